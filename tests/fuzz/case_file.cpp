// SPDX-License-Identifier: MIT
// Fuzz target: a case file is read, or rejected with messages and positions in the file.
#include <cstdlib>
#include <string>

#include "input/read.hpp"
#include "target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  talus::fuzz::try_to([&] {
    try {
      const auto loaded = talus::input::read_case_text(text, "fuzz.toml", {}, talus::input::CaseScope::whole_or_tests);
      for (const auto& warning : loaded.warnings)
        if (warning.sentence.empty()) std::abort();
    } catch (const talus::InputError& error) {
      if (error.diagnostics().empty()) std::abort();
      for (const auto& fault : error.diagnostics())
        if (fault.sentence.empty() || fault.line < 0) std::abort();
    }
  });
  return 0;
}
