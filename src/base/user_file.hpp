// SPDX-License-Identifier: MIT
#pragma once
// Reading of files named by the user: regular files up to a stated size, read as a whole. Pipes, devices, entries of
// /proc and endless files are rejected at once. Also: safe file names from names in a case.

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace talus {

/// Size limits of input files [bytes], listed in docs/manual/command-line.md.
namespace largest_file {
inline constexpr std::uint64_t megabyte = 1'000'000;
inline constexpr std::uint64_t case_file = 10 * megabyte;
inline constexpr std::uint64_t table = 50 * megabyte;                           ///< series, measured curves
inline constexpr std::uint64_t mesh = 2000 * megabyte;                          ///< Gmsh format
inline constexpr std::uint64_t library = 500 * megabyte;                        ///< compiled constitutive laws
inline constexpr std::uint64_t result = 1000 * megabyte;                        ///< JSON and CSV of results
inline constexpr std::uint64_t any = std::numeric_limits<std::int64_t>::max();  ///< HDF5, not read as a whole
}  // namespace largest_file

/// The reason why a file cannot be read.
struct FileFault {
  std::string why;  ///< the end of a sentence: "it is a folder, not a file"
  bool is_missing = false;
};

/// Returns the reason why `path` is not a readable regular file of at most `most` bytes; std::nullopt if it is. Throws
/// Error (no_memory) if this process may not open more files.
std::optional<FileFault> find_file_fault(const std::filesystem::path& path, std::uint64_t most);

/// Returns the content of the file. Throws Error (wrong_input) "cannot read 'path': why".
std::string read_user_file(const std::filesystem::path& path, std::uint64_t most);

/// Reads the file into `text`; returns the reason if that fails.
std::optional<FileFault> try_user_file(const std::filesystem::path& path, std::uint64_t most, std::string& text);

/// Throws Error (no_memory) if this process may open fewer files than any command needs.
void require_open_files();

/// Throws Error (no_memory) if `reason`, a value of errno, is the limit of open files of this process or machine.
void refuse_full_file_table(int reason);

// File and folder names that come from a case, a list of jobs or a result. Paths are made from such names only by these
// functions.

/// Longest accepted or generated name [bytes]. File systems allow 255; the rest is reserved for ".csv.part" and
/// numbers.
inline constexpr std::size_t longest_file_name = 200;

/// Returns the reason why `name` is not a valid name within a folder, as the end of a sentence: "it holds '/'"; empty
/// if it is valid.
std::string find_name_fault(std::string_view name);

/// Returns true for names of result files and folders of the program, and for device names of Windows.
bool is_reserved_name(std::string_view name);

/// Returns `folder` / (`name` + `ending`). Throws Error (wrong_input) if find_name_fault() rejects the name.
std::filesystem::path join_name(const std::filesystem::path& folder, std::string_view name,
                                std::string_view ending = "");

/// Returns `folder` / `path` with every part checked as a name. Throws Error (wrong_input) for an absolute path and for
/// one that leaves `folder`.
std::filesystem::path join_path(const std::filesystem::path& folder, std::string_view path);

/// Makes a file name that is not reserved from `text`: letters, digits and _ . + - are kept, other characters are
/// replaced by one underscore per run, dots and underscores at the ends are removed. The name has at most `longest`
/// bytes; `if_empty` is returned if nothing is left.
std::string make_file_name(std::string_view text, std::string_view if_empty, std::size_t longest = longest_file_name);

/// Makes a file name that is not in `taken`, with a number if necessary, and adds it to `taken`.
std::string take_file_name(std::string_view text, std::string_view if_empty, std::set<std::string>& taken);

}  // namespace talus
