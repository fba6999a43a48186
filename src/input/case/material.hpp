// SPDX-License-Identifier: MIT
#pragma once
// [materials.NAME]: the soils. No strength has a default here: a forgotten one must not become a number.

#include <array>
#include <optional>

#include "input/case/slice_soil.hpp"
#include "input/case/water.hpp"
#include "input/language/spec.hpp"
#include "material/law.hpp"

namespace talus::input {

using MaterialModel = material::Model;

/// The words of the laws, in their order.
template <>
inline constexpr auto choices<MaterialModel> = [] {
  std::array<Choice<MaterialModel>, material::Laws::traits.size()> list{};
  for (std::size_t i = 0; i < list.size(); ++i)
    list[i] = {MaterialModel(i), material::Laws::traits[i].word, material::Laws::traits[i].meaning};
  return list;
}();

/// What every soil has, and the numbers of all laws, of which a case gives those of its model.
struct Material : material::SoilNumbers {
  MaterialModel model = material::model_of<material::LinearElastic>;
  double grain_density = 0;                ///< ρ_s [kg/m³]
  double porosity = 0;                     ///< n [-]
  std::optional<double> given_void_ratio;  ///< e_0 where the case gives it; the porosity follows from it [-]
  PoreWater water;                         ///< by default none
  SliceSoil slices;

  const material::Traits& traits() const { return material::get_traits(model); }
  /// e_0 = n/(1-n) [-].
  double void_ratio() const { return porosity / (1 - porosity); }
  /// Bulk density of the dry soil (1-n)ρ_s [kg/m³].
  double density() const { return (1 - porosity) * grain_density; }

  // Compiled once, in material.cpp: the files that hold one would each compile them again.
  Material();
  Material(const Material&);
  Material(Material&&) noexcept;
  Material& operator=(const Material&);
  Material& operator=(Material&&) noexcept;
  ~Material();
};

/// The law of a material, its strength with another cohesion [Pa] and reduced by `factor`. Throws what
/// material::make_law() throws.
inline material::Law make_law(const Material& m, std::optional<double> cohesion = {}, double factor = 1) {
  return material::make_law(m.model, m, {factor, cohesion});
}

template <class Visitor>
void describe(Visitor& v, Material& m) {
  v.key("model", m.model, plain().required().example(R"("mohr_coulomb")"), "How stress follows strain.");
  v.key("unit_weight", m.slices.unit_weight, quantity("kN/m3").above(0).usual(10, 28, weight_slips()).example("18"),
        "γ, weight of the soil above the water table, instead of `grain_density` and porosity. Soil whose pore water "
        "moves ([materials.NAME.water]) needs its porosity all the same, and with material points both.");
  const bool is_weighed = m.slices.unit_weight.has_value();
  v.key("grain_density", m.grain_density,
        quantity("kg/m3")
            .above(0)
            .usual(2000, 3500, {{"g/cm3", 1e3}, {"kN/m3", 101.972}})
            .required()
            .unless_given("unit_weight", is_weighed)
            .example("2500"),
        "Density of the solid grains; the bulk density of the dry soil is (1 - porosity) times it.");
  v.key("void_ratio", m.given_void_ratio, plain().at_least(0).example("0.6"),
        "Volume of the pores over that of the grains at the start, e₀, instead of the porosity.");
  v.key("porosity", m.porosity,
        plain()
            .at_least(0)
            .below(1)
            .usual_or_zero(0.1, 0.9)
            .needed_without("void_ratio", m.given_void_ratio.has_value())
            .unless_given("unit_weight", is_weighed)
            .example("0.2"),
        "Share of the pores in the volume, e₀/(1+e₀).");
  m.for_each_block([&]<class Block>(Block& block) { describe(v, block, material::Laws::list_users<Block>(m.model)); });
  describe_slice_soil(v, m.slices);
  describe_slice_blocks(v, m.slices);
  v.table("water", m.water, "The pore water of this soil. Without this block the soil is dry.");
}

}  // namespace talus::input
