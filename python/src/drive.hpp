// SPDX-License-Identifier: MIT
#pragma once
// Work of the library in a thread of its own, while the calling thread sees to signals and the callback.

#include <pybind11/pybind11.h>

#include <functional>

#include "base/progress.hpp"

namespace talus::python {

/// How often the callback is called.
enum class Calls {
  with_news,  ///< once for each report of the work
  always,     ///< ten times a second, for work that reports seldom
};

/// Does `work`; meanwhile calls `callback`, unless it is None, with line, label, stage, time and duration of the newest
/// report. When it returns False or raises, or with Ctrl-C, the work is asked to stop. Throws what the work threw; what
/// the callback or Ctrl-C raised is joined with that: one becomes the cause of the other. Throws Error (wrong_input)
/// when other work goes on already: the request to stop is one for the whole process.
void drive(const std::function<void(Progress&)>& work, const pybind11::object& callback, Calls calls);

}  // namespace talus::python
