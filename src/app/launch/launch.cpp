// SPDX-License-Identifier: MIT
// The program `talus` of a package, which executes the build for this processor. The folder of the package has a
// folder with a complete program for each level of the instruction set. The launcher is compiled for every x86-64
// processor, and is not part of a build for one machine. It requires Linux, since it reads its own path from
// /proc/self/exe.

#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>

#include "app/wait_policy.hpp"
#include "base/error.hpp"

namespace {

struct Level {
  const char* name;
  bool runs_here;
};

/// Levels from the fastest to the slowest; the names are those of instruction_level in base/lane.hpp.
std::array<Level, 3> list_levels() {
  __builtin_cpu_init();
  const bool two =
      __builtin_cpu_supports("sse4.2") && __builtin_cpu_supports("popcnt") && __builtin_cpu_supports("ssse3");
  const bool three = two && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                     __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
  const bool four = three && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                    __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
                    __builtin_cpu_supports("avx512vl");
  return {{{"x86-64-v4", four}, {"x86-64-v3", three}, {"x86-64-v2", two}}};
}

int refuse(const std::string& sentence, talus::ExitCode code = talus::ExitCode::wrong_input) {
  std::fprintf(stderr, "talus: error: %s\n", sentence.c_str());
  return static_cast<int>(code);
}

/// Disables fused multiplication in the C library for the lowest level. Its sine with and without fused multiplication
/// differ in the last bit, so that results would depend on the processor.
void hide_fused_multiplication() {
  const char* given = std::getenv("GLIBC_TUNABLES");
  std::string text = given == nullptr || *given == '\0' ? "" : std::string(given) + ":";
  setenv("GLIBC_TUNABLES", (text + "glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4").c_str(), 1);
}

/// Sets the path of the database of units, which a wheel includes; a package uses that of the system.
void find_units(const std::filesystem::path& folder) {
  const std::filesystem::path units = folder / "units" / "udunits2.xml";
  std::error_code failure;
  if (std::filesystem::exists(units, failure)) setenv("UDUNITS2_XML_PATH", units.c_str(), 0);
}

}  // namespace

int main(int argc, char** argv) {
  const std::array<Level, 3> levels = list_levels();
  const char* asked = std::getenv("TALUS_LEVEL");
  const bool is_asked = asked != nullptr && *asked != '\0';
  const Level* chosen = nullptr;
  for (const Level& level : levels)
    if (chosen == nullptr && (is_asked ? level.name == std::string_view(asked) : level.runs_here)) chosen = &level;
  if (chosen == nullptr && is_asked)
    return refuse(std::string("TALUS_LEVEL is '") + asked + "'; the levels are x86-64-v2, x86-64-v3 and x86-64-v4");
  if (chosen == nullptr) return refuse("this processor has no SSE 4.2, which Talus needs");
  if (!chosen->runs_here)
    return refuse(std::string("TALUS_LEVEL is '") + asked + "', which this processor does not have");
  if (argc == 2 && std::string_view(argv[1]) == "--level") {
    std::puts(chosen->name);
    return 0;
  }
  std::error_code failure;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", failure);
  const std::string program = (self.parent_path() / chosen->name / "talus").string();
  find_units(self.parent_path());
  talus::app::set_wait_policy();
  if (chosen == &levels.back()) hide_fused_multiplication();
  execv(program.c_str(), argv);
  return refuse(program + " cannot be started: " + std::strerror(errno), talus::ExitCode::internal_error);
}
