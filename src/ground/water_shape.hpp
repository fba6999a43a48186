// SPDX-License-Identifier: MIT
#pragma once
// Water tables that are drawn as no water can stand.

#include <string>
#include <vector>

#include "ground/ground_line.hpp"
#include "input/case/case.hpp"

namespace talus::ground {

/// Sentences on the water tables of a plane case, before and after a drawdown: free water that slopes, ends inside the
/// section that flood lower ground, water far above the crest, and lines that lie outside the section.
std::vector<std::string> find_odd_water(const input::Case& data);

/// The same of one line; `name` begins the sentences: "The water table".
std::vector<std::string> find_odd_water(const Polyline& table, const Polyline& ground, double base,
                                        const std::string& name);

}  // namespace talus::ground
