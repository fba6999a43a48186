// SPDX-License-Identifier: MIT
#include "study/study_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <span>

#include "base/atomic_file.hpp"
#include "base/text.hpp"
#include "base/units.hpp"
#include "base/user_file.hpp"
#include "output/files/history.hpp"
#include "output/plots/curve_plot.hpp"
#include "output/plots/gnuplot.hpp"
#include "results/json.hpp"
#include "results/named.hpp"
#include "run/common/head.hpp"
#include "run/mpm/record/motion.hpp"
#include "study/back_analysis_text.hpp"

namespace talus::study {

namespace {

using results::ColumnKind;
using results::Runout;
using results::RunResult;
using results::StudyCell;
using results::StudyColumn;

/// Largest difference between equal factors of trials.
constexpr double same_factor = 1e-9;

/// Returns a number of a part of the result; nullopt if the run does not have that part.
template <class Part, class Owner, class Number>
std::optional<double> get(const std::optional<Part>& part, Number Owner::*number) {
  return part ? std::optional(static_cast<double>((*part).*number)) : std::nullopt;
}

std::optional<double> get_displacement(const RunResult& r, double factor) {
  if (r.curve)
    for (const results::Trial& t : r.curve->points)
      if (std::abs(t.factor - factor) < same_factor) return t.displacement;
  return std::nullopt;
}

const Runout* find_runout(const RunResult& r) {
  return r.runout ? &*r.runout : nullptr;
}

const Runout* find_runout_at(const RunResult& r, double factor) {
  if (r.runouts)
    for (const results::RunoutTrial& t : *r.runouts)
      if (std::abs(t.trial.factor - factor) < same_factor) return &t.runout;
  return nullptr;
}

std::optional<double> get_time_step(const RunResult& r) {
  return r.stages && !r.stages->empty() ? std::optional(r.stages->back().time_step) : std::nullopt;
}

/// Returns all factors whose trials continued until rest, in any variant.
std::set<double> list_runout_factors(const std::vector<StudyRow>& rows) {
  std::set<double> factors;
  for (const StudyRow& row : rows)
    if (row.result && row.result->runouts)
      for (const results::RunoutTrial& t : *row.result->runouts) factors.insert(t.trial.factor);
  return factors;
}

/// Words of the patterns of movement in the table, in the order of the enumerators.
constexpr const char* patterns[] = {
    "none", "one monitor only", "together", "from the bottom upwards", "from the top downwards", "in no such order"};

/// Returns why the criteria on the curve gave no factor.
std::string explain_missing_factors(const RunResult& r, const std::string& label) {
  if (!r.factor_of_safety || !r.factor_of_safety->criteria) return "";
  std::string remarks;
  for (const results::Criterion& c : *r.factor_of_safety->criteria)
    if (!c.factor && c.kind != results::CriterionKind::frozen)
      remarks += fmt::format("- {}: no factor of safety by the {} criterion: {}\n", label, to_word(c.kind), c.note);
  return remarks;
}

StudyColumn begin_column(const std::string& name, const std::string& title, const std::string& unit) {
  return {name, title, unit, {}, ColumnKind::other, ""};
}

/// A factor with a column.
struct FactorColumn {
  const char *name, *title;
};
constexpr FactorColumn governing_factor{"main_factor", "governing"};
/// F of a set with a resistance factor is compared with γ_R;e, so that only this ratio is comparable between sets.
constexpr FactorColumn over_design{"partial_factors.over_design", "over-design factor F/γ_R"};
constexpr FactorColumn slice_factors[] = {{"lem.fellenius", "Fellenius"},
                                          {"lem.bishop", "Bishop"},
                                          {"lem.janbu", "Janbu"},
                                          {"lem.janbu_corrected", "Janbu, corrected"},
                                          {"lem.spencer", "Spencer"},
                                          {"lem.morgenstern_price", "Morgenstern–Price"},
                                          {"lem.morgenstern_price_constant", "Morgenstern–Price, constant"},
                                          {"lem.corps_1", "Corps of Engineers #1"},
                                          {"lem.corps_2", "Corps of Engineers #2"},
                                          {"lem.lowe_karafiath", "Lowe–Karafiath"},
                                          {"lem.modified_swedish", "Modified Swedish"},
                                          {"lem.noncircular.spencer", "Spencer, non-circular"},
                                          {"lem.noncircular.morgenstern_price", "Morgenstern–Price, non-circular"}};
/// Results that repeat the factor of another one.
constexpr const char* repeated_factors[] = {governing_factor.name, "lem.factor"};
constexpr FactorColumn element_factors[] = {{"fem.factor", "finite elements"},
                                            {"fem.by_displacement", "finite elements, displacement"},
                                            {"fem.associated.factor", "finite elements, ψ = φ"}};

std::string name_factor_column(const std::string& title) {
  return "FoS, " + title;
}

/// Adds columns of numbers to a table.
class Columns {
 public:
  explicit Columns(const std::vector<StudyRow>& rows) : rows_(rows) {}

  using Getter = std::function<std::optional<double>(const RunResult&)>;
  /// Adds a column. `format` is that of the displayed number, `{:.3f}`; the numbers are SI and displayed in `unit`.
  void add(const std::string& name, const std::string& unit, const char* format, bool always, const Getter& get,
           ColumnKind kind = ColumnKind::other) {
    StudyColumn column = begin_column(name, name, unit);
    column.kind = kind;
    const double factor = unit.empty() ? 1 : units::get_si_factor(unit);
    bool any = false;
    for (const StudyRow& row : rows_) {
      std::optional<double> value;
      if (row.result) value = get(*row.result);
      any = any || value;
      column.cells.push_back(
          value ? StudyCell{write_shortest(*value / factor), fmt::format(fmt::runtime(format), *value / factor)}
                : StudyCell{});
    }
    if (any || always) table.push_back(std::move(column));
  }

  /// Adds the measure `key` of a runout. A cell says "not determined" where the two meshes do not determine it.
  void add_measure(const std::string& name, const std::string& unit, const char* format, const char* key,
                   const std::function<const Runout*(const RunResult&)>& find, ColumnKind kind = ColumnKind::other) {
    const auto get_estimate = [&](const RunResult& r) -> std::optional<results::Estimate> {
      const Runout* runout = find(r);
      return runout != nullptr ? std::optional(*results::RunoutEstimates(*runout).find(key)) : std::nullopt;
    };
    const auto is_open = [&](const StudyRow& row) {
      const auto estimate = row.result ? get_estimate(*row.result) : std::nullopt;
      return estimate && !estimate->is_determined();
    };
    const std::size_t count = table.size();
    add(
        name, unit, format, std::any_of(rows_.begin(), rows_.end(), is_open),
        [&](const RunResult& r) {
          const auto estimate = get_estimate(r);
          return estimate && estimate->is_determined() ? std::optional(estimate->value) : std::nullopt;
        },
        kind);
    if (table.size() == count) return;
    for (std::size_t i = 0; i < rows_.size(); ++i)
      if (is_open(rows_[i])) table.back().cells[i].shown = "not determined";
  }

  /// Adds the factor of safety with the result name `name`.
  void add_factor(const std::string& title, const std::string& name, ColumnKind kind = ColumnKind::factor) {
    const std::size_t count = table.size();
    add(
        name_factor_column(title), "", "{:.3f}", false, [&](const RunResult& r) { return run::find_result(r, name); },
        kind);
    if (table.size() > count) table.back().by = title;
  }

  /// Adds a column for every governing factor that no other column has, such as that of a surface of the case.
  void add_missing_factors() {
    constexpr int plane = 2;  // factors have no unit
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (!rows_[i].result) continue;
      const auto main = run::find_result(*rows_[i].result, governing_factor.name);
      if (!main || has_factor(i, write_shortest(*main))) continue;
      for (const results::NamedValue& value : results::list_values(*rows_[i].result, plane)) {
        const bool repeats = std::find(std::begin(repeated_factors), std::end(repeated_factors), value.name) !=
                             std::end(repeated_factors);
        if (value.kind != results::ResultKind::factor || repeats || value.value != *main) continue;
        add_factor(value.title, value.name, ColumnKind::other);
        break;
      }
    }
  }

  std::vector<StudyColumn> table;

 private:
  /// Returns true if a factor other than the governing one has this number in row `i`.
  bool has_factor(std::size_t i, const std::string& number) const {
    return std::any_of(table.begin(), table.end(), [&](const StudyColumn& column) {
      return !column.by.empty() && column.kind != ColumnKind::governing && column.cells[i].full == number;
    });
  }

  const std::vector<StudyRow>& rows_;
};

/// Escapes text for a Markdown table.
std::string write_cell(const std::string& text) {
  std::string cell;
  for (const char c : text) cell += c == '|' ? "\\|" : c == '\n' ? " " : std::string(1, c);
  return cell.empty() ? "–" : cell;
}

/// Adds onset and displacement of every monitor, the displacement also over that of the reference if the monitor moved
/// there, and the order of movement.
void add_motion(const StudyPlan& plan, const std::vector<StudyRow>& rows, Columns& columns) {
  for (const std::string& name : plan.monitors)
    columns.add("onset of " + name, "s", "{:.4g}", false,
                [&](const RunResult& r) { return run::find_result(r, fmt::format("onset[{}]", name)); });
  for (const std::string& name : plan.monitors) {
    const auto get_end = [&](const RunResult& r) { return run::find_result(r, fmt::format("displacement[{}]", name)); };
    columns.add("displacement of " + name, plan.summary.units.displacement, "{:.4g}", false, get_end);
    const auto& base = rows[plan.reference].result;
    const bool moves = base && run::find_result(*base, fmt::format("onset[{}]", name));
    const std::optional<double> reference = moves ? get_end(*base) : std::nullopt;
    columns.add(
        fmt::format("displacement of {} over that of {}", name, plan.variants[plan.reference].label), "", "{:.3f}",
        false,
        [&](const RunResult& r) {
          const std::optional<double> value = get_end(r);
          return value && reference && *reference > 0 ? std::optional(*value / *reference) : std::nullopt;
        },
        ColumnKind::ratio);
  }
  StudyColumn order = begin_column("order of movement", "order of movement", "");
  for (const StudyRow& row : rows) {
    const std::string words =
        row.result && row.result->motion ? patterns[static_cast<int>(row.result->motion->pattern)] : "";
    order.cells.push_back({words, words});
  }
  const auto is_empty = [](const StudyCell& cell) { return cell.full.empty(); };
  if (!std::all_of(order.cells.begin(), order.cells.end(), is_empty)) columns.table.push_back(std::move(order));
}

}  // namespace

std::vector<StudyColumn> make_study_table(const StudyPlan& plan, const std::vector<StudyRow>& rows) {
  Columns columns(rows);
  StudyColumn names = begin_column("variant", "variant", ""), ends = begin_column("result", "result", "");
  for (const StudyRow& row : rows) {
    names.cells.push_back({row.summary.folder, row.summary.name});
    ends.cells.push_back({to_word(row.summary.status), to_word(row.summary.status)});
  }
  columns.table.push_back(std::move(names));
  for (std::size_t k = 0; k < plan.names.size(); ++k) {
    StudyColumn column = begin_column(plan.summary.vary[k].key, plan.names[k], plan.summary.vary[k].unit);
    for (const Variant& v : plan.variants) column.cells.push_back({v.values[k], v.values[k]});
    columns.table.push_back(std::move(column));
  }
  for (const double f : plan.factors)
    columns.add(fmt::format("displacement at SRF {:g}", f), plan.summary.units.displacement, "{:.4g}", true,
                [f](const RunResult& r) { return get_displacement(r, f); });
  columns.add_factor(governing_factor.title, governing_factor.name, ColumnKind::governing);
  columns.add(over_design.title, "", "{:.3f}", false,
              [](const RunResult& r) { return run::find_result(r, over_design.name); });
  for (const char* criterion : {"frozen", "bilinear", "displacement", "jump"})
    columns.add_factor(criterion, std::string("factor_of_safety.") + criterion);
  for (const FactorColumn& f : slice_factors) columns.add_factor(f.title, f.name, ColumnKind::other);
  for (const FactorColumn& f : element_factors) columns.add_factor(f.title, f.name);
  columns.add_missing_factors();
  for (const double f : list_runout_factors(rows))
    columns.add_measure(
        fmt::format("front advance at SRF {:g}", f), plan.summary.units.length, "{:.3g}", "front_advance",
        [f](const RunResult& r) { return find_runout_at(r, f); }, ColumnKind::runout);
  add_motion(plan, rows, columns);
  columns.add(
      "largest displacement", plan.summary.units.displacement, "{:.4g}", false,
      [](const RunResult& r) { return get(r.runout, &Runout::largest_displacement); }, ColumnKind::displacement);
  columns.add_measure("front advance", plan.summary.units.length, "{:.3g}", "front_advance", find_runout,
                      ColumnKind::runout);
  columns.add_measure("runout beyond the toe", plan.summary.units.length, "{:.3g}", "toe_distance", find_runout);
  columns.add_measure("crest retreat", plan.summary.units.length, "{:.3g}", "crest_retreat", find_runout);
  columns.add("advance of the centre", plan.summary.units.length, "{:.3g}", false,
              [](const RunResult& r) { return get(r.runout, &Runout::centre_advance); });
  const bool plane = std::all_of(rows.begin(), rows.end(), [](const StudyRow& row) {
    return !row.result || !row.result->mesh || row.result->mesh->dimension == 2;
  });
  columns.add_measure("moved volume", plane ? "m3/m" : "m3", "{:.4g}", "moved_volume", find_runout);
  columns.add_measure("volume over the old ground", plane ? "m3/m" : "m3", "{:.4g}", "deposit_volume", find_runout);
  for (const auto& [name, number] : {std::pair{"points", &results::Mesh::points},
                                     {"elements with soil", &results::Mesh::soil_elements},
                                     {"elements", &results::Mesh::elements}})
    columns.add(name, "", "{:.0f}", false, [n = number](const RunResult& r) { return get(r.mesh, n); });
  columns.add("time step", "s", "{:.3g}", false, get_time_step);
  columns.add("wall time", "s", "{:.3g}", false,
              [](const RunResult& r) { return get(r.timing, &results::Timing::wall); });
  columns.table.push_back(std::move(ends));
  if (plan.summary.back_analysis) add_back_analysis(*plan.summary.back_analysis, columns.table);
  return columns.table;
}

std::string find_result_column(const std::string& name) {
  if (name == governing_factor.name) return name_factor_column(governing_factor.title);
  if (name == over_design.name) return over_design.title;
  for (const auto& list :
       {std::span<const FactorColumn>(slice_factors), std::span<const FactorColumn>(element_factors)})
    for (const FactorColumn& f : list)
      if (name == f.name) return name_factor_column(f.title);
  return name;
}

std::string write_study_csv(const std::vector<StudyColumn>& table) {
  std::string text;
  for (const StudyColumn& c : table)
    text += (text.empty() ? "" : ",") + output::quote_field(output::make_label(c.name, c.unit));
  text += '\n';
  for (std::size_t i = 0; i < table[0].cells.size(); ++i) {
    for (std::size_t k = 0; k < table.size(); ++k)
      text += (k == 0 ? "" : ",") + output::quote_field(table[k].cells[i].full);
    text += '\n';
  }
  return text;
}

std::string write_study_markdown(const StudyPlan& plan, const std::vector<StudyRow>& rows,
                                 const results::StudyResult& study) {
  std::string text = fmt::format("# {}\n\n", study.title.empty() ? "Study" : study.title);
  text += "Varied:";
  for (const results::StudyKey& key : study.vary)
    text += fmt::format("{} `{}`", &key == study.vary.data() ? "" : ",", key.key);
  text += ".\n";
  if (study.back_analysis) {
    for (const std::string& sentence : study.back_analysis->sentences) text += fmt::format("\n{}\n", sentence);
    if (const std::string targets = write_targets(*study.back_analysis); !targets.empty()) text += "\n" + targets;
  }
  text += "\n|";
  for (const StudyColumn& c : study.columns)
    text += fmt::format(" {} |", write_cell(output::make_label(c.title, c.unit)));
  text += "\n|";
  for (const StudyColumn& c : study.columns)
    text += &c == &study.columns.front() || &c == &study.columns.back() ? "---|" : "--:|";
  text += '\n';
  for (std::size_t i = 0; i < rows.size(); ++i) {
    text += '|';
    for (const StudyColumn& c : study.columns) text += fmt::format(" {} |", write_cell(c.cells[i].shown));
    text += '\n';
  }
  std::string remarks;
  for (const StudyRow& row : rows) {
    const std::string& label = row.summary.name;
    if (!row.summary.reason.empty()) remarks += fmt::format("- {}: {}\n", label, row.summary.reason);
    if (!row.result) continue;
    for (const std::string& warning : row.result->warnings) remarks += fmt::format("- {}: {}\n", label, warning);
    remarks += explain_missing_factors(*row.result, label);
    if (row.summary.status != results::VariantStatus::finished || !row.result->curve) continue;
    for (const double f : plan.factors)
      if (!get_displacement(*row.result, f)) remarks += fmt::format("- {}: no trial at SRF {:g}\n", label, f);
  }
  for (const std::string& note : study.notes) remarks += fmt::format("- {}\n", note);
  if (study.extrapolation) text += write_extrapolation_markdown(*study.extrapolation, plan.names[*plan.extrapolated]);
  return text + (remarks.empty() ? "" : "\n" + remarks);
}

results::StudyResult describe_study(const StudyPlan& plan, const std::vector<StudyRow>& rows) {
  results::StudyResult study = plan.summary;
  study.reference = plan.variants[plan.reference].label;
  for (const Variant& v : plan.variants)
    for (std::size_t k = 0; k < v.values.size(); ++k)
      if (std::vector<std::string>& values = study.vary[k].values;
          std::find(values.begin(), values.end(), v.values[k]) == values.end())
        values.push_back(v.values[k]);
  study.columns = make_study_table(plan, rows);
  for (const StudyRow& row : rows) study.variants.push_back(row.summary);
  study.extrapolation = extrapolate_factors(plan, study.columns);
  return study;
}

void write_study_tables(const StudyPlan& plan, const std::vector<StudyRow>& rows, const std::filesystem::path& folder) {
  const std::string safe = "the results of the variants are complete";
  const results::StudyResult study = describe_study(plan, rows);
  write_atomically(folder / "study.csv", write_study_csv(study.columns), safe);
  results::write_file(folder / "study.json", study, 2, safe);
  write_atomically(folder / "study.md", make_printable(write_study_markdown(plan, rows, study), true), safe);
}

// The following functions draw the curves of all variants of a study, and the displacement of each monitor over time.

namespace {

namespace fs = std::filesystem;

/// Displacements below this fraction of the largest one are rounding errors of a slope at rest, which would fill a
/// logarithmic axis.
constexpr double smallest_share = 1e-5;

}  // namespace

void draw_study(const StudyPlan& plan, const std::vector<StudyRow>& rows, const std::filesystem::path& picture) {
  output::TablePlot plot;
  plot.title = plan.summary.title;
  plot.x_label = "strength reduction factor";
  plot.y_label = output::make_label("displacement", plan.summary.units.displacement);
  plot.log_y = true;  // displacements of the variants differ by powers of ten
  const double unit = units::get_si_factor(plan.summary.units.displacement);
  double largest = 0;
  for (const StudyRow& row : rows)
    if (row.result && row.result->curve)
      for (const results::Trial& t : row.result->curve->points) largest = std::max(largest, t.displacement / unit);
  for (const StudyRow& row : rows) {
    if (!row.result || !row.result->curve) continue;
    output::PlotSeries series{row.summary.name, {}, {}};
    for (const results::Trial& t : row.result->curve->points) {
      if (!(t.displacement / unit > smallest_share * largest)) continue;
      series.x.push_back(t.factor);
      series.y.push_back(t.displacement / unit);
    }
    if (!series.x.empty()) plot.series.push_back(std::move(series));
  }
  if (!plot.series.empty()) output::draw(plot, picture);
}

void draw_motion(const StudyPlan& plan, const std::vector<StudyRow>& rows, const fs::path& folder) {
  const double unit = units::get_si_factor(plan.summary.units.displacement);
  std::set<std::string> names;
  for (const std::string& monitor : plan.monitors) {
    output::TablePlot plot;
    plot.title = plan.summary.title.empty() ? monitor : fmt::format("{}: {}", plan.summary.title, monitor);
    plot.is_history = true;
    plot.x_label = "time [s]";
    plot.y_label = output::make_label("displacement", plan.summary.units.displacement);
    for (const StudyRow& row : rows) {
      const fs::path file = join_name(folder, row.summary.folder) / "monitors.csv";
      if (!row.result || !row.result->clock || !fs::exists(file)) continue;
      const results::Clock& clock = *row.result->clock;
      const run::MonitorPath path = run::read_monitor_path(output::read_history(file), monitor, clock);
      output::PlotSeries series{row.summary.name, path.time, path.displacement};
      for (double& u : series.y) u /= unit;
      plot.series.push_back(std::move(series));
    }
    const std::string name = take_file_name("displacement_" + monitor, "", names);
    if (!plot.series.empty()) output::draw(plot, join_name(folder, name, ".svg"));
  }
}

void write_study(const StudyPlan& plan, const std::vector<StudyRow>& rows, const fs::path& folder) {
  write_study_tables(plan, rows, folder);
  draw_study(plan, rows, folder / "study.svg");
  draw_motion(plan, rows, folder);
}

}  // namespace talus::study
