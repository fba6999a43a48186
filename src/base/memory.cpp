// SPDX-License-Identifier: MIT
#include "base/memory.hpp"

#include <fmt/format.h>
#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "base/numbers.hpp"

namespace talus {
namespace {

std::string read(const char* path) {
  std::ifstream file(path);
  std::ostringstream text;
  if (file) text << file.rdbuf();
  return text.str();
}

/// Returns the number at the beginning of a text.
std::optional<double> parse(const std::string& text) {
  const double value = read_number(text);
  return std::isnan(value) ? std::nullopt : std::optional(value);
}

}  // namespace

std::optional<double> find_free_memory() {
  return find_free_memory(read("/proc/meminfo"), read("/sys/fs/cgroup/memory.max"),
                          read("/sys/fs/cgroup/memory.current"));
}

std::optional<double> find_free_memory(const std::string& meminfo, const std::string& limit, const std::string& used) {
  std::optional<double> free;
  constexpr const char* word = "MemAvailable:";
  if (const auto at = meminfo.find(word); at != std::string::npos)
    if (const auto kilobytes = parse(meminfo.substr(at + std::string(word).size()))) free = 1024 * *kilobytes;
  // A control group without a limit has the text "max".
  const auto most = parse(limit), taken = parse(used);
  if (most && taken) free = std::min(free.value_or(*most - *taken), std::max(0.0, *most - *taken));
  return free;
}

std::optional<double> find_address_size() {
  const auto pages = parse(read("/proc/self/statm"));  // reads the first number
  return pages ? std::optional(*pages * static_cast<double>(sysconf(_SC_PAGESIZE))) : std::nullopt;
}

std::optional<double> find_address_room() {
  const auto free = find_free_memory(), size = find_address_size();
  return free && size ? std::optional(*size + *free) : std::nullopt;
}

void return_freed_memory() {
#if defined(__GLIBC__)
  malloc_trim(0);
#endif
}

std::string write_bytes(double bytes) {
  constexpr double thousand = 1000;
  const char* unit = "MB";
  double value = bytes / 1e6;
  for (const char* larger : {"GB", "TB", "PB"}) {
    if (value < thousand) break;
    value /= thousand;
    unit = larger;
  }
  return value < 10 ? fmt::format("{:.1f} {}", value, unit) : fmt::format("{:.0f} {}", value, unit);
}

}  // namespace talus
