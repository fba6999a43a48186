// SPDX-License-Identifier: MIT
#include "run/lem/slice_run.hpp"

#include <fmt/format.h>

#include "results/governing.hpp"
#include "results/json.hpp"
#include "run/attempt.hpp"

namespace talus::run {
namespace {

constexpr const char *slice_file = "lem.json", *slice_title = "limit equilibrium";

}  // namespace

SliceRun::SliceRun(const input::Case& data, bool alone, const RunOptions& options, std::string input_hash)
    : data_(data), options_(options), hash_(std::move(input_hash)), alone_(alone), prepared_(prepare_slope(data)) {}

void SliceRun::calculate() {
  if (options_.resume) {
    auto known = results::find_file<results::SliceFile>(options_.folder / slice_file);
    if (known && known->input_hash == hash_) {
      outcome_.result = std::move(known->summary);
      is_kept_ = is_done_ = true;
      return;
    }
  }
  if (options_.progress) options_.progress->show("limit equilibrium: searching for the critical slip surface");
  if (const auto why = attempt(options_, alone_, [&] { outcome_ = run_lem(data_, prepared_, options_.threads); })) {
    outcome_.result.error = why;
    outcome_.result.warnings = {fmt::format("{}: {}", slice_title, *why)};
  }
  if (options_.progress) options_.progress->clear();
  is_done_ = true;
}

void SliceRun::take_referee(results::Referee referee) {
  results::take_referee(std::move(referee), outcome_.result);
}

void SliceRun::keep() const {
  if (is_done_ && !is_kept_)
    results::write_file(options_.folder / slice_file, results::SliceFile{hash_, outcome_.result, outcome_.trials}, -1);
}

void SliceRun::write_result(results::RunResult& run) const {
  if (!is_done_) return;
  run.slices = outcome_.result;
  for (const std::string& warning : outcome_.result.warnings)
    run.warnings.push_back(outcome_.result.error ? warning : fmt::format("{}: {}", slice_title, warning));
  ground::give(prepared_.water, run);
}

}  // namespace talus::run
