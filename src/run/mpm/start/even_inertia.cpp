// SPDX-License-Identifier: MIT
#include "run/mpm/start/even_inertia.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "mpm/body/observe.hpp"
#include "run/mpm/start/stand_in.hpp"

namespace talus::run {
namespace {

/// Elements with altitudes below this share of the median are small: those of an ungraded mesh are not.
constexpr double small_altitude = 0.85;

/// The altitude above and below which one half of the soil's volume is [m].
template <int D>
double find_median_altitude(const mpm::Body<D>& body) {
  const mesh::Mesh<D>& mesh = body.mesh();
  std::vector<int> filled;
  double all = 0;
  for (int e = 0; e < mesh.element_count(); ++e) {
    if (body.points.count[e] == 0) continue;
    filled.push_back(e);
    all += mesh.volumes[e];
  }
  std::sort(filled.begin(), filled.end(), [&](int a, int b) { return mesh.altitudes[a] < mesh.altitudes[b]; });
  double below = 0;
  for (int e : filled) {
    below += mesh.volumes[e];
    if (below >= 0.5 * all) return mesh.altitudes[e];
  }
  return 0;
}

/// By how much the inertia of each element's points grows. The critical step also looks at the neighbours.
template <int D>
std::vector<double> find_growth(const mpm::Body<D>& body) {
  const mesh::Mesh<D>& mesh = body.mesh();
  const double wanted = small_altitude * find_median_altitude(body);
  std::vector<double> growth(mesh.elements.size());
  for (int e = 0; e < mesh.element_count(); ++e) {
    double altitude = mesh.altitudes[e];
    for (int n : mesh.neighbours[e])
      if (n >= 0) altitude = std::min(altitude, mesh.altitudes[n]);
    growth[e] = std::max(1.0, (wanted / altitude) * (wanted / altitude));
  }
  return growth;
}

}  // namespace

template <int D>
mpm::Body<D> make_even_body(const mpm::Body<D>& body, const StagePlan<D>& plan, const StageState& state) {
  const std::vector<double> growth = find_growth(body);
  mpm::Body<D> even = body;
  std::vector<Vec<D>> relief(body.mesh().nodes.size());
  for (int id = 0; id < body.points.size(); ++id) {
    if (!mpm::is_present(body, id)) continue;
    const int e = body.points.element[id];
    if (growth[e] == 1) continue;
    double* p = &even.points.data[find_place(even.points, id)];
    double& mass = p[mpm::Points<D>::mass * lane_width];
    const double added = mass * (growth[e] - 1);
    mass += added;
    double shape[D + 1];
    shape[0] = 1;
    for (int k = 0; k < D; ++k) {
      shape[k + 1] = p[(mpm::Points<D>::xi + k) * lane_width];
      shape[0] -= shape[k + 1];
    }
    for (int k = 0; k <= D; ++k)
      for (int d = 0; d < D; ++d) relief[body.mesh().elements[e][k]][d] -= shape[k] * added * plan.gravity[d];
  }
  mpm::Load<D> load;
  for (std::size_t i = 0; i < relief.size(); ++i) {
    if (norm(relief[i]) > 0) load.entries.push_back({static_cast<int>(i), relief[i]});
  }
  load.factor = find_weight_growth(body, plan, state);
  if (!load.entries.empty()) even.conditions.loads.push_back(std::move(load));
  return even;
}

template mpm::Body<2> make_even_body<2>(const mpm::Body<2>&, const StagePlan<2>&, const StageState&);
template mpm::Body<3> make_even_body<3>(const mpm::Body<3>&, const StagePlan<3>&, const StageState&);

}  // namespace talus::run
