// SPDX-License-Identifier: MIT
#pragma once
// How much memory is free for a run.

#include <optional>
#include <string>

namespace talus::run {

/// Bytes that can be taken without swapping: the kernel's MemAvailable, or what a container's limit leaves if that is
/// less. Nothing where the system does not say.
std::optional<double> find_free_memory();

/// The same from the texts of /proc/meminfo and of the control group's memory.max and memory.current; texts may be
/// empty.
std::optional<double> find_free_memory(const std::string& meminfo, const std::string& limit, const std::string& used);

/// "1.2 GB", "340 MB".
std::string write_bytes(double bytes);

}  // namespace talus::run
