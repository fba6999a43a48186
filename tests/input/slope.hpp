// SPDX-License-Identifier: MIT
#pragma once
// A small case, and a way to break it in one place and say where the fault must be reported.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/slopes.hpp"

namespace talus::input {

/// `text` with the one occurrence of `old_part` replaced.
std::string change(std::string text, const std::string& old_part, const std::string& new_part);

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

/// Takes the mark @@ out of a text and says where it was.
Marked take_mark(std::string text);

std::vector<Diagnostic> find_faults(const std::string& text, const std::vector<Override>& overrides = {});

/// Expects exactly one fault, at the mark @@ of the text, whose sentence holds `part`.
void expect_fault(const std::string& marked_text, const std::string& part);

/// The same, for the slope with `old_part` replaced by `new_part`, which holds the mark.
void expect_fault(const std::string& old_part, const std::string& new_part, const std::string& part);

}  // namespace talus::input
