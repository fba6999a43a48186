// SPDX-License-Identifier: MIT
#pragma once
// Names of files and folders that come from a case, a list of jobs or a result: the only way from such a name to a
// path.

#include <filesystem>
#include <set>
#include <string>
#include <string_view>

namespace talus {

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
