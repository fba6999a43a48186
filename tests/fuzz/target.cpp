// SPDX-License-Identifier: MIT
#include "target.hpp"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <string>

#include "base/error.hpp"

namespace talus::fuzz {

void try_to(const std::function<void()>& work) try { work(); } catch (...) {
  const Failure failure = explain_failure(std::current_exception());
  if (failure.code != ExitCode::internal_error && !failure.sentence.empty()) return;
  std::fprintf(stderr, "a defect: %s\n", failure.sentence.c_str());
  std::abort();
}

const std::filesystem::path& as_file(std::span<const std::uint8_t> bytes, const char* name) {
  static const std::filesystem::path path = [&] {
    const std::filesystem::path memory = "/dev/shm";
    std::filesystem::path folder = std::filesystem::exists(memory) ? memory : std::filesystem::temp_directory_path();
    folder /= "talus_fuzz_" + std::to_string(getpid());
    std::filesystem::create_directory(folder);
    static const struct Remover {
      std::filesystem::path folder;
      ~Remover() {
        std::error_code unimportant;
        std::filesystem::remove_all(folder, unimportant);
      }
    } remover{folder};
    return folder / name;
  }();
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  return path;
}

}  // namespace talus::fuzz
