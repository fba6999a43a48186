// SPDX-License-Identifier: MIT
#pragma once
// A small slope for LEM and FEM, with runs in a folder of their own.

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "base/file_list.hpp"
#include "support/run_json.hpp"
#include "support/scratch.hpp"
#include "support/slopes.hpp"

namespace talus {

/// The dry slope of the source with LEM alone; `more` is appended.
inline std::string write_case(const std::string& methods = "\"lem\"", const std::string& more = "") {
  return support::write_slope("dry",
                              {"geometry.box=[[0, 0], [44, 15]]", "mesh.size=2.5", "materials.sand.grain_density=2650",
                               "materials.sand.porosity=0.4", "analysis.methods=[" + methods + "]"}) +
         "[[geometry.line]]\nname = \"toe\"\npoints = [[32, 5], [44, 5]]\n" + more;
}

inline constexpr const char* few_circles = R"(
[lem]
methods = ["bishop", "spencer"]
noncircular = false
yield_acceleration = false
minima = 1
referee = false
[lem.entry_exit]
exits = 12
entries = 12
depths = 8
)";

/// Runs cases in a folder that goes when the test ends.
class MethodsTest : public ::testing::Test {
 protected:
  nlohmann::json run(const std::string& text, const std::vector<input::Override>& overrides = {}, bool resume = false) {
    run::RunOptions options;
    options.folder = folder_;
    options.overwrite = !resume;
    options.resume = resume;
    options.progress = progress_;
    return support::run_case(input::read_case_text(text, "slope.toml", overrides), options);
  }

  /// Leaves a file as a run that was stopped before its summary.
  void leave(const std::string& name, const nlohmann::json& content) const {
    const FileList files(folder_);
    remove_file(folder_ / "summary.json");
    write_atomically(folder_ / name, content.dump());
  }

  /// The sentence that the case ends with.
  std::string find_fault(const std::string& text, const std::vector<input::Override>& overrides = {}) {
    try {
      run(text, overrides);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }

  static double find_factor(const nlohmann::json& summary, const std::string& method) {
    for (const auto& c : summary.at("lem").at("critical"))
      if (c.at("method") == method) return c.at("factor");
    return 0;
  }

  Progress* progress_ = nullptr;  ///< nowhere
  const std::filesystem::path folder_ = support::make_scratch("methods") / "run";
};

}  // namespace talus
