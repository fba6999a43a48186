// SPDX-License-Identifier: MIT
// Runs and studies for Python.

#include <pybind11/stl/filesystem.h>

#include <optional>

#include "bind.hpp"
#include "drive.hpp"
#include "run/run_case.hpp"
#include "study/whole_study.hpp"

namespace talus::python {
namespace {

template <class Options>
Options make_options(const std::filesystem::path& folder, int threads, bool resume, bool overwrite) {
  Options options;
  options.folder = folder;
  options.threads = threads;
  options.resume = resume;
  options.overwrite = overwrite;
  return options;
}

void run(const input::LoadedCase& loaded, const std::filesystem::path& folder, int threads, bool resume, bool overwrite,
         const py::object& callback) {
  auto options = make_options<run::RunOptions>(folder, threads, resume, overwrite);
  const auto work = [&](Progress& progress) {
    options.progress = &progress;
    run::run_case(loaded, options);
  };
  drive(work, callback, Calls::with_news);
}

/// Returns the error of a study whose variants did not all finish, or None; throws when it was stopped, and what kept
/// it from beginning.
py::object study(const input::LoadedCase& base, const std::filesystem::path& folder, int threads, bool resume,
                 bool overwrite, const py::object& callback) {
  auto options = make_options<study::StudyOptions>(folder, threads, resume, overwrite);
  std::optional<Error> failure;
  const auto work = [&](Progress& progress) {
    options.progress = &progress;
    failure = study::calculate_study(base, {}, options).failure;
    if (failure && failure->code() == ExitCode::interrupted) throw *failure;
  };
  drive(work, callback, Calls::always);
  return failure ? make_exception(*failure) : py::none();
}

}  // namespace

void bind_run(py::module_& module) {
  module.def("run", &run);
  module.def("study", &study);
}

}  // namespace talus::python
