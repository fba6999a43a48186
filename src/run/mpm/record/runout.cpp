// SPDX-License-Identifier: MIT
#include "run/mpm/record/runout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "base/atomic_file.hpp"
#include "base/numbers.hpp"
#include "mesh/mesh.hpp"
#include "mesh/planar.hpp"
#include "mpm/solver/observe.hpp"
#include "output/files/history.hpp"
#include "run/mpm/record/deposit.hpp"
#include "run/mpm/start/prepare.hpp"

namespace talus::run {
namespace {

/// Fraction of the moved mass behind the front of the mass.
constexpr double front_share = 0.99;

/// A deposit is at least as thick as the larger of this fraction of the relief, and this fraction of an element.
constexpr double thickness_per_relief = 0.05, thickness_per_element = 0.25;

/// Ground whose relief is below this fraction of the height of the soil is level.
constexpr double level_relief = 0.02;

/// Returns the coordinate below which the fraction `share` of the mass lies. `places`: (coordinate, mass).
double find_quantile(std::vector<std::pair<double, double>> places, double share) {
  std::sort(places.begin(), places.end());
  double total = 0, sum = 0;
  for (const auto& p : places) total += p.second;
  for (const auto& p : places) {
    sum += p.second;
    if (sum >= share * total) return p.first;
  }
  return places.empty() ? 0 : places.back().first;
}

/// Returns the edge of the upper level on the side towards which the soil moves.
double find_crest(const results::Profile& profile, int direction) {
  if (profile.x.empty()) return 0;
  const double top = *std::max_element(profile.height.begin(), profile.height.end());
  const double low = *std::min_element(profile.height.begin(), profile.height.end());
  const double tolerance = 0.05 * (top - low);
  double crest = direction > 0 ? profile.x.front() : profile.x.back();
  for (std::size_t i = 0; i < profile.x.size(); ++i) {
    if (profile.height[i] < top - tolerance) continue;
    crest = direction > 0 ? std::max(crest, profile.x[i]) : std::min(crest, profile.x[i]);
  }
  return crest;
}

/// Returns the lowest level of the ground as a mean of two bins: a bin at a wall may hold only the side of a point.
double find_lowest(const std::vector<double>& height) {
  double lowest = height.size() == 1 ? height[0] : std::numeric_limits<double>::max();
  for (std::size_t i = 1; i < height.size(); ++i) lowest = std::min(lowest, std::max(height[i - 1], height[i]));
  return lowest;
}

/// Returns where the ground, going out from the crest, reaches its lower level (or ends). A rise beyond it, such as a
/// bin whose highest point is slightly higher, is not part of the slope. `soil_height`: that of all soil [m].
double find_toe(const results::Profile& profile, double crest, int direction, double soil_height) {
  const double top = *std::max_element(profile.height.begin(), profile.height.end());
  const double low = find_lowest(profile.height);
  const bool is_level = top - low < level_relief * soil_height;  // such as a column: its toe is its edge
  double toe = crest;
  const std::size_t count = profile.x.size();
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = direction > 0 ? k : count - 1 - k;
    if (direction * (profile.x[i] - toe) <= 0) continue;
    if (!is_level && profile.height[i] <= low + 0.02 * (top - low)) break;
    toe = profile.x[i];
  }
  return toe + direction * 0.5 * profile.bin;
}

/// A point that moved by more than the threshold.
struct MovedPoint {
  double x, across, up;  ///< position along x, and displacement along x and y [m]
  double displacement;   ///< [m]
  double mass, volume;
  SoilCube before, now;
};

/// Extent of the box along x.
struct Ends {
  double left = std::numeric_limits<double>::max(), right = std::numeric_limits<double>::lowest();  ///< [m]
  double size = 0;   ///< element size [m]; soil nearer than this to an end counts as being at the end
  double least = 0;  ///< least volume of soil at an end, to disregard single points [m³ or m³/m]

  template <int D>
  Ends(const mesh::Mesh<D>& mesh, double bin) : size(bin), least(0.5 * std::pow(bin, D)) {
    for (const Vec<D>& x : mesh.nodes) left = std::min(left, x[0]), right = std::max(right, x[0]);
  }
  bool is_at(int direction, double x) const { return (direction > 0 ? right - x : x - left) < size; }
};

std::optional<results::BoxLimit> find_limits(const std::vector<MovedPoint>& moved, int direction, const Ends& ends,
                                             double threshold) {
  double front = 0, crest = 0;
  for (const MovedPoint& p : moved) {
    if (direction * p.across > threshold && ends.is_at(direction, p.x)) front += p.volume;
    if (ends.is_at(-direction, p.x - p.across)) crest += p.volume;
  }
  const results::BoxLimit limits{front > ends.least, crest > ends.least};
  if (!limits.front && !limits.crest) return std::nullopt;
  return limits;
}

/// The section before and after, for all sides.
struct States {
  Ground before, now;
  Ends ends;
  double threshold = 0;    ///< as in RunoutStart [m]
  double soil_height = 0;  ///< of all soil at the start [m]
  double thickness = 0;    ///< least thickness of a deposit [m]
};

/// Sets the measures of thickness: the front of the deposit and the retreat of the ground that sank.
void measure_ground(const std::vector<MovedPoint>& moved, const States& states, const Stretch& stretch,
                    results::RunoutSide& r) {
  std::vector<SoilCube> before, now;  // of the soil that began behind the toe
  for (const MovedPoint& p : moved) {
    if (r.direction * (p.before.x - r.initial_toe) > 0) continue;
    before.push_back(p.before);
    now.push_back(p.now);
  }
  const ColumnGrid& grid = states.before.grid();
  const auto start = measure_deposit(before, nullptr, grid, r.direction, states.thickness).front;
  const Deposit deposit = measure_deposit(now, &states.before, grid, r.direction, states.thickness);
  r.deposit_volume = deposit.volume;
  r.toe = deposit.front.value_or(start.value_or(r.initial_toe));
  if (start) r.front_advance = std::max(0.0, r.direction * (r.toe - *start));
  if (deposit.front) r.toe_distance = std::max(0.0, r.direction * (r.toe - r.initial_toe));
  r.crest_retreat = measure_retreat(states.before, states.now, r.crest, r.direction, states.thickness, stretch);
}

/// Measures the runout of one side in its `direction`. `initial`: the ground of that side.
results::RunoutSide measure_side(const std::vector<MovedPoint>& moved, const results::Profile& initial, int direction,
                                 const States& states) {
  results::RunoutSide r;
  r.direction = direction;
  r.limits = find_limits(moved, direction, states.ends, states.threshold);
  double mass = 0;
  for (const MovedPoint& p : moved) mass += p.mass;
  std::vector<std::pair<double, double>> before, now;
  double farthest_before = std::numeric_limits<double>::lowest(), farthest_now = farthest_before;
  for (const MovedPoint& p : moved) {
    r.largest_displacement = std::max(r.largest_displacement, p.displacement);
    const double x1 = r.direction * p.x, x0 = x1 - r.direction * p.across;
    before.emplace_back(x0, p.mass);
    now.emplace_back(x1, p.mass);
    farthest_before = std::max(farthest_before, x0);
    farthest_now = std::max(farthest_now, x1);
    r.moved_volume += p.volume;
    r.centre_advance += r.direction * p.across * p.mass / mass;
    r.centre_drop -= p.up * p.mass / mass;
  }
  if (now.empty() || initial.x.empty()) return r;
  const double front_now = find_quantile(now, front_share), front_before = find_quantile(before, front_share);
  r.mass_front = r.direction * front_now;
  r.mass_front_advance = front_now - front_before;
  r.farthest_advance = farthest_now - farthest_before;
  r.crest = find_crest(initial, r.direction);
  r.initial_toe = find_toe(initial, r.crest, r.direction, states.soil_height);
  measure_ground(moved, states, {initial.x.front(), initial.x.back()}, r);
  return r;
}

/// Measures both sides of a divided section, the one towards smaller x first.
std::vector<results::RunoutSide> measure_sides(const std::vector<MovedPoint>& moved, const results::Profile& initial,
                                               const mesh::Divide& divide, const States& states) {
  std::vector<results::RunoutSide> sides;
  for (const bool is_left : {true, false}) {
    std::vector<MovedPoint> own;
    for (const MovedPoint& p : moved)
      if ((p.x - p.across < divide.x) == is_left) own.push_back(p);
    results::Profile ground;
    ground.bin = initial.bin;
    for (std::size_t i = 0; i < initial.x.size(); ++i)
      if ((initial.x[i] < divide.x) == is_left) {
        ground.x.push_back(initial.x[i]);
        ground.height.push_back(initial.height[i]);
      }
    sides.push_back(measure_side(own, ground, is_left ? divide.left : -divide.left, states));
  }
  if (sides[0].direction > 0) std::swap(sides[0], sides[1]);
  return sides;
}

template <int D>
SoilCube make_cube(const Vec<D>& x, double volume, const ColumnGrid& grid) {
  return {x[0], x[1], grid.find_lane(x[D - 1]), std::pow(volume, 1.0 / D), volume};
}

/// Sets the levels at the start that the measures refer to. `soil`: all of it at the start.
void set_levels(const std::vector<SoilCube>& soil, const results::Profile& ground, States& states, results::Runout& r) {
  if (ground.height.empty()) return;
  double bottom = std::numeric_limits<double>::max();
  for (const SoilCube& c : soil) bottom = std::min(bottom, c.y - 0.5 * c.size);
  const double top = *std::max_element(ground.height.begin(), ground.height.end()), low = find_lowest(ground.height);
  states.soil_height = top - bottom;
  const bool is_level = top - low < level_relief * states.soil_height;
  r.lowest_ground = is_level ? bottom : low;
  states.thickness =
      std::max(thickness_per_relief * (top - r.lowest_ground), thickness_per_element * states.before.grid().width);
  r.deposit_threshold = states.thickness;
}

bool goes_farther(const results::RunoutSide& a, const results::RunoutSide& b) {
  return std::tie(a.toe_distance, a.front_advance, a.moved_volume) >
         std::tie(b.toe_distance, b.front_advance, b.moved_volume);
}

}  // namespace

template <int D>
results::Profile find_profile(const mpm::Body<D>& body, double bin) {
  const ColumnGrid grid = make_column_grid(body.mesh(), bin);
  std::vector<SoilCube> soil;
  for (int id = 0; id < body.points.size(); ++id)
    if (mpm::is_present(body, id)) {
      const auto p = mpm::view_point(body, id);
      soil.push_back(make_cube<D>(p.position, p.volume, grid));
    }
  return Ground(grid, soil).make_profile();
}

template <int D>
double find_slope_height(const mpm::Body<D>& body, const input::Gravity& gravity) {
  // The relief is the difference between the highest and the lowest node of the free surface: sides of elements with
  // soil whose neighbour has none, and whose outward normal points up.
  const auto& mesh = body.mesh();
  double lowest = std::numeric_limits<double>::max(), highest = std::numeric_limits<double>::lowest();
  for (int e = 0; e < mesh.element_count(); ++e) {
    if (body.points.count[e] == 0) continue;
    for (int k = 0; k <= D; ++k) {
      const int n = mesh.neighbours[e][k];
      if (n >= 0 && body.points.count[n] > 0) continue;
      const Vec<D> gradient = mesh::find_shape_gradient(mesh, e, k);
      double up = 0;  // component of -∇N_k, the outward direction, against gravity
      for (int d = 0; d < D; ++d) up += gradient[d] * gravity.direction[d];
      constexpr double steepest_ground = 0.05;  // cosine; steeper sides are walls
      if (up < steepest_ground * norm(gradient)) continue;
      for (int j = 0; j <= D; ++j) {
        if (j == k) continue;
        double height = 0;
        for (int d = 0; d < D; ++d) height -= gravity.direction[d] * mesh.nodes[mesh.elements[e][j]][d];
        lowest = std::min(lowest, height);
        highest = std::max(highest, height);
      }
    }
  }
  const double soil = find_soil_height(body, gravity);
  const double relief = highest - lowest;
  return relief > 0.02 * soil ? relief : soil;
}

template <int D>
std::vector<double> find_specific_volumes(const mpm::Body<D>& body) {
  std::vector<double> volumes, masses;
  for (int id = 0; id < body.points.size(); ++id) {
    if (!mpm::is_present(body, id)) continue;
    const auto p = mpm::view_point(body, id);
    const auto material = static_cast<std::size_t>(p.material);
    if (material >= volumes.size()) volumes.resize(material + 1), masses.resize(material + 1);
    volumes[material] += p.volume;
    masses[material] += p.mass;
  }
  for (std::size_t i = 0; i < volumes.size(); ++i) volumes[i] = masses[i] > 0 ? volumes[i] / masses[i] : 0;
  return volumes;
}

template <int D>
results::Runout find_runout(const mpm::Body<D>& body, const RunoutStart& from) {
  results::Runout r;
  r.threshold = from.threshold;
  const ColumnGrid grid = make_column_grid(body.mesh(), from.initial.bin);
  std::vector<MovedPoint> moved;
  std::vector<mesh::MovedSoil> soil;
  std::vector<SoilCube> before, now;
  double largest = 0, moment = 0;
  for (int id = 0; id < body.points.size(); ++id) {
    if (!mpm::is_present(body, id)) continue;
    const auto p = mpm::view_point(body, id);
    Vec<D> start = p.position;
    for (std::size_t d = 0; d < D; ++d) start[d] -= p.displacement[d];
    const auto material = static_cast<std::size_t>(p.material);
    const double volume = material < from.specific_volumes.size() && from.specific_volumes[material] > 0
                              ? p.mass * from.specific_volumes[material]
                              : p.volume;
    before.push_back(make_cube<D>(start, volume, grid));
    now.push_back(make_cube<D>(p.position, volume, grid));
    const double u = norm(p.displacement);
    largest = std::max(largest, u);
    if (u <= from.threshold) continue;
    moved.push_back(
        {p.position[0], p.displacement[0], p.displacement[1], u, p.mass, volume, before.back(), now.back()});
    soil.push_back({p.position[0] - p.displacement[0], p.displacement[0], p.mass});
    moment += p.mass * p.displacement[0];
  }
  States states{{grid, before}, {grid, now}, {body.mesh(), grid.width}, from.threshold};
  const results::Profile initial = states.before.make_profile();
  set_levels(before, initial, states, r);
  if (const auto divide = mesh::find_divide(std::move(soil), from.threshold)) {
    r.sides = measure_sides(moved, initial, *divide, states);
    const bool is_first = goes_farther((*r.sides)[0], (*r.sides)[1]);
    static_cast<results::RunoutSide&>(r) = (*r.sides)[is_first ? 0 : 1];
    r.moved_volume = r.deposit_volume = 0;
    for (const results::RunoutSide& side : *r.sides) r.deposit_volume += side.deposit_volume;
    for (const MovedPoint& p : moved) r.moved_volume += p.volume;
  } else {
    static_cast<results::RunoutSide&>(r) = measure_side(moved, initial, moment < 0 ? -1 : 1, states);
  }
  r.largest_displacement = largest;
  const std::vector<double> levels = states.now.make_profile().height;
  if (!levels.empty()) r.highest_ground = *std::max_element(levels.begin(), levels.end());
  return r;
}

std::string describe_limits(const results::Runout& runout) {
  const results::RunoutSide& whole = runout;
  const std::vector<results::RunoutSide> all = runout.sides.value_or(std::vector{whole});
  std::string ends;
  for (const results::RunoutSide& side : all)
    if (side.limits && side.limits->front)
      ends += (ends.empty() ? "" : " and the ") + std::string(side.direction < 0 ? "left" : "right");
  if (ends.empty()) return "";
  return fmt::format(
      "soil that moved lies at the {} end of the box, which limits front, runout and moved volume; make "
      "the box longer there",
      ends);
}

void write_profiles(const std::filesystem::path& path, const results::Profile& before, const results::Profile& after) {
  std::map<double, std::pair<std::string, std::string>> rows;
  for (std::size_t i = 0; i < before.x.size(); ++i) rows[before.x[i]].first = write_shortest(before.height[i]);
  for (std::size_t i = 0; i < after.x.size(); ++i) rows[after.x[i]].second = write_shortest(after.height[i]);
  std::string text = "x [m],ground before [m],ground after [m]\n";
  for (const auto& [x, heights] : rows)
    text += fmt::format("{},{},{}\n", write_shortest(x), heights.first, heights.second);
  write_atomically(path, text);
}

#define TALUS_INSTANTIATE(D)                                                        \
  template results::Profile find_profile<D>(const mpm::Body<D>&, double);           \
  template double find_slope_height<D>(const mpm::Body<D>&, const input::Gravity&); \
  template std::vector<double> find_specific_volumes<D>(const mpm::Body<D>&);       \
  template results::Runout find_runout<D>(const mpm::Body<D>&, const RunoutStart&);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

}  // namespace talus::run
