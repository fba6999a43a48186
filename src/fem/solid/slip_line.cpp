// SPDX-License-Identifier: MIT
// The slip lines of a failed trial: the path of least cost through the mesh between the two ends of the moving ground
// of a side, where the cost of a length decreases with the shear strain (T19.11); then moved onto the ridge of the
// shear strain and smoothed.

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <queue>

#include "fem/solid/system.hpp"
#include "mesh/planar.hpp"

namespace talus::fem {
namespace {

using Point = std::array<double, 2>;
using Line = std::vector<Point>;

constexpr double moving_share = 0.4;    ///< fraction of the largest displacement: moving ground
constexpr double bridged = 4;           ///< elements of resting ground that separate moving ground
constexpr double steeper = 1.2;         ///< ratio of the gradients of displacement for an end farther out
constexpr double across_share = 0.25;   ///< fraction of the largest displacement: motion to a side
constexpr double band_quantile = 0.97;  ///< fraction of the area with strains below γ_c; larger strains count as γ_c
constexpr double least_share = 1e-3;    ///< lower limit of γ/γ_c
constexpr double along_ground = 10;     ///< factor of the cost on the ground, which keeps the line off it
constexpr int passes = 8;               ///< iterations of the move onto the ridge
constexpr double reach = 1.5;           ///< radius in elements within which the ridge is searched

double find_distance(const Point& a, const Point& b) {
  return std::hypot(b[0] - a[0], b[1] - a[1]);
}

/// Returns √(2 e:e) of a strain with engineering shear components, which is γ in simple shear.
double find_shear(const std::array<double, 6>& s) {
  const double m = (s[0] + s[1] + s[2]) / 3;
  return std::sqrt(2 * ((s[0] - m) * (s[0] - m) + (s[1] - m) * (s[1] - m) + (s[2] - m) * (s[2] - m)) + s[3] * s[3]);
}

class SlipLines {
 public:
  SlipLines(const SolidModel<2>& model, const QuadraticMesh<2>& mesh, const SolidState<2>& state)
      : mesh_(mesh), state_(state), held_(find_held_directions(model, mesh)) {}

  std::vector<SlipLine> find() {
    find_strains();
    if (!(cap_ > 0)) return {};
    chain_ground();
    const int fastest = find_fastest([&](int n) { return find_motion(n); });
    if (fastest < 0) return {};
    std::vector<SlipLine> lines;
    if (const auto divide = find_sides(across_share * find_motion(fastest))) {
      const auto find_side = [&](bool is_left, int way) {
        const auto is_own = [&](int n) { return (place(n)[0] < divide->x) == is_left; };
        add_line(find_fastest([&](int n) { return is_own(n) ? way * displace(n)[0] : 0; }), way, is_own, lines);
      };
      find_side(true, divide->left);
      find_side(false, -divide->left);
      if (lines.size() == 2) {
        if (fastest_[1] > fastest_[0]) std::swap(lines[0], lines[1]);
        return lines;
      }
      lines.clear();
    }
    add_line(
        fastest, 0, [](int) { return true; }, lines);
    return lines;
  }

 private:
  using Q = Quadratic<2>;

  /// Computes the shear strain at nodes and integration points, and γ_c.
  void find_strains() {
    std::vector<double> weight(mesh_.nodes.size(), 0);
    strain_.assign(mesh_.nodes.size(), 0);
    double area = 0;
    std::vector<std::array<double, 2>> ranked;
    for (std::size_t p = 0; p < mesh_.points.size(); ++p) {
      const double shear = find_shear(state_.strain[p]);
      shear_.push_back(shear);
      ranked.push_back({shear, mesh_.weights[p]});
      area += mesh_.weights[p];
      const auto& nodes = mesh_.elements[p / Q::points];
      for (std::size_t i = 0; i < Q::nodes; ++i) {
        const auto n = static_cast<std::size_t>(nodes[i]);
        const double w = mesh_.weights[p] / std::max(find_distance(mesh_.nodes[n], mesh_.points[p]), 1e-300);
        strain_[n] += w * shear;
        weight[n] += w;
      }
    }
    for (std::size_t n = 0; n < strain_.size(); ++n)
      if (weight[n] > 0) strain_[n] /= weight[n];
    size_ = 1.5 * std::sqrt(area / static_cast<double>(mesh_.elements.size()));  // edge of a mean triangle
    std::sort(ranked.begin(), ranked.end());
    double sum = 0;
    for (const auto& [shear, w] : ranked) {
      sum += w;
      cap_ = shear;
      if (sum >= band_quantile * area) break;
    }
  }

  const Point& place(int n) const { return mesh_.nodes[static_cast<std::size_t>(n)]; }
  const Vec<2>& displace(int n) const { return state_.displacement[static_cast<std::size_t>(n)]; }
  double find_motion(int n) const { return norm(displace(n)); }

  /// Determines the nodes of the free surface and their neighbours along it.
  void chain_ground() {
    std::map<std::array<int, 3>, int> uses;  // number of elements per half edge: a < b, middle
    for (const auto& element : mesh_.elements)
      for (std::size_t i = 0; i < Q::edges.size(); ++i) {
        // The two sides of a wall count as one line inside the soil.
        const int a = mesh_.find_original(element[Q::edges[i][0]]), b = mesh_.find_original(element[Q::edges[i][1]]);
        ++uses[{std::min(a, b), std::max(a, b), mesh_.find_original(element[Q::corners + i])}];
      }
    ground_.assign(mesh_.nodes.size(), 0);
    for (const auto& [edge, count] : uses) {
      if (count != 1 || !held_[static_cast<std::size_t>(edge[2])].empty()) continue;
      for (int end : {edge[0], edge[1]}) {
        next_[end].push_back(edge[2]);
        next_[edge[2]].push_back(end);
      }
      for (int n : edge) ground_[static_cast<std::size_t>(n)] = 1;
    }
  }

  /// Returns the node of the ground with the largest positive speed(n); -1 if there is none.
  int find_fastest(const auto& speed) const {
    double most = 0;
    int fastest = -1;
    for (std::size_t n = 0; n < ground_.size(); ++n) {
      if (!ground_[n]) continue;
      const double u = speed(static_cast<int>(n));
      if (u > most) most = u, fastest = static_cast<int>(n);
    }
    return fastest;
  }

  /// Returns the divide between soil that moves to smaller x and soil that moves to larger x.
  std::optional<mesh::Divide> find_sides(double threshold) const {
    std::vector<mesh::MovedSoil> soil;
    for (std::size_t k = 0; k < mesh_.elements.size(); ++k) {
      mesh::MovedSoil& s = soil.emplace_back();
      for (const int n : mesh_.elements[k]) {
        s.x += mesh_.nodes[static_cast<std::size_t>(n)][0] / Q::nodes;
        s.across += state_.displacement[static_cast<std::size_t>(n)][0] / Q::nodes;
      }
      for (std::size_t p = k * Q::points; p < (k + 1) * Q::points; ++p) s.amount += mesh_.weights[p];
    }
    return mesh::find_divide(std::move(soil), threshold);
  }

  struct Step {
    int node;
    double along;  ///< distance along the ground from the start of the walk [m]
    double motion;
  };

  /// Returns the ground from a node in one of its two directions, to its end or to the first node that is not `own`.
  std::vector<Step> walk(int from, std::size_t way, const auto& is_own) const {
    std::vector<Step> steps{{from, 0, find_motion(from)}};
    int before = -1, at = from;
    while (is_own(at) && steps.size() <= ground_.size()) {
      int to = -1;
      for (int n : next_.at(at))
        if (n != before && (before >= 0 || to < 0 || way == 1)) to = n;
      if (to < 0) break;
      steps.push_back({to, steps.back().along + find_distance(place(at), place(to)), find_motion(to)});
      before = at;
      at = to;
    }
    return steps;
  }

  /// Returns the displacement at a distance along the walk, linear between nodes.
  static double find_motion_at(const std::vector<Step>& steps, double along) {
    if (along <= 0) return steps.front().motion;
    for (std::size_t i = 1; i < steps.size(); ++i) {
      if (steps[i].along < along) continue;
      const double share = (along - steps[i - 1].along) / (steps[i].along - steps[i - 1].along);
      return steps[i - 1].motion + share * (steps[i].motion - steps[i - 1].motion);
    }
    return steps.back().motion;
  }

  /// Returns the decrease of the displacement over an element on either side of a point.
  double find_fall(const std::vector<Step>& steps, double along) const {
    return find_motion_at(steps, along - size_) - find_motion_at(steps, along + size_);
  }

  /// Returns where the displacement falls below moving_share of the largest for good. A resting stretch no longer than
  /// the moving one before it is not the end; it occurs below the centre of a rotation.
  std::size_t find_rest(const std::vector<Step>& steps) const {
    const double limit = moving_share * steps[0].motion;
    std::size_t still = 0;
    for (std::size_t i = 1; i < steps.size(); ++i) {
      if (steps[i].motion > limit)
        still = 0;
      else if (still == 0)
        still = i;
      if (still > 0 && steps[i].along > steps[still].along + std::max(bridged * size_, steps[still].along)) break;
    }
    return still > 0 ? still : steps.size() - 1;
  }

  /// Returns the end of the moving ground: where it comes to rest, or farther out where the displacement falls more
  /// steeply than there, as at the scarp of a head that moves less than the toe.
  int find_end(const std::vector<Step>& steps) const {
    const std::size_t rest = find_rest(steps);
    double steepest = 0, at = -1;
    for (const Step& s : steps)
      if (std::abs(s.along - steps[rest].along) <= 2 * size_) steepest = std::max(steepest, find_fall(steps, s.along));
    steepest *= steeper;
    for (std::size_t i = rest; i < steps.size(); ++i)
      if (const double fall = find_fall(steps, steps[i].along); fall > steepest) steepest = fall, at = steps[i].along;
    if (at < 0) return steps[rest].node;
    const double inside = find_motion_at(steps, at - size_), outside = find_motion_at(steps, at + size_),
                 limit = outside + moving_share * (inside - outside);
    for (const Step& s : steps)
      if (s.along > at - size_ && s.motion <= limit) return s.node;
    return steps[rest].node;
  }

  /// Adds the line of the moving ground around a node, from its upper end, if there is one. `way`: direction of the
  /// motion; 0: towards the lower end.
  void add_line(int from, int way, const auto& is_own, std::vector<SlipLine>& lines) {
    if (from < 0) return;
    for (const std::size_t i : {0, 1}) ends_[i] = find_end(walk(from, i, is_own));
    if (ends_[0] == ends_[1]) return;
    Line line = find_way();
    if (line.size() < 3) return;
    line = resample(line);
    draw_to_ridge(line);
    const double across = line.back()[0] - line.front()[0];
    if (way == 0 ? line.front()[1] < line.back()[1] : way * across < 0) std::reverse(line.begin(), line.end());
    fastest_.push_back(find_motion(from));
    lines.push_back({line.back()[0] < line.front()[0] ? -1 : 1, std::move(line)});
  }

  Line find_way() const {
    struct Neighbour {
      int node;
      double cost;
    };
    std::vector<std::vector<Neighbour>> graph(mesh_.nodes.size());
    for (const auto& element : mesh_.elements)
      for (std::size_t i = 0; i < Q::nodes; ++i)
        for (std::size_t j = 0; j < Q::nodes; ++j) {
          const auto a = static_cast<std::size_t>(mesh_.find_original(element[i])),
                     b = static_cast<std::size_t>(mesh_.find_original(element[j]));
          if (a == b) continue;
          const double strain = std::clamp(0.5 * (strain_[a] + strain_[b]), least_share * cap_, cap_) / cap_;
          const double cost = find_distance(mesh_.nodes[a], mesh_.nodes[b]) / (strain * strain);
          graph[a].push_back({static_cast<int>(b), ground_[a] && ground_[b] ? along_ground * cost : cost});
        }
    std::vector<double> best(mesh_.nodes.size(), std::numeric_limits<double>::infinity());
    std::vector<int> from(mesh_.nodes.size(), -1);
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    best[static_cast<std::size_t>(ends_[0])] = 0;
    open.push({0, ends_[0]});
    while (!open.empty()) {
      const auto [cost, node] = open.top();
      open.pop();
      if (cost > best[static_cast<std::size_t>(node)]) continue;
      if (node == ends_[1]) break;
      for (const auto& n : graph[static_cast<std::size_t>(node)]) {
        const double sum = cost + n.cost;
        if (sum >= best[static_cast<std::size_t>(n.node)]) continue;
        best[static_cast<std::size_t>(n.node)] = sum;
        from[static_cast<std::size_t>(n.node)] = node;
        open.push({sum, n.node});
      }
    }
    Line line;
    for (int n = ends_[1]; n >= 0; n = from[static_cast<std::size_t>(n)])
      line.push_back(mesh_.nodes[static_cast<std::size_t>(n)]);
    return line;
  }

  /// Returns points about an element apart.
  Line resample(const Line& line) const {
    std::vector<double> along(1, 0);
    for (std::size_t i = 1; i < line.size(); ++i) along.push_back(along.back() + find_distance(line[i - 1], line[i]));
    const auto count = std::max<std::size_t>(4, static_cast<std::size_t>(along.back() / size_));
    Line r;
    std::size_t k = 1;
    for (std::size_t i = 0; i <= count; ++i) {
      const double s = along.back() * static_cast<double>(i) / static_cast<double>(count);
      while (k + 1 < along.size() && along[k] < s) ++k;
      const double t = (s - along[k - 1]) / (along[k] - along[k - 1]);
      r.push_back(
          {line[k - 1][0] + t * (line[k][0] - line[k - 1][0]), line[k - 1][1] + t * (line[k][1] - line[k - 1][1])});
    }
    r.front() = line.front();
    r.back() = line.back();
    return r;
  }

  /// Moves the inner points across the line to the centroid of the shear strain near them, and smooths.
  void draw_to_ridge(Line& line) const {
    const double radius = reach * size_;
    for (int pass = 0; pass < passes; ++pass) {
      Line moved = line;
      for (std::size_t i = 1; i + 1 < line.size(); ++i) {
        double tx = line[i + 1][0] - line[i - 1][0], ty = line[i + 1][1] - line[i - 1][1];
        const double length = std::hypot(tx, ty);
        if (!(length > 0)) continue;
        tx /= length, ty /= length;
        double sum = 0, across = 0;
        for (std::size_t p = 0; p < shear_.size(); ++p) {
          const double x = mesh_.points[p][0] - line[i][0], y = mesh_.points[p][1] - line[i][1];
          const double near = 1 - (x * x + y * y) / (radius * radius);
          if (near <= 0) continue;
          const double shear = std::min(shear_[p], cap_), w = shear * shear * near * mesh_.weights[p];
          sum += w;
          across += w * (y * tx - x * ty);
        }
        if (sum > 0) moved[i] = {line[i][0] - ty * across / sum, line[i][1] + tx * across / sum};
      }
      for (std::size_t i = 1; i + 1 < line.size(); ++i)
        for (std::size_t d = 0; d < 2; ++d)
          line[i][d] = 0.25 * moved[i - 1][d] + 0.5 * moved[i][d] + 0.25 * moved[i + 1][d];
    }
  }

  const QuadraticMesh<2>& mesh_;
  const SolidState<2>& state_;
  std::vector<std::vector<Vec<2>>> held_;
  std::vector<double> strain_, shear_;  ///< at nodes and at integration points
  std::vector<char> ground_;
  std::map<int, std::vector<int>> next_;  ///< neighbours along the ground
  std::array<int, 2> ends_{-1, -1};
  std::vector<double> fastest_;  ///< displacement of the ground above each line
  double cap_ = 0, size_ = 0;
};

}  // namespace

std::vector<SlipLine> find_slip_lines(const SolidModel<2>& model, const QuadraticMesh<2>& mesh,
                                      const SolidState<2>& motion) {
  return SlipLines(model, mesh, motion).find();
}

}  // namespace talus::fem
