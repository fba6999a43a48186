// SPDX-License-Identifier: MIT
#include "input/slope.hpp"

namespace talus::input {

std::string change(std::string text, const std::string& old_part, const std::string& new_part) {
  const auto at = text.find(old_part);
  if (at == std::string::npos || text.find(old_part, at + 1) != std::string::npos) {
    ADD_FAILURE() << "'" << old_part << "' must be in the text exactly once";
    return text;
  }
  return text.replace(at, old_part.size(), new_part);
}

Marked take_mark(std::string text) {
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

std::vector<Diagnostic> find_faults(const std::string& text, const std::vector<Override>& overrides) {
  try {
    read_case_text(text, "slope.toml", overrides);
  } catch (const InputError& error) {
    EXPECT_FALSE(error.diagnostics().empty());
    return error.diagnostics();
  }
  return {};
}

void expect_fault(const std::string& marked_text, const std::string& part) {
  const Marked marked = take_mark(marked_text);
  const std::vector<Diagnostic> faults = find_faults(marked.text);
  ASSERT_EQ(faults.size(), 1u) << (faults.empty() ? "" : InputError(faults).what()) << "\nexpected: " << part;
  EXPECT_EQ(faults[0].file, "slope.toml");
  EXPECT_EQ(faults[0].line, marked.line) << faults[0].sentence;
  EXPECT_EQ(faults[0].column, marked.column) << faults[0].sentence;
  EXPECT_NE(faults[0].sentence.find(part), std::string::npos) << faults[0].sentence << "\nexpected: " << part;
}

void expect_fault(const std::string& old_part, const std::string& new_part, const std::string& part) {
  expect_fault(change(slope, old_part, new_part), part);
}

}  // namespace talus::input
