// SPDX-License-Identifier: MIT
#pragma once
// How much memory is free, and giving some back.

#include <optional>
#include <string>

namespace talus {

/// Bytes that can be taken without swapping: the kernel's MemAvailable, or what a container's limit leaves if that is
/// less. Nothing where the system does not say.
std::optional<double> find_free_memory();

/// The same from the texts of /proc/meminfo and of the control group's memory.max and memory.current; texts may be
/// empty.
std::optional<double> find_free_memory(const std::string& meminfo, const std::string& limit, const std::string& used);

/// The size [bytes] of this process's address space; nothing where it is not known.
std::optional<double> find_address_size();

/// The size [bytes] that this process's address space would have with all that memory; nothing where it is not known.
std::optional<double> find_address_room();

/// Gives memory that was freed back to the system, which the C library would keep: after work that needed much for a
/// while.
void return_freed_memory();

/// "1.2 GB", "340 MB".
std::string write_bytes(double bytes);

}  // namespace talus
