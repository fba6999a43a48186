// SPDX-License-Identifier: MIT
#pragma once
// A very coarse slope, of which a whole study takes a second, and folders for its results.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "study/study.hpp"
#include "study/study_table.hpp"
#include "support/program.hpp"
#include "support/scratch.hpp"
#include "support/slopes.hpp"

namespace talus::study {

/// The slope of the examples with elements of 3 m, its curve at four factors; `[study]` is added by each test.
inline const std::string coarse_slope =
    support::write_slope("dry", {"geometry.line=[]", "mesh={ size = 3, points_per_element = 3 }",
                                 "materials.sand.grain_density=2650", "materials.sand.porosity=0.4",
                                 "stage=[{ name = 'gravity', duration = 10, until = 'rest', damping = 0.75 }]",
                                 "analysis.kind=strength_reduction",
                                 "strength_reduction.curve={ smoothing = 'none', from = 1.4, to = 2.0, step = 0.2, "
                                 "refine = false, window = 1, damping = 0.05 }",
                                 "strength_reduction.frozen.enabled=false"});

inline const std::string cohesion_study = coarse_slope + R"(
[study]
factors = [1.4, 2.0]

[[study.vary]]
key = "materials.sand.cohesion"
values = ["4 kPa", 8]
)";

inline StudyPlan plan_text(const std::string& text, const std::vector<input::Override>& overrides = {}) {
  return plan_study(input::read_case_text(text, "slope.toml", overrides), overrides);
}

/// A folder of this test that is not there yet.
inline std::filesystem::path make_test_folder() {
  return support::make_scratch("study") / "results";
}

inline StudyOptions write_to(const std::filesystem::path& folder, bool resume = false) {
  StudyOptions options;
  options.folder = folder;
  options.threads = 2;
  options.resume = resume;
  return options;
}

using support::read_text;

/// The column of a table with this name; fails the test when there is none.
inline results::StudyColumn get_column(const std::vector<results::StudyColumn>& table, const std::string& name) {
  const auto at =
      std::find_if(table.begin(), table.end(), [&](const results::StudyColumn& c) { return c.name == name; });
  if (at != table.end()) return *at;
  ADD_FAILURE() << "there is no column '" << name << "'";
  return {};
}

}  // namespace talus::study
