// SPDX-License-Identifier: MIT
#include "base/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "base/error.hpp"

namespace talus {
namespace {

namespace fs = std::filesystem;

/// A file descriptor that is closed on every way out.
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

/// The rename itself must survive a loss of power too. Some file systems cannot flush a folder; that is no error.
void flush_folder(const fs::path& folder) {
  const Descriptor directory(::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (directory.fd >= 0) ::fsync(directory.fd);
}

[[noreturn]] void give_up(const fs::path& path, int reason, const std::string& safe) {
  std::error_code ignored;
  fs::remove(temporary_name(path), ignored);
  throw_cannot_write(path, reason, safe);
}

}  // namespace

void throw_cannot_write(const fs::path& path, int reason, const std::string& safe) {
  throw Error(ExitCode::cannot_write, fmt::format("cannot write '{}': {}{}{}", path.string(), std::strerror(reason),
                                                  safe.empty() ? "" : "; ", safe));
}

fs::path temporary_name(const fs::path& path) {
  return path.string() + ".part";
}

void make_folder(const fs::path& folder, const std::string& safe) {
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure) throw_cannot_write(folder, failure.value(), safe);
  if (!fs::is_directory(folder, failure)) throw_cannot_write(folder, ENOTDIR, safe);
}

void publish(const fs::path& path, const std::string& safe) {
  const fs::path temporary = temporary_name(path);
  {
    const Descriptor file(::open(temporary.c_str(), O_RDWR | O_CLOEXEC));
    if (file.fd < 0 || ::fsync(file.fd) != 0) give_up(path, errno, safe);
  }
  if (::rename(temporary.c_str(), path.c_str()) != 0) give_up(path, errno, safe);
  flush_folder(path.parent_path());
}

void write_atomically(const fs::path& path, std::span<const std::byte> bytes, const std::string& safe) {
  {
    Descriptor file(::open(temporary_name(path).c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
    if (file.fd < 0) throw_cannot_write(path, errno, safe);
    if (const int reason = write_all(file.fd, bytes)) give_up(path, reason, safe);
    // A full disk may be reported only here (network file systems).
    const int closed = ::close(file.fd);
    file.fd = -1;
    if (closed != 0) give_up(path, errno, safe);
  }
  publish(path, safe);
}

void write_atomically(const fs::path& path, std::string_view text, const std::string& safe) {
  write_atomically(path, std::as_bytes(std::span(text.data(), text.size())), safe);
}

}  // namespace talus
