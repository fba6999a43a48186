// SPDX-License-Identifier: MIT
#pragma once
// Files that a user names: regular files below a stated size, read whole. A pipe, a device, an entry of /proc or a file
// without end is a fault that is found at once.

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <string_view>

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

// Names of files and folders that come from a case, a list of jobs or a result: the only way from such a name to a
// path.

/// Longest name [bytes] that is accepted or made. File systems allow 255, which leaves room for ".csv.part" and
/// numbers.
inline constexpr std::size_t longest_file_name = 200;

/// Why `name` is not that of one file in one folder, as the end of a sentence: "it holds '/'"; empty where it is.
std::string find_name_fault(std::string_view name);

/// Returns true for names that the program itself gives to files and folders of results, and for devices of Windows.
bool is_reserved_name(std::string_view name);

/// `folder` / (`name` + `ending`). Throws Error (wrong_input) for a name that find_name_fault() does not accept.
std::filesystem::path join_name(const std::filesystem::path& folder, std::string_view name,
                                std::string_view ending = "");

/// `folder` / `path`, whose parts are names. Throws Error (wrong_input) for an absolute path and for one that leaves
/// `folder`.
std::filesystem::path join_path(const std::filesystem::path& folder, std::string_view path);

/// `text` as the name of a file that is not reserved: letters, digits and _ . + - stay, runs of anything else become
/// one underscore, points at the ends are left out. At most `longest` bytes; `if_empty` where nothing is left.
std::string make_file_name(std::string_view text, std::string_view if_empty, std::size_t longest = longest_file_name);

/// The same, numbered where it is `taken`; it is taken then.
std::string take_file_name(std::string_view text, std::string_view if_empty, std::set<std::string>& taken);

}  // namespace talus
