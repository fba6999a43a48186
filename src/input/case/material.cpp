#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <vector>

#include "base/nearest.hpp"
#include "base/units.hpp"
#include "input/case/checks.hpp"

namespace talus::input {
namespace {

template <class Map>
std::vector<std::string> list_names(const Map& map) {
  std::vector<std::string> names;
  for (const auto& entry : map) names.push_back(entry.first);
  return names;
}

std::string join(const std::set<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text.empty() ? "there are none" : text;
}

/// "did you mean 'sand'?" or the list of what there is.
std::string suggest(const std::string& word, const std::set<std::string>& names) {
  const std::string near = find_nearest(word, {names.begin(), names.end()});
  return near.empty() ? "known: " + join(names) : fmt::format("did you mean '{}'?", near);
}

void check_strength(const Material& m, const std::string& path, Findings& findings) {
  if (!is_mohr_coulomb(m)) return;
  const double degree = units::get_si_factor("deg");
  const auto is_sound = [&](const char* key) { return findings.is_sound(path + "." + key); };
  const bool has_angle = is_sound("friction_angle");
  if (has_angle && is_sound("dilatancy_angle") && m.dilatancy_angle > m.friction_angle)
    findings.add(
        path + ".dilatancy_angle",
        fmt::format("'dilatancy_angle' is {:.6g} deg; it must not be greater than the friction angle, {:.6g} deg",
                    m.dilatancy_angle / degree, m.friction_angle / degree));
  // Without friction the yield surface has no apex, and tension is limited by nothing else.
  if (!has_angle || !is_sound("cohesion") || !is_sound("tensile_strength") || m.friction_angle <= 0) return;
  const double apex = m.cohesion / std::tan(m.friction_angle);
  if (m.tensile_strength > apex * (1 + 1e-12))
    findings.add(path + ".tensile_strength",
                 fmt::format("'tensile_strength' is {:.6g} kPa; it must not be above the apex of the yield surface, "
                             "cohesion/tan(friction_angle) = {:.6g} kPa",
                             m.tensile_strength / 1e3, apex / 1e3));
}

void check_cam_clay(const Material& m, const std::string& name, Findings& findings) {
  if (!is_cam_clay(m)) return;
  const std::string path = "materials." + name;
  const CamClaySoil& clay = m.cam_clay;
  if (findings.is_sound(path + ".lambda") && findings.is_sound(path + ".kappa") && clay.swelling >= clay.compression)
    findings.add(path + ".kappa", fmt::format("'kappa' is {:.6g} and 'lambda' is {:.6g}; κ must be smaller than λ",
                                              clay.swelling, clay.compression));
  if (findings.is_sound(path + ".porosity") && findings.is_sound(path + ".void_ratio") && m.porosity <= 0)
    findings.add(
        path + (m.given_void_ratio ? ".void_ratio" : ".porosity"),
        fmt::format("material '{}' has no pores, but the stiffness and the hardening of Cam-clay follow from its "
                    "void ratio; give one above 0",
                    name));
  if (findings.is_sound(path + ".preconsolidation") && findings.is_sound(path + ".preconsolidation_ratio")) {
    if (!clay.preconsolidation && !clay.preconsolidation_ratio)
      findings.add(path,
                   fmt::format("material '{}' is Cam-clay; give its 'preconsolidation', for example 125 (kPa), or "
                               "its 'preconsolidation_ratio'",
                               name));
    else if (clay.preconsolidation && clay.preconsolidation_ratio)
      findings.add(path + ".preconsolidation_ratio",
                   fmt::format("material '{}' has both a preconsolidation and a preconsolidation_ratio; give one of "
                               "them",
                               name));
  }
  if (std::isfinite(m.roots.breaking_strain) || !findings.is_sound(path + ".root_breaking_strain")) return;
  for (const char* key : {".root_breaking_range", ".root_residual_share"})
    if (findings.places.is_given(path + key) && findings.is_sound(path + key))
      findings.add(path + key,
                   fmt::format("'{}' has no meaning without 'root_breaking_strain', at which roots begin to "
                               "break",
                               key + 1));
}

void check_external(const Material& m, const std::string& path, const Initial& initial, Findings& findings) {
  namespace fs = std::filesystem;
  if (m.model != MaterialModel::external) return;
  const ExternalModel& external = m.external;
  if (findings.is_sound(path + ".library") && !fs::is_regular_file(external.library_file))
    findings.add(path + ".library",
                 fmt::format("there is no library '{}'; its path is relative to the case file", external.library_file));
  if (findings.is_sound(path + ".states") && findings.is_sound(path + ".initial_states") &&
      external.initial_states.size() > static_cast<std::size_t>(external.states))
    findings.add(path + ".initial_states", fmt::format("'initial_states' has {} numbers, but 'states' is {}",
                                                       external.initial_states.size(), external.states));
  if (initial.stress == InitialStress::k0 && !initial.k0 && findings.is_sound("initial"))
    findings.add(
        "initial.stress",
        "stress = \"k0\" needs 'k0' in [initial]: an external model has no Poisson's ratio that it would follow "
        "from");
}

}  // namespace

double Material::constrained_modulus() const {
  return young_modulus * (1 - poisson_ratio) / ((1 + poisson_ratio) * (1 - 2 * poisson_ratio));
}

bool is_mohr_coulomb(const Material& material) {
  return material.model == MaterialModel::mohr_coulomb || material.model == MaterialModel::rooted_mohr_coulomb;
}

bool is_cam_clay(const Material& material) {
  return material.model == MaterialModel::modified_cam_clay || material.model == MaterialModel::rooted_cam_clay;
}

void check_regions(const Case& data, const std::set<std::string>& regions, Findings& findings) {
  for (const std::string& region : regions)
    if (data.regions.count(region) == 0 && findings.is_sound("regions." + region))
      findings.add("regions." + region,
                   fmt::format("region '{}' has no material: write {} = \"MATERIAL\" in [regions]", region, region));
  for (const auto& [region, material] : data.regions)
    if (regions.count(region) == 0)
      findings.add("regions." + region, fmt::format("there is no region '{}'; {}", region, suggest(region, regions)));
  for (const auto& [region, velocity] : data.initial.velocity)
    if (regions.count(region) == 0)
      findings.add("initial.velocity." + region,
                   fmt::format("there is no region '{}'; {}", region, suggest(region, regions)));
}

void check_materials(const Case& data, Findings& findings) {
  std::set<std::string> materials, used;
  for (const auto& [name, material] : data.materials) {
    materials.insert(name);
    if (!findings.is_sound("materials." + name + ".model")) continue;
    check_strength(material, "materials." + name, findings);
    check_cam_clay(material, name, findings);
    check_external(material, "materials." + name, data.initial, findings);
  }
  if (materials.empty() && findings.is_sound("materials"))
    findings.add("materials", "there is no material: add a table [materials.NAME]");
  for (const auto& [region, material] : data.regions) {
    used.insert(material);
    if (materials.count(material) == 0)
      findings.add("regions." + region,
                   fmt::format("there is no material '{}'; {}", material, suggest(material, materials)));
  }
  for (const PointTest& test : data.tests) used.insert(test.material);
  // Regions of a ready mesh are known only when it is read: check_against_mesh().
  if (data.mesh.file.empty() && findings.is_sound("geometry.polygon") && !data.mesh.polygons.empty()) {
    std::set<std::string> regions;
    for (const mesh::Polygon& polygon : data.mesh.polygons) regions.insert(polygon.name);
    check_regions(data, regions, findings);
  }
  // Where a region has a wrong material or none, the right one seems unused, which is no fault of its own.
  if (!findings.is_sound("regions")) return;
  // Nor is it one where --set or a study gives a region another material: that is how soils are compared.
  for (const auto& [region, material] : data.regions)
    if (findings.places.find("regions." + region).line == 0) return;
  for (const std::string& name : materials)
    if (used.count(name) == 0)
      findings.add("materials." + name, fmt::format("material '{}' is not used: no region in [regions] has it", name));
}

}  // namespace talus::input
