// SPDX-License-Identifier: MIT
// Unknowns, pattern and assembly of the equations of equilibrium.
#include "fem/solid/system.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "fem/solid/known_springs.hpp"
#include "material/every_law.hpp"

namespace talus::fem {

// Assembly. Elements are computed in parallel in batches and added in their order, so that the sums are bitwise
// identical for any number of threads.

namespace {

constexpr std::size_t elements_per_piece = 32;

/// The two axes of each shear component, in the order of the stress.
constexpr std::array<std::array<std::size_t, 2>, 3> shears{{{0, 1}, {1, 2}, {2, 0}}};

/// Calls f(a, axis, strain, gradient component) for each entry of B of a node.
template <int D, class F>
void for_strain(const Vec<D>& g, F&& f) {
  for (std::size_t d = 0; d < D; ++d) f(d, d, g[d]);
  for (std::size_t s = 0; s < (D == 2 ? 1 : 3); ++s) {
    const auto [a, b] = shears[s];
    f(a, s + 3, g[b]);
    f(b, s + 3, g[a]);
  }
}

/// Adds w Bᵀ C B of an integration point to the matrix of its element.
template <int D>
void add_stiffness(const std::array<Vec<D>, Quadratic<D>::nodes>& g,
                   const std::array<double, Quadratic<D>::strains * Quadratic<D>::strains>& c, double w,
                   double* matrix) {
  constexpr std::size_t n = SolidSystem<D>::locals, ns = Quadratic<D>::strains;
  std::array<std::array<double, n>, ns> cb{};  // w C B
  for (std::size_t b = 0; b < Quadratic<D>::nodes; ++b)
    for_strain<D>(g[b], [&](std::size_t axis, std::size_t s, double v) {
      for (std::size_t t = 0; t < ns; ++t) cb[t][b * D + axis] += w * v * c[t * ns + s];
    });
  for (std::size_t a = 0; a < Quadratic<D>::nodes; ++a)
    for_strain<D>(g[a], [&](std::size_t axis, std::size_t s, double v) {
      double* row = matrix + (a * D + axis) * n;
      for (std::size_t j = 0; j < n; ++j) row[j] += v * cb[s][j];
    });
}

/// Adds the tangent of a spring to the global matrix.
void add_spring(const Spring& spring, double tangent, std::vector<double>& matrix) {
  const std::size_t count = spring.unknown.size();
  if (tangent == 0) return;
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 0; j < count; ++j)
      matrix[static_cast<std::size_t>(spring.slots[i * count + j])] +=
          spring.weight * tangent * spring.rate[i] * spring.rate[j];
}

void add_joint(const Joint& joint, const std::array<double, 4>& tangent, std::vector<double>& matrix) {
  const std::size_t count = joint.unknown.size();
  for (std::size_t i = 0; i < count; ++i) {
    const double by_opening = joint.opening[i] * tangent[0] + joint.slip[i] * tangent[2],
                 by_slip = joint.opening[i] * tangent[1] + joint.slip[i] * tangent[3];
    for (std::size_t j = 0; j < count; ++j)
      matrix[static_cast<std::size_t>(joint.slots[i * count + j])] +=
          joint.weight * (by_opening * joint.opening[j] + by_slip * joint.slip[j]);
  }
}

}  // namespace

template <int D>
struct SolidAssembly<D>::Element {
  static constexpr std::size_t n = SolidSystem<D>::locals;
  std::array<double, n> force;
  std::array<double, n * n> matrix;
  bool symmetric;
  int yielding;
};

template <int D>
SolidAssembly<D>::SolidAssembly(const SolidSystem<D>& system, std::vector<material::Law> laws, int threads,
                                const SpringStage& stage)
    : system_(system), laws_(std::move(laws)), threads_(threads > 0 ? threads : default_threads()), stage_(stage) {
  for (const auto& law : laws_) state_size_ = std::max(state_size_, material::state_size(law));
}

template <int D>
SolidAssembly<D>::~SolidAssembly() = default;

template <int D>
const material::Law& SolidAssembly<D>::get_law(std::size_t k) const {
  return laws_[static_cast<std::size_t>(system_.region(k))];
}

template <int D>
SolidState<D> SolidAssembly<D>::make_start() const {
  SolidState<D> s;
  const auto& mesh = system_.mesh;
  const std::size_t points = mesh.points.size(), size = static_cast<std::size_t>(state_size_);
  s.displacement.assign(mesh.nodes.size(), Vec<D>{});
  s.stress.assign(points, {});
  s.strain.assign(points, {});
  s.yields.assign(points, 0);
  s.state.assign(points * size, 0);
  s.bars.assign(system_.springs.list.size(), 0);
  for (const Joint& joint : system_.springs.joints) {
    s.bars.push_back(-joint.compression / joint.normal_stiffness);
    s.bars.push_back(0);
  }
  read_known_springs(system_.springs, system_.model.known_springs, s.bars);
  for (std::size_t p = 0; p < points; ++p) {
    const std::size_t k = p / Quadratic<D>::points;
    if (!system_.model.point_stress.empty())
      s.stress[p] = system_.model.point_stress[static_cast<std::size_t>(mesh.linear_element[k]) * Quadratic<D>::points +
                                               p % Quadratic<D>::points];
    else if (!system_.model.initial_stress.empty())
      s.stress[p] = system_.model.initial_stress[static_cast<std::size_t>(mesh.linear_element[k])];
    if (system_.model.set_state) system_.model.set_state(system_.region(k), mesh.points[p], &s.state[p * size]);
  }
  return s;
}

template <int D>
void SolidAssembly<D>::evaluate_element(std::size_t k, const SolidState<D>& start, const std::vector<Vec<D>>& u,
                                        bool with_matrix, SolidState<D>& end, Element& sum) const {
  using Q = Quadratic<D>;
  constexpr std::size_t ns = Q::strains;
  sum.force.fill(0);
  if (with_matrix) sum.matrix.fill(0);
  sum.symmetric = true;
  sum.yielding = 0;
  const auto& model = system_.model;
  const auto& nodes = system_.mesh.elements[k];
  const auto& law = laws_[static_cast<std::size_t>(system_.region(k))];
  const double saturation =
      model.saturation.empty() ? 1 : model.saturation[static_cast<std::size_t>(system_.mesh.linear_element[k])];
  const std::size_t size = static_cast<std::size_t>(state_size_);
  for (std::size_t q = 0; q < Q::points; ++q) {
    const std::size_t p = k * Q::points + q;
    const auto g = find_gradients<D>(find_barycentric<D>(q), system_.gradients[k]);
    std::array<double, ns> d{};
    for (std::size_t a = 0; a < Q::nodes; ++a) {
      const auto& ua = u[static_cast<std::size_t>(nodes[a])];
      for_strain<D>(g[a], [&](std::size_t axis, std::size_t s, double v) { d[s] += v * ua[axis]; });
    }
    std::array<double, ns * ns> c;
    end.stress[p] = start.stress[p];
    std::copy_n(&start.state[p * size], size, &end.state[p * size]);
    const PointAnswer answer = update_point<static_cast<int>(ns)>(
        law, saturation, d.data(), end.stress[p].data(), &end.state[p * size], with_matrix ? c.data() : nullptr);
    end.yields[p] = start.yields[p] || answer.yields;
    sum.yielding += answer.yields;
    sum.symmetric = sum.symmetric && answer.symmetric;
    end.strain[p] = start.strain[p];
    for (std::size_t s = 0; s < ns; ++s) end.strain[p][s] += d[s];
    const double w = system_.mesh.weights[p];
    std::array<double, ns> total;
    for (std::size_t s = 0; s < ns; ++s) total[s] = w * (end.stress[p][s] + (s < 3 ? system_.pore[k][q] : 0));
    for (std::size_t a = 0; a < Q::nodes; ++a)
      for_strain<D>(g[a], [&](std::size_t axis, std::size_t s, double v) { sum.force[a * D + axis] += v * total[s]; });
    if (!with_matrix) continue;
    add_stiffness<D>(g, c, w, sum.matrix.data());
  }
  if (system_.turned[k]) turn(k, with_matrix, sum);
}

/// Transforms the sums of an element from coordinate axes to the axes of the nodes.
template <int D>
void SolidAssembly<D>::turn(std::size_t k, bool with_matrix, Element& sum) const {
  constexpr std::size_t n = Element::n;
  for (std::size_t a = 0; a < Quadratic<D>::nodes; ++a) {
    const auto& node = system_.nodes[static_cast<std::size_t>(system_.mesh.elements[k][a])];
    if (!node.turned) continue;
    const auto turn_triple = [&](auto&& at) {
      Vec<D> old, now{};
      for (std::size_t d = 0; d < D; ++d) old[d] = at(d);
      for (std::size_t i = 0; i < D; ++i) now[i] = dot(node.axes[i], old);
      for (std::size_t d = 0; d < D; ++d) at(d) = now[d];
    };
    turn_triple([&](std::size_t d) -> double& { return sum.force[a * D + d]; });
    if (!with_matrix) continue;
    for (std::size_t j = 0; j < n; ++j)
      turn_triple([&](std::size_t d) -> double& { return sum.matrix[(a * D + d) * n + j]; });
    for (std::size_t i = 0; i < n; ++i)
      turn_triple([&](std::size_t d) -> double& { return sum.matrix[i * n + a * D + d]; });
  }
}

template <int D>
void SolidAssembly<D>::add(std::size_t k, const Element& sum, bool with_matrix, SolidSums& sums) const {
  for (std::size_t a = 0; a < Quadratic<D>::nodes; ++a) {
    const auto& node = system_.nodes[static_cast<std::size_t>(system_.mesh.elements[k][a])];
    for (std::size_t d = 0; d < D; ++d)
      if (node.unknown[d] >= 0) sums.force[static_cast<std::size_t>(node.unknown[d])] += sum.force[a * D + d];
  }
  sums.symmetric = sums.symmetric && sum.symmetric;
  sums.yielding += sum.yielding;
  if (!with_matrix) return;
  const auto& slots = system_.slots[k];
  for (std::size_t i = 0; i < slots.size(); ++i)
    if (slots[i] >= 0) sums.matrix[static_cast<std::size_t>(slots[i])] += sum.matrix[i];
}

template <int D>
template <class Work>
void SolidAssembly<D>::for_batches(bool with_matrix, Work&& work, SolidSums& sums) const {
  sums.force.assign(static_cast<std::size_t>(system_.unknowns), 0);
  if (with_matrix) sums.matrix.assign(system_.row.size(), 0);
  sums.symmetric = true;
  sums.yielding = 0;
  const std::size_t count = system_.mesh.elements.size();
  const std::size_t batch = elements_per_piece * static_cast<std::size_t>(std::max(threads_, 1));
  std::vector<Element> buffer(std::min(batch, count));
  for (std::size_t from = 0; from < count; from += batch) {
    const std::size_t to = std::min(count, from + batch);
    const auto pieces = static_cast<int>((to - from + elements_per_piece - 1) / elements_per_piece);
    parallel_for(pieces, threads_, [&](int piece) {
      const std::size_t first = from + static_cast<std::size_t>(piece) * elements_per_piece;
      for (std::size_t k = first; k < std::min(to, first + elements_per_piece); ++k) work(k, buffer[k - from]);
    });
    for (std::size_t k = from; k < to; ++k) add(k, buffer[k - from], with_matrix, sums);
  }
}

template <int D>
void SolidAssembly<D>::evaluate_springs(const SolidState<D>& start, const std::vector<double>& q, bool with_matrix,
                                        SolidState<D>& end, SolidSums& sums) const {
  const auto& list = system_.springs.list;
  end.bars.resize(list.size() + 2 * system_.springs.joints.size());
  for (std::size_t s = 0; s < list.size(); ++s) {
    const Spring& spring = list[s];
    const std::size_t count = spring.unknown.size();
    double deformation = 0;
    for (std::size_t i = 0; i < count; ++i)
      deformation += spring.rate[i] * q[static_cast<std::size_t>(spring.unknown[i])];
    const SpringAnswer answer = update_spring(spring, stage_, start.bars[s], deformation);
    end.bars[s] = answer.elastic;
    // A spring without tangent makes the matrix singular unless viscosity is added, as does yielding soil.
    sums.yielding += answer.tangent == 0;
    for (std::size_t i = 0; i < count; ++i)
      sums.force[static_cast<std::size_t>(spring.unknown[i])] += spring.weight * answer.force * spring.rate[i];
    if (with_matrix) add_spring(spring, answer.tangent, sums.matrix);
  }
  for (std::size_t s = 0; s < system_.springs.joints.size(); ++s) {
    const Joint& joint = system_.springs.joints[s];
    const std::size_t place = list.size() + 2 * s;
    std::array<double, 2> deformation{};
    for (std::size_t i = 0; i < joint.unknown.size(); ++i) {
      deformation[0] += joint.opening[i] * q[static_cast<std::size_t>(joint.unknown[i])];
      deformation[1] += joint.slip[i] * q[static_cast<std::size_t>(joint.unknown[i])];
    }
    const JointAnswer answer = update_joint(joint, stage_, {start.bars[place], start.bars[place + 1]}, deformation);
    end.bars[place] = answer.elastic[0];
    end.bars[place + 1] = answer.elastic[1];
    sums.yielding += answer.yields;
    sums.symmetric = sums.symmetric && answer.tangent[1] == answer.tangent[2];
    for (std::size_t i = 0; i < joint.unknown.size(); ++i)
      sums.force[static_cast<std::size_t>(joint.unknown[i])] +=
          joint.weight * (joint.opening[i] * answer.force[0] + joint.slip[i] * answer.force[1]);
    if (with_matrix) add_joint(joint, answer.tangent, sums.matrix);
  }
}

template <int D>
void SolidAssembly<D>::evaluate(const SolidState<D>& start, const std::vector<double>& q, bool with_matrix,
                                SolidState<D>& end, SolidSums& sums) const {
  std::vector<Vec<D>> u;
  system_.to_nodes(q, u);
  end.stress.resize(start.stress.size());
  end.strain.resize(start.strain.size());
  end.state.resize(start.state.size());
  end.yields.resize(start.yields.size());
  end.displacement.resize(start.displacement.size());
  for (std::size_t n = 0; n < u.size(); ++n)
    for (std::size_t d = 0; d < D; ++d) end.displacement[n][d] = start.displacement[n][d] + u[n][d];
  for_batches(
      with_matrix, [&](std::size_t k, Element& sum) { evaluate_element(k, start, u, with_matrix, end, sum); }, sums);
  evaluate_springs(start, q, with_matrix, end, sums);
  throw_failure();
}

template <int D>
void SolidAssembly<D>::find_elastic_matrix(const SolidState<D>& at, std::vector<double>& matrix) const {
  using Q = Quadratic<D>;
  constexpr std::size_t ns = Q::strains;
  SolidSums sums;
  const std::size_t size = static_cast<std::size_t>(state_size_);
  for_batches(
      true,
      [&](std::size_t k, Element& sum) {
        sum.force.fill(0);
        sum.matrix.fill(0);
        sum.symmetric = true;
        sum.yielding = 0;
        for (std::size_t q = 0; q < Q::points; ++q) {
          const std::size_t p = k * Q::points + q;
          const auto g = find_gradients<D>(find_barycentric<D>(q), system_.gradients[k]);
          std::array<double, ns * ns> c;
          find_elastic_stiffness<static_cast<int>(ns)>(laws_[static_cast<std::size_t>(system_.region(k))],
                                                       at.stress[p].data(), &at.state[p * size], c.data());
          add_stiffness<D>(g, c, system_.mesh.weights[p], sum.matrix.data());
        }
        if (system_.turned[k]) turn(k, true, sum);
      },
      sums);
  for (const Spring& spring : system_.springs.list) add_spring(spring, spring.stiffness, sums.matrix);
  for (const Joint& joint : system_.springs.joints)
    add_joint(joint, {joint.normal_stiffness, 0, 0, joint.tangential_stiffness}, sums.matrix);
  matrix = std::move(sums.matrix);
}

template <int D>
void SolidAssembly<D>::throw_failure() const {
  for (const auto& law : laws_)
    if (const auto failure = material::take_failure(law)) throw Error(ExitCode::unstable, failure->describe(""));
}

template class SolidAssembly<2>;
template class SolidAssembly<3>;

namespace {

/// Completes the axes, of which the first ones are fixed, to an orthonormal basis.
template <int D>
void complete(std::vector<Vec<D>>& axes) {
  for (std::size_t d = 0; axes.size() < D && d < D; ++d) {
    // the coordinate axis with the smallest component in the span of the given ones
    std::size_t best = 0;
    double least = 2;
    for (std::size_t c = 0; c < D; ++c) {
      double along = 0;
      for (const auto& a : axes) along += a[c] * a[c];
      if (along < least - 1e-9) least = along, best = c;
    }
    Vec<D> v{};
    v[best] = 1;
    for (const auto& a : axes) {
      const double along = a[best];
      for (std::size_t c = 0; c < D; ++c) v[c] -= along * a[c];
    }
    const double length = norm(v);
    for (double& x : v) x /= length;
    axes.push_back(v);
  }
}

template <int D>
bool is_along_axes(const std::vector<Vec<D>>& held) {
  for (const auto& h : held)
    for (double x : h)
      if (std::abs(x) > 1e-9 && std::abs(x) < 1 - 1e-9) return false;
  return true;
}

}  // namespace

template <int D>
SolidSystem<D>::SolidSystem(const SolidModel<D>& m) : model(m), mesh(make_quadratic(*m.mesh, list_cuts(m))) {
  const auto held = find_held_directions(model, mesh);
  nodes.resize(mesh.nodes.size());
  std::vector<char> has_soil(mesh.nodes.size(), 0);
  for (const auto& element : mesh.elements)
    for (int n : element) has_soil[static_cast<std::size_t>(n)] = 1;
  bool supported = false;
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    auto& node = nodes[n];
    node.unknown.fill(-1);
    for (std::size_t d = 0; d < D; ++d) node.axes[d] = Vec<D>{}, node.axes[d][d] = 1;
    supported = supported || !held[n].empty();
    if (!has_soil[n]) continue;
    std::array<bool, D> fixed{};
    if (is_along_axes<D>(held[n])) {
      for (const auto& h : held[n])
        for (std::size_t d = 0; d < D; ++d) fixed[d] = fixed[d] || std::abs(h[d]) > 0.5;
    } else {
      node.turned = true;
      auto axes = held[n];
      complete<D>(axes);
      std::copy(axes.begin(), axes.end(), node.axes.begin());
      for (std::size_t d = 0; d < held[n].size(); ++d) fixed[d] = true;
    }
    for (std::size_t d = 0; d < D; ++d)
      if (!fixed[d]) node.unknown[d] = unknowns++;
  }
  if (!supported) fail_input("no side of the soil is fixed: FEM needs a support for equilibrium");
  if (unknowns == 0) fail_input("every node of the soil is fixed: FEM has no unknown displacement");

  gradients.resize(mesh.elements.size());
  pore.assign(mesh.elements.size(), {});
  turned.assign(mesh.elements.size(), 0);
  for (std::size_t k = 0; k < mesh.elements.size(); ++k) {
    std::array<Vec<D>, D + 1> x;
    for (std::size_t i = 0; i < Q::corners; ++i) x[i] = mesh.nodes[static_cast<std::size_t>(mesh.elements[k][i])];
    find_simplex<D>(x, gradients[k]);
    for (int n : mesh.elements[k])
      if (nodes[static_cast<std::size_t>(n)].turned) turned[k] = 1;
    if (model.pore_stress.empty()) continue;
    const auto& p = model.pore_stress[static_cast<std::size_t>(mesh.linear_element[k])];
    for (std::size_t q = 0; q < Q::points; ++q) {
      const auto l = find_barycentric<D>(q);
      for (std::size_t i = 0; i < Q::corners; ++i) pore[k][q] += l[i] * p[i];
    }
  }
  if constexpr (D == 2) {
    springs = make_springs(model.bars, mesh, nodes, unknowns);
    if (!model.walls.empty()) add_walls(model, mesh, nodes, unknowns, springs);
  }
  unknowns += springs.unknowns;
  to_unknowns(find_loads(model, mesh), load);
  for (const auto& [unknown, force] : springs.loads) load[static_cast<std::size_t>(unknown)] += force;
  make_pattern();
}

/// Builds the pattern of the matrix, in which all unknowns of an element or of a spring are coupled.
template <int D>
void SolidSystem<D>::make_pattern() {
  const auto list_unknowns = [&](std::size_t k) {
    std::array<int, locals> list;
    for (std::size_t i = 0; i < Q::nodes; ++i)
      for (std::size_t d = 0; d < D; ++d)
        list[i * D + d] = nodes[static_cast<std::size_t>(mesh.elements[k][i])].unknown[d];
    return list;
  };
  std::vector<std::vector<int>> columns(static_cast<std::size_t>(unknowns));
  for (std::size_t k = 0; k < mesh.elements.size(); ++k) {
    const auto list = list_unknowns(k);
    for (int j : list)
      if (j >= 0)
        for (int i : list)
          if (i >= 0) columns[static_cast<std::size_t>(j)].push_back(i);
  }
  const auto couple = [&](const std::vector<int>& list) {
    for (const int j : list) {
      auto& column = columns[static_cast<std::size_t>(j)];
      column.insert(column.end(), list.begin(), list.end());
    }
  };
  for (const Spring& spring : springs.list) couple(spring.unknown);
  for (const Joint& joint : springs.joints) couple(joint.unknown);
  column_start.assign(1, 0);
  for (auto& column : columns) {
    std::sort(column.begin(), column.end());
    column.erase(std::unique(column.begin(), column.end()), column.end());
    row.insert(row.end(), column.begin(), column.end());
    column_start.push_back(static_cast<int>(row.size()));
  }
  const auto find_slot = [&](int i, int j) {
    const auto begin = row.begin() + column_start[static_cast<std::size_t>(j)],
               end = row.begin() + column_start[static_cast<std::size_t>(j) + 1];
    return static_cast<int>(std::lower_bound(begin, end, i) - row.begin());
  };
  for (Spring& spring : springs.list)
    for (int i : spring.unknown)
      for (int j : spring.unknown) spring.slots.push_back(find_slot(i, j));
  for (Joint& joint : springs.joints)
    for (int i : joint.unknown)
      for (int j : joint.unknown) joint.slots.push_back(find_slot(i, j));
  slots.resize(mesh.elements.size());
  for (std::size_t k = 0; k < mesh.elements.size(); ++k) {
    const auto list = list_unknowns(k);
    for (std::size_t b = 0; b < locals; ++b) {
      for (std::size_t a = 0; a < locals; ++a) {
        int& slot = slots[k][a * locals + b];
        slot = -1;
        if (list[a] >= 0 && list[b] >= 0) slot = find_slot(list[a], list[b]);
      }
    }
  }
}

template <int D>
void SolidSystem<D>::to_nodes(const std::vector<double>& q, std::vector<Vec<D>>& u) const {
  u.assign(nodes.size(), Vec<D>{});
  for (std::size_t n = 0; n < nodes.size(); ++n)
    for (std::size_t k = 0; k < D; ++k)
      if (nodes[n].unknown[k] >= 0)
        for (std::size_t d = 0; d < D; ++d)
          u[n][d] += nodes[n].axes[k][d] * q[static_cast<std::size_t>(nodes[n].unknown[k])];
}

template <int D>
void SolidSystem<D>::to_unknowns(const std::vector<Vec<D>>& f, std::vector<double>& q) const {
  q.assign(static_cast<std::size_t>(unknowns), 0);
  for (std::size_t n = 0; n < nodes.size(); ++n)
    for (std::size_t k = 0; k < D; ++k)
      if (nodes[n].unknown[k] >= 0) q[static_cast<std::size_t>(nodes[n].unknown[k])] = dot(nodes[n].axes[k], f[n]);
}

template struct SolidSystem<2>;
template struct SolidSystem<3>;

}  // namespace talus::fem
