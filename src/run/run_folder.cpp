// SPDX-License-Identifier: MIT
#include "run/run_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "base/folder_lock.hpp"
#include "results/json.hpp"
#include "run/mpm/start/end_state.hpp"

namespace talus::run {

namespace fs = std::filesystem;

namespace {

/// Everything that a run may leave in its folder; --overwrite removes these and nothing else.
const char* const own_files[] = {
    "results.vtkhdf", "results.xdmf",     "mesh.vtkhdf",    "mesh.xdmf",     "frames",
    "history.csv",    "monitors.csv",     "summary.json",   "checkpoint.h5", "stages.json",
    "curve.csv",      "profile.csv",      "trials",         "frozen",        "mesh.h5",
    "report.html",    "season.csv",       "sections",       end_state_file,  "lem.json",
    "fem.json",       "fem.vtu",          "water.json",     "bounds.json",   "timeline_water.json",
    "timeline.json",  "released_earlier", "released_later", "coarser_mesh"};

/// Folders of finite elements in time: elements_1 and so on.
bool is_reduction(const fs::path& folder) {
  const std::string name = folder.filename().string(), begin = "elements_";
  return name.size() > begin.size() && name.starts_with(begin) &&
         std::all_of(name.begin() + static_cast<std::ptrdiff_t>(begin.size()), name.end(),
                     [](unsigned char c) { return std::isdigit(c) != 0; });
}

/// Whether a run wrote a picture of that name: curve, section, or one that ends with four digits.
bool is_picture(const fs::path& file) {
  const std::string end = file.extension().string(), stem = file.stem().string();
  if (end != ".svg" && end != ".png" && end != ".gp") return false;
  if (stem == "curve" || stem == "section") return true;
  constexpr std::size_t number = 5;  // _0012
  return stem.size() >= number && stem[stem.size() - number] == '_' &&
         std::all_of(stem.end() - number + 1, stem.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
}

void check_empty(const input::Initial& initial, const RunOptions& options) {
  std::error_code unknown;  // of a folder that is not there yet
  if (!initial.result.empty() && fs::equivalent(initial.result_folder, options.folder, unknown)) {
    throw Error(ExitCode::folder_exists, fmt::format("the case starts from the result in '{}', which stays as it is; "
                                                     "give another folder with -o",
                                                     options.folder.string()));
  }
  if (options.resume || !fs::exists(options.folder)) return;
  if (!fs::is_directory(options.folder)) {
    throw Error(ExitCode::folder_exists, fmt::format("'{}' is a file; results need a folder", options.folder.string()));
  }
  if (holds_nothing(options.folder) || options.overwrite) return;
  throw Error(ExitCode::folder_exists,
              fmt::format("the folder '{}' is not empty; give another one with -o, replace it with --overwrite, "
                          "or go on with --resume",
                          options.folder.string()));
}

void clear(const RunOptions& options) {
  if (options.resume || !options.overwrite || !fs::exists(options.folder)) return;
  for (const char* name : own_files) fs::remove_all(options.folder / name);
  // Pictures of the old results would be taken for those of the new ones.
  for (const auto& entry : fs::directory_iterator(options.folder)) {
    if (is_picture(entry.path())) fs::remove(entry.path());
    if (is_reduction(entry.path())) fs::remove_all(entry.path());
  }
}

}  // namespace

void check_folder(const input::Initial& initial, const RunOptions& options) {
  use_folder(options.folder, [&] { check_empty(initial, options); });
}

void clear_folder(const RunOptions& options) {
  use_folder(options.folder, [&] { clear(options); });
}

std::optional<results::RunResult> load_finished(const RunOptions& options, const std::string& input_hash) {
  if (!options.resume) return std::nullopt;
  auto run = results::read_file<results::RunResult>(options.folder / "summary.json");
  if (!run || run->status != results::Status::finished) return std::nullopt;
  if (run->provenance.input_hash != input_hash) {
    throw Error(
        ExitCode::wrong_input,
        fmt::format("'{}' holds the results of another input; start anew with --overwrite", options.folder.string()));
  }
  return run;
}

}  // namespace talus::run
