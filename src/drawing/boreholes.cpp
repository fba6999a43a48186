// SPDX-License-Identifier: MIT
#include "drawing/boreholes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "base/error.hpp"
#include "drawing/case_text.hpp"
#include "mesh/layers.hpp"

namespace talus::drawing {
namespace {

constexpr std::size_t most_soils = 100;
constexpr std::size_t nowhere = std::numeric_limits<std::size_t>::max();

/// Order of the soils: for each pair, a borehole in which the first is above the second.
class SoilOrder {
 public:
  SoilOrder(const std::vector<Borehole>& holes, const std::vector<std::vector<std::size_t>>& met,
            const std::vector<std::string>& labels)
      : holes_(holes), labels_(labels), witness_(labels.size(), std::vector<std::size_t>(labels.size(), nowhere)) {
    std::vector<int> counts(labels.size());
    depth_.resize(labels.size());
    for (std::size_t h = 0; h < holes.size(); ++h)
      for (std::size_t i = 0; i < met[h].size(); ++i) {
        const std::size_t soil = met[h][i];
        depth_[soil] += holes[h].layers[i].bottom;
        ++counts[soil];
        for (std::size_t k = 0; k < i; ++k)
          if (witness_[met[h][k]][soil] == nowhere) witness_[met[h][k]][soil] = h;
      }
    for (std::size_t s = 0; s < depth_.size(); ++s) depth_[s] /= std::max(counts[s], 1);
  }

  /// Returns the soils from the top down; among those that may be next, the one with the least mean depth.
  std::vector<std::size_t> sort() const {
    refuse_pairs();
    std::vector<std::size_t> order;
    std::vector<char> is_placed(labels_.size());
    while (order.size() < labels_.size()) {
      std::size_t next = nowhere;
      for (std::size_t s = 0; s < labels_.size(); ++s)
        if (!is_placed[s] && find_above(s, is_placed) == nowhere && (next == nowhere || depth_[s] < depth_[next]))
          next = s;
      if (next == nowhere) refuse_ring(is_placed);
      is_placed[next] = 1;
      order.push_back(next);
    }
    return order;
  }

 private:
  /// Returns a soil that is not placed yet and must be above `soil`.
  std::size_t find_above(std::size_t soil, const std::vector<char>& is_placed) const {
    for (std::size_t s = 0; s < labels_.size(); ++s)
      if (!is_placed[s] && witness_[s][soil] != nowhere) return s;
    return nowhere;
  }

  void refuse_pairs() const {
    for (std::size_t a = 0; a < labels_.size(); ++a)
      for (std::size_t b = 0; b < a; ++b)
        if (witness_[a][b] != nowhere && witness_[b][a] != nowhere) {
          const Borehole &one = holes_[witness_[b][a]], &other = holes_[witness_[a][b]];
          fail_input(
              "the order of the soils contradicts itself: '{}' is above '{}' in borehole {} ({}), and below it in "
              "borehole {} ({}): give one of the layers another name",
              clean_text(labels_[b]), clean_text(labels_[a]), clean_text(one.name), one.place, clean_text(other.name),
              other.place);
        }
  }

  [[noreturn]] void refuse_ring(const std::vector<char>& is_placed) const {
    std::size_t soil = 0;
    while (is_placed[soil]) ++soil;
    // Going up from any soil, the first that returns is part of a ring.
    std::vector<std::size_t> way{soil};
    std::size_t first = nowhere;
    while (first == nowhere) {
      const std::size_t above = find_above(way.back(), is_placed);
      const auto at = std::find(way.begin(), way.end(), above);
      if (at != way.end()) first = static_cast<std::size_t>(at - way.begin());
      way.push_back(above);
    }
    std::string ring;
    for (std::size_t i = way.size() - 1; i > first; --i)
      ring += fmt::format("{}'{}' is above '{}' in borehole {}", ring.empty() ? "" : ", ", clean_text(labels_[way[i]]),
                          clean_text(labels_[way[i - 1]]), clean_text(holes_[witness_[way[i]][way[i - 1]]].name));
    fail_input("the order of the soils contradicts itself: {}: give one of the layers another name", ring);
  }

  const std::vector<Borehole>& holes_;
  const std::vector<std::string>& labels_;
  std::vector<std::vector<std::size_t>> witness_;
  std::vector<double> depth_;
};

}  // namespace

std::vector<DrilledSoil> order_soils(std::vector<Borehole>& holes) {
  std::map<std::pair<std::string, int>, std::size_t> numbers;
  std::vector<std::string> labels, soils;
  std::vector<std::vector<std::size_t>> met(holes.size());
  for (std::size_t h = 0; h < holes.size(); ++h) {
    std::map<std::string, int> count;
    for (const DrilledLayer& layer : holes[h].layers) {
      const int occurrence = ++count[layer.soil];
      const auto [at, is_new] = numbers.try_emplace({layer.soil, occurrence}, labels.size());
      if (is_new) {
        labels.push_back(occurrence == 1 ? layer.soil : fmt::format("{} {}", layer.soil, occurrence));
        soils.push_back(layer.soil);
      }
      met[h].push_back(at->second);
    }
    if (labels.size() > most_soils)
      fail_input(
          "the boreholes have more than {} different soils; a section has at most that many: give a column with names "
          "of soils, not with descriptions",
          most_soils);
  }
  const std::vector<std::size_t> order = SoilOrder(holes, met, labels).sort();
  std::vector<std::size_t> rank(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) rank[order[i]] = i;
  for (std::size_t h = 0; h < holes.size(); ++h) {
    Borehole& hole = holes[h];
    hole.bottoms.assign(order.size(), std::nullopt);
    double above = 0;
    std::size_t next = 0;
    for (std::size_t i = 0; i < met[h].size(); ++i) {
      const std::size_t soil = rank[met[h][i]];
      for (; next < soil; ++next) hole.bottoms[next] = above;
      above = hole.layers[i].bottom;
      // A borehole ends within its last soil.
      if (i + 1 < met[h].size()) hole.bottoms[next++] = above;
    }
    hole.end = std::max(hole.end, above);
  }
  std::vector<DrilledSoil> sorted;
  std::set<std::string> names;
  std::map<std::string, std::string> materials;
  for (const std::size_t soil : order) {
    const std::string name = take_name(names, labels[soil]);
    sorted.push_back({name, materials.try_emplace(soils[soil], name).first->second});
  }
  return sorted;
}

std::vector<DrawnSoil> make_drilled_layers(const std::vector<Borehole>& holes, const std::vector<DrilledSoil>& soils,
                                           const mesh::Polyline& ground, std::optional<double> base,
                                           std::vector<std::string>& remarks) {
  std::vector<DrawnSoil> layers;
  std::set<std::string> lowered;
  double lowest_end = 1e300, lowest_boundary = 1e300;
  for (const Borehole& hole : holes) lowest_end = std::min(lowest_end, mesh::find_level(ground, *hole.x) - hole.end);
  for (std::size_t i = 0; i < soils.size(); ++i) {
    DrawnSoil& layer = layers.emplace_back();
    layer.name = soils[i].name;
    layer.material = soils[i].material;
    layer.are_depths = true;
    mesh::Polyline levels;
    for (const Borehole& hole : holes)
      if (hole.bottoms[i]) levels.push_back({*hole.x, mesh::find_level(ground, *hole.x) - *hole.bottoms[i]});
    if (levels.empty()) {
      if (i + 1 < soils.size()) {
        remarks.push_back(fmt::format("no borehole reaches the lower boundary of '{}'; it was left out", layer.name));
        layers.pop_back();
      }
      continue;
    }
    for (const Borehole& hole : holes) {
      const double top = mesh::find_level(ground, *hole.x);
      if (hole.bottoms[i]) {
        layer.points.push_back({*hole.x, *hole.bottoms[i]});
        continue;
      }
      // The boundary between the neighbours would be above the end of a borehole that has not met it.
      const double depth = *hole.x < levels.front()[0] ? mesh::find_level(ground, levels.front()[0]) - levels.front()[1]
                           : *hole.x > levels.back()[0] ? mesh::find_level(ground, levels.back()[0]) - levels.back()[1]
                                                        : top - mesh::find_level(levels, *hole.x);
      if (!(depth < hole.end)) continue;
      layer.points.push_back({*hole.x, hole.end});
      if (lowered.insert(hole.name).second)
        remarks.push_back(fmt::format(
            "borehole {} ends above the lower boundary of '{}', which was drawn through its end, {:.6g} m deep",
            clean_text(hole.name), layer.name, hole.end));
    }
    for (const auto& [x, depth] : layer.points)
      lowest_boundary = std::min(lowest_boundary, mesh::find_level(ground, x) - depth);
  }
  const bool is_open = layers.empty() || layers.back().points.empty();
  if (base && !(*base < lowest_boundary))
    fail_input("the base of the section, y = {:.6g} m, is not below the lowest boundary in a borehole, y = {:.6g} m",
               *base, lowest_boundary);
  if (!is_open && !base) return layers;
  if (!is_open) layers.push_back({"base", {}, "", true, {}});
  if (!base) {
    if (lowest_end >= lowest_boundary)
      fail_input("no borehole goes below the boundary of the last soil: give the base of the section with --base");
    remarks.push_back(fmt::format(
        "the base of the section is level at y = {:.6g} m, the lowest end of a borehole; --base gives another one",
        lowest_end));
  }
  layers.back().level = base.value_or(lowest_end);
  return layers;
}

}  // namespace talus::drawing
