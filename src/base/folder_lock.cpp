// SPDX-License-Identifier: MIT
#include "base/folder_lock.hpp"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <set>
#include <sstream>
#include <string>
#include <thread>

#include "base/atomic_file.hpp"
#include "base/error.hpp"

namespace talus {
namespace {

namespace fs = std::filesystem;

/// Content of a lock file, one member per line. All members are empty if the process could not write the file.
struct Holder {
  std::string machine, process, since;
};

std::string get_machine() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

Holder read_holder(int file) {
  std::array<char, 1024> text{};
  const ssize_t size = ::pread(file, text.data(), text.size(), 0);
  std::istringstream lines(std::string(text.data(), static_cast<std::size_t>(size > 0 ? size : 0)));
  Holder holder;
  std::getline(lines, holder.machine);
  std::getline(lines, holder.process);
  std::getline(lines, holder.since);
  return holder;
}

void write_holder(int file) {
  const std::string text =
      fmt::format("{}\n{}\n{:%Y-%m-%d %H:%M:%S} UTC\n", get_machine(), ::getpid(), fmt::gmtime(std::time(nullptr)));
  // A full disk is reported by the first write of results; the lock is valid nevertheless.
  if (::ftruncate(file, 0) == 0) static_cast<void>(::pwrite(file, text.data(), text.size(), 0) < 0);
}

/// Returns true if the process that holds a lock may still run, on a file system without locks.
bool may_run(const Holder& holder) {
  if (holder.process.empty()) return false;
  if (holder.machine != get_machine()) return true;
  const pid_t process = static_cast<pid_t>(std::strtol(holder.process.c_str(), nullptr, 10));
  return process > 0 && (::kill(process, 0) == 0 || errno != ESRCH);
}

/// Returns true if the process that took a lock has ended on this machine: a process that it had started, and that ends
/// with it, holds the lock a moment longer.
bool has_ended(const Holder& holder) {
  return !holder.process.empty() && holder.machine == get_machine() && !may_run(holder);
}

[[noreturn]] void refuse(const fs::path& folder, const Holder& holder, bool is_sure) {
  const std::string who = holder.process.empty() ? "another run"
                                                 : fmt::format("process {} on '{}', since {}", holder.process,
                                                               holder.machine, holder.since);
  const std::string then =
      is_sure && (holder.machine.empty() || holder.machine == get_machine())
          ? "wait for its end, or give another folder with -o"
          : fmt::format("wait for its end, or give another folder with -o; if that machine is gone, remove '{}'",
                        (folder / lock_file).string());
  throw Error(ExitCode::folder_exists, "the folder '{}' is in use by {}: {}", folder.string(), who, then);
}

/// Opens the lock file, created if `flags` contain O_CREAT; returns -1 if there is none that can be read. Throws Error
/// (cannot_write) for a symbolic link or a device.
int open_lock(const fs::path& path, int flags) {
  const auto refuse = [&](const char* what) {
    throw Error(ExitCode::cannot_write, "cannot write '{}': it is {}, and a lock is a file of its own; remove it",
                path.string(), what);
  };
  const int file = ::open(path.c_str(), flags | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0666);
  if (file < 0 && errno == ELOOP) refuse("a symbolic link");
  if (file < 0 && (errno == ENOENT || errno == EACCES) && (flags & O_CREAT) == 0) return -1;
  if (file < 0) throw_cannot_write(path, errno);
  struct stat found {};
  if (::fstat(file, &found) == 0 && S_ISREG(found.st_mode) && found.st_nlink <= 1) return file;
  ::close(file);
  refuse(S_ISREG(found.st_mode) ? "a link to another file" : "no file");
  return -1;
}

bool is_writable(const fs::path& folder) {
  std::error_code unknown;
  return fs::is_directory(folder, unknown) && ::access(folder.c_str(), W_OK) == 0;
}

/// Returns true if the path still refers to the open file: the previous holder may have removed it in the meantime.
bool is_same(int file, const fs::path& path) {
  struct stat open {
  }, named{};
  return ::fstat(file, &open) == 0 && ::lstat(path.c_str(), &named) == 0 && open.st_dev == named.st_dev &&
         open.st_ino == named.st_ino;
}

}  // namespace

void FolderLock::acquire(bool is_shared, int flags) {
  constexpr int most_looks = 500;
  constexpr std::chrono::milliseconds look{20};
  const fs::path path = folder_ / lock_file;
  for (int looks = 0;;) {
    const int file = open_lock(path, flags);
    if (file < 0) return;
    const bool is_locked = ::flock(file, (is_shared ? LOCK_SH : LOCK_EX) | LOCK_NB) == 0;
    const bool is_held = !is_locked && errno == EWOULDBLOCK;
    const Holder holder = read_holder(file);
    if (is_held || (!is_locked && may_run(holder))) {
      ::close(file);
      if (is_held && has_ended(holder) && looks++ < most_looks) {
        std::this_thread::sleep_for(look);
        continue;
      }
      refuse(folder_, holder, is_held);
    }
    if (is_same(file, path)) {
      file_ = file;
      if (!is_shared) write_holder(file);
      return;
    }
    ::close(file);
  }
}

void FolderLock::take() {
  if (file_ >= 0) return;
  make_folder(folder_);
  acquire(false, O_RDWR | O_CREAT);
}

void FolderLock::take_existing() {
  if (is_writable(folder_)) take();
}

void FolderLock::share() {
  if (file_ < 0) acquire(true, is_writable(folder_) ? O_RDWR | O_CREAT : O_RDONLY);
}

FolderLock::~FolderLock() {
  if (file_ < 0) return;
  // Removes the file only if no other process holds the lock.
  std::error_code ignored;
  if (::flock(file_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) fs::remove(folder_ / lock_file, ignored);
  ::close(file_);
}

ResultsLock::ResultsLock(const fs::path& folder) {
  // Parts of a run, such as its trials, are locked together with the run, which is the folder with a summary.
  constexpr int deepest_part = 3;
  std::error_code unknown;
  fs::path above = fs::canonical(folder, unknown);
  for (int i = 0; i < deepest_part && above.has_relative_path() && !fs::exists(above / "summary.json", unknown); ++i) {
    above = above.parent_path();
    if (::access((above / lock_file).c_str(), R_OK) == 0) locks_.emplace_back(above).share();
  }
  locks_.emplace_back(folder).share();
}

ResultsLock::ResultsLock(const fs::path& folder, const std::vector<fs::path>& parts) : ResultsLock(folder) {
  locks_.pop_back();
  std::set<fs::path> held{fs::canonical(folder)};
  for (const fs::path& part : parts)
    for (fs::path on_way = fs::canonical(part); held.insert(on_way).second;) on_way = on_way.parent_path();
  for (const fs::path& each : held) locks_.emplace_back(each).take();
}

bool holds_nothing(const fs::path& folder) {
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.path().filename() != lock_file) return false;
  return true;
}

}  // namespace talus
