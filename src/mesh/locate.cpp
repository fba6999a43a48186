// SPDX-License-Identifier: MIT
#include "mesh/locate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/error.hpp"
#include "base/parallel.hpp"

namespace talus::mesh {

namespace {

/// One side as part of one element.
template <int D>
struct HalfSide {
  std::array<int, D - 1> others;  ///< nodes of the side except the lowest, ascending
  int element;
  int opposite;  ///< local node opposite the side
};

/// Returns the nodes of the side of `element` opposite local node `k`, ascending.
template <int D>
std::array<int, D> sort_side(const typename Mesh<D>::Element& element, int k) {
  std::array<int, D> side;
  for (int i = 0, j = 0; i <= D; ++i)
    if (i != k) side[j++] = element[i];
  std::sort(side.begin(), side.end());
  return side;
}

}  // namespace

template <int D>
std::vector<typename Mesh<D>::Element> find_neighbours(const Mesh<D>& mesh) {
  // Counting sort by the lowest node: about two dozen half sides per node in 3D, four in 2D.
  std::vector<int> start(mesh.nodes.size() + 1, 0);
  for (const auto& element : mesh.elements)
    for (int k = 0; k <= D; ++k) ++start[sort_side<D>(element, k)[0] + 1];
  for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
  std::vector<HalfSide<D>> halves(mesh.elements.size() * (D + 1));
  std::vector<int> fill(start.begin(), start.end() - 1);
  for (int e = 0; e < mesh.element_count(); ++e)
    for (int k = 0; k <= D; ++k) {
      const auto side = sort_side<D>(mesh.elements[e], k);
      HalfSide<D>& half = halves[fill[side[0]]++];
      std::copy(side.begin() + 1, side.end(), half.others.begin());
      half.element = e;
      half.opposite = k;
    }

  std::vector<typename Mesh<D>::Element> neighbours(mesh.elements.size());
  for (auto& n : neighbours) n.fill(-1);
  for (std::size_t node = 0; node + 1 < start.size(); ++node) {
    const auto begin = halves.begin() + start[node], end = halves.begin() + start[node + 1];
    std::sort(begin, end, [](const HalfSide<D>& a, const HalfSide<D>& b) {
      return a.others != b.others ? a.others < b.others : a.element < b.element;
    });
    for (auto a = begin; a != end;) {
      auto b = a + 1;
      while (b != end && b->others == a->others) ++b;
      if (b - a > 2)
        fail_input("{} elements of the mesh share the side between nodes {} and {}: elements overlap", b - a, node,
                   a->others[0]);
      if (b - a == 2) {
        neighbours[a->element][a->opposite] = (a + 1)->element;
        neighbours[(a + 1)->element][(a + 1)->opposite] = a->element;
      }
      a = b;
    }
  }
  return neighbours;
}

template std::vector<Mesh<2>::Element> find_neighbours<2>(const Mesh<2>&);
template std::vector<Mesh<3>::Element> find_neighbours<3>(const Mesh<3>&);

namespace {

/// The local node with the smallest shape function at a point, and its value.
template <int D>
struct Lowest {
  int node = 0;
  double value = 1;
};

template <int D>
Lowest<D> find_lowest(const Mesh<D>& mesh, int e, const typename Mesh<D>::Point& x) {
  const auto xi = to_local(mesh, e, x);
  Lowest<D> lowest;
  for (double value : xi) lowest.value -= value;
  for (int k = 0; k < D; ++k)
    if (xi[k] < lowest.value) lowest = {k + 1, xi[k]};
  return lowest;
}

}  // namespace

template <int D>
int find_element(const Mesh<D>& mesh, const typename Mesh<D>::Point& x, int start) {
  const int count = mesh.element_count();
  int e = start >= 0 && start < count ? start : 0;
  for (int step = 0; step < count; ++step) {
    const auto lowest = find_lowest(mesh, e, x);
    if (lowest.value >= -inside_tolerance) return e;
    const int next = mesh.neighbours[e][lowest.node];
    if (next < 0) break;
    e = next;
  }
  for (e = 0; e < count; ++e)
    if (find_lowest(mesh, e, x).value >= -inside_tolerance) return e;
  return -1;
}

template int find_element<2>(const Mesh<2>&, const std::array<double, 2>&, int);
template int find_element<3>(const Mesh<3>&, const std::array<double, 3>&, int);

namespace {

/// Two sides crossed within this fraction of an element count as crossed together: the line hits an edge or a node.
constexpr double tie_tolerance = 1e-11;
/// Shift of a degenerate line as a fraction of the distance to the element's centroid.
constexpr double nudge = 1e-9;
constexpr int most_nudges = 6;
constexpr std::size_t points_per_piece = 4096;

/// Integrates along lines of one direction through a mesh.
template <int D>
class Walker {
 public:
  using Point = typename Mesh<D>::Point;

  Walker(const Mesh<D>& mesh, const std::vector<double>& weight, const Point& up)
      : mesh_(mesh), weight_(weight), up_(up), rates_(mesh.elements.size()) {
    for (int e = 0; e < mesh.element_count(); ++e) {
      rates_[e].fill(0);
      for (int k = 0; k < D; ++k)
        for (int d = 0; d < D; ++d) {
          rates_[e][k + 1] += mesh.gradients[e][k * D + d] * up[d];
          rates_[e][0] -= mesh.gradients[e][k * D + d] * up[d];
        }
      double top = std::numeric_limits<double>::lowest();
      for (int node : mesh.elements[e]) top = std::max(top, height(mesh.nodes[node]));
      mesh_top_ = std::max(mesh_top_, top);
      if (weight[e] != 0) weight_top_ = std::max(weight_top_, top);
      for (int k = 0; k <= D; ++k)  // the line enters where N_k increases along it
        if (mesh.neighbours[e][k] < 0 && rates_[e][k] > parallel(e)) entries_.push_back({e, k});
    }
  }

  double integrate(const LocalPoint<D>& point) const {
    const Point start = to_global(mesh_, point.element, point.xi);
    Point centroid_xi;
    centroid_xi.fill(1.0 / (D + 1));
    const Point centroid = to_global(mesh_, point.element, centroid_xi);
    for (int attempt = 0; attempt <= most_nudges; ++attempt) {
      // Different factors per axis, so that symmetry does not lead to another edge.
      Point from = start;
      for (int d = 0; d < D; ++d) from[d] += attempt * nudge * (1 + 0.37 * d) * (centroid[d] - start[d]);
      if (attempt > 1)  // the centroid is straight above: shift sideways within the element
        for (int d = 0; d < D; ++d)
          from[d] += attempt * nudge * (mesh_.nodes[mesh_.elements[point.element][attempt % (D + 1)]][d] - start[d]);
      if (const auto sum = walk(point.element, from, attempt == most_nudges)) return *sum;
    }
    return 0;  // not reached: the last attempt always returns a value
  }

 private:
  struct Entry {
    int element;
    int opposite;
  };

  double height(const Point& x) const {
    double h = 0;
    for (int d = 0; d < D; ++d) h += x[d] * up_[d];
    return h;
  }

  /// Rates below this value belong to sides parallel to the line.
  double parallel(int e) const { return 1e-12 / mesh_.altitudes[e]; }

  /// Returns the integral; std::nullopt if the line meets a node or an edge. With `accept` the line continues
  /// through such points.
  std::optional<double> walk(int e, const Point& from, bool accept) const {
    const double start_height = height(from), end = weight_top_ - start_height;
    double sum = 0, s = 0;
    for (int step = 0; s < end && step <= 2 * mesh_.element_count(); ++step) {
      const Exit exit = find_exit(e, from);
      if (exit.tied && !accept) return std::nullopt;
      if (exit.distance > s) {
        sum += weight_[e] * (exit.distance - s);
        s = exit.distance;
      }
      const int next = exit.node < 0 ? -1 : mesh_.neighbours[e][exit.node];
      if (next >= 0) {
        e = next;
        continue;
      }
      if (start_height + s >= mesh_top_ - mesh_.altitudes[e] * 1e-9) break;
      if (!enter_again(from, e, s)) break;
    }
    return sum;
  }

  struct Exit {
    int node = -1;  ///< opposite the side through which the line exits
    double distance = std::numeric_limits<double>::infinity();
    bool tied = false;
  };

  /// Returns the exit of the line through `from` from element `e`: the side whose N_k(s) = N_k + s ∇N_k·up reaches zero
  /// first.
  Exit find_exit(int e, const Point& from) const {
    const auto xi = to_local(mesh_, e, from);
    double value[D + 1];
    value[0] = 1;
    for (int k = 0; k < D; ++k) {
      value[k + 1] = xi[k];
      value[0] -= xi[k];
    }
    Exit exit;
    double second = exit.distance;
    for (int k = 0; k <= D; ++k) {
      if (rates_[e][k] >= -parallel(e)) {
        // The line lies in this side, so rounding decides to which element it belongs.
        if (rates_[e][k] <= parallel(e) && std::abs(value[k]) < tie_tolerance) exit.tied = true;
        continue;
      }
      const double distance = value[k] / -rates_[e][k];
      if (distance < exit.distance) {
        second = exit.distance;
        exit.distance = distance;
        exit.node = k;
      } else {
        second = std::min(second, distance);
      }
    }
    if (second - exit.distance < tie_tolerance * mesh_.altitudes[e]) exit.tied = true;
    return exit;
  }

  /// Continues a line that left the mesh in the nearest element above; returns false if there is none.
  bool enter_again(const Point& from, int& e, double& s) const {
    int best = -1;
    double nearest = std::numeric_limits<double>::infinity();
    for (const Entry& entry : entries_) {
      const auto xi = to_local(mesh_, entry.element, from);
      double value[D + 1];
      value[0] = 1;
      for (int k = 0; k < D; ++k) {
        value[k + 1] = xi[k];
        value[0] -= xi[k];
      }
      const auto& rates = rates_[entry.element];
      const double distance = -value[entry.opposite] / rates[entry.opposite];
      if (distance < s - tie_tolerance * mesh_.altitudes[entry.element] || distance >= nearest) continue;
      bool inside = true;
      for (int k = 0; k <= D; ++k) inside = inside && value[k] + distance * rates[k] >= -inside_tolerance;
      if (inside) {
        nearest = distance;
        best = entry.element;
      }
    }
    if (best < 0) return false;
    e = best;
    s = std::max(s, nearest);
    return true;
  }

  const Mesh<D>& mesh_;
  const std::vector<double>& weight_;
  const Point up_;
  std::vector<std::array<double, D + 1>> rates_;               ///< ∇N_k·up [1/m]
  std::vector<Entry> entries_;                                 ///< boundary sides through which lines enter the mesh
  double mesh_top_ = std::numeric_limits<double>::lowest();    ///< greatest height of the mesh [m]
  double weight_top_ = std::numeric_limits<double>::lowest();  ///< greatest height of an element with weight [m]
};

}  // namespace

template <int D>
std::vector<double> overburden_integral(const Mesh<D>& mesh, const std::vector<double>& element_weight,
                                        const std::vector<LocalPoint<D>>& points, const typename Mesh<D>::Point& up,
                                        int threads) {
  if (element_weight.size() != mesh.elements.size())
    throw Error(ExitCode::internal_error, "overburden: {} weights for {} elements", element_weight.size(),
                mesh.elements.size());
  const Walker<D> walker(mesh, element_weight, up);
  std::vector<double> integrals(points.size());
  const std::size_t pieces = (points.size() + points_per_piece - 1) / points_per_piece;
  parallel_for(static_cast<int>(pieces), threads, [&](int piece) {
    const std::size_t begin = static_cast<std::size_t>(piece) * points_per_piece;
    const std::size_t end = std::min(points.size(), begin + points_per_piece);
    for (std::size_t p = begin; p < end; ++p) integrals[p] = walker.integrate(points[p]);
  });
  return integrals;
}

template std::vector<double> overburden_integral<2>(const Mesh<2>&, const std::vector<double>&,
                                                    const std::vector<LocalPoint<2>>&, const Mesh<2>::Point&, int);
template std::vector<double> overburden_integral<3>(const Mesh<3>&, const std::vector<double>&,
                                                    const std::vector<LocalPoint<3>>&, const Mesh<3>::Point&, int);

}  // namespace talus::mesh
