// SPDX-License-Identifier: MIT
#include "output/plots/section_plot.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/error.hpp"
#include "base/units.hpp"
#include "output/plots/field_plot.hpp"
#include "output/plots/gnuplot.hpp"

namespace talus::output {
namespace {

constexpr double plot_right = 30, axis = 62, plot_heading = 46;  ///< [px]
constexpr const char* water_colour = "#2f7fd6";
constexpr double legend_row = 22, legend_sample = 48, legend_space = 20;  ///< of the legend [px]

std::string describe(const results::MethodSurface& s) {
  return s.factor ? fmt::format("{:.3f}  {}", *s.factor, s.title) : s.title;
}

/// Returns the line style. Bands of FEM are wide and translucent, since lines of other methods lie on them.
std::string find_style(const results::MethodSurface& s, std::size_t number) {
  const std::size_t colours = std::size(line_colours);
  const std::string colour = line_colours[number % colours];
  if (s.method == Method::fem) return fmt::format("linewidth 7 linecolor rgb '#90{}'", colour.substr(1));
  return fmt::format("linewidth 2 dashtype {} linecolor rgb '{}'", 1 + number / colours, colour);
}

/// The legend in as many columns as fit; its first row is at `top` [px from the lower edge].
class Legend {
 public:
  Legend(const std::vector<results::MethodSurface>& surfaces, double left, double width) : left_(left) {
    for (const results::MethodSurface& s : surfaces)
      column_ = std::max(column_, legend_sample + estimate_width(describe(s)) + legend_space);
    const auto columns = static_cast<std::size_t>(std::max(1.0, std::floor(width / column_)));
    rows_ = (surfaces.size() + columns - 1) / columns;
  }

  double height() const { return legend_row * static_cast<double>(rows_) + 10; }
  double width() const { return column_; }

  std::string draw(const std::vector<results::MethodSurface>& surfaces, double total_width, double total_height) const {
    std::string script;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
      const std::size_t column = i / rows_, row = i % rows_;
      const double x = left_ + column_ * static_cast<double>(column);
      const double y = (height() - legend_row * (static_cast<double>(row) + 0.5)) / total_height;
      script += fmt::format("set arrow from screen {:.6f}, screen {:.6f} to screen {:.6f}, screen {:.6f} nohead {}\n",
                            x / total_width, y, (x + legend_sample - 8) / total_width, y, find_style(surfaces[i], i));
      script += fmt::format("set label {} at screen {:.6f}, screen {:.6f} left textcolor rgb '{}'\n",
                            quote(describe(surfaces[i])), (x + legend_sample) / total_width, y, text_colour);
    }
    return script;
  }

 private:
  double left_;        ///< [px]
  double column_ = 0;  ///< width of a column [px]
  std::size_t rows_ = 0;
};

}  // namespace

void draw(const SectionPlot& plot, const std::filesystem::path& picture) {
  if (plot.surfaces.empty()) fail_input("a section without slip surfaces cannot be drawn");
  const double unit = 1 / units::get_si_factor(plot.length_unit);
  Box box;
  for (const auto& outline : plot.outlines)
    for (const auto& p : outline) box.include(p[0] * unit, p[1] * unit);
  for (const results::MethodSurface& s : plot.surfaces)
    for (const auto& p : s.points) box.include(p[0] * unit, p[1] * unit);
  if (plot.water)
    for (const results::StandingWater& p : plot.water->ponds) {
      box.include(p.from[0] * unit, p.level_from * unit);
      box.include(p.to[0] * unit, p.level_to * unit);
    }
  box.widen(0.02 * std::max(box.x1 - box.x0, box.y1 - box.y0));
  const auto [w, h] = fit_frame(box);
  const double left = find_left_margin(box);
  const Legend legend(plot.surfaces, left, w);
  const double bottom = axis + legend.height();
  const double total_w =
      left + plot_right +
      std::max({w, legend.width(), estimate_width(plot.title) * 14 / 12});  // the font of the title is larger
  const double total_h = bottom + h + plot_heading;

  std::string s = fmt::format(
      "set lmargin at screen {:.6f}\nset rmargin at screen {:.6f}\nset bmargin at screen {:.6f}\n"
      "set tmargin at screen {:.6f}\nset xrange [{:.10g}:{:.10g}]\nset yrange [{:.10g}:{:.10g}]\n",
      left / total_w, (left + w) / total_w, bottom / total_h, (bottom + h) / total_h, box.x0, box.x1, box.y0, box.y1);
  s += fmt::format("set border 3 linecolor rgb '{0}'\nset tics nomirror out scale 0.6 textcolor rgb '{0}'\n",
                   text_colour);
  s += make_tics("x", box.x1 - box.x0, std::max(3.0, w / 80)) + make_tics("y", box.y1 - box.y0, std::max(3.0, h / 40));
  for (const char* name : {"x", "y"})
    s += fmt::format("set {}label {} textcolor rgb '{}'\n", name, quote(make_label(name, plot.length_unit)),
                     text_colour);
  s += fmt::format("set label {} at screen {:.6f}, screen {:.6f} left font title_font textcolor rgb '{}'\n",
                   quote(plot.title), left / total_w, 1 - 22 / total_h, text_colour);
  s += legend.draw(plot.surfaces, total_w, total_h) + "unset key\n";
  std::string plots;
  const auto add = [&](const std::string& name, const std::string& rows, const std::string& style,
                       const char* as = "lines") {
    s += fmt::format("${} << END\n{}END\n", name, rows);
    plots += fmt::format("{}${} using 1:2 with {} {}", plots.empty() ? "plot " : ", \\\n     ", name, as, style);
  };
  std::string soils;
  for (const auto& outline : plot.outlines) soils += draw_line(outline, unit, true);
  if (plot.water) {
    std::string ponds, tables;
    for (const results::StandingWater& p : plot.water->ponds)
      ponds += draw_line({p.from, {p.from[0], p.level_from}, {p.to[0], p.level_to}, p.to}, unit, true);
    for (const auto& line : plot.water->water_table) tables += draw_line(line, unit, false);
    if (!ponds.empty())
      add("ponds", ponds, fmt::format("fillstyle solid 0.25 noborder linecolor rgb '{}'", water_colour),
          "filledcurves");
    if (!tables.empty())
      add("table", tables, fmt::format("linewidth 1.6 dashtype '_._' linecolor rgb '{}'", water_colour), "lines");
  }
  if (!soils.empty()) add("outlines", soils, fmt::format("linewidth 1.2 linecolor rgb '{}'", text_colour));
  // Bands are drawn first, since they are wide.
  for (const bool band : {true, false})
    for (std::size_t i = 0; i < plot.surfaces.size(); ++i)
      if ((plot.surfaces[i].method == Method::fem) == band)
        add(fmt::format("surface{}", i), draw_line(plot.surfaces[i].points, unit, false),
            find_style(plot.surfaces[i], i));
  run_gnuplot(picture, s + plots + "\n", static_cast<int>(std::lround(total_w)),
              static_cast<int>(std::lround(total_h)));
}

}  // namespace talus::output
