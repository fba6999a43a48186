// SPDX-License-Identifier: MIT
#include "run/common/run_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "base/folder_lock.hpp"
#include "base/text.hpp"
#include "input/read.hpp"
#include "output/files/results_folder.hpp"
#include "results/json.hpp"
#include "results/present.hpp"

namespace talus::run {

namespace fs = std::filesystem;

namespace {

/// Names of files in the folders of runs and of their trials.
const char* const run_files[] = {"results.vtkhdf",
                                 "results.xdmf",
                                 "mesh.vtkhdf",
                                 "mesh.xdmf",
                                 "history.csv",
                                 "monitors.csv",
                                 "summary.json",
                                 "checkpoint.h5",
                                 "stages.json",
                                 "curve.csv",
                                 "profile.csv",
                                 "mesh.h5",
                                 "report.html",
                                 "season.csv",
                                 end_state_file,
                                 "lem.json",
                                 "fem.json",
                                 "fem.vtu",
                                 "water.json",
                                 "seepage.json",
                                 "seepage_state.json",
                                 "bounds.json",
                                 "timeline.json",
                                 "trial.json",
                                 "trials.json",
                                 "outcome.json",
                                 slip_line_file,
                                 "timeline_water.json",
                                 "construction.json",
                                 "construction_state.json",
                                 "construction_monitors.csv"};
/// Folders in the folder of a run.
const char* const run_folders[] = {"frames",           "trials",         "frozen",       "sections",
                                   "released_earlier", "released_later", "coarser_mesh", results::present_folder};

template <class Names>
bool has(const Names& names, const std::string& name) {
  return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

/// Returns true for folders of FEM in time, elements_1 and so on, of stages of construction, stage_1 and released_1,
/// and for their fields, construction_1.vtu.
bool is_numbered(const std::string& name) {
  const auto continues = [&](const std::string& begin, const std::string& ending = "") {
    return name.size() > begin.size() + ending.size() && name.starts_with(begin) && name.ends_with(ending) &&
           std::all_of(name.begin() + static_cast<std::ptrdiff_t>(begin.size()),
                       name.end() - static_cast<std::ptrdiff_t>(ending.size()),
                       [](unsigned char c) { return std::isdigit(c) != 0; });
  };
  return continues("elements_") || continues("stage_") || continues("released_") || continues("construction_", ".vtu");
}

/// Resolves symbolic links.
fs::path find_real(const fs::path& path) {
  std::error_code unknown;
  const fs::path real = fs::weakly_canonical(path, unknown);
  return real.has_filename() ? real : real.parent_path();
}

/// Throws Error (folder_exists) if `target` is or holds something that must not be replaced by results.
void check_target(const input::LoadedCase& loaded, const fs::path& target) {
  const fs::path folder = find_real(target), home = fs::path(loaded.file).parent_path();
  const auto holds = [&](const fs::path& path) {
    const fs::path real = find_real(path);
    return std::mismatch(folder.begin(), folder.end(), real.begin(), real.end()).first == folder.end();
  };
  const auto refuse = [&](const std::string& what) {
    throw Error(ExitCode::folder_exists, fmt::format("'{}' {}, and --overwrite replaces folders of results only; give "
                                                     "another folder",
                                                     target.string(), what));
  };
  std::vector<std::string> names = input::list_files(loaded.text, {});
  names.insert(names.begin(), fs::path(loaded.file).filename().string());
  std::error_code unknown;
  for (const std::string& name : names)
    if (fs::exists(home / name, unknown) && holds(home / name))
      refuse(fmt::format("holds '{}', which the case reads", (home / name).string()));
  if (holds(fs::current_path())) refuse("is or holds the current folder");
  if (const char* user = std::getenv("HOME"); user != nullptr && *user != '\0' && holds(user))
    refuse("is or holds the home folder");
  if (fs::exists(folder / ".git", unknown)) refuse("is a repository (.git)");
}

/// Throws Error (folder_exists) with the name of a foreign file that is in the way of a new one.
void refuse_obstacles(const SortedFiles& files, const IsWritten& is_written) {
  for (const fs::path& file : files.foreign) {
    const std::string path = (files.folder / file).string();
    if (has(file, ".git"))
      throw Error(ExitCode::folder_exists,
                  fmt::format("'{}' holds a repository ('{}'), and --overwrite replaces folders of results only; give "
                              "another folder",
                              files.folder.string(), path));
    const bool is_part = temporary_name(file.stem()) == file.filename();
    if (is_written(file) || (is_part && is_written(file.parent_path() / file.stem())))
      throw Error(ExitCode::folder_exists,
                  fmt::format("'{}' is in the way, and --overwrite keeps it, because no run wrote it or it was changed "
                              "since; move it away, or give another folder",
                              path));
  }
}

void check_empty(const input::LoadedCase& loaded, const RunOptions& options) {
  const input::Initial& initial = loaded.data.initial;
  std::error_code unknown;  // of a folder that does not exist yet
  if (!initial.result.empty() && fs::equivalent(initial.result_folder, options.folder, unknown)) {
    throw Error(ExitCode::folder_exists, fmt::format("the case starts from the result in '{}', which stays as it is; "
                                                     "give another folder with -o",
                                                     options.folder.string()));
  }
  if (!fs::exists(options.folder)) return;
  if (!fs::is_directory(options.folder)) {
    throw Error(ExitCode::folder_exists, fmt::format("'{}' is a file; results need a folder", options.folder.string()));
  }
  if (options.overwrite)
    return check_replaced(loaded, options.folder, [&](const fs::path& f) { return is_of_run(loaded.data, f); });
  if (holds_nothing(options.folder)) return;
  if (options.resume) return require_list(options.folder);
  throw Error(ExitCode::folder_exists,
              fmt::format("the folder '{}' is not empty; give another one with -o, replace it with --overwrite, "
                          "or continue with --resume",
                          options.folder.string()));
}

}  // namespace

bool is_of_run(const input::Case& data, const fs::path& file) {
  const std::string first = file.begin()->string(), name = file.filename().string();
  const bool is_folder = has(run_folders, first) || is_numbered(first);
  if (has(run_files, first)) return true;
  if (first == name || !is_folder) return is_folder;
  if (file.parent_path().filename() == "frames") return output::find_frame_number(file).has_value();
  if (first != "sections") return has(run_files, name);
  return std::any_of(data.output.sections.begin(), data.output.sections.end(),
                     [&](const input::SectionLine& line) { return name == make_printable(line.name) + ".csv"; });
}

void check_replaced(const input::LoadedCase& loaded, const fs::path& folder, const IsWritten& is_written) {
  check_target(loaded, folder);
  if (holds_nothing(folder)) return;
  require_list(folder);
  refuse_obstacles(sort_files(folder, Compared::sizes), is_written);
}

void replace_folder(const fs::path& folder, const IsWritten& is_written, Progress* progress) {
  use_folder(folder, [&] {
    if (!has_list(folder)) return;
    const SortedFiles files = sort_files(folder, Compared::contents);
    refuse_obstacles(files, is_written);
    remove_own(files);
    if (files.foreign.empty() || progress == nullptr) return;
    const std::size_t others = files.foreign.size() - 1;
    progress->note(fmt::format("kept '{}'{}, which no run wrote or which changed since",
                               (folder / files.foreign.front()).string(),
                               others == 0 ? "" : fmt::format(" and {} other file{}", others, others == 1 ? "" : "s")));
  });
}

RunOptions RunOptions::make_nested(const fs::path& nested) const {
  RunOptions options = *this;
  options.folder = nested;
  options.keeps_present = false;
  options.store_present = {};
  return options;
}

void remove_present(const RunOptions& options) {
  for (const char* file :
       {results::present_summary_file, results::present_reduction_file, results::present_bounds_file})
    remove_file(options.folder / file);
  std::error_code ignored;
  fs::remove(options.folder / results::present_folder, ignored);  // unless it has files of the user
}

void require_list(const fs::path& folder) {
  if (has_list(folder)) return;
  throw Error(ExitCode::folder_exists,
              fmt::format("the folder '{}' has no list of the files that a run wrote ({}); remove it yourself, or give "
                          "another folder",
                          folder.string(), list_file));
}

void check_kept(const fs::path& folder) {
  check_listed(folder, [&](const std::string& name) {
    const fs::path file = name;
    if (file.filename() == end_state_file) return fs::exists(folder / file);  // the end state may be deleted
    const fs::path end = file.extension();
    return file.filename() != "report.html" && end != ".svg" && end != ".png" && end != ".gp";
  });
}

void check_folder(const input::LoadedCase& loaded, const RunOptions& options) {
  use_folder(options.folder, [&] { check_empty(loaded, options); });
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
