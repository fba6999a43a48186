// SPDX-License-Identifier: MIT
#include "base/user_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "base/error.hpp"

#ifdef __linux__
#include <sys/vfs.h>
#endif

namespace talus {
namespace {

namespace fs = std::filesystem;

/// A file that is open for reading.
class OpenFile {
 public:
  OpenFile() = default;
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  ~OpenFile() {
    if (file_ >= 0) ::close(file_);
  }

  std::optional<FileFault> open(const fs::path& path, std::uint64_t most);
  std::optional<FileFault> read(std::uint64_t most, std::string& text) const;

 private:
  int file_ = -1;
  std::uint64_t size_ = 0;
};

std::string write_size(std::uint64_t bytes) {
  const double megabytes = static_cast<double>(bytes) / largest_file::megabyte;
  return bytes < largest_file::megabyte ? fmt::format("{} bytes", bytes) : fmt::format("{:.4g} MB", megabytes);
}

FileFault describe_reason(int reason) {
  refuse_full_file_table(reason);
  return {std::strerror(reason), reason == ENOENT || reason == ENOTDIR};
}

std::optional<FileFault> find_kind_fault(const struct stat& file) {
  if (S_ISREG(file.st_mode)) return std::nullopt;
  if (S_ISDIR(file.st_mode)) return FileFault{"it is a folder, not a file"};
  if (S_ISFIFO(file.st_mode)) return FileFault{"it is a pipe, not a file"};
  if (S_ISSOCK(file.st_mode)) return FileFault{"it is a socket, not a file"};
  return FileFault{"it is a device, not a file"};
}

/// Entries of /proc and /sys are regular files to stat(), without a size and maybe without an end.
bool is_of_kernel([[maybe_unused]] int file) {
#ifdef __linux__
  constexpr std::array<long, 4> kernel{0x9fa0, 0x62656572, 0x64626720, 0x74726163};  // proc, sysfs, debugfs, tracefs
  struct statfs system {};
  return ::fstatfs(file, &system) == 0 && std::ranges::find(kernel, static_cast<long>(system.f_type)) != kernel.end();
#else
  return false;
#endif
}

rlim_t get_file_limit() {
  rlimit files{};
  return getrlimit(RLIMIT_NOFILE, &files) == 0 ? files.rlim_cur : RLIM_INFINITY;
}

FileFault describe_size(std::uint64_t size, std::uint64_t most) {
  return {fmt::format("it has {}, and at most {} are read", write_size(size), write_size(most))};
}

std::optional<FileFault> OpenFile::open(const fs::path& path, std::uint64_t most) {
  if (path.native().find('\0') != std::string::npos) return FileFault{"its name holds a zero byte"};
  struct stat file {};
  if (::stat(path.c_str(), &file) != 0) return describe_reason(errno);
  if (auto fault = find_kind_fault(file)) return fault;  // opening a device may already do something
  file_ = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  if (file_ < 0 || ::fstat(file_, &file) != 0) return describe_reason(errno);
  if (auto fault = find_kind_fault(file)) return fault;
  if (is_of_kernel(file_)) return FileFault{"it is an entry of the system, not a file on a disk"};
  size_ = static_cast<std::uint64_t>(file.st_size);
  if (size_ > most) return describe_size(size_, most);
  return std::nullopt;
}

std::optional<FileFault> OpenFile::read(std::uint64_t most, std::string& text) const {
  constexpr std::size_t portion = 1 << 20;
  text.clear();
  text.reserve(size_);
  std::string bytes(std::min<std::size_t>(portion, size_ + 1), '\0');
  for (;;) {
    const ssize_t n = ::read(file_, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return describe_reason(errno);
    if (n == 0) return std::nullopt;
    text.append(bytes.data(), static_cast<std::size_t>(n));
    if (text.size() > most) return describe_size(text.size(), most);
  }
}

}  // namespace

std::optional<FileFault> find_file_fault(const fs::path& path, std::uint64_t most) {
  OpenFile file;
  return file.open(path, most);
}

std::optional<FileFault> try_user_file(const fs::path& path, std::uint64_t most, std::string& text) {
  OpenFile file;
  if (auto fault = file.open(path, most)) return fault;
  return file.read(most, text);
}

std::string read_user_file(const fs::path& path, std::uint64_t most) {
  std::string text;
  if (const auto fault = try_user_file(path, most, text))
    throw Error(ExitCode::wrong_input, fmt::format("cannot read '{}': {}", path.string(), fault->why));
  return text;
}

void require_open_files() {
  constexpr rlim_t least = 32;
  if (get_file_limit() < least) refuse_full_file_table(EMFILE);
}

void refuse_full_file_table(int reason) {
  if (reason == ENFILE) throw Error(ExitCode::no_memory, "the machine opens no more files");
  if (reason != EMFILE) return;
  throw Error(ExitCode::no_memory,
              fmt::format("this process may open {} files at a time, and needs more; raise the limit (ulimit -n)",
                          get_file_limit()));
}

}  // namespace talus
