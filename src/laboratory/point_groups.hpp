#pragma once
// How element tests are shown: which belong into one picture, over what, and with which line.

#include <string>
#include <vector>

#include "input/case/case.hpp"

namespace talus::laboratory {

/// One diagram; names of input::list_point_quantities().
struct PointPanel {
  std::string x, y;
  bool log_x = false;
};

/// Tests of one kind of apparatus.
struct PointGroup {
  std::string id;                  ///< "drained_triaxial": name of its picture
  std::string title;               ///< "Drained triaxial tests"
  std::vector<PointPanel> panels;  ///< four
  std::vector<std::size_t> tests;  ///< by number
  std::vector<int> colour, dash;   ///< of each of its tests, from 0: tests that set the same have one colour
};

/// The groups of a case in the order of their first tests.
std::vector<PointGroup> group_tests(const std::vector<input::PointTest>& tests);

}  // namespace talus::laboratory
