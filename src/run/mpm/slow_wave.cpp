// SPDX-License-Identifier: MIT
#include "run/mpm/slow_wave.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "mpm/body/observe.hpp"

namespace talus::run {
namespace {

/// Largest crossing over the process. Consolidation under a sudden load is 0.5 % off at a twentieth, 6 % at a sixth and
/// 21 % at a half (theory 5).
constexpr double largest_share = 0.1;

/// Conductivity of soil in which water takes k/(n g), some milliseconds, to follow a change of its drag [m/s].
constexpr double open_soil = 1e-2;

/// Part of the weight that water may carry at the end of a weight stage.
constexpr double largest_excess = 0.05;

/// To one digit.
double round_down(double x) {
  const double unit = std::pow(10.0, std::floor(std::log10(x)));
  return std::floor(x / unit * (1 + 1e-9)) * unit;
}

}  // namespace

template <int D>
DrainedWave find_drained_wave(const mpm::Body<D>& body, const StagePlan<D>& plan) {
  const double g = norm(plan.gravity);
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest, slowest = 0, fastest_drainage = 0;
  for (int id = 0; id < body.points.size(); ++id) {
    if (!mpm::is_present(body, id)) continue;
    const auto p = mpm::view_point(body, id);
    const double height = g > 0 ? -dot(p.position, plan.gravity) / g : p.position[D - 1];
    lowest = std::min(lowest, height);
    highest = std::max(highest, height);
    const double modulus = material::constrained_modulus(body.laws[p.material], p.stress.data(), p.state.data());
    slowest = std::max(slowest, (p.mass + p.water_mass) / (p.volume * modulus));
    if (!p.wet || !input::moves(plan.step.water)) continue;
    const mpm::WaterLaw& law = body.water.laws[p.material];
    const double conductivity = law.conductivity * plan.step.conductivity_factor;
    fastest_drainage = std::max(fastest_drainage, conductivity * modulus / (law.density * law.drag_gravity));
  }
  const double height = std::max(0.0, highest - lowest);
  DrainedWave wave{height * std::sqrt(plan.step.mass_scaling * slowest)};
  if (fastest_drainage > 0) wave.drainage = height * height / fastest_drainage;
  return wave;
}

template <int D>
std::optional<std::string> describe_slow_wave(const mpm::Body<D>& body, const StagePlan<D>& plan) {
  const double scaling = plan.step.mass_scaling;
  if (scaling <= 1) return std::nullopt;
  const DrainedWave wave = find_drained_wave(body, plan);
  const double lasting = plan.until_rest ? std::numeric_limits<double>::infinity() : plan.duration;
  const bool drains = wave.drainage && *wave.drainage < lasting;
  const double process = drains ? *wave.drainage : lasting, share = wave.crossing / process;
  if (!(share > largest_share)) return std::nullopt;
  return fmt::format(
      "stage '{}': with mass_scaling = {:.3g} a wave needs {:.2g} s to cross the drained soil. What takes less than "
      "ten times as long lags behind, and {} {:.2g} s. A mass_scaling up to {:g} follows it",
      plan.name, scaling, wave.crossing, drains ? "the soil drains in" : "the stage lasts", process,
      round_down(std::max(1.0, scaling * std::pow(largest_share / share, 2))));
}

template <int D>
std::optional<std::string> describe_fast_water(const mpm::Body<D>& body, const StagePlan<D>& plan) {
  if (plan.step.water != input::WaterMotion::seeps) return std::nullopt;
  for (std::size_t m = 0; m < body.water.laws.size(); ++m) {
    const mpm::WaterLaw& law = body.water.laws[m];
    const double conductivity = law.conductivity * plan.step.conductivity_factor;
    if (law.wet && conductivity > open_soil)
      return fmt::format(
          "stage '{}': water = \"seeps\" leaves out the inertia of the water itself, which matters in '{}' with a "
          "conductivity of {:g} m/s where the flow changes within seconds; water = \"flows\" has it",
          plan.name, body.material_names[m], conductivity);
  }
  return std::nullopt;
}

template <int D>
CarriedWeight find_carried_weight(const mpm::Body<D>& body) {
  CarriedWeight carried;
  double volume = 0;
  for (int id = 0; id < body.points.size(); ++id) {
    if (!mpm::is_present(body, id)) continue;
    const auto p = mpm::view_point(body, id);
    if (!p.wet) continue;
    volume += p.volume;
    carried.water -= p.volume * p.pressure;
    carried.grains -= p.volume * p.stress[1];
  }
  if (volume > 0) carried = {carried.water / volume, carried.grains / volume};
  return carried;
}

template <int D>
std::optional<std::string> describe_undrained_weight(const mpm::Body<D>& body, const std::string& stage,
                                                     const CarriedWeight& before) {
  const CarriedWeight now = find_carried_weight(body);
  const double excess = now.water - before.water, weight = excess + now.grains - before.grains;
  if (!(excess > largest_excess * weight) || !(weight > 0)) return std::nullopt;
  return fmt::format(
      "stage '{}': at its end the pore water carries {:.0f} % of the weight that the stage brought on (mean excess "
      "pressure {:.3g} kPa): the soil is at rest, not drained, and its effective stresses are too low. Leave `water` "
      "and "
      "`geometry` of a weight stage out, which holds the pore pressures, or give the water time to drain",
      stage, 100 * std::min(1.0, excess / weight), excess / 1e3);
}

#define TALUS_INSTANTIATE(D)                                                                                \
  template DrainedWave find_drained_wave<D>(const mpm::Body<D>&, const StagePlan<D>&);                      \
  template std::optional<std::string> describe_slow_wave<D>(const mpm::Body<D>&, const StagePlan<D>&);      \
  template std::optional<std::string> describe_fast_water<D>(const mpm::Body<D>&, const StagePlan<D>&);     \
  template CarriedWeight find_carried_weight<D>(const mpm::Body<D>&);                                       \
  template std::optional<std::string> describe_undrained_weight<D>(const mpm::Body<D>&, const std::string&, \
                                                                   const CarriedWeight&);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

}  // namespace talus::run
