// SPDX-License-Identifier: MIT
// Ponds and water tables on the ground of a section.
#include "site/standing_water.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/numbers.hpp"
#include "site/site.hpp"

namespace talus::site {

namespace {

/// Columns in which the water table is traced.
constexpr int columns = 400;
/// Time before the start, over the duration of what follows, at which a series that jumps at the start has its earlier
/// value.
constexpr double just_before = 1e-9;

/// Returns the line of that name, or the top of the box, which soil may reach. Other sides of the box bear no pond.
std::optional<mesh::Line> find_line(const mesh::Plan& plan, const std::string& name) {
  for (const mesh::Line& line : plan.lines)
    if (line.name == name) return line;
  if (name != "top") return std::nullopt;
  return mesh::Line{.name = name, .points = {{plan.box_min[0], plan.box_max[1]}, plan.box_max}};
}

double find_width(const Polyline& ground) {
  return ground.back()[0] - ground.front()[0];
}

}  // namespace

double find_water_table(const std::vector<std::array<double, 2>>& table, double x) {
  if (x <= table.front()[0]) return table.front()[1];
  for (std::size_t i = 1; i < table.size(); ++i) {
    const auto &a = table[i - 1], &b = table[i];
    if (x <= b[0]) return a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0]);
  }
  return table.back()[1];
}

bool is_step(const Point& a, const Point& b) {
  constexpr double steepest = 10;
  return std::abs(b[1] - a[1]) > steepest * (b[0] - a[0]);
}

bool has_step(const Polyline& table) {
  for (std::size_t i = 1; i < table.size(); ++i)
    if (is_step(table[i - 1], table[i])) return true;
  return false;
}

double leave_steps(const Polyline& table, double x, double middle) {
  for (std::size_t i = 1; i < table.size(); ++i) {
    const Point &a = table[i - 1], &b = table[i];
    if (!is_step(a, b)) continue;
    if (middle <= a[0]) x = std::min(x, a[0]);
    if (middle >= b[0]) x = std::max(x, b[0]);
  }
  return x;
}

double find_first_time(const input::Case& data) {
  return data.timeline ? -just_before * data.timeline->duration : 0;
}

double find_weather_start(const input::Case& data) {
  const bool has_season = data.initial.water.season > 0 && data.initial.result.empty();
  return has_season ? -(1 + just_before) * data.initial.water.season : find_first_time(data);
}

std::vector<Pond> find_ponds(const input::Case& data, const Polyline& ground, double time) {
  std::vector<Pond> ponds;
  const double weight = find_water_weight(data), near = 1e-6 * find_width(ground);
  for (const input::Hydraulic& h : data.hydraulics) {
    const bool is_head = h.condition == input::WaterCondition::total_head;
    if (!is_head && h.condition != input::WaterCondition::pressure) continue;
    const std::optional<mesh::Line> line = find_line(data.mesh, h.on);
    if (!line) continue;
    const double value = h.values().at(time);
    for (std::size_t i = 1; i < line->points.size(); ++i) {
      Point a = line->points[i - 1], b = line->points[i];
      if (a[0] > b[0]) std::swap(a, b);
      if (b[0] - a[0] <= near || std::abs(find_level(ground, (a[0] + b[0]) / 2) - (a[1] + b[1]) / 2) > near) continue;
      const auto find = [&](const Point& x) { return is_head ? value : x[1] + value / weight; };
      // Only the part of the ground that is under water.
      double over_a = find(a) - a[1], over_b = find(b) - b[1];
      if (over_a <= 0 && over_b <= 0) continue;
      if (over_a * over_b < 0) {
        const double share = over_a / (over_a - over_b);
        const Point cut{a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])};
        (over_a < 0 ? a : b) = cut;
      }
      ponds.push_back({a, b, find(a), find(b)});
    }
  }
  std::sort(ponds.begin(), ponds.end(), [](const Pond& a, const Pond& b) { return a.from[0] < b.from[0]; });
  return ponds;
}

std::vector<std::string> find_open_ends(const std::vector<Pond>& ponds, const Polyline& ground,
                                        const ShownUnit& length) {
  constexpr double noticeable = 1e-3;
  const double step = 1e-6 * find_width(ground);
  std::vector<std::string> notes;
  const auto look = [&](const Point& end, double level, double side) {
    const double x = end[0] + side * step;
    if (x <= ground.front()[0] || x >= ground.back()[0] || find_standing_level(ponds, {}, ground, x)) return;
    if (level - find_level(ground, x) < noticeable * find_width(ground)) return;
    notes.push_back(
        fmt::format("the standing water with its level at y = {} has no bank at x = {}, where the ground "
                    "is at {}: extend its line to the bank",
                    format_coordinate(level, length), format_coordinate(end[0], length),
                    format_coordinate(find_level(ground, x), length)));
  };
  for (const Pond& p : ponds) {
    look(p.from, p.level_from, -1);
    look(p.to, p.level_to, 1);
  }
  return notes;
}

std::optional<double> find_standing_level(const std::vector<Pond>& ponds, const Polyline& table, const Polyline& ground,
                                          double x) {
  std::optional<double> level;
  for (const Pond& p : ponds) {
    if (x < p.from[0] || x > p.to[0]) continue;
    const double here = p.level_from + (p.level_to - p.level_from) * (x - p.from[0]) / (p.to[0] - p.from[0]);
    level = std::max(level.value_or(here), here);
  }
  if (!table.empty()) {
    const double here = find_water_table(table, x);
    if (here > find_level(ground, x)) level = std::max(level.value_or(here), here);
  }
  return level;
}

Polyline trace_water_table(const lem::PressureGrid& grid, const std::vector<Pond>& ponds, const Polyline& ground,
                           double base) {
  const double left = ground.front()[0], width = find_width(ground), dry = base - width;
  std::vector<double> wet_top(columns + 1, dry);
  const auto x_of = [&](int c) { return left + width * c / columns; };
  for (const auto& t : grid.triangles) {
    double low = std::numeric_limits<double>::max(), high = -low;
    for (const int i : t) low = std::min(low, grid.nodes[i][0]), high = std::max(high, grid.nodes[i][0]);
    const int first = std::max(0, static_cast<int>(std::ceil((low - left) / width * columns - 1e-9))),
              last = std::min(columns, static_cast<int>(std::floor((high - left) / width * columns + 1e-9)));
    for (int c = first; c <= last; ++c) {
      // The intersections of the column with the sides of the triangle.
      double y[2] = {0, 0}, u[2] = {0, 0};
      int met = 0;
      for (int k = 0; k < 3; ++k) {
        const int i = t[k], j = t[(k + 1) % 3];
        const Point &a = grid.nodes[i], &b = grid.nodes[j];
        if (std::abs(b[0] - a[0]) <= 1e-12 * width) continue;
        const double share = (x_of(c) - a[0]) / (b[0] - a[0]);
        if (share < -1e-9 || share > 1 + 1e-9) continue;
        const double here = a[1] + share * (b[1] - a[1]),
                     pressure = grid.pressure[i] + share * (grid.pressure[j] - grid.pressure[i]);
        if (met == 0) {
          y[0] = y[1] = here;
          u[0] = u[1] = pressure;
          met = 1;
        } else if (here < y[0]) {
          y[0] = here, u[0] = pressure;
        } else if (here > y[1]) {
          y[1] = here, u[1] = pressure;
        }
      }
      if (met == 0) continue;
      if (u[0] >= 0) wet_top[c] = std::max(wet_top[c], u[1] >= 0 ? y[1] : y[0] + (y[1] - y[0]) * u[0] / (u[0] - u[1]));
    }
  }
  Polyline table;
  const auto add = [&](double x, double y) {
    if (table.empty() || x > table.back()[0]) table.push_back({x, y});
  };
  const double step = 1e-7 * width;
  for (int c = 0; c <= columns; ++c) {
    const double x = x_of(c), next = x_of(c + 1), level_here = std::min(wet_top[c], find_level(ground, x));
    const auto standing = find_standing_level(ponds, {}, ground, x);
    add(x, standing.value_or(level_here));
    const auto beside = [&](double bank) { return find_standing_level(ponds, {}, ground, bank).value_or(level_here); };
    for (const Pond& p : ponds) {  // banks of ponds are steps, unless the next pond begins there
      if (p.from[0] > x && p.from[0] < next)
        add(p.from[0] - step, beside(p.from[0] - step)), add(p.from[0], p.level_from);
      if (p.to[0] > x && p.to[0] < next) add(p.to[0], p.level_to), add(p.to[0] + step, beside(p.to[0] + step));
    }
  }
  return table;
}

Polyline add_ponds(const Polyline& table, const std::vector<Pond>& ponds, const Polyline& ground) {
  const double step = 1e-7 * find_width(ground);
  std::vector<double> breaks{ground.front()[0], ground.back()[0]};
  for (const Point& x : table) breaks.push_back(x[0]);
  for (const Pond& p : ponds)
    for (const double x : {p.from[0] - step, p.from[0], p.to[0], p.to[0] + step}) breaks.push_back(x);
  std::sort(breaks.begin(), breaks.end());
  Polyline line;
  for (const double x : breaks) {
    if (!line.empty() && x <= line.back()[0]) continue;
    line.push_back({x, find_standing_level(ponds, {}, ground, x).value_or(find_water_table(table, x))});
  }
  return line;
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
    if (open && open->depth > noticeable * relief_ && !is_step({open->from, open->highest}, {open->to, open->lowest}))
      standing_.push_back(*open);
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

std::vector<std::string> find_odd_water(const Site& site) {
  if (!site.has_ground()) return {};
  const input::Case& data = site.data();
  const Polyline& ground = site.ground();
  // A water table far below dry ground is the reference level of suction.
  const bool has_suction = std::any_of(data.materials.begin(), data.materials.end(), [](const auto& entry) {
    return entry.second.water.is_wet() || entry.second.slices.suction_strength == input::SuctionStrength::phi_b;
  });
  const double base = has_suction ? std::numeric_limits<double>::lowest() : find_base(data.mesh);
  const ShownUnit& length = data.units().length;
  std::vector<std::string> sentences = find_odd_water(site.water_table(), ground, base, length, "The water table");
  if (data.lem.drawdown && input::uses(data, Method::lem))
    for (std::string& sentence :
         find_odd_water(data.lem.drawdown->water_table, ground, base, length, "The water table after drawdown"))
      sentences.push_back(std::move(sentence));
  return sentences;
}

}  // namespace talus::site
