// SPDX-License-Identifier: MIT
// Checks of [support.NAME]: patterns, resistances and places.
#include "input/case/support.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "input/case/case.hpp"
#include "input/case/checks.hpp"
#include "input/case/support_places.hpp"
#include "input/case/support_warnings.hpp"
#include "mesh/ground.hpp"
#include "mesh/planar.hpp"

namespace talus::input {

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
    for (std::size_t i = 0; i + 1 < s_.line.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (const auto at = find_meeting(j, i)) {
          fail("line", "'line' meets itself at {}; a wall goes from its head to its toe without crossing or returning",
               format_point(*at, data_.units().length));
          return false;
        }
    return true;
  }

  /// Returns a place at which two pieces of the line meet, of neighbours beside their common point.
  std::optional<PlanePoint> find_meeting(std::size_t first, std::size_t second) const {
    const PlanePoint &a = s_.line[first], &b = s_.line[first + 1], &c = s_.line[second], &d = s_.line[second + 1];
    const double slack = 1e-9 * (std::hypot(b[0] - a[0], b[1] - a[1]) + std::hypot(d[0] - c[0], d[1] - c[1]));
    if (mesh::compute_distance(d, a, b) <= slack) return d;
    if (second == first + 1) return mesh::compute_distance(a, c, d) <= slack ? std::optional(a) : std::nullopt;
    for (const PlanePoint* p : {&a, &b})
      if (mesh::compute_distance(*p, c, d) <= slack) return *p;
    if (mesh::compute_distance(c, a, b) <= slack) return c;
    return do_cross({a, b}, {c, d}) ? std::optional(c) : std::nullopt;
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
      ground = find_placing_ground(data_, name_);
    } catch (const Error&) {
      return;  // the methods that need the ground report its fault
    }
    std::vector<PlanePoint> heads = s_.heads;
    if (s_.first) heads.push_back(*s_.first);
    if (!s_.line.empty()) heads.push_back(s_.line.front());
    for (const PlanePoint& head : heads)
      if (!check_head(head, ground)) return;
    const BarLayout layout = lay_bars(s_, ground, data_.units().length);
    if (!layout.fault.empty()) return fail(layout.key, "{}", std::string(layout.fault));
    for (const BarLine& bar : layout.bars) {
      if (!check_lengths(bar)) return;
      if (!check_place(bar, ground)) return;
    }
    check_later_stages(layout);
    for (std::size_t i = 0; i < s_.strut_levels.size(); ++i)
      if (!check_strut(layout, i)) return;
  }

  /// Checks that a strut stands on a side of the wall without soil, in the stage that adds it.
  bool check_strut(const BarLayout& layout, std::size_t i) const {
    for (const char* key : {"strut_levels", "strut_stiffness", "strut_strength", "strut_prestress"})
      if (!block_.is_sound(key)) return false;
    const double level = s_.strut_levels[i];
    const auto stage = std::max(find_placing_stage(data_, name_), find_placing_stage(data_, name_strut(name_, i)));
    const auto ground = data_.construction.empty() ? mesh::find_ground(data_.mesh) : find_stage_ground(data_, stage);
    if (!ground) return true;
    const double beside = 1e-6 * measure_width(*ground);
    bool is_on_wall = false;
    for (const BarLine& piece : layout.bars) {
      const double rise = piece.end[1] - piece.head[1], t = rise != 0 ? (level - piece.head[1]) / rise : -1;
      if (!(t >= 0 && t <= 1)) continue;
      is_on_wall = true;
      const double x = piece.head[0] + t * (piece.end[0] - piece.head[0]);
      for (const double side : {-beside, beside}) {
        const auto levels = find_levels(*ground, x + side);
        if (!levels || (*levels)[0] <= level + beside) return true;
      }
    }
    const std::string where = stage ? fmt::format(" in stage '{}'", data_.construction[*stage].name)
                              : data_.construction.empty() ? ""
                                                           : " at the start";
    fail("strut_levels", "the strut at y = {} {}{}{}", format_coordinate(level, data_.units().length),
         is_on_wall ? "has soil on both sides of the wall" : "is above or below the wall", where,
         is_on_wall && !data_.construction.empty()
             ? fmt::format("; let the stage that exposes it add \"{}\"", name_strut(name_, i))
             : "");
    return false;
  }

  /// Names the ground on which the support is placed.
  std::string name_ground() const {
    if (data_.construction.empty()) return "the ground";
    const auto stage = find_placing_stage(data_, name_);
    return stage ? fmt::format("the ground of stage '{}'", data_.construction[*stage].name) : "the ground at the start";
  }

  /// Checks that no stage takes the soil around a support and leaves the support in the air.
  void check_later_stages(const BarLayout& layout) const {
    for (std::size_t k = 0; k < data_.construction.size(); ++k) {
      if (data_.construction[k].remove.empty() || !is_there(data_, name_, k)) continue;
      const auto ground = find_stage_ground(data_, k);
      if (!ground) continue;
      const double near = near_ground * measure_width(*ground);
      for (const BarLine& bar : layout.bars)
        for (int i = 0; i <= places_of_bar; ++i) {
          const PlanePoint p = find_point(bar, i);
          const auto levels = find_levels(*ground, p[0]);
          if (levels && p[1] <= (*levels)[1] + near) continue;
          return fail("",
                      "stage '{}' removes the soil at {}, where row {} of the support is: it must 'remove' the "
                      "support as well",
                      data_.construction[k].name, format_point(p, data_.units().length), bar.row);
        }
    }
  }

  static constexpr int places_of_bar = 50;
  /// Returns a point of a bar, the head for 0 and the end for `places_of_bar`.
  static PlanePoint find_point(const BarLine& bar, int i) {
    const double t = static_cast<double>(i) / places_of_bar;
    return {bar.head[0] + t * (bar.end[0] - bar.head[0]), bar.head[1] + t * (bar.end[1] - bar.head[1])};
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

  bool check_head(const PlanePoint& head, const mesh::Polyline& ground) const {
    const ShownUnit& unit = data_.units().length;
    const double near = near_ground * measure_width(ground);
    const std::string head_key = !s_.line.empty() ? "line" : s_.heads.empty() ? "first" : "heads";
    const auto levels = find_levels(ground, head[0]);
    const double off = mesh::compute_distance(head, ground);
    const bool may_be_buried =
        s_.kind == SupportKind::geosynthetic || s_.kind == SupportKind::pile || s_.kind == SupportKind::wall;
    if (!levels || (head[1] > (*levels)[1] && off > near)) {
      fail(head_key, "the head {} lies in the air, {} from {}", format_point(head, unit), format_value(off, unit, 3),
           name_ground());
      return false;
    }
    if (off > near && !may_be_buried) {
      fail(head_key, "the head {} lies in the soil, {} below {}; heads of nails, anchors and bolts lie on it",
           format_point(head, unit), format_value(off, unit, 3), name_ground());
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
    for (int i = 1; i <= places_of_bar; ++i) {
      const PlanePoint p = find_point(bar, i);
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
