// SPDX-License-Identifier: MIT
#include "base/listed_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <memory>
#include <sstream>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "base/folder_lock.hpp"
#include "base/hash.hpp"
#include "base/user_file.hpp"

namespace talus {
namespace {

namespace fs = std::filesystem;

std::string read_name(const std::string& text) {
  std::string name;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool escapes = text[i] == '\\' && i + 1 < text.size();
    name += !escapes ? text[i] : text[++i] == 'n' ? '\n' : text[i];
  }
  return name;
}

/// Returns true where the file has the listed size and content; a file that grows may be longer.
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

/// Sorts what lies in a folder, list by list.
class Sorting {
 public:
  Sorting(const fs::path& folder, Compared compared) : compared_(compared) {
    found_.folder = folder;
    found_.lists.emplace_back();
    walk({}, {}, read_list(folder));
  }
  SortedFiles take() { return std::move(found_); }

 private:
  /// `inside` is a folder of the one that has the list, `list`; both are relative to the folder that is sorted.
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
  if (!file) throw Error(ExitCode::wrong_input, fmt::format("cannot read '{}'", path.string()));
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
    throw Error(
        ExitCode::wrong_input,
        fmt::format("cannot read '{}': it is no list of the files of a run, or of another version of the program",
                    path.string()));
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
    throw Error(ExitCode::wrong_input,
                fmt::format("'{}' {}: put it back as it was, or calculate again in another folder", path.string(),
                            is_there ? "is not as the run wrote it" : "is missing"));
  }
}

SortedFiles sort_files(const fs::path& folder, Compared compared) {
  return Sorting(folder, compared).take();
}

void remove_own(const SortedFiles& files) {
  std::vector<std::unique_ptr<FolderLock>> locks;  // the caller has that of the folder itself
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
