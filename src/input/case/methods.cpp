// SPDX-License-Identifier: MIT
// Checks of [analysis] methods: requirements and limitations of each method.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "input/case/case.hpp"
#include "input/case/checks.hpp"
#include "input/case/elements_and_bounds.hpp"
#include "input/case/support_places.hpp"
#include "mesh/ground.hpp"

namespace talus::input {

namespace {

void check_list(const Case& data, Findings& findings) {
  if (data.methods.empty())
    findings.add("analysis.methods",
                 "'methods' is empty; name at least one of \"lem\", \"fem\", \"bounds\", \"mpm\" and \"seepage\"");
  for (std::size_t i = 1; i < data.methods.size(); ++i)
    if (std::find(data.methods.begin(), data.methods.begin() + static_cast<std::ptrdiff_t>(i), data.methods[i]) !=
        data.methods.begin() + static_cast<std::ptrdiff_t>(i))
      findings.add(fmt::format("analysis.methods.{}", i), "'methods' names \"{}\" twice", get_word(data.methods[i]));
}

/// Checks that LEM, FEM and limit analysis start from the section of the file, not from a result.
void check_plain_start(const Case& data, Findings& findings) {
  if (!data.initial.result.empty() && findings.is_sound("initial.result"))
    findings.add("initial.result",
                 "'result' is not possible with the methods \"lem\", \"fem\" and \"bounds\": only MPM "
                 "resumes from another result");
  if (data.gravity.acceleration == 0 && findings.is_sound("gravity.acceleration"))
    findings.add("gravity.acceleration", "'acceleration' is 0, but a factor of safety needs a weight");
  const std::array<double, 3>& down = data.gravity.direction;
  if (uses(data, Method::lem) && findings.is_sound("gravity.direction") &&
      !(down[0] == 0 && down[1] < 0 && down[2] == 0))
    findings.add("gravity.direction",
                 "'direction' is inclined, but LEM needs gravity along y; give a horizontal acceleration in "
                 "[earthquake] instead");
}

void check_slices_need(const Case& data, Findings& findings) {
  if (data.mesh.dimension != 2 && findings.is_sound("geometry.dimension"))
    findings.add("geometry.dimension",
                 "'dimension' is 3, but LEM analyses a plane section; take \"lem\" out of 'methods' in [analysis]");
  if (!data.mesh.file.empty() && findings.is_sound("mesh.file"))
    findings.add("mesh.file",
                 "LEM needs the polygons of the section, which a ready mesh does not have; write them as "
                 "[[geometry.polygon]], or take \"lem\" out of 'methods' in [analysis]");
  for (const auto& [name, material] : data.materials) {
    const std::string path = "materials." + name + ".model";
    if (findings.is_sound(path) && !material.traits().serves_slices)
      findings.add(path,
                   "material '{}' has no cohesion and friction angle for LEM, which takes {} and, as rock that no "
                   "surface passes through, {}",
                   name, material::list_sliceable(), material::list_words([](const material::Traits& t) {
                     return t.strength == material::Strength::none;
                   }));
  }
}

/// Reports what the methods on the whole section cannot model: hidden strengths, and walls with friction or velocity.
/// `who` and `words` are the titles and words of those methods that the case uses.
void check_reduces(const Case& data, const std::string& who, const std::string& words, Findings& findings) {
  for (const auto& [name, material] : data.materials) {
    const std::string path = "materials." + name + ".model";
    if (material.traits().strength == material::Strength::hidden && material.reduced && findings.is_sound(path))
      findings.add(
          path,
          "strength reduction ({}) is not possible with material '{}': which of the constants of an external model "
          "are its strength is not known",
          who, name);
  }
  for (std::size_t i = 0; i < data.boundaries.size(); ++i) {
    const Boundary& b = data.boundaries[i];
    const std::string path = fmt::format("boundary.{}.fix", i);
    if ((b.fix == Fix::friction || b.fix == Fix::velocity) && findings.is_sound(path))
      findings.add(
          path, "a {1} is not possible with {0}; take {2} out of 'methods' in [analysis], or fix '{3}' in another way",
          who, b.fix == Fix::friction ? "wall with friction" : "boundary that moves", words, b.on);
  }
  if (data.boundaries.empty() && uses(data, Method::mpm) && findings.is_sound("boundary"))
    findings.add("boundary", "there is no [[boundary]]: {} and MPM need fixed sides", who);
}

void check_reduces(const Case& data, Findings& findings) {
  std::string who, words;
  for (const Method method : {Method::fem, Method::bounds}) {
    if (!uses(data, method)) continue;
    const char* between = who.empty() ? "" : " and ";
    who += between + std::string(get_title(method));
    words += fmt::format("{}\"{}\"", between, get_word(method));
  }
  if (!who.empty()) check_reduces(data, who, words, findings);
}

void check_elements_need(const Case& data, Findings& findings) {
  if (data.mesh.file.empty() && !data.fem.size && data.mesh.size == 0 && findings.is_sound("mesh.size") &&
      findings.is_sound("fem.size"))
    findings.add("mesh", "FEM needs a size: give 'size' in [mesh], or in [fem]");
  if (findings.is_sound("fem.from") && findings.is_sound("fem.to") && data.fem.from >= data.fem.to)
    findings.add(findings.places.is_given("fem.from") ? "fem.from" : "fem.to",
                 "'from' is {:.6g} and 'to' is {:.6g}; 'from' must be smaller", data.fem.from, data.fem.to);
}

/// Reports materials without one pair of angles for Davis's strength.
void check_davis(const Case& data, const char* key, Findings& findings) {
  if (!findings.is_sound(key)) return;
  for (const auto& [name, material] : data.materials) {
    const bool is_other_cone = material.model == material::model_of<material::DruckerPrager> &&
                               material.cone != material::ConeMatch::plane_strain;
    if (is_other_cone || material::needs<material::FlowRatio>(material.model) ||
        material::needs<material::BeddingInput>(material.model))
      findings.add(key,
                   "Davis's strength needs the angles φ and ψ of an isotropic soil with a straight envelope in plane "
                   "strain, and material '{}' ({}) has none; take 'davis' out",
                   name, material.traits().title);
  }
}

void check_davis_of_elements(const Case& data, Findings& findings) {
  check_davis(data, "fem.davis", findings);
  if (data.fem.flow == FlowRule::associated && findings.is_sound("fem.davis"))
    findings.add("fem.davis", "'davis' replaces the trials with ψ as given, and flow = \"associated\" has none");
}

/// Checks that progressive failure has a soil that softens, and the strains over which it does.
void check_progressive_failure(const Case& data, Findings& findings) {
  if (!findings.is_sound("fem.softening")) return;
  bool softens = false;
  for (const auto& [name, material] : data.materials) {
    if (!material::needs<material::SofteningRange>(material.model)) continue;
    softens = true;
    const std::string path = "materials." + name;
    if (!findings.places.is_given(path + ".softening_end") && findings.is_sound(path + ".softening_end") &&
        !uses(data, Method::mpm))
      findings.add(path, "'softening_end' of material '{}' is missing; [fem] softening = \"progressive\" needs it",
                   name);
  }
  if (!softens)
    findings.add("fem.softening",
                 "'softening' is \"progressive\", but no soil of the case softens; those of model {} do",
                 material::list_words([](const material::Traits& t) { return t.softens && t.serves_slices; }));
  if (softens && data.fem.davis != DavisRule::none && findings.is_sound("fem.davis"))
    findings.add("fem.davis",
                 "Davis's strength needs constant angles φ and ψ, and those of soil that softens fall; take 'davis' "
                 "or softening = \"progressive\" out");
}

void check_bounds_need(const Case& data, Findings& findings) {
  if (data.mesh.dimension != 2 && findings.is_sound("geometry.dimension"))
    findings.add("geometry.dimension",
                 "'dimension' is 3, but limit analysis needs a plane section; take \"bounds\" out of 'methods' "
                 "in [analysis]");
  if (!data.mesh.file.empty() && findings.is_sound("mesh.file"))
    findings.add("mesh.file",
                 "limit analysis makes its own meshes from the polygons of the section, which a ready mesh does not "
                 "have; write them as [[geometry.polygon]], or take \"bounds\" out of 'methods' in [analysis]");
  for (const auto& [name, material] : data.materials) {
    const std::string path = "materials." + name + ".model";
    if (material.traits().strength != material::Strength::hidden && !material.traits().serves_slices &&
        findings.is_sound(path))
      findings.add(path, "material '{}' has no cohesion and friction angle for limit analysis, which takes {}", name,
                   material::list_sliceable());
  }
}

/// Reports laws whose strength LEM alone has.
void check_only_slices(const Case& data, Findings& findings) {
  std::string others;
  for (const Method method : {Method::fem, Method::bounds, Method::mpm})
    if (uses(data, method)) others += fmt::format("{}\"{}\"", others.empty() ? "" : ", ", get_word(method));
  if (others.empty()) return;
  for (const auto& [name, material] : data.materials)
    if (material.traits().only_slices && findings.is_sound("materials." + name + ".model"))
      findings.add(
          "materials." + name + ".model",
          "the strength of material '{}' ({}) serves LEM only; take {} out of 'methods' in [analysis], or give "
          "the material another model",
          name, material.traits().title, others);
}

/// Reports cones whose strength in plane strain a factor does not divide like c and tan φ, as those of LEM.
void check_cones(const Case& data, Findings& findings) {
  std::string users;
  for (const Method method : {Method::lem, Method::bounds})
    if (uses(data, method)) users += fmt::format("{}\"{}\"", users.empty() ? "" : ", ", get_word(method));
  if (users.empty()) return;
  for (const auto& [name, material] : data.materials)
    if (material.model == material::model_of<material::DruckerPrager> &&
        material.cone != material::ConeMatch::plane_strain && findings.is_sound("materials." + name + ".cone"))
      findings.add("materials." + name + ".cone",
                   "LEM and limit analysis take cone = \"plane_strain\" only, because a factor of safety changes the "
                   "plane strength of another cone in another way; change it for material '{}', or take {} out of "
                   "'methods' in [analysis]",
                   name, users);
}

/// Reports strengths by depth or by σ'_v without a section, which gives the soil above a point.
void check_columns(const Case& data, Findings& findings) {
  if (data.mesh.dimension == 2 && data.mesh.file.empty()) return;
  for (const auto& [name, material] : data.materials) {
    const bool by_stress = material.model == material::model_of<material::Shansep>;
    const std::string path = "materials." + name + (by_stress ? ".model" : ".profile_depths");
    if ((by_stress || !material.profile_depths.empty()) && findings.is_sound(path))
      findings.add(path, "{} of material '{}' needs a plane section of [[geometry.polygon]] or layers",
                   by_stress ? "the strength by σ'_v" : "the strength by depth", name);
  }
}

void check_has_strength(const Case& data, Findings& findings) {
  if (!findings.is_sound("materials") || data.materials.empty()) return;
  // Stages without a factor compute stress and flow alone.
  if (!data.construction.empty() && std::none_of(data.construction.begin(), data.construction.end(),
                                                 [](const ConstructionStage& stage) { return stage.factor; }))
    return;
  if (std::none_of(data.materials.begin(), data.materials.end(), [](const auto& entry) {
        return entry.second.traits().strength == material::Strength::known && entry.second.reduced;
      }))
    findings.add("analysis.methods",
                 "a factor of safety needs a material with a strength, which is not excluded by reduced = false");
}

/// Reports a pore pressure ratio r_u together with a pore pressure field.
void check_pressure_ratio(const Material& m, const std::string& name, Findings& findings) {
  const std::string path = "materials." + name + ".pore_pressure_ratio";
  if (m.slices.pore_pressure_ratio != 0 && m.water.is_wet() && findings.is_sound(path))
    findings.add(path,
                 "material '{}' has a pore pressure ratio and pore water, [materials.{}.water]; give one of them "
                 "for MPM and for stages of construction",
                 name, name);
}

/// Returns the lowest level of a material's regions [m]; infinity if there is none.
double find_bottom(const Case& data, const std::string& material) {
  double bottom = std::numeric_limits<double>::infinity();
  for (const mesh::Polygon& polygon : data.mesh.polygons) {
    const auto region = data.regions.find(polygon.name);
    if (region == data.regions.end() || region->second != material) continue;
    for (const auto& p : polygon.points) bottom = std::min(bottom, p[1]);
  }
  return bottom;
}

void check_cohesion_gradient(const Case& data, const Material& m, const std::string& name, Findings& findings) {
  const std::string path = "materials." + name;
  const material::CohesionGradient& s = m;
  if (findings.places.is_given(path + ".cohesion_gradient") != findings.places.is_given(path + ".cohesion_level"))
    return findings.add(
        findings.places.is_given(path + ".cohesion_level") ? path + ".cohesion_level" : path + ".cohesion_gradient",
        "'cohesion_gradient' and 'cohesion_level' of material '{}' belong together; give both or none", name);
  if (findings.places.is_given(path + ".undrained_gradient") && !findings.places.is_given(path + ".undrained_level"))
    return findings.add(path + ".undrained_gradient",
                        "'undrained_gradient' of material '{}' needs 'undrained_level', the elevation below which the "
                        "strength grows",
                        name);
  if (s.cohesion_gradient >= 0 || data.mesh.polygons.empty() || !findings.is_sound("geometry.polygon")) return;
  const double bottom = find_bottom(data, name);
  if (!std::isfinite(bottom)) return;
  const double least = m.cohesion + s.find_extra(bottom);
  if (least < 0 && findings.is_sound(path + ".cohesion"))
    findings.add(path + ".cohesion_gradient", "the cohesion of material '{}' would be negative, {} at y = {}", name,
                 format_value(least, data.units().stress), format_coordinate(bottom, data.units().length));
}

void check_weight(const Case& data, const Material& m, const std::string& name, Findings& findings) {
  const std::string path = "materials." + name;
  const auto is_given = [&](const char* key) { return findings.places.is_given(path + key); };
  const SliceSoil& s = m.slices;
  if (s.unit_weight && s.saturated_unit_weight && *s.saturated_unit_weight < *s.unit_weight &&
      findings.is_sound(path + ".saturated_unit_weight") && findings.is_sound(path + ".unit_weight"))
    findings.add(path + ".saturated_unit_weight",
                 "'saturated_unit_weight' is {:.6g} kN/m3; it must not be smaller than the unit weight, {:.6g} kN/m3",
                 *s.saturated_unit_weight / 1e3, *s.unit_weight / 1e3);
  if (!s.unit_weight || !findings.is_sound(path + ".unit_weight") || !findings.is_sound(path + ".grain_density"))
    return;
  if (!m.water.is_wet()) {
    if (is_given(".grain_density"))
      findings.add(path + ".grain_density",
                   "material '{}' has both a unit weight and a grain density; give one of them", name);
    return;
  }
  // LEM and FEM use the given unit weight; MPM requires grain density and porosity.
  if (uses(data, Method::mpm) && !is_given(".grain_density"))
    findings.add(path + ".unit_weight",
                 "the pore water of material '{}' moves, so that its weight changes: give 'grain_density' and "
                 "'porosity' as well",
                 name);
}

void check_suction(const Case& data, const Material& m, const std::string& name, Findings& findings) {
  const std::string path = "materials." + name + ".suction_strength";
  if (!findings.is_sound(path)) return;
  const RetentionCurve curve = m.water.retention;
  if (m.slices.suction_strength == SuctionStrength::saturation && findings.is_sound("materials." + name + ".water") &&
      (curve == RetentionCurve::dry || curve == RetentionCurve::saturated))
    findings.add(
        path, "suction_strength = \"saturation\" needs the retention curve of material '{}', in [materials.{}.water]",
        name, name);
  if (m.slices.suction_strength == SuctionStrength::phi_b && m.friction_angle > 0 &&
      m.slices.phi_b > m.friction_angle && findings.is_sound("materials." + name + ".phi_b") &&
      findings.is_sound("materials." + name + ".friction_angle"))
    findings.add("materials." + name + ".phi_b",
                 "'phi_b' of material '{}' is greater than its friction angle; suction adds at most as much as the "
                 "same effective stress would",
                 name);
  if (m.slices.suction_strength == SuctionStrength::phi_b && material::needs<material::FlowRatio>(m.model) &&
      (uses(data, Method::fem) || uses(data, Method::bounds)))
    findings.add(
        path,
        "suction_strength = \"phi_b\" is that of LEM alone for material '{}' ({}): FEM and limit analysis take "
        "suction as an effective stress, which φ_b gives for a constant friction angle only; use "
        "\"saturation\" or \"none\"",
        name, m.traits().title);
}

/// Reports stiffness that FEM and MPM need.
void check_stiffness(const Case& data, Findings& findings) {
  const char* method = uses(data, Method::fem) ? "FEM" : "MPM";
  for (const auto& [name, support] : data.supports) {
    const BlockFindings block(findings, "support." + name);
    if (!block.is_sound("kind")) continue;
    const auto need = [&, name = name](const char* key, bool is_given, const char* words) {
      if (!is_given && block.is_sound(key))
        findings.add(block.path, fmt::format("support '{}': {} needs its '{}', {}", name, method, key, words));
    };
    if (support.kind == SupportKind::geosynthetic)
      need("sheet_stiffness", support.sheet_stiffness.has_value(), "the stiffness J per metre of width");
    else
      need("axial_stiffness", support.axial_stiffness.has_value(),
           support.kind == SupportKind::wall ? "E A of a metre of wall" : "E A of one bar");
    if (support.kind == SupportKind::pile)
      need("bending_stiffness", support.bending_stiffness.has_value(), "E I of one pile");
    if (support.kind == SupportKind::wall)
      need("bending_stiffness", support.bending_stiffness.has_value(), "E I of a metre of wall");
  }
}

void check_interfaces(const Case& data, Findings& findings) {
  for (const auto& [name, support] : data.supports) {
    const BlockFindings block(findings, "support." + name);
    if (!block.is_sound("kind") || support.kind != SupportKind::wall || !block.is_sound("interface_strength")) continue;
    if (!support.interface_strength && !support.bond_adhesion && !support.bond_friction)
      findings.add(block.path, fmt::format("support '{}': {} needs its 'interface_strength', the strength of its "
                                           "interface over that of the soil, or 'bond_adhesion' and 'bond_friction'",
                                           name, uses(data, Method::fem) ? "FEM" : "limit analysis"));
  }
}

/// Returns true if pore pressures follow from a calculation of seepage.
bool computes_seepage(const Case& data) {
  return is_wet(data) && (data.initial.water.pressure == InitialPressure::seepage || data.initial.water.season > 0 ||
                          data.timeline || uses(data, Method::seepage));
}

/// Checks that walls beside computed seepage are permeable or not, and warns of heads that do not hold their wall.
void check_walls(const Case& data, Findings& findings) {
  if (computes_seepage(data))
    for (const auto& [name, support] : data.supports)
      if (support.kind == SupportKind::wall && !support.permeable &&
          findings.is_sound("support." + name + ".permeable"))
        findings.add("support." + name,
                     "support '{}': give 'permeable'; pore pressures follow from seepage here, which a wall with "
                     "permeable = false stops and one with permeable = true does not",
                     name);
  if (!findings.is_sound("support") || !findings.is_sound("geometry") || data.mesh.polygons.empty()) return;
  mesh::Polyline ground;
  try {
    ground = mesh::find_ground(data.mesh);
  } catch (const Error&) {
    return;  // the methods that need the ground report its fault
  }
  constexpr double near = 1e-3;  // of the width of the section
  for (const auto& [name, wall] : data.supports) {
    if (wall.kind != SupportKind::wall) continue;
    for (const auto& [other, support] : data.supports) {
      const bool is_loose = support.kind == SupportKind::nail || support.kind == SupportKind::anchor;
      if (!is_loose || support.plate > 0) continue;
      for (const BarLine& piece : lay_bars(data, name).bars)
        for (const BarLine& bar : lay_bars(data, other).bars)
          if (mesh::compute_distance(bar.head, piece.head, piece.end) <= near * (ground.back()[0] - ground.front()[0]))
            return findings.warn("support." + other + ".plate",
                                 "the head of support '{}' in row {} lies on the wall '{}' and does not hold it: "
                                 "'plate' is 0",
                                 other, bar.row, name);
    }
  }
}

/// Returns the path of the key by which MPM starts from a state of another method; empty if it does not.
std::string find_release_path(const Case& data) {
  if (data.timeline && data.timeline->release) return "timeline.release";
  for (std::size_t k = 0; k < data.construction.size(); ++k)
    if (data.construction[k].release) return fmt::format("construction.{}.release", k);
  return "";
}

}  // namespace

std::optional<std::string> find_axial_obstacle(const Case& data) {
  if (auto why = find_support_obstacle(data)) return why;
  for (const auto& [name, support] : data.supports)
    if (support.kind == SupportKind::wall)
      return fmt::format("support '{}' is a wall, whose bending and embedment LEM does not have", name);
  return std::nullopt;
}

void check_support_methods(const Case& data, Findings& findings) {
  if (!findings.is_sound("analysis.methods")) return;
  check_walls(data, findings);
  if (uses(data, Method::fem) || uses(data, Method::mpm)) check_stiffness(data, findings);
  if (uses(data, Method::fem) || uses(data, Method::bounds)) check_interfaces(data, findings);
  if (const auto why = find_support_obstacle(data); why && uses(data, Method::bounds))
    findings.add("analysis.methods", "{}; take \"bounds\" out of 'methods'", *why);
  if (uses(data, Method::mpm))
    for (const auto& [name, support] : data.supports) {
      if (support.kind == SupportKind::pile)
        findings.add(
            "support." + name,
            "support '{}' is a pile, and MPM takes bars in tension only; take \"mpm\" out of 'methods', or the "
            "pile out of the case",
            name);
      if (support.kind == SupportKind::wall)
        findings.add("support." + name,
                     "support '{}' is a wall, and MPM takes bars in tension only; take \"mpm\" out of 'methods', or "
                     "give the wall as a region of strong soil",
                     name);
    }
  const std::string release = find_release_path(data);
  if ((!release.empty() || data.initial.stress == InitialStress::elements) && uses(data, Method::mpm))
    findings.add(release.empty() ? "initial.stress" : release,
                 "not with [support.{}]: in the stresses of FEM its bars carry a part, and in MPM they would begin "
                 "without force; start from K0 stresses or with a stage that brings the weight",
                 data.supports.begin()->first);
  if (data.lem.drawdown)
    findings.add("lem.drawdown", "not with [support.{}]: the force of supports during a rapid drawdown is not known",
                 data.supports.begin()->first);
  if (const auto why = find_axial_obstacle(data); why && data.lem.referee && findings.places.is_given("lem.referee"))
    findings.add("lem.referee", "limit analysis cannot judge these supports: {}; leave out 'referee'", *why);
  if (data.mesh.dimension != 2)
    findings.add("support." + data.supports.begin()->first, "supports need a plane section, with dimension = 2");
}

void check_methods(const Case& data, Findings& findings) {
  if (!findings.is_sound("analysis.methods")) return;
  for (const auto& [name, material] : data.materials) {
    check_weight(data, material, name, findings);
    check_suction(data, material, name, findings);
    check_cohesion_gradient(data, material, name, findings);
  }
  check_list(data, findings);
  const bool has_slices = uses(data, Method::lem), has_elements = uses(data, Method::fem),
             has_bounds = uses(data, Method::bounds);
  if (has_slices || has_elements || has_bounds) {
    check_plain_start(data, findings);
    check_has_strength(data, findings);
  }
  if (has_slices) check_slices_need(data, findings);
  if (has_elements) check_elements_need(data, findings);
  if (has_elements && data.fem.davis != DavisRule::none) check_davis_of_elements(data, findings);
  if (has_elements && data.fem.softening == FemSoftening::progressive) check_progressive_failure(data, findings);
  if (has_bounds) check_bounds_need(data, findings);
  if (has_bounds && data.bounds.flow == BoundsFlow::davis) check_davis(data, "bounds.flow", findings);
  check_reduces(data, findings);
  check_only_slices(data, findings);
  check_cones(data, findings);
  check_columns(data, findings);
  if (uses(data, Method::mpm) || !data.construction.empty())
    for (const auto& [name, material] : data.materials) check_pressure_ratio(material, name, findings);
  if (computes_seepage(data) && !has_elements && data.mesh.file.empty() && data.mesh.size == 0 &&
      findings.is_sound("mesh.size"))
    findings.add("mesh", "pore pressures that follow from seepage need a mesh: give 'size' in [mesh]");
}

// [bounds]: default size of the first mesh.

namespace {

/// Fractions of the section's height.
constexpr double first_size = 1.0 / 6, first_size_with_water = 1.0 / 12;

}  // namespace

double find_bounds_size(const Case& data) {
  if (data.bounds.size) return *data.bounds.size;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const mesh::Polygon& polygon : data.mesh.polygons)
    for (const auto& x : polygon.points) low = std::min(low, x[1]), high = std::max(high, x[1]);
  const bool has_water = data.initial.water.pressure != InitialPressure::zero || data.initial.water.known;
  return (has_water ? first_size_with_water : first_size) * (high - low);
}

}  // namespace talus::input
