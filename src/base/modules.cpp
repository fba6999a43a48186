// SPDX-License-Identifier: MIT
#include "base/modules.hpp"

#include <dlfcn.h>

#include <filesystem>

#include "base/error.hpp"

namespace talus {

void* load_module(const std::string& name, const char* maker, bool global, std::string& why) {
  std::error_code ignored;
  const std::string program = std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path().string();
  void* library = nullptr;
  for (std::string path : {program + "/", program + "/../lib/talus/"})
    if (library == nullptr) library = dlopen(path.append(name).c_str(), RTLD_NOW | (global ? RTLD_GLOBAL : RTLD_LOCAL));
  if (library == nullptr) {
    why = dlerror();
    return nullptr;
  }
  void* function = dlsym(library, maker);
  if (function == nullptr) throw Error(ExitCode::wrong_input, name + " is of another version");
  return function;
}

}  // namespace talus
