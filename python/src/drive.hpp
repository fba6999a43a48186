// SPDX-License-Identifier: MIT
#pragma once
// Runs work of the library in a thread of its own, while the calling thread processes signals and the callback.

#include <pybind11/pybind11.h>

#include <functional>

#include "base/progress.hpp"

namespace talus::python {

/// Frequency of the callback.
enum class Calls {
  with_news,  ///< once per report of the work
  always,     ///< ten times a second, for work with few reports
};

/// Runs `work` and meanwhile calls `callback`, unless it is None, with line, label, stage, time and duration of the
/// newest report. If the callback returns False or raises, or on Ctrl-C, the work is requested to stop. Throws the
/// exception of the work, chained with that of the callback or of Ctrl-C. Throws Error (wrong_input) if other work is
/// in progress, because the request to stop applies to the whole process.
void drive(const std::function<void(Progress&)>& work, const pybind11::object& callback, Calls calls);

}  // namespace talus::python
