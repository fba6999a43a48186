// SPDX-License-Identifier: MIT
#include "base/file_list.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <fstream>
#include <memory>
#include <mutex>
#include <optional>
#include <sstream>
#include <vector>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "base/folder_lock.hpp"
#include "base/hash.hpp"
#include "base/user_file.hpp"

namespace talus {

namespace fs = std::filesystem;

/// An open list file to which this process appends.
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

  /// Appends lines in one write; with `flushes` they are on the disk before any later write.
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
    // Some file systems do not support flushing a file, which is not an error.
    if (flushes && ::fdatasync(file) != 0 && errno != EINVAL && errno != ENOSYS)
      throw_cannot_write(folder / list_file, errno);
  }
};

namespace {

/// The open lists of this process.
struct OpenLists {
  std::mutex mutex;
  std::vector<std::shared_ptr<OpenList>> lists;

  static OpenLists& get() {
    static OpenLists all;
    return all;
  }
};

/// A file name relative to the folder of an open list.
struct Place {
  std::shared_ptr<OpenList> list;
  std::string name;
};

/// Returns the innermost open list whose folder contains `path`.
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

/// Appends one line per word about a file, if it belongs to an open list.
void append(const std::optional<Place>& place, const std::vector<std::string>& words, bool flushes) {
  if (!place) return;
  std::vector<std::string> lines;
  for (const std::string& word : words) lines.push_back(word + " " + write_name(place->name));
  const std::lock_guard lock(place->list->mutex);
  place->list->append(lines, flushes);
}

/// Throws Error (folder_exists) if a file that no run wrote would be replaced.
void refuse_foreign(const std::optional<Place>& place, const fs::path& path) {
  if (!place) return;
  const std::lock_guard lock(place->list->mutex);
  const auto it = place->list->listed.files.find(place->name);
  const bool is_listed = it != place->list->listed.files.end();
  const auto check = [](const fs::path& file, bool is_own) {
    std::error_code none;
    const fs::file_status there = fs::symlink_status(file, none);
    if (!is_own && (fs::is_regular_file(there) || fs::is_symlink(there)))
      throw Error(ExitCode::folder_exists,
                  "'{}' was not written by a run and stays; move it away, or give another folder", file.string());
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

namespace {

std::string read_name(const std::string& text) {
  std::string name;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool escapes = text[i] == '\\' && i + 1 < text.size();
    name += !escapes ? text[i] : text[++i] == 'n' ? '\n' : text[i];
  }
  return name;
}

/// Returns true if the file has the listed size and content; a growing file may be longer.
bool is_as_listed(const fs::path& path, const ListedFile& listed, Compared compared) {
  std::error_code none;
  if (!fs::is_regular_file(fs::symlink_status(path, none))) return false;
  const std::uint64_t size = fs::file_size(path, none);
  for (const auto& content : {listed.planned, listed.whole}) {
    if (!content || (listed.grows ? size < content->size : size != content->size)) continue;
    if (compared == Compared::sizes || describe_content(path, content->size) == *content) return true;
  }
  return false;
}

/// Classifies the files below a folder, one list at a time.
class Sorting {
 public:
  Sorting(const fs::path& folder, Compared compared) : compared_(compared) {
    found_.folder = folder;
    found_.lists.emplace_back();
    walk({}, {}, read_list(folder));
  }
  SortedFiles take() { return std::move(found_); }

 private:
  /// `inside` is a folder below `list`, the folder whose list applies; both are relative to the sorted folder.
  void walk(const fs::path& inside, const fs::path& list, const Listed& listed) {
    std::vector<fs::directory_entry> entries;
    for (const auto& entry : fs::directory_iterator(found_.folder / inside)) entries.push_back(entry);
    std::sort(entries.begin(), entries.end());
    for (const fs::directory_entry& entry : entries) {
      const fs::path path = inside / entry.path().filename();
      const std::string name = list.empty() ? path.generic_string() : path.lexically_relative(list).generic_string();
      if (!fs::is_directory(entry.symlink_status())) {
        sort_file(path, name, listed);
      } else if (!listed.folders.contains(name)) {
        walk(path, list, listed);
      } else {
        found_.folders.push_back(path);
        if (!has_list(entry.path())) {
          walk(path, list, listed);
        } else {
          found_.lists.push_back(path);
          walk(path, path, read_list(entry.path()));
        }
      }
    }
  }

  void sort_file(const fs::path& path, const std::string& name, const Listed& listed) {
    if (name == list_file || name == lock_file) return;
    const auto it = listed.files.find(name);
    const bool is_own = (it != listed.files.end() && is_as_listed(found_.folder / path, it->second, compared_)) ||
                        is_temporary(name, listed);
    (is_own ? found_.own : found_.foreign).push_back(path);
  }

  static bool is_temporary(const std::string& name, const Listed& listed) {
    const std::string end = temporary_name("").string();
    if (!name.ends_with(end)) return false;
    const std::string file = name.substr(0, name.size() - end.size());
    const auto it = listed.files.find(file);
    return file == list_file || (it != listed.files.end() && (it->second.is_being_written()));
  }

  Compared compared_;
  SortedFiles found_;
};

}  // namespace

FileContent describe_content(std::span<const std::byte> bytes) {
  ContentHash hash;
  hash.add(bytes);
  return {bytes.size(), hash.value()};
}

FileContent describe_content(const fs::path& path, std::uint64_t most) {
  std::ifstream file(path, std::ios::binary);
  if (!file) fail_input("cannot read '{}'", path.string());
  constexpr std::uint64_t piece = 1 << 20;
  std::vector<char> bytes(piece);
  ContentHash hash;
  FileContent content;
  while (content.size < most && file) {
    file.read(bytes.data(), static_cast<std::streamsize>(std::min(piece, most - content.size)));
    const auto count = static_cast<std::size_t>(file.gcount());
    hash.add(std::as_bytes(std::span(bytes.data(), count)));
    content.size += count;
  }
  content.hash = hash.value();
  return content;
}

std::string write_name(const std::string& name) {
  std::string text;
  for (const char c : name) text += c == '\\' ? "\\\\" : c == '\n' ? "\\n" : std::string(1, c);
  return text;
}

void Listed::add(const std::string& line) {
  std::istringstream text(line);
  std::string word, size, hash, name;
  text >> word;
  if (word == "write") text >> size >> hash;
  text.get();
  std::getline(text, name);
  name = read_name(name);
  if (name.empty()) return;
  if (word == "folder") {
    folders.insert(name);
    return;
  }
  ListedFile& file = files[name];
  if (word == "write") {
    FileContent content;
    const auto read = [](const std::string& digits, std::uint64_t& value, int base) {
      const char* end = digits.data() + digits.size();
      return std::from_chars(digits.data(), end, value, base).ptr == end;
    };
    if (!read(size, content.size, 10) || !read(hash, content.hash, 16)) return;
    file.planned = content;
    file.removed = false;
  } else if (word == "begin") {
    file.has_temporary = true;
    file.removed = false;
  } else if (word == "whole") {
    if (file.planned) file.whole = file.planned;
    file = {file.whole, {}, false, false, false};
  } else if (word == "grows") {
    file.grows = true;
  } else if (word == "remove") {
    file.removed = true;
  }
}

Listed read_list(const fs::path& folder) {
  const fs::path path = folder / list_file;
  const std::string text = read_user_file(path, largest_file::result);
  Listed listed;
  listed.has_header = !text.empty();
  listed.is_cut_off = !text.empty() && text.back() != '\n';
  std::istringstream lines(text.substr(0, text.rfind('\n') + 1));
  std::string line;
  if (listed.has_header && (!std::getline(lines, line) || line != list_header))
    fail_input("cannot read '{}': it is no list of the files of a run, or of another version of the program",
               path.string());
  while (std::getline(lines, line)) listed.add(line);
  return listed;
}

fs::path make_absolute(const fs::path& path) {
  const fs::path normal = fs::absolute(path).lexically_normal();
  return normal.has_filename() ? normal : normal.parent_path();
}

bool has_list(const fs::path& folder) {
  std::error_code none;
  return fs::is_regular_file(fs::symlink_status(folder / list_file, none));
}

std::optional<fs::path> find_listed_folder(const fs::path& file) {
  for (fs::path folder = make_absolute(file).parent_path();; folder = folder.parent_path()) {
    if (has_list(folder)) return folder;
    if (!folder.has_relative_path()) return std::nullopt;
  }
}

void check_listed(const fs::path& folder, const std::function<bool(const std::string&)>& is_needed) {
  for (const auto& [name, file] : read_list(folder).files) {
    if (file.removed || !file.whole || !is_needed(name)) continue;
    std::error_code none;
    const fs::path path = folder / name;
    const bool is_there = fs::exists(fs::symlink_status(path, none));
    if (is_there && is_as_listed(path, file, Compared::contents)) continue;
    fail_input("'{}' {}: put it back as it was, or calculate again in another folder", path.string(),
               is_there ? "is not as the run wrote it" : "is missing");
  }
}

SortedFiles sort_files(const fs::path& folder, Compared compared) {
  return Sorting(folder, compared).take();
}

void remove_own(const SortedFiles& files) {
  std::vector<std::unique_ptr<FolderLock>> locks;  // the caller holds the lock of the folder itself
  for (std::size_t i = 1; i < files.lists.size(); ++i) {
    locks.push_back(std::make_unique<FolderLock>(files.folder / files.lists[i]));
    locks.back()->take_existing();
  }
  for (const fs::path& file : files.own) fs::remove(files.folder / file);
  for (std::size_t i = 1; i < files.lists.size(); ++i) fs::remove(files.folder / files.lists[i] / list_file);
  write_atomically(files.folder / list_file, std::string(list_header) + "\n");
  locks.clear();
  std::error_code is_not_empty;
  for (auto folder = files.folders.rbegin(); folder != files.folders.rend(); ++folder)
    fs::remove(files.folder / *folder, is_not_empty);
}

}  // namespace talus
