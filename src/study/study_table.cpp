#include "study/study_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>

#include "base/atomic_file.hpp"
#include "base/units.hpp"
#include "output/files/history.hpp"
#include "output/plots/curve_plot.hpp"
#include "output/plots/gnuplot.hpp"
#include "run/named_results.hpp"
#include "study/extrapolation.hpp"

namespace talus::study {
namespace {

using nlohmann::json;

/// Two trials are of one factor when their factors differ by less.
constexpr double same_factor = 1e-9;
/// Displacements below this share of the largest one are rounding errors of a slope at rest; a logarithmic axis would
/// be all theirs.
constexpr double smallest_share = 1e-5;

/// What a summary says at `path`; nullptr when it does not say it.
const json* find(const json& summary, std::initializer_list<const char*> path) {
  const json* at = &summary;
  for (const char* step : path) {
    if (!at->is_object() || !at->contains(step)) return nullptr;
    at = &at->at(step);
  }
  return at->is_null() ? nullptr : at;
}

std::optional<double> get_number(const json& summary, std::initializer_list<const char*> path) {
  const json* found = find(summary, path);
  return found != nullptr && found->is_number() ? std::optional(found->get<double>()) : std::nullopt;
}

/// The entry of a list in the summary whose `srf` is `factor`.
const json* find_trial(const json* list, double factor) {
  if (list == nullptr) return nullptr;
  for (const json& t : *list)
    if (std::abs(t.at("srf").get<double>() - factor) < same_factor) return &t;
  return nullptr;
}

std::optional<double> get_displacement(const json& summary, double factor) {
  const json* trial = find_trial(find(summary, {"curve", "points"}), factor);
  return trial == nullptr ? std::nullopt : get_number(*trial, {"displacement"});
}

const json* find_criterion(const json& summary, const std::string& name) {
  const json* list = find(summary, {"factor_of_safety", "criteria"});
  if (list == nullptr) return nullptr;
  for (const json& c : *list)
    if (c.at("name") == name) return &c;
  return nullptr;
}

std::optional<double> get_time_step(const json& summary) {
  const json* stages = find(summary, {"stages"});
  return stages == nullptr || stages->empty() ? std::nullopt : get_number(stages->back(), {"time_step"});
}

/// All factors whose trials went on until rest, in any variant.
std::set<double> list_runout_factors(const std::vector<StudyRow>& rows) {
  std::set<double> factors;
  for (const StudyRow& row : rows)
    if (const json* runouts = find(row.summary, {"runouts"}))
      for (const json& r : *runouts) factors.insert(r.at("srf").get<double>());
  return factors;
}

/// What the pattern of movement is called in the table.
std::string describe_pattern(const json& summary) {
  static const std::map<std::string, const char*> words{{"none", "none"},
                                                        {"single", "one monitor only"},
                                                        {"together", "together"},
                                                        {"upwards", "from the bottom upwards"},
                                                        {"downwards", "from the top downwards"},
                                                        {"mixed", "in no such order"}};
  const json* pattern = find(summary, {"motion", "pattern"});
  const auto found = pattern == nullptr ? words.end() : words.find(pattern->get<std::string>());
  return found == words.end() ? "" : found->second;
}

/// Adds columns of numbers to a table.
class Columns {
 public:
  explicit Columns(const std::vector<StudyRow>& rows) : rows_(rows) {}

  using Getter = std::function<std::optional<double>(const json&)>;
  /// `format` is that of the shown number, `{:.3f}`; the numbers are SI and shown in `unit`.
  void add(const std::string& name, const std::string& unit, const char* format, bool always, const Getter& get) {
    StudyColumn column{name, name, unit, {}};
    const double factor = unit.empty() ? 1 : units::get_si_factor(unit);
    bool any = false;
    for (const StudyRow& row : rows_) {
      std::optional<double> value;
      if (row.summary.is_object()) value = get(row.summary);
      any = any || value;
      column.cells.push_back(
          value ? StudyCell{output::to_shortest(*value / factor), fmt::format(fmt::runtime(format), *value / factor)}
                : StudyCell{});
    }
    if (any || always) table.push_back(std::move(column));
  }

  std::vector<StudyColumn> table;

 private:
  const std::vector<StudyRow>& rows_;
};

/// A CSV field; quoted where a comma or a quotation mark would end it.
std::string write_field(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

/// Text inside a Markdown table.
std::string write_cell(const std::string& text) {
  std::string cell;
  for (const char c : text) cell += c == '|' ? "\\|" : c == '\n' ? " " : std::string(1, c);
  return cell.empty() ? "–" : cell;
}

/// Onset and displacement of every monitor, the latter also over that of the reference, if it moved there, and the
/// order of movement.
void add_motion(const StudyPlan& plan, const std::vector<StudyRow>& rows, Columns& columns) {
  for (const std::string& name : plan.monitors)
    columns.add("onset of " + name, "s", "{:.4g}", false,
                [&](const json& s) { return run::find_result(s, fmt::format("onset[{}]", name)); });
  for (const std::string& name : plan.monitors) {
    const auto get = [&](const json& s) { return run::find_result(s, fmt::format("displacement[{}]", name)); };
    columns.add("displacement of " + name, plan.displacement_unit, "{:.4g}", false, get);
    const json& base = rows[plan.reference].summary;
    const bool moves = base.is_object() && run::find_result(base, fmt::format("onset[{}]", name));
    const std::optional<double> reference = moves ? get(base) : std::nullopt;
    columns.add(fmt::format("displacement of {} over that of {}", name, plan.variants[plan.reference].label), "",
                "{:.3f}", false, [&](const json& s) {
                  const std::optional<double> value = get(s);
                  return value && reference && *reference > 0 ? std::optional(*value / *reference) : std::nullopt;
                });
  }
  StudyColumn order{"order of movement", "order of movement", "", {}};
  for (const StudyRow& row : rows) {
    const std::string words = row.summary.is_object() ? describe_pattern(row.summary) : "";
    order.cells.push_back({words, words});
  }
  const auto is_empty = [](const StudyCell& cell) { return cell.full.empty(); };
  if (!std::all_of(order.cells.begin(), order.cells.end(), is_empty)) columns.table.push_back(std::move(order));
}

}  // namespace

std::vector<StudyColumn> make_study_table(const StudyPlan& plan, const std::vector<StudyRow>& rows) {
  Columns columns(rows);
  StudyColumn names{"variant", "variant", "", {}}, results{"result", "result", "", {}};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    names.cells.push_back({plan.variants[i].name, plan.variants[i].label});
    results.cells.push_back({rows[i].status, rows[i].status});
  }
  columns.table.push_back(std::move(names));
  for (std::size_t k = 0; k < plan.keys.size(); ++k) {
    StudyColumn column{plan.keys[k].path, plan.keys[k].name, plan.keys[k].unit, {}};
    for (const Variant& v : plan.variants) column.cells.push_back({v.values[k], v.values[k]});
    columns.table.push_back(std::move(column));
  }
  for (const double f : plan.factors)
    columns.add(fmt::format("displacement at SRF {:g}", f), plan.displacement_unit, "{:.4g}", true,
                [f](const json& s) { return get_displacement(s, f); });
  for (const char* criterion : {"frozen", "bilinear", "displacement", "jump"})
    columns.add(fmt::format("FoS, {}", criterion), "", "{:.3f}", false, [criterion](const json& s) {
      return run::find_result(s, std::string("factor_of_safety.") + criterion);
    });
  for (const auto& [name, title] : std::initializer_list<std::pair<const char*, const char*>>{
           {"lem.fellenius", "Fellenius"},
           {"lem.bishop", "Bishop"},
           {"lem.janbu", "Janbu"},
           {"lem.janbu_corrected", "Janbu, corrected"},
           {"lem.spencer", "Spencer"},
           {"lem.morgenstern_price", "Morgenstern–Price"},
           {"lem.morgenstern_price_constant", "Morgenstern–Price, constant"},
           {"lem.noncircular.spencer", "Spencer, non-circular"},
           {"lem.noncircular.morgenstern_price", "Morgenstern–Price, non-circular"},
           {"fem.factor", "finite elements"},
           {"fem.by_displacement", "finite elements, displacement"},
           {"fem.associated.factor", "finite elements, ψ = φ"}})
    columns.add(fmt::format("FoS, {}", title), "", "{:.3f}", false,
                [n = std::string(name)](const json& s) { return run::find_result(s, n); });
  for (const double f : list_runout_factors(rows))
    columns.add(fmt::format("front advance at SRF {:g}", f), plan.length_unit, "{:.3g}", false, [f](const json& s) {
      const json* trial = find_trial(find(s, {"runouts"}), f);
      return trial == nullptr ? std::nullopt : get_number(*trial, {"runout", "front_advance"});
    });
  add_motion(plan, rows, columns);
  columns.add("largest displacement", plan.displacement_unit, "{:.4g}", false, [](const json& s) {
    return get_number(s, {"runout", "largest_displacement"});
  });
  for (const auto& [name, key] : {std::pair{"front advance", "front_advance"},
                                  {"runout beyond the toe", "toe_distance"},
                                  {"crest retreat", "crest_retreat"},
                                  {"advance of the centre", "centre_advance"}})
    columns.add(name, plan.length_unit, "{:.3g}", false, [k = key](const json& s) {
      return get_number(s, {"runout", k});
    });
  const bool plane = std::all_of(rows.begin(), rows.end(), [](const StudyRow& row) {
    return get_number(row.summary, {"mesh", "dimension"}).value_or(2) == 2;
  });
  columns.add("moved volume", plane ? "m3/m" : "m3", "{:.4g}", false, [](const json& s) {
    return get_number(s, {"runout", "moved_volume"});
  });
  columns.add("points", "", "{:.0f}", false, [](const json& s) { return get_number(s, {"mesh", "points"}); });
  columns.add("elements with soil", "", "{:.0f}", false, [](const json& s) {
    return get_number(s, {"mesh", "soil_elements"});
  });
  columns.add("elements", "", "{:.0f}", false, [](const json& s) { return get_number(s, {"mesh", "elements"}); });
  columns.add("time step", "s", "{:.3g}", false, get_time_step);
  columns.add("wall time", "s", "{:.3g}", false, [](const json& s) { return get_number(s, {"timing", "wall"}); });
  columns.table.push_back(std::move(results));
  return columns.table;
}

std::string write_study_csv(const std::vector<StudyColumn>& table) {
  std::string text;
  for (const StudyColumn& c : table)
    text += (text.empty() ? "" : ",") + write_field(output::make_label(c.name, c.unit));
  text += '\n';
  for (std::size_t i = 0; i < table[0].cells.size(); ++i) {
    for (std::size_t k = 0; k < table.size(); ++k) text += (k == 0 ? "" : ",") + write_field(table[k].cells[i].full);
    text += '\n';
  }
  return text;
}

std::string write_study_markdown(const StudyPlan& plan, const std::vector<StudyRow>& rows) {
  const std::vector<StudyColumn> table = make_study_table(plan, rows);
  std::string text = fmt::format("# {}\n\n", plan.title.empty() ? "Study" : plan.title);
  text += "Varied:";
  for (const StudyKey& key : plan.keys) text += fmt::format("{} `{}`", &key == &plan.keys[0] ? "" : ",", key.path);
  text += ".\n\n|";
  for (const StudyColumn& c : table) text += fmt::format(" {} |", write_cell(output::make_label(c.title, c.unit)));
  text += "\n|";
  for (std::size_t k = 0; k < table.size(); ++k) text += k == 0 || k + 1 == table.size() ? "---|" : "--:|";
  text += '\n';
  for (std::size_t i = 0; i < rows.size(); ++i) {
    text += '|';
    for (const StudyColumn& c : table) text += fmt::format(" {} |", write_cell(c.cells[i].shown));
    text += '\n';
  }
  std::string remarks;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::string& label = plan.variants[i].label;
    if (!rows[i].reason.empty()) remarks += fmt::format("- {}: {}\n", label, rows[i].reason);
    if (!rows[i].summary.is_object()) continue;
    if (const json* warnings = find(rows[i].summary, {"warnings"}))
      for (const json& w : *warnings) remarks += fmt::format("- {}: {}\n", label, w.get<std::string>());
    for (const char* name : {"bilinear", "displacement", "jump"}) {
      const json* c = find_criterion(rows[i].summary, name);
      if (c != nullptr && !get_number(*c, {"factor"}))
        remarks +=
            fmt::format("- {}: no factor of safety by the {} criterion: {}\n", label, name, c->value("note", ""));
    }
    if (rows[i].status != "finished" || find(rows[i].summary, {"curve"}) == nullptr) continue;
    for (const double f : plan.factors)
      if (!get_displacement(rows[i].summary, f)) remarks += fmt::format("- {}: no trial at SRF {:g}\n", label, f);
  }
  for (const std::string& note : plan.notes) remarks += fmt::format("- {}\n", note);
  text += write_extrapolation_markdown(plan, extrapolate_factors(plan, rows));
  return text + (remarks.empty() ? "" : "\n" + remarks);
}

json describe_study(const StudyPlan& plan, const std::vector<StudyRow>& rows) {
  json vary = json::array(), columns = json::array(), variants = json::array();
  for (std::size_t k = 0; k < plan.keys.size(); ++k) {
    json values = json::array();
    for (const Variant& v : plan.variants)
      if (std::find(values.begin(), values.end(), v.values[k]) == values.end()) values.push_back(v.values[k]);
    vary.push_back({{"key", plan.keys[k].path}, {"unit", plan.keys[k].unit}, {"values", values}});
  }
  for (const StudyColumn& c : make_study_table(plan, rows)) {
    json cells = json::array();
    for (const StudyCell& cell : c.cells) cells.push_back({{"full", cell.full}, {"shown", cell.shown}});
    columns.push_back({{"name", c.name}, {"title", c.title}, {"unit", c.unit}, {"cells", cells}});
  }
  for (std::size_t i = 0; i < rows.size(); ++i)
    variants.push_back({{"name", plan.variants[i].label},
                        {"folder", plan.variants[i].name},
                        {"status", rows[i].status},
                        {"reason", rows[i].reason}});
  json study{{"format", 1},
             {"title", plan.title},
             {"case_file", plan.file},
             {"mode", plan.mode},
             {"reference", plan.variants.empty() ? "" : plan.variants[plan.reference].label},
             {"vary", vary},
             {"columns", columns},
             {"variants", variants},
             {"notes", plan.notes},
             {"units", {{"displacement", plan.displacement_unit}, {"length", plan.length_unit}}}};
  if (!plan.extrapolate.empty()) study["extrapolation"] = describe_extrapolation(plan, extrapolate_factors(plan, rows));
  return study;
}

void write_study_tables(const StudyPlan& plan, const std::vector<StudyRow>& rows, const std::filesystem::path& folder) {
  const std::string safe = "the results of the variants are whole";
  write_atomically(folder / "study.csv", write_study_csv(make_study_table(plan, rows)), safe);
  write_atomically(folder / "study.json", describe_study(plan, rows).dump(2) + "\n", safe);
  write_atomically(folder / "study.md", write_study_markdown(plan, rows), safe);
}

void draw_study(const StudyPlan& plan, const std::vector<StudyRow>& rows, const std::filesystem::path& picture) {
  output::TablePlot plot;
  plot.title = plan.title;
  plot.x_label = "strength reduction factor";
  plot.y_label = output::make_label("displacement", plan.displacement_unit);
  plot.log_y = true;  // displacements of the variants differ by powers of ten
  const double unit = units::get_si_factor(plan.displacement_unit);
  double largest = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const json* points = find(rows[i].summary, {"curve", "points"});
    if (points == nullptr) continue;
    output::PlotSeries series{plan.variants[i].label, {}, {}};
    for (const json& p : *points) {
      series.x.push_back(p.at("srf").get<double>());
      series.y.push_back(p.at("displacement").get<double>() / unit);
      largest = std::max(largest, series.y.back());
    }
    plot.series.push_back(std::move(series));
  }
  for (output::PlotSeries& s : plot.series) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < s.x.size(); ++i) {
      if (!(s.y[i] > smallest_share * largest)) continue;
      s.x[kept] = s.x[i];
      s.y[kept++] = s.y[i];
    }
    s.x.resize(kept);
    s.y.resize(kept);
  }
  std::erase_if(plot.series, [](const output::PlotSeries& s) { return s.x.empty(); });
  if (!plot.series.empty()) output::draw(plot, picture);
}

}  // namespace talus::study
