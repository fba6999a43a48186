// SPDX-License-Identifier: MIT
#include "run/mpm/record/deposit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace talus::run {
namespace {

constexpr double none = -std::numeric_limits<double>::infinity();

int find_place(double x, double from, double width, int count) {
  return std::clamp(static_cast<int>(std::floor((x - from) / width)), 0, count - 1);
}

/// A place where the slope of the thickness over the distance from the far end changes.
struct Bend {
  double distance = 0, change = 0;
};
bool is_later(const Bend& a, const Bend& b) {
  return a.distance > b.distance;
}

/// Returns the least distance at which the sum of all changes reaches `least`. `bends`: a heap by is_later.
std::optional<double> find_first_reach(std::vector<Bend> bends, double least) {
  double at = 0, thickness = 0, slope = 0;
  while (!bends.empty()) {
    const Bend next = bends.front();
    const double step = next.distance - at;
    if (slope > 0 && thickness + slope * step >= least) return at + (least - thickness) / slope;
    thickness += slope * step;
    slope += next.change;
    at = next.distance;
    std::pop_heap(bends.begin(), bends.end(), is_later);
    bends.pop_back();
  }
  return std::nullopt;
}

}  // namespace

int ColumnGrid::find_column(double x) const {
  return find_place(x, left, width, columns);
}

int ColumnGrid::find_lane(double z) const {
  return lanes == 1 ? 0 : find_place(z, side, breadth, lanes);
}

template <int D>
ColumnGrid make_column_grid(const mesh::Mesh<D>& mesh, double size) {
  auto low = mesh.nodes.front(), high = low;
  for (const auto& x : mesh.nodes)
    for (std::size_t d = 0; d < D; ++d) low[d] = std::min(low[d], x[d]), high[d] = std::max(high[d], x[d]);
  const auto count = [&](std::size_t d) {
    return std::max(1, static_cast<int>(std::lround((high[d] - low[d]) / size)));
  };
  ColumnGrid grid;
  grid.left = low[0];
  grid.columns = count(0);
  grid.width = (high[0] - low[0]) / grid.columns;
  if constexpr (D == 3) {
    grid.side = low[2];
    grid.lanes = count(2);
    grid.breadth = (high[2] - low[2]) / grid.lanes;
  }
  return grid;
}

Ground::Ground(const ColumnGrid& grid, const std::vector<SoilCube>& soil)
    : grid_(grid), levels_(static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.lanes), none) {
  for (const SoilCube& c : soil) {
    double& level = levels_[grid.find_index(grid.find_column(c.x), c.lane)];
    level = std::max(level, c.y + 0.5 * c.size);
  }
}

results::Profile Ground::make_profile() const {
  results::Profile profile;
  profile.bin = grid_.width;
  for (int i = 0; i < grid_.columns; ++i) {
    double top = none;
    for (int lane = 0; lane < grid_.lanes; ++lane) top = std::max(top, level(i, lane));
    if (top == none) continue;
    profile.x.push_back(grid_.centre(i));
    profile.height.push_back(top);
  }
  return profile;
}

Deposit measure_deposit(const std::vector<SoilCube>& soil, const Ground* ground, const ColumnGrid& grid, int direction,
                        double least) {
  Deposit out;
  const double far = direction > 0 ? grid.left + (grid.columns + 1) * grid.width : grid.left - grid.width;
  std::vector<std::vector<Bend>> lanes(static_cast<std::size_t>(grid.lanes));
  for (const SoilCube& c : soil) {
    const double level = ground == nullptr ? none : ground->level(grid.find_column(c.x), c.lane);
    const double above = level == none ? 1 : std::clamp((c.y + 0.5 * c.size - level) / c.size, 0.0, 1.0);
    if (above == 0) continue;
    out.volume += above * c.volume;
    // The mean over a column's width of the thickness of one cube is a trapezium over the distance from the far end.
    const double slope = above * c.volume / (grid.breadth * c.size * grid.width);
    const double inner = 0.5 * std::abs(c.size - grid.width), outer = 0.5 * (c.size + grid.width);
    const double centre = direction * (far - c.x);
    for (const auto& [from, change] : {std::pair{-outer, slope}, {-inner, -slope}, {inner, -slope}, {outer, slope}})
      lanes[static_cast<std::size_t>(c.lane)].push_back({centre + from, change});
  }
  std::optional<double> nearest;
  for (std::vector<Bend>& bends : lanes) {
    std::make_heap(bends.begin(), bends.end(), is_later);
    const auto reach = find_first_reach(std::move(bends), least);
    if (reach && (!nearest || *reach < *nearest)) nearest = reach;
  }
  if (nearest) out.front = far - direction * *nearest;
  return out;
}

double measure_retreat(const Ground& before, const Ground& now, double crest, int direction, double least,
                       const Stretch& stretch) {
  const ColumnGrid& grid = before.grid();
  double retreat = 0;
  for (int lane = 0; lane < grid.lanes; ++lane) {
    const auto find_drop = [&](int k) {  // k: number of the column from the rear
      const int i = direction > 0 ? k : grid.columns - 1 - k;
      const double x = grid.centre(i), level = before.level(i, lane);
      return x < stretch.from || x > stretch.to || level == none ? none : level - now.level(i, lane);
    };
    for (int k = 0; k + 1 < grid.columns; ++k) {
      const double drop = find_drop(k), behind = k > 0 ? find_drop(k - 1) : none;
      if (!(drop >= least) || !(find_drop(k + 1) >= least)) continue;
      // A column at the end of the ground, or one that lost all its soil, counts to its edge.
      const double part = behind == none || !std::isfinite(drop) ? 0.5 : (drop - least) / (drop - behind);
      const double x = grid.centre(direction > 0 ? k : grid.columns - 1 - k) - direction * part * grid.width;
      retreat = std::max(retreat, direction * (crest - x));
      break;
    }
  }
  return retreat;
}

template ColumnGrid make_column_grid<2>(const mesh::Mesh<2>&, double);
template ColumnGrid make_column_grid<3>(const mesh::Mesh<3>&, double);

}  // namespace talus::run
