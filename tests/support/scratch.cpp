// SPDX-License-Identifier: MIT
// Folders for the files of tests: the folder of the process, and its removal.
#include "support/scratch.hpp"

#include <unistd.h>

#include <cstdlib>
#include <stdexcept>
#include <system_error>

namespace talus::support {
namespace {

namespace fs = std::filesystem;

class ProcessFolder {
 public:
  ProcessFolder() {
    std::string name = (fs::temp_directory_path() / "talus-test-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make the folder '" + name + "'");
    fs::permissions(name, fs::perms(0755));  // tests act as a user without rights, too
    path = name;
  }
  ProcessFolder(const ProcessFolder&) = delete;
  ProcessFolder& operator=(const ProcessFolder&) = delete;
  /// A child process may exit while its parent still needs the folder.
  ~ProcessFolder() {
    std::error_code unimportant;
    if (getpid() == owner_) fs::remove_all(path, unimportant);
  }

  fs::path path;

 private:
  pid_t owner_ = getpid();
};

}  // namespace

fs::path name_scratch(const std::string& name) {
  static const ProcessFolder folder;
  return folder.path / name;
}

fs::path make_scratch(const std::string& name) {
  const fs::path folder = name_scratch(name);
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

}  // namespace talus::support
