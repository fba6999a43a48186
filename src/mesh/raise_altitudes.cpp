// SPDX-License-Identifier: MIT
#include "mesh/raise_altitudes.hpp"

#include <algorithm>
#include <cmath>

namespace talus::mesh {
namespace {

/// Elements are worked on below this ratio of altitude to size. The regular simplex has 0.866 (2D) and 0.816 (3D).
template <int D>
constexpr double target = D == 2 ? 0.7 : 0.5;
constexpr int most_sweeps = 30;
constexpr double first_step = 0.2, last_step = 0.01;  ///< of the element size
constexpr double least_gain = 1e-3;                   ///< smaller gains are not worth a step

/// Smallest altitude of a simplex, D V / (largest side) [m]; negative when it is turned inside out.
template <int D>
double measure_altitude(const std::array<std::array<double, D>, D + 1>& x, double orientation) {
  const auto subtract = [](const std::array<double, D>& a, const std::array<double, D>& b) {
    std::array<double, D> c;
    for (int d = 0; d < D; ++d) c[d] = a[d] - b[d];
    return c;
  };
  if constexpr (D == 2) {
    const auto a = subtract(x[1], x[0]), b = subtract(x[2], x[0]), c = subtract(x[2], x[1]);
    const double longest = std::max({a[0] * a[0] + a[1] * a[1], b[0] * b[0] + b[1] * b[1], c[0] * c[0] + c[1] * c[1]});
    return orientation * (a[0] * b[1] - a[1] * b[0]) / std::sqrt(longest);
  } else {
    const auto cross = [](const std::array<double, 3>& a, const std::array<double, 3>& b) {
      return std::array<double, 3>{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    };
    const auto square = [](const std::array<double, 3>& a) { return a[0] * a[0] + a[1] * a[1] + a[2] * a[2]; };
    const auto a = subtract(x[1], x[0]), b = subtract(x[2], x[0]), c = subtract(x[3], x[0]);
    const auto ab = cross(a, b);
    const double largest =
        std::max({square(ab), square(cross(a, c)), square(cross(b, c)), square(cross(subtract(b, a), subtract(c, a)))});
    return orientation * (ab[0] * c[0] + ab[1] * c[1] + ab[2] * c[2]) / std::sqrt(largest);
  }
}

template <int D>
class Smoother {
 public:
  using Point = typename Mesh<D>::Point;

  Smoother(Mesh<D>& mesh, const std::vector<Freedom<D>>& freedoms, const std::function<double(const Point&)>& get_size)
      : mesh_(mesh), freedoms_(freedoms), orientations_(mesh.elements.size(), 1), start_(mesh.nodes.size() + 1, 0) {
    sizes_.reserve(mesh.nodes.size());
    for (const Point& x : mesh.nodes) sizes_.push_back(get_size(x));
    for (int e = 0; e < mesh.element_count(); ++e) {
      if (measure(e) < 0) orientations_[e] = -1;
      for (int node : mesh.elements[e]) ++start_[node + 1];
    }
    for (std::size_t i = 1; i < start_.size(); ++i) start_[i] += start_[i - 1];
    star_.resize(static_cast<std::size_t>(start_.back()));
    std::vector<int> fill(start_.begin(), start_.end() - 1);
    for (int e = 0; e < mesh.element_count(); ++e)
      for (int node : mesh.elements[e]) star_[fill[node]++] = e;
  }

  void run() {
    bool moved = true;
    for (int sweep = 0; moved && sweep < most_sweeps; ++sweep) {
      moved = false;
      for (int node = 0; node < mesh_.node_count(); ++node)
        if (freedoms_[node].count > 0 && measure_star(node) < target<D>) moved = improve(node) || moved;
    }
  }

 private:
  /// Altitude over the mean size wanted at the element's nodes.
  double measure(int e) const {
    std::array<Point, D + 1> x;
    double size = 0;
    for (int k = 0; k <= D; ++k) {
      x[k] = mesh_.nodes[mesh_.elements[e][k]];
      size += sizes_[mesh_.elements[e][k]] / (D + 1);
    }
    return measure_altitude<D>(x, orientations_[e]) / size;
  }

  double measure_star(int node) const {
    double worst = 1;
    for (int i = start_[node]; i < start_[node + 1]; ++i) worst = std::min(worst, measure(star_[i]));
    return worst;
  }

  /// Compass search: the best of the directions, or a shorter step when none is better.
  bool improve(int node) {
    Point& x = mesh_.nodes[node];
    const Freedom<D>& freedom = freedoms_[node];
    double best = measure_star(node);
    bool moved = false;
    for (double step = first_step; step > last_step;) {
      const Point origin = x;
      Point target_place = x;
      double value = best * (1 + least_gain);
      int combinations = 1;
      for (int i = 0; i < freedom.count; ++i) combinations *= 3;
      for (int c = 0; c < combinations; ++c) {
        Point offset{};
        int terms = 0;
        for (int i = 0, rest = c; i < freedom.count; ++i, rest /= 3) {
          const int sign = rest % 3 - 1;
          terms += sign * sign;
          for (int d = 0; d < D; ++d) offset[d] += sign * freedom.directions[i][d];
        }
        if (terms == 0) continue;
        for (int d = 0; d < D; ++d) x[d] = origin[d] + step * sizes_[node] / std::sqrt(terms) * offset[d];
        if (const double tried = measure_star(node); tried > value) {
          value = tried;
          target_place = x;
        }
      }
      x = target_place;
      if (x == origin) {
        step /= 2;
      } else {
        best = value;
        moved = true;
      }
    }
    return moved;
  }

  Mesh<D>& mesh_;
  const std::vector<Freedom<D>>& freedoms_;
  std::vector<double> orientations_;  ///< 1 or -1
  std::vector<double> sizes_;         ///< wanted at each node [m]
  std::vector<int> start_, star_;     ///< the elements around each node
};

}  // namespace

template <int D>
void raise_altitudes(Mesh<D>& mesh, const std::vector<Freedom<D>>& freedoms,
                     const std::function<double(const typename Mesh<D>::Point&)>& get_size) {
  Smoother<D>(mesh, freedoms, get_size).run();
}

template void raise_altitudes<2>(Mesh<2>&, const std::vector<Freedom<2>>&,
                                 const std::function<double(const Mesh<2>::Point&)>&);
template void raise_altitudes<3>(Mesh<3>&, const std::vector<Freedom<3>>&,
                                 const std::function<double(const Mesh<3>::Point&)>&);

}  // namespace talus::mesh
