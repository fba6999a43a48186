// SPDX-License-Identifier: MIT

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <vector>

#include "input/case/checks.hpp"
#include "input/case/compare.hpp"
#include "input/case/support.hpp"
#include "material/every_law.hpp"

namespace talus::input {

namespace {

/// Sets the box to the bounding box of the soil, for a case without MPM.
void fit_box(mesh::Plan& plan) {
  if (plan.polygons.empty()) return;
  constexpr double far = std::numeric_limits<double>::infinity();
  plan.box_min = {far, far};
  plan.box_max = {-far, -far};
  for (const mesh::Polygon& polygon : plan.polygons) {
    for (const auto& p : polygon.points) {
      for (std::size_t d = 0; d < 2; ++d) {
        plan.box_min[d] = std::min(plan.box_min[d], p[d]);
        plan.box_max[d] = std::max(plan.box_max[d], p[d]);
      }
    }
  }
}

/// Sets the default supports of FEM and limit analysis: fixed base, rollers at the sides.
void hold_section(Case& data) {
  std::vector<const char*> rollers{"left", "right"};
  if (data.mesh.dimension == 3) rollers.insert(rollers.end(), {"front", "back"});
  data.boundaries.resize(1 + rollers.size());
  data.boundaries[0].on = "bottom";
  for (std::size_t i = 0; i < rollers.size(); ++i) {
    data.boundaries[i + 1].on = rollers[i];
    data.boundaries[i + 1].fix = Fix::normal;
  }
}

/// Completes keys that a case without MPM leaves out.
void complete_without_points(Case& data, const Places& places) {
  if (data.mesh.file.empty() && !places.is_given("geometry.box")) fit_box(data.mesh);
  if (uses(data, Method::seepage) && !places.is_given("initial.pore_pressure"))
    data.initial.water.pressure = InitialPressure::seepage;
  if (uses(data, Method::mpm)) return;
  if (data.mesh.size == 0 && data.fem.size) data.mesh.size = *data.fem.size;
  if ((uses(data, Method::fem) || uses(data, Method::bounds)) && data.boundaries.empty()) hold_section(data);
}

/// Computes the grain density from the unit weight, unless the grain density is given.
void complete_density(Material& material, const Gravity& gravity, const std::string& path, const Places& places) {
  if (!material.slices.unit_weight || places.is_given(path + ".grain_density") || gravity.acceleration <= 0) return;
  material.grain_density = *material.slices.unit_weight / (gravity.acceleration * (1 - material.porosity));
}

/// In a first stage of gravity loading, keeps the pore pressures and freezes the geometry, so that the weight becomes
/// effective stress under drained (hydrostatic) water.
void drain_weight(Case& data, const Places& places) {
  if (data.stages.empty() || !is_wet(data)) return;
  Stage& first = data.stages.front();
  const bool brings_weight = first.until == Until::rest && data.initial.stress == InitialStress::none &&
                             data.initial.result.empty() && data.initial.water.pressure != InitialPressure::zero &&
                             data.gravity.acceleration > 0;
  if (!brings_weight || places.is_given("stage.0.water") || places.is_given("stage.0.geometry") ||
      places.is_given("stage.0.conductivity_factor"))
    return;
  first.step.water = WaterMotion::held;
  first.step.geometry = Geometry::frozen;
}

}  // namespace

void complete_units(Case& data) {
  try {
    data.mesh.units = make_shown_units(data.output.length_unit, data.output.displacement_unit, data.output.stress_unit);
  } catch (const Error&) {
    data.mesh.units = {};
  }
}

void complete_porosities(Case& data) {
  for (auto& [name, material] : data.materials)
    if (const auto e = material.given_void_ratio) material.porosity = *e / (1 + *e);
}

void complete(Case& data, const std::string& file, const Places& places) {
  if (data.mesh.dimension == 3 && !places.is_given("mesh.points_per_element")) data.points_per_element = 4;
  const auto find_file = [&](const std::string& path) {
    return (std::filesystem::path(file).parent_path() / path).lexically_normal().string();
  };
  if (!data.mesh.file.empty()) data.mesh.file = find_file(data.mesh.file);
  complete_porosities(data);
  for (auto& [name, material] : data.materials) {
    complete_density(material, data.gravity, "materials." + name, places);
    material::complete_soil(material, name, find_file);
  }
  complete_without_points(data, places);
  drain_weight(data, places);
  // An external mesh cannot be coarsened, and a second tetrahedral mesh costs memory and time.
  if (!places.is_given("fem.meshes") && (data.mesh.dimension == 3 || !data.mesh.file.empty())) data.fem.meshes = 1;
  if (data.initial.result.empty()) return;
  data.initial.result_folder = find_file(data.initial.result);
  // The mesh of a result cannot be replaced by finer or coarser ones.
  if (!places.is_given("strength_reduction.frozen.meshes")) data.strength_reduction.frozen.meshes = 1;
}

namespace {

/// Returns true if the plastic flow of some soil dilates.
bool dilates(const Case& data) {
  return std::any_of(data.materials.begin(), data.materials.end(), [](const auto& entry) {
    const Material& m = entry.second;
    return (m.traits().has_friction && m.dilatancy_angle > 0) ||
           (material::needs<material::FlowRatio>(m.model) && m.dilatancy_ratio > 0);
  });
}

/// Replaces smoothing where it is harmful; `where` is for example "stage 'slide'".
void replace_smoothing(const Case& data, StepSettings& step, const std::string& where,
                       std::vector<std::string>& sentences) {
  const bool flows = is_wet(data) && step.water == WaterMotion::flows && step.geometry == Geometry::moving;
  const auto replace = [&](Smoothing instead, const char* reason) {
    sentences.push_back(fmt::format(
        "{}: smoothing = \"{}\" {}. It is calculated with smoothing = \"{}\" instead; write that into the case.", where,
        get_word(step.smoothing), reason, get_word(instead)));
    step.smoothing = instead;
  };
  if (step.smoothing == Smoothing::stable && flows)
    replace(Smoothing::none,
            "and pore water that flows through moving soil disturb each other: the exchange of water between elements "
            "works against the averaged stress, and slopes have burst");
  else if (step.smoothing == Smoothing::strain && dilates(data))
    replace(flows ? Smoothing::none : Smoothing::stable,
            "does not balance the mean stress of soil that dilates (ψ > 0): a checkerboard of pressures grows until "
            "the slope bursts");
}

/// Returns true if pore pressures are from a piezometric line or r_u, without pore water in the soil.
bool holds_pressures(const Case& data) {
  const bool has_ratio = std::any_of(data.materials.begin(), data.materials.end(),
                                     [](const auto& entry) { return entry.second.slices.pore_pressure_ratio != 0; });
  const InitialPressure pressure = data.initial.water.pressure;
  const bool is_given = pressure == InitialPressure::water_table || pressure == InitialPressure::grid;
  return has_ratio || (is_given && !is_wet(data));
}

void replace_geometry(Case& data, std::vector<std::string>& sentences) {
  std::vector<std::string> replaced;
  const auto freeze = [&](StepSettings& step, const std::string& where) {
    if (step.geometry == Geometry::frozen) return;
    step.geometry = Geometry::frozen;
    replaced.push_back(where);
  };
  for (Stage& stage : data.stages) freeze(stage.step, fmt::format("stage '{}'", stage.name));
  DisplacementCurve& curve = data.strength_reduction.curve;
  if (data.analysis == AnalysisKind::strength_reduction && curve.enabled) {
    freeze(curve.step_settings, "[strength_reduction.curve]");
    curve.runout.clear();  // there is no runout on frozen geometry
  }
  if (replaced.empty()) return;
  sentences.push_back(fmt::format(
      "{}: the pore pressures of a water table without [materials.NAME.water], and of r_u, are held where they are, so "
      "MPM runs at frozen geometry instead. For large deformations give the soils their pore water.",
      fmt::join(replaced, ", ")));
}

}  // namespace

std::vector<std::string> replace_harmful(Case& data) {
  std::vector<std::string> sentences;
  if (!uses(data, Method::mpm)) return sentences;
  if (holds_pressures(data)) replace_geometry(data, sentences);
  for (Stage& stage : data.stages)
    replace_smoothing(data, stage.step, fmt::format("stage '{}'", stage.name), sentences);
  if (data.analysis != AnalysisKind::strength_reduction) return sentences;
  StrengthReduction& reduction = data.strength_reduction;
  if (reduction.curve.enabled)
    replace_smoothing(data, reduction.curve.step_settings, "[strength_reduction.curve]", sentences);
  if (reduction.frozen.enabled)
    replace_smoothing(data, reduction.frozen.step_settings, "[strength_reduction.frozen]", sentences);
  return sentences;
}

Case::Case() = default;
Case::Case(const Case&) = default;
Case::Case(Case&&) noexcept = default;
Case& Case::operator=(const Case&) = default;
Case& Case::operator=(Case&&) noexcept = default;
Case::~Case() = default;

}  // namespace talus::input
