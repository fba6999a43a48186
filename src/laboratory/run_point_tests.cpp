#include "laboratory/run_point_tests.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <ctime>
#include <set>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "base/nearest.hpp"
#include "base/units.hpp"
#include "laboratory/point_groups.hpp"
#include "laboratory/point_results.hpp"
#include "output/plots/gnuplot.hpp"
#include "output/plots/point_plot.hpp"
#include "run/mpm/record/recorder.hpp"
#include "run/named_results.hpp"
#include "run/summary.hpp"

namespace talus::laboratory {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

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

output::PointPlot make_plot(const PointGroup& group, const std::vector<Done>& tests, const std::string& title,
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
  for (const PointPanel& panel : group.panels) {
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

json to_json(const PointGroup& group, const std::string& picture) {
  json panels = json::array();
  for (const PointPanel& p : group.panels) panels.push_back({{"x", p.x}, {"y", p.y}, {"log_x", p.log_x}});
  return {{"id", group.id},       {"title", group.title},   {"picture", picture}, {"panels", panels},
          {"tests", group.tests}, {"colour", group.colour}, {"dash", group.dash}};
}

/// Whatever the case compares with a published value.
json find_results(const input::LoadedCase& loaded, const std::vector<Done>& tests) {
  json results = json::object();
  for (const input::Compare& compare : loaded.data.compare) {
    const auto name = input::find_point_result_name(compare.name);
    if (!name) continue;
    for (const Done& done : tests)
      if (done.test.name == name->test)
        if (const auto value = find_point_result(done.curve, done.test, *name)) results[compare.name] = *value;
  }
  return results;
}

}  // namespace

json run_point_tests(const input::LoadedCase& loaded, const PointOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t cpu = std::clock();
  const std::vector<std::size_t> chosen = choose_tests(loaded, options.names);
  std::vector<Done> tests;
  for (const std::size_t i : chosen)
    tests.push_back({loaded.data.tests[i], run_point_test(loaded.data.test_soils[i], loaded.data.tests[i])});
  const fs::path folder = options.folder / "point";
  const std::string& stress_unit = loaded.data.output.stress_unit;
  make_folder(folder);
  json list = json::array(), warnings = json::array(), groups = json::array();
  std::set<std::string> files;
  std::vector<input::PointTest> shown;
  for (const Done& done : tests) {
    const std::string file = name_file(done.test.name, files);
    write_atomically(folder / file, write_point_table(done.curve, stress_unit));
    list.push_back(describe_point_test(done.test, done.curve, file));
    if (!done.curve.stopped.empty())
      warnings.push_back(fmt::format("Test '{}' ended early: {}.", done.test.name, done.curve.stopped));
    shown.push_back(done.test);
  }
  for (const PointGroup& group : group_tests(shown)) {
    const std::string picture = group.id + "." + options.pictures;
    output::draw(make_plot(group, tests, loaded.data.title, stress_unit), folder / picture);
    groups.push_back(to_json(group, picture));
  }
  json summary{{"format", 1},
               {"title", loaded.data.title},
               {"project", run::describe_project(loaded.data)},
               {"input", loaded.echo.get()},
               {"provenance", run::describe_provenance(loaded, run::hash_text(loaded.echo.write()), 1)},
               {"units",
                {{"length", loaded.data.output.length_unit},
                 {"displacement", loaded.data.output.displacement_unit},
                 {"stress", stress_unit}}},
               {"tests", list},
               {"groups", groups},
               {"point_results", find_results(loaded, tests)},
               {"warnings", warnings}};
  summary["comparisons"] = run::compare_results(loaded.data, summary);
  summary["timing"] = {{"wall", std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()},
                       {"cpu", static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC}};
  write_atomically(folder / "point.json", summary.dump(1) + "\n");
  return summary;
}

std::string write_point_digest(const json& summary) {
  const std::string unit = summary["units"]["stress"];
  const double si = units::get_si_factor(unit);
  std::size_t width = 4;
  for (const json& test : summary["tests"]) width = std::max(width, test["name"].get<std::string>().size());
  std::string text = fmt::format("{:<{}}  {:>12}  {:>9}  {:>12}  {:>9}  {:>8}\n", "test", width, "peak q " + unit,
                                 "at strain", "end q " + unit, "ε_v", "e");
  for (const json& test : summary["tests"]) {
    const json& end = test["end"];
    text += fmt::format("{:<{}}  {:>12.4g}  {:>7.3g} %  {:>12.4g}  {:>7.3g} %  {:>8.4f}\n",
                        test["name"].get<std::string>(), width, test["peak_q"].get<double>() / si,
                        100 * test["peak_q_strain"].get<double>(), end["q"].get<double>() / si,
                        100 * end["volumetric_strain"].get<double>(), end["void_ratio"].get<double>());
  }
  for (const json& warning : summary["warnings"]) text += "warning: " + warning.get<std::string>() + "\n";
  std::size_t agree = 0;
  for (const json& c : summary["comparisons"]) {
    const double shown = c["unit"]["si"];
    agree += c["passes"].get<bool>() ? 1 : 0;
    if (c["passes"].get<bool>()) continue;
    text +=
        fmt::format("differs: {} is {}, published {:.4g} {}, tolerance {}\n", c["name"].get<std::string>(),
                    c["computed"].is_null() ? "not known" : fmt::format("{:.4g}", c["computed"].get<double>() / shown),
                    c["published"].get<double>() / shown, c["unit"]["name"].get<std::string>(),
                    c["tolerance_text"].get<std::string>());
  }
  if (!summary["comparisons"].empty())
    text +=
        fmt::format("{} of {} compared values agree within their tolerances\n", agree, summary["comparisons"].size());
  return text;
}

}  // namespace talus::laboratory
