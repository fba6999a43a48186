#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/nearest.hpp"
#include "base/units.hpp"
#include "model/checks.hpp"

namespace talus::model {
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
  if (m.model != MaterialModel::mohr_coulomb) return;
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

}  // namespace

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
    check_strength(material, "materials." + name, findings);
  }
  if (materials.empty() && findings.is_sound("materials"))
    findings.add("materials", "there is no material: add a table [materials.NAME]");
  for (const auto& [region, material] : data.regions) {
    used.insert(material);
    if (materials.count(material) == 0)
      findings.add("regions." + region,
                   fmt::format("there is no material '{}'; {}", material, suggest(material, materials)));
  }
  // Regions of a ready mesh are known only when it is read: check_against_mesh().
  if (data.mesh.file.empty() && findings.is_sound("geometry.polygon") && !data.mesh.polygons.empty()) {
    std::set<std::string> regions;
    for (const mesh::Polygon& polygon : data.mesh.polygons) regions.insert(polygon.name);
    check_regions(data, regions, findings);
  }
  // Where a region has a wrong material or none, the right one seems unused, which is no fault of its own.
  if (!findings.is_sound("regions")) return;
  for (const std::string& name : materials)
    if (used.count(name) == 0)
      findings.add("materials." + name, fmt::format("material '{}' is not used: no region in [regions] has it", name));
}

}  // namespace talus::model
