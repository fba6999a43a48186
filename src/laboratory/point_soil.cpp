// SPDX-License-Identifier: MIT
#include "laboratory/point_soil.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "input/case/soil_water_law.hpp"

namespace talus::laboratory {

PointSoil::PointSoil(const input::Material& material, const Voigt& stress, double suction)
    : law_(input::make_law(material)),
      retention_(input::make_retention(material.water)),
      is_wet_(material.water.is_wet()),
      chi_air_entry_(material.water.chi == input::BishopChi::khalili_khabbaz ? material.water.chi_air_entry : 0),
      void_ratio_(material.void_ratio()) {
  start_.stress = stress;
  for (std::size_t i = 0; i < 3; ++i) start_.stress[i] -= find_suction_stress(suction);
  start_.suction = suction;
  set_start_state(material);
  // A stress beyond the strength would jump back in the first step.
  const PointState same = advance(start_, {}, suction);
  throw_failure();
  double largest = 0, jump = 0;
  for (std::size_t i = 0; i < stress.size(); ++i) {
    largest = std::max(largest, std::abs(start_.stress[i]));
    jump = std::max(jump, std::abs(same.stress[i] - start_.stress[i]));
  }
  if (!(jump <= 1e-6 * largest))
    throw Error(
        ExitCode::wrong_input,
        fmt::format("the soil does not carry the stress at the start, {:.6g} kPa axial and {:.6g} kPa radial: it "
                    "is outside the yield surface{}",
                    -start_.stress[1] / 1e3, -start_.stress[0] / 1e3,
                    find_preconsolidation(start_) > 0 ? fmt::format(", whose preconsolidation pressure is {:.6g} kPa",
                                                                    find_preconsolidation(start_) / 1e3)
                                                      : ""));
}

void PointSoil::set_start_state(const input::Material& material) {
  const double saturation = find_saturation(start_.suction);
  material::StateStart start{start_.stress.data(), void_ratio_, saturation};
  start.root_content = material.root_content;
  start.root_cohesion = material.root_cohesion;
  material::set_initial_state(law_, material, start, start_.state.data());
  std::visit(
      [&]<class L>([[maybe_unused]] const L& law) {
        if constexpr (material::IsPreconsolidated<L>)
          if (!material.preconsolidation) {
            // Without stages the ratio is that to the stress at the start.
            input::Material known = material;
            std::array<double, material::max_state_size> state{};
            law.set_preconsolidation(material.preconsolidation_ratio.value_or(1), start_.stress.data(), state.data());
            known.preconsolidation = state[1];
            material::set_initial_state(law_, known, start, start_.state.data());
          }
      },
      law_);
}

PointState PointSoil::advance(const PointState& from, const Voigt& d_epsilon, double suction) const {
  PointState to = from;
  to.suction = suction;
  to.time = from.time + 1;
  const int point = 0;
  const material::Surroundings<double> around{find_saturation(suction), &point, from.time, 1};
  std::visit(
      [&](const auto& law) {
        law.template update<6>(to.stress.data(), d_epsilon.data(), to.state.data(), true, around);
      },
      law_);
  if (auto failure = material::take_failure(law_)) {
    failure_ = std::move(failure);
    to.stress.fill(std::numeric_limits<double>::quiet_NaN());  // so that no caller goes on from here
  }
  return to;
}

void PointSoil::throw_failure() const {
  if (failure_) throw Error(ExitCode::unstable, failure_->describe(""));
}

double PointSoil::find_saturation(double suction) const {
  if (!is_wet_) return 1;
  return std::visit([&](const auto& curve) { return curve.template evaluate<double>(suction).value; }, retention_);
}

double PointSoil::find_suction_stress(double suction) const {
  if (!is_wet_ || suction <= 0) return 0;
  if (chi_air_entry_ <= 0) return find_saturation(suction) * suction;
  return suction * std::pow(std::max(1.0, suction / chi_air_entry_), -0.55);
}

double PointSoil::find_preconsolidation(const PointState& at) const {
  double pressure = 0;
  std::visit(
      [&]<class L>([[maybe_unused]] const L& law) {
        if constexpr (material::IsPreconsolidated<L>)
          pressure = law.find_preconsolidation(at.state.data(), find_saturation(at.suction));
      },
      law_);
  return pressure;
}

double PointSoil::find_void_ratio(const PointState& at, double volumetric_strain) const {
  return std::visit(
      [&]<class L>(const L&) {
        if constexpr (requires { L::find_void_ratio(at.state.data()); })
          return L::find_void_ratio(at.state.data());
        else
          return (1 + void_ratio_) * std::exp(-volumetric_strain) - 1;
      },
      law_);
}

}  // namespace talus::laboratory
