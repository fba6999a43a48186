// SPDX-License-Identifier: MIT
#include "run/bounds/given_loads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/numbers.hpp"

namespace talus::run {
namespace {

/// Differences up to this fraction of the largest load are rounding, and up to this fraction of the pressure of water
/// as deep as the ground is wide: a water table along the ground is a load of rounding alone.
constexpr double rounding_of_loads = 1e-6, rounding_of_water = 1e-12;
/// Places at which a side is looked at.
constexpr int side_samples = 9;

/// A polyline at x, level beyond its ends; `y` of equal length.
double interpolate(const std::vector<double>& xs, const std::vector<double>& ys, double x) {
  const auto after = static_cast<std::size_t>(std::upper_bound(xs.begin(), xs.end(), x) - xs.begin());
  if (after == 0) return ys.front();
  if (after == xs.size()) return ys.back();
  const double part = (x - xs[after - 1]) / (xs[after] - xs[after - 1]);
  return ys[after - 1] + part * (ys[after] - ys[after - 1]);
}

class GivenLoads {
 public:
  GivenLoads(const input::Case& data, const std::vector<ground::Pond>& ponds, const ground::Polyline& table)
      : data_(data), ponds_(ponds), weight_(data.water.density * data.gravity.acceleration) {
    for (const auto& x : table) table_x_.push_back(x[0]), table_y_.push_back(x[1]);
  }

  /// Traction on ground with this upward normal [Pa].
  Vec<2> find(const Vec<2>& x, const Vec<2>& normal) const {
    double surcharge = 0;
    for (const input::Surcharge& s : data_.surcharges)
      if (x[0] > s.x.front() && x[0] < s.x.back()) surcharge += interpolate(s.x, s.load, x[0]);
    double depth = 0;
    for (const ground::Pond& p : ponds_)
      if (x[0] > p.from[0] && x[0] < p.to[0])
        depth = std::max(depth, interpolate({p.from[0], p.to[0]}, {p.level_from, p.level_to}, x[0]) - x[1]);
    if (!table_x_.empty()) depth = std::max(depth, interpolate(table_x_, table_y_, x[0]) - x[1]);
    return {-weight_ * depth * normal[0], -weight_ * depth * normal[1] - surcharge * normal[1]};
  }

 private:
  const input::Case& data_;
  const std::vector<ground::Pond>& ponds_;
  double weight_;
  std::vector<double> table_x_, table_y_;
};

}  // namespace

std::optional<std::string> find_wrong_load(const input::Case& data, const std::vector<ground::Pond>& ponds,
                                           const ground::Polyline& table, const std::vector<LoadedSide>& sides) {
  const GivenLoads given(data, ponds, table);
  double largest = 0, most = 0, left = std::numeric_limits<double>::infinity(), right = -left;
  Vec<2> where{};
  for (const LoadedSide& side : sides) {
    const double run = side.from[0] - side.to[0], rise = side.to[1] - side.from[1], length = std::hypot(run, rise);
    const Vec<2> normal{rise / length, run / length};
    left = std::min({left, side.from[0], side.to[0]}), right = std::max({right, side.from[0], side.to[0]});
    if (normal[1] < 1e-6) continue;  // a vertical step has its water beside it
    for (int i = 1; i <= side_samples; ++i) {
      const double s = static_cast<double>(i) / (side_samples + 1);
      const Vec<2> x{side.from[0] - s * run, side.from[1] + s * rise};
      const Vec<2> of_case = given.find(x, normal);
      double off = 0;
      for (std::size_t d = 0; d < 2; ++d)
        off = std::hypot(off, (1 - s) * side.traction[0][d] + s * side.traction[1][d] - of_case[d]);
      largest = std::max(largest, norm(of_case));
      if (off > most) most = off, where = x;
    }
  }
  const double water = data.water.density * data.gravity.acceleration * (right - left);
  if (!(most > rounding_of_loads * largest + rounding_of_water * water)) return std::nullopt;
  return fmt::format("at {} the load on the ground differs from that of the case by {:.3g} kPa: nothing is proven",
                     format_point(where), most / 1e3);
}

}  // namespace talus::run
