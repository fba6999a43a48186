#include "laboratory/run_calibration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "laboratory/calibration_results.hpp"
#include "laboratory/run_point_tests.hpp"

namespace talus::laboratory {

namespace fs = std::filesystem;
using nlohmann::json;

json run_calibration(const input::LoadedCase& loaded, const CalibrationRun& run) {
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
  json summary = to_json(result, unit);
  summary["format"] = 1;
  summary["title"] = loaded.data.title;
  summary["seed"] = loaded.data.calibration->seed;
  summary["wall"] = wall;
  write_atomically(folder / "calibration.json", summary.dump(1) + "\n");
  return summary;
}

std::string write_calibration_digest(const json& summary) {
  std::size_t width = 9;
  for (const json& p : summary["parameters"]) width = std::max(width, p["key"].get<std::string>().size());
  const auto show = [](const json& value) {
    return value.is_null() ? std::string("-") : fmt::format("{:.4g}", value.get<double>());
  };
  std::string text =
      fmt::format("{:<{}}  {:>10}  {:>10}  {:>10}  {}\n", "parameter", width, "start", "fitted", "std. error", "range");
  for (const json& p : summary["parameters"]) {
    const std::string limit = p["limit"], unit = p["unit"];
    text += fmt::format("{:<{}}  {:>10}  {:>10}  {:>10}  {} to {}{}{}\n", p["key"].get<std::string>(), width,
                        show(p["start"]), show(p["value"]), show(p["error"]), show(p["low"]), show(p["high"]),
                        unit.empty() ? "" : " " + unit, limit == "no" ? "" : "  AT ITS LIMIT");
  }
  for (const json& c : summary["curves"]) {
    const std::size_t points = c["at"].size();
    const std::string unit = c["y"]["unit"];
    text +=
        fmt::format("{}: {} at {} {}, differences {}{}{} (root mean square; before {})\n", c["test"].get<std::string>(),
                    c["y"]["title"].get<std::string>(), points, points == 1 ? "point" : "points", show(c["rms"]),
                    unit == "-" ? "" : " ", unit == "-" ? "" : unit, show(c["rms_before"]));
  }
  for (const json& sentence : summary["findings"]) text += "warning: " + sentence.get<std::string>() + "\n";
  const json& starts = summary["starts"];
  const auto converged =
      std::count_if(starts.begin(), starts.end(), [](const json& s) { return s["converged"] == true; });
  text +=
      fmt::format("{} of {} searches converged; {} sets of parameters, {} tests, {:.1f} s\n", converged, starts.size(),
                  summary["evaluations"].get<long>(), summary["tests"].get<long>(), summary["wall"].get<double>());
  text += "Use them with:";
  for (const json& p : summary["parameters"])
    text += fmt::format(" --set {}={}", p["key"].get<std::string>(), p["text"].get<std::string>());
  return text + "\n";
}

}  // namespace talus::laboratory
