// SPDX-License-Identifier: MIT
#pragma once
// Results of the method "seepage": discharges, exit gradients, and the safety against uplift and heave.

#include <optional>
#include <string>
#include <vector>

#include "results/about.hpp"

namespace talus::results {

/// Discharge through a line of the case [m³/s; m³/(s m) in plane strain], positive to its right.
struct SectionFlow {
  std::string name;
  double discharge = 0;
};
void describe(auto& v, As<SectionFlow> auto& r) {
  v.key("name", r.name, {"", "section"});
  v.key("discharge", r.discharge, {"m3/s", "discharge"});
}

/// Largest hydraulic gradient normal to a side from which water leaves the soil.
struct ExitGradient {
  std::string name;
  double gradient = 0;
  std::vector<double> at;          ///< [m]
  std::optional<double> critical;  ///< γ'/γ_w, where the ground is nearly level
  std::optional<double> factor;    ///< critical over computed
  bool grows = false;              ///< it rises steeply towards its place, as at a singularity: it depends on the mesh
};
void describe(auto& v, As<ExitGradient> auto& r) {
  v.key("name", r.name, {"", "side"});
  v.key("gradient", r.gradient, {"", "largest exit gradient"});
  v.key("at", r.at, {"m", "where it is largest"});
  v.maybe("critical", r.critical, {"", "critical gradient"});
  v.maybe("factor", r.factor, {"", "factor of safety against boiling"});
  v.key("grows", r.grows, {"", "whether it depends on the size of the elements"});
}

/// The place with the least safety against uplift, at the base of a less permeable layer.
struct UpliftPlace {
  std::string layer;
  std::vector<double> at;           ///< [m]
  double weight = 0, pressure = 0;  ///< of the soil above; pore pressure less that of standing water [Pa]
  double factor = 0;
};
void describe(auto& v, As<UpliftPlace> auto& r) {
  v.key("layer", r.layer, {"", "layer that is lifted"});
  v.key("at", r.at, {"m", "where"});
  v.key("weight", r.weight, {"Pa", "weight of the soil above"});
  v.key("pressure", r.pressure, {"Pa", "pore pressure below it, less that of standing water"});
  v.key("factor", r.factor, {"", "factor of safety against uplift"});
}

/// Heave of a block of soil (Terzaghi 1943). Forces are per metre of thickness.
struct Heave {
  std::string name;
  double weight = 0, force = 0;  ///< buoyant weight; force of the excess pore pressure at its base [N/m]
  std::optional<double> factor;  ///< nullopt if nothing lifts it
};
void describe(auto& v, As<Heave> auto& r) {
  v.key("name", r.name, {"", "block"});
  v.key("weight", r.weight, {"N/m", "buoyant weight"});
  v.key("force", r.force, {"N/m", "force of the excess pore pressure at its base"});
  v.maybe("factor", r.factor, {"", "factor of safety against heave"});
}

/// Flow at one time.
struct FlowState {
  double time = 0;                 ///< [s]
  double inflow = 0, outflow = 0;  ///< [m³/s; m³/(s m) in plane strain]
  std::vector<SectionFlow> sections;
  std::vector<ExitGradient> exits;
  std::optional<UpliftPlace> uplift;
  std::vector<Heave> heaves;
};
void describe(auto& v, As<FlowState> auto& r) {
  v.key("time", r.time, {"s", "when"});
  v.key("inflow", r.inflow, {"m3/s", "flow in"});
  v.key("outflow", r.outflow, {"m3/s", "flow out"});
  v.key("sections", r.sections, {"", "flow through the sections"});
  v.key("exits", r.exits, {"", "exit gradients"});
  v.maybe("uplift", r.uplift, {"", "least safety against uplift"});
  v.key("heaves", r.heaves, {"", "safety against heave"});
}

/// The method "seepage": steady flow, or the flow at the times of the case.
struct FlowResult {
  std::optional<std::string> error;
  std::vector<std::string> warnings;
  std::vector<FlowState> states;
  int elements = 0;
  double step_error = 0;  ///< largest estimated error of the head in a time step [m]
  std::optional<double> seconds;
};
void describe(auto& v, As<FlowResult> auto& r) {
  v.maybe("error", r.error, {"", "why there is no result"});
  v.key("warnings", r.warnings, {"", "warnings"});
  v.key("states", r.states, {"", "flow at each time"});
  v.key("elements", r.elements, {"", "elements"});
  v.key("step_error", r.step_error, {"m", "largest estimated error of the head in a time step"});
  v.maybe("seconds", r.seconds, {"s", "seconds"});
}

/// seepage.json, which a resumed run reads instead of computing it again.
struct FlowFile {
  std::string input_hash;
  FlowResult summary;
};
void describe(auto& v, As<FlowFile> auto& r) {
  v.key("input_hash", r.input_hash, {"", "hash of the input"});
  v.key("summary", r.summary, {"", "flow of water"});
}

/// The least factor of safety of all times of a kind, with the state in which it occurs.
template <class Found>
struct LeastFlowFactor {
  const Found* found = nullptr;
  double time = 0;
};

/// Returns the exit gradient with the least factor, or the largest gradient where there is no factor, of one side.
inline LeastFlowFactor<ExitGradient> find_worst_exit(const FlowResult& flow, const std::string& side) {
  LeastFlowFactor<ExitGradient> worst;
  for (const FlowState& state : flow.states)
    for (const ExitGradient& exit : state.exits)
      if (exit.name == side && (worst.found == nullptr || exit.gradient > worst.found->gradient))
        worst = {&exit, state.time};
  return worst;
}

inline LeastFlowFactor<UpliftPlace> find_worst_uplift(const FlowResult& flow) {
  LeastFlowFactor<UpliftPlace> worst;
  for (const FlowState& state : flow.states)
    if (state.uplift && (worst.found == nullptr || state.uplift->factor < worst.found->factor))
      worst = {&*state.uplift, state.time};
  return worst;
}

inline LeastFlowFactor<Heave> find_worst_heave(const FlowResult& flow, const std::string& block) {
  LeastFlowFactor<Heave> worst;
  for (const FlowState& state : flow.states)
    for (const Heave& heave : state.heaves)
      if (heave.name == block && heave.factor && (worst.found == nullptr || *heave.factor < *worst.found->factor))
        worst = {&heave, state.time};
  return worst;
}

}  // namespace talus::results
