// SPDX-License-Identifier: MIT
#pragma once
// One run at a time in a folder of results.

#include <deque>
#include <filesystem>
#include <utility>
#include <vector>

namespace talus {

/// Holds a folder for this process from take() to its own end, by a lock (flock) on the file `talus.lock` in it, which
/// also says who holds it. The lock ends with the process, however that ends. Linux hands it on to network file
/// systems. On one that has no locks the file itself is the lock: it is taken over when its process was of this machine
/// and has ended.
class FolderLock {
 public:
  explicit FolderLock(std::filesystem::path folder) : folder_(std::move(folder)) {}
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock();

  /// Makes the folder where it is missing and takes it; nothing when it is held already. Throws Error (folder_exists)
  /// when another process holds it, with its machine, number and time, and Error (cannot_write) when the machine
  /// refuses.
  void take();
  /// The same for a folder that is there and may be written to; nothing else can harm what is in it.
  void take_existing();
  /// Holds a folder that is there for reading, beside others that read it; errors as take().
  void share();

 private:
  void acquire(bool is_shared, int flags);

  std::filesystem::path folder_;
  int file_ = -1;
};

/// Holds a folder of results for a command beside the run: while it is held no run begins in it, and what runs in it,
/// or in the run that it is a part of, is refused as by FolderLock.
class ResultsLock {
 public:
  /// For reading.
  explicit ResultsLock(const std::filesystem::path& folder);
  /// For writing to `parts`, which are folders in it.
  ResultsLock(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& parts);

 private:
  std::deque<FolderLock> locks_;
};

/// The lock's file in a folder, which belongs to no result.
inline constexpr const char* lock_file = "talus.lock";

/// Whether nothing but a lock's file is in a folder that exists.
bool holds_nothing(const std::filesystem::path& folder);

}  // namespace talus
