// SPDX-License-Identifier: MIT
#pragma once
// The input of constitutive laws in blocks of keys, each with the law that introduces it; laws share blocks.

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "material/blocks.hpp"
#include "material/properties.hpp"

namespace talus::material {

/// Strength of soil that softens in methods of limit states.
enum class LimitStrength { peak, residual };

/// Meridian on which cone and pyramid agree, or the state of plane strain at failure.
enum class ConeMatch { plane_strain, compression, extension, inscribed };

}  // namespace talus::material

namespace talus::input {

template <>
inline constexpr auto choices<material::LimitStrength> = std::array{
    Choice{material::LimitStrength::peak, "peak", "that before any softening: for a first failure at small strain"},
    Choice{material::LimitStrength::residual, "residual", "the softened one: for a slide that has moved before"},
};

template <>
inline constexpr auto choices<material::ConeMatch> = std::array{
    Choice{material::ConeMatch::plane_strain, "plane_strain", "in plane strain at failure, with the given ψ"},
    Choice{material::ConeMatch::compression, "compression", "in triaxial compression: around the pyramid"},
    Choice{material::ConeMatch::extension, "extension", "in triaxial extension"},
    Choice{material::ConeMatch::inscribed, "inscribed", "the largest cone within the pyramid"},
};

}  // namespace talus::input

namespace talus::material {

struct YoungInput {
  double young_modulus = 0;  ///< E [Pa]
};
void describe(input::Visitor& v, YoungInput& in, const Users& users);

struct PoissonInput {
  double poisson_ratio = 0;  ///< ν [-]
};
void describe(input::Visitor& v, PoissonInput& in, const Users& users);

/// Strength parameters: the block of input, and the strength that the law uses.
struct MohrCoulombStrength {
  double cohesion = 0;          ///< c [Pa]
  double friction_angle = 0;    ///< φ [rad]
  double dilatancy_angle = 0;   ///< ψ [rad]
  double tensile_strength = 0;  ///< σ_t [Pa]

  /// Returns the strength with c/F and arctan(tanφ/F), (3.14-3.15). The dilatancy angle is unchanged but at most the
  /// reduced friction angle. The tensile strength is divided like the cohesion, so that its ratio to the cohesion is
  /// unchanged.
  MohrCoulombStrength reduced(double factor) const;
  /// Replaces the cohesion by that of the stage, if given, and reduces the strength.
  MohrCoulombStrength changed(const StrengthChange& change) const;
  /// Reports ψ > φ, and a tensile strength above the apex.
  void check(const SoilFindings& findings) const;
  Properties list_properties() const;
  void divide(PartialDivision& division);
};
void describe(input::Visitor& v, MohrCoulombStrength& in, const Users& users);

/// A cohesion that grows with depth.
struct CohesionGradient {
  double cohesion_gradient = 0;  ///< growth of c below `cohesion_level` [Pa/m]
  double cohesion_level = 0;     ///< [m]

  /// Returns the increase of the cohesion at a level [Pa].
  double find_extra(double level) const { return cohesion_gradient * std::max(0.0, cohesion_level - level); }
};
void describe(input::Visitor& v, CohesionGradient& in, const Users& users);

struct RootCohesionInput {
  double root_cohesion = 0;  ///< c_r where no [[roots]] sets it [Pa]
};
void describe(input::Visitor& v, RootCohesionInput& in, const Users& users);

struct ResidualStrength {
  double residual_cohesion = 0;        ///< [Pa]
  double residual_friction_angle = 0;  ///< [rad]
};
void describe(input::Visitor& v, ResidualStrength& in, const Users& users);

/// Strain over which a strength falls, and the strength of methods without softening.
struct SofteningRange {
  double softening_start = 0;  ///< ε_q^p at which the strength begins to fall [-]
  double softening_end = 0;    ///< ε_q^p at which it is residual [-]
  LimitStrength limit_strength = LimitStrength::residual;
  bool is_associated = false;  ///< ψ = φ at every strain; set by FEM, not by the case

  /// Returns the share of the softening that a strain has caused, from 0 to 1.
  double find_share(double strain) const {
    return strain <= softening_start ? 0
           : strain >= softening_end ? 1
                                     : (strain - softening_start) / (softening_end - softening_start);
  }
  void check(const SoilFindings& findings) const;
  void add_properties(Properties& list) const;
};
void describe(input::Visitor& v, SofteningRange& in, const Users& users);

struct DruckerPragerInput {
  ConeMatch cone = ConeMatch::plane_strain;
};
void describe(input::Visitor& v, DruckerPragerInput& in, const Users& users);

struct TrescaInput {
  double undrained_strength = 0;          ///< s_u at `undrained_level` and above [Pa]
  double undrained_gradient = 0;          ///< growth of s_u below that level [Pa/m]
  double undrained_level = 0;             ///< [m]
  std::vector<double> profile_strengths;  ///< s_u along the profile instead [Pa]

  /// Returns the increase of s_u at a level [Pa].
  double find_growth(double level) const { return undrained_gradient * std::max(0.0, undrained_level - level); }
};
void describe(input::Visitor& v, TrescaInput& in, const Users& users);

/// Places of a profile, of which a soil gives elevations or depths.
struct StrengthProfile {
  std::vector<double> profile_levels;  ///< elevations, from the top down [m]
  std::vector<double> profile_depths;  ///< under the ground, increasing [m]
  std::vector<double> profile_x;       ///< horizontal places of several profiles, increasing; empty: one profile [m]

  bool is_given() const { return !profile_levels.empty() || !profile_depths.empty(); }
  /// Returns the value at a place, elevation and depth [m], linear between the places and constant beyond them. Values
  /// are given profile by profile.
  double interpolate(const std::vector<double>& values, double x, double level, double depth) const;
  /// Reports a profile without places, with two kinds of places, in the wrong order, or of another length than the
  /// `values` of `key`.
  void check(const SoilFindings& findings, const char* key, const std::vector<double>& values) const;
};
void describe(input::Visitor& v, StrengthProfile& in, const Users& users);

struct ShansepInput {
  double strength_ratio = 0;                     ///< S [-]
  double strength_exponent = 0;                  ///< m [-]
  double added_strength = 0;                     ///< A [Pa]
  std::optional<double> ocr;                     ///< [-]
  std::vector<double> profile_ocr;               ///< [-]
  std::vector<double> profile_preconsolidation;  ///< σ'_p [Pa]
};
void describe(input::Visitor& v, ShansepInput& in, const Users& users);

struct AdpInput {
  double direct_ratio = 1;   ///< s_uD/s_uA [-]
  double passive_ratio = 1;  ///< s_uP/s_uA [-]
};
void describe(input::Visitor& v, AdpInput& in, const Users& users);

struct AnisotropicInput {
  std::vector<double> base_inclinations;   ///< increasing [rad]
  std::vector<double> inclined_cohesions;  ///< [Pa]
  std::vector<double> inclined_frictions;  ///< [rad]
};
void describe(input::Visitor& v, AnisotropicInput& in, const Users& users);

struct BeddingInput {
  double bedding_angle = 0;                  ///< [rad]
  double bedding_cohesion = 0;               ///< [Pa]
  double bedding_friction = 0;               ///< [rad]
  double bedding_range = 0;                  ///< A [rad]
  std::optional<double> bedding_transition;  ///< B [rad]
  double bedding_dilatancy = 0;              ///< [rad]
};
void describe(input::Visitor& v, BeddingInput& in, const Users& users);

struct PowerCurveInput {
  double power_factor = 0;    ///< a, for stresses in kPa [kPa^(1-b)]
  double power_exponent = 0;  ///< b [-]
  double power_shift = 0;     ///< d [Pa]
  double power_cohesion = 0;  ///< c [Pa]
};
void describe(input::Visitor& v, PowerCurveInput& in, const Users& users);

struct FlowRatio {
  double dilatancy_ratio = 0;  ///< tan ψ over tan φ of the tangent [-]
};
void describe(input::Visitor& v, FlowRatio& in, const Users& users);

struct StrengthTableInput {
  std::vector<double> normal_stresses;  ///< σ'_n, increasing [Pa]
  std::vector<double> shear_strengths;  ///< τ [Pa]
};
void describe(input::Visitor& v, StrengthTableInput& in, const Users& users);

struct HoekBrownInput {
  double intact_strength = 0;  ///< σ_ci [Pa]
  double gsi = 0;              ///< [-]
  double intact_constant = 0;  ///< m_i [-]
  double disturbance = 0;      ///< D [-]
};
void describe(input::Visitor& v, HoekBrownInput& in, const Users& users);

struct ResidualIndex {
  double residual_gsi = 0;  ///< [-]
};
void describe(input::Visitor& v, ResidualIndex& in, const Users& users);

struct JointInput {
  double joint_roughness = 0;    ///< JRC [-]
  double joint_strength = 0;     ///< JCS [Pa]
  double residual_friction = 0;  ///< φ_r [rad]
};
void describe(input::Visitor& v, JointInput& in, const Users& users);

/// Cam-clay parameters of the case; Poisson's ratio is in PoissonInput.
struct CamClayInput {
  double compression = 0, swelling = 0, critical_state_slope = 0, suction_hardening = 0, smallest_pressure = 1e3;
};
void describe(input::Visitor& v, CamClayInput& in, const Users& users);

/// Initial preconsolidation; exactly one of the two is given.
struct Preconsolidation {
  std::optional<double> preconsolidation;  ///< p'_c0 of the saturated soil without roots [Pa]
  std::optional<double>
      preconsolidation_ratio;  ///< R_0, ratio to the mean effective stress after initial.equilibrium [-]

  void check(const SoilFindings& findings, const char* title) const;
};
void describe(input::Visitor& v, Preconsolidation& in, const Users& users);

/// Parameters of the rooted soil. Root contents are mass of roots over dry mass of soil in per cent: (4.4), (4.6) and
/// (4.10) in the units of the published runs.
struct RootParameters {
  double hardening = 0;                ///< R_p of (4.6), (4.10) [1/%]
  double strength = 0;                 ///< R_a of (4.4) [1/%]
  std::optional<double> activation{};  ///< R_p m_r of (4.10) as one number [-]; hardening × content if not given
  double breaking_strain =
      std::numeric_limits<double>::infinity();  ///< ε_r^peak, activation strain at which roots begin to break [-]
  double breaking_range = 0.1;                  ///< range of ε_r beyond the peak over which roots break, linearly [-]
  double residual_share = 0;                    ///< fraction of the root contribution that remains after breakage [-]
  double root_content = 0;                      ///< m_r^ini where no [[roots]] sets it [%]

  void check(const SoilFindings& findings) const;
};
void describe(input::Visitor& v, RootParameters& in, const Users& users);

struct ExternalParameters {
  std::string library;                 ///< path of the shared library, as given
  std::string symbol = "umat_";        ///< name of the subroutine in it
  std::string material;                ///< CMNAME
  std::vector<double> constants;       ///< PROPS
  int states = 0;                      ///< NSTATV, at most External::most_states
  std::vector<double> initial_states;  ///< zero if not given
  double constrained_modulus = 0;      ///< E_c for the critical time step [Pa]
  std::string library_file;            ///< resolved path of the library; empty: as given

  const std::string& find_library() const { return library_file.empty() ? library : library_file; }
};
void describe(input::Visitor& v, ExternalParameters& in, const Users& users);

}  // namespace talus::material
