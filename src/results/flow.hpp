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
void describe(Visitor& v, SectionFlow& r);

/// Largest hydraulic gradient normal to a side from which water leaves the soil.
struct ExitGradient {
  std::string name;
  double gradient = 0;
  std::vector<double> at;          ///< [m]
  std::optional<double> critical;  ///< γ'/γ_w, where the ground is nearly level
  std::optional<double> factor;    ///< critical over computed
  bool grows = false;              ///< it rises steeply towards its place, as at a singularity: it depends on the mesh
};
void describe(Visitor& v, ExitGradient& r);

/// The place with the least safety against uplift, at the base of a less permeable layer.
struct UpliftPlace {
  std::string layer;
  std::vector<double> at;           ///< [m]
  double weight = 0, pressure = 0;  ///< of the soil above; pore pressure less that of standing water [Pa]
  double factor = 0;
};
void describe(Visitor& v, UpliftPlace& r);

/// Heave of a block of soil (Terzaghi 1943). Forces are per metre of thickness.
struct Heave {
  std::string name;
  double weight = 0, force = 0;  ///< buoyant weight; force of the excess pore pressure at its base [N/m]
  std::optional<double> factor;  ///< nullopt if nothing lifts it
};
void describe(Visitor& v, Heave& r);

/// Flow at one time.
struct FlowState {
  double time = 0;                 ///< [s]
  double inflow = 0, outflow = 0;  ///< [m³/s; m³/(s m) in plane strain]
  std::vector<SectionFlow> sections;
  std::vector<ExitGradient> exits;
  std::optional<UpliftPlace> uplift;
  std::vector<Heave> heaves;
};
void describe(Visitor& v, FlowState& r);

/// The method "seepage": steady flow, or the flow at the times of the case.
struct FlowResult {
  std::optional<std::string> error;
  std::vector<std::string> warnings;
  std::vector<FlowState> states;
  int elements = 0;
  double step_error = 0;  ///< largest estimated error of the head in a time step [m]
  std::optional<double> seconds;
};
void describe(Visitor& v, FlowResult& r);

/// seepage.json, which a resumed run reads instead of computing it again.
struct FlowFile {
  std::string input_hash;
  FlowResult summary;
};
void describe(Visitor& v, FlowFile& r);

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
