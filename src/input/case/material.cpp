// SPDX-License-Identifier: MIT
#include "input/case/material.hpp"

#include <fmt/format.h>

#include "base/text.hpp"
#include "input/case/checks.hpp"

namespace talus::input {
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
