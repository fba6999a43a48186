// SPDX-License-Identifier: MIT
#include "ground/water_shape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "ground/initial_water.hpp"

namespace talus::ground {
namespace {

/// Fraction of the relief of the ground: shallower water may be a line drawn along the ground, and a smaller difference
/// of levels a rounded number.
constexpr double noticeable = 0.02;
/// Fraction of the relief: water that stands higher above the crest is probably in other units or coordinates.
constexpr double far_above = 2;

/// Water that stands on the ground.
struct Standing {
  double from = 0, to = 0;         ///< x [m]
  double lowest = 0, highest = 0;  ///< level [m]
  double depth = 0;                ///< largest [m]
};

/// A water table over the ground.
class Table {
 public:
  Table(const Polyline& table, const Polyline& ground, std::string name)
      : table_(table), ground_(ground), name_(std::move(name)) {
    low_ = high_ = ground.front()[1];
    for (const Point& p : ground) low_ = std::min(low_, p[1]), high_ = std::max(high_, p[1]);
    relief_ = high_ > low_ ? high_ - low_ : ground.back()[0] - ground.front()[0];
    find_standing();
  }

  std::vector<std::string> describe(double base) {
    if (left() > table_.back()[0] || right() < table_.front()[0])
      say("{} runs from x = {} m to {} m, outside the section, which runs from {} m to {} m: its level at the nearer "
          "end is used everywhere",
          name_, format_coordinate(table_.front()[0]), format_coordinate(table_.back()[0]), format_coordinate(left()),
          format_coordinate(right()));
    const double lowest = find_extreme(false), highest = find_extreme(true);
    if (highest < base)
      say("{} lies below the section: its highest level is y = {} m, and the lowest soil is at y = {} m", name_,
          format_coordinate(highest), format_coordinate(base));
    if (lowest > high_ + far_above * relief_)
      say("{} is at least {:.3g} m above the highest ground: the whole section is under water", name_, lowest - high_);
    for (const Standing& s : standing_)
      if (s.highest - s.lowest > noticeable * relief_ && !is_flood(s))
        say("{} is above the ground from x = {} m to {} m and slopes there between y = {} m and {} m; standing water "
            "is level. Lower it to the ground where there is no pond",
            name_, write(s.from), write(s.to), write(s.lowest), write(s.highest));
    describe_end(true);
    describe_end(false);
    return std::move(sentences_);
  }

 private:
  double left() const { return ground_.front()[0]; }
  double right() const { return ground_.back()[0]; }

  /// To a millimetre: crossings of lines have more digits than a reader needs.
  static std::string write(double x) { return format_coordinate(std::round(x * 1e3) / 1e3); }

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

  /// Ends of the lines, and places where they cross.
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

  /// True where the table slopes at its end and its level continuation covers lower ground.
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
    say("{} ends at x = {} m, inside the section, and continues level at y = {} m: there it floods the ground up to "
        "{:.3g} m deep. Give its points up to x = {} m",
        name_, format_coordinate(end[0]), format_coordinate(end[1]), depth,
        format_coordinate(at_right ? right() : left()));
  }

  const Polyline& table_;
  const Polyline& ground_;
  std::string name_;
  double low_ = 0, high_ = 0, relief_ = 0;
  std::vector<double> breaks_;
  std::vector<Standing> standing_;
  std::vector<std::string> sentences_;
};

}  // namespace

std::vector<std::string> find_odd_water(const Polyline& table, const Polyline& ground, double base,
                                        const std::string& name) {
  if (table.empty() || ground.size() < 2) return {};
  return Table(table, ground, name).describe(base);
}

std::vector<std::string> find_odd_water(const input::Case& data) {
  if (data.mesh.dimension != 2 || data.mesh.polygons.empty()) return {};
  Polyline ground;
  try {
    ground = find_ground(data.mesh);
  } catch (const Error&) {
    return {};  // finite elements and material points take sections with overhangs
  }
  // Far below dry ground a water table is the source of suction.
  const bool has_suction = std::any_of(data.materials.begin(), data.materials.end(), [](const auto& entry) {
    return entry.second.water.is_wet() || entry.second.slices.suction_strength == input::SuctionStrength::phi_b;
  });
  const double base = has_suction ? std::numeric_limits<double>::lowest() : find_base(data.mesh);
  std::vector<std::string> sentences;
  if (data.initial.water.pressure == input::InitialPressure::water_table)
    sentences = find_odd_water(data.initial.water.water_table, ground, base, "The water table");
  if (data.lem.drawdown && input::uses(data, Method::lem))
    for (std::string& sentence :
         find_odd_water(data.lem.drawdown->water_table, ground, base, "The water table after drawdown"))
      sentences.push_back(std::move(sentence));
  return sentences;
}

}  // namespace talus::ground
