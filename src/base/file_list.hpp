// SPDX-License-Identifier: MIT
#pragma once
// How the list of the files that a run writes into its folder grows; what it says is in base/file_list.hpp.

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

// The list of the files that a run wrote, kept in its folder, against what is there: what --overwrite removes, and what
// --resume checks.

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

struct OpenList;

/// While it exists, every file and folder that this process makes or removes below `folder` through atomic_file.hpp is
/// listed there. A line is appended before a file is made, with its size and hash, and another one when it is whole: a
/// process that is killed at any moment leaves no file unlisted. Of nested folders with lists each has its own. A file
/// of the folder that is not listed is not replaced: Error (folder_exists).
class FileList {
 public:
  /// Begins the list of a folder that exists, or continues it. Throws Error (cannot_write), and Error (wrong_input)
  /// when the list cannot be read.
  explicit FileList(const std::filesystem::path& folder);
  FileList(const FileList&) = delete;
  FileList& operator=(const FileList&) = delete;
  ~FileList();

  /// Continues the list of the nearest folder above a file of it that is still to come; nothing where there is none, or
  /// this process continues it already.
  static std::unique_ptr<FileList> find(const std::filesystem::path& file);

  /// Lists a folder that another process makes.
  void add_folder(const std::string& name);

 private:
  std::shared_ptr<OpenList> open_;
};

// Writers of files call the following functions, which do nothing outside the folder of a FileList.

/// Lists the content of `path` before a file of these bytes replaces it. Throws Error (folder_exists) when a file that
/// no run wrote is in the way.
void list_content(const std::filesystem::path& path, std::span<const std::byte> bytes);
/// Lists the content of a finished temporary file in the same way.
void list_content(const std::filesystem::path& path, const std::filesystem::path& temporary);
/// Lists `path` before its temporary file is made. Throws as list_content().
void list_temporary(const std::filesystem::path& path);
/// Lists that `path` is whole.
void list_whole(const std::filesystem::path& path);
/// Lists `path` before rows are appended to it.
void list_growing(const std::filesystem::path& path);
/// Lists the rows so far: check_listed() expects them, and accepts more where the file still grows.
void list_grown(const std::filesystem::path& path, bool still_grows);
/// Lists a folder before it is made.
void list_folder(const std::filesystem::path& folder);
/// Lists that `path` is about to be removed. Returns false where it is not listed and must stay.
bool list_removal(const std::filesystem::path& path);

}  // namespace talus
