// SPDX-License-Identifier: MIT
// Every calculation polls for signals often enough to stop within a second, and can be resumed.

#include <gtest/gtest.h>

#include <ctime>
#include <fstream>
#include <random>

#include "base/progress.hpp"
#include "methods_slope.hpp"
#include "support/scratch.hpp"
#include "support/slopes.hpp"

namespace talus {
namespace {

using nlohmann::json;

/// Counts how often a calculation checks for signals, and requests its end at one of these checks.
struct Looks {
  static inline long count = 0, last = -1;       ///< checks so far, and the check at which the end is requested
  static inline double largest = 0, before = 0;  ///< processor time between two looks, and at the one before [s]

  static double read_clock() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  }
  static void look() {
    const double now = read_clock();
    largest = std::max(largest, now - before);
    before = now;
    if (++count == last) request_interrupt();
  }
  /// From now on, up to look number `end`; -1: to the end.
  static void begin(long end) {
    count = 0;
    last = end;
    largest = 0;
    before = read_clock();
    watch_interrupts(look);
  }
  static void end() {
    watch_interrupts(nullptr);
    request_interrupt(false);
  }
};

struct Calculation {
  std::string name, text;
  std::vector<input::Override> changes;
};

void PrintTo(const Calculation& calculation, std::ostream* out) {
  *out << calculation.name;
}

class Signals : public testing::TestWithParam<Calculation> {
 protected:
  void TearDown() override { Looks::end(); }

  /// Nothing where it was interrupted.
  std::optional<json> run(bool resume, long last) {
    run::RunOptions options;
    options.folder = folder_;
    options.threads = 1;
    options.overwrite = !resume;
    options.resume = resume;
    Looks::begin(last);
    try {
      json summary =
          support::run_case(input::read_case_text(GetParam().text, "slope.toml", GetParam().changes), options);
      Looks::end();
      return summary;
    } catch (const Error& error) {
      Looks::end();
      EXPECT_EQ(error.code(), ExitCode::interrupted) << error.what();
      return std::nullopt;
    }
  }

  const std::filesystem::path folder_ = support::make_scratch("signals") / GetParam().name;
};

TEST_P(Signals, EndItWithinASecondAndItResumes) {
  const auto whole = run(false, -1);
  ASSERT_TRUE(whole);
  const long looks = Looks::count;
  RecordProperty("looks", std::to_string(looks));
  RecordProperty("largest_gap", fmt::format("{:.3f} s", Looks::largest));
  EXPECT_LT(Looks::largest, 1);
  EXPECT_GT(looks, 10);
  std::mt19937 draw(53);
  int ended = 0;
  for (int i = 0; i < 10; ++i) {
    const long last = 1 + static_cast<long>(draw() % static_cast<unsigned long>(looks));
    const bool resume = std::filesystem::exists(folder_ / list_file) && ended > 0;
    if (!run(resume, last)) ++ended;
  }
  EXPECT_GT(ended, 0);
  const auto resumed = run(true, -1);
  ASSERT_TRUE(resumed);
  for (const char* key : {"main_factor", "factor_of_safety", "runout"})
    EXPECT_EQ(resumed->value(key, json()), whole->value(key, json())) << key;
}

std::string read_example(const std::string& name) {
  std::ifstream file(TALUS_SOURCE_DIR "/examples/" + name);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string write(const std::string& rest) {
  return support::write_slope("dry", {"mesh.size=1.5"}) + rest;
}

INSTANTIATE_TEST_SUITE_P(
    Of, Signals,
    testing::Values(
        Calculation{"slices",
                    write("[analysis]\nmethods = [\"lem\"]\n[lem]\nmethods = [\"spencer\"]\n"
                          "entry_exit = { exits = 12, entries = 12, depths = 8 }\n"),
                    {}},
        Calculation{"elements", write("[analysis]\nmethods = [\"fem\"]\n[fem]\nmeshes = 1\nresolution = 0.1\n"), {}},
        Calculation{"bounds", write("[analysis]\nmethods = [\"bounds\"]\n[bounds]\ngap = 0.1\n"), {}},
        Calculation{"points", write("[[stage]]\nname = \"gravity\"\nduration = 2\n"), {}},
        Calculation{"stress_by_elements",
                    write("[initial]\nstress = \"elements\"\n[[stage]]\nname = \"gravity\"\nduration = 0.5\n"),
                    {}},
        Calculation{"water_in_time",
                    read_example("reservoir_drawdown/case.toml"),
                    {{"timeline.times", "[0.5, 2]"},
                     {"mesh.size", "2"},
                     {"lem.referee", "false"},
                     {"lem.entry_exit", "{ exits = 8, entries = 8, depths = 6 }"}}}),
    [](const testing::TestParamInfo<Calculation>& each) { return each.param.name; });

}  // namespace
}  // namespace talus
