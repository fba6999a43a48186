// SPDX-License-Identifier: MIT
#include "input/case/material.hpp"

#include <fmt/format.h>

#include "base/text.hpp"
#include "input/case/checks.hpp"
#include "input/language/visitor.hpp"
#include "material/every_law.hpp"

namespace talus::input {

void describe(Visitor& v, UndrainedEnvelope& e) {
  v.key("cohesion", e.cohesion, quantity("kPa").at_least(0).required().example("57"), "c_R.");
  v.key("friction_angle", e.friction_angle, quantity("deg").at_least(0).below(90).required().example("16"), "φ_R.");
}

namespace {

/// Declares the parameters for LEM and FEM other than strength; `unit_weight` is declared earlier.
void describe_slice_soil(Visitor& v, SliceSoil& s) {
  v.key("saturated_unit_weight", s.saturated_unit_weight,
        quantity("kN/m3").above(0).usual(10, 28, weight_slips()).example("20"),
        "Weight of the soil with its water below the water table, for LEM and FEM; if not given, that "
        "of grains and water where `grain_density` is given, else `unit_weight`.");
  v.key("pore_pressure_ratio", s.pore_pressure_ratio, plain().at_least(0).below(1),
        "r_u, pore pressure over the weight of the soil above, instead of a water table. MPM keeps it, at frozen "
        "geometry.");
  v.key("suction_strength", s.suction_strength, plain(),
        "Strength due to suction s above the water table, for LEM, FEM and limit analysis. MPM uses "
        "[materials.NAME.water].");
  v.key("phi_b", s.phi_b,
        quantity("deg")
            .at_least(0)
            .below(90)
            .needed_with("suction_strength", s.suction_strength, SuctionStrength::phi_b)
            .example("15"),
        "φᵇ of that.");
  v.key("b_bar", s.b_bar, plain().at_least(0).at_most(1).example("1"),
        "B̄, the change of the pore pressure over that of the vertical stress, where [lem.drawdown] has method = "
        "\"b_bar\". Soil without it drains.");
}

}  // namespace

namespace {

/// Declares the blocks of SliceSoil, which follow all keys.
void describe_slice_blocks(Visitor& v, SliceSoil& s) {
  v.optional_table("undrained_envelope", s.undrained_envelope,
                   "The R envelope c_R + σ' tan φ_R of isotropically consolidated undrained tests, in total stresses, "
                   "for [lem.drawdown]. Soil without it drains.");
}

}  // namespace

const Choice<MaterialModel>* ModelChoices::begin() const {
  static constexpr auto list = [] {
    std::array<Choice<MaterialModel>, size()> made{};
    for (std::size_t i = 0; i < made.size(); ++i)
      made[i] = {MaterialModel(i), material::Laws::traits[i].word, material::Laws::traits[i].meaning};
    return made;
  }();
  return list.data();
}

material::Law make_law(const Material& m, std::optional<double> cohesion, double factor) {
  return material::make_law(m.model, m, {m.reduced ? factor : 1, cohesion});
}

void describe(Visitor& v, Material& m) {
  v.key("model", m.model, plain().required().by_methods({"lem", "fem", "bounds", "mpm"}).example(R"("mohr_coulomb")"),
        "How stress follows strain.");
  v.key("reduced", m.reduced, plain(),
        "false: the factor of safety does not divide the strength of this soil, as of a wall or of rock, in LEM, FEM, "
        "limit analysis and MPM. Partial factors divide it all the same.");
  v.key("unit_weight", m.slices.unit_weight, quantity("kN/m3").above(0).usual(10, 28, weight_slips()).example("18"),
        "γ, weight of the soil above the water table, instead of `grain_density` and porosity. Soil whose pore water "
        "moves ([materials.NAME.water]) needs its porosity all the same, and with MPM both.");
  const bool is_weighed = m.slices.unit_weight.has_value();
  v.key("grain_density", m.grain_density,
        quantity("kg/m3")
            .above(0)
            .usual(2000, 3500, {{"g/cm3", 1e3}, {"kN/m3", 101.972}})
            .required()
            .by_methods({"lem", "fem", "bounds", "mpm"})
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
void check_regions(const Case& data, const std::set<std::string>& regions, Findings& findings) {
  for (const std::string& region : regions)
    if (data.regions.count(region) == 0 && findings.is_sound("regions." + region))
      findings.add("regions." + region, "region '{}' has no material: write {} = \"MATERIAL\" in [regions]", region,
                   region);
  for (const auto& [region, material] : data.regions)
    if (regions.count(region) == 0)
      findings.add("regions." + region, "there is no region '{}'; {}", region,
                   talus::suggest(region, {regions.begin(), regions.end()}));
  for (const auto& [region, velocity] : data.initial.velocity)
    if (regions.count(region) == 0)
      findings.add("initial.velocity." + region, "there is no region '{}'; {}", region,
                   talus::suggest(region, {regions.begin(), regions.end()}));
}

void check_materials(const Case& data, Findings& findings) {
  std::set<std::string> materials, used;
  for (const auto& [name, material] : data.materials) {
    materials.insert(name);
    if (!findings.is_sound("materials." + name + ".model")) continue;
    material::check_soil(material.model, material,
                         {name, material.porosity, material.given_void_ratio.has_value(), findings, data.units()});
    if (data.initial.stress != InitialStress::none && !data.initial.k0 && findings.is_sound("initial") &&
        !material::needs<material::PoissonInput>(material.model))
      findings.add(
          "initial.stress",
          "stress = \"{}\" needs 'k0' in [initial]: an {} model has no Poisson's ratio that it would follow from",
          get_word(data.initial.stress), material.traits().title);
  }
  if (materials.empty() && findings.is_sound("materials"))
    findings.add("materials", "there is no material: add a table [materials.NAME]");
  for (const auto& [region, material] : data.regions) {
    used.insert(material);
    if (materials.count(material) == 0)
      findings.add("regions." + region, "there is no material '{}'; {}", material,
                   talus::suggest(material, {materials.begin(), materials.end()}));
  }
  for (const PointTest& test : data.tests) used.insert(test.material);
  for (const ConstructionStage& stage : data.construction)
    for (const auto& [region, material] : stage.soils) used.insert(material);
  // Regions of an external mesh are known only after it is read: check_against_mesh().
  if (data.mesh.file.empty() && findings.is_sound("geometry.polygon") && !data.mesh.polygons.empty()) {
    std::set<std::string> regions;
    for (const mesh::Polygon& polygon : data.mesh.polygons) regions.insert(polygon.name);
    check_regions(data, regions, findings);
  }
  // A region with a wrong material or none leaves the intended material unused; that is not reported again.
  if (!findings.is_sound("regions")) return;
  // An unused material is also no fault if --set or a study assigns another one to a region, to compare soils.
  for (const auto& [region, material] : data.regions)
    if (findings.places.find("regions." + region).line == 0) return;
  for (const std::string& name : materials)
    if (used.count(name) == 0)
      findings.warn("materials." + name, "material '{}' is not used: no region in [regions] has it", name);
}

}  // namespace talus::input
