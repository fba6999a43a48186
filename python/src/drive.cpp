// SPDX-License-Identifier: MIT
#include "drive.hpp"

#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

#include "base/progress.hpp"
#include "bind.hpp"

namespace talus::python {
namespace {

/// Longest time before a Ctrl-C is processed.
constexpr std::chrono::milliseconds patience{100};

/// Guard against a second run: the request to stop applies to the whole process.
class OnlyRun {
 public:
  OnlyRun() {
    if (is_running.exchange(true))
      throw Error(ExitCode::wrong_input,
                  "a run or a study is active in this process already; runs side by side need a process each");
    request_interrupt(false);
  }
  ~OnlyRun() {
    request_interrupt(false);
    is_running = false;
  }
  OnlyRun(const OnlyRun&) = delete;
  OnlyRun& operator=(const OnlyRun&) = delete;

 private:
  static inline std::atomic<bool> is_running{false};
};

/// The calculation in a thread of its own. The destructor must be called with the GIL held.
class Calculation {
 public:
  explicit Calculation(const std::function<void(Progress&)>& work)
      : progress_(Progress::Listener([this](const ProgressReport& report) { keep(report); })),
        thread_([this, &work] { calculate(work); }) {}
  ~Calculation() {
    if (!thread_.joinable()) return;
    request_interrupt();
    join();
  }
  Calculation(const Calculation&) = delete;
  Calculation& operator=(const Calculation&) = delete;

  /// Waits for a report or the end, at most for `patience`, with the GIL released. Returns true if the calculation has
  /// ended.
  bool wait(std::optional<ProgressReport>& news) {
    const py::gil_scoped_release released;
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, patience, [&] { return ended_ || news_; });
    news = std::exchange(news_, std::nullopt);
    return ended_;
  }
  /// Waits for the end and returns the exception of the calculation, or null.
  std::exception_ptr join() {
    const py::gil_scoped_release released;
    thread_.join();
    return failure_;
  }

 private:
  /// Stores the newest report only: a slow callback skips reports, and the calculation never waits for it.
  void keep(const ProgressReport& report) {
    const std::lock_guard lock(mutex_);
    news_ = report;
    changed_.notify_one();
  }
  void calculate(const std::function<void(Progress&)>& work) {
    try {
      work(progress_);
    } catch (const Error&) {
      failure_ = std::current_exception();
    } catch (...) {
      const Failure failure = explain_failure(std::current_exception());
      failure_ = std::make_exception_ptr(Error(failure.code, failure.sentence));
    }
    const std::lock_guard lock(mutex_);
    ended_ = true;
    changed_.notify_one();
  }

  Progress progress_;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool ended_ = false;
  std::optional<ProgressReport> news_;
  std::exception_ptr failure_;
  std::thread thread_;  ///< last, since the thread uses the members above
};

/// Calls `callback`; returns false if it requests a stop. It holds HDF5 during the call, so that the callback may read
/// results, also with h5py.
bool ask(const py::object& callback, const ProgressReport& report) {
  const LibraryTurn turn;
  const py::object answer = callback(report.line, report.label, report.stage, report.time, report.duration);
  return !answer.is(py::bool_(false));
}

/// Raises the exception that stopped the run and that of the run, one as the cause of the other; KeyboardInterrupt is
/// preserved.
[[noreturn]] void raise_both(py::error_already_set& stop, const std::exception_ptr& failure) {
  if (!failure) throw stop;
  py::object sentence;
  try {
    std::rethrow_exception(failure);
  } catch (const Error& error) {
    sentence = make_exception(error);
  }
  const bool is_ordinary = stop.matches(PyExc_Exception);
  const py::object reason = stop.value();
  if (stop.trace()) PyException_SetTraceback(reason.ptr(), stop.trace().ptr());
  const py::object& shown = is_ordinary ? sentence : reason;
  const py::object& cause = is_ordinary ? reason : sentence;
  PyException_SetCause(shown.ptr(), py::object(cause).release().ptr());
  PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(shown.ptr())), shown.ptr());
  throw py::error_already_set();
}

}  // namespace

void drive(const std::function<void(Progress&)>& work, const py::object& callback, Calls calls) {
  const OnlyRun only;
  std::optional<py::error_already_set> stop;
  std::optional<ProgressReport> newest;
  Calculation calculation(work);
  for (bool ended = false, asked = false; !ended;) {
    std::optional<ProgressReport> news;
    ended = calculation.wait(news);
    if (stop) {
      if (PyErr_CheckSignals() != 0)
        PyErr_Clear();  // a second Ctrl-C is ignored, since the state is already being
                        // saved
      continue;
    }
    if (news) newest = news;
    const bool is_due = newest && (news || calls == Calls::always);
    try {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      if (is_due && !asked && !callback.is_none() && !ask(callback, *newest)) {
        asked = true;
        request_interrupt();
      }
    } catch (py::error_already_set& error) {
      stop.emplace(error);
      request_interrupt();
    }
  }
  const std::exception_ptr failure = calculation.join();
  if (stop) raise_both(*stop, failure);
  if (failure) std::rethrow_exception(failure);
}

}  // namespace talus::python
