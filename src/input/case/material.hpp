#pragma once
// [materials.NAME]: the soils. No strength has a default here: a forgotten one must not become a number.

#include <optional>

#include "input/case/cam_clay.hpp"
#include "input/case/external.hpp"
#include "input/case/slice_soil.hpp"
#include "input/case/water.hpp"
#include "input/language/spec.hpp"

namespace talus::input {

struct Material {
  MaterialModel model = MaterialModel::linear_elastic;
  double grain_density = 0;                ///< ρ_s [kg/m³]
  double porosity = 0;                     ///< n [-]
  std::optional<double> given_void_ratio;  ///< e_0 where the case gives it; the porosity follows from it [-]
  double young_modulus = 0;                ///< E [Pa]
  double poisson_ratio = 0;                ///< ν [-]
  double cohesion = 0;                     ///< c [Pa], Mohr–Coulomb
  double friction_angle = 0;               ///< φ [rad], Mohr–Coulomb
  double dilatancy_angle = 0;              ///< ψ [rad], Mohr–Coulomb
  double tensile_strength = 0;             ///< σ_t [Pa], Mohr–Coulomb; at most the apex c/tanφ
  CamClaySoil cam_clay;
  RootedSoil roots;
  ExternalModel external;
  PoreWater water;  ///< by default none
  SliceSoil slices;

  /// e_0 = n/(1-n) [-].
  double void_ratio() const { return porosity / (1 - porosity); }
  /// Bulk density of the dry soil (1-n)ρ_s [kg/m³].
  double density() const { return (1 - porosity) * grain_density; }
  /// E_c of (2.84) of a soil with a Young's modulus [Pa].
  double constrained_modulus() const;
};

template <class Visitor>
void describe_stiffness(Visitor& v, Material& m) {
  using M = MaterialModel;
  const auto linear = {M::mohr_coulomb, M::rooted_mohr_coulomb, M::linear_elastic};
  const auto built_in = {M::mohr_coulomb, M::rooted_mohr_coulomb, M::modified_cam_clay, M::rooted_cam_clay,
                         M::linear_elastic};
  v.key("young_modulus", m.young_modulus,
        quantity("kPa").above(0).needed_with("model", m.model, linear).by_methods({"fem", "mpm"}).example("45000"),
        "Young's modulus.");
  v.key("poisson_ratio", m.poisson_ratio,
        plain().above(-1).below(0.5).needed_with("model", m.model, built_in).by_methods({"fem", "mpm"}).example("0.3"),
        "Poisson's ratio.");
}

template <class Visitor>
void describe_strength(Visitor& v, Material& m) {
  const auto strength = {MaterialModel::mohr_coulomb, MaterialModel::rooted_mohr_coulomb};
  v.key("cohesion", m.cohesion, quantity("kPa").at_least(0).needed_with("model", m.model, strength).example("10"),
        "Cohesion c of the soil itself.");
  v.key("friction_angle", m.friction_angle,
        quantity("deg").at_least(0).below(90).needed_with("model", m.model, strength).example("20"),
        "Angle of internal friction φ.");
  v.key("dilatancy_angle", m.dilatancy_angle,
        quantity("deg")
            .at_least(0)
            .below(90)
            .needed_with("model", m.model, strength)
            .by_methods({"fem", "mpm"})
            .example("0"),
        "Angle of dilatancy ψ of the plastic flow; at most the friction angle.");
  v.key("tensile_strength", m.tensile_strength,
        quantity("kPa").at_least(0).needed_with("model", m.model, strength).by_methods({"fem", "mpm"}).example("0"),
        "Largest tensile stress; at most c/tan φ, the apex of the yield surface.");
}

template <class Visitor>
void describe(Visitor& v, Material& m) {
  v.key("model", m.model, plain().required().example(R"("mohr_coulomb")"), "How stress follows strain.");
  v.key("unit_weight", m.slices.unit_weight, quantity("kN/m3").above(0).example("18"),
        "γ, weight of the soil above the water table, instead of `grain_density` and porosity. Soil whose pore water "
        "moves ([materials.NAME.water]) needs those all the same.");
  const bool is_weighed = m.slices.unit_weight.has_value();
  v.key("grain_density", m.grain_density,
        quantity("kg/m3").above(0).required().unless_given("unit_weight", is_weighed).example("2500"),
        "Density of the solid grains; the bulk density of the dry soil is (1 - porosity) times it.");
  v.key("void_ratio", m.given_void_ratio, plain().at_least(0).example("0.6"),
        "Volume of the pores over that of the grains at the start, e₀, instead of the porosity.");
  v.key("porosity", m.porosity,
        plain()
            .at_least(0)
            .below(1)
            .needed_without("void_ratio", m.given_void_ratio.has_value())
            .unless_given("unit_weight", is_weighed)
            .example("0.2"),
        "Share of the pores in the volume, e₀/(1+e₀).");
  describe_stiffness(v, m);
  describe_strength(v, m);
  describe_cam_clay(v, m.cam_clay, m.model);
  describe_rooted_soil(v, m.roots, m.model);
  describe_external(v, m.external, m.model);
  describe_slice_soil(v, m.slices, m.model);
  v.table("water", m.water, "The pore water of this soil. Without this block the soil is dry.");
}

}  // namespace talus::input
