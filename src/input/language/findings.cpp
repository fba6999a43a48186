// SPDX-License-Identifier: MIT
#include "input/language/findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>

namespace talus::input {
namespace {

/// Returns true if `path` is `parent` or below it: "a.b" is within "a.b" and "a", not within "a.bc".
bool is_within(const std::string& path, const std::string& parent) {
  return parent.empty() || path == parent ||
         (path.size() > parent.size() && path.compare(0, parent.size(), parent) == 0 && path[parent.size()] == '.');
}

/// Returns the first of "", "a", "a.b" … up to the path itself for which `holds` is true; std::nullopt if there is
/// none.
std::optional<std::string> find_parent(const std::string& path, auto&& holds) {
  for (std::size_t end = 0;; end = path.find('.', end + 1)) {
    const std::string parent = path.substr(0, end);
    if (holds(parent)) return parent;
    if (end == std::string::npos || path.empty()) return std::nullopt;
  }
}

void sort_by_place(std::vector<Diagnostic>& list) {
  std::stable_sort(list.begin(), list.end(), [](const Diagnostic& a, const Diagnostic& b) {
    return std::tuple(a.line == 0, a.line, a.column) < std::tuple(b.line == 0, b.line, b.column);
  });
}

}  // namespace

Places::Places(std::string file) : file_(std::move(file)) {
  places_[""] = Place{file_, 1, 1};
}

void Places::mark_override(const std::string& path, const std::string& written) {
  overrides_[path] = written;
}

Place Places::locate(const std::string& path, int line, int column) const {
  const auto parent = find_parent(path, [this](const std::string& p) { return overrides_.contains(p); });
  return parent ? Place{"--set " + overrides_.at(*parent), 0, 0} : Place{file_, line, column};
}

void Places::record(const std::string& path, int line, int column) {
  const Place place = locate(path, line, column);
  // A table created by --set has no place in the file; its faults are reported at its parent.
  if (place.line > 0 || place.file != file_) places_[path] = place;
}

Place Places::find(const std::string& path) const {
  for (std::string at = path;; at = at.substr(0, at.rfind('.'))) {
    if (const auto found = places_.find(at); found != places_.end()) return found->second;
    if (at.find('.') == std::string::npos) return places_.at("");
  }
}

std::vector<std::string> Places::list_given() const {
  std::vector<std::string> paths;
  for (const auto& [path, place] : places_)
    if (!path.empty()) paths.push_back(path);
  return paths;
}

void Findings::add(const std::string& path, const std::string& sentence) {
  add_at(places.find(path), path, sentence);
}

void Findings::add_at(const Place& place, const std::string& path, const std::string& sentence) {
  if (!sentence.empty()) diagnostics_.push_back({place.file, place.line, place.column, sentence});
  faulty_.insert(path);
}

void Findings::add_unknown_key(const Place& place, const std::string& path, const std::string& sentence) {
  add_at(place, path, sentence);
  diagnostics_.back().is_unknown_key = true;
}

bool Findings::is_sound(const std::string& path) const {
  // The set may have tens of thousands of paths and is queried for every key; faults below `path` are adjacent in it.
  if (path.empty()) return faulty_.empty();
  const auto under = faulty_.lower_bound(path + ".");
  if (under != faulty_.end() && is_within(*under, path)) return false;
  return !find_parent(path, [this](const std::string& p) { return !p.empty() && faulty_.contains(p); });
}

void Findings::warn(const std::string& path, const std::string& sentence) {
  const Place place = places.find(path);
  warnings_.push_back({path, {place.file, place.line, place.column, sentence}});
}

std::vector<Diagnostic> Findings::sort() const {
  std::vector<Diagnostic> sorted = diagnostics_;
  sort_by_place(sorted);
  return sorted;
}

std::vector<Diagnostic> Findings::sort_warnings(const std::vector<std::string>& meant) const {
  std::vector<Diagnostic> sorted;
  for (const Warning& warning : warnings_)
    if (is_sound(warning.path) && std::none_of(meant.begin(), meant.end(),
                                               [&](const std::string& path) { return is_within(warning.path, path); }))
      sorted.push_back(warning.diagnostic);
  sort_by_place(sorted);
  return sorted;
}

std::string write_warning(const Diagnostic& warning) {
  const std::string place = warning.line > 0 ? fmt::format("{}:{}:{}: ", warning.file, warning.line, warning.column)
                            : warning.file.empty() ? ""
                                                   : warning.file + ": ";
  return fmt::format("{}warning: {}", place, warning.sentence);
}

}  // namespace talus::input
