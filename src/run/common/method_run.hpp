// SPDX-License-Identifier: MIT
#pragma once
// A method beside others in a run: its failure, its file, which a resumed run reads, its part of the results, and the
// pace of its results so far.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <string>

#include "base/error.hpp"
#include "results/json.hpp"
#include "results/run.hpp"
#include "run/common/run_folder.hpp"
#include "site/seepage_results.hpp"

namespace talus::run {

/// Runs `part` of a method. If the case has other methods as well, returns the message of its Error, which becomes a
/// part of the results. Rethrows it if it is an interruption, or the method is `alone`.
template <class Part>
std::optional<std::string> attempt(const RunOptions& options, bool alone, Part part) {
  try {
    part();
  } catch (const Error& error) {
    if (options.progress) options.progress->clear();
    if (alone || error.code() == ExitCode::interrupted) throw;
    return error.what();
  }
  return std::nullopt;
}

/// Limits how often files are written that are overwritten each time: to a twentieth of the time of the run, and to
/// once a second.
class PresentClock {
 public:
  /// Calls `write` unless it was called a short time ago.
  template <class Write>
  void update(Write write) {
    const auto begin = Clock::now();
    if (begin < next_) return;
    write();
    constexpr int pause = 20;
    const auto end = Clock::now();
    next_ = end + std::max<Clock::duration>(std::chrono::seconds(1), pause * (end - begin));
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point next_{};
};

/// LEM, FEM or limit analysis of a case. `File`: the struct of its file, with a summary that may have an error.
template <class File>
class MethodRun {
 public:
  /// Fields of the water that gives the pore pressures; nullptr in dry ground.
  const results::WaterFields* water_fields() const { return water_.fields ? &*water_.fields : nullptr; }
  /// Returns false before the end of calculate().
  bool has_result() const { return !file_.input_hash.empty() || file_.summary.error; }

 protected:
  /// `alone`: the case has no other method.
  MethodRun(const char* title, const char* name, bool alone, const RunOptions& options, std::string input_hash)
      : title_(title), name_(name), alone_(alone), options_(options), hash_(std::move(input_hash)) {}

  /// Runs `part` and measures its time. Returns false if it failed and the case has other methods as well: the error is
  /// then the result.
  template <class Part>
  bool try_part(Part part) {
    const auto start = std::chrono::steady_clock::now();
    const auto why = attempt(options_, alone_, part);
    spent_ += std::chrono::steady_clock::now() - start;
    if (!why) return true;
    file_ = {};
    file_.summary.error = why;
    file_.summary.warnings = {fmt::format("{}: {}", title_, *why)};
    return false;
  }

  /// Reads the file of an interrupted run of the same input. Returns false if there is none.
  bool read_kept() {
    if (!options_.resume) return false;
    auto known = results::find_file<File>(options_.folder / name_);
    if (!known || known->input_hash != hash_) return false;
    file_ = std::move(*known);
    return true;
  }
  void write_kept() const { results::write_file(options_.folder / name_, file_, -1); }

  void show(const std::string& what) const { show(what, {}); }
  void show(const std::string& what, ProgressValues values) const {
    if (options_.progress) options_.progress->show(fmt::format("{}: {}", title_, what), std::move(values));
  }
  void clear_progress() const {
    if (options_.progress) options_.progress->clear();
  }

  void add_warnings(results::RunResult& run) const {
    for (const std::string& warning : file_.summary.warnings)
      run.warnings.push_back(file_.summary.error ? warning : fmt::format("{}: {}", title_, warning));
  }

  const char* title_;
  const char* name_;  ///< of the file
  bool alone_;
  const RunOptions& options_;
  std::string hash_;
  site::WaterResult water_;
  File file_;
  std::chrono::duration<double> spent_{0};
};

}  // namespace talus::run
