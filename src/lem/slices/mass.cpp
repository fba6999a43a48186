// SPDX-License-Identifier: MIT
// Base, slices, direction of sliding and tension crack of a mass over a slip surface, and its equations in a frame
// along the sliding.
#include "lem/slices/mass.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "lem/slices/slices.hpp"
#include "lem/surface/base_line.hpp"

namespace talus::lem {

void Mass::set(const Slope& slope, const CutSurface& cut, double horizontal) {
  const double vertical = 1 + slope.section().vertical_acceleration;
  const double way = cut.slides_left ? -1 : 1, xo = way * cut.moment_centre[0], yo = cut.moment_centre[1];
  const auto size = cut.slices.size();
  wedges.resize(size);
  radius = cut.radius;
  crack = cut.crack_thrust;
  moment = crack > 0 ? crack * (yo - cut.crack_thrust_level) : 0;
  scale = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const Slice& slice = cut.slices[cut.slides_left ? size - 1 - i : i];
    Wedge& wedge = wedges[i];
    const double fall = way * (slice.base_left[1] - slice.base_right[1]);
    wedge.sine = fall / slice.length;
    wedge.cosine = (slice.right - slice.left) / slice.length;
    wedge.friction = slice.tan_friction;
    wedge.uplift = std::max(0.0, slice.pore_pressure) * slice.length;
    wedge.strength = slice.cohesion * slice.length - wedge.uplift * slice.tan_friction;
    const double weight = vertical * slice.weight, earthquake = horizontal * slice.weight;
    wedge.down = weight + slice.surface_load;
    wedge.push = earthquake - slice.surface_thrust;
    const double x = way * 0.5 * (slice.left + slice.right), y = 0.5 * (slice.base_left[1] + slice.base_right[1]);
    wedge.arm_shear = (yo - y) * wedge.cosine - (x - xo) * wedge.sine;
    wedge.arm_normal = (x - xo) * wedge.cosine + (yo - y) * wedge.sine;
    moment += (xo - x) * wedge.down + (yo - slice.centroid) * earthquake - (yo - y) * slice.surface_thrust -
              way * slice.surface_moment;
    scale += wedge.down;
  }
  held.clear();
  held_moment = 0;
  if (!cut.pulls.empty()) add_bars(slope, cut);
}

void Mass::add_bars(const Slope& slope, const CutSurface& cut) {
  const double way = cut.slides_left ? -1 : 1;
  for (const BarPart& part : cut.parts) {
    const BarPull& pull = cut.pulls[static_cast<std::size_t>(part.pull)];
    const double force = part.fraction * pull.force();
    if (force == 0) continue;
    const double down = -force * part.direction[1], push = way * force * part.direction[0];
    const double about = way * (cut.moment_centre[0] - pull.at[0]) * down + (cut.moment_centre[1] - pull.at[1]) * push;
    const auto slice = static_cast<std::size_t>(part.slice);
    const std::size_t i = cut.slides_left ? wedges.size() - 1 - slice : slice;
    if (slope.section().bars[static_cast<std::size_t>(pull.bar)].is_active) {
      wedges[i].down += down;
      wedges[i].push += push;
      moment += about;
      continue;
    }
    if (held.empty()) held.resize(wedges.size());
    held[i].down += down;
    held[i].push += push;
    held_moment += about;
  }
}

void Mass::set_interslice_function(bool half_sine, const CutSurface& cut) {
  const double left = cut.slices.front().left, span = cut.slices.back().right - left;
  const auto size = wedges.size();
  for (std::size_t i = 0; i < size; ++i) {
    const double x = cut.slides_left ? cut.slices[size - 1 - i].left : cut.slices[i].right;
    wedges[i].ratio = half_sine ? std::sin(std::numbers::pi * std::clamp((x - left) / span, 0.0, 1.0)) : 1;
  }
}

namespace {

/// Returns the slope of the ground over a slice, positive where it falls in the direction of sliding.
double find_ground_slope(const CutSurface& cut, const Slice& slice) {
  const double way = cut.slides_left ? 1 : -1;
  return way * (slice.top_right - slice.top_left) / (slice.right - slice.left);
}

/// Returns the slope of the line from the lower end of the mass to the upper one, on the ground.
double find_chord_slope(const CutSurface& cut) {
  const Slice &first = cut.slices.front(), &last = cut.slices.back();
  const double way = cut.slides_left ? 1 : -1;
  return way * (last.top_right - first.top_left) / (last.right - first.left);
}

/// Returns the slope of the line from the lower end to the crest, the first point of the ground at its highest level.
double find_face_slope(const CutSurface& cut) {
  const auto size = cut.slices.size();
  const Slice& toe = cut.slides_left ? cut.slices.front() : cut.slices.back();
  const double x = cut.slides_left ? toe.left : toe.right, y = cut.slides_left ? toe.top_left : toe.top_right;
  double highest = y, at = x;
  for (std::size_t i = 0; i < size; ++i) {
    const Slice& slice = cut.slices[cut.slides_left ? i : size - 1 - i];
    const double level = cut.slides_left ? slice.top_right : slice.top_left;
    if (level <= highest + 1e-9 * std::abs(highest - y)) continue;
    highest = level;
    at = cut.slides_left ? slice.right : slice.left;
  }
  return at == x ? 0 : (highest - y) / std::abs(at - x);
}

}  // namespace

void Mass::set_inclinations(SliceMethod method, const CutSurface& cut) {
  const auto size = wedges.size();
  const double constant = method == SliceMethod::corps_1            ? find_chord_slope(cut)
                          : method == SliceMethod::modified_swedish ? find_face_slope(cut)
                                                                    : 0;
  for (std::size_t i = 0; i < size; ++i) {
    wedges[i].ratio = constant;
    if (method != SliceMethod::corps_2 && method != SliceMethod::lowe_karafiath) continue;
    // The side towards the lower end, between this slice and the next; no force acts on the last side.
    const auto number = [&](std::size_t k) { return cut.slides_left ? size - 1 - k : k; };
    const Slice &here = cut.slices[number(i)], &below = cut.slices[number(std::min(i + 1, size - 1))];
    const double ground = 0.5 * (std::atan(find_ground_slope(cut, here)) + std::atan(find_ground_slope(cut, below)));
    const double base = 0.5 * (here.alpha() + below.alpha());
    wedges[i].ratio = std::tan(method == SliceMethod::corps_2 ? ground : 0.5 * (ground + base));
  }
}

// Cuts the sliding mass over a surface: base, slices, direction of sliding, tension crack.

namespace {

/// Sets centre and radius for moments: of the circle, or of one through the ends of the polyline and near its vertices.
void set_moment_centre(const Surface& surface, CutSurface& cut) {
  if (surface.circle) {
    cut.moment_centre = surface.circle->centre;
    cut.radius = surface.circle->radius;
    return;
  }
  // Circle through both ends. The height h of its centre over the middle of the chord is fitted to the middles of the
  // bases by least squares: t² + n² - 2 n h = (L/2)² along and normal to the chord.
  const Point &a = surface.line.front(), &b = surface.line.back();
  const double length = std::hypot(b[0] - a[0], b[1] - a[1]), half = 0.5 * length;
  const Point along{(b[0] - a[0]) / length, (b[1] - a[1]) / length}, middle{0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])};
  double top = 0, bottom = 0;
  for (const Slice& slice : cut.slices) {
    const double dx = 0.5 * (slice.left + slice.right) - middle[0];
    const double dy = 0.5 * (slice.base_left[1] + slice.base_right[1]) - middle[1];
    const double t = dx * along[0] + dy * along[1], n = -dx * along[1] + dy * along[0];
    top += n * (t * t + n * n - half * half) * slice.length;
    bottom += 2 * n * n * slice.length;
  }
  // A nearly straight surface has its centre far above it.
  const double h = bottom > 0 ? std::clamp(top / bottom, 0.0, 1000 * length) : 1000 * length;
  cut.moment_centre = {middle[0] - h * along[1], middle[1] + h * along[0]};
  cut.radius = std::hypot(half, h);
}

/// Returns the horizontal component of weights and loads along the base, positive to the left; its sign is the
/// direction of sliding.
double sum_push(const CutSurface& cut) {
  double push = 0;
  for (const Slice& slice : cut.slices)
    push +=
        (slice.weight + slice.surface_load) * (slice.base_right[1] - slice.base_left[1]) / (slice.right - slice.left) -
        slice.surface_thrust;
  return push;
}

void turn_slices(std::vector<Slice>& slices) {
  for (Slice& slice : slices) {
    slice.slope = -slice.slope;
    slice.surface_thrust = -slice.surface_thrust;
  }
}

/// Returns x where the base is as deep as the crack, whose depth is `depth_at` of x, searched from the upper end; none
/// if there is no such place.
std::optional<double> find_crack(const BaseLine& base, const CutSurface& cut, const auto& depth_at, double& bottom) {
  const auto size = cut.slices.size();
  for (std::size_t i = 0; i < size; ++i) {
    const Slice& slice = cut.slices[cut.slides_left ? size - 1 - i : i];
    const double near = cut.slides_left ? slice.top_right - slice.base_right[1] : slice.top_left - slice.base_left[1];
    const double far = cut.slides_left ? slice.top_left - slice.base_left[1] : slice.top_right - slice.base_right[1];
    double a = cut.slides_left ? slice.right : slice.left, b = cut.slides_left ? slice.left : slice.right;
    if (far < depth_at(b)) continue;
    if (near >= depth_at(a)) b = a;
    for (int k = 0; k < 60 && a != b; ++k) {
      const double x = 0.5 * (a + b), t = (x - slice.left) / (slice.right - slice.left);
      const double ground = slice.top_left + t * (slice.top_right - slice.top_left);
      (ground - base.at(x) < depth_at(x) ? a : b) = x;
    }
    bottom = base.at(b);
    return b;
  }
  return std::nullopt;
}

void warn(const Slope& slope, CutSurface& cut) {
  bool lifted = true;
  for (const Slice& slice : cut.slices)
    lifted = lifted && slice.pore_pressure * (slice.right - slice.left) > slice.weight + slice.surface_load;
  if (lifted) cut.warnings.push_back("the pore pressure exceeds the weight of the soil everywhere on the base");
  if (!cut.surface.circle) return;
  // Beyond its lower end the circle continues below the ground if it falls outwards more steeply.
  const auto& [xc, yc] = cut.surface.circle->centre;
  const Point toe = cut.slides_left ? cut.slices.front().base_left : cut.slices.back().base_right;
  const double outwards = cut.slides_left ? -1 : 1, step = 1e-3 * cut.radius;
  const double x = toe[0] + outwards * step;
  if (x < slope.left() || x > slope.right() || std::abs(x - xc) >= cut.radius) return;
  const double arc = yc - std::sqrt(cut.radius * cut.radius - (x - xc) * (x - xc));
  cut.cut_at_toe = arc < slope.ground(x) - 1e-3 * step;
  if (cut.cut_at_toe)
    cut.warnings.push_back("the arc is cut at its lower end: the circle would continue below the ground");
}

/// Makes the slices over the base, with the loads on vertical steps of the ground.
void slice_mass(const Slope& slope, const BaseLine& base, int count, CrackEnd crack, CutSurface& cut) {
  fill_slices(slope.strips(), base, count, cut);
  press_on_faces(slope.strips(), cut.slices, crack);
  if (slope.before() != nullptr) press_on_faces(slope.before()->strips(), cut.before, crack);
}

/// Position of a vertical crack at the upper end of a mass.
struct CrackPlace {
  double x = 0, bottom = 0, water = 0;  ///< x, elevation of the bottom, height of the water [m]
};

/// Returns the position of the crack; nothing if no mass would remain.
std::optional<CrackPlace> place_crack(const BaseLine& base, const CutSurface& cut, const auto& depth_at, double water) {
  const double from = cut.slices.front().left, to = cut.slices.back().right;
  CrackPlace crack;
  const auto x = find_crack(base, cut, depth_at, crack.bottom);
  const double kept = x ? (cut.slides_left ? *x - from : to - *x) : 0;
  if (kept < 1e-3 * (to - from)) return std::nullopt;
  crack.x = *x;
  crack.water = std::min(water, depth_at(*x));
  return crack;
}

/// Returns the cracks of which the weakest counts; empty: no mass would remain. With a limit any depth up to it may be:
/// the soil with its strength divided by F is in tension less deep than the limit, which is that of the strength as it
/// is, and the limit reduces the thrust of water.
std::vector<std::optional<CrackPlace>> list_cracks(const Slope& slope, const Surface& surface, const BaseLine& base,
                                                   const CutSurface& cut) {
  const TensionCrack crack =
      surface.crack > 0 ? TensionCrack{surface.crack, 0} : slope.section().crack.value_or(TensionCrack{});
  std::vector<std::optional<CrackPlace>> cracks;
  const auto add = [&](const auto& depth_at) {
    if (const auto place = place_crack(base, cut, depth_at, crack.water)) cracks.emplace_back(place);
  };
  if (surface.crack > 0 || !crack.limited) {
    add([&](double at) { return surface.crack > 0 ? surface.crack : slope.crack_depth(at); });
    return cracks;
  }
  for (const double share : {1.0, 0.5, 0.25}) add([&](double at) { return share * slope.crack_depth(at); });
  if (crack.water > 0) add([&](double) { return crack.depth; });
  cracks.emplace_back(std::nullopt);
  return cracks;
}

/// Slices the mass as `crack` cuts it off, if there is one.
void slice_cracked_mass(const Slope& slope, BaseLine& base, int count, const std::optional<CrackPlace>& crack,
                        const std::array<double, 2>& ends, CutSurface& cut) {
  const bool slides_left = cut.slides_left;
  base.divide(slope, crack && !slides_left ? crack->x : ends[0], crack && slides_left ? crack->x : ends[1]);
  slice_mass(slope, base, count, !crack ? CrackEnd::none : slides_left ? CrackEnd::right : CrackEnd::left, cut);
  cut.crack_thrust = crack ? 0.5 * slope.section().water_unit_weight * crack->water * crack->water : 0;
  cut.crack_thrust_level = crack ? crack->bottom + crack->water / 3 : 0;
}

/// Completes the slices.
void finish_mass(const Slope& slope, CutSurface& cut) {
  set_moment_centre(cut.surface, cut);
  for (Slice& slice : cut.slices) slice.earthquake = slope.section().turn_to_sliding(slice.earthquake, cut.slides_left);
  if (!cut.slides_left) {
    turn_slices(cut.slices);
    turn_slices(cut.before);
  }
  if (!slope.section().bars.empty()) cross_bars(slope, cut);
  if (slope.before() != nullptr && slope.before()->strips().laws)
    set_law_strengths(slope.before()->strips(), cut.before, false, {});
  if (slope.strips().laws) set_law_strengths(slope.strips(), cut.slices, false, cut.before);
}

/// Returns Janbu's simplified factor, by which two crack depths on one surface are compared; infinity if there is none.
double find_janbu(const Slope& slope, const CutSurface& cut) {
  static thread_local Mass mass;
  const Section& section = slope.section();
  mass.set(slope, cut, section.turn_to_sliding(section.horizontal_acceleration, cut.slides_left));
  int iterations = 0;
  const double factor = solve_simplified(mass, false, 1, iterations);
  return factor > 0 ? factor : std::numeric_limits<double>::infinity();
}

/// Checks a mass against what a user asked for; the crack at its upper end is part of the slip surface.
Refusal check_limits(const CutSurface& cut, bool has_crack, const SurfaceLimits& limits) {
  if (limits.direction != 0 && cut.slides_left != (limits.direction < 0)) return Refusal::direction;
  if (cut.area < limits.smallest_area) return Refusal::too_small;
  if (limits.smallest_weight > 0) {
    double weight = 0;
    for (const Slice& slice : cut.slices) weight += slice.weight;
    if (weight < limits.smallest_weight) return Refusal::too_small;
  }
  std::array<Point, 2> crack{};
  if (has_crack) {
    const Slice &left = cut.slices.front(), &right = cut.slices.back();
    crack = cut.slides_left ? std::array{right.base_right, Point{right.right, right.top_right}}
                            : std::array{left.base_left, Point{left.left, left.top_left}};
  }
  for (const std::vector<Point>& polygon : limits.excluded) {
    if (has_crack && enters_polygon(polygon, crack[0], crack[1])) return Refusal::excluded;
    for (const Slice& slice : cut.slices)
      if (enters_polygon(polygon, slice.base_left, slice.base_right)) return Refusal::excluded;
  }
  const auto meets = [&](const Window& window) {
    return (has_crack && meets_window(window, crack[0], crack[1])) ||
           std::any_of(cut.slices.begin(), cut.slices.end(),
                       [&](const Slice& s) { return meets_window(window, s.base_left, s.base_right); });
  };
  return std::all_of(limits.passages.begin(), limits.passages.end(), meets) ? Refusal::none : Refusal::passage;
}

Refusal cut_mass(const Slope& slope, const Surface& surface, int count, const Checks& checks, CutSurface& cut) {
  static thread_local BaseLine base;
  const auto& strips = slope.strips();
  const double from = surface.circle ? surface.from : surface.line.empty() ? 0 : surface.line.front()[0];
  const double to = surface.circle ? surface.to : surface.line.empty() ? 0 : surface.line.back()[0];
  const double hair = 1e-6 * (to - from);
  if (!(to > from) || from < slope.left() - hair || to > slope.right() + hair) return Refusal::outside;
  if (const Refusal refusal = base.lay(slope, surface, checks.composite); refusal != Refusal::none) return refusal;
  const double near = ground_tolerance * (to - from);
  if (!base.ends_on_ground(strips, base.pieces.front(), from, near) ||
      !base.ends_on_ground(strips, base.pieces.back(), to, near))
    return Refusal::outside;
  if (const Refusal refusal = base.divide(slope, from, to); refusal != Refusal::none) return refusal;
  cut.composite = base.composite;
  slice_mass(slope, base, count, CrackEnd::none, cut);
  if (cut.depth < checks.smallest_depth || !(cut.area > 0)) return Refusal::too_shallow;
  cut.slides_left = sum_push(cut) >= 0;
  bool has_crack = false;
  if (surface.crack > 0 || (slope.section().crack && slope.section().crack->depth > 0)) {
    const auto cracks = list_cracks(slope, surface, base, cut);
    if (cracks.empty()) return Refusal::too_shallow;
    std::size_t weakest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < cracks.size() && cracks.size() > 1; ++i) {
      slice_cracked_mass(slope, base, count, cracks[i], {from, to}, cut);
      finish_mass(slope, cut);
      if (const double factor = find_janbu(slope, cut); factor < least) least = factor, weakest = i;
    }
    slice_cracked_mass(slope, base, count, cracks[weakest], {from, to}, cut);
    has_crack = cracks[weakest].has_value();
  }
  finish_mass(slope, cut);
  if (checks.limits)
    if (const Refusal refusal = check_limits(cut, has_crack, *checks.limits); refusal != Refusal::none) return refusal;
  keep_drained_strengths(cut);
  warn(slope, cut);
  return Refusal::none;
}

}  // namespace

void cut_surface(const Slope& slope, const Surface& surface, int count, const Checks& checks, CutSurface& cut) {
  cut.surface = surface;
  cut.warnings.clear();
  cut.composite = cut.cut_at_toe = false;
  cut.crack_thrust = cut.crack_thrust_level = 0;
  cut.pulls.clear();
  cut.parts.clear();
  cut.refusal = cut_mass(slope, surface, count, checks, cut);
  if (cut.refusal != Refusal::none) {
    cut.slices.clear();
    cut.before.clear();
  }
}

CutSurface cut_surface(const Slope& slope, const Surface& surface, int count, const Checks& checks) {
  CutSurface cut;
  cut_surface(slope, surface, count, checks, cut);
  return cut;
}

}  // namespace talus::lem
