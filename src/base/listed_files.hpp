// SPDX-License-Identifier: MIT
#pragma once
// The list of the files that a run wrote, kept in its folder, against what is there: what --overwrite removes, and what
// --resume checks.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace talus {

/// The list's file in a folder of results.
inline constexpr const char* list_file = "talus.files";

/// Size [bytes] and hash of a file.
struct FileContent {
  std::uint64_t size = 0, hash = 0;
  bool operator==(const FileContent&) const = default;
};
FileContent describe_content(std::span<const std::byte> bytes);
/// Size and hash of the first `most` bytes of a file. Throws Error (wrong_input) when the file cannot be read.
FileContent describe_content(const std::filesystem::path& file, std::uint64_t most = UINT64_MAX);

/// A file as the lines of a list leave it.
struct ListedFile {
  std::optional<FileContent> whole;    ///< when it was last whole
  std::optional<FileContent> planned;  ///< announced since then
  bool has_temporary = false, grows = false, removed = false;

  bool is_being_written() const { return has_temporary || planned.has_value(); }
};

/// The lines of a list, read.
struct Listed {
  std::map<std::string, ListedFile> files;
  std::set<std::string> folders;
  bool has_header = false;  ///< false: a process was killed before it wrote the first line
  bool is_cut_off = false;  ///< the last line is incomplete

  /// Adds a line: a word, for "write" size and hash, and a name. Ignores one that was cut off.
  void add(const std::string& line);
};

/// The first line of a list.
inline constexpr const char* list_header = "Talus files 1";
/// A name on one line.
std::string write_name(const std::string& name);
/// The list of a folder. Throws Error (wrong_input) when its file is none.
Listed read_list(const std::filesystem::path& folder);

/// An absolute path without dots.
std::filesystem::path make_absolute(const std::filesystem::path& path);

bool has_list(const std::filesystem::path& folder);
/// The nearest folder above a file that has a list, as an absolute path.
std::optional<std::filesystem::path> find_listed_folder(const std::filesystem::path& file);

/// Throws Error (wrong_input) naming the first listed file that is missing, or is not as it was written, of those for
/// whose name in the folder `is_needed` holds.
void check_listed(const std::filesystem::path& folder, const std::function<bool(const std::string&)>& is_needed);

/// Sizes alone are compared with a list, or contents as well.
enum class Compared { sizes, contents };

/// Files and folders below a folder with a list.
struct SortedFiles {
  std::filesystem::path folder;
  std::vector<std::filesystem::path> own;      ///< of a run, as it left them; relative to the folder, as all are
  std::vector<std::filesystem::path> foreign;  ///< not listed, or changed since
  std::vector<std::filesystem::path> folders;  ///< that runs made, outer ones first
  std::vector<std::filesystem::path> lists;    ///< folders with a list, the folder itself first
};
SortedFiles sort_files(const std::filesystem::path& folder, Compared compared);

/// Removes the files of runs, then their folders where these are empty. The list of the folder begins anew. Throws
/// Error (folder_exists) before anything is removed when another process uses one of the folders.
void remove_own(const SortedFiles& files);

}  // namespace talus
