// SPDX-License-Identifier: MIT
#include "lem/surface/base_line.hpp"

#include <algorithm>
#include <cmath>

namespace talus::lem {

namespace {

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
  const double bottom = slope.section().base;
  if (!surface.circle) {
    if (surface.line.size() < 2) return Refusal::outside;
    const double nearest = 1e-6 * (surface.line.back()[0] - surface.line.front()[0]);
    for (std::size_t i = 1; i < surface.line.size(); ++i) {
      const Point &a = surface.line[i - 1], &b = surface.line[i];
      if (!(b[0] > a[0])) return Refusal::outside;
      if (std::min(a[1], b[1]) < bottom - nearest) return Refusal::below_base;
      pieces.push_back({a[0], b[0], false, {a[1], (b[1] - a[1]) / (b[0] - a[0])}});
    }
    return clip(slope.strips(), true);
  }
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
  return clip(slope.strips(), may_cut);
}

Refusal BaseLine::clip(const Slope::Strips& strips, bool may_cut) {
  if (!strips.firm) return Refusal::none;
  const std::vector<BasePiece> whole = std::move(pieces);
  pieces.clear();
  const double span = whole.back().to - whole.front().from, hair = 1e-10 * span, step = 1e-6 * span;
  for (const BasePiece& piece : whole) {
    for (int s = strips.find(piece.from); s < static_cast<int>(strips.strips.size()); ++s) {
      const Strip& strip = strips.strip(s);
      double a = std::max(piece.from, strip.left);
      const double end = std::min(piece.to, strip.right);
      if (end - a <= hair && a > piece.from) break;
      meets.clear();
      if (strip.is_firm) add_meets(*this, piece, strip, strip.floor, a, end, meets);
      meets.push_back(end);
      std::sort(meets.begin(), meets.end());
      for (const double b : meets) {
        if (b - a <= hair) continue;
        const double middle = 0.5 * (a + b) - strip.left;
        const bool follows = strip.is_firm && at(piece, 0.5 * (a + b)) < strip.floor.at(middle);
        BasePiece part = piece;
        part.from = a;
        part.to = b;
        if (!piece.arc) part.line.y = piece.line.at(a - piece.from);
        if (follows) part = {a, b, false, {strip.floor.at(a - strip.left), strip.floor.slope}};
        composite = composite || follows;
        const bool is_cut_at_base = !piece.arc && whole.size() > 1 && !follows;
        if (is_cut_at_base && !may_cut) return Refusal::below_base;
        // A vertical face of impenetrable soil has no slices along it.
        if (!pieces.empty() && std::abs(at(pieces.back(), a) - at(part, a)) > step) return Refusal::below_base;
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
  return Refusal::none;
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
