// SPDX-License-Identifier: MIT
// A run that a full disk ends at any of its files, and that is resumed, leaves the files of a whole run.

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include "base/file_list.hpp"
#include "support/program.hpp"
#include "support/run_json.hpp"
#include "support/scratch.hpp"
#include "support/slopes.hpp"

namespace talus {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

struct Calculation {
  std::string name, text;
};

void PrintTo(const Calculation& calculation, std::ostream* out) {
  *out << calculation.name;
}

/// Removes what differs between two runs of the same input: times of day, durations, and the sentence on them.
void drop_times(json& tree) {
  if (tree.is_object() && tree.value("text", json()).dump().starts_with("\"Computing time")) tree.erase("text");
  if (tree.is_object())
    for (const char* key : {"seconds", "search_seconds", "timing", "started", "wall", "circles_per_second"})
      tree.erase(key);
  for (auto& child : tree)
    if (child.is_structured()) drop_times(child);
}

/// The files of a folder, JSON without times.
std::map<std::string, std::string> read_folder(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file() || entry.path().filename() == list_file) continue;
    std::string text = support::read_text(entry.path());
    if (entry.path().extension() == ".json") {
      json tree = json::parse(text);
      drop_times(tree);
      text = tree.dump();
    }
    files[fs::relative(entry.path(), folder).string()] = std::move(text);
  }
  return files;
}

/// Files of this process may not grow beyond `bytes` while it lives, which to a writer looks like a full disk.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit small{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallDisk() { setrlimit(RLIMIT_FSIZE, &before_); }

 private:
  rlimit before_{};
};

class KeptFiles : public testing::TestWithParam<Calculation> {
 protected:
  ExitCode run(const fs::path& folder, bool resume, rlim_t bytes = RLIM_INFINITY) {
    run::RunOptions options;
    options.folder = folder;
    options.threads = 1;
    options.overwrite = !resume;
    options.resume = resume;
    const input::LoadedCase loaded = input::read_case_text(GetParam().text, "slope.toml");
    try {
      const SmallDisk disk(bytes);
      run::run_case(loaded, options);
    } catch (const Error& error) {
      return error.code();
    }
    return ExitCode::success;
  }

  const fs::path folder_ = support::make_scratch("kept_files") / GetParam().name;
};

TEST_P(KeptFiles, OfAFullDiskAreCompletedByResume) {
  ASSERT_EQ(run(folder_ / "whole", false), ExitCode::success);
  const auto whole = read_folder(folder_ / "whole");
  // With each file the first that does not fit: the digits of durations vary. The list of files has to fit.
  const auto smallest = fs::file_size(folder_ / "whole" / list_file);
  std::set<std::uintmax_t> limits;
  for (const auto& [name, text] : whole) limits.insert(fs::file_size(folder_ / "whole" / name) * 49 / 50);
  limits.erase(limits.begin(), limits.upper_bound(2 * smallest));
  ASSERT_GE(limits.size(), 2u);
  for (const auto limit : limits) {
    ASSERT_EQ(run(folder_ / "resumed", false, limit), ExitCode::cannot_write) << limit;
    ASSERT_EQ(run(folder_ / "resumed", true), ExitCode::success) << limit;
    const auto resumed = read_folder(folder_ / "resumed");
    for (const auto& [name, text] : whole) {
      ASSERT_TRUE(resumed.contains(name)) << name << " is missing, " << limit << " bytes";
      EXPECT_TRUE(resumed.at(name) == text) << name << " differs, " << limit << " bytes";
    }
    EXPECT_EQ(resumed.size(), whole.size()) << limit;
  }
}

const std::string pit = R"(
title = "Pit behind a sheet pile wall"
geometry.polygon = [{ name = "sand", points = [[0, 0], [20, 0], [20, 6], [10.2, 6], [10.2, 10], [0, 10]] }]
geometry.line = [{ name = "river bed", points = [[0, 10], [10.2, 10]] }, { name = "pit", points = [[10.2, 6], [20, 6]] }]
mesh.size = 1
regions.sand = "sand"
hydraulic = [
  { on = "river bed", condition = "total_head", head = 11.5 }, { on = "pit", condition = "total_head", head = 6 }]
initial.pore_pressure = "seepage"
[materials.sand]
model = "mohr_coulomb"
unit_weight = 20
cohesion = 5
friction_angle = 35
porosity = 0.4
[materials.sand.water]
retention = "saturated"
conductivity = "1e-4 m/s"
compressibility = 1e-7
[support.sheet]
kind = "wall"
line = [[10.2, 10], [10.2, 3]]
permeable = false
interface_strength = 0.5
plastic_moment = 100
)";

INSTANTIATE_TEST_SUITE_P(
    Of, KeptFiles,
    testing::Values(
        Calculation{"seepage", pit + "[analysis]\nmethods = [\"seepage\"]\n"},
        Calculation{"seepage_in_time", pit + "[analysis]\nmethods = [\"seepage\"]\n[seepage]\ntimes = [0.1, 1]\n"},
        Calculation{"fem", support::write_slope("dry", {"mesh.size=1.5"}) +
                               "[analysis]\nmethods = [\"fem\"]\n[fem]\nmeshes = 1\nresolution = 0.3\nsize = 2\n"},
        Calculation{"lem", support::write_slope("dry", {}) +
                               "[analysis]\nmethods = [\"lem\"]\n[lem]\nmethods = [\"spencer\"]\nreferee = false\n"
                               "noncircular = false\nentry_exit = { exits = 5, entries = 5, depths = 3 }\n"}),
    [](const testing::TestParamInfo<Calculation>& each) { return each.param.name; });

}  // namespace
}  // namespace talus
