// SPDX-License-Identifier: MIT
#include "output/plots/curve_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "output/plots/gnuplot.hpp"

namespace talus::output {
namespace {

constexpr int width = 900, height = 600;  ///< [px]
constexpr double left = 90, bottom = 70, row_height = 22;

const char* series_colour(std::size_t i) {
  return line_colours[i % std::size(line_colours)];
}

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
  void include(double v) {
    if (!std::isfinite(v)) return;
    low = std::min(low, v);
    high = std::max(high, v);
  }
  void include(const std::vector<double>& values) {
    for (const double v : values) include(v);
  }
  double length() const { return high - low; }
};

/// Label of a factor, and its row above the frame.
struct Flag {
  FactorMark mark;
  std::string text;
  std::size_t order;  ///< index in the list of the case, which determines the colour
  int row = 0;
};

/// Assigns rows to the labels so that none covers another label or its line. From the right, each label is placed above
/// the lines that it crosses.
std::vector<Flag> place_flags(const std::vector<FactorMark>& criteria, double pixels_per_unit) {
  std::vector<Flag> flags;
  for (const FactorMark& mark : criteria)
    flags.push_back({mark, fmt::format("{:.2f}  {}", mark.factor, to_words(mark.name)), flags.size(), 0});
  std::ranges::stable_sort(flags, [](const Flag& a, const Flag& b) { return a.mark.factor > b.mark.factor; });
  for (std::size_t i = 0; i < flags.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if ((flags[k].mark.factor - flags[i].mark.factor) * pixels_per_unit < estimate_width(flags[i].text) + 16)
        flags[i].row = std::max(flags[i].row, flags[k].row + 1);
  return flags;
}

std::string draw_flags(const std::vector<Flag>& flags, double top) {
  std::string script;
  for (const Flag& flag : flags) {
    const double y = 1 - (top - row_height * (flag.row + 0.6)) / height;
    const std::string x = fmt::format("{:.10g}", flag.mark.factor);
    if (flag.mark.lower && flag.mark.upper && *flag.mark.upper > *flag.mark.lower)
      script += fmt::format(
          "set object rectangle from {:.10g}, graph 0 to {:.10g}, graph 1 behind fillcolor rgb '{}' fillstyle solid "
          "0.15 noborder\n",
          *flag.mark.lower, *flag.mark.upper, series_colour(flag.order));
    script += fmt::format(
        "set arrow from {0}, graph 0 to {0}, screen {1:.5f} nohead front linewidth 1.5 dashtype 2 linecolor rgb "
        "'{2}'\n",
        x, y, series_colour(flag.order));
    script += fmt::format("set label {} at {}, screen {:.5f} left offset 0.6,0 front textcolor rgb '{}'\n",
                          quote(flag.text), x, y, series_colour(flag.order));
  }
  return script;
}

/// Samples a line over [from, to] where its value is between `floor` and `ceiling`.
PlotSeries sample(const results::Branch& line, double from, double to, double floor, double ceiling) {
  PlotSeries s;
  for (int i = 0; i <= 200; ++i) {
    const double x = from + (to - from) * i / 200, y = line.slope * x + line.intercept;
    if (y > floor && y <= ceiling) s.x.push_back(x), s.y.push_back(y);
  }
  return s;
}

std::vector<double> scale(std::vector<double> values, double factor) {
  for (double& v : values) v *= factor;
  return values;
}

/// Returns the points of the curve at `abscissae`, to which a line was fitted.
PlotSeries pick(const CurvePlot& plot, const std::vector<double>& abscissae) {
  PlotSeries s;
  for (std::size_t i = 0; i < plot.factors.size(); ++i)
    for (const double x : abscissae)
      if (std::abs(plot.factors[i] - x) < 1e-9 * std::max(1.0, std::abs(x))) {
        s.x.push_back(x);
        s.y.push_back(plot.displacements[i] * plot.units_per_metre);
        break;
      }
  return s;
}

std::string make_frame(const std::string& title, const std::string& x_label, const std::string& y_label, double right,
                       double top) {
  std::string script = fmt::format(
      "set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\nset bmargin at screen {:.5f}\n"
      "set tmargin at screen {:.5f}\n",
      left / width, 1 - right / width, bottom / height, 1 - top / height);
  script += fmt::format(
      "set border 3 linecolor rgb '{0}'\nset tics nomirror out scale 0.6 textcolor rgb '{0}'\n"
      "set grid ytics linetype 1 linewidth 0.7 linecolor rgb '{1}'\n",
      text_colour, grid_colour);
  script += fmt::format("set xlabel {} textcolor rgb '{}'\n", quote(x_label), text_colour);
  script += fmt::format("set ylabel {} textcolor rgb '{}'\n", quote(y_label), text_colour);
  if (!title.empty())
    script += fmt::format("set label {} at screen {:.5f}, screen {:.5f} left font title_font textcolor rgb '{}'\n",
                          quote(title), left / width, 1 - 24.0 / height, text_colour);
  return script;
}

/// Data blocks and plot clauses, collected together so that their names match.
class Layers {
 public:
  void add(const PlotSeries& s, const std::string& style, const std::string& label = "") {
    if (s.x.empty()) return;
    const std::string name = fmt::format("data{}", count_++);
    data_ += make_data(name, {s.x, s.y});
    plot_ += fmt::format("{}${} using 1:2 {} {}", plot_.empty() ? "plot " : ", \\\n     ", name, style,
                         label.empty() ? "notitle" : "title " + quote(label));
  }
  std::string text() const { return data_ + plot_ + "\n"; }

 private:
  std::string data_, plot_;
  int count_ = 0;
};

std::string line_style(const char* c) {
  return fmt::format("with lines linewidth 2 linecolor rgb '{}'", c);
}
std::string point_style(const char* c, int type, double size) {
  return fmt::format("with points pointtype {} pointsize {} linewidth 1.5 linecolor rgb '{}'", type, size, c);
}

}  // namespace

void draw(const CurvePlot& plot, const std::filesystem::path& picture) {
  if (plot.factors.empty() || plot.factors.size() != plot.displacements.size())
    fail_input("a displacement curve without points cannot be drawn");
  const double unit = plot.units_per_metre;
  const PlotSeries curve{"", plot.factors, scale(plot.displacements, unit)};
  std::vector<FactorMark> criteria = plot.criteria;
  const bool known = std::ranges::any_of(criteria, [&plot](const FactorMark& m) {
    return plot.intersection && std::abs(m.factor - *plot.intersection) < 1e-9;
  });
  if (plot.intersection && !known) criteria.push_back({"intersection of the two lines", *plot.intersection, {}, {}});

  Range x, y;
  x.include(curve.x);
  y.include(curve.y);
  for (const FactorMark& m : criteria) x.include(m.factor);
  for (const PlotSeries& s : plot.references) x.include(s.x), y.include(scale(s.y, unit));
  const double pad = 0.03 * (x.length() > 0 ? x.length() : 1);
  x.include(x.low - pad);
  x.include(x.high + pad);
  double smallest = std::numeric_limits<double>::infinity();
  for (const double v : curve.y)
    if (v > 0) smallest = std::min(smallest, v);
  const bool logarithmic = plot.log_displacement && std::isfinite(smallest);
  const double y_low = logarithmic ? smallest / 2 : std::min(0.0, 1.05 * y.low);
  const double y_high = logarithmic ? 2 * y.high : y.high > 0 ? 1.06 * y.high : 1;

  // Margin for labels near the right end. It changes the scale, so it is estimated first, on the safe side.
  double right = 30;
  for (const FactorMark& m : criteria) {
    const double from_end = (x.high - m.factor) / x.length() * (width - left - right);
    right = std::max(right, std::min(260.0, estimate_width(fmt::format("1.23  {}", m.name)) + 12 - from_end));
  }
  const std::vector<Flag> flags = place_flags(criteria, (width - left - right) / x.length());
  int rows = 0;
  for (const Flag& flag : flags) rows = std::max(rows, flag.row + 1);
  const double top = (plot.title.empty() ? 16 : 46) + row_height * rows + (rows > 0 ? 6 : 0);

  std::string script = make_frame(plot.title, "strength reduction factor",
                                  make_label("displacement", plot.displacement_unit), right, top);
  script += fmt::format("set xrange [{:.10g}:{:.10g}]\nset yrange [{:.10g}:{:.10g}]\n", x.low, x.high, y_low, y_high);
  script += make_tics("x", x.length(), 11);
  script += logarithmic ? "set logscale y\nset format y '%g'\n" : make_tics("y", y_high - y_low, 8);
  script += "set key top left Left reverse samplen 2.5 spacing 1.3 textcolor rgb '" + std::string(text_colour) + "'\n";
  script += draw_flags(flags, top);

  Layers layers;
  const std::string curve_style = "with linespoints linewidth 1.5 pointtype 7 pointsize 0.6 linecolor rgb '#000000'";
  layers.add(curve, curve_style, plot.references.empty() ? "trials" : "this calculation");
  const double floor = logarithmic ? 0 : y_low;
  if (plot.first && plot.second && plot.intersection) {
    const double reach = 0.12 * x.length();
    results::Branch first = *plot.first, second = *plot.second;
    for (results::Branch* line : {&first, &second}) line->slope *= unit, line->intercept *= unit;
    layers.add(sample(first, x.low, *plot.intersection + reach, floor, y_high), line_style(line_colours[4]),
               "first line");
    layers.add(sample(second, *plot.intersection - reach, x.high, floor, y_high), line_style(line_colours[5]),
               "second line");
  }
  layers.add(curve, curve_style);  // drawn again above the lines; the first one determines the order of the legend
  if (plot.first)
    layers.add(pick(plot, plot.first->factors), point_style(line_colours[4], 6, 1.1), "points of the first line");
  if (plot.second)
    layers.add(pick(plot, plot.second->factors), point_style(line_colours[5], 6, 1.1), "points of the second line");
  if (plot.intersection && plot.first) {
    const double at = (plot.first->slope * *plot.intersection + plot.first->intercept) * unit;
    layers.add({"", {*plot.intersection}, {at}}, point_style("#000000", 12, 1.6));
  }
  for (std::size_t i = 0; i < plot.references.size(); ++i) {
    const PlotSeries& s = plot.references[i];
    constexpr std::array<int, 5> open_markers{4, 8, 10, 12, 2};
    layers.add({"", s.x, scale(s.y, unit)}, point_style("#666666", open_markers[i % open_markers.size()], 0.9),
               s.label);
  }
  run_gnuplot(picture, script + layers.text(), width, height);
}

void draw(const TablePlot& plot, const std::filesystem::path& picture) {
  double widest = 0;
  bool any = false;
  for (const PlotSeries& s : plot.series) {
    widest = std::max(widest, estimate_width(s.label));
    any = any || !s.x.empty();
  }
  if (!any) fail_input("a table without rows cannot be drawn");
  const double right = plot.series.size() > 1 ? std::min(0.45 * width, widest + 75) : 30;
  std::string script = make_frame(plot.title, plot.x_label, plot.y_label, right, plot.title.empty() ? 16 : 46);
  script += fmt::format(
      "set key at screen {:.5f}, graph 1 left top Left reverse samplen 2.5 spacing 1.3 textcolor rgb '{}'\n",
      1 - (right - 12) / width, text_colour);
  if (plot.log_x) script += "set logscale x\n";
  if (plot.log_y) script += "set logscale y\n";
  script += plot.is_history ? "set offsets 0, graph 0.03, graph 0.05, 0\nset xrange [0:*]\nset yrange [0:*]\n"
                            : "set offsets graph 0.03, graph 0.03, graph 0.05, graph 0.05\n";
  Layers layers;
  constexpr std::array<int, 6> markers{7, 5, 9, 11, 13, 6};  // circle, square, triangles, diamond, ring
  for (std::size_t i = 0; i < plot.series.size(); ++i)
    layers.add(
        plot.series[i],
        fmt::format("with linespoints linewidth 1.8 pointtype {} pointsize 0.8 pointinterval {} linecolor rgb '{}'",
                    markers[i % markers.size()],
                    plot.is_history ? std::max<std::size_t>(1, plot.series[i].x.size() / 12) : 1, series_colour(i)),
        plot.series.size() > 1 ? plot.series[i].label : "");
  run_gnuplot(picture, script + layers.text(), width, height);
}

}  // namespace talus::output
