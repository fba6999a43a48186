// SPDX-License-Identifier: MIT
#include "app/closing_report.hpp"

#include "base/error.hpp"
#include "report/report.hpp"

namespace talus::app {

void do_and_report(const std::filesystem::path& folder, bool wants_report, const std::function<void()>& work) {
  try {
    work();
  } catch (...) {
    const ExitCode code = explain_failure(std::current_exception()).code;
    // Input errors and an occupied folder are found before anything is written: the files there belong to another run.
    const bool has_begun = code != ExitCode::wrong_input && code != ExitCode::folder_exists;
    // Who interrupts wants the end now; `talus report` writes the page of what there is.
    if (wants_report && has_begun && code != ExitCode::interrupted) {
      try {
        report::write_report(folder);
      } catch (...) {  // the first error is the one to report
      }
    }
    throw;
  }
  if (wants_report) report::write_report(folder);
}

}  // namespace talus::app
