// SPDX-License-Identifier: MIT
#include "mesh/layers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace talus::mesh {
namespace {

/// A point of a boundary as a function of x, with its levels on both sides, which differ at a vertical step.
struct Knot {
  double x = 0, left = 0, right = 0;
};

/// A boundary from the left to the right end of the ground. The knots increase in x.
using Boundary = std::vector<Knot>;

double interpolate(double x, const Knot& a, const Knot& b) {
  return a.right + (b.left - a.right) * (x - a.x) / (b.x - a.x);
}

Boundary make_boundary(const Polyline& line) {
  Boundary boundary;
  for (const Point2& p : line) {
    if (boundary.empty() || p[0] > boundary.back().x)
      boundary.push_back({p[0], p[1], p[1]});
    else
      boundary.back().right = p[1];
  }
  return boundary;
}

/// Returns the index of the first knot at or beyond x.
std::size_t find_knot(const Boundary& boundary, double x) {
  const auto at =
      std::lower_bound(boundary.begin(), boundary.end(), x, [](const Knot& k, double v) { return k.x < v; });
  return static_cast<std::size_t>(at - boundary.begin());
}

/// Returns the knot of a boundary at x, interpolated where there is none.
Knot get_knot(const Boundary& boundary, double x) {
  const std::size_t i = find_knot(boundary, x);
  if (i < boundary.size() && boundary[i].x == x) return boundary[i];
  if (i == 0) return {x, boundary.front().left, boundary.front().left};
  if (i == boundary.size()) return {x, boundary.back().right, boundary.back().right};
  const double level = interpolate(x, boundary[i - 1], boundary[i]);
  return {x, level, level};
}

/// Returns the boundary with knots at the places of both, and where the two cross.
Boundary refine(const Boundary& boundary, const Boundary& other) {
  Boundary refined;
  std::size_t i = 0, j = 0;
  while (i < boundary.size() || j < other.size()) {
    const bool takes_own = j == other.size() || (i < boundary.size() && boundary[i].x <= other[j].x);
    const double x = takes_own ? boundary[i].x : other[j].x;
    if (i < boundary.size() && boundary[i].x == x) ++i;
    if (j < other.size() && other[j].x == x) ++j;
    const Knot next = get_knot(boundary, x);
    if (!refined.empty()) {
      const Knot last = refined.back();
      const double before = last.right - get_knot(other, last.x).right, after = next.left - get_knot(other, x).left;
      if ((before > 0) != (after > 0) && before != 0 && after != 0) {
        const double crossing = last.x + (x - last.x) * before / (before - after);
        if (crossing > last.x && crossing < x) {
          const double level = get_knot(other, crossing).left;
          refined.push_back({crossing, level, level});
        }
      }
    }
    refined.push_back(next);
  }
  return refined;
}

Boundary offset(Boundary boundary, double height) {
  for (Knot& k : boundary) k.left += height, k.right += height;
  return boundary;
}

/// Largest height of a boundary over another one, by intervals of x in which it is above.
struct Excess {
  double from = 0, to = 0, size = 0;
};

/// Lowers a boundary to `limit` where it is above, or less than `least` below, and returns the intervals with the
/// largest height by which it was above; of those moved down to close a sliver the height is negative.
std::vector<Excess> lower_to(Boundary& boundary, const Boundary& limit, double least) {
  const auto is_own = [own = boundary](double x) {
    const std::size_t i = find_knot(own, x);
    return i < own.size() && own[i].x == x;
  };
  Boundary fine = refine(boundary, limit);
  std::vector<Excess> found;
  // The boundary is above the limit from the crossing before the first such knot to the crossing after the last one.
  bool continues = false;
  const auto note = [&](std::size_t i, double height, double moved) {
    const double x = fine[i].x;
    if (continues) found.back().to = x;
    if (moved != 0 && (!continues || (height > 0) != (found.back().size > 0)))
      found.push_back(
          {height > 0 && i > 0 && fine[i - 1].left == get_knot(limit, fine[i - 1].x).left ? fine[i - 1].x : x, x,
           height > 0 ? height : -moved});
    else if (moved != 0)
      found.back().size = height > 0 ? std::max(found.back().size, height) : std::min(found.back().size, -moved);
    continues = moved != 0;
  };
  std::vector<char> touches(fine.size()), is_moved(fine.size());
  for (std::size_t i = 0; i < fine.size(); ++i) {
    const Knot top = get_knot(limit, fine[i].x);
    for (auto side : {&Knot::left, &Knot::right}) {
      const double height = fine[i].*side - top.*side;
      const bool closes = height > -least;
      note(i, height, closes ? std::abs(height) : 0);
      if (closes) fine[i].*side = top.*side, touches[i] = 1;
      if (closes && height != 0) is_moved[i] = 1;
    }
  }
  // Knots of the limit are needed only where the boundary follows it.
  boundary.clear();
  for (std::size_t i = 0; i < fine.size(); ++i) {
    const bool follows = touches[i] || (i > 0 && is_moved[i - 1]) || (i + 1 < fine.size() && is_moved[i + 1]);
    if (follows || is_own(fine[i].x)) boundary.push_back(fine[i]);
  }
  return found;
}

/// Gives knots that differ by rounding errors the same x.
void join_places(std::vector<Boundary>& boundaries, double tolerance) {
  std::vector<double> places;
  for (const Boundary& boundary : boundaries)
    for (const Knot& knot : boundary) places.push_back(knot.x);
  std::sort(places.begin(), places.end());
  std::vector<double> kept;
  for (const double x : places)
    if (kept.empty() || x - kept.back() > tolerance) kept.push_back(x);
  for (Boundary& boundary : boundaries) {
    Boundary joined;
    for (Knot knot : boundary) {
      knot.x = *std::prev(std::upper_bound(kept.begin(), kept.end(), knot.x));
      if (joined.empty() || knot.x > joined.back().x)
        joined.push_back(knot);
      else
        joined.back().right = knot.right;
    }
    boundary = std::move(joined);
  }
}

/// Adds to each boundary the knots of the others that lie on it, so that polygons share their corners.
void share_knots(std::vector<Boundary>& boundaries, double tolerance) {
  for (Boundary& boundary : boundaries) {
    Boundary more;
    for (const Boundary& other : boundaries) {
      if (&other == &boundary) continue;
      for (const Knot& knot : other) {
        const Knot own = get_knot(boundary, knot.x);
        const std::size_t i = find_knot(boundary, knot.x);
        if (i < boundary.size() && boundary[i].x == knot.x) continue;
        if (std::abs(own.left - knot.left) <= tolerance)
          more.push_back({knot.x, knot.left, knot.left});
        else if (std::abs(own.left - knot.right) <= tolerance)
          more.push_back({knot.x, knot.right, knot.right});
      }
    }
    boundary.insert(boundary.end(), more.begin(), more.end());
    std::stable_sort(boundary.begin(), boundary.end(), [](const Knot& a, const Knot& b) { return a.x < b.x; });
    boundary.erase(
        std::unique(boundary.begin(), boundary.end(), [](const Knot& a, const Knot& b) { return a.x == b.x; }),
        boundary.end());
  }
}

/// Makes levels at one place equal that differ by rounding errors. Requires share_knots() before.
void join_levels(std::vector<Boundary>& boundaries, double tolerance) {
  const auto join = [&](double& level, double to) {
    if (std::abs(level - to) <= tolerance) level = to;
  };
  for (std::size_t i = 0; i < boundaries.size(); ++i)
    for (Knot& knot : boundaries[i]) {
      for (std::size_t j = 0; j < i; ++j) {
        const std::size_t k = find_knot(boundaries[j], knot.x);
        if (k == boundaries[j].size() || boundaries[j][k].x != knot.x) continue;
        join(knot.left, boundaries[j][k].left);
        join(knot.right, boundaries[j][k].right);
      }
      join(knot.right, knot.left);
    }
}

/// Collects the outline of one connected part of a layer.
class Outline {
 public:
  bool is_empty() const { return top_.empty(); }
  void add_top(double x, double y) { add(top_, {x, y}); }
  void add_bottom(double x, double y) { add(bottom_, {x, y}); }

  Polyline take() {
    Polyline corners = std::move(top_);
    for (auto p = bottom_.rbegin(); p != bottom_.rend(); ++p) add(corners, *p);
    while (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
    top_.clear();
    bottom_.clear();
    return corners;
  }

 private:
  static void add(Polyline& line, const Point2& p) {
    if (line.empty() || line.back() != p) line.push_back(p);
  }
  Polyline top_, bottom_;
};

/// Returns the parts of the soil between two boundaries, from left to right.
std::vector<Polyline> list_parts(const Boundary& top, const Boundary& bottom) {
  std::vector<double> places;
  for (const Boundary* b : {&top, &bottom})
    for (const Knot& k : *b) places.push_back(k.x);
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  const auto is_knot = [](const Boundary& b, double x) {
    const std::size_t i = find_knot(b, x);
    return i < b.size() && b[i].x == x;
  };
  std::vector<Polyline> parts;
  Outline outline;
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const double x = places[i], end = places[i + 1];
    const Knot a = get_knot(top, x), b = get_knot(bottom, x), c = get_knot(top, end), d = get_knot(bottom, end);
    if (!(a.right > b.right || c.left > d.left)) continue;
    if (outline.is_empty() || is_knot(top, x)) outline.add_top(x, a.right);
    if (outline.is_empty() || is_knot(bottom, x)) outline.add_bottom(x, b.right);
    // Soil on both sides of x is connected if the vertical through x passes through both.
    const bool ends = i + 2 == places.size() || !(std::min(c.left, c.right) > std::max(d.left, d.right));
    if (ends || is_knot(top, end)) outline.add_top(end, c.left);
    if (ends || is_knot(bottom, end)) outline.add_bottom(end, d.left);
    if (ends) parts.push_back(outline.take());
  }
  std::erase_if(parts, [](const Polyline& part) { return part.size() < 3; });
  return parts;
}

/// Fits a boundary to the extent of the ground. Beyond an end at or above `top` it follows that boundary; otherwise it
/// continues horizontally.
Boundary fit(const Boundary& boundary, const Boundary& top, double least, int layer, std::vector<LayerNote>& notes) {
  const double left = top.front().x, right = top.back().x;
  Boundary fitted;
  const auto add_note = [&](LayerNote::Kind kind, double from, double to) {
    notes.push_back({kind, layer, from, to, 0});
  };
  const Knot &first = boundary.front(), &last = boundary.back();
  const auto follows = [&](double x, double level, double at_top) {
    return x > left && x < right && level > at_top - least;
  };
  if (first.x < left || last.x > right) add_note(LayerNote::Kind::trimmed, first.x, last.x);
  if (first.x > left) {
    const Knot at = get_knot(top, first.x);
    if (follows(first.x, first.left, at.left)) {
      for (const Knot& k : top)
        if (k.x < first.x) fitted.push_back(k);
    } else {
      add_note(LayerNote::Kind::extended, left, first.x);
      fitted.push_back({left, first.left, first.left});
    }
  } else {
    fitted.push_back(get_knot(boundary, left));
    fitted.back().left = fitted.back().right;
  }
  for (const Knot& k : boundary)
    if (k.x > left && k.x < right) fitted.push_back(k);
  if (last.x < right) {
    const Knot at = get_knot(top, last.x);
    if (follows(last.x, last.right, at.right)) {
      for (const Knot& k : top)
        if (k.x > last.x) fitted.push_back(k);
    } else {
      add_note(LayerNote::Kind::extended, last.x, right);
      fitted.push_back({right, last.right, last.right});
    }
  } else {
    fitted.push_back(get_knot(boundary, right));
    fitted.back().right = fitted.back().left;
  }
  return fitted;
}

void add_excess(const std::vector<Excess>& list, LayerNote::Kind above, int layer, double tiny,
                std::vector<LayerNote>& notes) {
  for (const Excess& e : list)
    if (std::abs(e.size) > tiny)
      notes.push_back({e.size > 0 ? above : LayerNote::Kind::sliver, layer, e.from, e.to, std::abs(e.size)});
}

}  // namespace

int find_fold(const Polyline& line) {
  for (std::size_t i = 1; i < line.size(); ++i)
    if (line[i][0] < line[i - 1][0]) return static_cast<int>(i);
  return -1;
}

double find_level(const Polyline& line, double x) {
  const Knot knot = get_knot(make_boundary(line), x);
  return std::min(knot.left, knot.right);
}

LayeredSection make_layers(const Polyline& ground, const std::vector<Layer>& layers, double least) {
  LayeredSection section;
  std::vector<Boundary> boundaries{make_boundary(ground)};
  const double width = boundaries[0].back().x - boundaries[0].front().x;
  const double tiny = 1e-9 * width;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const int layer = static_cast<int>(i);
    Boundary bottom = layers[i].thickness
                          ? offset(boundaries.back(), -*layers[i].thickness)
                          : fit(make_boundary(layers[i].bottom), boundaries.back(), least, layer, section.notes);
    add_excess(lower_to(bottom, boundaries.front(), least), LayerNote::Kind::outcrop, layer, tiny, section.notes);
    if (i > 0)
      add_excess(lower_to(bottom, boundaries.back(), least),
                 layers[i].cut ? LayerNote::Kind::cut : LayerNote::Kind::crossed, layer, tiny, section.notes);
    boundaries.push_back(std::move(bottom));
  }
  join_places(boundaries, tiny);
  share_knots(boundaries, tiny);
  join_levels(boundaries, tiny);
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const std::vector<Polyline> parts = list_parts(boundaries[i], boundaries[i + 1]);
    if (parts.empty()) section.notes.push_back({LayerNote::Kind::vanished, static_cast<int>(i), 0, 0, 0});
    for (std::size_t k = 0; k < parts.size(); ++k) {
      section.polygons.push_back({k == 0 ? layers[i].name : fmt::format("{} ({})", layers[i].name, k + 1), parts[k]});
      section.layers.push_back(static_cast<int>(i));
    }
  }
  return section;
}

}  // namespace talus::mesh
