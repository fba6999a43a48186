// SPDX-License-Identifier: MIT
#pragma once
// Progress of a command as lines of JSON on standard error, for programs that start it (--progress-lines).

#include "base/progress.hpp"

namespace talus::app {

/// Writes a line {"line", "label", "stage", "time", "duration", "values"}; keys without a value are left out. `values`
/// has the members of ProgressValues.
void write_progress_line(const ProgressReport& report);

}  // namespace talus::app
