// SPDX-License-Identifier: MIT
// Critical time steps of one phase (2.84) and of the two-velocity formulation (2.85-2.88), over all ranks.
#include "mpm/solver/step.hpp"

#include <algorithm>
#include <cmath>

#include "material/every_law.hpp"
#include "mpm/kernels/element_kernels.hpp"
#include "mpm/kernels/pore_state.hpp"
#include "mpm/solver/observe.hpp"
#include "mpm/state/partition.hpp"
#include "mpm/two_velocity/kernels.hpp"

namespace talus::mpm {
namespace {

/// Suctions below this may vanish before the next evaluation of the critical step [Pa].
constexpr double saturating_suction = 2e3;

/// A wet point in the state of smallest storage that it can reach before the next evaluation of the critical step. The
/// conductivity is needed for explicit drag only; null with implicit drag.
CoupledSoil make_coupled_soil(const WaterLaw& law, double modulus, double porosity, double pressure,
                              const double* conductivity_factor) {
  double storage = law.full / law.bulk_modulus, saturation = law.full, relative = law.saturated_relative;
  if (pressure > saturating_suction) {
    saturation = material::saturation(law.retention, pressure);
    storage = std::min(find_storage(law, pressure), find_storage(law, 0.5 * pressure));
    if (conductivity_factor) relative = find_state_at_pressure<double>(law, pressure).relative;
  }
  const double resistance = conductivity_factor ? find_saturated_resistance(law, *conductivity_factor) / relative : 0.0;
  return {modulus, porosity, saturation, porosity * storage, law.grain_density, law.density, resistance};
}

/// Effective mass scaling, β/(1+α) with explicit drag and net damping (T14.10), else β: net damping adds its fraction α
/// to forces that slow a phase, so stiffness and drag act as if they were 1+α times as large (theory 14, Time step).
template <int D>
double find_scaling_in_drag(const StepOptions<D>& o) {
  const bool strengthens = !o.implicit_drag && o.net_damping;
  return o.mass_scaling / (strengthens ? 1 + std::max(o.damping, o.water_damping) : 1.0);
}

/// Smallest altitude [m] of an element and its neighbours, which its points may enter before the next evaluation, with
/// the element that has it.
template <int D>
std::pair<double, int> find_shortest(const mesh::Mesh<D>& mesh, int e) {
  std::pair<double, int> shortest{mesh.altitudes[e], e};
  for (int n : mesh.neighbours[e]) {
    if (n >= 0 && mesh.altitudes[n] < shortest.first) shortest = {mesh.altitudes[n], n};
  }
  return shortest;
}

/// Critical step of soil with bars: the rates of both add up.
template <int D>
CriticalStep add_bars(const Body<D>& body, CriticalStep soil, double mass_scaling) {
  if constexpr (D == 2) {
    if (body.bars.empty() || soil.element < 0) return soil;
    // Twice the rate at small slip, since a bent bar also holds the soil across its length.
    const double rate = 2 * find_bar_rate(body) / mass_scaling;
    soil.dt = 1 / std::sqrt(1 / (soil.dt * soil.dt) + rate / 4);
  }
  return soil;
}

/// The smallest critical step of all ranks; NaN wins over any number.
template <int D>
CriticalStep find_least(const Body<D>& body, const CriticalStep& critical) {
  CriticalStep of_all;
  for (const CriticalStep& of_rank : join_lists(body, std::vector{critical}))
    if (of_rank.element >= 0 && (of_all.element < 0 || !(of_rank.dt >= of_all.dt))) of_all = of_rank;
  return of_all;
}

}  // namespace

double find_two_velocity_step(const CoupledSoil& soil, double length, double beta, bool implicit_drag) {
  const double n = soil.porosity, s = soil.saturation, theta = n * s;
  const double solid = (1 - n) * soil.grain_density, water = theta * soil.water_density;
  const double pressure = s * s / soil.storage;
  const double k00 = soil.constrained_modulus + pressure * (1 - n) * (1 - n), k11 = pressure * n * n,
               k01 = pressure * n * (1 - n);
  const double drag = theta * theta * soil.resistance;
  const double a = implicit_drag ? 0.0 : drag * (1 / solid + 1 / water) / beta;
  const double b = 4 / (length * length) * (k00 / solid + k11 / water) / beta;
  const double c = 16 / std::pow(length, 4) * (k00 * k11 - k01 * k01) / (solid * water) / (beta * beta);
  const double x = b + std::sqrt(std::max(0.0, b * b - 4 * c));
  return (-2 * a + std::sqrt(4 * a * a + 8 * x)) / x;
}

template <int D>
CriticalStep find_critical_step(const Body<D>& body, double mass_scaling) {
  StepSquare least;
  const auto [begin, end] = own_elements(body);
  for (int e = begin; e < end; ++e) least.add(find_step_square(body, e));
  return add_bars(body, find_least(body, {std::sqrt(least.dt2 * mass_scaling), least.element}), mass_scaling);
}

template <int D>
CriticalStep find_critical_step(const Body<D>& body, const StepOptions<D>& o) {
  if (!body.water.is_wet()) return find_critical_step(body, o.mass_scaling);
  using P = Points<D>;
  const mesh::Mesh<D>& mesh = body.mesh();
  CriticalStep critical;
  const auto [begin, end] = own_elements(body);
  for (int e = begin; e < end; ++e) {
    const int n = static_cast<int>(body.points.count[e]);
    if (n == 0) continue;
    const auto [length, shortest] = find_shortest(mesh, e);
    for (int k = 0; k < n; ++k) {
      const std::int64_t slot = body.points.block_start[e / lane_width] + k;
      const double* p = body.points.slot(slot) + e % lane_width;
      const int m = body.points.material[body.points.id[static_cast<std::size_t>(slot * lane_width + e % lane_width)]];
      const WaterLaw& law = body.water.laws[m];
      const double modulus = find_modulus<D>(body.laws[m], p);
      const double mass = p[P::mass * lane_width], volume = p[P::volume * lane_width];
      const double whole = o.darcy ? mass + p[(body.water.first_field + WaterFields<D>::mass) * lane_width] : mass;
      double dt = length * std::sqrt(o.mass_scaling * whole / (modulus * volume));
      if (law.wet && !o.darcy) {
        const double pressure = p[(body.water.first_field + WaterFields<D>::pressure) * lane_width];
        const CoupledSoil soil = make_coupled_soil(law, modulus, 1 - mass / (law.grain_density * volume), pressure,
                                                   o.implicit_drag ? nullptr : &o.conductivity_factor);
        dt = find_two_velocity_step(soil, length, find_scaling_in_drag(o), o.implicit_drag);
      }
      if (critical.element < 0 || !(dt >= critical.dt)) critical = {dt, shortest};
    }
  }
  return add_bars(body, find_least(body, critical), o.mass_scaling);
}

template CriticalStep find_critical_step<2>(const Body<2>&, double);
template CriticalStep find_critical_step<3>(const Body<3>&, double);
template CriticalStep find_critical_step<2>(const Body<2>&, const StepOptions<2>&);
template CriticalStep find_critical_step<3>(const Body<3>&, const StepOptions<3>&);

}  // namespace talus::mpm
