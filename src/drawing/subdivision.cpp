// SPDX-License-Identifier: MIT
#include "drawing/subdivision.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "base/error.hpp"
#include "base/foreign_code.hpp"
#include "base/message.hpp"
#include "drawing/drawing.hpp"

namespace talus::drawing {
namespace {

using mesh::Point2;

constexpr double longest_work = 60;          // of processor time [s]
constexpr double most_memory_of_geos = 2e9;  // [bytes]
constexpr std::size_t most_edges = 50'000;

double measure(const Point2& a, const Point2& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

double measure_length(const mesh::Polyline& line) {
  double sum = 0;
  for (std::size_t i = 1; i < line.size(); ++i) sum += measure(line[i - 1], line[i]);
  return sum;
}

/// Corners of lines, of which those within a tolerance are one.
class Corners {
 public:
  explicit Corners(double tolerance) : tolerance_(tolerance) {}

  /// Returns the corner for `p`, which is new if there is none within the tolerance.
  Point2 take(const Point2& p) {
    const Cell centre{std::floor(p[0] / tolerance_), std::floor(p[1] / tolerance_)};
    const Point2* nearest = nullptr;
    for (const double dx : {-1.0, 0.0, 1.0})
      for (const double dy : {-1.0, 0.0, 1.0}) {
        const auto cell = cells_.find({centre[0] + dx, centre[1] + dy});
        if (cell == cells_.end()) continue;
        for (const Point2& q : cell->second)
          if (measure(p, q) <= tolerance_ && (nearest == nullptr || measure(p, q) < measure(p, *nearest))) nearest = &q;
      }
    if (nearest != nullptr) return *nearest;
    cells_[centre].push_back(p);
    all_.push_back(p);
    return p;
  }

  const std::vector<Point2>& all() const { return all_; }

 private:
  using Cell = std::array<double, 2>;
  double tolerance_;
  std::map<Cell, std::vector<Point2>> cells_;
  std::vector<Point2> all_;
};

/// Adds the corners near a segment to it, in their order along it.
void split_segment(const Point2& a, const Point2& b, const std::vector<Point2>& by_x, double tolerance,
                   mesh::Polyline& line, std::vector<Subdivision::Snap>& snaps) {
  const double length = measure(a, b);
  std::vector<std::pair<double, Point2>> inner;
  const double low = std::min(a[0], b[0]) - tolerance, high = std::max(a[0], b[0]) + tolerance;
  const auto first =
      std::lower_bound(by_x.begin(), by_x.end(), low, [](const Point2& p, double x) { return p[0] < x; });
  for (auto p = first; p != by_x.end() && (*p)[0] <= high; ++p) {
    if (*p == a || *p == b) continue;
    const double along = (((*p)[0] - a[0]) * (b[0] - a[0]) + ((*p)[1] - a[1]) * (b[1] - a[1])) / length;
    const double across = std::abs(((*p)[0] - a[0]) * (b[1] - a[1]) - ((*p)[1] - a[1]) * (b[0] - a[0])) / length;
    if (across > tolerance || along <= 0 || along >= length) continue;
    inner.push_back({along, *p});
    snaps.push_back({*p, across});
  }
  std::sort(inner.begin(), inner.end());
  for (const auto& [along, p] : inner) line.push_back(p);
  line.push_back(b);
}

using Segment = std::array<Point2, 2>;

Segment order(const Point2& a, const Point2& b) {
  return a < b ? Segment{a, b} : Segment{b, a};
}

/// Returns the edges that bound no face.
std::vector<Subdivision::Dangle> find_dangles(const std::vector<mesh::Polyline>& edges,
                                              const std::vector<mesh::Polyline>& faces) {
  std::set<Segment> used;
  for (const mesh::Polyline& face : faces)
    for (std::size_t i = 0; i < face.size(); ++i) used.insert(order(face[i], face[(i + 1) % face.size()]));
  std::map<Point2, int> degree;
  for (const mesh::Polyline& edge : edges) ++degree[edge.front()], ++degree[edge.back()];
  std::vector<Subdivision::Dangle> dangles;
  for (const mesh::Polyline& edge : edges)
    if (edge.size() > 1 && !used.contains(order(edge[0], edge[1])))
      dangles.push_back({degree[edge.back()] == 1 ? edge.back() : edge.front(), measure_length(edge)});
  std::stable_sort(dangles.begin(), dangles.end(), [](const auto& a, const auto& b) { return a.length > b.length; });
  return dangles;
}

}  // namespace

std::vector<Subdivision::Snap> snap_lines(std::vector<mesh::Polyline>& lines, double tolerance) {
  std::vector<Subdivision::Snap> snaps;
  Corners corners(tolerance);
  for (mesh::Polyline& line : lines) {
    for (Point2& p : line) {
      const Point2 to = corners.take(p);
      snaps.push_back({to, measure(p, to)});
      p = to;
    }
    line.erase(std::unique(line.begin(), line.end()), line.end());
  }
  std::erase_if(lines, [](const mesh::Polyline& line) { return line.size() < 2; });
  std::vector<Point2> by_x = corners.all();
  std::sort(by_x.begin(), by_x.end());
  for (mesh::Polyline& line : lines) {
    mesh::Polyline split{line.front()};
    for (std::size_t i = 1; i < line.size(); ++i) split_segment(line[i - 1], line[i], by_x, tolerance, split, snaps);
    line = std::move(split);
  }
  // Gaps of this size are rounding errors of coordinates.
  std::erase_if(snaps, [&](const Subdivision::Snap& snap) { return snap.gap < 1e-3 * tolerance; });
  std::stable_sort(snaps.begin(), snaps.end(), [](const auto& a, const auto& b) { return a.gap > b.gap; });
  return snaps;
}

Subdivision subdivide(const std::vector<Chain>& chains, double tolerance) {
  std::vector<mesh::Polyline> lines;
  Subdivision found;
  for (const Chain& chain : chains) {
    lines.push_back(chain.points);
    if (chain.closed) lines.back().push_back(lines.back().front());
  }
  found.snaps = snap_lines(lines, tolerance);
  Message message;
  try {
    message = do_in_child("finding the areas between lines", [&](Message& out) {
      const auto divide = reinterpret_cast<SubdivideByGdal>(load_gdal("talus_subdivide"));
      limit_processor_time(longest_work);
      limit_memory(most_memory_of_geos);
      std::vector<mesh::Polyline> edges, faces;
      std::string error;
      // Crossings may lie within the tolerance of corners, so lines are snapped once more between two divisions.
      divide(lines, edges, faces, error);
      if (error.empty() && edges.size() > most_edges)
        error = fmt::format("they divide one another into {} parts, and at most {} are used", edges.size(), most_edges);
      if (error.empty()) {
        snap_lines(edges, tolerance);
        lines = std::move(edges);
        edges.clear(), faces.clear();
        divide(lines, edges, faces, error);
      }
      out.put_text(error);
      Putting put(out);
      put(edges, faces);
    });
  } catch (const ChildCrash& crash) {
    fail_input("the areas between the lines of the drawing cannot be found: {}", crash.what());
  }
  if (const std::string error = message.get_text(); !error.empty())
    fail_input("the areas between the lines of the drawing cannot be found: {}", error);
  std::vector<mesh::Polyline> edges;
  Taking take(message);
  take(edges, found.faces);
  found.dangles = find_dangles(edges, found.faces);
  return found;
}

}  // namespace talus::drawing
