// SPDX-License-Identifier: MIT
#pragma once
// How the list of the files that a run writes into its folder grows; what it says is in base/listed_files.hpp.

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "base/listed_files.hpp"

namespace talus {

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
