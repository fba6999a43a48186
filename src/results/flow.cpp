// SPDX-License-Identifier: MIT
#include "results/flow.hpp"

#include "results/described.hpp"

namespace talus::results {

void describe(Visitor& v, SectionFlow& r) {
  v.key("name", r.name, {"", "section"});
  v.key("discharge", r.discharge, {"m3/s", "discharge"});
}

void describe(Visitor& v, ExitGradient& r) {
  v.key("name", r.name, {"", "side"});
  v.key("gradient", r.gradient, {"", "largest exit gradient"});
  v.key("at", r.at, {"m", "where it is largest"});
  v.maybe("critical", r.critical, {"", "critical gradient"});
  v.maybe("factor", r.factor, {"", "factor of safety against boiling"});
  v.key("grows", r.grows, {"", "whether it depends on the size of the elements"});
}

void describe(Visitor& v, UpliftPlace& r) {
  v.key("layer", r.layer, {"", "layer that is lifted"});
  v.key("at", r.at, {"m", "where"});
  v.key("weight", r.weight, {"Pa", "weight of the soil above"});
  v.key("pressure", r.pressure, {"Pa", "pore pressure below it, less that of standing water"});
  v.key("factor", r.factor, {"", "factor of safety against uplift"});
}

void describe(Visitor& v, Heave& r) {
  v.key("name", r.name, {"", "block"});
  v.key("weight", r.weight, {"N/m", "buoyant weight"});
  v.key("force", r.force, {"N/m", "force of the excess pore pressure at its base"});
  v.maybe("factor", r.factor, {"", "factor of safety against heave"});
}

void describe(Visitor& v, FlowState& r) {
  v.key("time", r.time, {"s", "when"});
  v.key("inflow", r.inflow, {"m3/s", "flow in"});
  v.key("outflow", r.outflow, {"m3/s", "flow out"});
  v.key("sections", r.sections, {"", "flow through the sections"});
  v.key("exits", r.exits, {"", "exit gradients"});
  v.maybe("uplift", r.uplift, {"", "least safety against uplift"});
  v.key("heaves", r.heaves, {"", "safety against heave"});
}

void describe(Visitor& v, FlowResult& r) {
  v.maybe("error", r.error, {"", "why there is no result"});
  v.key("warnings", r.warnings, {"", "warnings"});
  v.key("states", r.states, {"", "flow at each time"});
  v.key("elements", r.elements, {"", "elements"});
  v.key("step_error", r.step_error, {"m", "largest estimated error of the head in a time step"});
  v.maybe("seconds", r.seconds, {"s", "seconds"});
}

void describe(Visitor& v, FlowFile& r) {
  v.key("input_hash", r.input_hash, {"", "hash of the input"});
  v.key("summary", r.summary, {"", "flow of water"});
}

}  // namespace talus::results
