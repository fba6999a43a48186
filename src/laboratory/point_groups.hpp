// SPDX-License-Identifier: MIT
#pragma once
// How element tests are shown: which belong into one picture, over what, and with which line.

#include <vector>

#include "input/case/case.hpp"
#include "results/laboratory.hpp"

namespace talus::laboratory {

/// The groups of a case in the order of their first tests, without their pictures; four panels each. Tests that set the
/// same have one colour.
std::vector<results::PointGroup> group_tests(const std::vector<input::PointTest>& tests);

}  // namespace talus::laboratory
