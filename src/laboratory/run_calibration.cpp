#include "laboratory/run_calibration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "laboratory/calibration_results.hpp"
#include "laboratory/run_point_tests.hpp"
#include "results/json.hpp"

namespace talus::laboratory {

namespace fs = std::filesystem;

results::Calibration run_calibration(const input::LoadedCase& loaded, const CalibrationRun& run) {
  if (!loaded.data.calibration)
    throw Error(ExitCode::wrong_input,
                fmt::format("there is nothing to calibrate in '{}': add [[calibration.parameter]] and "
                            "[[calibration.curve]]",
                            loaded.file));
  const auto start = std::chrono::steady_clock::now();
  const CalibrationResult result = calibrate(loaded.data, run.options);
  const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (run.options.progress != nullptr) run.options.progress->clear();

  // The element tests once more, with the fitted soils: tables, pictures and the report's first half.
  std::vector<input::Override> changes = run.overrides;
  for (const FittedParameter& p : result.parameters) changes.push_back({p.key, write_value(p)});
  const input::LoadedCase fitted =
      input::read_case_text(loaded.text, loaded.file, changes, input::CaseScope::whole_or_tests);
  run_point_tests(fitted, {run.folder, {}, run.pictures});

  const fs::path folder = run.folder / "calibration";
  make_folder(folder);
  const std::string& unit = loaded.data.output.stress_unit;
  write_atomically(folder / "parameters.csv", write_parameter_table(result));
  write_atomically(folder / "correlation.csv", write_correlation_table(result));
  write_atomically(folder / "curves.csv", write_curve_table(result, unit));
  write_atomically(folder / "solver.txt", result.log);
  results::Calibration calibration = describe_calibration(result, unit);
  calibration.title = loaded.data.title;
  calibration.seed = static_cast<std::uint64_t>(loaded.data.calibration->seed);
  calibration.wall = wall;
  results::write_file(folder / "calibration.json", calibration, 1);
  return calibration;
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
