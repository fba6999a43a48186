// SPDX-License-Identifier: MIT
#include "base/modules.hpp"

#include <dlfcn.h>

#include <filesystem>

#include "base/error.hpp"

namespace talus {
namespace {

/// Where the program is, or the library that Python has loaded.
std::string find_own_folder() {
  Dl_info own{};
  std::error_code ignored;
  const bool known = dladdr(reinterpret_cast<void*>(&find_own_folder), &own) != 0 && own.dli_fname != nullptr;
  std::filesystem::path file = known ? std::filesystem::canonical(own.dli_fname, ignored) : "";
  // A program says the word with which it was called, which may be none of a file.
  if (file.extension() != ".so") file = std::filesystem::read_symlink("/proc/self/exe", ignored);
  return file.parent_path().string();
}

/// From the program, from Python's library in its package, in the folder of a processor's level, and in a build.
constexpr const char* places[] = {"/", "/../lib/talus/", "/../../../talus/", "/../", "/../../bin/"};

}  // namespace

void* load_module(const std::string& name, const char* maker, bool global, std::string& why) {
  const std::string own = find_own_folder();
  void* library = nullptr;
  for (const char* place : places) {
    const std::string path = std::string(own).append(place).append(name);
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
