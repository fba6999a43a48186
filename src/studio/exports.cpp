// SPDX-License-Identifier: MIT
#include "studio/exports.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>

#include "base/atomic_file.hpp"
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

std::string export_source(const Workspace& workspace, const fs::path& program, const fs::path& source,
                          const std::string& format) {
  constexpr double longest = 120;  // [s]
  if (format != "dxf" && format != "xlsx") throw Refusal(404, "an export is a .dxf or an .xlsx");
  const fs::path folder = workspace.state() / "exports";
  make_own_folder(folder);
  const std::string number = make_number();
  const ScratchFile file(folder / fmt::format("{}.{}", number, format)), log(folder / (number + ".log"));
  run_process(program, {"talus", "export", source.string(), "-o", file.path.string(), "--overwrite"}, log.path,
              longest);
  return read_user_file(file.path, largest_file::result);
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

}  // namespace talus::studio
