// SPDX-License-Identifier: MIT
#include "studio/workspace.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <nlohmann/json.hpp>

#include "base/atomic_file.hpp"
#include "base/hash.hpp"
#include "base/text.hpp"
#include "base/user_file.hpp"

namespace talus::studio {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::string_view ending = ".toml";

int open_lock(const fs::path& file) {
  const int opened = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600);
  if (opened < 0) throw_cannot_write(file, errno);
  return opened;
}

bool is_hidden(const std::string& name) {
  return name.starts_with('.');
}

bool is_within(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

RevisedText read_text(const fs::path& file) {
  RevisedText read;
  if (const auto fault = try_user_file(file, largest_file::case_file, read.text))
    throw Refusal(fault->is_missing ? 404 : 403,
                  fmt::format("'{}' cannot be read: {}", file.filename().string(), fault->why));
  read.revision = hash_text(read.text);
  return read;
}

}  // namespace

void make_own_folder(const fs::path& folder) {
  if (fs::is_symlink(folder)) fail_input("'{}' is a link; the studio writes to folders only", folder.string());
  make_folder(folder);
}

FileLock::FileLock(const fs::path& file) : file_(open_lock(file)) {
  while (flock(file_, LOCK_EX) != 0)
    if (errno != EINTR) {
      const int reason = errno;
      close(file_);
      throw_cannot_write(file, reason);
    }
}

bool FileLock::try_lock(const fs::path& file, std::optional<FileLock>& lock) {
  FileLock taken;
  taken.file_ = open_lock(file);
  if (flock(taken.file_, LOCK_EX | LOCK_NB) != 0) return false;
  lock.emplace(std::move(taken));
  return true;
}

FileLock::~FileLock() {
  if (file_ >= 0) close(file_);
}

Workspace::Workspace(const fs::path& folder) {
  std::error_code failure;
  folder_ = fs::canonical(folder, failure);
  if (failure || !fs::is_directory(folder_)) fail_input("there is no folder '{}'", folder.string());
  make_own_folder(state());
  make_own_folder(state() / "journal");
  make_own_folder(state() / "runs");
}

fs::path Workspace::find(const std::string& path) const {
  constexpr std::size_t longest = 1000, most_parts = 32;
  const auto refuse = [&](int status, const char* why) {
    throw Refusal(status, fmt::format("'{}' is no case file of this folder: {}", make_printable(path), why));
  };
  if (path.size() > longest) throw Refusal(400, "the path is too long");
  const fs::path parts(path);
  if (static_cast<std::size_t>(std::distance(parts.begin(), parts.end())) > most_parts) refuse(400, "too many folders");
  for (const fs::path& part : parts) {
    if (const std::string fault = find_name_fault(part.string()); !fault.empty())
      throw Refusal(403, fmt::format("'{}' is no path within the folder: {}", make_printable(path), fault));
    if (is_hidden(part.string())) refuse(403, "hidden files are not shown");
  }
  if (!path.ends_with(ending)) refuse(403, "its name does not end with .toml");
  if (find_wrong_utf8(path)) refuse(403, "its name is not UTF-8");
  std::error_code failure;
  fs::path file = folder_ / parts;
  const fs::path parent = fs::canonical(file.parent_path(), failure);
  if (failure || !fs::is_directory(parent)) refuse(404, "its folder does not exist");
  if (!is_within(parent, folder_) || parent != file.parent_path()) refuse(403, "a link leads to it");
  const fs::file_status status = fs::symlink_status(file, failure);
  if (fs::exists(status) && !fs::is_regular_file(status)) refuse(403, "it is not a regular file");
  return file;
}

std::vector<ListedFile> Workspace::list() const {
  constexpr std::size_t most_files = 2000, most_entries = 20'000;
  constexpr int deepest = 6;
  std::vector<ListedFile> files;
  std::error_code failure;
  fs::recursive_directory_iterator entry(folder_, fs::directory_options::skip_permission_denied, failure);
  std::size_t seen = 0;
  for (; !failure && entry != fs::recursive_directory_iterator(); entry.increment(failure)) {
    if (++seen > most_entries || files.size() == most_files) break;
    const fs::path& path = entry->path();
    const std::string name = path.filename().string();
    std::error_code ignored;
    if (entry->is_symlink(ignored)) continue;
    if (entry->is_directory(ignored)) {
      if (is_hidden(name) || name == "node_modules" || entry.depth() >= deepest ||
          fs::exists(path / "summary.json", ignored))
        entry.disable_recursion_pending();
      continue;
    }
    if (!name.ends_with(ending) || is_hidden(name) || !entry->is_regular_file(ignored)) continue;
    const std::string shown = fs::relative(path, folder_, ignored).generic_string();
    if (find_wrong_utf8(shown)) continue;
    std::string text;
    if (!try_user_file(path, largest_file::case_file, text)) files.push_back({shown, hash_text(text)});
  }
  std::sort(files.begin(), files.end(), [](const ListedFile& a, const ListedFile& b) { return a.path < b.path; });
  return files;
}

RevisedText Workspace::read(const std::string& path) const {
  return read_text(find(path));
}

std::optional<std::string> Workspace::write(const std::string& path, const std::string& text,
                                            const std::string& revision) const {
  const fs::path file = find(path);
  if (text.size() > largest_file::case_file) throw Refusal(413, "the text is larger than a case file may be");
  const FileLock lock(state() / "files.lock");
  std::string now;
  if (fs::exists(file)) now = read_text(file).revision;
  if (now != revision) return std::nullopt;
  write_atomically(file, text);
  for (const JournalEntry& entry : read_journal(path))
    if (entry.text == text) remove_journal(path, entry.window);
  return hash_text(text);
}

fs::path Workspace::find_journal(const std::string& path, const std::string& window) const {
  constexpr std::size_t longest = 32;
  const auto is_plain = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'); };
  if (window.size() > longest || !std::all_of(window.begin(), window.end(), is_plain))
    throw Refusal(400, "the name of a window has small letters and digits only");
  if (!path.empty()) find(path);
  return state() / "journal" / (hash_text(path) + (window.empty() ? "" : "-" + window) + ".json");
}

void Workspace::write_journal(const std::string& path, const JournalEntry& entry) const {
  const fs::path file = find_journal(path, entry.window);
  if (std::max(entry.text.size(), entry.base.size()) > largest_file::case_file)
    throw Refusal(413, "the text is larger than a case file may be");
  const FileLock lock(state() / "journal.lock");
  const json written{{"path", path},       {"window", entry.window},     {"text", entry.text},
                     {"base", entry.base}, {"revision", entry.revision}, {"time", entry.time}};
  write_atomically(file, written.dump(-1, ' ', false, json::error_handler_t::replace));
}

std::vector<JournalEntry> Workspace::read_journal(const std::string& path) const {
  constexpr std::size_t most_entries = 20;
  const std::string stem = find_journal(path, "").stem().string();
  std::vector<std::pair<fs::file_time_type, fs::path>> files;
  std::error_code failure;
  for (const fs::directory_entry& file : fs::directory_iterator(state() / "journal", failure)) {
    const std::string name = file.path().filename().string();
    if (name == stem + ".json" || name.starts_with(stem + "-")) {
      const auto time = file.last_write_time(failure);
      if (!failure) files.emplace_back(time, file.path());
    }
  }
  std::sort(files.rbegin(), files.rend());
  std::vector<JournalEntry> entries;
  for (const auto& [time, file] : files) {
    if (entries.size() == most_entries) break;
    std::string text;
    // Control characters take six bytes each in JSON.
    if (try_user_file(file, 12 * largest_file::case_file, text)) continue;
    const json read = json::parse(text, nullptr, false);
    const auto get = [&](const char* key) {
      const auto found = read.find(key);
      return found != read.end() && found->is_string() ? found->get<std::string>() : "";
    };
    if (!read.is_object() || get("path") != path || !read.contains("text")) continue;
    const auto stored = read.find("time");
    entries.push_back({get("window"), get("text"), get("base"), get("revision"),
                       stored != read.end() && stored->is_number() ? stored->get<double>() : 0});
  }
  // The file system may give several files one time.
  std::stable_sort(entries.begin(), entries.end(),
                   [](const JournalEntry& a, const JournalEntry& b) { return a.time > b.time; });
  return entries;
}

void Workspace::remove_journal(const std::string& path, const std::string& window) const {
  const fs::path file = find_journal(path, window);
  const FileLock lock(state() / "journal.lock");
  remove_file(file);
}

}  // namespace talus::studio
