// SPDX-License-Identifier: MIT
#pragma once
// Atomic writing of files: each file is written under a temporary name, flushed to the disk and renamed, so it is
// either complete or absent. Files in a folder of results are listed there (base/file_list.hpp).

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace talus {

/// Writes `text` to `path` atomically: after a loss of power, and for every reader, the file is either the old or the
/// new one. Throws Error (cannot_write) with the path, the reason and `safe`, a clause on what is not affected, e.g.
/// "the 12 frames written before are whole"; the temporary file is removed.
void write_atomically(const std::filesystem::path& path, std::string_view text, const std::string& safe = "");
void write_atomically(const std::filesystem::path& path, std::span<const std::byte> bytes,
                      const std::string& safe = "");

/// Returns the name of a file while it is being written: `path` + ".part".
std::filesystem::path temporary_name(const std::filesystem::path& path);

/// Prepares for a file that is written by other means to temporary_name(path), which it returns; publish() must follow.
/// An existing entry of that name, such as a symbolic link, is removed.
std::filesystem::path begin_file(const std::filesystem::path& path);
/// Removes the temporary file of `path`.
void clear_temporary(const std::filesystem::path& path);

/// Flushes the completed temporary file of `path` to the disk and renames it to `path`. Errors as write_atomically().
void publish(const std::filesystem::path& path, const std::string& safe = "");

/// Makes `folder` and its parents. Throws Error (cannot_write) with the path and the reason.
void make_folder(const std::filesystem::path& folder, const std::string& safe = "");

/// Removes a file and its temporary file left by a killed process; a user's file in a folder of results is kept. Throws
/// Error (cannot_write).
void remove_file(const std::filesystem::path& path);

/// Calls `work`, which reads, makes or removes files in `folder`; converts filesystem_error to Error (cannot_write).
void use_folder(const std::filesystem::path& folder, auto&& work);

/// Throws Error (cannot_write) "cannot write 'path': reason; safe". `reason` is a value of errno.
[[noreturn]] void throw_cannot_write(const std::filesystem::path& path, int reason, const std::string& safe = "");

void use_folder(const std::filesystem::path& folder, auto&& work) {
  try {
    work();
  } catch (const std::filesystem::filesystem_error& error) {
    throw_cannot_write(error.path1().empty() ? folder : error.path1(), error.code().value());
  }
}

}  // namespace talus
