// SPDX-License-Identifier: MIT
#include "base/file_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/encoding.hpp"
#include "base/error.hpp"

namespace talus {
namespace {

namespace fs = std::filesystem;

/// Endings of files that the program writes, and folders that it makes, beside those that cases name.
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
  return std::ranges::find(devices, stem) != devices.end();
}

}  // namespace

std::string find_name_fault(std::string_view name) {
  if (name.empty()) return "it is empty";
  if (name == "." || name == "..") return "it is a folder itself";
  if (name.find('/') != std::string_view::npos) return "it holds '/'";
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
  if (std::ranges::any_of(name, is_control)) return "it holds a control character";
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
  return std::ranges::find(own_folders, lower) != own_folders.end() ||
         std::ranges::any_of(own_endings, [&](std::string_view ending) { return lower.ends_with(ending); });
}

fs::path join_name(const fs::path& folder, std::string_view name, std::string_view ending) {
  if (const std::string fault = find_name_fault(name); !fault.empty())
    throw Error(ExitCode::wrong_input, fmt::format("'{}' cannot be a name in the folder '{}': {}", make_printable(name),
                                                   folder.string(), fault));
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
