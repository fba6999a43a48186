// SPDX-License-Identifier: MIT
#pragma once
// A case as far as it can be read, for pictures of cases with faults.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "input/case/case.hpp"
#include "input/language/parse.hpp"
#include "input/read.hpp"

namespace talus::input {

struct Sketch {
  std::string file;       ///< its name in messages
  Case data;              ///< values that could not be read have their defaults; is_sound() identifies them
  Layering layering;      ///< boundary lines as given, from which the polygons are built
  bool is_whole = false;  ///< false: no slope, or a text that is not TOML
  bool is_small = false;  ///< the section has few enough corners for geometric checks
  /// Returns true if no fault at, below or above a path ("geometry.polygon.0.points.2") is known.
  std::function<bool(const std::string& path)> is_sound;
  std::function<bool(const std::string& path)> is_given;
  /// Returns the path of the key where a message is reported; of the nearest key before its place if no key begins
  /// there, and of the key that --set gives; empty without a place in the case.
  std::function<std::string(const Diagnostic& message)> find_path;
};

/// Reads and checks a case file as read_case() does, without values of a study. Does not throw for faults of the case,
/// which read_case() lists.
Sketch read_sketch(const std::string& path, const std::vector<Override>& overrides, CaseScope scope);

/// A text with all that one reading finds: its faults, its warnings and its sketch.
struct Examination {
  std::vector<Diagnostic> faults;    ///< as read_case_text() throws
  std::vector<Diagnostic> warnings;  ///< of the keys without faults
  Sketch sketch;
  std::optional<LoadedCase> loaded;  ///< without faults only
};

/// Reads and checks a text as read_case_text() does. Does not throw for faults of the case.
Examination examine_text(const std::string& text, const std::string& name, const std::vector<Override>& overrides = {},
                         CaseScope scope = CaseScope::whole_or_tests);

/// Reads and checks a case file in the same way, and returns the warnings of keys without faults.
std::vector<Diagnostic> read_warnings(const std::string& path, const std::vector<Override>& overrides, CaseScope scope);

}  // namespace talus::input
