// SPDX-License-Identifier: MIT
#include "output/plots/point_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "output/plots/gnuplot.hpp"

namespace talus::output {
namespace {

constexpr double panel_top = 44, panel_row = 350, panel_above = 14, panel_below = 62, foot = 8;  ///< [px]
constexpr double panel_width = 400, left_margin = 84, panel_gap = 92, legend_gap = 24;
constexpr double line_sample = 48;

struct AxisRange {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
};

AxisRange find_axis_range(const std::vector<std::vector<double>>& lists, bool positive) {
  AxisRange range;
  for (const auto& list : lists)
    for (const double v : list)
      if (std::isfinite(v) && (!positive || v > 0)) range = {std::min(range.low, v), std::max(range.high, v)};
  return range.low <= range.high ? range : AxisRange{positive ? 1.0 : 0.0, 1};
}

/// Adds a margin around the values; the axis of a constant zero has a finite length.
AxisRange widen(AxisRange range, bool logarithmic) {
  if (logarithmic) return {range.low / 1.15, range.high * 1.15};
  const double length = range.high - range.low, size = std::max(std::abs(range.low), std::abs(range.high));
  const double pad = length > 1e-9 * size ? 0.04 * length : std::max(0.05 * size, 1e-3);
  // There is no margin at an end at zero.
  return {range.low == 0 && length > 0 ? 0 : range.low - pad, range.high == 0 && length > 0 ? 0 : range.high + pad};
}

/// Returns the tics of a logarithmic axis: powers of ten, with 2 and 5 times them if there are few; equal steps within
/// less than one decade.
std::string list_log_tics(AxisRange x) {
  std::string tics;
  const auto add = [&](double at) {
    if (at >= x.low && at <= x.high) tics += fmt::format("{}'{:g}' {:.10g}", tics.empty() ? "" : ", ", at, at);
  };
  if (x.high < 5 * x.low) {
    const double step = find_tic_step(x.high - x.low, 5);
    for (double k = std::ceil(x.low / step); k * step <= x.high; ++k) add(k * step);
    return tics;
  }
  for (int power = static_cast<int>(std::floor(std::log10(x.low))); power <= std::log10(x.high); ++power)
    for (const int digit : {1, 2, 5})
      if (digit == 1 || x.high < 100 * x.low) add(digit * std::pow(10, power));
  return tics;
}

std::string name_data(std::size_t diagram, std::size_t line) {
  return fmt::format("d{}_{}", diagram, line);
}

std::string style_line(const PointLine& line) {
  return fmt::format("with lines linewidth 1.8 dashtype {} linecolor rgb '{}'", line.dash % 5 + 1,
                     line_colours[static_cast<std::size_t>(line.colour) % std::size(line_colours)]);
}

std::string draw_diagram(const PointPlot& plot, std::size_t number, double width, double height) {
  const PointDiagram& d = plot.diagrams[number];
  const std::size_t row = number / 2, column = number % 2;
  const double left = left_margin + static_cast<double>(column) * (panel_width + panel_gap);
  const double row_top = panel_top + static_cast<double>(row) * panel_row;
  const AxisRange x = widen(find_axis_range(d.x, d.log_x), d.log_x), y = widen(find_axis_range(d.y, false), false);
  std::string script = fmt::format(
      "unset label\nset lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\nset tmargin at screen {:.5f}\n"
      "set bmargin at screen {:.5f}\nset xlabel {} textcolor rgb '{}'\nset ylabel {} textcolor rgb '{}'\n",
      left / width, (left + panel_width) / width, 1 - (row_top + panel_above) / height,
      1 - (row_top + panel_row - panel_below) / height, quote(d.x_label), text_colour, quote(d.y_label), text_colour);
  if (number == 0)
    script += fmt::format("set label {} at screen {:.5f}, screen {:.5f} left font title_font textcolor rgb '{}'\n",
                          quote(plot.title), left_margin / width, 1 - 24 / height, text_colour);
  script += fmt::format("set xrange [{:.10g}:{:.10g}]\nset yrange [{:.10g}:{:.10g}]\n", x.low, x.high, y.low, y.high);
  script += d.log_x ? "set logscale x\nset format x '%g'\nset xtics (" + list_log_tics(x) + ")\n"
                    : "unset logscale x\n" + make_tics("x", x.high - x.low, 6);
  script += make_tics("y", y.high - y.low, 7);
  std::string layers;
  for (std::size_t i = 0; i < plot.lines.size(); ++i)
    layers += fmt::format("{}${} using 1:2 {} notitle", layers.empty() ? "plot " : ", \\\n     ", name_data(number, i),
                          style_line(plot.lines[i]));
  return script + layers + "\n";
}

/// Draws the legend in a column of its own: a last, empty diagram.
std::string draw_legend(const PointPlot& plot, double width, double height) {
  const double left = left_margin + 2 * panel_width + panel_gap + legend_gap;
  std::string script = fmt::format(
      "unset label\nunset border\nunset tics\nunset grid\nunset xlabel\nunset ylabel\nunset logscale x\n"
      "set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\nset tmargin at screen {:.5f}\n"
      "set bmargin at screen {:.5f}\nset xrange [0:1]\nset yrange [0:1]\n"
      "set key at screen {:.5f}, screen {:.5f} left top Left reverse samplen 3 spacing 1.25 textcolor rgb '{}'\n",
      left / width, 1.0, 1 - panel_top / height, foot / height, left / width, 1 - (panel_top + panel_above) / height,
      text_colour);
  std::string layers;
  for (const PointLine& line : plot.lines)
    layers +=
        fmt::format("{}NaN {} title {}", layers.empty() ? "plot " : ", \\\n     ", style_line(line), quote(line.label));
  return script + layers + "\n";
}

}  // namespace

void draw(const PointPlot& plot, const std::filesystem::path& picture) {
  if (plot.lines.empty() || plot.diagrams.empty()) fail_input("element tests cannot be drawn: there are none");
  double widest = 0;
  for (const PointLine& line : plot.lines) widest = std::max(widest, estimate_width(line.label));
  const double width = left_margin + 2 * panel_width + panel_gap + legend_gap + line_sample + widest + 24;
  const double rows = std::ceil(static_cast<double>(plot.diagrams.size()) / 2);
  const double height =
      std::max(panel_top + rows * panel_row + foot, panel_top + 24.0 * static_cast<double>(plot.lines.size()));
  std::string script;
  for (std::size_t d = 0; d < plot.diagrams.size(); ++d)
    for (std::size_t i = 0; i < plot.lines.size(); ++i)
      script += make_data(name_data(d, i), {plot.diagrams[d].x[i], plot.diagrams[d].y[i]});
  script += fmt::format(
      "set border 3 linecolor rgb '{0}'\nset tics nomirror out scale 0.6,0.3 textcolor rgb '{0}'\n"
      "set grid xtics ytics linetype 1 linewidth 0.7 linecolor rgb '{1}'\nunset key\nset multiplot\n",
      text_colour, grid_colour);
  for (std::size_t d = 0; d < plot.diagrams.size(); ++d) script += draw_diagram(plot, d, width, height);
  script += draw_legend(plot, width, height);
  run_gnuplot(picture, script + "unset multiplot\n", static_cast<int>(width), static_cast<int>(height));
}

}  // namespace talus::output
