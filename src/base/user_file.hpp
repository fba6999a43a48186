// SPDX-License-Identifier: MIT
#pragma once
// Files that a user names: regular files below a stated size, read whole. A pipe, a device, an entry of /proc or a file
// without end is a fault that is found at once.

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>

namespace talus {

/// Largest files that are read [bytes], listed in docs/manual/command-line.md.
namespace largest_file {
inline constexpr std::uint64_t megabyte = 1'000'000;
inline constexpr std::uint64_t case_file = 10 * megabyte;
inline constexpr std::uint64_t table = 50 * megabyte;                           ///< series, measured curves
inline constexpr std::uint64_t mesh = 2000 * megabyte;                          ///< in Gmsh's format
inline constexpr std::uint64_t library = 500 * megabyte;                        ///< compiled soils
inline constexpr std::uint64_t result = 1000 * megabyte;                        ///< JSON and CSV of results
inline constexpr std::uint64_t any = std::numeric_limits<std::int64_t>::max();  ///< HDF5, which is not read whole
}  // namespace largest_file

/// The reason why a file cannot be read.
struct FileFault {
  std::string why;  ///< the end of a sentence: "it is a folder, not a file"
  bool is_missing = false;
};

/// Why `path` is no regular file of at most `most` bytes that can be opened; nothing where it is one. Throws Error
/// (no_memory) where this process may open no more files.
std::optional<FileFault> find_file_fault(const std::filesystem::path& path, std::uint64_t most);

/// The content of such a file. Throws Error (wrong_input) "cannot read 'path': why".
std::string read_user_file(const std::filesystem::path& path, std::uint64_t most);

/// The same into `text`; returns what keeps it from being read.
std::optional<FileFault> try_user_file(const std::filesystem::path& path, std::uint64_t most, std::string& text);

/// Throws Error (no_memory) when this process may open fewer files than any command needs.
void require_open_files();

/// Throws Error (no_memory) when `reason`, a value of errno, says that this process or machine opens no more files.
void refuse_full_file_table(int reason);

}  // namespace talus
