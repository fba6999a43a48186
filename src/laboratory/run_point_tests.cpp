#include "laboratory/run_point_tests.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <ctime>
#include <map>
#include <set>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "base/hash.hpp"
#include "base/nearest.hpp"
#include "base/units.hpp"
#include "laboratory/point_groups.hpp"
#include "laboratory/point_results.hpp"
#include "output/plots/gnuplot.hpp"
#include "output/plots/point_plot.hpp"
#include "results/json.hpp"
#include "run/head.hpp"
#include "run/mpm/record/recorder.hpp"
#include "run/named_results.hpp"

namespace talus::laboratory {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_drawn = 250;  ///< rows of a test in a picture

struct Done {
  input::PointTest test;
  PointCurve curve;
};

std::vector<std::size_t> choose_tests(const input::LoadedCase& loaded, const std::vector<std::string>& wanted) {
  const std::vector<input::PointTest>& tests = loaded.data.tests;
  if (tests.empty())
    throw Error(ExitCode::wrong_input,
                fmt::format("there is no element test in '{}': add a [[test]] with a name, a material and a kind",
                            loaded.file));
  std::vector<std::string> names;
  for (const input::PointTest& test : tests) names.push_back(test.name);
  for (const std::string& name : wanted)
    if (std::find(names.begin(), names.end(), name) == names.end()) {
      const std::string near = find_nearest(name, names);
      std::string list;
      for (const std::string& known : names) list += (list.empty() ? "'" : ", '") + known + "'";
      throw Error(ExitCode::wrong_input,
                  fmt::format("there is no test '{}'; {}", name,
                              near.empty() ? "known: " + list : fmt::format("did you mean '{}'?", near)));
    }
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < tests.size(); ++i)
    if (wanted.empty() || std::find(wanted.begin(), wanted.end(), tests[i].name) != wanted.end()) chosen.push_back(i);
  return chosen;
}

/// "100 kPa, 0.22 %" → "100_kPa_0.22"; numbered where two names give one.
std::string name_file(const std::string& test, std::set<std::string>& taken) {
  std::string name;
  for (const char c : test) {
    const bool stays = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-';
    if (stays)
      name += c;
    else if (!name.empty() && name.back() != '_')
      name += '_';
  }
  while (!name.empty() && (name.back() == '_' || name.back() == '.')) name.pop_back();
  if (name.empty()) name = "test";
  std::string free = name;
  for (int i = 2; !taken.insert(free).second; ++i) free = fmt::format("{}_{}", name, i);
  return free + ".csv";
}

/// A picture shows no more rows, and its script stays small; turning points and the last row are always among them.
std::set<std::size_t> choose_drawn(const PointCurve& curve) {
  std::set<std::size_t> chosen(curve.turns.begin(), curve.turns.end());
  const std::size_t stride = (curve.rows.size() + most_drawn - 1) / most_drawn;
  for (std::size_t k = 0; k < curve.rows.size(); k += stride) chosen.insert(k);
  chosen.insert(curve.rows.size() - 1);
  return chosen;
}

output::PointPlot make_plot(const results::PointGroup& group, const std::vector<Done>& tests, const std::string& title,
                            const std::string& stress_unit) {
  output::PointPlot plot{title.empty() ? group.title : title + ": " + group.title, {}, {}};
  const double si = units::get_si_factor(stress_unit);
  for (std::size_t i = 0; i < group.tests.size(); ++i)
    plot.lines.push_back({tests[group.tests[i]].test.name, group.colour[i], group.dash[i]});
  const auto describe = [&](const std::string& name) {
    const auto& all = input::list_point_quantities();
    return *std::find_if(all.begin(), all.end(), [&](const auto& q) { return name == q.name; });
  };
  const auto label = [&](const std::string& name) {
    const input::PointQuantity q = describe(name);
    const bool is_strain = name.ends_with("strain");
    return output::make_label(std::string(q.title) + (*q.symbol ? " " : "") + q.symbol, is_strain ? "%"
                                                                                        : std::string(q.unit) == "Pa"
                                                                                            ? stress_unit
                                                                                            : q.unit);
  };
  for (const results::PointPanel& panel : group.panels) {
    output::PointDiagram diagram{label(panel.x), label(panel.y), panel.log_x, {}, {}};
    for (const std::size_t i : group.tests)
      for (const auto& [name, list] : {std::pair{panel.x, &diagram.x}, std::pair{panel.y, &diagram.y}}) {
        const double scale = name.ends_with("strain") ? 1e-2 : std::string(describe(name).unit) == "Pa" ? si : 1;
        std::vector<double>& values = list->emplace_back();
        const std::vector<PointRow>& rows = tests[i].curve.rows;
        for (const std::size_t k : choose_drawn(tests[i].curve)) values.push_back(get_quantity(rows[k], name) / scale);
      }
    plot.diagrams.push_back(std::move(diagram));
  }
  return plot;
}

/// Whatever the case compares with a published value.
std::map<std::string, double> find_results(const input::LoadedCase& loaded, const std::vector<Done>& tests) {
  std::map<std::string, double> found;
  for (const input::Compare& compare : loaded.data.compare) {
    const auto name = input::find_point_result_name(compare.name);
    if (!name) continue;
    for (const Done& done : tests)
      if (done.test.name == name->test)
        if (const auto value = find_point_result(done.curve, done.test, *name)) found[compare.name] = *value;
  }
  return found;
}

}  // namespace

results::PointTests run_point_tests(const input::LoadedCase& loaded, const PointOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t cpu = std::clock();
  const std::vector<std::size_t> chosen = choose_tests(loaded, options.names);
  std::vector<Done> tests;
  for (const std::size_t i : chosen)
    tests.push_back({loaded.data.tests[i], run_point_test(loaded.data.test_soils[i], loaded.data.tests[i])});
  const fs::path folder = options.folder / "point";
  const input::Output& shown_as = loaded.data.output;
  make_folder(folder);
  results::PointTests result;
  result.title = loaded.data.title;
  result.units = {shown_as.length_unit, shown_as.displacement_unit, shown_as.stress_unit};
  std::set<std::string> files;
  std::vector<input::PointTest> shown;
  for (const Done& done : tests) {
    const std::string file = name_file(done.test.name, files);
    write_atomically(folder / file, write_point_table(done.curve, shown_as.stress_unit));
    result.tests.push_back(describe_point_test(done.test, done.curve, file));
    if (!done.curve.stopped.empty())
      result.warnings.push_back(fmt::format("Test '{}' ended early: {}.", done.test.name, done.curve.stopped));
    shown.push_back(done.test);
  }
  result.groups = group_tests(shown);
  for (results::PointGroup& group : result.groups) {
    group.picture = group.id + "." + options.pictures;
    output::draw(make_plot(group, tests, loaded.data.title, shown_as.stress_unit), folder / group.picture);
  }
  result.project = run::tell_project(loaded.data);
  result.input = loaded.echo;
  result.provenance = run::tell_provenance(loaded, hash_text(loaded.echo.write()), 1);
  result.point_results = find_results(loaded, tests);
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
