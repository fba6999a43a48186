// SPDX-License-Identifier: MIT
#pragma once
// Files that are whole or absent: written under a temporary name, flushed to the disk, then renamed. Those of a folder
// of results are listed there (base/file_list.hpp).

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace talus {

/// Writes `text` to `path`, replacing what was there in one go: a reader, or a machine that loses power, sees the old
/// file or the new one, never a part. Throws Error (cannot_write) with the path, the reason and `safe`, a clause that
/// says what is not harmed, e.g. "the 12 frames written before are whole"; the temporary file is removed.
void write_atomically(const std::filesystem::path& path, std::string_view text, const std::string& safe = "");
void write_atomically(const std::filesystem::path& path, std::span<const std::byte> bytes,
                      const std::string& safe = "");

/// The name a file has while it is being written: `path` + ".part".
std::filesystem::path temporary_name(const std::filesystem::path& path);

/// The same before that file is made by other means; publish() follows. What had that name, such as a link to somewhere
/// else, is removed.
std::filesystem::path begin_file(const std::filesystem::path& path);
/// Removes what has the temporary name of `path`.
void clear_temporary(const std::filesystem::path& path);

/// Flushes the finished temporary file of `path` to the disk and gives it its name. Errors as for write_atomically.
void publish(const std::filesystem::path& path, const std::string& safe = "");

/// Makes `folder` and its parents. Throws Error (cannot_write) with the path and the reason.
void make_folder(const std::filesystem::path& folder, const std::string& safe = "");

/// Removes a file and what a killed process left of it, where it is no file of the user in a folder of results. Throws
/// Error (cannot_write).
void remove_file(const std::filesystem::path& path);

/// Does `work`, which looks at, makes or removes files in `folder`. What the system refuses is an Error (cannot_write).
template <class Work>
void use_folder(const std::filesystem::path& folder, Work&& work);

/// The sentence "cannot write 'path': reason; safe" as an Error (cannot_write). `reason` is a value of errno.
[[noreturn]] void throw_cannot_write(const std::filesystem::path& path, int reason, const std::string& safe = "");

template <class Work>
void use_folder(const std::filesystem::path& folder, Work&& work) {
  try {
    work();
  } catch (const std::filesystem::filesystem_error& error) {
    throw_cannot_write(error.path1().empty() ? folder : error.path1(), error.code().value());
  }
}

}  // namespace talus
