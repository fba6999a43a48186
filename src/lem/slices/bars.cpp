// SPDX-License-Identifier: MIT
// Bars that the base of a mass crosses, and their forces there.

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "lem/section/piles.hpp"
#include "lem/slices/slices.hpp"

namespace talus::lem {

namespace {

/// Crossing of a bar with the border between the mass and the stable soil.
struct Crossing {
  double distance = 0;  ///< from the head [m]
  int slice = 0;
  bool is_crack = false;  ///< at the side of a tension crack
};

/// Returns the parameter t of a + t (b - a) at its crossing with c-d, whose upper end counts if `with_end`; nullopt if
/// they do not cross.
std::optional<double> find_crossing(const Point& a, const Point& b, const Point& c, const Point& d, bool with_end) {
  const double ux = b[0] - a[0], uy = b[1] - a[1], vx = d[0] - c[0], vy = d[1] - c[1];
  const double cross = ux * vy - uy * vx;
  if (cross == 0) return std::nullopt;
  const double wx = c[0] - a[0], wy = c[1] - a[1];
  const double t = (wx * vy - wy * vx) / cross, r = (wx * uy - wy * ux) / cross;
  // A surface through an end of the bar does not cross it.
  constexpr double rounding = 1e-9;
  if (!(t > rounding && t < 1 - rounding && r >= 0 && (r < 1 || (with_end && r <= 1)))) return std::nullopt;
  return t;
}

/// Returns the slice with a tension crack as its upper side; -1 if the mass has none.
int find_cracked_slice(const CutSurface& cut) {
  const Surface& surface = cut.surface;
  const double from = surface.circle ? surface.from : surface.line.front()[0];
  const double to = surface.circle ? surface.to : surface.line.back()[0];
  const double near = 1e-9 * (to - from);
  if (cut.slides_left) return cut.slices.back().right < to - near ? static_cast<int>(cut.slices.size()) - 1 : -1;
  return cut.slices.front().left > from + near ? 0 : -1;
}

std::vector<Crossing> list_crossings(const Bar& bar, const CutSurface& cut) {
  std::vector<Crossing> list;
  const double length = std::hypot(bar.end[0] - bar.head[0], bar.end[1] - bar.head[1]);
  const auto add = [&](const Point& c, const Point& d, bool with_end, int slice, bool is_crack) {
    if (const auto t = find_crossing(bar.head, bar.end, c, d, with_end)) list.push_back({*t * length, slice, is_crack});
  };
  const auto [left, right] = std::minmax(bar.head[0], bar.end[0]);
  for (std::size_t i = 0; i < cut.slices.size(); ++i) {
    const Slice& slice = cut.slices[i];
    if (slice.right < left || slice.left > right) continue;
    add(slice.base_left, slice.base_right, i + 1 == cut.slices.size(), static_cast<int>(i), false);
  }
  if (const int i = find_cracked_slice(cut); i >= 0) {
    const Slice& slice = cut.slices[static_cast<std::size_t>(i)];
    const Point& bottom = cut.slides_left ? slice.base_right : slice.base_left;
    add(bottom, {bottom[0], cut.slides_left ? slice.top_right : slice.top_left}, true, i, true);
  }
  std::sort(list.begin(), list.end(), [](const Crossing& a, const Crossing& b) { return a.distance < b.distance; });
  return list;
}

/// Returns true if a point lies in the mass.
bool is_in_mass(const CutSurface& cut, const Point& p) {
  for (const Slice& slice : cut.slices) {
    if (p[0] < slice.left || p[0] > slice.right) continue;
    const double t = (p[0] - slice.left) / (slice.right - slice.left);
    return p[1] > slice.base_left[1] + t * (slice.base_right[1] - slice.base_left[1]);
  }
  return false;
}

/// Returns the unit vector along the base of a slice in the direction of sliding.
Point find_sliding(const CutSurface& cut, const Slice& slice) {
  const double way = cut.slides_left ? -1 : 1;
  return {way * (slice.base_right[0] - slice.base_left[0]) / slice.length,
          way * (slice.base_right[1] - slice.base_left[1]) / slice.length};
}

/// Returns the direction of the force of a bar that pulls along `axis` on a mass that slides along `sliding`.
Point find_direction(BarDirection direction, const Point& axis, const Point& sliding) {
  switch (direction) {
    case BarDirection::axial:
      return axis;
    case BarDirection::tangent:
      return {-sliding[0], -sliding[1]};
    case BarDirection::normal: {
      const double sign = -axis[1] * sliding[0] + axis[0] * sliding[1] > 0 ? -1 : 1;
      return {-sign * axis[1], sign * axis[0]};
    }
    case BarDirection::bisector:
      break;
  }
  const Point sum{axis[0] - sliding[0], axis[1] - sliding[1]};
  const double length = std::hypot(sum[0], sum[1]);
  return length > 0 ? Point{sum[0] / length, sum[1] / length} : axis;
}

/// Sets resistance and limit of a bar in tension. `part`: resistance of a part of the bar by its bond [N/m].
void set_tension(const Bar& bar, BarPull& pull) {
  pull.resistance = bar.tensile;
  pull.limit = BarLimit::tension;
  if (pull.behind < pull.resistance) pull.resistance = pull.behind, pull.limit = BarLimit::pull_out;
  if (pull.front < pull.resistance) pull.resistance = pull.front, pull.limit = BarLimit::stripping;
  if (bar.is_active) pull.prestress = std::min(bar.prestress, pull.resistance);
}

/// Length of the base over which the soil spreads the force of a bar, over the depth of the mass [-]. It lies above the
/// bar, where a base that bends upwards is steeper and the force holds less: the safe side.
constexpr double spread = 0.02;

/// Adds the parts of the force of a bar on the slices above its crossing, by the lengths of their bases there.
void spread_force(const Bar& bar, const Point& axis, CutSurface& cut) {
  const auto pull = static_cast<int>(cut.pulls.size()) - 1, upwards = cut.slides_left ? 1 : -1;
  const std::size_t first = cut.parts.size();
  const BarPull& own = cut.pulls.back();
  double rest = spread * cut.depth, sum = 0;
  for (int i = own.slice; i >= 0 && i < static_cast<int>(cut.slices.size()) && rest > 0; i += upwards) {
    const Slice& slice = cut.slices[static_cast<std::size_t>(i)];
    const double run = i != own.slice    ? slice.right - slice.left
                       : cut.slides_left ? slice.right - own.at[0]
                                         : own.at[0] - slice.left;
    const double length = std::min(rest, slice.length * run / (slice.right - slice.left));
    rest -= length;
    if (!(length > 0)) continue;
    cut.parts.push_back({pull, i, length, find_direction(bar.direction, axis, find_sliding(cut, slice))});
    sum += length;
  }
  for (std::size_t i = first; i < cut.parts.size(); ++i) cut.parts[i].fraction /= sum;
  if (sum == 0) cut.parts.push_back({pull, own.slice, 1, own.direction});
}

/// Sets the force of a bar across it at `s`, with its end in the mass and the other one in stable soil.
void set_lateral(const Slope& slope, double s, double in_mass, double in_stable, BarPull& pull) {
  const auto number = static_cast<std::size_t>(pull.bar);
  const Bar& bar = slope.section().bars[number];
  const bool is_given = bar.hold == BarHold::across;
  pull.behind = bar.shear;
  if (!bar.is_pile) {
    pull.front = is_given ? bar.lateral : std::abs(slope.strips().bars[number].find_part(s, in_mass));
    pull.resistance = std::min(pull.front, pull.behind);
    pull.limit = pull.behind < pull.front ? BarLimit::shear : BarLimit::lateral;
    return;
  }
  const BarDiagram &embedded = slope.strips().embedded[number],
                   &pressing = is_given ? embedded : slope.strips().bars[number];
  const PileSide mass{&pressing, s, in_mass}, stable{&embedded, s, in_stable};
  const double given = is_given ? bar.lateral : std::numeric_limits<double>::infinity();
  pull.front = std::min(given, mass.compute_strength());
  const PileForce found = compute_pile_force(mass, stable, {bar.moment, bar.shear, given});
  pull.resistance = found.force;
  pull.limit = found.limit;
}

}  // namespace

void cross_bars(const Slope& slope, CutSurface& cut) {
  const std::vector<Bar>& bars = slope.section().bars;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  cut.pulls.clear();
  cut.parts.clear();
  for (std::size_t b = 0; b < bars.size(); ++b) {
    const Bar& bar = bars[b];
    const std::vector<Crossing> crossings = list_crossings(bar, cut);
    if (crossings.empty()) continue;
    const BarDiagram& diagram = slope.strips().bars[b];
    const double length = std::hypot(bar.end[0] - bar.head[0], bar.end[1] - bar.head[1]);
    const Point along{(bar.end[0] - bar.head[0]) / length, (bar.end[1] - bar.head[1]) / length};
    const auto find_point = [&](double s) { return Point{bar.head[0] + s * along[0], bar.head[1] + s * along[1]}; };
    const bool is_across = bar.hold == BarHold::across || bar.hold == BarHold::soil_pressure;
    for (std::size_t k = 0; k < crossings.size(); ++k) {
      const double s = crossings[k].distance, before = k > 0 ? crossings[k - 1].distance : 0,
                   after = k + 1 < crossings.size() ? crossings[k + 1].distance : length;
      const bool is_head_in = is_in_mass(cut, find_point(0.5 * (before + s))),
                 is_end_in = is_in_mass(cut, find_point(0.5 * (s + after)));
      // A bar across an open crack does not count, as in other programs: its force would act above the slip surface.
      if (is_head_in == is_end_in || crossings[k].is_crack) continue;
      const Slice& slice = cut.slices[static_cast<std::size_t>(crossings[k].slice)];
      const Point sliding = find_sliding(cut, slice);
      // The force on the mass points to the part of the bar that is in stable soil.
      const Point axis = is_head_in ? along : Point{-along[0], -along[1]};
      // A bar that holds on to soil ahead of the mass is compressed where it meets the rising part of the base.
      const bool is_ahead = cut.slides_left ? axis[0] < 0 : axis[0] > 0;
      if (!is_across && is_ahead && !(axis[0] * sliding[0] + axis[1] * sliding[1] < 0)) continue;
      BarPull pull{static_cast<int>(b), crossings[k].slice, find_point(s), s, 0, {}, 0, 0, BarLimit::tension};
      pull.direction = find_direction(bar.direction, axis, sliding);
      if (is_across) {
        set_lateral(slope, s, is_head_in ? before : after, is_head_in ? after : before, pull);
      } else {
        const bool has_anchor = bar.hold == BarHold::end_anchor;
        const double head_part = diagram.find_part(before, s) + (k > 0 ? 0 : has_anchor ? infinity : bar.plate);
        const double end_part =
            diagram.find_part(s, after) + (has_anchor && k + 1 == crossings.size() ? infinity : 0.0);
        pull.front = is_head_in ? head_part : end_part;
        pull.behind = is_head_in ? end_part : head_part;
        set_tension(bar, pull);
      }
      if (!(pull.resistance > 0)) continue;
      cut.pulls.push_back(pull);
      spread_force(bar, axis, cut);
    }
  }
}

namespace {

void turn_force(int number, CutSurface& cut) {
  const auto turn = [](Point& direction) { direction = {-direction[0], -direction[1]}; };
  BarPull& pull = cut.pulls[static_cast<std::size_t>(number)];
  turn(pull.direction);
  pull.is_turned = !pull.is_turned;
  for (BarPart& part : cut.parts)
    if (part.pull == number) turn(part.direction);
}

}  // namespace

void tighten_bars(CutSurface& cut) {
  for (std::size_t i = 0; i < cut.pulls.size(); ++i) {
    if (cut.pulls[i].is_turned) turn_force(static_cast<int>(i), cut);
    cut.pulls[i].is_slack = false;
  }
}

bool release_bars(const Slope& slope, CutSurface& cut, double factor) {
  if (!(factor > 0)) return false;
  const double way = cut.slides_left ? -1 : 1;
  bool is_changed = false;
  for (std::size_t i = 0; i < cut.pulls.size(); ++i) {
    BarPull& pull = cut.pulls[i];
    const Bar& bar = slope.section().bars[static_cast<std::size_t>(pull.bar)];
    if (pull.is_slack || pull.is_turned) continue;
    double power = 0;
    for (const BarPart& part : cut.parts) {
      if (part.pull != static_cast<int>(i)) continue;
      // The velocity (cos(α - φ_F), sin(α - φ_F)) in the direction of sliding and downwards, over cos α cos φ_F.
      const Slice& slice = cut.slices[static_cast<std::size_t>(part.slice)];
      const double dilation = slice.tan_friction / factor;
      const double run = 1 + dilation * slice.slope, fall = slice.slope - dilation;
      power += part.fraction * (way * run * part.direction[0] - fall * part.direction[1]);
    }
    if (!(power > 0)) continue;
    is_changed = true;
    if (bar.direction == BarDirection::normal)
      turn_force(static_cast<int>(i), cut);
    else
      pull.is_slack = true;
  }
  return is_changed;
}

}  // namespace talus::lem
