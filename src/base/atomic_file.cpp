// SPDX-License-Identifier: MIT
#include "base/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <iterator>
#include <vector>

#include "base/error.hpp"
#include "base/file_list.hpp"

namespace talus {
namespace {

namespace fs = std::filesystem;

/// A file descriptor that is closed in the destructor.
struct Descriptor {
  int fd;
  explicit Descriptor(int f) : fd(f) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (fd >= 0) ::close(fd);
  }
};

int write_all(int fd, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(fd, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return errno;
    bytes = bytes.subspan(static_cast<std::size_t>(n));
  }
  return 0;
}

/// Makes the rename durable. Some file systems do not support flushing a folder, which is not an error.
void flush_folder(const fs::path& folder) {
  const Descriptor directory(::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (directory.fd >= 0) ::fsync(directory.fd);
}

[[noreturn]] void give_up(const fs::path& path, int reason, const std::string& safe) {
  clear_temporary(path);
  throw_cannot_write(path, reason, safe);
}

/// Renames the completed temporary file to `path`. A device, a pipe or a socket of this name is not replaced: for the
/// user root even /dev/null would be.
void flush_and_rename(const fs::path& path, const std::string& safe) {
  const fs::path temporary = temporary_name(path);
  std::error_code failure;
  if (const fs::file_status now = fs::symlink_status(path, failure); fs::exists(now) && fs::is_other(now)) {
    clear_temporary(path);
    throw Error(ExitCode::cannot_write, "cannot write '{}': it is a device, a pipe or a socket, not a file",
                path.string());
  }
  {
    const Descriptor file(::open(temporary.c_str(), O_RDWR | O_NOFOLLOW | O_CLOEXEC));
    if (file.fd < 0 || ::fsync(file.fd) != 0) give_up(path, errno, safe);
  }
  if (::rename(temporary.c_str(), path.c_str()) != 0) give_up(path, errno, safe);
  flush_folder(path.parent_path());
  list_whole(path);
}

}  // namespace

void throw_cannot_write(const fs::path& path, int reason, const std::string& safe) {
  throw Error(ExitCode::cannot_write, "cannot write '{}': {}{}{}", path.string(), std::strerror(reason),
              safe.empty() ? "" : "; ", safe);
}

fs::path temporary_name(const fs::path& path) {
  return path.string() + ".part";
}

void clear_temporary(const fs::path& path) {
  static_cast<void>(::unlink(temporary_name(path).c_str()));  // a failure is reported when the file is opened
}

void make_folder(const fs::path& folder, const std::string& safe) {
  std::error_code failure;
  std::vector<fs::path> missing;
  for (fs::path f = folder; !f.empty() && !fs::exists(f, failure); f = f.parent_path()) missing.push_back(f);
  for (auto f = missing.rbegin(); f != missing.rend(); ++f) list_folder(*f);
  fs::create_directories(folder, failure);
  if (failure) throw_cannot_write(folder, failure.value(), safe);
  if (!fs::is_directory(folder, failure)) throw_cannot_write(folder, ENOTDIR, safe);
}

fs::path begin_file(const fs::path& path) {
  list_temporary(path);
  clear_temporary(path);
  return temporary_name(path);
}

void publish(const fs::path& path, const std::string& safe) {
  list_content(path, temporary_name(path));
  flush_and_rename(path, safe);
}

void remove_file(const fs::path& path) {
  std::error_code failure;
  const auto is_there = [&](const fs::path& file) { return fs::exists(fs::symlink_status(file, failure)); };
  const fs::path files[] = {path, temporary_name(path)};
  if (std::none_of(std::begin(files), std::end(files), is_there) || !list_removal(path)) return;
  for (const fs::path& file : files) {
    fs::remove(file, failure);
    if (failure) throw Error(ExitCode::cannot_write, "cannot remove '{}': {}", file.string(), failure.message());
  }
}

void write_atomically(const fs::path& path, std::span<const std::byte> bytes, const std::string& safe) {
  list_content(path, bytes);
  {
    clear_temporary(path);
    Descriptor file(::open(temporary_name(path).c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666));
    if (file.fd < 0) throw_cannot_write(path, errno, safe);
    if (const int reason = write_all(file.fd, bytes)) give_up(path, reason, safe);
    // Network file systems may report a full disk only on close().
    const int closed = ::close(file.fd);
    file.fd = -1;
    if (closed != 0) give_up(path, errno, safe);
  }
  flush_and_rename(path, safe);
}

void write_atomically(const fs::path& path, std::string_view text, const std::string& safe) {
  write_atomically(path, std::as_bytes(std::span(text.data(), text.size())), safe);
}

}  // namespace talus
