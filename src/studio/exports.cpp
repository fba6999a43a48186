// SPDX-License-Identifier: MIT
#include "studio/exports.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>

#include "base/atomic_file.hpp"
#include "base/hash.hpp"
#include "base/user_file.hpp"
#include "studio/process.hpp"

namespace talus::studio {
namespace {

namespace fs = std::filesystem;

/// A number that no other request of this machine has at the same time.
std::string make_number() {
  static std::atomic<int> count{0};
  return fmt::format("{}-{}", getpid(), ++count);
}

/// A file that is removed in any case.
struct ScratchFile {
  explicit ScratchFile(fs::path file) : path(std::move(file)) {}
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;
  ~ScratchFile() {
    std::error_code ignored;
    fs::remove(path, ignored);
  }
  fs::path path;
};

/// Runs the program with `arguments`, after which the name of a file follows, and returns this file.
std::string make_file(const Workspace& workspace, const fs::path& program, std::vector<std::string> arguments,
                      const std::string& ending) {
  constexpr double longest = 120;  // [s]
  const fs::path folder = workspace.state() / "exports";
  make_own_folder(folder);
  const std::string number = make_number();
  const ScratchFile file(folder / fmt::format("{}.{}", number, ending)), log(folder / (number + ".log"));
  arguments.push_back(file.path.string());
  run_process(program, arguments, log.path, longest);
  return read_user_file(file.path, largest_file::result);
}

std::string export_source(const Workspace& workspace, const fs::path& program, const fs::path& source,
                          const std::string& format) {
  if (format != "dxf" && format != "xlsx") throw Refusal(404, "an export is a .dxf or an .xlsx");
  return make_file(workspace, program, {"talus", "export", source.string(), "--overwrite", "-o"}, format);
}

}  // namespace

std::string export_results(const Workspace& workspace, const fs::path& program, const fs::path& results,
                           const std::string& format) {
  return export_source(workspace, program, results, format);
}

std::string export_case(const Workspace& workspace, const fs::path& program, const std::string& text,
                        const std::string& path) {
  if (text.size() > largest_file::case_file) throw Refusal(413, "the text is larger than a case file may be");
  const fs::path file = path.empty() ? workspace.folder() / "case.toml" : workspace.find(path);
  // Beside the case, because its tables are named relative to it.
  const ScratchFile copy(file.parent_path() / fmt::format(".{}-export-{}.toml", file.stem().string(), make_number()));
  write_atomically(copy.path, text);
  return export_source(workspace, program, copy.path, "dxf");
}

std::string stamp_results(const fs::path& results) {
  std::string text;
  std::error_code failure;
  for (auto entry = fs::recursive_directory_iterator(results, failure); entry != fs::recursive_directory_iterator();
       entry.increment(failure)) {
    std::error_code fault;
    if (!entry->is_regular_file(fault) || entry->is_symlink(fault)) continue;
    text += fmt::format("{} {} {}\n", entry->path().string(), entry->file_size(fault),
                        entry->last_write_time(fault).time_since_epoch().count());
  }
  return hash_text(text);
}

std::string read_report_data(const Workspace& workspace, const fs::path& program, const fs::path& results) {
  return make_file(workspace, program, {"talus", "report", results.string(), "--data"}, "json");
}

}  // namespace talus::studio
