// SPDX-License-Identifier: MIT
#include "input/case/harmful.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "input/case/checks.hpp"

namespace talus::input {
namespace {

/// Whether some soil has plastic flow that grows its volume.
bool dilates(const Case& data) {
  return std::any_of(data.materials.begin(), data.materials.end(), [](const auto& entry) {
    return entry.second.traits().has_friction && entry.second.dilatancy_angle > 0;
  });
}

/// `where`: "stage 'slide'".
void replace_smoothing(const Case& data, StepSettings& step, const std::string& where,
                       std::vector<std::string>& sentences) {
  const bool flows = is_wet(data) && step.water == WaterMotion::flows && step.geometry == Geometry::moving;
  const auto replace = [&](Smoothing instead, const char* reason) {
    sentences.push_back(
        fmt::format("{}: smoothing = \"{}\" {}. It is calculated with smoothing = \"{}\" instead; write "
                    "that into the case.",
                    where, get_word(step.smoothing), reason, get_word(instead)));
    step.smoothing = instead;
  };
  if (step.smoothing == Smoothing::stable && flows)
    replace(Smoothing::none,
            "and pore water that flows through moving soil disturb each other: the exchange of water between elements "
            "works against the averaged stress, and slopes have burst");
  else if (step.smoothing == Smoothing::strain && dilates(data))
    replace(
        flows ? Smoothing::none : Smoothing::stable,
        "does not balance the mean stress of soil that dilates (ψ > 0): a checkerboard of pressures grows until the "
        "slope bursts");
}

/// Pore pressures of a piezometric line or of r_u, which have no water that could move with the soil.
bool holds_pressures(const Case& data) {
  const bool has_ratio = std::any_of(data.materials.begin(), data.materials.end(),
                                     [](const auto& entry) { return entry.second.slices.pore_pressure_ratio != 0; });
  return has_ratio || (data.initial.water.pressure == InitialPressure::water_table && !is_wet(data));
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
    curve.runout.clear();  // soil that keeps its place runs nowhere
  }
  if (replaced.empty()) return;
  sentences.push_back(
      fmt::format("{}: the pore pressures of a water table without [materials.NAME.water], and of r_u, are held where "
                  "they are, so material points calculate at frozen geometry instead. For large deformations give the "
                  "soils their pore water.",
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

}  // namespace talus::input
