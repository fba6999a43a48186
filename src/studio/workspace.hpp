// SPDX-License-Identifier: MIT
#pragma once
// The folder of the studio: case files with revisions, and the journal of texts that are not saved yet. Every path
// comes from a page and is hostile until it is checked here.

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"

namespace talus::studio {

/// A request that is refused, with its status of HTTP.
class Refusal : public Error {
 public:
  Refusal(int status, const std::string& sentence) : Error(ExitCode::wrong_input, sentence), status_(status) {}
  int status() const { return status_; }

 private:
  int status_;
};

/// Exclusive lock of a file among all processes and threads, from the constructor to the destructor. The file is
/// created; its content does not matter.
class FileLock {
 public:
  /// Waits for the lock. Throws Error (cannot_write).
  explicit FileLock(const std::filesystem::path& file);
  /// Returns false at once if another holder has it.
  static bool try_lock(const std::filesystem::path& file, std::optional<FileLock>& lock);
  FileLock(FileLock&& other) noexcept : file_(std::exchange(other.file_, -1)) {}
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;
  ~FileLock();

 private:
  FileLock() = default;
  int file_ = -1;
};

/// Makes a folder. Throws Error (wrong_input) for a link, which would lead out of the folder of the studio.
void make_own_folder(const std::filesystem::path& folder);

struct RevisedText {
  std::string text;
  std::string revision;  ///< hash of the text
};

/// A text that is not saved.
struct JournalEntry {
  std::string window;  ///< of the page: small letters and digits, at most 32; may be empty
  std::string text;
  std::string base;      ///< text of the file that it grew from
  std::string revision;  ///< of that text
  double time = 0;       ///< when it was stored [s] since 1970
};

struct ListedFile {
  std::string path;  ///< below the folder, with slashes
  std::string revision;
};

class Workspace {
 public:
  /// Opens an existing folder and makes its state folder `.talus-studio`. Throws Error (wrong_input) if there is no
  /// such folder or its state folder is a link, and Error (cannot_write).
  explicit Workspace(const std::filesystem::path& folder);

  const std::filesystem::path& folder() const { return folder_; }
  std::filesystem::path state() const { return folder_ / state_name; }

  /// Returns the case file of a path. Throws Refusal for a path that leaves the folder, is hidden, is a link, has no
  /// existing folder, or does not end with .toml.
  std::filesystem::path find(const std::string& path) const;

  /// Returns the files that end with .toml, without hidden ones, links and folders of results.
  std::vector<ListedFile> list() const;
  /// Throws Refusal (404) if there is no such file.
  RevisedText read(const std::string& path) const;
  /// Writes a text if the file still has `revision`, or does not exist and `revision` is empty. Returns the new
  /// revision; std::nullopt if the file has changed.
  std::optional<std::string> write(const std::string& path, const std::string& text, const std::string& revision) const;

  /// Stores a text that is not saved, for the case that the page or the program ends: one for each window. The path is
  /// empty for a case that was never saved. Throws Refusal for the name of a window that is none.
  void write_journal(const std::string& path, const JournalEntry& entry) const;
  /// Returns the latest 20 texts of a path, the latest first.
  std::vector<JournalEntry> read_journal(const std::string& path) const;
  void remove_journal(const std::string& path, const std::string& window) const;

 private:
  static constexpr const char* state_name = ".talus-studio";
  std::filesystem::path find_journal(const std::string& path, const std::string& window) const;

  std::filesystem::path folder_;
};

}  // namespace talus::studio
