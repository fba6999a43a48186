#pragma once
// [materials.NAME]: the soils. Nothing here has a default: a forgotten strength must not become a number.

#include "model/case.hpp"
#include "model/codec.hpp"
#include "model/declare_water.hpp"

namespace talus::model {

template <>
inline constexpr auto choices<MaterialModel> = std::array{
    Choice{MaterialModel::mohr_coulomb, "mohr_coulomb",
           "linear elastic, perfectly plastic with Mohr–Coulomb's strength"},
    Choice{MaterialModel::linear_elastic, "linear_elastic", "linear elastic, without any strength limit"},
};

template <class Visitor>
void describe(Visitor& v, Material& m) {
  const auto strength = MaterialModel::mohr_coulomb;
  v.key("model", m.model, plain().required().example(R"("mohr_coulomb")"), "How stress follows strain.");
  v.key("grain_density", m.grain_density, quantity("kg/m3").above(0).required().example("2500"),
        "Density of the solid grains; the bulk density of the dry soil is (1 - porosity) times it.");
  v.key("porosity", m.porosity, plain().at_least(0).below(1).required().example("0.2"),
        "Share of the pores in the volume.");
  v.key("young_modulus", m.young_modulus, quantity("kPa").above(0).required().example("45000"), "Young's modulus.");
  v.key("poisson_ratio", m.poisson_ratio, plain().above(-1).below(0.5).required().example("0.3"), "Poisson's ratio.");
  v.key("cohesion", m.cohesion, quantity("kPa").at_least(0).needed_with("model", m.model, strength).example("10"),
        "Cohesion c.");
  v.key("friction_angle", m.friction_angle,
        quantity("deg").at_least(0).below(90).needed_with("model", m.model, strength).example("20"),
        "Angle of internal friction φ.");
  v.key("dilatancy_angle", m.dilatancy_angle,
        quantity("deg").at_least(0).below(90).needed_with("model", m.model, strength).example("0"),
        "Angle of dilatancy ψ of the plastic flow; at most the friction angle.");
  v.key("tensile_strength", m.tensile_strength,
        quantity("kPa").at_least(0).needed_with("model", m.model, strength).example("0"),
        "Largest tensile stress; at most c/tan φ, the apex of the yield surface.");
  v.table("water", m.water, "The pore water of this soil. Without this block the soil is dry.");
}

}  // namespace talus::model
