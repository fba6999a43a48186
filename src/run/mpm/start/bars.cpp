// SPDX-License-Identifier: MIT
#include "run/mpm/start/bars.hpp"

#include <algorithm>
#include <cmath>

#include "input/case/support.hpp"
#include "mesh/locate.hpp"
#include "mesh/quality.hpp"
#include "mpm/solver/bars.hpp"
#include "run/common/bars_of_case.hpp"
#include "run/common/head.hpp"
#include "site/supports.hpp"

namespace talus::run {
namespace {

/// Nodes of a bar per element of the mean size, and the fewest pieces of a bonded length.
constexpr double nodes_per_element = 2;
constexpr int fewest_pieces = 6;
/// Places under a plate per element.
constexpr double places_per_element = 4;
/// Distance into the soil at which the element of a place on the ground is sought, over the size of elements.
constexpr double inwards = 1e-4;

class BarPlacer {
 public:
  explicit BarPlacer(const mesh::Mesh<2>& mesh) : mesh_(mesh), size_(mesh::measure_quality(mesh).mean_size) {}

  mpm::Bar place(const fem::Bar& from, double rupture_strain) const {
    const double length = std::hypot(from.end[0] - from.head[0], from.end[1] - from.head[1]);
    const Vec<2> along{(from.end[0] - from.head[0]) / length, (from.end[1] - from.head[1]) / length};
    mpm::Bar bar;
    bar.name = from.name;
    bar.head = from.head, bar.end = from.end;
    bar.tension = {from.axial_stiffness, 0, from.tensile, true};
    bar.rupture_strain = rupture_strain;
    bar.prestress = from.prestress;
    bar.reduces_bond = from.reduces_bond;
    for (const double s : divide(from, length)) {
      mpm::BarNode& node = bar.nodes.emplace_back();
      node.place = s;
      node.soil = find_place({from.head[0] + s * along[0], from.head[1] + s * along[1]}, along);
    }
    for (std::size_t i = 0; i + 1 < bar.nodes.size(); ++i)
      bar.pieces.push_back({.length = bar.nodes[i + 1].place - bar.nodes[i].place});
    bond(from, bar);
    if (from.plate > 0) add_plate(from, along, bar);
    mpm::settle_bar(bar);
    return bar;
  }

 private:
  /// Distances of the nodes from the head; a free length is one piece.
  std::vector<double> divide(const fem::Bar& from, double length) const {
    std::vector<double> places;
    const double free = std::min(from.free_length, length), bonded = length - free;
    if (free > 0) places.push_back(0);
    if (!(bonded > 1e-9 * length)) {
      places.push_back(length);
      return places;
    }
    const int pieces = std::max(fewest_pieces, static_cast<int>(std::ceil(bonded * nodes_per_element / size_)));
    for (int i = 0; i <= pieces; ++i) places.push_back(free + bonded * i / pieces);
    return places;
  }

  /// Gives every node the bond of the bonded length that it stands for, and the last one the anchorage of a bolt.
  static void bond(const fem::Bar& from, mpm::Bar& bar) {
    const std::size_t first = from.free_length > 0 ? 1 : 0, last = bar.nodes.size() - 1;
    if (from.bond)
      for (std::size_t i = first; i <= last; ++i) {
        const double before = i > first ? bar.pieces[i - 1].length : 0, after = i < last ? bar.pieces[i].length : 0,
                     length = 0.5 * (before + after);
        mpm::BarNode& node = bar.nodes[i];
        const double strength = length * from.bond(node.soil.x);
        node.bond = {length * from.bond_stiffness, -strength, strength, false};
      }
    if (from.anchorage > 0) bar.nodes[last].bond = {from.anchorage_stiffness, -from.anchorage, from.anchorage, false};
  }

  void add_plate(const fem::Bar& from, const Vec<2>& along, mpm::Bar& bar) const {
    std::vector<Vec<2>> line = from.plate_line;
    if (line.empty()) line = {from.head};
    bar.plate.law = {from.plate_stiffness, 0, from.plate, true};
    if (line.size() == 1) bar.plate.places.push_back(find_place(line[0], along));
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const double length = std::hypot(line[i + 1][0] - line[i][0], line[i + 1][1] - line[i][1]);
      const int count = std::max(1, static_cast<int>(std::ceil(length * places_per_element / size_)));
      for (int k = 0; k < count; ++k) {
        const double t = (k + 0.5) / count;
        bar.plate.places.push_back(find_place(
            {line[i][0] + t * (line[i + 1][0] - line[i][0]), line[i][1] + t * (line[i + 1][1] - line[i][1])}, along));
      }
    }
  }

  mpm::SoilPlace find_place(const Vec<2>& x, const Vec<2>& along) const {
    mpm::SoilPlace place;
    place.x = x;
    const double inside = inwards * size_;
    const Vec<2> sought{x[0] + inside * along[0], x[1] + inside * along[1]};
    place.element = mesh::find_element<2>(mesh_, sought);
    if (place.element < 0) place.element = mesh::find_element<2>(mesh_, x);
    if (place.element >= 0) place.xi = mesh::find_local(mesh_, place.element, x);
    return place;
  }

  const mesh::Mesh<2>& mesh_;
  const double size_;
};

/// Bond that the soil exerts between two nodes of a bar, and its limit [N].
struct UsedBond {
  double force = 0, limit = 0;
};
UsedBond sum_bond(const mpm::Bar& bar, std::size_t first, std::size_t end) {
  UsedBond used;
  for (std::size_t i = first; i < end; ++i) {
    const mpm::BarNode& node = bar.nodes[i];
    if (!node.soil.is_joined) continue;
    used.force += node.bond.stiffness * node.slip;
    used.limit += node.bond.upper / bar.divisor;
  }
  return used;
}

void judge(const mpm::Bar& bar, results::PointBar& out) {
  using Limit = results::PointBarLimit;
  const auto top = static_cast<std::size_t>(std::max_element(out.force.begin(), out.force.end()) - out.force.begin());
  out.largest = out.force[top];
  out.plate = bar.plate.force;
  out.tension = out.largest / bar.tension.upper;
  for (const mpm::BarPiece& piece : bar.pieces) out.torn += piece.is_torn ? 1 : 0;
  if (out.torn > 0) out.limit = Limit::torn;
  if (!(out.largest > 0)) return;
  // Behind the largest force the bar slips out of the soil, against its direction; in front of it the soil strips off.
  const UsedBond front = sum_bond(bar, 0, top + 1), behind = sum_bond(bar, top + 1, bar.nodes.size());
  if (behind.limit > 0) out.pull_out = -behind.force / behind.limit;
  if (front.limit + bar.plate.law.upper > 0)
    out.stripping = (front.force + bar.plate.force) / (front.limit + bar.plate.law.upper);
  if (out.torn > 0) return;
  out.limit = select_limit<Limit>(
      {{out.stripping, Limit::stripping}, {out.pull_out, Limit::pull_out}, {out.tension, Limit::tension}}, Limit::none);
}

}  // namespace

void add_bars(mpm::Body<2>& body, const input::Case& data) {
  if (data.supports.empty()) return;
  const BarPlacer placer(body.mesh());
  for (const fem::Bar& bar : make_bars(site::Site(data)))
    body.bars.push_back(placer.place(bar, data.supports.at(bar.name).rupture_strain.value_or(fem::unlimited)));
}

std::vector<results::PointBar> make_bar_results(const mpm::Body<2>& body, const input::Case& data) {
  std::vector<results::PointBar> results;
  if (body.bars.empty()) return results;
  const std::vector<site::Bar> bars = site::list_bars(site::Site(data));
  for (std::size_t i = 0; i < body.bars.size(); ++i) {
    const mpm::Bar& bar = body.bars[i];
    results::PointBar& out = results.emplace_back();
    out.support = bars[i].support;
    out.kind = input::get_word(bars[i].kind);
    out.row = bars[i].row;
    for (const mpm::BarNode& node : bar.nodes) {
      out.line.push_back(node.soil.x);
      out.slip.push_back(node.all_slip);
    }
    for (std::size_t j = 0; j < bar.pieces.size(); ++j) {
      out.place.push_back(0.5 * (bar.nodes[j].place + bar.nodes[j + 1].place));
      out.force.push_back(bar.pieces[j].tension);
    }
    judge(bar, out);
  }
  return results;
}

}  // namespace talus::run
