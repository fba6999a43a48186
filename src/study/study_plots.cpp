// SPDX-License-Identifier: MIT
// The curves of all variants of a study, and the displacement of each monitor over time, as pictures.

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/file_name.hpp"
#include "base/units.hpp"
#include "output/plots/curve_plot.hpp"
#include "output/plots/gnuplot.hpp"
#include "run/mpm/record/motion.hpp"
#include "study/study_table.hpp"

namespace talus::study {
namespace {

namespace fs = std::filesystem;

/// Displacements below this share of the largest one are rounding errors of a slope at rest; a logarithmic axis would
/// be all theirs.
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
