// SPDX-License-Identifier: MIT
#include "base/file_list.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <mutex>
#include <optional>
#include <vector>

#include "base/atomic_file.hpp"
#include "base/error.hpp"

namespace talus {

namespace fs = std::filesystem;

/// A list to which this process appends.
struct OpenList {
  fs::path folder;
  int file = -1;
  Listed listed;
  std::mutex mutex;

  explicit OpenList(const fs::path& where) : folder(make_absolute(where)) {
    const fs::path path = folder / list_file;
    file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (file < 0) throw_cannot_write(path, errno);
    try {
      listed = read_list(folder);
      if (!listed.has_header) append_text(std::string(list_header) + "\n", true);
    } catch (...) {
      ::close(file);
      throw;
    }
  }
  OpenList(const OpenList&) = delete;
  OpenList& operator=(const OpenList&) = delete;
  ~OpenList() { ::close(file); }

  /// Appends lines in one go; with `flushes` they survive a loss of power before anything that follows.
  void append(const std::vector<std::string>& lines, bool flushes) {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    append_text(text, flushes);
    for (const std::string& line : lines) listed.add(line);
  }

 private:
  void append_text(std::string text, bool flushes) {
    if (listed.is_cut_off) text.insert(0, "\n");
    listed.is_cut_off = true;
    for (std::size_t done = 0; done < text.size();) {
      const ssize_t n = ::write(file, text.data() + done, text.size() - done);
      if (n < 0 && errno == EINTR) continue;
      if (n < 0) throw_cannot_write(folder / list_file, errno);
      done += static_cast<std::size_t>(n);
    }
    listed.is_cut_off = false;
    // Some file systems cannot flush a file; that is no error.
    if (flushes && ::fdatasync(file) != 0 && errno != EINVAL && errno != ENOSYS)
      throw_cannot_write(folder / list_file, errno);
  }
};

namespace {

/// The lists that this process continues.
struct OpenLists {
  std::mutex mutex;
  std::vector<std::shared_ptr<OpenList>> lists;

  static OpenLists& get() {
    static OpenLists all;
    return all;
  }
};

/// A file in the folder of an open list.
struct Place {
  std::shared_ptr<OpenList> list;
  std::string name;
};

/// The innermost open list whose folder holds `path`.
std::optional<Place> find_place(const fs::path& path) {
  OpenLists& open = OpenLists::get();
  const std::lock_guard lock(open.mutex);
  if (open.lists.empty() || path.filename() == list_file) return std::nullopt;
  const fs::path file = make_absolute(path);
  std::optional<Place> best;
  for (const std::shared_ptr<OpenList>& list : open.lists) {
    const fs::path& folder = list->folder;
    const auto [end, rest] = std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
    if (end != folder.end() || rest == file.end()) continue;
    if (!best || best->list->folder.native().size() < folder.native().size())
      best = {list, file.lexically_relative(folder).generic_string()};
  }
  return best;
}

/// Appends lines on a file, where a list is open for it.
void append(const std::optional<Place>& place, const std::vector<std::string>& words, bool flushes) {
  if (!place) return;
  std::vector<std::string> lines;
  for (const std::string& word : words) lines.push_back(word + " " + write_name(place->name));
  const std::lock_guard lock(place->list->mutex);
  place->list->append(lines, flushes);
}

/// A file that no run wrote is not replaced.
void refuse_foreign(const std::optional<Place>& place, const fs::path& path) {
  if (!place) return;
  const std::lock_guard lock(place->list->mutex);
  const auto it = place->list->listed.files.find(place->name);
  const bool is_listed = it != place->list->listed.files.end();
  const auto check = [](const fs::path& file, bool is_own) {
    std::error_code none;
    const fs::file_status there = fs::symlink_status(file, none);
    if (!is_own && (fs::is_regular_file(there) || fs::is_symlink(there)))
      throw Error(
          ExitCode::folder_exists,
          fmt::format("'{}' was not written by a run and stays; move it away, or give another folder", file.string()));
  };
  check(path, is_listed);
  check(temporary_name(path), is_listed && it->second.is_being_written());
}

std::string write_content(const FileContent& content) {
  return fmt::format("write {} {:016x}", content.size, content.hash);
}

}  // namespace

FileList::FileList(const fs::path& folder) : open_(std::make_shared<OpenList>(folder)) {
  OpenLists& open = OpenLists::get();
  const std::lock_guard lock(open.mutex);
  open.lists.push_back(open_);
}

FileList::~FileList() {
  OpenLists& open = OpenLists::get();
  const std::lock_guard lock(open.mutex);
  std::erase(open.lists, open_);
}

std::unique_ptr<FileList> FileList::find(const fs::path& file) {
  const auto folder = find_listed_folder(file);
  const auto place = find_place(file);
  const bool is_open = place && folder && place->list->folder == *folder;
  return !folder || is_open ? nullptr : std::make_unique<FileList>(*folder);
}

void FileList::add_folder(const std::string& name) {
  {
    const std::lock_guard lock(open_->mutex);
    if (open_->listed.folders.contains(name)) return;
  }
  append(Place{open_, name}, {"folder"}, false);
}

void list_content(const fs::path& path, std::span<const std::byte> bytes) {
  const auto place = find_place(path);
  refuse_foreign(place, path);
  if (place) append(place, {write_content(describe_content(bytes))}, true);
}

void list_content(const fs::path& path, const fs::path& temporary) {
  const auto place = find_place(path);
  refuse_foreign(place, path);
  std::error_code none;
  if (place && fs::exists(temporary, none)) append(place, {write_content(describe_content(temporary))}, true);
}

void list_temporary(const fs::path& path) {
  const auto place = find_place(path);
  refuse_foreign(place, path);
  append(place, {"begin"}, true);
}

void list_whole(const fs::path& path) {
  append(find_place(path), {"whole"}, false);
}

void list_growing(const fs::path& path) {
  append(find_place(path), {"grows"}, false);
}

void list_grown(const fs::path& path, bool still_grows) {
  const auto place = find_place(path);
  if (!place) return;
  std::vector<std::string> words{write_content(describe_content(path)), "whole"};
  if (still_grows) words.emplace_back("grows");
  append(place, words, false);
}

void list_folder(const fs::path& folder) {
  append(find_place(folder), {"folder"}, false);
}

bool list_removal(const fs::path& path) {
  const auto place = find_place(path);
  if (!place) return true;
  {
    const std::lock_guard lock(place->list->mutex);
    if (!place->list->listed.files.contains(place->name)) return false;
  }
  append(place, {"remove"}, false);
  return true;
}

}  // namespace talus
