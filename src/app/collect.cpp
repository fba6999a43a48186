// SPDX-License-Identifier: MIT
// `talus collect DIR`: makes result files of the frames that a killed run left behind.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/commands.hpp"
#include "base/error.hpp"
#include "output/files/frames_reader.hpp"

namespace talus::app {
namespace {

namespace fs = std::filesystem;

/// A killed run may have made its folder of frames and no frame yet, or a part of one.
bool holds_frames(const fs::path& folder) {
  if (fs::exists(folder / "results.vtkhdf")) return true;
  if (!fs::is_directory(folder / "frames")) return false;
  const fs::directory_iterator files(folder / "frames");
  return std::any_of(begin(files), end(files), [](const auto& file) { return file.path().extension() == ".h5"; });
}

/// The folder itself and all below it that hold frames: trials and variants keep frames of their own.
std::vector<fs::path> find_runs(const fs::path& folder) {
  std::vector<fs::path> found;
  if (holds_frames(folder)) found.push_back(folder);
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_directory() && holds_frames(entry.path())) found.push_back(entry.path());
  std::sort(found.begin(), found.end());
  return found;
}

void collect(const std::string& name) {
  if (!fs::is_directory(name)) throw Error(ExitCode::wrong_input, fmt::format("there is no folder '{}'", name));
  const std::vector<fs::path> runs = find_runs(name);
  if (runs.empty()) throw Error(ExitCode::wrong_input, fmt::format("there are no frames of a run in '{}'", name));
  for (const fs::path& run : runs) {
    const int count = output::collect(run);
    fmt::print("{}: {} frame{}\n", (run / "results.vtkhdf").string(), count, count == 1 ? "" : "s");
  }
}

}  // namespace

void add_collect(CLI::App& app) {
  const Command command(app, "collect", "Write the result files of a run that was killed, from its frames");
  const auto folder = std::make_shared<std::string>();
  command.take("DIR", *folder, "Folder of the results, with those of its trials and variants").required();
  command.act([folder] { collect(*folder); });
}

}  // namespace talus::app
