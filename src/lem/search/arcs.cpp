// SPDX-License-Identifier: MIT
// Admissible arcs between two points of the ground, in closed form where there is one, and the places of their ends.
#include "lem/search/arcs.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lem/search/optimise.hpp"
#include "lem/search/trial_circles.hpp"
#include "lem/section/strips.hpp"
#include "mesh/planar.hpp"

namespace talus::lem {

namespace {

constexpr double pi = std::numbers::pi;
/// Smallest half angle [rad]: the depth of that arc is 1/200 of its chord.
constexpr double flattest = 0.02;

struct Chord {
  Point left, right, middle, along;  ///< `along`: unit vector to the right
  double length = 0;
  Chord(const Point& a, const Point& b) : left(a), right(b), middle{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2}, along{} {
    length = std::hypot(b[0] - a[0], b[1] - a[1]);
    along = {(b[0] - a[0]) / length, (b[1] - a[1]) / length};
  }
  /// Height over the chord; negative below it.
  double height(const Point& p) const { return along[0] * (p[1] - left[1]) - along[1] * (p[0] - left[0]); }
  /// Returns the half angle of the arc through a point below the chord: π less the angle that the chord subtends at the
  /// point (inscribed angle theorem).
  double half_angle(const Point& p) const {
    const double ax = left[0] - p[0], ay = left[1] - p[1], bx = right[0] - p[0], by = right[1] - p[1];
    return std::atan2(std::abs(ax * by - ay * bx), -(ax * bx + ay * by));
  }
  Circle circle(double half_angle) const {
    const double offset = 0.5 * length / std::tan(half_angle);
    return {{middle[0] - along[1] * offset, middle[1] + along[0] * offset}, 0.5 * length / std::sin(half_angle)};
  }
};

/// Returns the smallest half angle whose arc is tangent to the segment from p to q from above.
std::optional<double> touch_segment(const Chord& chord, const Point& p, const Point& q) {
  const double length = std::hypot(q[0] - p[0], q[1] - p[1]);
  if (!(length > 0)) return {};
  const Point t{(q[0] - p[0]) / length, (q[1] - p[1]) / length};
  // Coordinates along the segment (s) and normal to it (d). The tangent circle of radius r touches at s = T: (s - T)² +
  // d² = 2 r d for both ends of the chord.
  auto along = [&](const Point& x) { return (x[0] - p[0]) * t[0] + (x[1] - p[1]) * t[1]; };
  auto off = [&](const Point& x) { return (x[1] - p[1]) * t[0] - (x[0] - p[0]) * t[1]; };
  const double sa = along(chord.left), sb = along(chord.right);
  double da = off(chord.left), db = off(chord.right);
  if (da * db <= 0) return {};
  const double side = da > 0 ? 1 : -1;
  da *= side, db *= side;
  if (std::min(da, db) < 1e-9 * chord.length) return {};
  const double a = db - da, b = db * sa - da * sb, c = db * (sa * sa + da * da) - da * (sb * sb + db * db);
  double roots[2];
  if (std::abs(a) < 1e-12 * chord.length) {
    if (b == 0) return {};
    roots[0] = roots[1] = 0.5 * c / b;
  } else {
    const double root = std::sqrt(std::max(0.0, b * b - a * c));
    roots[0] = (b - root) / a, roots[1] = (b + root) / a;
  }
  std::optional<double> best;
  for (double at : roots) {
    if (at < 0 || at > length) continue;
    const Point place{p[0] + at * t[0], p[1] + at * t[1]};
    if (chord.height(place) >= 0 || place[0] <= chord.left[0] || place[0] >= chord.right[0]) continue;
    const double angle = chord.half_angle(place);
    if (!best || angle < *best) best = angle;
  }
  return best;
}

/// Returns the line that composite circles continue along, from left to right.
std::vector<Point> list_floor(const Slope& slope) {
  std::vector<Point> line;
  for (const Strip& strip : slope.strips().strips) {
    line.push_back({strip.left, strip.floor.y});
    line.push_back({strip.right, strip.floor.at(strip.right - strip.left)});
  }
  return mesh::drop_straight_points(line, false, 1e-9 * (slope.right() - slope.left()));
}

/// Distance from the end of a bar to the surface just behind it, over its length [-].
constexpr double behind = 1e-6;
/// Largest number of ends that circles are tied to.
constexpr std::size_t most_ends = 24;

}  // namespace

std::vector<Point> list_bar_ends(const Section& section) {
  std::vector<Point> all;
  for (const Bar& bar : section.bars) {
    const double dx = bar.end[0] - bar.head[0], dy = bar.end[1] - bar.head[1];
    all.push_back({bar.end[0] + behind * dx, bar.end[1] + behind * dy});
    // The other end is one too where nothing holds it, as that of a sheet in the soil.
    if (bar.hold == BarHold::bond && bar.plate == 0)
      all.push_back({bar.head[0] - behind * dx, bar.head[1] - behind * dy});
  }
  if (all.size() <= most_ends) return all;
  std::vector<Point> ends;
  for (std::size_t i = 0; i < most_ends; ++i) ends.push_back(all[i * all.size() / most_ends]);
  return ends;
}

Arcs::Arcs(const Slope& slope, double smallest_depth, bool composite, const std::optional<TangentLines>& tangent)
    : slope_(&slope),
      smallest_depth_(smallest_depth),
      composite_(composite || slope.strips().firm),
      regions_(slope.section().regions),
      tangent_(tangent) {
  const double left = slope.left(), right = slope.right(), base = slope.section().base, far = base - (right - left);
  if (composite) {
    Region below{-1, {{left, base}, {right, base}}};
    if (slope.strips().raised) below.polygon = list_floor(slope);
    below.polygon.push_back({right, far});
    below.polygon.push_back({left, far});
    regions_.push_back(std::move(below));
  }
  for (const Point& p : list_bar_ends(slope.section())) regions_.push_back({-1, {p}});
  if (!tangent) return;
  // Each line as a polygon without area: there and back.
  const auto close = [](const std::vector<Point>& line) {
    Region region{-1, line};
    for (std::size_t i = line.size() - 1; i-- > 1;) region.polygon.push_back(line[i]);
    return region;
  };
  upper_ = close(tangent->upper);
  lower_ = close(tangent->lower);
}

bool Arcs::restrict_to_tangents(double left, double right, double steepness, AngleRange& range) const {
  constexpr double rounding = 1e-9;
  const auto lower = find_touch(left, right, lower_);
  if (!lower) return false;
  if (!tangent_->is_level) {
    if (*lower < range.from || *lower > range.to) return false;
    range = {*lower * (1 - rounding), *lower, false};
    return true;
  }
  // The deepest point of a circle lies between its ends if the half angle exceeds the inclination of the chord.
  range.from = std::max(range.from, steepness * (1 + rounding));
  if (const auto upper = find_touch(left, right, upper_)) range.from = std::max(range.from, *upper * (1 - rounding));
  if (*lower < range.to) range.to = *lower, range.to_base = false;
  return range.from < range.to;
}

double Arcs::measure_half_angle(const Surface& arc) {
  const Circle& c = *arc.circle;
  auto lean = [&](double x) { return std::asin(std::clamp((x - c.centre[0]) / c.radius, -1.0, 1.0)); };
  return 0.5 * (lean(arc.to) - lean(arc.from));
}

Surface Arcs::make_arc(double left, double right, double half_angle) const {
  const Chord chord({left, slope_->lower_ground(left)}, {right, slope_->lower_ground(right)});
  Surface s;
  s.circle = chord.circle(half_angle);
  s.from = left;
  s.to = right;
  return s;
}

double Arcs::find_depth(double left, double right, double half_angle) const {
  const Circle c = Chord({left, slope_->lower_ground(left)}, {right, slope_->lower_ground(right)}).circle(half_angle);
  const auto& ground = slope_->section().ground;
  double depth = 0;
  auto next = std::upper_bound(ground.begin(), ground.end(), left, [](double x, const Point& p) { return x < p[0]; });
  for (auto q = next; q != ground.end(); ++q) {
    if (q == ground.begin()) continue;
    const Point& a = *(q - 1);
    const Point& b = *q;
    if (a[0] >= right) break;
    if (b[0] <= a[0]) continue;
    const double slope = (b[1] - a[1]) / (b[0] - a[0]);
    // The depth under a straight piece is largest where the arc is parallel to it.
    const double x = std::clamp(c.centre[0] + c.radius * slope / std::hypot(1.0, slope), std::max(left, a[0]),
                                std::min(right, b[0]));
    const double off = std::min(std::abs(x - c.centre[0]), c.radius);
    depth = std::max(depth, a[1] + slope * (x - a[0]) - c.centre[1] + std::sqrt(c.radius * c.radius - off * off));
  }
  return depth;
}

std::optional<AngleRange> Arcs::find_range(double left, double right) const {
  if (!(right - left > 1e-9 * (slope_->right() - slope_->left()))) return {};
  const Chord chord({left, slope_->lower_ground(left)}, {right, slope_->lower_ground(right)});
  const double steepness = std::asin(std::min(1.0, std::abs(chord.along[1])));
  AngleRange range{flattest, pi / 2 - steepness, false};
  const auto& ground = slope_->section().ground;
  auto p = std::upper_bound(ground.begin(), ground.end(), left, [](double x, const Point& q) { return x < q[0]; });
  for (; p != ground.end() && (*p)[0] < right; ++p)
    if (chord.height(*p) < 0) range.from = std::max(range.from, chord.half_angle(*p));
  if (!composite_) {
    // Tangent to the base: cosβ cosθ + (2h/L) sinθ = 1, with h the height of the chord's middle over the base.
    const double a = chord.along[0], b = 2 * (chord.middle[1] - slope_->section().base) / chord.length;
    const double tangent = std::atan2(b, a) + std::acos(std::min(1.0, 1 / std::hypot(a, b)));
    if (std::hypot(a, b) < 1) return {};
    if (tangent * (1 - 1e-9) < range.to) range.to = tangent * (1 - 1e-9), range.to_base = true;
  }
  if (!(range.from < range.to)) return {};
  if (smallest_depth_ > 0 && find_depth(left, right, range.from) < smallest_depth_) {
    if (find_depth(left, right, range.to) < smallest_depth_) return {};
    double low = range.from, high = range.to;
    for (int i = 0; i < 50 && high - low > 1e-12; ++i) {
      const double middle = 0.5 * (low + high);
      (find_depth(left, right, middle) < smallest_depth_ ? low : high) = middle;
    }
    range.from = high * (1 + 1e-9);
    if (!(range.from < range.to)) return {};
  }
  if (tangent_ && !restrict_to_tangents(left, right, steepness, range)) return {};
  return range;
}

std::optional<double> Arcs::find_touch(double left, double right, const Region& region) const {
  const Chord chord({left, slope_->lower_ground(left)}, {right, slope_->lower_ground(right)});
  std::optional<double> best;
  const auto& corners = region.polygon;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point& p = corners[i];
    std::optional<double> angle;
    if (p[0] > left && p[0] < right && chord.height(p) < 0) angle = chord.half_angle(p);
    const auto tangent = touch_segment(chord, p, corners[(i + 1) % corners.size()]);
    if (tangent && (!angle || *tangent < *angle)) angle = tangent;
    if (angle && (!best || *angle < *best)) best = angle;
  }
  if (best) *best *= 1 - 1e-9;  // the arc touches the region but does not enter it
  return best;
}

// Places of the ends of trial circles on the ground.

namespace {

/// Density of trial points along the ground [1/m]: it gives every slope the same number, whatever its size, and
/// decreases with the distance from it.
class Density {
 public:
  explicit Density(const Slope& slope) {
    const auto& ground = slope.section().ground;
    double highest = ground.front()[1], lowest = highest;
    for (const Point& p : ground) highest = std::max(highest, p[1]), lowest = std::min(lowest, p[1]);
    for (std::size_t i = 1; i < ground.size(); ++i) {
      const double height = std::abs(ground[i][1] - ground[i - 1][1]);
      // Small steps get fewer points than the slope that they stand on.
      if (height > 1e-6 * (highest - lowest))
        faces_.push_back({ground[i - 1][0], ground[i][0], height, std::sqrt(height / (highest - lowest))});
    }
    floor_ = 2 / (slope.right() - slope.left());
  }
  double operator()(double x) const {
    double density = floor_;
    for (const Face& f : faces_) {
      const double distance = std::max({f.from - x, x - f.to, 0.0});
      density = std::max(density, f.weight / (distance + 0.5 * f.height));
    }
    return density;
  }

 private:
  struct Face {
    double from, to, height, weight;
  };
  std::vector<Face> faces_;
  double floor_ = 0;
};

}  // namespace

std::vector<double> place_points(const Slope& slope, double from, double to, int count, int seed) {
  from = std::max(from, slope.left());
  to = std::min(to, slope.right());
  if (!(to > from) || count < 2) return {from};
  const Density density(slope);
  constexpr int cells = 4000;
  const double width = (to - from) / cells;
  std::vector<double> sum(cells + 1, 0.0);
  for (std::size_t i = 0; i < cells; ++i)
    sum[i + 1] = sum[i] + density(from + (static_cast<double>(i) + 0.5) * width) * width;
  std::vector<double> points{from};
  RandomParts parts(seed);
  std::size_t cell = 0;
  for (int i = 1; i + 1 < count; ++i) {
    // A perturbation of less than half a spacing preserves the order of the points.
    const double target = sum.back() * (i + (seed > 0 ? 0.49 * parts.draw() : 0)) / (count - 1);
    while (sum[cell + 1] < target) ++cell;
    points.push_back(from + width * (static_cast<double>(cell) + (target - sum[cell]) / (sum[cell + 1] - sum[cell])));
  }
  points.push_back(to);
  // Circles often end at a corner of the ground: the nearest point, if still free, is moved there; the nearest pair
  // first.
  std::vector<std::array<double, 2>> corners;  // distance to the nearest point, x
  for (const Point& corner : slope.section().ground) {
    const double x = corner[0];
    if (x <= from || x >= to) continue;
    const auto right = std::upper_bound(points.begin(), points.end(), x);
    corners.push_back({std::min(x - *(right - 1), *right - x), x});
  }
  std::stable_sort(corners.begin(), corners.end(), [](auto& a, auto& b) { return a[0] < b[0]; });
  std::vector<char> taken(points.size(), 0);
  taken.front() = taken.back() = 1;
  for (const auto& [distance, x] : corners) {
    const auto right = std::upper_bound(points.begin(), points.end(), x);
    const auto nearest = x - *(right - 1) < *right - x ? right - 1 : right;
    auto& used = taken[static_cast<std::size_t>(nearest - points.begin())];
    if (!used) *nearest = x, used = 1;
  }
  return points;
}

}  // namespace talus::lem
