#include "ground/soil_laws.hpp"

#include <fmt/format.h>

#include "base/error.hpp"

namespace talus::ground {
namespace {

material::LinearElastic make_elastic(const input::Material& m) {
  return material::LinearElastic::from_young(m.young_modulus, m.poisson_ratio);
}

material::MohrCoulombStrength make_strength(const input::Material& m, std::optional<double> cohesion, double factor) {
  material::MohrCoulombStrength strength{m.cohesion, m.friction_angle, m.dilatancy_angle, m.tensile_strength};
  if (cohesion) strength.cohesion = *cohesion;
  return factor == 1 ? strength : strength.reduced(factor);
}

material::CamClayParameters make_cam_clay(const input::Material& m, double factor) {
  return {.compression = m.cam_clay.compression,
          .swelling = m.cam_clay.swelling,
          .poisson_ratio = m.poisson_ratio,
          .critical_state_slope = m.cam_clay.critical_state_slope,
          .suction_hardening = m.cam_clay.suction_hardening,
          .smallest_pressure = m.cam_clay.smallest_pressure,
          .strength_factor = factor};
}

material::RootParameters make_roots(const input::RootedSoil& roots) {
  return {.hardening = roots.hardening,
          .strength = roots.strength,
          .activation = roots.activation.value_or(-1),
          .breaking_strain = roots.breaking_strain,
          .breaking_range = roots.breaking_range,
          .residual_share = roots.residual_share};
}

material::External make_external(const input::ExternalModel& m) {
  return material::External({.library = m.library_file.empty() ? m.library : m.library_file,
                             .symbol = m.symbol,
                             .material = m.material,
                             .constants = m.constants,
                             .states = m.states,
                             .initial_states = m.initial_states,
                             .constrained_modulus = m.constrained_modulus});
}

}  // namespace

material::Law make_law(const input::Material& m, std::optional<double> cohesion, double factor) {
  switch (m.model) {
    case input::MaterialModel::linear_elastic:
      return make_elastic(m);
    case input::MaterialModel::mohr_coulomb:
      return material::MohrCoulomb(make_elastic(m), make_strength(m, cohesion, factor));
    case input::MaterialModel::rooted_mohr_coulomb:
      return material::RootedMohrCoulomb(make_elastic(m), make_strength(m, cohesion, factor), factor);
    case input::MaterialModel::modified_cam_clay:
      return material::ModifiedCamClay(make_cam_clay(m, factor));
    case input::MaterialModel::rooted_cam_clay:
      return material::RootedCamClay(make_cam_clay(m, factor), make_roots(m.roots));
    case input::MaterialModel::external:
      if (factor != 1)
        throw Error(ExitCode::wrong_input,
                    fmt::format("the strength of the external model '{}' cannot be divided by {:g}: only the library "
                                "knows it; give its reduced constants instead",
                                m.external.library, factor));
      return make_external(m.external);
  }
  throw Error(ExitCode::wrong_input, "unknown model of a material");
}

}  // namespace talus::ground
