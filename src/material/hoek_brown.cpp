// SPDX-License-Identifier: MIT
#include "material/hoek_brown.hpp"

#include <fmt/format.h>

#include <cmath>
#include <memory>

namespace talus::material {

HoekBrownMass make_rock_mass(const HoekBrownInput& in) {
  return {in.intact_strength, in.intact_constant * std::exp((in.gsi - 100) / (28 - 14 * in.disturbance)),
          std::exp((in.gsi - 100) / (9 - 3 * in.disturbance)),
          0.5 + (std::exp(-in.gsi / 15) - std::exp(-20.0 / 3)) / 6};
}

Properties HoekBrown::list_properties(const Input& in) {
  const HoekBrownInput& rock = in.get<HoekBrownInput>();
  const HoekBrownMass mass = make_rock_mass(rock);
  return {
      {"intact_strength", "uniaxial strength of the intact rock", "σ_ci", ShownAs::stress, rock.intact_strength, {}},
      {"gsi", "Geological Strength Index", "GSI", ShownAs::number, rock.gsi, {}},
      {"intact_constant", "constant of the intact rock", "m_i", ShownAs::number, rock.intact_constant, {}},
      {"disturbance", "disturbance", "D", ShownAs::number, rock.disturbance, {}},
      {"rock_mass_constant", "constant of the rock mass", "m_b", ShownAs::number, mass.m, {}},
      {"rock_mass_s", "constant of the rock mass", "s", ShownAs::number, mass.s, {}},
      {"rock_mass_exponent", "exponent of the rock mass", "a", ShownAs::number, mass.a, {}}};
}

SofteningHoekBrown::SofteningHoekBrown(const LinearElastic& elastic, const Input& in, double factor)
    : SofteningLaw(elastic),
      rock_(in.get<HoekBrownInput>()),
      residual_gsi_(in.get<ResidualIndex>().residual_gsi),
      range_(in.get<SofteningRange>()),
      dilatancy_ratio_(in.get<FlowRatio>().dilatancy_ratio),
      factor_(factor) {}

SofteningHoekBrown SofteningHoekBrown::make(const Input& in, const StrengthChange& change) {
  return {LinearElastic::make(in), in, change.factor};
}

void SofteningHoekBrown::check(const Input& in, const SoilFindings& findings) {
  const double peak = in.get<HoekBrownInput>().gsi, residual = in.get<ResidualIndex>().residual_gsi;
  if (findings.is_sound("gsi") && findings.is_sound("residual_gsi") && residual > peak)
    findings.add("residual_gsi",
                 fmt::format("'residual_gsi' is {:g}; it must not be above 'gsi', {:g}", residual, peak));
  in.get<SofteningRange>().check(findings);
}

Properties SofteningHoekBrown::list_properties(const Input& in) {
  Properties list = HoekBrown::list_properties(in);
  list.push_back({"residual_gsi",
                  "residual Geological Strength Index",
                  "GSI_r",
                  ShownAs::number,
                  in.get<ResidualIndex>().residual_gsi,
                  {}});
  in.get<SofteningRange>().add_properties(list);
  return list;
}

SliceStrength SofteningHoekBrown::find_slice_strength(const Input& in) {
  HoekBrownInput rock = in.get<HoekBrownInput>();
  if (in.get<SofteningRange>().limit_strength == LimitStrength::residual)
    rock.gsi = in.get<ResidualIndex>().residual_gsi;
  SliceStrength strength;
  StrengthLaw law;
  law.is_curved = true;
  law.find_tangent = [mass = make_rock_mass(rock)](const StrengthPlane& plane) {
    return mass.find_tangent(plane.normal);
  };
  strength.law = std::make_shared<const StrengthLaw>(std::move(law));
  return strength;
}

void SofteningHoekBrown::stop_softening(const Input::Changeable& in) {
  if (in.get<SofteningRange>().limit_strength == LimitStrength::residual)
    in.get<HoekBrownInput>().gsi = in.get<ResidualIndex>().residual_gsi;
}

HoekBrownMass SofteningHoekBrown::find_mass(double strain) const {
  HoekBrownInput now = rock_;
  now.gsi += range_.find_share(strain) * (residual_gsi_ - now.gsi);
  return make_rock_mass(now);
}

}  // namespace talus::material
