// SPDX-License-Identifier: MIT
#include "results/construction_restart.hpp"

#include "results/described.hpp"

namespace talus::results {

void describe(Visitor& v, ConstructionRestart& r) {
  v.key("input_hash", r.input_hash, {"", "hash of the input"});
  v.key("summary", r.summary, {"", "results of the stages"});
  v.key("monitors", r.monitors, {"", "monitored places"});
  v.key("lines", r.lines, {"", "section lines"});
  v.key("times", r.times, {"s", "times of the monitors"});
  v.key("fields", r.fields, {"", "fields at the ends of the stages"});
  v.key("steady_head", r.steady_head, {"m", "heads of steady flow at the end of the last stage"});
  v.key("start_pressure", r.start_pressure, {"Pa", "pore pressures at the start of the last stage"});
  v.key("head", r.head, {"m", "heads at its end"});
  v.key("displacement", r.displacement, {"m", "displacements"});
  v.key("stress", r.stress, {"Pa", "effective stresses"});
  v.key("state", r.state, {"", "state variables"});
  v.key("strain", r.strain, {"", "strains"});
  v.key("bars", r.bars, {"m", "deformations of supports"});
  v.key("yields", r.yields, {"", "points that have yielded"});
  v.key("warnings", r.warnings, {"", "warnings"});
  v.key("stage_warnings", r.stage_warnings, {"", "warnings of the methods, each with its stages"});
}

}  // namespace talus::results
