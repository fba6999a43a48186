#pragma once
// [materials.NAME]: modified Cam-clay, and the effects of roots.

#include <limits>
#include <optional>

#include "input/case/material_model.hpp"
#include "input/language/forms.hpp"
#include "input/language/spec.hpp"

namespace talus::input {

/// Modified Cam-clay, bare or rooted (4.1-4.15).
struct CamClaySoil {
  double compression = 0;                        ///< λ [-]
  double swelling = 0;                           ///< κ [-]
  double critical_state_slope = 0;               ///< M_0 [-]
  double suction_hardening = 0;                  ///< b [-]
  std::optional<double> preconsolidation;        ///< p'_c0 of the saturated bare soil [Pa]; or
  std::optional<double> preconsolidation_ratio;  ///< R_0 over the mean effective stress after initial.equilibrium [-]
  double smallest_pressure = 1e3;                ///< K = (1+e) max(p', this)/κ [Pa]
};

/// The effects of roots on the soil, per per cent of content.
struct RootedSoil {
  double content = 0;                                                ///< m_r^ini where no [[roots]] says otherwise [%]
  double hardening = 0;                                              ///< R_p [1/%]
  double strength = 0;                                               ///< R_a [1/%]
  std::optional<double> activation;                                  ///< R_p m_r of (4.10) as one number [-]
  double breaking_strain = std::numeric_limits<double>::infinity();  ///< ε_r^peak [-]
  double breaking_range = 0.1;                                       ///< over which they break [-]
  double residual_share = 0;                                         ///< [-]
  double cohesion = 0;  ///< c_r where no [[roots]] says otherwise, rooted_mohr_coulomb [Pa]
};

template <class Visitor>
void describe_cam_clay(Visitor& v, CamClaySoil& clay, const MaterialModel& model) {
  using M = MaterialModel;
  const auto clays = {M::modified_cam_clay, M::rooted_cam_clay};
  v.key("lambda", clay.compression, plain().above(0).needed_with("model", model, clays).example("0.089"),
        "λ, slope of the normal-compression line in the plane of void ratio and ln p'; the compression index over "
        "2.303.");
  v.key("kappa", clay.swelling, plain().above(0).needed_with("model", model, clays).example("0.022"),
        "κ, slope of the swelling lines in that plane; less than λ. The bulk modulus is (1+e)p'/κ.");
  v.key("critical_state_slope", clay.critical_state_slope,
        plain().above(0).below(3).needed_with("model", model, clays).example("1.2"),
        "M₀, slope q/p' of the critical-state line of the soil without roots; 6 sin φ'/(3 - sin φ') in compression.");
  v.key("preconsolidation", clay.preconsolidation,
        quantity("kPa").above(0).allowed_with("model", model, clays).example("125"),
        "p'c₀, preconsolidation pressure of the saturated soil without roots. Where the stress at the start needs a "
        "larger one, the soil is normally consolidated there. Either this or `preconsolidation_ratio` is needed.");
  v.key("preconsolidation_ratio", clay.preconsolidation_ratio,
        plain().at_least(1).allowed_with("model", model, clays).example("3"),
        "R₀ instead: p'c₀ over the mean effective stress at the end of the stage that initial.equilibrium names. Until "
        "then the soil is elastic.");
  v.key("suction_hardening", clay.suction_hardening, plain().at_least(0).allowed_with("model", model, clays),
        "b: p'c is exp(b(1 - S)) times that of the saturated soil, S being the degree of saturation; 0: suction does "
        "not harden the soil.");
  v.key("smallest_pressure", clay.smallest_pressure, quantity("kPa").above(0).allowed_with("model", model, clays),
        "Floor of p' in the bulk modulus (1+e)p'/κ, which would vanish at a free surface.");
}

template <class Visitor>
void describe_rooted_soil(Visitor& v, RootedSoil& roots, const MaterialModel& model) {
  const auto rooted = MaterialModel::rooted_cam_clay;
  PerCent<double> content{roots.content};
  v.key(
      "root_content", content,
      quantity("%").at_least(0).below(100).allowed_with("model", model, rooted).example("0.88"),
      "m_r, dry root mass over dry soil mass, where no [[roots]] says otherwise. A plain number is per cent: 0.88, not "
      "0.0088.");
  v.key("root_hardening", roots.hardening, plain().at_least(0).needed_with("model", model, rooted).example("0.28"),
        "R_p, per per cent of root content: at the start p'c is exp(R_p m_r) times that of the soil without roots, and "
        "grows as the roots are activated.");
  v.key("root_strength", roots.strength, plain().at_least(0).needed_with("model", model, rooted).example("0.18"),
        "R_a, per per cent of root content: the critical-state slope is M₀ + R_a m_r.");
  v.key("root_activation", roots.activation, plain().at_least(0).allowed_with("model", model, rooted).example("0.5"),
        "How fast p'c grows with the activation strain, as one number in the place of R_p m_r; 0: not at all. If not "
        "given, R_p m_r.");
  v.key("root_breaking_strain", roots.breaking_strain,
        plain().above(0).or_infinite().allowed_with("model", model, rooted).example("0.3"),
        "Activation strain (volumetric and deviatoric strain, added up) at which roots begin to break; inf: never.");
  v.key("root_breaking_range", roots.breaking_range, plain().above(0).allowed_with("model", model, rooted),
        "Further activation strain within which they break, one after the other.");
  v.key("root_residual_share", roots.residual_share,
        plain().at_least(0).at_most(1).allowed_with("model", model, rooted), "Share of the roots that holds for ever.");
  v.key("root_cohesion", roots.cohesion,
        quantity("kPa").at_least(0).allowed_with("model", model, MaterialModel::rooted_mohr_coulomb).example("5"),
        "c_r, added to the cohesion, where no [[roots]] says otherwise.");
}

}  // namespace talus::input
