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
#include "base/text.hpp"

#ifdef __linux__
#include <sys/vfs.h>
#endif

namespace talus {
namespace {

namespace fs = std::filesystem;

/// A file opened for reading.
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

/// Returns true for entries of /proc and /sys: stat() reports them as regular files, but without a size, and some are
/// endless.
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
  if (auto fault = find_kind_fault(file))
    return fault;  // before open(), because opening a device may have side effects
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
  if (const auto fault = try_user_file(path, most, text)) fail_input("cannot read '{}': {}", path.string(), fault->why);
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
              "this process may open {} files at a time, and needs more; raise the limit (ulimit -n)",
              get_file_limit());
}

}  // namespace talus

namespace talus {

namespace {

/// File endings and folder names that the program uses, beside names from cases.
constexpr std::array<std::string_view, 15> own_endings{".csv",   ".files", ".gp",     ".h5",   ".html",
                                                       ".json",  ".lock",  ".md",     ".part", ".png",
                                                       ".slurm", ".svg",   ".vtkhdf", ".vtu",  ".xdmf"};
constexpr std::array<std::string_view, 11> own_folders{"calibration",    "case",     "coarser_mesh", "frames",
                                                       "frozen",         "jobs",     "point",        "released_earlier",
                                                       "released_later", "sections", "trials"};
constexpr std::array<std::string_view, 4> devices{"aux", "con", "nul", "prn"};
constexpr std::string_view reductions = "elements_";

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool is_device(std::string_view stem) {
  if (stem.size() == 4 && is_digit(stem[3])) return stem.starts_with("com") || stem.starts_with("lpt");
  return std::find(devices.begin(), devices.end(), stem) != devices.end();
}

}  // namespace

std::string find_name_fault(std::string_view name) {
  if (name.empty()) return "it is empty";
  if (name == "." || name == "..") return "it is a folder itself";
  if (name.find('/') != std::string_view::npos) return "it holds '/'";
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
  if (std::any_of(name.begin(), name.end(), is_control)) return "it holds a control character";
  if (name.size() > longest_file_name)
    return fmt::format("it has {} bytes, and a name has at most {}", name.size(), longest_file_name);
  return "";
}

bool is_reserved_name(std::string_view name) {
  const std::string lower = to_lower(name);
  if (is_device(lower.substr(0, lower.find('.')))) return true;
  if (lower.size() > reductions.size() && lower.starts_with(reductions) &&
      std::all_of(lower.begin() + reductions.size(), lower.end(), is_digit))
    return true;
  return std::find(own_folders.begin(), own_folders.end(), lower) != own_folders.end() ||
         std::any_of(own_endings.begin(), own_endings.end(),
                     [&](std::string_view ending) { return lower.ends_with(ending); });
}

fs::path join_name(const fs::path& folder, std::string_view name, std::string_view ending) {
  if (const std::string fault = find_name_fault(name); !fault.empty())
    fail_input("'{}' cannot be a name in the folder '{}': {}", make_printable(name), folder.string(), fault);
  return folder / (std::string(name) + std::string(ending));
}

fs::path join_path(const fs::path& folder, std::string_view path) {
  const fs::path parts(path);
  if (parts.empty()) return join_name(folder, path);
  fs::path joined = folder;
  for (const fs::path& part : parts) joined = join_name(joined, part.string());
  return joined;
}

std::string make_file_name(std::string_view text, std::string_view if_empty, std::size_t longest) {
  std::string name;
  for (const char c : text) {
    if (is_letter(c) || is_digit(c) || std::string_view("_.+-").find(c) != std::string_view::npos)
      name += c;
    else if (!name.empty() && name.back() != '_')
      name += '_';
  }
  name.erase(0, std::min(name.find_first_not_of("._"), name.size()));
  name.resize(std::min(name.size(), longest));
  name.resize(name.find_last_not_of("._") + 1);
  if (name.empty()) name = if_empty;
  return is_reserved_name(name) ? name + "_" : name;
}

std::string take_file_name(std::string_view text, std::string_view if_empty, std::set<std::string>& taken) {
  const std::string name = make_file_name(text, if_empty);
  std::string free = name;
  for (int i = 2; !taken.insert(free).second; ++i) free = fmt::format("{}_{}", name, i);
  return free;
}

}  // namespace talus
