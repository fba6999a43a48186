// SPDX-License-Identifier: MIT
// Places of the bars of [support.NAME] in the section, and the checks of patterns, resistances and places.
#include "input/case/support.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "input/case/case.hpp"
#include "input/case/checks.hpp"
#include "input/case/support_warnings.hpp"
#include "mesh/ground.hpp"

namespace talus::input {

namespace {

using Point = std::array<double, 2>;

/// A head within this fraction of the width of the section lies on the ground: its coordinates are rounded.
constexpr double near_ground = 1e-3;

double measure_width(const mesh::Polyline& ground) {
  return ground.back()[0] - ground.front()[0];
}

/// Returns the levels of the ground at x, the lower and the upper end of a vertical step; nullopt beyond its ends.
std::optional<std::array<double, 2>> find_levels(const mesh::Polyline& ground, double x) {
  std::optional<std::array<double, 2>> levels;
  const double slack = 1e-9 * measure_width(ground);
  for (std::size_t i = 1; i < ground.size(); ++i) {
    const Point &a = ground[i - 1], &b = ground[i];
    if (x < a[0] - slack || x > b[0] + slack) continue;
    const bool is_step = b[0] - a[0] <= slack;
    const double t = is_step ? 0 : std::clamp((x - a[0]) / (b[0] - a[0]), 0.0, 1.0);
    const double first = is_step ? a[1] : a[1] + t * (b[1] - a[1]), second = is_step ? b[1] : first;
    if (!levels) levels = {first, first};
    for (const double y : {first, second}) *levels = {std::min((*levels)[0], y), std::max((*levels)[1], y)};
  }
  return levels;
}

/// Returns 1 if the ground rises towards larger x at a point of it, -1 if it falls, 0 where it is level.
int find_rise(const mesh::Polyline& ground, const Point& p) {
  const double near = near_ground * measure_width(ground);
  int rise = 0;
  for (std::size_t i = 1; i < ground.size(); ++i) {
    const Point &a = ground[i - 1], &b = ground[i];
    const double dy = b[1] - a[1];
    if (mesh::compute_distance(p, a, b) > near || std::abs(dy) < 1e-9 * measure_width(ground)) continue;
    const int own = dy > 0 ? 1 : -1;
    if (rise != 0 && rise != own) return 0;
    rise = own;
  }
  return rise;
}

/// Returns the place on the ground that is `distance` further down the slope; nullopt beyond its end.
std::optional<Point> step_down(const mesh::Polyline& ground, const Point& from, double distance, RowSpacing along) {
  const int rise = find_rise(ground, from);
  if (rise == 0) return std::nullopt;
  const double near = near_ground * measure_width(ground);
  // The walk begins on the last piece near the point.
  const auto size = static_cast<int>(ground.size());
  const auto corner = [&](int i) { return ground[static_cast<std::size_t>(rise > 0 ? size - 1 - i : i)]; };
  int piece = -1;
  for (int i = 1; i < size; ++i)
    if (mesh::compute_distance(from, corner(i - 1), corner(i)) <= near) piece = i;
  if (piece < 0) return std::nullopt;
  int last = piece;  // level ground below it is the foot
  for (int i = piece; i < size; ++i)
    if (corner(i - 1)[1] - corner(i)[1] > 1e-9 * measure_width(ground)) last = i;
  Point at = from;
  double left = distance;
  for (int i = piece; i <= last; ++i) {
    const Point& to = corner(i);
    const double dx = to[0] - at[0], dy = to[1] - at[1];
    const double step = along == RowSpacing::face ? std::hypot(dx, dy) : std::max(0.0, -dy);
    if (step >= left * (1 - 1e-12) && step > 0) return Point{at[0] + dx * left / step, at[1] + dy * left / step};
    left -= step;
    at = to;
  }
  return std::nullopt;
}

}  // namespace

double BarLine::length() const {
  return std::hypot(end[0] - head[0], end[1] - head[1]);
}

namespace {

/// Lists the heads of a support, from the top of its pattern.
std::vector<Point> list_heads(const Support& support, const mesh::Polyline& ground, const ShownUnit& unit,
                              BarLayout& out) {
  if (!support.heads.empty()) return support.heads;
  std::vector<Point> heads;
  for (const double x : support.x) {
    const auto levels = find_levels(ground, x);
    if (!levels) {
      out.fault =
          fmt::format("x = {} is not on the ground, which goes from x = {} to x = {}", format_coordinate(x, unit),
                      format_coordinate(ground.front()[0], unit), format_coordinate(ground.back()[0], unit));
      out.key = "x";
      return {};
    }
    heads.push_back({x, (*levels)[1]});
  }
  if (!support.first) return heads;
  heads.push_back(*support.first);
  for (int row = 2; row <= support.rows; ++row) {
    const auto next =
        step_down(ground, heads.front(), (row - 1) * support.row_spacing.value_or(0), support.spacing_along);
    if (!next) {
      out.fault = fmt::format(
          "row {} of {} lies beyond the foot of the slope below `first`, {}: fewer rows, or a smaller 'row_spacing'",
          row, support.rows, format_point(*support.first, unit));
      out.key = "rows";
      return {};
    }
    heads.push_back(*next);
  }
  return heads;
}

}  // namespace

BarLayout lay_bars(const Support& support, const mesh::Polyline& ground, const ShownUnit& unit) {
  BarLayout out;
  for (std::size_t i = 0; i + 1 < support.line.size(); ++i) out.bars.push_back({support.line[i], support.line[i + 1]});
  if (!support.line.empty()) return out;
  const std::vector<Point> heads = list_heads(support, ground, unit, out);
  // A case that was checked has one length or end for each head, and a spacing of its rows.
  const bool has_lengths =
      support.lengths.empty() ? support.length.has_value() : support.lengths.size() == heads.size();
  if (out.fault.empty() && (support.ends.empty() ? !has_lengths : support.ends.size() != heads.size()))
    out.fault = "bars without a length";
  if (!out.fault.empty()) return out;
  const bool is_steep = support.kind == SupportKind::pile || support.kind == SupportKind::wall;
  const double dip = support.inclination.value_or(is_steep ? std::numbers::pi / 2 : 0);
  const bool is_upright = std::cos(dip) < 1e-9;
  for (std::size_t i = 0; i < heads.size(); ++i) {
    BarLine bar{heads[i], {}, static_cast<int>(i) + 1};
    if (!support.ends.empty()) {
      bar.end = support.ends[i];
    } else {
      int rise = is_upright ? 1 : find_rise(ground, bar.head);
      if (rise == 0 && support.first) rise = find_rise(ground, *support.first);  // rows on a bench
      if (rise == 0) {
        out.fault = fmt::format(
            "the side on which soil lies is not known at the head {}: it is not on an inclined part of the ground. "
            "Give 'heads' and 'ends' instead of 'inclination' and 'length'",
            format_point(bar.head, unit));
        out.key = support.heads.empty() ? "first" : "heads";
        return out;
      }
      const double length = support.lengths.empty() ? *support.length : support.lengths[i];
      bar.end = {bar.head[0] + (is_upright ? 0 : rise * length * std::cos(dip)), bar.head[1] - length * std::sin(dip)};
    }
    out.bars.push_back(bar);
  }
  return out;
}

namespace {

/// Checks one support; messages name it.
class SupportCheck {
 public:
  SupportCheck(const Case& data, const std::string& name, const Support& support, Findings& findings)
      : data_(data), name_(name), s_(support), block_(findings, "support." + name) {}

  void run() const {
    if (!block_.is_sound("kind")) return;
    const bool has_pattern = check_pattern();
    check_resistance();
    if (s_.kind == SupportKind::anchor) check_anchor();
    if (s_.kind == SupportKind::pile) check_pile();
    if (s_.kind == SupportKind::wall) check_wall();
    if (has_pattern && data_.mesh.dimension == 2 && !data_.mesh.polygons.empty() &&
        block_.findings.is_sound("geometry.polygon"))
      check_places();
  }

 private:
  template <class... Rest>
  void fail(const std::string& key, fmt::format_string<Rest...> sentence, Rest&&... rest) const {
    // A missing key is reported at its block.
    const std::string path = key.empty() || !block_.is_given(key) ? block_.path : block_.path + "." + key;
    block_.findings.add(path,
                        fmt::format("support '{}': ", name_) + fmt::format(sentence, std::forward<Rest>(rest)...));
  }

  /// Returns true if bars can be placed.
  bool check_pattern() const {
    for (const char* key :
         {"heads", "ends", "x", "line", "first", "rows", "row_spacing", "inclination", "length", "lengths"})
      if (!block_.is_sound(key)) return false;
    const int given = int(!s_.heads.empty()) + int(!s_.x.empty()) + int(s_.first.has_value()) + int(!s_.line.empty());
    if (given != 1) {
      fail("", "{}; give either 'heads', or 'first' and 'rows'{}",
           given == 0 ? "it has no place" : "its place is given twice",
           s_.kind == SupportKind::pile   ? ", or 'x' of piles"
           : s_.kind == SupportKind::wall ? ", or 'x' of a wall, or its 'line'"
                                          : "");
      return false;
    }
    if (!s_.line.empty()) return check_line();
    if (!s_.first && (block_.is_given("rows") || s_.row_spacing)) {
      fail(s_.row_spacing ? "row_spacing" : "rows", "rows need their 'first' head");
      return false;
    }
    if (s_.rows > 1 && !s_.row_spacing) {
      fail("rows", "{} rows need a 'row_spacing'", s_.rows);
      return false;
    }
    const std::size_t bars = s_.first ? static_cast<std::size_t>(s_.rows) : std::max(s_.heads.size(), s_.x.size());
    if (!s_.ends.empty()) return check_ends(bars);
    if (s_.length.has_value() != s_.lengths.empty()) {
      fail(s_.length ? "lengths" : "", "{}; give 'length', or 'lengths' of each row{}",
           s_.length ? "the length is given twice" : "it has no length", s_.first ? "" : ", or 'ends'");
      return false;
    }
    if (!s_.lengths.empty() && s_.lengths.size() != bars) {
      fail("lengths", "'lengths' has {} values for {} {}", s_.lengths.size(), bars, s_.first ? "rows" : "heads");
      return false;
    }
    if (!s_.inclination && s_.kind != SupportKind::geosynthetic && s_.kind != SupportKind::pile &&
        s_.kind != SupportKind::wall) {
      fail("", "it needs an 'inclination'{}", s_.first ? "" : ", or 'ends'");
      return false;
    }
    return true;
  }

  bool check_line() const {
    for (const char* key : {"ends", "inclination", "length", "lengths", "rows", "row_spacing"})
      if (block_.is_given(key)) {
        fail(key, "'{}' belongs to walls without 'line'", key);
        return false;
      }
    if (s_.line.size() < 2) {
      fail("line", "'line' has one point, and a wall goes from its head to its toe");
      return false;
    }
    for (std::size_t i = 0; i + 1 < s_.line.size(); ++i)
      if (s_.line[i] == s_.line[i + 1]) {
        fail("line", "'line' has the point {} twice in a row", format_point(s_.line[i], data_.units().length));
        return false;
      }
    return true;
  }

  bool check_ends(std::size_t bars) const {
    if (s_.heads.empty() || s_.ends.size() != bars) {
      fail("ends", "'ends' has {} points for {} {}", s_.ends.size(), bars, s_.heads.empty() ? "rows" : "heads");
      return false;
    }
    for (const char* key : {"inclination", "length", "lengths"})
      if (block_.is_given(key)) {
        fail(key, "'{}' belongs to bars without 'ends'", key);
        return false;
      }
    for (std::size_t i = 0; i < bars; ++i)
      if (s_.heads[i] == s_.ends[i]) {
        fail("ends", "the bar at {} has no length", format_point(s_.heads[i], data_.units().length));
        return false;
      }
    return true;
  }

  void check_resistance() const {
    for (const char* key : {"bond", "bond_adhesion", "bond_friction", "diameter"})
      if (!block_.is_sound(key)) return;
    const bool has_stress = s_.bond_adhesion.value_or(0) > 0 || s_.bond_friction.value_or(0) > 0;
    const bool is_grouted = s_.kind == SupportKind::nail || s_.kind == SupportKind::anchor;
    if (is_grouted && s_.bond && (s_.bond_adhesion || s_.bond_friction))
      return fail("bond", "the bond is given twice; give 'bond', or 'bond_adhesion' and 'bond_friction'");
    if ((is_grouted && !s_.bond && !has_stress) || (s_.kind == SupportKind::geosynthetic && !has_stress))
      return fail("", "it has no resistance to pull-out; give {}'bond_adhesion' or 'bond_friction' above 0",
                  is_grouted ? "'bond', or " : "");
    if (is_grouted && has_stress && !s_.diameter)
      fail("", "adhesion and friction act on the surface of the grout: give its 'diameter'");
    if (s_.bond && block_.is_given("bond_scale")) fail("bond_scale", "'bond_scale' belongs to 'bond_friction'");
  }

  void check_anchor() const {
    if (!block_.is_sound("free_length") || !block_.is_sound("bond_length")) return;
    if (s_.free_length.has_value() == s_.bond_length.has_value())
      return fail(s_.free_length ? "bond_length" : "", "{}; give 'free_length' or 'bond_length'",
                  s_.free_length ? "the bonded part is given twice" : "an anchor is bonded over a part of its length");
  }

  void check_wall() const {
    for (const char* key : {"crossing", "shear_strength", "interface_strength", "bond_adhesion", "bond_friction",
                            "strut_levels", "strut_stiffness", "strut_strength", "strut_prestress"})
      if (!block_.is_sound(key)) return;
    if (s_.crossing == WallCrossing::resisted && !s_.shear_strength)
      fail("crossing", "crossing = \"resisted\" needs the 'shear_strength' of the wall");
    if (s_.interface_strength && (s_.bond_adhesion || s_.bond_friction))
      fail("interface_strength",
           "the interface is given twice; give 'interface_strength', or 'bond_adhesion' and 'bond_friction'");
    if (s_.strut_levels.empty()) {
      for (const char* key : {"strut_stiffness", "strut_strength", "strut_prestress"})
        if (block_.is_given(key)) fail(key, "'{}' needs 'strut_levels'", key);
    } else if (!s_.strut_stiffness || !(s_.strut_strength > 0)) {
      fail("strut_levels", "struts need 'strut_stiffness' and 'strut_strength' above 0");
    } else if (s_.strut_prestress > s_.strut_strength) {
      fail("strut_prestress", "the prestress exceeds 'strut_strength', {:g} kN", s_.strut_strength / 1e3);
    }
  }

  void check_pile() const {
    const bool is_given = s_.lateral_law == LateralLaw::given;
    if (!block_.is_sound("lateral_law") || !block_.is_sound("lateral_resistance")) return;
    if (is_given && !s_.lateral_resistance && !s_.shear_strength)
      fail("", "a pile needs a 'lateral_resistance' or a 'shear_strength', or lateral_law = \"ito_matsui\"");
    if (is_given) return;
    if (s_.lateral_resistance) fail("lateral_resistance", "'lateral_resistance' belongs to lateral_law = \"given\"");
    if (!block_.is_sound("diameter") || !block_.is_sound("out_of_plane_spacing")) return;
    if (!s_.diameter) return fail("", "lateral_law = \"ito_matsui\" needs the 'diameter' of the piles");
    if (*s_.diameter >= s_.out_of_plane_spacing)
      fail("diameter", "the diameter, {}, must be less than the spacing of the axes, {}",
           format_value(*s_.diameter, data_.units().length),
           format_value(s_.out_of_plane_spacing, data_.units().length));
  }

  /// Checks that bars lie in the soil, and free and bonded lengths against theirs.
  void check_places() const {
    mesh::Polyline ground;
    try {
      ground = mesh::find_ground(data_.mesh);
    } catch (const Error&) {
      return;  // the methods that need the ground report its fault
    }
    std::vector<Point> heads = s_.heads;
    if (s_.first) heads.push_back(*s_.first);
    if (!s_.line.empty()) heads.push_back(s_.line.front());
    for (const Point& head : heads)
      if (!check_head(head, ground)) return;
    const BarLayout layout = lay_bars(s_, ground, data_.units().length);
    if (!layout.fault.empty()) return fail(layout.key, "{}", std::string(layout.fault));
    for (const BarLine& bar : layout.bars) {
      if (!check_lengths(bar)) return;
      if (!check_place(bar, ground)) return;
    }
  }

  bool check_lengths(const BarLine& bar) const {
    const double length = bar.length();
    const ShownUnit& unit = data_.units().length;
    const std::optional<double>& part = s_.free_length ? s_.free_length : s_.bond_length;
    if (!part || (s_.free_length ? *part < length : *part <= length * (1 + 1e-9))) return true;
    if (s_.free_length)
      fail("free_length", "the free length, {}, leaves nothing bonded of the anchor in row {}, which is {} long",
           format_value(*part, unit), bar.row, format_value(length, unit));
    else
      fail("bond_length", "the bond length, {}, exceeds the length of the anchor in row {}, {}",
           format_value(*part, unit), bar.row, format_value(length, unit));
    return false;
  }

  bool check_head(const Point& head, const mesh::Polyline& ground) const {
    const ShownUnit& unit = data_.units().length;
    const double near = near_ground * measure_width(ground);
    const std::string head_key = !s_.line.empty() ? "line" : s_.heads.empty() ? "first" : "heads";
    const auto levels = find_levels(ground, head[0]);
    const double off = mesh::compute_distance(head, ground);
    const bool may_be_buried =
        s_.kind == SupportKind::geosynthetic || s_.kind == SupportKind::pile || s_.kind == SupportKind::wall;
    if (!levels || (head[1] > (*levels)[1] && off > near)) {
      fail(head_key, "the head {} lies in the air, {} from the ground", format_point(head, unit),
           format_value(off, unit, 3));
      return false;
    }
    if (off > near && !may_be_buried) {
      fail(head_key, "the head {} lies in the soil, {} below the ground; heads of nails, anchors and bolts lie on it",
           format_point(head, unit), format_value(off, unit, 3));
      return false;
    }
    if (off > near && s_.connection > 0) {
      fail("connection", "the head {} lies in the soil, where nothing connects it: connection = 0",
           format_point(head, unit));
      return false;
    }
    return true;
  }

  bool check_place(const BarLine& bar, const mesh::Polyline& ground) const {
    const ShownUnit& unit = data_.units().length;
    const double near = near_ground * measure_width(ground);
    const double bottom = SoilOutline(data_.mesh).bottom();
    constexpr int places = 50;
    for (int i = 1; i <= places; ++i) {
      const double t = static_cast<double>(i) / places;
      const Point p{bar.head[0] + t * (bar.end[0] - bar.head[0]), bar.head[1] + t * (bar.end[1] - bar.head[1])};
      const auto here = find_levels(ground, p[0]);
      const bool is_in_air = !here || p[1] > (*here)[1] + near, is_below = p[1] < bottom - near;
      if (!is_in_air && !is_below) continue;
      const std::string key = !s_.line.empty()     ? "line"
                              : !s_.ends.empty()   ? "ends"
                              : s_.lengths.empty() ? "length"
                                                   : "lengths";
      const std::string what = s_.kind == SupportKind::wall ? "the wall" : fmt::format("the bar in row {}", bar.row);
      fail(key, "{} from {} to {} leaves the soil at {}, {}", what, format_point(bar.head, unit),
           format_point(bar.end, unit), format_point(p, unit),
           !here      ? "the side of the section"
           : is_below ? "below its bottom"
                      : "above the ground");
      return false;
    }
    return true;
  }

  const Case& data_;
  const std::string& name_;
  const Support& s_;
  BlockFindings block_;
};

}  // namespace

bool has_passive_supports(const Case& data) {
  return std::any_of(data.supports.begin(), data.supports.end(), [](const auto& s) {
    return !s.second.is_active() && (s.second.kind != SupportKind::wall || s.second.shear_strength);
  });
}

std::optional<std::string> find_support_obstacle(const Case& data) {
  for (const auto& [name, support] : data.supports) {
    using K = SupportKind;
    if (support.kind == K::pile || support.kind == K::bolt)
      return fmt::format("support '{}' is a {}, and limit analysis takes nails, anchors, geosynthetics and walls", name,
                         get_word(support.kind));
    if (support.kind == K::wall) continue;
    if (support.find_direction() != SupportDirection::axial)
      return fmt::format("the force of support '{}' is not axial, as that of a bar in limit analysis is", name);
  }
  return std::nullopt;
}

void check_supports(const Case& data, Findings& findings) {
  if (data.supports.empty()) return;
  constexpr std::size_t most = 2000;
  std::size_t bars = 0;
  for (const auto& [name, support] : data.supports)
    bars += std::max({support.heads.size(), support.x.size(), support.line.size(),
                      static_cast<std::size_t>(std::max(1, support.rows))});
  if (bars > most)
    return findings.add("support." + data.supports.begin()->first,
                        "the case has {} bars in [support], and at most {} are read; the forces of bars that lie close "
                        "together can be given as those of one",
                        bars, most);
  for (const auto& [name, support] : data.supports) SupportCheck(data, name, support, findings).run();
  check_support_methods(data, findings);
  warn_of_supports(data, findings);
}

}  // namespace talus::input
