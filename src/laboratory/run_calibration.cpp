// SPDX-License-Identifier: MIT
#include "laboratory/calibration.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <exception>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "base/file_list.hpp"
#include "base/folder_lock.hpp"
#include "base/units.hpp"
#include "input/echo.hpp"
#include "laboratory/evaluation_store.hpp"
#include "laboratory/point_results.hpp"
#include "laboratory/point_test.hpp"
#include "output/files/history.hpp"
#include "results/json.hpp"
#include "run/run_case.hpp"

namespace talus::laboratory {
namespace {

namespace fs = std::filesystem;
using results::AtLimit;

constexpr const char* search_folder = "calibration";

/// Rounds to nine digits, which are more than those of any measurement.
double round_off(double value) {
  if (value == 0 || !std::isfinite(value)) return value;
  const double power = std::pow(10, 8 - std::floor(std::log10(std::abs(value))));
  return std::isfinite(power) ? std::round(value * power) / power : value;
}

/// Returns how a quantity of a test or of a monitor is shown.
Shown show_axis(const std::string& name, const std::string& stress_unit) {
  if (name == time_axis) return {{name, "time", "day"}, units::get_si_factor("day")};
  if (name == input::get_word(input::MonitoredQuantity::settlement)) return {{name, "settlement", "mm"}, 1e-3};
  if (name == input::get_word(input::MonitoredQuantity::lateral))
    return {{name, "horizontal displacement", "mm"}, 1e-3};
  if (name == input::get_word(input::MonitoredQuantity::pressure))
    return {{name, "pore pressure", stress_unit}, units::get_si_factor(stress_unit)};
  return show_quantity(name, stress_unit);
}

/// Converts a curve from SI to display units.
void show_curve(results::CalibratedCurve& c, const std::string& stress_unit) {
  const Shown x = show_axis(c.x.name, stress_unit), y = show_axis(c.y.name, stress_unit);
  c.x = x.summary;
  c.y = y.summary;
  for (double& v : c.at) v = round_off(v / x.factor);
  for (std::vector<double>* list : {&c.measured, &c.before, &c.fitted})
    for (double& v : *list) v = round_off(v / y.factor);
  for (std::vector<results::Point>* line : {&c.line, &c.line_before})
    for (auto& [a, b] : *line) a = round_off(a / x.factor), b = round_off(b / y.factor);
  for (double* v : {&c.deviation, &c.rms, &c.rms_before, &c.mean, &c.largest}) *v /= y.factor;
  c.largest_at /= x.factor;
}

/// Converts the parameters from the units of the soils to those of the keys, and formats the value for --set.
void show_parameters(results::Calibration& result, const input::Calibration& calibration) {
  for (std::size_t i = 0; i < result.parameters.size(); ++i) {
    results::CalibratedParameter& p = result.parameters[i];
    const double factor = calibration.parameters[i].factor;
    for (double* v : {&p.start, &p.value, &p.low, &p.high}) *v /= factor;
    if (p.error) *p.error /= factor;
    for (results::CalibrationSearch& s : result.starts) s.from[i] /= factor, s.to[i] /= factor;
    // Six digits are more than any calibration determines; a value at its limit must not be rounded past it.
    p.text = p.limit == AtLimit::no ? fmt::format("{:.6g}", p.value) : write_shortest(p.value);
  }
}

std::string write_parameter_table(const results::Calibration& result) {
  std::string text = "parameter,unit,start,fitted,standard_error,min,max,limit\n";
  for (const results::CalibratedParameter& p : result.parameters)
    text += fmt::format("{},{},{:.10g},{:.10g},{},{:.10g},{:.10g},{}\n", p.key, p.unit.empty() ? "-" : p.unit, p.start,
                        p.value, p.error ? fmt::format("{:.6g}", *p.error) : "", p.low, p.high,
                        p.limit == AtLimit::no    ? ""
                        : p.limit == AtLimit::low ? "min"
                                                  : "max");
  return text;
}

std::string write_correlation_table(const results::Calibration& result) {
  std::string text = "parameter";
  for (const results::CalibratedParameter& p : result.parameters) text += "," + p.key;
  text += '\n';
  for (std::size_t i = 0; i < result.parameters.size(); ++i) {
    text += result.parameters[i].key;
    for (const auto& c : result.correlation[i]) text += c ? fmt::format(",{:.6f}", *c) : ",";
    text += '\n';
  }
  return text;
}

/// Formats the curves in SI: rounded values would not give their differences.
std::string write_curve_table(const results::Calibration& result, const std::string& stress_unit) {
  std::string text = "test,x,x_unit,y,y_unit,x_value,measured,with_start,fitted,difference,standard_error\n";
  for (const results::CalibratedCurve& c : result.curves) {
    const Shown x = show_axis(c.x.name, stress_unit), y = show_axis(c.y.name, stress_unit);
    for (std::size_t i = 0; i < c.at.size(); ++i)
      text += fmt::format("{},{},{},{},{},{:.10g},{:.10g},{:.10g},{:.10g},{:.6g},{:.6g}\n", output::quote_field(c.test),
                          c.x.name, x.summary.unit, c.y.name, y.summary.unit, c.at[i] / x.factor,
                          c.measured[i] / y.factor, c.before[i] / y.factor, c.fitted[i] / y.factor,
                          (c.fitted[i] - c.measured[i]) / y.factor, c.deviation / y.factor);
  }
  return text;
}

/// Returns true if a folder has nothing but the evaluations of a search.
bool holds_only_search(const fs::path& folder) {
  std::error_code unknown;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, unknown))
    if (entry.path().filename() != search_folder && entry.path().filename() != lock_file) return false;
  return fs::exists(folder / search_folder, unknown);
}

/// Refuses a folder before the search. Throws Error (cannot_write) if nothing can be written there, and Error
/// (folder_exists) if it has results of a run, which no calibration has left there, or the stages must not replace it.
void check_folder(const input::LoadedCase& loaded, const fs::path& folder) {
  std::error_code unknown;
  fs::path there = fs::absolute(folder);
  while (!fs::exists(there, unknown) && there.has_relative_path()) there = there.parent_path();
  if (!fs::is_directory(there, unknown)) throw_cannot_write(there, ENOTDIR);
  if (::access(there.c_str(), W_OK) != 0) throw_cannot_write(folder, errno);
  if (loaded.data.calibration->monitors.empty() || holds_only_search(folder)) return;
  run::RunOptions options;
  options.folder = folder;
  options.overwrite = true;
  run::check_folder(loaded, options);
  if (fs::exists(folder / "summary.json") && !fs::exists(folder / search_folder / "calibration.json"))
    throw Error(ExitCode::folder_exists,
                "'{}' holds the results of a run, which the stages with the fitted soils would replace: give another "
                "folder with -o",
                folder.string());
}

/// Runs the stages without factors.
void run_stages(const input::LoadedCase& fitted, std::vector<input::Override> changes, const CalibrationRun& run) {
  changes.push_back({"analysis.methods", "[\"fem\"]"});
  for (std::size_t k = 0; k < fitted.data.construction.size(); ++k)
    for (const char* key : {"factor", "release"})
      changes.push_back({fmt::format("construction.{}.{}", k, key), "false"});
  // The folder of the search is no result of the run, which requires a list of files where a folder is not empty and
  // would note what it keeps.
  { const FileList list(run.folder); }
  if (run.options.progress != nullptr) run.options.progress->show("stages with the fitted soils");
  run::RunOptions options;
  options.folder = run.folder;
  options.overwrite = true;
  options.threads = run.options.threads;
  run::run_case(input::read_case_text(fitted.text, fitted.file, changes), options);
}

/// Repeats tests and stages with the fitted soils, for tables, pictures and the first half of the report.
void repeat(const input::LoadedCase& loaded, const results::Calibration& result, const CalibrationRun& run) {
  std::vector<input::Override> changes = run.overrides;
  for (const results::CalibratedParameter& p : result.parameters) changes.push_back({p.key, p.text});
  const input::LoadedCase fitted =
      input::read_case_text(loaded.text, loaded.file, changes, input::CaseScope::whole_or_tests);
  if (!fitted.data.tests.empty()) run_point_tests(fitted, {run.folder, {}, run.pictures});
  if (!loaded.data.calibration->monitors.empty()) run_stages(fitted, std::move(changes), run);
}

}  // namespace

results::Calibration run_calibration(const input::LoadedCase& loaded, const CalibrationRun& run) {
  if (!loaded.data.calibration)
    fail_input(
        "there is nothing to calibrate in '{}': add [[calibration.parameter]] and [[calibration.curve]] or "
        "[[calibration.monitor]]",
        loaded.file);
  check_folder(loaded, run.folder);
  const auto start = std::chrono::steady_clock::now();
  const fs::path folder = run.folder / search_folder;
  FolderLock lock(folder);
  EvaluationStore store(folder / "evaluations.jsonl", input::hash_input(loaded.echo, loaded.data), run.resume);
  CalibrationOptions options = run.options;
  options.store = &store;
  lock.take();
  std::string log;
  results::Calibration result = calibrate(loaded.data, options, &log);
  result.title = loaded.data.title;
  result.seed = static_cast<std::uint64_t>(loaded.data.calibration->seed);
  result.wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (run.options.progress != nullptr) run.options.progress->clear();
  const std::string& unit = loaded.data.output.stress_unit;
  const std::string curves = write_curve_table(result, unit);
  for (results::CalibratedCurve& c : result.curves) show_curve(c, unit);
  show_parameters(result, *loaded.data.calibration);

  // Whatever ends the tests or the stages, the search is not lost.
  std::exception_ptr thrown;
  try {
    repeat(loaded, result, run);
  } catch (...) {
    thrown = std::current_exception();
  }
  write_atomically(folder / "parameters.csv", write_parameter_table(result));
  write_atomically(folder / "correlation.csv", write_correlation_table(result));
  write_atomically(folder / "curves.csv", curves);
  write_atomically(folder / "solver.txt", log);
  results::write_file(folder / "calibration.json", result, 1);
  if (thrown) {
    const Failure failure = explain_failure(thrown);
    const std::string why = failure.code == ExitCode::interrupted
                                ? "interrupted while tests and stages were run with the fitted soils"
                                : failure.sentence;
    throw Error(failure.code, "{}; the fitted parameters are in '{}'", why, folder.string());
  }
  return result;
}

std::string write_calibration_digest(const results::Calibration& calibration) {
  std::size_t width = 9;
  for (const results::CalibratedParameter& p : calibration.parameters) width = std::max(width, p.key.size());
  const auto show = [](double value) { return fmt::format("{:.4g}", value); };
  std::string text =
      fmt::format("{:<{}}  {:>10}  {:>10}  {:>10}  {}\n", "parameter", width, "start", "fitted", "std. error", "range");
  for (const results::CalibratedParameter& p : calibration.parameters)
    text += fmt::format("{:<{}}  {:>10}  {:>10}  {:>10}  {} to {}{}{}\n", p.key, width, show(p.start), show(p.value),
                        p.error ? show(*p.error) : "-", show(p.low), show(p.high), p.unit.empty() ? "" : " " + p.unit,
                        p.limit == AtLimit::no ? "" : "  AT ITS LIMIT");
  for (const results::CalibratedCurve& c : calibration.curves) {
    const std::size_t points = c.at.size();
    const std::string& unit = c.y.unit;
    text += fmt::format("{}: {} at {} {}, differences {}{}{} (root mean square; before {})\n", c.test, c.y.title,
                        points, points == 1 ? "point" : "points", show(c.rms), unit == "-" ? "" : " ",
                        unit == "-" ? "" : unit, show(c.rms_before));
  }
  for (const std::string& sentence : calibration.findings) text += "warning: " + sentence + "\n";
  const auto& starts = calibration.starts;
  const auto converged = std::count_if(starts.begin(), starts.end(), [](const auto& s) { return s.converged; });
  text += fmt::format("{} of {} searches converged; {} sets of parameters, {} tests, {:.1f} s\n", converged,
                      starts.size(), calibration.evaluations, calibration.tests, calibration.wall);
  text += "Use them with:";
  for (const results::CalibratedParameter& p : calibration.parameters)
    text += fmt::format(" --set {}={}", p.key, p.text);
  return text + "\n";
}

}  // namespace talus::laboratory
