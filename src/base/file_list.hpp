// SPDX-License-Identifier: MIT
#pragma once
// The list of the files that runs write into a folder of results: --overwrite removes the listed files, and --resume
// checks them.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace talus {

// Reading of a list and comparison with the files in the folder.

/// Name of the list file in a folder of results.
inline constexpr const char* list_file = "talus.files";

/// Size [bytes] and hash of a file.
struct FileContent {
  std::uint64_t size = 0, hash = 0;
  bool operator==(const FileContent&) const = default;
};
FileContent describe_content(std::span<const std::byte> bytes);
/// Returns size and hash of the first `most` bytes of a file. Throws Error (wrong_input) if it cannot be read.
FileContent describe_content(const std::filesystem::path& file, std::uint64_t most = UINT64_MAX);

/// State of a file after all lines of a list.
struct ListedFile {
  std::optional<FileContent> whole;    ///< content after the last completed write
  std::optional<FileContent> planned;  ///< announced content of a write that is not completed
  bool has_temporary = false, grows = false, removed = false;

  bool is_being_written() const { return has_temporary || planned.has_value(); }
};

/// The parsed lines of a list.
struct Listed {
  std::map<std::string, ListedFile> files;
  std::set<std::string> folders;
  bool has_header = false;  ///< false: the process was killed before it wrote the header
  bool is_cut_off = false;  ///< the last line is incomplete

  /// Parses a line: a word, size and hash for "write", and a name. Ignores an incomplete line.
  void add(const std::string& line);
};

/// Header line of a list.
inline constexpr const char* list_header = "Talus files 1";
/// Escapes a name such that it is on one line.
std::string write_name(const std::string& name);
/// Returns the list of a folder. Throws Error (wrong_input) if its file is not a list.
Listed read_list(const std::filesystem::path& folder);

/// Returns an absolute path without "." and "..".
std::filesystem::path make_absolute(const std::filesystem::path& path);

bool has_list(const std::filesystem::path& folder);
/// Returns the absolute path of the nearest folder above a file that has a list.
std::optional<std::filesystem::path> find_listed_folder(const std::filesystem::path& file);

/// Throws Error (wrong_input) with the first listed file that is missing or changed, among the files whose name
/// satisfies `is_needed`.
void check_listed(const std::filesystem::path& folder, const std::function<bool(const std::string&)>& is_needed);

/// Extent of the comparison with a list: sizes only, or sizes and contents.
enum class Compared { sizes, contents };

/// Files and folders below a folder with a list; paths are relative to it.
struct SortedFiles {
  std::filesystem::path folder;
  std::vector<std::filesystem::path> own;      ///< written by runs and unchanged
  std::vector<std::filesystem::path> foreign;  ///< not listed, or changed since
  std::vector<std::filesystem::path> folders;  ///< made by runs, outer ones first
  std::vector<std::filesystem::path> lists;    ///< folders with a list, the folder itself first
};
SortedFiles sort_files(const std::filesystem::path& folder, Compared compared);

/// Removes the files of runs, then their folders if empty, and starts a new list of the folder. Throws Error
/// (folder_exists) before any removal if another process uses one of the folders.
void remove_own(const SortedFiles& files);

struct OpenList;

/// Records in the list every file and folder below `folder` that this process makes or removes through atomic_file.hpp,
/// for the lifetime of the object. A line with size and hash is appended before a file is made and another one when it
/// is complete, so that a process killed at any time leaves no unlisted file. Nested folders with lists have separate
/// lists. Replacing a file that is not listed throws Error (folder_exists).
class FileList {
 public:
  /// Opens the list of an existing folder, or creates it. Throws Error (cannot_write); throws Error (wrong_input) if
  /// the list cannot be read.
  explicit FileList(const std::filesystem::path& folder);
  FileList(const FileList&) = delete;
  FileList& operator=(const FileList&) = delete;
  ~FileList();

  /// Opens the list of the nearest folder above a file that is to be written; nullptr if there is no list, or if this
  /// process has it open.
  static std::unique_ptr<FileList> find(const std::filesystem::path& file);

  /// Lists a folder that another process makes.
  void add_folder(const std::string& name);

 private:
  std::shared_ptr<OpenList> open_;
};

// Functions for writers of files, without effect outside the folder of a FileList.

/// Lists the content of `path` before a file of these bytes replaces it. Throws Error (folder_exists) if a file there
/// was not written by a run.
void list_content(const std::filesystem::path& path, std::span<const std::byte> bytes);
/// Lists the content of a completed temporary file in the same way.
void list_content(const std::filesystem::path& path, const std::filesystem::path& temporary);
/// Lists `path` before its temporary file is made. Throws as list_content().
void list_temporary(const std::filesystem::path& path);
/// Marks `path` as complete.
void list_whole(const std::filesystem::path& path);
/// Lists `path` before rows are appended to it.
void list_growing(const std::filesystem::path& path);
/// Lists the current rows: check_listed() requires them, and accepts further rows if the file still grows.
void list_grown(const std::filesystem::path& path, bool still_grows);
/// Lists a folder before it is made.
void list_folder(const std::filesystem::path& folder);
/// Lists the removal of `path`. Returns false if the file is not listed and must be kept.
bool list_removal(const std::filesystem::path& path);

}  // namespace talus
