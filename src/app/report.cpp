// SPDX-License-Identifier: MIT
// `talus report DIR`: one HTML file of a folder of results; `talus collect DIR`: result files from the frames of a
// killed run.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/command_line.hpp"
#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "base/file_list.hpp"
#include "base/folder_lock.hpp"
#include "base/progress.hpp"
#include "base/text.hpp"
#include "output/files/frames_reader.hpp"
#include "report/report.hpp"

namespace talus::app {

void add_report(CLI::App& app) {
  const Command command(app, "report", "Write a report of a run or a study as one HTML file");
  const auto folder = std::make_shared<std::string>(), data = std::make_shared<std::string>();
  command.take("DIR", *folder, "Folder of the results of a run or a study; report.html is written there").required();
  command.take("--data", *data, "Write only the data of the page, as JSON, into FILE; the run may be in progress")
      .shown_as("FILE");
  command.act([folder, data] {
    catch_interrupts();
    if (data->empty())
      print(stdout, fmt::format("{}\n", report::write_report(*folder).string()));
    else
      write_atomically(*data, report::write_data(*folder));
  });
}

// The following functions implement `talus collect`.

namespace {

namespace fs = std::filesystem;

/// Returns the folder itself and all below it that hold frames: trials and variants have frames of their own.
std::vector<fs::path> find_runs(const fs::path& folder) {
  std::vector<fs::path> found;
  if (output::holds_frames(folder)) found.push_back(folder);
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_directory() && output::holds_frames(entry.path())) found.push_back(entry.path());
  std::sort(found.begin(), found.end());
  return found;
}

/// Throws Error (wrong_input) if a frame of the run is missing or has changed.
void check_frames(const fs::path& run) {
  const fs::path frames = fs::absolute(run / "frames").lexically_normal();
  const auto listed = find_listed_folder(frames);
  if (listed) check_listed(*listed, [&](const std::string& name) { return (*listed / name).parent_path() == frames; });
}

void collect(const std::string& name) {
  if (!fs::is_directory(name)) fail_input("there is no folder '{}'", name);
  const std::vector<fs::path> runs = find_runs(name);
  const ResultsLock lock(name, runs);  // a run that has just started has no frames yet
  if (runs.empty()) fail_input("there are no frames of a run in '{}'", name);
  for (const fs::path& run : runs) {
    check_frames(run);
    const auto files = FileList::find(run / "results.vtkhdf");
    const int count = output::collect(run);
    print(stdout, fmt::format("{}: {} frame{}\n", (run / "results.vtkhdf").string(), count, count == 1 ? "" : "s"));
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
