// SPDX-License-Identifier: MIT
#include "lem/surface/base_line.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace talus::lem {

namespace {

/// A face of the base that rises against the sliding more steeply than this holds the mass like a vertical step [-].
constexpr double steepest_rise = 1;
/// Falls of the ramps from the upper edge of a step: where the base falls with the sliding the active plane of φ = 30°,
/// tan 60°; where it rises against it, tan 20°, flatter than any passive plane, where the normal force is reliable [-].
constexpr double active_ramp = 1.732050807568877, passive_ramp = 0.363970234266202;

/// Adds the x between a and b at which the piece meets a straight line of the strip. The arc is convex, so that it
/// meets a line at most twice.
void add_meets(const BaseLine& base, const BasePiece& piece, const Strip& strip, const StripLine& line, double a,
               double b, std::vector<double>& meets) {
  const double above_a = base.at(piece, a) - line.at(a - strip.left),
               above_b = base.at(piece, b) - line.at(b - strip.left);
  if (!piece.arc) {
    if (above_a * above_b < 0) meets.push_back(a + (b - a) * above_a / (above_a - above_b));
    return;
  }
  if (above_a <= 0 && above_b <= 0) return;
  const auto& [xc, yc] = base.circle.centre;
  const double s = line.slope, h = yc - line.at(xc - strip.left), q = 1 + s * s;
  const double root = base.circle.radius * base.circle.radius * q - h * h;
  if (root <= 0) return;
  for (const double sign : {-1.0, 1.0}) {
    const double x = xc + (s * h + sign * std::sqrt(root)) / q;
    if (x > a && x < b) meets.push_back(x);
  }
}

bool is_impenetrable(const Section& section, int soil) {
  return std::find(section.impenetrable.begin(), section.impenetrable.end(), soil) != section.impenetrable.end();
}

}  // namespace

double BaseLine::at(const BasePiece& piece, double x) const {
  if (!piece.arc) return piece.line.at(x - piece.from);
  const double d = x - circle.centre[0];
  return circle.centre[1] - std::sqrt(std::max(0.0, (circle.radius + d) * (circle.radius - d)));
}

double BaseLine::at(double x) const {
  for (const BasePiece& piece : pieces)
    if (x <= piece.to) return at(piece, x);
  return at(pieces.back(), x);
}

bool BaseLine::passes(const BasePiece& piece, const Point& p, double tolerance) const {
  if (std::abs(at(piece, p[0]) - p[1]) <= tolerance) return true;
  const double dx = p[0] - circle.centre[0], dy = p[1] - circle.centre[1];
  return piece.arc && dy <= tolerance && std::abs(std::sqrt(dx * dx + dy * dy) - circle.radius) <= tolerance;
}

bool BaseLine::ends_on_ground(const Slope::Strips& strips, const BasePiece& piece, double x, double tolerance) const {
  const int i = strips.find(x);
  const Strip& strip = strips.strip(i);
  double low = strip.ground.at(x - strip.left), high = low;
  const auto widen = [&](const Strip& other) {
    const double ground = other.ground.at(x - other.left);
    low = std::min(low, ground);
    high = std::max(high, ground);
  };
  if (i > 0 && x - strip.left <= tolerance) widen(strips.strip(i - 1));
  if (i + 1 < static_cast<int>(strips.strips.size()) && strip.right - x <= tolerance) widen(strips.strip(i + 1));
  const double y = at(piece, x);
  return (y >= low && y <= high) || passes(piece, {x, low}, tolerance) || passes(piece, {x, high}, tolerance);
}

Refusal BaseLine::lay(const Slope& slope, const Surface& surface, bool may_cut) {
  pieces.clear();
  composite = false;
  if (!surface.circle) return lay_polyline(slope, surface, may_cut);
  const double bottom = slope.section().base;
  circle = *surface.circle;
  const double from = surface.from, to = surface.to, span = to - from, hair = 1e-6 * span;
  const auto& [xc, yc] = circle.centre;
  if (!(span > 0) || from < xc - circle.radius - hair || to > xc + circle.radius + hair) return Refusal::outside;
  const double over = yc - bottom;  // height of the centre over the base
  const double half = std::sqrt(std::max(0.0, (circle.radius - over) * (circle.radius + over)));
  const double a = std::max(from, xc - half), b = std::min(to, xc + half);
  if (over < 0 || (circle.radius > over && a < b && circle.radius - over > hair)) {
    if (!(may_cut || slope.strips().firm) || over < 0) return Refusal::below_base;
    composite = true;
    if (a > from) pieces.push_back({from, a, true, {}});
    pieces.push_back({a, b, false, {bottom, 0}});
    if (b < to) pieces.push_back({b, to, true, {}});
  } else {
    pieces.push_back({from, to, true, {}});
  }
  return clip(slope.strips(), surface, may_cut);
}

Refusal BaseLine::lay_polyline(const Slope& slope, const Surface& surface, bool may_cut) {
  if (surface.line.size() < 2) return Refusal::outside;
  const auto& strips = slope.strips();
  const double nearest = 1e-6 * (surface.line.back()[0] - surface.line.front()[0]);
  const auto find_bottom = [&](double x) {
    const Strip& strip = strips.strip(strips.find(x));
    return may_cut && strip.is_raised ? strip.floor.at(x - strip.left) : slope.section().base;
  };
  for (std::size_t i = 0; i < surface.line.size(); ++i) {
    const Point& p = surface.line[i];
    if (p[1] < std::min(find_bottom(p[0] - nearest), find_bottom(p[0] + nearest)) - nearest) return Refusal::below_base;
    if (i == 0) continue;
    const Point& last = surface.line[i - 1];
    if (!(p[0] > last[0])) return Refusal::outside;
    pieces.push_back({last[0], p[0], false, {last[1], (p[1] - last[1]) / (p[0] - last[0])}});
  }
  return clip(strips, surface, may_cut);
}

Refusal BaseLine::clip(const Slope::Strips& strips, const Surface& surface, bool may_cut) {
  if (!strips.firm && !(strips.raised && may_cut)) return Refusal::none;
  const std::vector<BasePiece> whole = std::move(pieces);
  pieces.clear();
  const double span = whole.back().to - whole.front().from, hair = 1e-10 * span, step = 1e-6 * span;
  bool has_step = false;
  for (const BasePiece& piece : whole) {
    const bool is_cut_at_base = surface.circle && !piece.arc && whole.size() > 1;
    for (int s = strips.find(piece.from); s < static_cast<int>(strips.strips.size()); ++s) {
      const Strip& strip = strips.strip(s);
      const bool has_floor = strip.is_firm || (may_cut && strip.is_raised);
      double a = std::max(piece.from, strip.left);
      const double end = std::min(piece.to, strip.right);
      if (end - a <= hair && a > piece.from) break;
      meets.clear();
      if (has_floor) add_meets(*this, piece, strip, strip.floor, a, end, meets);
      meets.push_back(end);
      std::sort(meets.begin(), meets.end());
      for (const double b : meets) {
        if (b - a <= hair) continue;
        const double middle = 0.5 * (a + b) - strip.left;
        const bool follows = has_floor && at(piece, 0.5 * (a + b)) < strip.floor.at(middle);
        BasePiece part = piece;
        part.from = a;
        part.to = b;
        if (!piece.arc) part.line.y = piece.line.at(a - piece.from);
        if (follows) part = {a, b, false, {strip.floor.at(a - strip.left), strip.floor.slope}, true};
        composite = composite || follows;
        if (is_cut_at_base && !follows && !may_cut) return Refusal::below_base;
        if (!pieces.empty() && std::abs(at(pieces.back(), a) - at(part, a)) > step) has_step = true;
        has_step = has_step || (follows && std::abs(part.line.slope) > steepest_rise);
        if (!pieces.empty() && piece.arc && !follows && pieces.back().arc)
          pieces.back().to = b;
        else
          pieces.push_back(part);
        a = b;
      }
      if (strip.right >= piece.to) break;
    }
  }
  if (pieces.empty()) return Refusal::outside;
  pieces.front().from = whole.front().from;
  pieces.back().to = whole.back().to;
  return has_step ? bridge_steps(surface, step) : Refusal::none;
}

namespace {

/// Returns dy/dx of a surface that was not cut.
double find_rise(const Surface& surface, double x) {
  constexpr double steepest = 1e3;
  if (surface.circle) {
    const double d = x - surface.circle->centre[0], r = surface.circle->radius;
    const double height = std::sqrt(std::max(0.0, (r - d) * (r + d)));
    return height * steepest > std::abs(d) ? d / height : std::copysign(steepest, d);
  }
  const auto& line = surface.line;
  std::size_t i = 1;
  while (i + 1 < line.size() && line[i][0] <= x) ++i;
  return (line[i][1] - line[i - 1][1]) / (line[i][0] - line[i - 1][0]);
}

/// The upper edge of a step, from which a ramp falls towards larger (1) or smaller x (-1).
struct StepEdge {
  Point at{};
  int way = 0;
};

/// Returns the first step of a base; none if it has no more. `sliding`: the direction in which the mass slides, -1, 1
/// or 0 where both ends have the same level.
std::optional<StepEdge> find_step_edge(const BaseLine& base, const Surface& surface, int sliding, double step) {
  for (std::size_t i = 0; i < base.pieces.size(); ++i) {
    const BasePiece& piece = base.pieces[i];
    if (i > 0) {
      const double x = piece.from, left = base.at(base.pieces[i - 1], x), right = base.at(piece, x);
      if (std::abs(right - left) > step) return StepEdge{{x, std::max(left, right)}, right > left ? -1 : 1};
    }
    // A face that rises against the sliding; one that falls with it is a part of the surface.
    const double rise = piece.line.slope;
    const int way = rise > 0 ? -1 : 1;
    if (!piece.follows || way == sliding) continue;
    const double x = way > 0 ? piece.from : piece.to;
    if (std::abs(rise) > std::max(steepest_rise, -way * find_rise(surface, x)))
      return StepEdge{{x, base.at(piece, x)}, way};
  }
  return std::nullopt;
}

}  // namespace

Refusal BaseLine::bridge_steps(const Surface& surface, double step) {
  const double left = at(pieces.front(), pieces.front().from), right = at(pieces.back(), pieces.back().to);
  const int sliding = std::abs(left - right) <= step ? 0 : left < right ? -1 : 1;
  // Each ramp ends at the base or at the next step.
  for (std::size_t rest = 4 * pieces.size() + 4; rest > 0; --rest) {
    const auto edge = find_step_edge(*this, surface, sliding, step);
    if (!edge) return Refusal::none;
    const double own = -edge->way * find_rise(surface, edge->at[0]);
    if (!add_ramp(edge->at, edge->way, std::max(edge->way == sliding ? active_ramp : passive_ramp, own))) break;
  }
  return Refusal::blocked;
}

bool BaseLine::add_ramp(const Point& edge, int way, double fall) {
  const auto find_gap = [&](const BasePiece& piece, double x) {
    return at(piece, x) - edge[1] + fall * std::abs(x - edge[0]);
  };
  std::optional<double> end;
  const auto size = static_cast<int>(pieces.size());
  for (int i = way > 0 ? 0 : size - 1; i >= 0 && i < size && !end; i += way) {
    const BasePiece& piece = pieces[static_cast<std::size_t>(i)];
    double a = way > 0 ? piece.from : piece.to, b = way > 0 ? piece.to : piece.from;
    if (way * (a - edge[0]) < 0) continue;
    if (a != edge[0] && find_gap(piece, a) >= 0) {
      end = a;
    } else if (find_gap(piece, b) >= 0) {
      for (int k = 0; k < 60; ++k) {
        const double middle = 0.5 * (a + b);
        (find_gap(piece, middle) < 0 ? a : b) = middle;
      }
      end = b;
    }
  }
  if (!end || *end == edge[0]) return false;
  const double from = std::min(edge[0], *end), to = std::max(edge[0], *end);
  const std::vector<BasePiece> old = std::move(pieces);
  pieces.clear();
  bool is_added = false;
  for (const BasePiece& piece : old) {
    if (piece.from < from) pieces.push_back(piece), pieces.back().to = std::min(piece.to, from);
    if (piece.to > from && !is_added) {
      pieces.push_back({from, to, false, {way > 0 ? edge[1] : edge[1] - fall * (to - from), -way * fall}});
      is_added = true;
    }
    if (piece.to <= to) continue;
    BasePiece rest = piece;
    rest.from = std::max(piece.from, to);
    if (!piece.arc) rest.line.y = piece.line.at(rest.from - piece.from);
    pieces.push_back(rest);
  }
  return true;
}

Refusal BaseLine::divide(const Slope& slope, double from, double to) {
  stretches.clear();
  const auto& strips = slope.strips();
  const double hair = 1e-10 * (to - from), rise = ground_tolerance * (to - from), near = 1e-6 * (to - from);
  int s = strips.find(from);
  for (int p = 0; p < static_cast<int>(pieces.size()); ++p) {
    const BasePiece& piece = pieces[static_cast<std::size_t>(p)];
    const double end = std::min(piece.to, to);
    double a = std::max(piece.from, from);
    while (end - a > hair) {
      while (s + 1 < static_cast<int>(strips.strips.size()) && strips.strip(s).right - a <= hair) ++s;
      const Strip& strip = strips.strip(s);
      double b = std::min(end, strip.right);
      if (end - b <= hair || s + 1 == static_cast<int>(strips.strips.size())) b = end;
      // The ends lie on the ground; between them the arc is convex and its height above the ground is largest at the
      // sides of a strip.
      if ((a > from && at(piece, a) > strip.ground.at(a - strip.left) + rise) ||
          (b < to && at(piece, b) > strip.ground.at(b - strip.left) + rise))
        return Refusal::outside;
      meets.clear();
      for (int i = strip.first; i + 1 < strip.last; ++i)
        add_meets(*this, piece, strip, strips.layer(i).bottom, a, b, meets);
      meets.push_back(b);
      if (meets.size() > 2) std::sort(meets.begin(), meets.end());
      for (const double x : meets) {
        if (x - a <= hair) continue;
        const double middle = 0.5 * (a + x);
        // Along a boundary of layers the upper layer counts, whatever the rounding.
        const int layer = strips.find_layer(strip, middle - strip.left, at(piece, middle) + near);
        if (layer < 0 || strips.layer(layer).soil < 0) return Refusal::below_base;
        if (strips.firm && is_impenetrable(strips.section, strips.layer(layer).soil)) return Refusal::below_base;
        stretches.push_back({a, x, p, s, layer});
        a = x;
      }
      a = b;
    }
  }
  return stretches.empty() ? Refusal::outside : Refusal::none;
}

}  // namespace talus::lem
