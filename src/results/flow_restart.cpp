// SPDX-License-Identifier: MIT
#include "results/flow_restart.hpp"

#include "results/described.hpp"

namespace talus::results {

void describe(Visitor& v, FlowRestart& r) {
  v.key("input_hash", r.input_hash, {"", "hash of the input"});
  v.maybe("seepage", r.seepage, {"", "steady state"});
  v.maybe("season", r.season, {"", "weather before the start"});
  v.maybe("states", r.states, {"", "states in the order of time"});
  v.maybe("fields", r.fields, {"", "fields of the states"});
}

}  // namespace talus::results
