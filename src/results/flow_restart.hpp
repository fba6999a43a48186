// SPDX-License-Identifier: MIT
#pragma once
// seepage_state.json: the pore water of the method "seepage", which seepage.json does not have.

#include <optional>
#include <string>
#include <vector>

#include "results/water.hpp"

namespace talus::results {

/// Pore water of the flow, which a resumed run reads with seepage.json. Numbers read back as the same doubles.
struct FlowRestart {
  std::string input_hash;
  std::optional<Seepage> seepage;
  std::optional<Season> season;
  std::optional<std::vector<WaterState>> states;
  std::optional<WaterFields> fields;
};
void describe(Visitor& v, FlowRestart& r);

}  // namespace talus::results
