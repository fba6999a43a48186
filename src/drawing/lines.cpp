// SPDX-License-Identifier: MIT
#include "drawing/lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/linestring.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "base/error.hpp"
#include "mesh/layers.hpp"

namespace talus::drawing {
namespace {

using mesh::Point2;
using mesh::Polyline;

bool is_near(const Point2& a, const Point2& b, double tolerance) {
  return std::hypot(a[0] - b[0], a[1] - b[1]) <= tolerance;
}

/// Joins the lines of a layer at points in which exactly two of them end.
class Joiner {
 public:
  explicit Joiner(double tolerance) : tolerance_(tolerance) {}

  std::vector<Chain> join(const std::vector<Chain>& lines) {
    std::vector<Chain> joined;
    ends_.clear();
    for (std::size_t i = 0; i < lines.size(); ++i)
      if (!lines[i].closed)
        for (const Point2* p : {&lines[i].points.front(), &lines[i].points.back()})
          ends_[get_cell(*p)].push_back({i, *p});
    std::vector<char> is_used(lines.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (is_used[i]) continue;
      is_used[i] = 1;
      Chain chain = lines[i];
      for (int side = 0; side < 2 && !chain.closed; ++side) {
        while (const auto next = find_next(chain.points.back(), is_used)) {
          is_used[*next] = 1;
          Polyline more = lines[*next].points;
          if (!meets(more.front(), chain.points.back())) std::reverse(more.begin(), more.end());
          chain.points.insert(chain.points.end(), more.begin() + 1, more.end());
        }
        if (chain.points.size() > 3 && meets(chain.points.front(), chain.points.back())) {
          chain.points.pop_back();
          chain.closed = true;
        }
        std::reverse(chain.points.begin(), chain.points.end());
      }
      joined.push_back(std::move(chain));
    }
    return joined;
  }

 private:
  bool meets(const Point2& a, const Point2& b) const { return is_near(a, b, tolerance_); }
  struct End {
    std::size_t line;
    Point2 at;
  };
  using Cell = std::array<double, 2>;
  Cell get_cell(const Point2& p) const { return {std::floor(p[0] / tolerance_), std::floor(p[1] / tolerance_)}; }

  /// Returns the unused line that ends at `p`, if it is the only other one.
  std::optional<std::size_t> find_next(const Point2& p, const std::vector<char>& is_used) const {
    std::optional<std::size_t> found;
    int count = 0;
    const Cell centre = get_cell(p);
    for (const double dx : {-1.0, 0.0, 1.0})
      for (const double dy : {-1.0, 0.0, 1.0}) {
        const auto cell = ends_.find({centre[0] + dx, centre[1] + dy});
        if (cell == ends_.end()) continue;
        for (const End& end : cell->second) {
          if (!meets(end.at, p)) continue;
          ++count;
          if (!is_used[end.line]) found = end.line;
        }
      }
    return count == 2 ? found : std::nullopt;
  }

  double tolerance_;
  std::map<Cell, std::vector<End>> ends_;
};

/// Returns the line without points within `tolerance` of it (Douglas and Peucker).
Polyline simplify(const Polyline& line, bool closed, double tolerance) {
  using Place = boost::geometry::model::d2::point_xy<double>;
  boost::geometry::model::linestring<Place> all, fewer;
  for (const Point2& p : line) all.emplace_back(p[0], p[1]);
  if (closed) all.push_back(all.front());
  boost::geometry::simplify(all, fewer, tolerance);
  if (closed) fewer.pop_back();
  if (closed && fewer.size() < 3) return line;
  Polyline points;
  for (const Place& p : fewer) points.push_back({p.x(), p.y()});
  return points;
}

}  // namespace

bool is_a_place(const Point2& p) {
  constexpr double farthest = 1e9;  // [m]
  return std::abs(p[0]) < farthest && std::abs(p[1]) < farthest;
}

double measure_extent(const std::vector<Chain>& chains) {
  Point2 low{1e300, 1e300}, high{-1e300, -1e300};
  for (const Chain& chain : chains)
    for (const Point2& p : chain.points)
      for (std::size_t d = 0; d < 2; ++d) low[d] = std::min(low[d], p[d]), high[d] = std::max(high[d], p[d]);
  return std::max(high[0] - low[0], high[1] - low[1]);
}

void drop_repeated(Polyline& points, double tolerance) {
  points.erase(std::unique(points.begin(), points.end(),
                           [&](const Point2& a, const Point2& b) { return is_near(a, b, tolerance); }),
               points.end());
}

std::vector<Chain> join_lines(const std::vector<Chain>& lines, double tolerance) {
  return Joiner(tolerance).join(lines);
}

void thin_out(std::vector<Chain>& chains, double tolerance, const std::string& what,
              std::vector<std::string>& remarks) {
  const auto count = [&] {
    std::size_t sum = 0;
    for (const Chain& chain : chains) sum += chain.points.size();
    return sum;
  };
  const std::size_t before = count();
  const double most = tolerance * largest_move / meeting_distance;
  double used = 0;
  for (double move = tolerance; count() > most_corners && move < most; move *= 2) {
    used = move;
    for (Chain& chain : chains)
      if (chain.points.size() > 2) chain.points = simplify(chain.points, chain.closed, move);
  }
  if (count() > most_corners)
    fail_input(
        "{} has {} points, and a section at most {}: even with lines that move by a thousandth of it, {} remain. "
        "Simplify them, or leave lines out (--layers for a drawing)",
        what, before, most_corners, count());
  if (used > 0)
    remarks.push_back(fmt::format("{} of {} points were left out; the lines moved by less than {:.2g} m",
                                  before - count(), before, 2 * used));
}

double compare_levels(const Polyline& a, const Polyline& b) {
  const double from = std::max(a.front()[0], b.front()[0]), to = std::min(a.back()[0], b.back()[0]);
  if (!(to > from)) return std::nan("");
  constexpr int samples = 32;
  double sum = 0;
  for (int i = 0; i < samples; ++i) {
    const double x = from + (to - from) * (i + 0.5) / samples;
    sum += mesh::find_level(a, x) - mesh::find_level(b, x);
  }
  return sum / samples;
}

std::optional<Point2> find_crossing(const Polyline& a, const Polyline& b, double tolerance) {
  const double from = std::max(a.front()[0], b.front()[0]), to = std::min(a.back()[0], b.back()[0]);
  std::vector<double> knots{from, to};
  for (const Polyline* line : {&a, &b})
    for (const Point2& p : *line)
      if (p[0] > from && p[0] < to) knots.push_back(p[0]);
  std::sort(knots.begin(), knots.end());
  int before = 0;
  for (const double x : to > from ? knots : std::vector<double>()) {
    const double level = mesh::find_level(a, x), height = level - mesh::find_level(b, x);
    const int side = height > tolerance ? 1 : height < -tolerance ? -1 : 0;
    if (side * before < 0) return Point2{x, level};
    if (side != 0) before = side;
  }
  return std::nullopt;
}

std::pair<Polyline, Polyline> split_outline(const Polyline& outline) {
  const std::size_t n = outline.size();
  const auto select = [&](auto&& is_better) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < n; ++i)
      if (is_better(outline[i], outline[best])) best = i;
    return best;
  };
  const auto is_left = [](const Point2& a, const Point2& b) { return a[0] < b[0]; };
  const auto is_right = [](const Point2& a, const Point2& b) { return a[0] > b[0]; };
  const auto walk = [&](std::size_t from, std::size_t to, std::size_t step) {
    Polyline line{outline[from]};
    for (std::size_t i = from; i != to;) line.push_back(outline[i = (i + step) % n]);
    return line;
  };
  const auto at_end = [&](bool left, bool top) {
    return select([&](const Point2& a, const Point2& b) {
      if (a[0] != b[0]) return left ? is_left(a, b) : is_right(a, b);
      return top ? a[1] > b[1] : a[1] < b[1];
    });
  };
  const bool clockwise = mesh::compute_area(outline) < 0;
  const std::size_t forward = clockwise ? 1 : n - 1, backward = n - forward;
  return {walk(at_end(true, true), at_end(false, true), forward),
          walk(at_end(true, false), at_end(false, false), backward)};
}

void sort_down(std::vector<Chain>& lines) {
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    std::size_t top = i;
    for (std::size_t k = i + 1; k < lines.size(); ++k)
      if (compare_levels(lines[k].points, lines[top].points) > 0) top = k;
    std::rotate(lines.begin() + static_cast<std::ptrdiff_t>(i), lines.begin() + static_cast<std::ptrdiff_t>(top),
                lines.begin() + static_cast<std::ptrdiff_t>(top) + 1);
  }
}

void check_base(double base, const std::vector<mesh::Polyline>& lines) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const mesh::Polyline& line : lines)
    for (const mesh::Point2& x : line) lowest = std::min(lowest, x[1]);
  if (!(base < lowest))
    fail_input("--base is {:.6g} m, and the lowest line of the survey lies at y = {:.6g} m: the base is below it", base,
               lowest);
}

}  // namespace talus::drawing
