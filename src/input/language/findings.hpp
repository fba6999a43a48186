// SPDX-License-Identifier: MIT
#pragma once
// Where in the file each key stands, and what is wrong or odd about it.

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/error.hpp"

namespace talus::input {

/// Where a key was given: in a file, or by --set (then without line).
struct Place {
  std::string file;
  int line = 0;
  int column = 0;
};

/// The places of all keys, tables and list entries that were given, by dotted path ("stage.0.duration").
class Places {
 public:
  explicit Places(std::string file = "");

  /// Everything at and under `path` came from --set `written`, whatever its position in that text is.
  void mark_override(const std::string& path, const std::string& written);
  void record(const std::string& path, int line, int column);
  bool is_given(const std::string& path) const { return places_.count(path) != 0; }
  /// The place of `path`, or of its nearest parent that was given.
  Place find(const std::string& path) const;
  /// Every path that was given.
  std::vector<std::string> list_given() const;
  /// The place of something at `line` and `column` that belongs to `path`.
  Place locate(const std::string& path, int line, int column) const;

 private:
  std::string file_;
  std::map<std::string, Place> places_;
  std::map<std::string, std::string> overrides_;
};

/// The faults found so far.
class Findings {
 public:
  explicit Findings(Places& of_file) : places(of_file) {}

  /// A fault of `path`, reported where it was given, or at its table when it is missing.
  void add(const std::string& path, const std::string& sentence);
  void add_at(const Place& place, const std::string& path, const std::string& sentence);
  /// The same for a key that no case has.
  void add_unknown_key(const Place& place, const std::string& path, const std::string& sentence);
  /// Whether nothing at, under or above `path` is known to be wrong, so that a check of it makes sense.
  bool is_sound(const std::string& path) const;
  /// What is allowed and probably not meant, told where `path` was given.
  void warn(const std::string& path, const std::string& sentence);
  /// All faults in the order of the file; those of --set come last.
  std::vector<Diagnostic> sort() const;
  /// The warnings in the same order, without those at and under the paths `meant`.
  std::vector<Diagnostic> sort_warnings(const std::vector<std::string>& meant) const;
  bool empty() const { return diagnostics_.empty(); }

  Places& places;
  /// Keys and choices of whole cases by their name: "it is a key of [lem]"; empty where no block has it. Not set: none.
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

/// `file:line:column: warning: sentence`, without the place where there is none.
std::string write_warning(const Diagnostic& warning);

}  // namespace talus::input
