// SPDX-License-Identifier: MIT
#pragma once
// Queries of free memory, and return of freed memory to the system.

#include <optional>
#include <string>

namespace talus {

/// Returns the bytes that can be allocated without swapping: MemAvailable of the kernel, or the rest of a container's
/// limit if that is less; std::nullopt if unknown.
std::optional<double> find_free_memory();

/// Returns the same from the texts of /proc/meminfo and of memory.max and memory.current of the control group; texts
/// may be empty.
std::optional<double> find_free_memory(const std::string& meminfo, const std::string& limit, const std::string& used);

/// Returns the size of this process's address space [bytes]; std::nullopt if unknown.
std::optional<double> find_address_size();

/// Returns the size of this process's address space including all free memory [bytes]; std::nullopt if unknown.
std::optional<double> find_address_room();

/// Returns freed memory to the system, which the C library would keep, after work that temporarily needed much memory.
void return_freed_memory();

/// Formats bytes as "1.2 GB" or "340 MB".
std::string write_bytes(double bytes);

}  // namespace talus
