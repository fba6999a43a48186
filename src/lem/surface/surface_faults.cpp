// SPDX-License-Identifier: MIT
// Faults of a slip surface that the user gave.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"
#include "lem/surface/base_line.hpp"

namespace talus::lem {

namespace {

std::string name_surface(const Surface& surface) {
  const char* kind = surface.circle ? "slip circle" : "slip surface";
  return surface.name.empty() ? fmt::format("the {}", kind) : fmt::format("{} '{}'", kind, surface.name);
}

void check_end(const Slope& slope, const std::string& name, const BaseLine& base, bool left, double near,
               std::vector<std::string>& faults) {
  const BasePiece& piece = left ? base.pieces.front() : base.pieces.back();
  const double x = left ? piece.from : piece.to, y = base.at(piece, x);
  const std::string end = fmt::format("{}: its {} end {}", name, left ? "left" : "right", format_point(Point{x, y}));
  if (x < slope.left() - near || x > slope.right() + near) {
    faults.push_back(fmt::format("{} lies outside the ground, which runs from x = {} to {}", end,
                                 format_coordinate(slope.left()), format_coordinate(slope.right())));
  } else if (!base.ends_on_ground(slope.strips(), piece, x, near)) {
    const double off = y - slope.ground(x);
    faults.push_back(
        fmt::format("{} lies {:.4g} m {} the ground, expected on it", end, std::abs(off), off > 0 ? "above" : "below"));
  }
}

bool check_shape(const Surface& surface, const std::string& name, std::vector<std::string>& faults) {
  if (surface.circle) {
    if (!(surface.circle->radius > 0)) faults.push_back(fmt::format("{}: its radius is not positive", name));
    if (!(surface.to > surface.from))
      faults.push_back(fmt::format("{} has no width: it meets the ground at no two points", name));
  } else {
    if (surface.line.size() < 2) faults.push_back(fmt::format("{} has fewer than two points", name));
    for (std::size_t i = 1; i < surface.line.size(); ++i) {
      const Point &a = surface.line[i - 1], &b = surface.line[i];
      if (!(b[0] > a[0]))
        faults.push_back(fmt::format("{} runs backwards from {} to {}: x must grow from point to point", name,
                                     format_point(a), format_point(b)));
    }
  }
  return faults.empty();
}

}  // namespace

std::vector<std::string> find_faults(const Slope& slope, const Surface& surface) {
  std::vector<std::string> faults;
  const std::string name = name_surface(surface);
  if (!check_shape(surface, name, faults)) return faults;
  BaseLine base;
  Checks checks;
  if (base.lay(slope, surface, checks) != Refusal::none) {
    faults.push_back(
        surface.circle
            ? fmt::format("{}: its ends lie beyond the lower half of the circle, or its centre below the base", name)
            : fmt::format("{} goes below the base at elevation {:.6g}", name, slope.section().base));
    return faults;
  }
  const double from = base.pieces.front().from, to = base.pieces.back().to, near = ground_tolerance * (to - from);
  check_end(slope, name, base, true, near, faults);
  check_end(slope, name, base, false, near, faults);
  if (!faults.empty()) return faults;
  const Refusal refusal = base.divide(slope, from, to);
  if (refusal == Refusal::below_base) faults.push_back(fmt::format("{} goes below the lowest region of soil", name));
  if (refusal == Refusal::outside) faults.push_back(fmt::format("{} rises above the ground between its ends", name));
  return faults;
}

}  // namespace talus::lem
