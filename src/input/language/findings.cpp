// SPDX-License-Identifier: MIT
#include "input/language/findings.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace talus::input {
namespace {

/// "a.b" is within "a.b" and "a", not within "a.bc".
bool is_within(const std::string& path, const std::string& parent) {
  return parent.empty() || path == parent ||
         (path.size() > parent.size() && path.compare(0, parent.size(), parent) == 0 && path[parent.size()] == '.');
}

}  // namespace

Places::Places(std::string file) : file_(std::move(file)) {
  places_[""] = Place{file_, 1, 1};
}

void Places::mark_override(const std::string& path, const std::string& written) {
  overrides_[path] = written;
}

Place Places::locate(const std::string& path, int line, int column) const {
  for (const auto& [parent, written] : overrides_)
    if (is_within(path, parent)) return {"--set " + written, 0, 0};
  return {file_, line, column};
}

void Places::record(const std::string& path, int line, int column) {
  const Place place = locate(path, line, column);
  // A table that --set had to create has no place in the file; its faults are reported at its parent.
  if (place.line > 0 || place.file != file_) places_[path] = place;
}

Place Places::find(const std::string& path) const {
  for (std::string at = path;; at = at.substr(0, at.rfind('.'))) {
    if (const auto found = places_.find(at); found != places_.end()) return found->second;
    if (at.find('.') == std::string::npos) return places_.at("");
  }
}

void Findings::add(const std::string& path, const std::string& sentence) {
  add_at(places.find(path), path, sentence);
}

void Findings::add_at(const Place& place, const std::string& path, const std::string& sentence) {
  diagnostics_.push_back({place.file, place.line, place.column, sentence});
  faulty_.insert(path);
}

bool Findings::is_sound(const std::string& path) const {
  return std::none_of(faulty_.begin(), faulty_.end(), [&](const std::string& faulty) {
    return is_within(faulty, path) || (!faulty.empty() && is_within(path, faulty));
  });
}

std::vector<Diagnostic> Findings::sort() const {
  std::vector<Diagnostic> sorted = diagnostics_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Diagnostic& a, const Diagnostic& b) {
    return std::tuple(a.line == 0, a.line, a.column) < std::tuple(b.line == 0, b.line, b.column);
  });
  return sorted;
}

}  // namespace talus::input
