// SPDX-License-Identifier: MIT
// The ground line as the upper limit of the polygons, steep faces of cohesionless soil, and implausible water tables.
#include "site/ground_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "mesh/planar.hpp"
#include "site/initial_water.hpp"

namespace talus::site {

namespace {

/// Lengths below this fraction of the section's width count as zero.
constexpr double nothing = 1e-9;

struct Edge {
  Point a{}, b{};  ///< a[0] < b[0]
  int polygon = 0;
  double at(double x) const { return a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0]); }
  bool spans(double x) const { return a[0] < x && x < b[0]; }
};

std::vector<Edge> list_edges(const mesh::Plan& plan, double least) {
  std::vector<Edge> edges;
  for (std::size_t p = 0; p < plan.polygons.size(); ++p) {
    const auto& corners = plan.polygons[p].points;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      Point a = corners[i], b = corners[(i + 1) % corners.size()];
      if (std::abs(a[0] - b[0]) <= least) continue;  // a vertical edge bounds no soil above or below
      if (a[0] > b[0]) std::swap(a, b);
      edges.push_back({a, b, static_cast<int>(p)});
    }
  }
  return edges;
}

/// Returns all x at which the order of the edges may change.
std::vector<double> list_breaks(const std::vector<Edge>& edges, double least) {
  std::vector<double> breaks;
  for (const Edge& e : edges) {
    breaks.push_back(e.a[0]);
    breaks.push_back(e.b[0]);
    for (const Edge& f : edges) {
      const double from = std::max(e.a[0], f.a[0]), to = std::min(e.b[0], f.b[0]);
      if (to - from <= least) continue;
      const double before = e.at(from) - f.at(from), after = e.at(to) - f.at(to);
      if (before * after < 0) breaks.push_back(from + (to - from) * before / (before - after));
    }
  }
  std::sort(breaks.begin(), breaks.end());
  std::vector<double> distinct;
  for (const double x : breaks)
    if (distinct.empty() || x - distinct.back() > least) distinct.push_back(x);
  return distinct;
}

/// Throws Error (wrong_input) if the soil at `x` has a gap below its upper limit. `levels`: elevations of the edges at
/// x, with their polygons.
void check_column(std::vector<std::pair<double, int>> levels, double x, double least, const ShownUnit& length) {
  std::sort(levels.begin(), levels.end());
  std::vector<std::array<double, 2>> filled;
  std::vector<std::pair<int, double>> open;  // polygon, elevation of its lower limit
  for (const auto& [y, polygon] : levels) {
    const auto begun =
        std::find_if(open.begin(), open.end(), [polygon = polygon](const auto& o) { return o.first == polygon; });
    if (begun == open.end()) {
      open.emplace_back(polygon, y);
    } else {
      filled.push_back({begun->second, y});
      open.erase(begun);
    }
  }
  std::sort(filled.begin(), filled.end());
  double top = filled.empty() ? 0 : filled.front()[1];
  for (const auto& [from, to] : filled) {
    if (from - top > least)
      throw Error(ExitCode::wrong_input, fmt::format("the soil at x = {} has a gap between y = {} and {}: LEM "
                                                     "needs soil without overhangs and cavities from the ground down",
                                                     format_coordinate(x, length), format_coordinate(top, length),
                                                     format_coordinate(from, length)));
    top = std::max(top, to);
  }
}

}  // namespace

Polyline find_ground(const mesh::Plan& plan) {
  double left = std::numeric_limits<double>::max(), right = std::numeric_limits<double>::lowest();
  for (const mesh::Polygon& p : plan.polygons)
    for (const Point& x : p.points) left = std::min(left, x[0]), right = std::max(right, x[0]);
  const double least = nothing * (right - left);
  const std::vector<Edge> edges = list_edges(plan, least);
  const std::vector<double> breaks = list_breaks(edges, least);
  const ShownUnit& length = plan.units.length;
  Polyline ground;
  const auto add = [&](const Point& x) {
    if (!ground.empty() && std::hypot(x[0] - ground.back()[0], x[1] - ground.back()[1]) <= 2 * least) return;
    ground.push_back(x);
  };
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    const double middle = (breaks[i] + breaks[i + 1]) / 2;
    const Edge* top = nullptr;
    std::vector<std::pair<double, int>> levels;
    for (const Edge& e : edges) {
      if (!e.spans(middle)) continue;
      levels.emplace_back(e.at(middle), e.polygon);
      if (top == nullptr || e.at(middle) > top->at(middle)) top = &e;
    }
    if (top == nullptr)
      throw Error(ExitCode::wrong_input,
                  fmt::format("there is no soil between x = {} and {}: LEM needs a ground "
                              "without gaps",
                              format_coordinate(breaks[i], length), format_coordinate(breaks[i + 1], length)));
    check_column(std::move(levels), middle, least, length);
    add({breaks[i], top->at(breaks[i])});
    add({breaks[i + 1], top->at(breaks[i + 1])});
  }
  return mesh::drop_straight_points(ground, false, least);
}

double find_level(const Polyline& ground, double x) {
  if (x < ground.front()[0]) return ground.front()[1];
  if (x > ground.back()[0]) return ground.back()[1];
  double level = std::numeric_limits<double>::lowest();
  for (std::size_t i = 1; i < ground.size(); ++i) {
    const Point &a = ground[i - 1], &b = ground[i];
    if (x < a[0] || x > b[0]) continue;
    level = std::max(level, b[0] > a[0] ? a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0]) : std::max(a[1], b[1]));
  }
  return level;
}

double find_base(const mesh::Plan& plan) {
  double base = std::numeric_limits<double>::max();
  for (const mesh::Polygon& p : plan.polygons)
    for (const Point& x : p.points) base = std::min(base, x[1]);
  return base;
}

double find_slope_height(const mesh::Plan& plan, const Polyline& ground) {
  double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();
  for (const Point& x : ground) low = std::min(low, x[1]), high = std::max(high, x[1]);
  return high > low ? high - low : high - find_base(plan);
}

namespace {

constexpr double degree = std::numbers::pi / 180;
/// Tolerance for rounded coordinates of a slope at the angle of repose [rad].
constexpr double rounding = 0.1 * degree;

/// Returns the material of the smallest polygon at a point; nullptr if there is none.
const std::string* find_material(const input::Case& data, const Point& below) {
  const std::string* found = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const mesh::Polygon& polygon : data.mesh.polygons) {
    const auto region = data.regions.find(polygon.name);
    if (region == data.regions.end() || !mesh::is_inside(below, polygon.points)) continue;
    const double area = std::abs(mesh::compute_area(polygon.points));
    if (area >= least) continue;
    least = area;
    found = &region->second;
  }
  return found;
}

/// Returns φ of a soil without cohesion and suction; nothing for other soils.
std::optional<double> find_bare_friction(const input::Material& m) {
  const auto strength = material::find_slice_strength(m.model, m);
  if (!strength || strength->cohesion > 0 || strength->cohesion_gradient > 0) return std::nullopt;
  const bool has_suction = m.slices.suction_strength == input::SuctionStrength::phi_b ||
                           (m.slices.suction_strength != input::SuctionStrength::none && m.water.is_wet());
  return has_suction ? std::nullopt : std::optional(strength->friction_angle);
}

}  // namespace

double SteepFace::factor() const {
  return std::tan(friction_angle) / std::tan(slope);
}

std::vector<SteepFace> find_steep_faces(const input::Case& data) {
  std::vector<SteepFace> faces;
  if (data.mesh.dimension != 2 || data.mesh.polygons.empty() || !data.roots.empty()) return faces;
  Polyline ground;
  try {
    ground = find_ground(data.mesh);
  } catch (const Error&) {
    return faces;  // FEM and MPM accept sections with overhangs
  }
  for (std::size_t i = 1; i < ground.size(); ++i) {
    const Point &a = ground[i - 1], &b = ground[i];
    const double dx = b[0] - a[0], dy = b[1] - a[1], length = std::hypot(dx, dy);
    if (!(length > 0) || dy == 0) continue;
    // A point just behind the face.
    const double depth = 1e-4 * length;
    const Point below{(a[0] + b[0]) / 2 + depth * dy / length, (a[1] + b[1]) / 2 - depth * dx / length};
    const std::string* material = find_material(data, below);
    if (material == nullptr) continue;
    const std::optional<double> friction = find_bare_friction(data.materials.at(*material));
    const double slope = std::atan2(std::abs(dy), dx);
    if (!friction || slope <= *friction + rounding) continue;
    faces.push_back({dy > 0 ? a : b, dy > 0 ? b : a, *material, slope, *friction});
  }
  return faces;
}

std::string describe(const SteepFace& face, const ShownUnit& length) {
  return fmt::format(
      "The ground between {} and {} rises at {:.1f}°, more than φ = {:.1f}° of '{}', which "
      "has no cohesion: it is unstable by inspection (a long slope of it has the factor {:.2f}), whatever a method "
      "finds. Check the cohesion and the geometry.",
      format_point(face.lower, length), format_point(face.upper, length), face.slope / degree,
      face.friction_angle / degree, face.material, face.factor());
}

namespace {

/// Fraction of the relief of the ground. Shallower water may be a line drawn along the ground, and a smaller difference
/// of levels a rounded number.
constexpr double noticeable = 0.02;
/// Fraction of the relief. Water higher than this above the crest is probably in other units or coordinates.
constexpr double far_above = 2;

/// Water standing on the ground.
struct Standing {
  double from = 0, to = 0;         ///< x [m]
  double lowest = 0, highest = 0;  ///< elevation of its surface [m]
  double depth = 0;                ///< largest depth [m]
};

/// Checks a water table against the ground.
class Table {
 public:
  Table(const Polyline& table, const Polyline& ground, const ShownUnit& length, std::string name)
      : table_(table), ground_(ground), length_(length), name_(std::move(name)) {
    low_ = high_ = ground.front()[1];
    for (const Point& p : ground) low_ = std::min(low_, p[1]), high_ = std::max(high_, p[1]);
    relief_ = high_ > low_ ? high_ - low_ : ground.back()[0] - ground.front()[0];
    find_standing();
  }

  std::vector<std::string> describe(double base) {
    if (left() > table_.back()[0] || right() < table_.front()[0])
      say("{} runs from x = {} to {}, outside the section, which runs from {} to {}: its level at the nearer "
          "end is used everywhere",
          name_, write(table_.front()[0]), write(table_.back()[0]), write(left()), write(right()));
    const double lowest = find_extreme(false), highest = find_extreme(true);
    if (highest < base)
      say("{} lies below the section: its highest level is y = {}, and the lowest soil is at y = {}", name_,
          write(highest), write(base));
    if (lowest > high_ + far_above * relief_)
      say("{} is at least {} above the highest ground: the whole section is under water", name_,
          format_value(lowest - high_, length_, 3));
    for (const Standing& s : standing_)
      if (s.highest - s.lowest > noticeable * relief_ && !is_flood(s))
        say("{} is above the ground from x = {} to {} and slopes there between y = {} and {}; standing water "
            "is level. Lower it to the ground where there is no pond",
            name_, write_rounded(s.from), write_rounded(s.to), write_rounded(s.lowest), write_rounded(s.highest));
    describe_end(true);
    describe_end(false);
    return std::move(sentences_);
  }

 private:
  double left() const { return ground_.front()[0]; }
  double right() const { return ground_.back()[0]; }

  std::string write(double x) const { return format_coordinate(x, length_); }

  /// Formats to 1/1000 of the unit, as intersections have more digits than a message needs.
  std::string write_rounded(double x) const { return write(std::round(x / length_.si * 1e3) / 1e3 * length_.si); }

  template <class... Args>
  void say(fmt::format_string<Args...> form, Args&&... args) {
    sentences_.push_back(fmt::format(form, std::forward<Args>(args)...));
  }

  double find_extreme(bool highest) const {
    double found = find_water_table(table_, left());
    for (const double x : breaks_) {
      const double level = find_water_table(table_, x);
      found = highest ? std::max(found, level) : std::min(found, level);
    }
    return found;
  }

  /// Finds the vertices of both lines and their intersections.
  void find_breaks() {
    for (const Polyline* line : {&table_, &ground_})
      for (const Point& p : *line)
        if (p[0] >= left() && p[0] <= right()) breaks_.push_back(p[0]);
    std::sort(breaks_.begin(), breaks_.end());
    const std::vector<double> corners = breaks_;
    for (std::size_t i = 1; i < corners.size(); ++i) {
      const double a = corners[i - 1], b = corners[i], near = 1e-9 * (b - a);
      const double over_a = over(a + near), over_b = over(b - near);
      if (b > a && over_a * over_b < 0) breaks_.push_back(a + (b - a) * over_a / (over_a - over_b));
    }
    std::sort(breaks_.begin(), breaks_.end());
  }

  double over(double x) const { return find_water_table(table_, x) - find_level(ground_, x); }

  void find_standing() {
    find_breaks();
    std::optional<Standing> open;
    for (std::size_t i = 1; i < breaks_.size(); ++i) {
      const double a = breaks_[i - 1], b = breaks_[i], near = 1e-6 * (b - a);
      if (!(b > a)) continue;
      const double depth = std::max(over(a + near), over(b - near));
      if (over((a + b) / 2) <= 0) {
        close(open);
        continue;
      }
      const double from = find_water_table(table_, a), to = find_water_table(table_, b);
      if (!open) open = Standing{a, b, std::min(from, to), std::max(from, to), 0};
      *open = {open->from, b, std::min({open->lowest, from, to}), std::max({open->highest, from, to}),
               std::max(open->depth, depth)};
    }
    close(open);
  }

  void close(std::optional<Standing>& open) {
    if (open && open->depth > noticeable * relief_) standing_.push_back(*open);
    open.reset();
  }

  /// Returns true if the table slopes at its end and its horizontal continuation covers lower ground.
  bool floods(bool at_right) const {
    if (table_.size() < 2) return false;
    const Point &end = at_right ? table_.back() : table_.front(),
                &inner = at_right ? table_[table_.size() - 2] : table_[1];
    const double x = end[0];
    if (x <= left() || x >= right() || std::abs(end[1] - inner[1]) <= noticeable * relief_) return false;
    return std::any_of(standing_.begin(), standing_.end(), [&](const Standing& s) {
      return at_right ? s.to > x + 1e-6 * relief_ : s.from < x - 1e-6 * relief_;
    });
  }

  bool is_flood(const Standing& s) const {
    return (floods(true) && s.to > table_.back()[0]) || (floods(false) && s.from < table_.front()[0]);
  }

  void describe_end(bool at_right) {
    if (!floods(at_right)) return;
    const Point& end = at_right ? table_.back() : table_.front();
    double depth = 0;
    for (const Standing& s : standing_) depth = std::max(depth, s.depth);
    say("{} ends at x = {}, inside the section, and continues level at y = {}: there it floods the ground up to "
        "{} deep. Give its points up to x = {}",
        name_, write(end[0]), write(end[1]), format_value(depth, length_, 3), write(at_right ? right() : left()));
  }

  const Polyline& table_;
  const Polyline& ground_;
  ShownUnit length_;
  std::string name_;
  double low_ = 0, high_ = 0, relief_ = 0;
  std::vector<double> breaks_;
  std::vector<Standing> standing_;
  std::vector<std::string> sentences_;
};

}  // namespace

std::vector<std::string> find_odd_water(const Polyline& table, const Polyline& ground, double base,
                                        const ShownUnit& length, const std::string& name) {
  if (table.empty() || ground.size() < 2) return {};
  return Table(table, ground, length, name).describe(base);
}

std::vector<std::string> find_odd_water(const input::Case& data) {
  if (data.mesh.dimension != 2 || data.mesh.polygons.empty()) return {};
  Polyline ground;
  try {
    ground = find_ground(data.mesh);
  } catch (const Error&) {
    return {};  // FEM and MPM accept sections with overhangs
  }
  // A water table far below dry ground is the reference level of suction.
  const bool has_suction = std::any_of(data.materials.begin(), data.materials.end(), [](const auto& entry) {
    return entry.second.water.is_wet() || entry.second.slices.suction_strength == input::SuctionStrength::phi_b;
  });
  const double base = has_suction ? std::numeric_limits<double>::lowest() : find_base(data.mesh);
  const ShownUnit& length = data.units().length;
  std::vector<std::string> sentences;
  if (data.initial.water.pressure == input::InitialPressure::water_table)
    sentences = find_odd_water(data.initial.water.water_table, ground, base, length, "The water table");
  if (data.lem.drawdown && input::uses(data, Method::lem))
    for (std::string& sentence :
         find_odd_water(data.lem.drawdown->water_table, ground, base, length, "The water table after drawdown"))
      sentences.push_back(std::move(sentence));
  return sentences;
}

}  // namespace talus::site
