// SPDX-License-Identifier: MIT
// The keys of the blocks.
#include "material/inputs.hpp"

#include "input/language/forms.hpp"
#include "input/language/visitor.hpp"

namespace talus::material {

using input::plain;
using input::quantity;

void describe(input::Visitor& v, YoungInput& in, const Users& users) {
  const std::vector<input::Slip> slips{{"MPa", 1e3}, {"GPa", 1e6}, {"Pa", 1e-3}, {"psf", 0.0478803}};
  v.key("young_modulus", in.young_modulus,
        users.need(quantity("kPa").above(0)).by_methods({"fem", "mpm"}).usual(200, 5e6, slips).example("45000"),
        "Young's modulus.");
}

void describe(input::Visitor& v, PoissonInput& in, const Users& users) {
  v.key("poisson_ratio", in.poisson_ratio,
        users.need(plain().above(-1).below(0.5)).by_methods({"fem", "mpm"}).usual_or_zero(0.05, 0.495).example("0.3"),
        "Poisson's ratio.");
}

void describe(input::Visitor& v, MohrCoulombStrength& in, const Users& users) {
  const std::vector<input::Slip> angles{{"rad", 57.29578}};
  const std::vector<input::Slip> stresses{{"Pa", 1e-3}, {"MPa", 1e3}, {"psf", 0.0478803}};
  v.key("cohesion", in.cohesion,
        users.need(quantity("kPa").at_least(0)).usual_or_zero(0.01, 500, stresses).example("10"),
        "Cohesion c of the soil itself.");
  v.key("friction_angle", in.friction_angle,
        users.need(quantity("deg").at_least(0).below(90)).usual_or_zero(5, 50, angles).example("20"),
        "Angle of internal friction φ.");
  v.key("dilatancy_angle", in.dilatancy_angle,
        users.need(quantity("deg").at_least(0).below(90))
            .by_methods({"fem", "mpm"})
            .usual_or_zero(1, 20, angles)
            .example("0"),
        "Angle of dilatancy ψ of the plastic flow; at most the friction angle.");
  v.key("tensile_strength", in.tensile_strength,
        users.need(quantity("kPa").at_least(0)).by_methods({"fem", "bounds", "mpm"}).example("0"),
        "Largest tensile stress; at most c/tan φ, the apex of the yield surface.");
}

void describe(input::Visitor& v, CohesionGradient& in, const Users& users) {
  v.key("cohesion_gradient", in.cohesion_gradient, users.allow(quantity("kPa/m")).example("1.5"),
        "The cohesion grows by this per metre below `cohesion_level`.");
  v.key("cohesion_level", in.cohesion_level, users.allow(quantity("m")).example("15"),
        "Level y at which that growth begins; `cohesion_gradient` needs it.");
}

void describe(input::Visitor& v, RootCohesionInput& in, const Users& users) {
  v.key("root_cohesion", in.root_cohesion, users.allow(quantity("kPa").at_least(0)).example("5"),
        "c_r, added to the cohesion, where no [[roots]] says otherwise.");
}

void describe(input::Visitor& v, ResidualStrength& in, const Users& users) {
  v.key("residual_cohesion", in.residual_cohesion,
        users.need(quantity("kPa").at_least(0)).usual_or_zero(0.01, 500).example("2"),
        "Cohesion after softening, at most `cohesion`.");
  v.key("residual_friction_angle", in.residual_friction_angle,
        users.need(quantity("deg").at_least(0).below(90)).usual_or_zero(5, 50).example("14"),
        "Friction angle after softening, at most `friction_angle`; tan φ falls linearly, and ψ to zero.");
}

void describe(input::Visitor& v, SofteningRange& in, const Users& users) {
  v.key("softening_start", in.softening_start, users.allow(plain().at_least(0)).example("0.01"),
        "Deviatoric plastic strain, ∫√(⅔ ė:ė) dt, at which the strength begins to fall.");
  v.key("softening_end", in.softening_end,
        users.need(plain().above(0)).by_methods({"mpm"}).usual(0.01, 10).example("0.3"),
        "The same strain at which the strength is residual, linearly between.");
  v.key("limit_strength", in.limit_strength,
        users.need(plain()).by_methods({"lem", "fem", "bounds"}).example(R"("residual")"),
        "Strength for LEM and limit analysis, which do not soften, and for FEM where [fem] softening is \"none\".");
}

void describe(input::Visitor& v, DruckerPragerInput& in, const Users& users) {
  v.key("cone", in.cone, users.need(plain()).example(R"("plane_strain")"),
        "Where the cone of Drucker–Prager has the strength that c and φ give Mohr–Coulomb's pyramid.");
}

void describe(input::Visitor& v, TrescaInput& in, const Users& users) {
  const std::vector<input::Slip> slips{{"Pa", 1e-3}, {"MPa", 1e3}, {"psf", 0.0478803}};
  v.key("profile_strengths", in.profile_strengths,
        users.allow(quantity("kPa").above(0)).usual(1, 500, slips).example("[20, 20, 45]"),
        "Undrained shear strengths s_u along the profile, instead of `undrained_strength`.");
  v.key("undrained_strength", in.undrained_strength,
        users.need(quantity("kPa").above(0))
            .usual(1, 500, slips)
            .unless_given("profile_strengths", !in.profile_strengths.empty())
            .example("25"),
        "Undrained shear strength s_u, at `undrained_level` and above it.");
  v.key("undrained_gradient", in.undrained_gradient, users.allow(quantity("kPa/m").at_least(0)).example("1.5"),
        "s_u grows by this per metre below `undrained_level`.");
  v.key("undrained_level", in.undrained_level, users.allow(quantity("m")).example("15"),
        "Level y at which that growth begins.");
}

void describe(input::Visitor& v, StrengthProfile& in, const Users& users) {
  v.key("profile_levels", in.profile_levels, users.allow(quantity("m")).example("[10, 6, 0]"),
        "Elevations y of a profile, from the top down; its values are linear between them and constant beyond.");
  v.key("profile_depths", in.profile_depths, users.allow(quantity("m").at_least(0)).example("[0, 4, 10]"),
        "Depths under the ground instead, from the top down.");
  v.key("profile_x", in.profile_x, users.allow(quantity("m")).example("[0, 40]"),
        "Horizontal places of several profiles, as of soundings, from left to right. Their values follow profile by "
        "profile, at the same levels or depths, and are linear between the profiles and constant beyond them.");
}

void describe(input::Visitor& v, ShansepInput& in, const Users& users) {
  v.key("strength_ratio", in.strength_ratio, users.need(plain().above(0)).usual(0.1, 0.5).example("0.22"),
        "S, undrained strength of the normally consolidated soil over σ'_v.");
  v.key("strength_exponent", in.strength_exponent, users.need(plain().at_least(0)).usual(0.5, 1).example("0.8"),
        "m, exponent of the overconsolidation ratio.");
  v.key("added_strength", in.added_strength, users.allow(quantity("kPa").at_least(0)).example("5"),
        "A, a strength that is added to that of the stress history.");
  v.key("ocr", in.ocr, users.allow(plain().at_least(1)).usual(1, 20).example("2"),
        "Overconsolidation ratio of the soil; either this, `profile_ocr` or `profile_preconsolidation` is needed.");
  v.key("profile_ocr", in.profile_ocr, users.allow(plain().at_least(1)).example("[4, 2, 1]"),
        "Overconsolidation ratios along the profile.");
  v.key("profile_preconsolidation", in.profile_preconsolidation,
        users.allow(quantity("kPa").above(0)).example("[80, 70, 120]"),
        "Preconsolidation stresses σ'_p along the profile; OCR is σ'_p/σ'_v, at least 1.");
}

void describe(input::Visitor& v, AdpInput& in, const Users& users) {
  v.key("direct_ratio", in.direct_ratio, users.need(plain().above(0).at_most(1.5)).usual(0.4, 1).example("0.63"),
        "Strength in direct simple shear over the active one, s_uD/s_uA, which `undrained_strength` or the profile "
        "gives.");
  v.key("passive_ratio", in.passive_ratio, users.need(plain().above(0).at_most(1.5)).usual(0.2, 1).example("0.35"),
        "Passive strength over the active one, s_uP/s_uA.");
}

void describe(input::Visitor& v, AnisotropicInput& in, const Users& users) {
  v.key("base_inclinations", in.base_inclinations,
        users.need(quantity("deg").at_least(-90).at_most(90)).example("[-90, -20, 20, 90]"),
        "Inclinations of a plane to the horizontal, increasing, positive where it rises with x.");
  v.key("inclined_cohesions", in.inclined_cohesions, users.need(quantity("kPa").at_least(0)).example("[20, 5, 5, 20]"),
        "Cohesions of planes with these inclinations; linear between, constant beyond.");
  v.key("inclined_frictions", in.inclined_frictions,
        users.need(quantity("deg").at_least(0).below(90)).example("[30, 22, 22, 30]"),
        "Friction angles of them; their tangents are linear between.");
}

void describe(input::Visitor& v, BeddingInput& in, const Users& users) {
  v.key("bedding_angle", in.bedding_angle, users.need(quantity("deg").at_least(-90).at_most(90)).example("25"),
        "Inclination of the bedding to the horizontal, positive where it rises with x.");
  v.key("bedding_cohesion", in.bedding_cohesion,
        users.need(quantity("kPa").at_least(0)).usual_or_zero(0.01, 500).example("5"), "Cohesion along the bedding.");
  v.key("bedding_friction", in.bedding_friction,
        users.need(quantity("deg").at_least(0).below(90)).usual_or_zero(5, 50).example("20"),
        "Friction angle along the bedding.");
  v.key("bedding_range", in.bedding_range, users.allow(quantity("deg").at_least(0).at_most(45)).example("2"),
        "LEM: planes within this angle of the bedding have its strength. 0 is the soil of FEM, limit analysis and MPM, "
        "which judges the factors then; polylines are searched along the bedding. A wider range stands for wavy "
        "bedding and lowers the factor.");
  v.key("bedding_transition", in.bedding_transition, users.allow(quantity("deg").at_least(0).at_most(90)).example("15"),
        "Planes beyond this angle have the strength of the soil itself, and c and tan φ are linear between; if not "
        "given, `bedding_range`.");
  v.key("bedding_dilatancy", in.bedding_dilatancy, users.allow(quantity("deg").at_least(0).below(90)).example("0"),
        "Dilatancy angle of sliding along the bedding in FEM and MPM, at most `bedding_friction`.");
}

void describe(input::Visitor& v, PowerCurveInput& in, const Users& users) {
  v.key("power_factor", in.power_factor, users.need(plain().above(0)).usual(0.05, 20).example("2"),
        "a of the power curve τ = a (σ' + d)^b + c, for stresses in kPa.");
  v.key("power_exponent", in.power_exponent, users.need(plain().above(0).at_most(1)).usual(0.4, 1).example("0.7"),
        "b of that.");
  v.key("power_shift", in.power_shift, users.allow(quantity("kPa").at_least(0)).example("1"),
        "d of that, an effective stress that acts beside σ'.");
  v.key("power_cohesion", in.power_cohesion, users.allow(quantity("kPa").at_least(0)).example("2"), "c of that.");
}

void describe(input::Visitor& v, FlowRatio& in, const Users& users) {
  v.key("dilatancy_ratio", in.dilatancy_ratio,
        users.need(plain().at_least(0).at_most(1)).by_methods({"fem", "mpm"}).example("0"),
        "tan ψ of the plastic flow over tan φ of the tangent to the envelope: 0 at constant volume, 1 associated.");
}

void describe(input::Visitor& v, StrengthTableInput& in, const Users& users) {
  v.key("normal_stresses", in.normal_stresses, users.need(quantity("kPa").at_least(0)).example("[0, 50, 200]"),
        "Effective normal stresses of a strength envelope, increasing.");
  v.key("shear_strengths", in.shear_strengths, users.need(quantity("kPa").at_least(0)).example("[5, 40, 130]"),
        "Shear strengths at them; straight between, and beyond the last with the last slope.");
}

void describe(input::Visitor& v, HoekBrownInput& in, const Users& users) {
  v.key("intact_strength", in.intact_strength,
        users.need(quantity("MPa").above(0))
            .usual(1, 300, {{"kPa", 1e-3}, {"Pa", 1e-6}, {"psi", 6.894757e-3}})
            .example("30"),
        "σ_ci, uniaxial compressive strength of the intact rock.");
  v.key("gsi", in.gsi, users.need(plain().above(0).at_most(100)).usual(5, 90).example("45"),
        "Geological Strength Index of the rock mass.");
  v.key("intact_constant", in.intact_constant, users.need(plain().above(0)).usual(2, 35).example("10"),
        "m_i of the intact rock.");
  v.key("disturbance", in.disturbance, users.allow(plain().at_least(0).at_most(1)).example("0.7"),
        "D, disturbance by blasting and relief, from 0 (none) to 1.");
}

void describe(input::Visitor& v, ResidualIndex& in, const Users& users) {
  v.key("residual_gsi", in.residual_gsi, users.need(plain().above(0).at_most(100)).usual(5, 40).example("22"),
        "Geological Strength Index after softening, at most `gsi` (Cai et al. 2007).");
}

void describe(input::Visitor& v, JointInput& in, const Users& users) {
  v.key("joint_roughness", in.joint_roughness,
        users.need(plain().at_least(0).at_most(30)).usual_or_zero(1, 20).example("8"),
        "JRC, joint roughness coefficient.");
  v.key("joint_strength", in.joint_strength,
        users.need(quantity("MPa").above(0)).usual(0.5, 300, {{"kPa", 1e-3}, {"Pa", 1e-6}}).example("50"),
        "JCS, compressive strength of the wall of the joint.");
  v.key("residual_friction", in.residual_friction,
        users.need(quantity("deg").above(0).below(90)).usual(15, 40).example("28"),
        "φ_r, residual friction angle of the joint.");
}

void describe(input::Visitor& v, CamClayInput& in, const Users& users) {
  v.key("lambda", in.compression, users.need(plain().above(0)).example("0.089"),
        "λ, slope of the normal-compression line in the plane of void ratio and ln p'; the compression index over "
        "2.303.");
  v.key("kappa", in.swelling, users.need(plain().above(0)).example("0.022"),
        "κ, slope of the swelling lines in that plane; less than λ. The bulk modulus is (1+e)p'/κ.");
  v.key("critical_state_slope", in.critical_state_slope,
        users.need(plain().above(0).below(3)).usual(0.4, 2).example("1.2"),
        "M₀, slope q/p' of the critical-state line of the soil without roots; 6 sin φ'/(3 - sin φ') in compression.");
  v.key("suction_hardening", in.suction_hardening, users.allow(plain().at_least(0)),
        "b: p'c is exp(b(1 - S)) times that of the saturated soil, S being the degree of saturation; 0: suction does "
        "not harden the soil.");
  v.key("smallest_pressure", in.smallest_pressure, users.allow(quantity("kPa").above(0)),
        "Floor of p' in the bulk modulus (1+e)p'/κ, which would vanish at a free surface.");
}

void describe(input::Visitor& v, Preconsolidation& in, const Users& users) {
  v.key("preconsolidation", in.preconsolidation, users.allow(quantity("kPa").above(0)).example("125"),
        "p'c₀, preconsolidation pressure of the saturated soil without roots. Where the stress at the start needs a "
        "larger one, the soil is normally consolidated there. Either this or `preconsolidation_ratio` is needed.");
  v.key("preconsolidation_ratio", in.preconsolidation_ratio, users.allow(plain().at_least(1)).example("3"),
        "R₀ instead: p'c₀ over the mean effective stress at the end of the stage that initial.equilibrium names. Until "
        "then the soil is elastic.");
}

void describe(input::Visitor& v, RootParameters& in, const Users& users) {
  input::PerCent<double> content{in.root_content};
  v.key("root_content", content, users.allow(quantity("%").at_least(0).below(100)).example("0.88"),
        "m_r, dry root mass over dry soil mass, where no [[roots]] says otherwise. A plain number is per cent: 0.88, "
        "not 0.0088.");
  v.key("root_hardening", in.hardening, users.need(plain().at_least(0)).example("0.28"),
        "R_p, per per cent of root content: at the start p'c is exp(R_p m_r) times that of the soil without roots, and "
        "grows as the roots are activated.");
  v.key("root_strength", in.strength, users.need(plain().at_least(0)).example("0.18"),
        "R_a, per per cent of root content: the critical-state slope is M₀ + R_a m_r.");
  v.key("root_activation", in.activation, users.allow(plain().at_least(0)).example("0.5"),
        "How fast p'c grows with the activation strain, as one number in the place of R_p m_r; 0: not at all. If not "
        "given, R_p m_r.");
  v.key("root_breaking_strain", in.breaking_strain, users.allow(plain().above(0).or_infinite()).example("0.3"),
        "Activation strain (volumetric and deviatoric strain, added up) at which roots begin to break; inf: never.");
  v.key("root_breaking_range", in.breaking_range, users.allow(plain().above(0)),
        "Further activation strain within which they break, one after the other.");
  v.key("root_residual_share", in.residual_share, users.allow(plain().at_least(0).at_most(1)),
        "Share of the roots that holds for ever.");
}

void describe(input::Visitor& v, ExternalParameters& in, const Users& users) {
  v.key("library", in.library, users.need(plain()).example(R"("model.so")"),
        "The shared library that holds the UMAT; its path is relative to the case file.");
  v.key("symbol", in.symbol, users.allow(plain()),
        "Name of the subroutine in it; Fortran compilers call UMAT \"umat_\".");
  v.key("constants", in.constants, users.allow(plain()).example("[45e6, 0.3]"),
        "PROPS, the constants that the UMAT expects, in SI units (stress in Pa).");
  v.key("states", in.states, users.allow(plain().at_least(0).at_most(20)),
        "NSTATV, how many state variables each point has.");
  v.key("initial_states", in.initial_states, users.allow(plain()).example("[125e3]"),
        "STATEV at the start; zero where not given.");
  v.key("constrained_modulus", in.constrained_modulus, users.need(quantity("kPa").above(0)).example("60000"),
        "The largest stiffness in one-dimensional compression that the UMAT can have; it sets the time step.");
}

}  // namespace talus::material
