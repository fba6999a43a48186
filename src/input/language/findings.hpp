// SPDX-License-Identifier: MIT
#pragma once
// Places of keys in the file, and the faults and warnings found in a case.

#include <fmt/format.h>

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/error.hpp"

namespace talus::input {

/// The place where a key was given: in a file, or by --set (then without line).
struct Place {
  std::string file;
  int line = 0;
  int column = 0;
};

/// The places of all given keys, tables and list entries, by dotted path ("stage.0.duration").
class Places {
 public:
  explicit Places(std::string file = "");

  /// Marks `path` and everything below it as given by --set `written`.
  void mark_override(const std::string& path, const std::string& written);
  void record(const std::string& path, int line, int column);
  bool is_given(const std::string& path) const { return places_.count(path) != 0; }
  /// Returns the place of `path`, or of its nearest given parent.
  Place find(const std::string& path) const;
  /// Returns all given paths.
  std::vector<std::string> list_given() const;
  /// Returns the place of an item at `line` and `column` that belongs to `path`.
  Place locate(const std::string& path, int line, int column) const;

 private:
  std::string file_;
  std::map<std::string, Place> places_;
  std::map<std::string, std::string> overrides_;
};

/// The faults and warnings of a case.
class Findings {
 public:
  explicit Findings(Places& of_file) : places(of_file) {}

  /// Adds a fault of `path`, reported where it was given, or at its table if it is missing.
  void add(const std::string& path, const std::string& sentence);
  /// An empty sentence marks `path` as faulty and reports nothing: the fault is part of another sentence.
  void add_at(const Place& place, const std::string& path, const std::string& sentence);
  /// Formats the sentence as fmt::format() does.
  template <class First, class... Rest>
  void add(const std::string& path, fmt::format_string<First, Rest...> sentence, First&& first, Rest&&... rest) {
    add(path, fmt::format(sentence, std::forward<First>(first), std::forward<Rest>(rest)...));
  }
  /// Adds the fault of a key that does not exist in any case.
  void add_unknown_key(const Place& place, const std::string& path, const std::string& sentence);
  /// Returns true if no fault at, below or above `path` is known, so that it can be checked further.
  bool is_sound(const std::string& path) const;
  /// Adds a warning at the place of `path`: the value is allowed, but probably not intended.
  void warn(const std::string& path, const std::string& sentence);
  template <class First, class... Rest>
  void warn(const std::string& path, fmt::format_string<First, Rest...> sentence, First&& first, Rest&&... rest) {
    warn(path, fmt::format(sentence, std::forward<First>(first), std::forward<Rest>(rest)...));
  }
  /// Returns all faults in the order of the file, followed by those of --set.
  std::vector<Diagnostic> sort() const;
  /// Returns the warnings in the same order, without those at and below the paths `meant`.
  std::vector<Diagnostic> sort_warnings(const std::vector<std::string>& meant) const;
  bool empty() const { return diagnostics_.empty(); }

  Places& places;
  /// Describes the keys and choices of that name in a case: "it is a key of [lem]"; empty if there is none. May be
  /// unset.
  std::function<std::string(const std::string& word)> describe_owners;

 private:
  struct Warning {
    std::string path;
    Diagnostic diagnostic;
  };

  std::vector<Diagnostic> diagnostics_;
  std::vector<Warning> warnings_;
  std::set<std::string> faulty_;
};

/// The findings of one block. Keys are relative to its path.
struct BlockFindings {
  Findings& findings;
  std::string path;  ///< "roots.0"

  BlockFindings(Findings& all, std::string block) : findings(all), path(std::move(block)) {}

  bool is_sound(const std::string& key) const { return findings.is_sound(path + "." + key); }
  bool is_given(const std::string& key) const { return findings.places.is_given(path + "." + key); }
  void report(const std::string& key, const std::string& sentence) const { findings.add(path + "." + key, sentence); }
  template <class First, class... Rest>
  void report(const std::string& key, fmt::format_string<First, Rest...> sentence, First&& first,
              Rest&&... rest) const {
    report(key, fmt::format(sentence, std::forward<First>(first), std::forward<Rest>(rest)...));
  }
};

/// Writes `file:line:column: warning: sentence`, without the place if there is none.
std::string write_warning(const Diagnostic& warning);

}  // namespace talus::input
