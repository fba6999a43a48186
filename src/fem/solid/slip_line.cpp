// SPDX-License-Identifier: MIT
// The slip line of a failed trial: the cheapest way through the mesh between the two places where the moving ground
// ends, where length costs less the more the soil is sheared; then drawn onto the ridge and smoothed.

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <queue>

#include "fem/solid/system.hpp"

namespace talus::fem {
namespace {

using Point = std::array<double, 2>;
using Line = std::vector<Point>;

constexpr double moving_share = 0.4;    ///< of the largest displacement: the ground that moves
constexpr double band_quantile = 0.97;  ///< of the sheared area; more strain than there counts as much
constexpr double least_share = 1e-3;    ///< of that strain, for soil that is hardly sheared
constexpr double along_ground = 10;     ///< times the cost: the line must not run back along the surface
constexpr int passes = 8;               ///< of drawing onto the ridge
constexpr double reach = 1.5;           ///< of an element, to look for the ridge

double find_distance(const Point& a, const Point& b) {
  return std::hypot(b[0] - a[0], b[1] - a[1]);
}

/// √(2 e:e) of a strain with engineering shear components: the shear of simple shear.
double find_shear(const std::array<double, 6>& s) {
  const double m = (s[0] + s[1] + s[2]) / 3;
  return std::sqrt(2 * ((s[0] - m) * (s[0] - m) + (s[1] - m) * (s[1] - m) + (s[2] - m) * (s[2] - m)) + s[3] * s[3]);
}

class SlipLine {
 public:
  SlipLine(const SolidModel<2>& model, const QuadraticMesh<2>& mesh, const SolidState<2>& state)
      : mesh_(mesh), state_(state), held_(find_held_directions(model, mesh)) {}

  Line find() {
    find_strains();
    if (!(cap_ > 0) || !find_ends()) return {};
    Line line = find_way();
    if (line.size() < 3) return {};
    line = resample(line);
    draw_to_ridge(line);
    if (line.front()[1] < line.back()[1]) std::reverse(line.begin(), line.end());
    return line;
  }

 private:
  using Q = Quadratic<2>;

  /// Shear strain at nodes and points, and the strain that counts as the band.
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

  /// Chains the free surface and walks from its fastest node to where it hardly moves, both ways.
  bool find_ends() {
    std::map<std::array<int, 3>, int> uses;  // half edges: a < b, middle
    for (const auto& element : mesh_.elements)
      for (std::size_t i = 0; i < Q::edges.size(); ++i) {
        const int a = element[Q::edges[i][0]], b = element[Q::edges[i][1]];
        ++uses[{std::min(a, b), std::max(a, b), element[Q::corners + i]}];
      }
    std::map<int, std::vector<int>> next;
    ground_.assign(mesh_.nodes.size(), 0);
    for (const auto& [edge, count] : uses) {
      if (count != 1 || !held_[static_cast<std::size_t>(edge[2])].empty()) continue;
      for (int end : {edge[0], edge[1]}) {
        next[end].push_back(edge[2]);
        next[edge[2]].push_back(end);
      }
      for (int n : edge) ground_[static_cast<std::size_t>(n)] = 1;
    }
    double most = 0;
    int fastest = -1;
    for (std::size_t n = 0; n < ground_.size(); ++n) {
      const double u = norm(state_.displacement[n]);
      if (ground_[n] && u > most) most = u, fastest = static_cast<int>(n);
    }
    if (fastest < 0) return false;
    for (std::size_t way = 0; way < 2; ++way) {
      int before = -1, at = fastest;
      std::size_t steps = 0;
      while (norm(state_.displacement[static_cast<std::size_t>(at)]) > moving_share * most &&
             steps++ < ground_.size()) {
        const auto& list = next[at];
        int to = -1;
        for (int n : list)
          if (n != before && (before >= 0 || to < 0 || way == 1)) to = n;
        if (to < 0) break;
        before = at;
        at = to;
      }
      ends_[way] = at;
    }
    return ends_[0] != ends_[1];
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
          const auto a = static_cast<std::size_t>(element[i]), b = static_cast<std::size_t>(element[j]);
          if (a == b) continue;
          const double strain = std::clamp(0.5 * (strain_[a] + strain_[b]), least_share * cap_, cap_) / cap_;
          const double cost = find_distance(mesh_.nodes[a], mesh_.nodes[b]) / (strain * strain);
          graph[a].push_back({element[j], ground_[a] && ground_[b] ? along_ground * cost : cost});
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

  /// Points about an element apart.
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

  /// Moves the inner points across the line to the middle of the strain near them, and smooths.
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
  std::vector<double> strain_, shear_;  ///< at nodes and at points
  std::vector<char> ground_;
  std::array<int, 2> ends_{-1, -1};
  double cap_ = 0, size_ = 0;
};

}  // namespace

std::vector<std::array<double, 2>> find_slip_line(const SolidModel<2>& model, const QuadraticMesh<2>& mesh,
                                                  const SolidState<2>& state) {
  return SlipLine(model, mesh, state).find();
}

}  // namespace talus::fem
