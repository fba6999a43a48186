// SPDX-License-Identifier: MIT
#pragma once
// The supports of a case as bars in the soil of MPM, and their forces as results.

#include <vector>

#include "input/case/case.hpp"
#include "mpm/state/body.hpp"
#include "results/bars.hpp"

namespace talus::run {

/// Places the bars of a case in a body at the start, with the bond of LEM, anchors at their prestress. Throws what
/// make_bars() throws.
void add_bars(mpm::Body<2>& body, const input::Case& data);
inline void add_bars(mpm::Body<3>&, const input::Case&) {}

/// Returns where the bars are and what they carry.
std::vector<results::PointBar> make_bar_results(const mpm::Body<2>& body, const input::Case& data);
inline std::vector<results::PointBar> make_bar_results(const mpm::Body<3>&, const input::Case&) {
  return {};
}

}  // namespace talus::run
