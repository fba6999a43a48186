// SPDX-License-Identifier: MIT
// Bindings of runs, studies and jobs.

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <optional>

#include "bind.hpp"
#include "drive.hpp"
#include "run/mpm/stage/stepper.hpp"
#include "run/run_case.hpp"
#include "study/jobs.hpp"
#include "study/study.hpp"

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
         const py::object& callback, const std::string& device) {
  auto options = make_options<run::RunOptions>(folder, threads, resume, overwrite);
  options.device = run::find_device_kind(device);
  const auto work = [&](Progress& progress) {
    options.progress = &progress;
    run::run_case(loaded, options);
  };
  drive(work, callback, Calls::with_news);
}

/// Returns the error of a study with unfinished variants, or None. Throws if the study was stopped or could not start.
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

/// Writes the jobs of a study to `folder`; with `jobs` = 0 their number is chosen automatically.
void prepare_jobs(const input::LoadedCase& base, const std::filesystem::path& folder, int threads, bool resume,
                  bool overwrite, int jobs) {
  study::JobOptions options{make_options<study::StudyOptions>(folder, threads, resume, overwrite), jobs};
  const auto work = [&](Progress& progress) {
    options.study.progress = &progress;
    study::prepare_jobs(base, {}, options);
  };
  drive(work, py::none(), Calls::with_news);
}

/// Returns the number of jobs, the indices of the missing ones, and of those with failures.
py::tuple list_jobs(const std::filesystem::path& folder) {
  const study::JobStates states = study::list_jobs(folder);
  return py::make_tuple(states.count, py::cast(states.missing), py::cast(states.failed));
}

/// Returns the error of a job with failures, or None.
py::object calculate_job(const std::filesystem::path& folder, int job, int threads) {
  std::optional<Error> failure;
  const auto work = [&](Progress& progress) { failure = study::calculate_job(folder, job, threads, &progress); };
  drive(work, py::none(), Calls::with_news);
  return failure ? make_exception(*failure) : py::none();
}

/// Returns the error of missing or failed jobs, or None.
py::object collect_jobs(const std::filesystem::path& folder, int threads) {
  auto options = make_options<study::StudyOptions>(folder, threads, false, false);
  std::optional<Error> failure;
  const auto work = [&](Progress& progress) {
    options.progress = &progress;
    failure = study::collect_jobs(options).failure;
  };
  drive(work, py::none(), Calls::with_news);
  return failure ? make_exception(*failure) : py::none();
}

}  // namespace

void bind_run(py::module_& module) {
  module.def("run", &run);
  module.def("study", &study);
  module.def("prepare_jobs", &prepare_jobs);
  module.def("list_jobs", &list_jobs);
  module.def("calculate_job", &calculate_job);
  module.def("collect_jobs", &collect_jobs);
}

}  // namespace talus::python
