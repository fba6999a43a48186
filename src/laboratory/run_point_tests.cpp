// SPDX-License-Identifier: MIT
#include "input/case/compare.hpp"
#include "laboratory/point_test.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <set>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "base/folder_lock.hpp"
#include "base/hash.hpp"
#include "base/text.hpp"
#include "base/units.hpp"
#include "base/user_file.hpp"
#include "laboratory/point_results.hpp"
#include "output/plots/gnuplot.hpp"
#include "output/plots/point_plot.hpp"
#include "results/json.hpp"
#include "run/common/head.hpp"

namespace talus::laboratory {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_plotted = 250;  ///< rows of a test in a picture, which limits the size of its script

/// Indices of the requested tests.
std::vector<std::size_t> choose_tests(const input::LoadedCase& loaded, const std::vector<std::string>& wanted) {
  const std::vector<input::PointTest>& tests = loaded.data.tests;
  if (tests.empty())
    fail_input("there is no element test in '{}': add a [[test]] with a name, a material and a kind", loaded.file);
  std::vector<std::string> names;
  for (const input::PointTest& test : tests) names.push_back(test.name);
  for (const std::string& name : wanted)
    if (std::find(names.begin(), names.end(), name) == names.end()) {
      const std::string near = find_nearest(name, names);
      std::string list;
      for (const std::string& known : names) list += (list.empty() ? "'" : ", '") + known + "'";
      fail_input("there is no test '{}'; {}", name,
                 near.empty() ? "known: " + list : fmt::format("did you mean '{}'?", near));
    }
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < tests.size(); ++i)
    if (wanted.empty() || std::find(wanted.begin(), wanted.end(), tests[i].name) != wanted.end()) chosen.push_back(i);
  return chosen;
}

output::PointPlot make_plot(const results::PointGroup& group, const std::vector<input::PointTest>& tests,
                            const std::vector<PointCurve>& curves, const results::PointTests& out) {
  output::PointPlot plot{out.title.empty() ? group.title : out.title + ": " + group.title, {}, {}};
  for (std::size_t i = 0; i < group.tests.size(); ++i)
    plot.lines.push_back({tests[group.tests[i]].name, group.colour[i], group.dash[i]});
  for (const results::PointPanel& panel : group.panels) {
    const Shown x = show_quantity(panel.x, out.units.stress), y = show_quantity(panel.y, out.units.stress);
    const auto label = [](const Shown& q) { return output::make_label(q.summary.title, q.summary.unit); };
    output::PointDiagram diagram{label(x), label(y), panel.log_x, {}, {}};
    for (const std::size_t i : group.tests)
      for (const auto& [q, list] : {std::pair{&x, &diagram.x}, std::pair{&y, &diagram.y}}) {
        std::vector<double>& values = list->emplace_back();
        for (const std::size_t k : choose_drawn(curves[i], most_plotted))
          values.push_back(get_quantity(curves[i].rows[k], q->summary.name) / q->factor);
      }
    plot.diagrams.push_back(std::move(diagram));
  }
  return plot;
}

/// Returns the results that the case compares with published values.
std::map<std::string, double> find_results(const input::Case& data, const std::vector<input::PointTest>& tests,
                                           const std::vector<PointCurve>& curves) {
  std::map<std::string, double> found;
  for (const input::Compare& compare : data.compare) {
    const auto name = input::find_point_result_name(compare.name);
    for (std::size_t i = 0; i < tests.size(); ++i)
      if (name && tests[i].name == name->test)
        if (const auto value = find_point_result(curves[i], tests[i], *name)) found[compare.name] = *value;
  }
  return found;
}

}  // namespace

results::PointTests run_point_tests(const input::LoadedCase& loaded, const PointOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t cpu = std::clock();
  std::vector<input::PointTest> tests;
  std::vector<PointCurve> curves;
  for (const std::size_t i : choose_tests(loaded, options.names)) {
    tests.push_back(loaded.data.tests[i]);
    curves.push_back(run_point_test(loaded.data.test_soils[i], tests.back(), loaded.data.units().stress));
  }
  const fs::path folder = options.folder / "point";
  const input::Output& shown_as = loaded.data.output;
  FolderLock lock(folder);
  lock.take();
  results::PointTests result;
  result.title = loaded.data.title;
  result.units = {shown_as.length_unit, shown_as.displacement_unit, shown_as.stress_unit};
  std::set<std::string> files;
  for (std::size_t i = 0; i < tests.size(); ++i) {
    const std::string file = take_file_name(tests[i].name, "test", files) + ".csv";
    write_atomically(join_name(folder, file), write_point_table(curves[i], shown_as.stress_unit));
    result.tests.push_back(describe_point_test(tests[i], curves[i], file, loaded.data.units().stress));
    if (!curves[i].stopped.empty())
      result.warnings.push_back(fmt::format("Test '{}' ended early: {}.", tests[i].name, curves[i].stopped));
  }
  result.groups = group_tests(tests);
  for (results::PointGroup& group : result.groups) {
    group.picture = group.id + "." + options.pictures;
    output::draw(make_plot(group, tests, curves, result), join_name(folder, group.picture));
  }
  result.project = run::make_project(loaded.data);
  result.input = loaded.echo;
  result.provenance = run::make_provenance(loaded, hash_text(loaded.echo.write()), 1);
  result.point_results = find_results(loaded.data, tests, curves);
  result.comparisons = run::compare_results(loaded.data, result);
  result.timing.wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  result.timing.cpu = static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC;
  results::write_file(folder / "point.json", result, 1);
  return result;
}

std::string write_point_digest(const results::PointTests& tests) {
  const std::string& unit = tests.units.stress;
  const double si = units::get_si_factor(unit);
  std::size_t width = 4;
  for (const results::PointTest& test : tests.tests) width = std::max(width, test.name.size());
  std::string text = fmt::format("{:<{}}  {:>12}  {:>9}  {:>12}  {:>9}  {:>8}\n", "test", width, "peak q " + unit,
                                 "at strain", "end q " + unit, "ε_v", "e");
  for (const results::PointTest& test : tests.tests) {
    const auto at_end = [&](const std::string& quantity) { return test.end.at(quantity); };
    text += fmt::format("{:<{}}  {:>12.4g}  {:>7.3g} %  {:>12.4g}  {:>7.3g} %  {:>8.4f}\n", test.name, width,
                        test.peak_q / si, 100 * test.peak_q_strain, at_end("q") / si, 100 * at_end("volumetric_strain"),
                        at_end("void_ratio"));
  }
  for (const std::string& warning : tests.warnings) text += "warning: " + warning + "\n";
  std::size_t agree = 0;
  for (const results::Comparison& c : tests.comparisons) {
    agree += c.passes ? 1 : 0;
    if (c.passes) continue;
    text += fmt::format("differs: {} is {}, published {:.4g} {}, tolerance {}\n", c.name,
                        c.computed ? fmt::format("{:.4g}", *c.computed / c.unit.si) : "not known",
                        c.published / c.unit.si, c.unit.name, c.tolerance_text);
  }
  if (!tests.comparisons.empty())
    text += fmt::format("{} of {} compared values agree within their tolerances\n", agree, tests.comparisons.size());
  return text;
}

}  // namespace talus::laboratory
