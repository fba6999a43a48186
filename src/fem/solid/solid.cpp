// SPDX-License-Identifier: MIT
// Equilibrium in load steps.
#include "fem/solid/solid.hpp"

#include <fmt/format.h>

#include <map>
#include <utility>

#include "base/error.hpp"
#include "fem/solid/softening.hpp"
#include "fem/solid/system.hpp"
#include "material/every_law.hpp"

namespace talus::fem {

template <int D>
std::vector<material::Law> make_laws(const SolidModel<D>& model, double factor) {
  int regions = 0;
  for (int r : model.mesh->element_region) regions = std::max(regions, r + 1);
  std::vector<char> used(static_cast<std::size_t>(regions), 0);
  for (int r : model.mesh->element_region)
    if (r != mesh::empty_region) used[static_cast<std::size_t>(r)] = 1;
  std::vector<material::Law> laws;
  for (int r = 0; r < regions; ++r)
    laws.push_back(used[static_cast<std::size_t>(r)] ? model.make_law(r, factor)
                                                     : material::Law(material::LinearElastic{}));
  return laws;
}

template <int D>
SolidResult<D> apply_loads(const SolidSystem<D>& system, SolidNewton<D>& newton, SolidSoftening<D>& softening,
                           const SolidAssembly<D>& assembly, const SolidOptions& options, const SolidState<D>& start) {
  SolidResult<D> result;
  SolidState<D> now = start, end;
  const std::vector<double> still(system.load.size(), 0);
  SolidSums sums;
  assembly.evaluate(start, still, false, end, sums);
  const int before = newton.factorisations();
  double share = 0, step = 1.0 / std::max(options.load_steps, 1);
  int halvings = 0;
  std::vector<double> target(system.load.size());
  while (share < 1) {
    const double next = std::min(1.0, share + step);
    for (std::size_t i = 0; i < target.size(); ++i)
      target[i] = sums.force[i] + (next > 1 - 1e-12 ? 1 : next) * (system.load[i] - sums.force[i]);
    const SofteningOutcome out = softening.solve(newton, assembly, now, target, end);
    result.iterations += out.iterations;
    result.force_residual = out.force_residual;
    result.displacement_residual = out.displacement_residual;
    result.flows = out.flows;
    if (!out.converged) {
      // flow means that the limit load is exceeded; a smaller step would only reach it later
      if (out.flows || halvings++ == options.most_halvings) break;
      step /= 2;
      continue;
    }
    ++result.load_steps;
    std::swap(now, end);
    share = next > 1 - 1e-12 ? 1 : next;
  }
  result.converged = share >= 1;
  result.at = result.converged ? std::move(now) : std::move(end);
  result.factorisations = newton.factorisations() - before;
  for (std::size_t n = 0; n < result.at.displacement.size(); ++n)
    result.largest_displacement = std::max(result.largest_displacement, norm(result.at.displacement[n]));
  return result;
}

template <int D>
SolidResult<D> find_equilibrium(const SolidModel<D>& model, const SolidOptions& options, double factor,
                                const SolidState<D>* start) {
  const SolidSystem<D> system(model);
  const SolidAssembly<D> assembly(system, make_laws(model, factor), options.threads, {factor, start == nullptr});
  SolidNewton<D> newton(system, options);
  SolidSoftening<D> softening(system, options);
  return apply_loads(system, newton, softening, assembly, options, start ? *start : assembly.make_start());
}

namespace {

/// Adds the deflection of walls beside soil: the motion of the soil less the opening of the joint, across the wall.
void add_deflections(const SpringSet& springs, const SolidState<2>& state, std::vector<BarForces>& found) {
  std::map<std::pair<int, double>, std::array<double, 2>> sums;  // wall and place → sum, number
  for (std::size_t j = 0; j < springs.joints.size(); ++j) {
    const Joint& joint = springs.joints[j];
    if (joint.is_section) continue;
    const double opening = state.bars[springs.list.size() + 2 * j] + joint.compression / joint.normal_stiffness,
                 away = dot(state.displacement[static_cast<std::size_t>(joint.node)], joint.normal) - opening;
    auto& [sum, number] = sums[{joint.wall, joint.place}];
    sum += joint.side == 0 ? away : -away;
    ++number;
  }
  for (const auto& [at, sum] : sums) {
    BarCurve& curve = found[static_cast<std::size_t>(at.first)].deflection;
    curve.place.push_back(at.second);
    curve.value.push_back(sum[0] / sum[1]);
  }
}

}  // namespace

std::vector<BarForces> compute_bar_forces(const SolidModel<2>& model, const SolidState<2>& state, double factor) {
  const SpringSet springs = SolidSystem<2>(model).springs;
  std::vector<BarForces> found =
      compute_bar_forces(model.bars.size() + model.walls.size(), springs, state.bars, factor);
  add_deflections(springs, state, found);
  return found;
}

template std::vector<material::Law> make_laws(const SolidModel<2>&, double);
template std::vector<material::Law> make_laws(const SolidModel<3>&, double);
template SolidResult<2> apply_loads(const SolidSystem<2>&, SolidNewton<2>&, SolidSoftening<2>&, const SolidAssembly<2>&,
                                    const SolidOptions&, const SolidState<2>&);
template SolidResult<3> apply_loads(const SolidSystem<3>&, SolidNewton<3>&, SolidSoftening<3>&, const SolidAssembly<3>&,
                                    const SolidOptions&, const SolidState<3>&);
template SolidResult<2> find_equilibrium<2>(const SolidModel<2>&, const SolidOptions&, double, const SolidState<2>*);
template SolidResult<3> find_equilibrium<3>(const SolidModel<3>&, const SolidOptions&, double, const SolidState<3>*);

}  // namespace talus::fem
