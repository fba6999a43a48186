// SPDX-License-Identifier: MIT
#include "base/modules.hpp"

#include <dlfcn.h>

#include <filesystem>
#include <vector>

#include "base/error.hpp"

namespace talus {
namespace {

/// Where modules may stand: beside the program or where it is installed; for the library that Python has loaded, where
/// its package is installed, in the folder above that of a processor's level, and in a build.
std::vector<std::string> list_folders() {
  Dl_info own{};
  std::error_code ignored;
  const bool known = dladdr(reinterpret_cast<void*>(&list_folders), &own) != 0 && own.dli_fname != nullptr;
  std::filesystem::path file = known ? std::filesystem::canonical(own.dli_fname, ignored) : "";
  const bool is_library = file.extension() == ".so";
  // A program says the word with which it was called, which may be none of a file.
  if (!is_library) file = std::filesystem::read_symlink("/proc/self/exe", ignored);
  const std::string folder = file.parent_path().string();
  if (is_library) return {folder + "/../../../talus/", folder + "/../", folder + "/../../bin/"};
  return {folder + "/", folder + "/../lib/talus/"};
}

}  // namespace

void* load_module(const std::string& name, const char* maker, bool global, std::string& why) {
  void* library = nullptr;
  for (std::string path : list_folders()) {
    path += name;
    library = dlopen(path.c_str(), RTLD_NOW | (global ? RTLD_GLOBAL : RTLD_LOCAL));
    if (library != nullptr) break;
    if (why.empty() || std::filesystem::exists(path)) why = dlerror();
  }
  if (library == nullptr) return nullptr;
  void* function = dlsym(library, maker);
  if (function == nullptr) throw Error(ExitCode::wrong_input, name + " is of another version");
  return function;
}

}  // namespace talus
