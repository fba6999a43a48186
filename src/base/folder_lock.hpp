// SPDX-License-Identifier: MIT
#pragma once
// Locks that admit one run at a time to a folder of results.

#include <deque>
#include <filesystem>
#include <utility>
#include <vector>

namespace talus {

/// Locks a folder for this process from take() to the destructor, by flock() on the file `talus.lock` in it, which also
/// contains the holder. The lock ends with the process in any case. Linux forwards it to network file systems. On file
/// systems without locks the existence of the file is the lock: it is taken over if its process ran on this machine and
/// has ended.
class FolderLock {
 public:
  explicit FolderLock(std::filesystem::path folder) : folder_(std::move(folder)) {}
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock();

  /// Makes the folder if it is missing and locks it; no effect if it is already locked by this object. Throws Error
  /// (folder_exists) with machine, process and time if another process holds it, and Error (cannot_write) if the system
  /// refuses.
  void take();
  /// Locks an existing, writable folder; other folders are not at risk and are not locked.
  void take_existing();
  /// Takes a shared lock of an existing folder for reading; errors as take().
  void share();

 private:
  void acquire(bool is_shared, int flags);

  std::filesystem::path folder_;
  int file_ = -1;
};

/// Locks a folder of results for a command other than a run: while it is held, no run can start in the folder; a run in
/// it, or in the run of which it is a part, is reported as by FolderLock.
class ResultsLock {
 public:
  /// Locks for reading.
  explicit ResultsLock(const std::filesystem::path& folder);
  /// Locks for writing to `parts`, which are folders in it.
  ResultsLock(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& parts);

 private:
  std::deque<FolderLock> locks_;
};

/// Name of the lock file, which is not a result.
inline constexpr const char* lock_file = "talus.lock";

/// Returns true if an existing folder has no entry but a lock file.
bool holds_nothing(const std::filesystem::path& folder);

}  // namespace talus
