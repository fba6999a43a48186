// The displacement of each monitor over time in all variants of a study, as pictures.

#include <fmt/format.h>

#include <algorithm>

#include "base/units.hpp"
#include "output/plots/curve_plot.hpp"
#include "output/plots/gnuplot.hpp"
#include "run/mpm/record/motion.hpp"
#include "study/study_table.hpp"

namespace talus::study {
namespace {

namespace fs = std::filesystem;

/// A monitor's name as a part of a file's.
std::string make_file_name(const std::string& monitor) {
  std::string name = monitor;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '/' || c == '\\' || c == ' ' || c == '\''; }, '_');
  return "displacement_" + name + ".svg";
}

}  // namespace

void draw_motion(const StudyPlan& plan, const std::vector<StudyRow>& rows, const fs::path& folder) {
  const double unit = units::get_si_factor(plan.displacement_unit);
  for (const std::string& monitor : plan.monitors) {
    output::TablePlot plot;
    plot.title = plan.title.empty() ? monitor : fmt::format("{}: {}", plan.title, monitor);
    plot.is_history = true;
    plot.x_label = "time [s]";
    plot.y_label = output::make_label("displacement", plan.displacement_unit);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const fs::path file = folder / plan.variants[i].name / "monitors.csv";
      if (!rows[i].result || !rows[i].result->clock || !fs::exists(file)) continue;
      const results::Clock& clock = *rows[i].result->clock;
      const run::MonitorPath path = run::read_monitor_path(output::read_history(file), monitor, clock);
      output::PlotSeries series{plan.variants[i].label, path.time, path.displacement};
      for (double& u : series.y) u /= unit;
      plot.series.push_back(std::move(series));
    }
    if (!plot.series.empty()) output::draw(plot, folder / make_file_name(monitor));
  }
}

}  // namespace talus::study
