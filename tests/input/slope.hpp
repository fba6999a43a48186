// SPDX-License-Identifier: MIT
#pragma once
// A small case, and a check that a fault in one place is reported at that place.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/slopes.hpp"

namespace talus::input {

/// `text` with the one occurrence of `old_part` replaced.
inline std::string change(std::string text, const std::string& old_part, const std::string& new_part) {
  const auto at = text.find(old_part);
  if (at == std::string::npos || text.find(old_part, at + 1) != std::string::npos) {
    ADD_FAILURE() << "'" << old_part << "' must be in the text exactly once";
    return text;
  }
  return text.replace(at, old_part.size(), new_part);
}

/// The dry slope whose right wall is free, in two stages.
inline const std::string slope =
    change(support::write_slope("dry"), "[[boundary]]\non = \"right\"\nfix = \"normal\"\n", R"([[stage]]
name = "gravity"
duration = 10
damping = 0.7

[[stage]]
name = "failure"
duration = "3 s"
)");

struct Marked {
  std::string text;
  int line = 0;
  int column = 0;
};

/// Removes the mark @@ from a text and returns its position.
inline Marked take_mark(std::string text) {
  Marked marked;
  const auto at = text.find("@@");
  EXPECT_NE(at, std::string::npos);
  marked.line = 1;
  marked.column = 1;
  for (std::size_t i = 0; i < at; ++i) {
    marked.column = text[i] == '\n' ? 1 : marked.column + 1;
    marked.line += text[i] == '\n' ? 1 : 0;
  }
  marked.text = text.erase(at, 2);
  return marked;
}

/// `name` of the case file, beside which its tables lie.
inline std::vector<Diagnostic> find_faults(const std::string& text, const std::vector<Override>& overrides = {},
                                           const std::string& name = "slope.toml") {
  try {
    read_case_text(text, name, overrides);
  } catch (const InputError& error) {
    EXPECT_FALSE(error.diagnostics().empty());
    return error.diagnostics();
  }
  return {};
}

/// Expects exactly one fault, at the mark @@ of the text, whose sentence holds `part`.
inline void expect_fault(const std::string& marked_text, const std::string& part) {
  const Marked marked = take_mark(marked_text);
  const std::vector<Diagnostic> faults = find_faults(marked.text);
  ASSERT_EQ(faults.size(), 1u) << (faults.empty() ? "" : InputError(faults).what()) << "\nexpected: " << part;
  EXPECT_EQ(faults[0].file, "slope.toml");
  EXPECT_EQ(faults[0].line, marked.line) << faults[0].sentence;
  EXPECT_EQ(faults[0].column, marked.column) << faults[0].sentence;
  EXPECT_NE(faults[0].sentence.find(part), std::string::npos) << faults[0].sentence << "\nexpected: " << part;
}

/// The same, for the slope with `old_part` replaced by `new_part`, which holds the mark.
inline void expect_fault(const std::string& old_part, const std::string& new_part, const std::string& part) {
  expect_fault(change(slope, old_part, new_part), part);
}

}  // namespace talus::input
