// SPDX-License-Identifier: MIT
#pragma once
// Messages of a check as the page shows them: with the key that they concern, its bytes in the text and a place in the
// section.

#include <cstddef>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "input/sketch.hpp"
#include "results/about.hpp"
#include "studio/spans.hpp"

namespace talus::studio {

/// Finds the key of a message, its span and its place in the section. Text and sketch must outlive it.
class MessageWriter {
 public:
  MessageWriter(const std::string& text, const input::Sketch& sketch);

  const TextSpans& spans() const { return spans_; }

  /// Appends {severity, key, text, line, column, span, place} to `list`.
  void add(const char* severity, const Diagnostic& message, nlohmann::json& list) const;

 private:
  void add_place(const Diagnostic& message, nlohmann::json& out) const;

  LineTable lines_;
  const input::Sketch& sketch_;
  std::vector<results::Point> ground_;
  TextSpans spans_;
  std::size_t size_;
  std::map<std::size_t, std::string> names_, starts_;  ///< paths by the first byte of their name and of their value
};

}  // namespace talus::studio
