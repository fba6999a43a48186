// SPDX-License-Identifier: MIT
#include "output/plots/field_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "base/error.hpp"
#include "output/plots/gnuplot.hpp"

namespace talus::output {

namespace {

constexpr double plot_width = 800, smallest_width = 60, smallest_height = 110, largest_height = 640;  ///< [px]

}  // namespace

FrameSize fit_frame(Box& box) {
  double w = plot_width, h = w * (box.y1 - box.y0) / (box.x1 - box.x0);
  if (h > largest_height) w *= largest_height / h, h = largest_height;
  if (h < smallest_height) {
    const double grow = 0.5 * (smallest_height / h - 1) * (box.y1 - box.y0);
    box.y0 -= grow, box.y1 += grow, h = smallest_height;
  }
  return {std::max(w, smallest_width), h};
}

double find_left_margin(const Box& box) {
  constexpr double margin = 75, digit = 7, usual = 4;
  const auto digits = static_cast<double>(fmt::format("{:.0f}", std::max(std::abs(box.y0), std::abs(box.y1))).size());
  return margin + digit * std::max(0.0, digits - usual);
}

std::string draw_line(const std::vector<results::Point>& points, double unit, bool close) {
  std::string rows;
  for (const auto& p : points) rows += fmt::format("{:.12g} {:.12g}\n", p[0] * unit, p[1] * unit);
  if (close && !points.empty()) rows += fmt::format("{:.12g} {:.12g}\n", points[0][0] * unit, points[0][1] * unit);
  return rows + "\n";
}

namespace {

constexpr double colours_right = 125, axis_bottom = 62;  ///< [px]

// Viridis (van der Walt and Smith 2015, https://bids.github.io/colormap, CC0) at ten equally spaced values.
constexpr const char* viridis =
    "0 '#440154', 1 '#482878', 2 '#3e4a89', 3 '#31688e', 4 '#26828e', 5 '#1f9e89', 6 '#35b779', 7 '#6ece58', 8 "
    "'#b5de2b', 9 '#fde725'";
// RdBu of ColorBrewer (https://colorbrewer2.org), from blue over white to red.
constexpr const char* blue_white_red =
    "0 '#2166ac', 1 '#4393c3', 2 '#92c5de', 3 '#d1e5f0', 4 '#f7f7f7', 5 '#fddbc7', 6 '#f4a582', 7 '#d6604d', 8 "
    "'#b2182b'";

/// Estimates the distance between neighbouring points as the root of the area per point. The covered area is counted in
/// square cells with a few points each.
double estimate_spacing(const std::vector<double>& x, const std::vector<double>& y, const Box& box) {
  const double count = static_cast<double>(x.size());
  const double area = std::max((box.x1 - box.x0) * (box.y1 - box.y0), 0.0);
  if (!(area > 0)) return std::max({box.x1 - box.x0, box.y1 - box.y0, 1e-6}) / std::max(count, 10.0);
  const double cell = 2 * std::sqrt(area / count);
  std::set<std::pair<long, long>> covered;
  for (std::size_t i = 0; i < x.size(); ++i)
    covered.emplace(std::lround(std::floor((x[i] - box.x0) / cell)), std::lround(std::floor((y[i] - box.y0) / cell)));
  return std::sqrt(static_cast<double>(covered.size()) * cell * cell / count);
}

std::array<double, 2> find_range(const FieldPlot& plot, bool diverging) {
  if (plot.range) return *plot.range;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const double v : plot.values)
    if (std::isfinite(v)) low = std::min(low, v), high = std::max(high, v);
  if (low > high) return {0, 1};
  if (diverging) high = std::max(std::abs(low), std::abs(high)), low = -high;
  if (!(high > low)) {  // constant values: gnuplot requires a range
    if (low == 0) return {diverging ? -1.0 : 0.0, 1.0};
    return {low - 0.05 * std::abs(low), high + 0.05 * std::abs(low)};
  }
  return {low, high};
}

bool is_signed(const std::vector<double>& values) {
  double low = 0, high = 0;
  for (const double v : values)
    if (std::isfinite(v)) low = std::min(low, v), high = std::max(high, v);
  // Small values of the other sign are round-off or occur at the surface; the field then counts as unsigned.
  return low < 0 && high > 0 && std::min(-low, high) > 0.05 * std::max(-low, high);
}

}  // namespace

// NOLINTNEXTLINE(readability-function-size): the commands of one picture, in the order of gnuplot
void draw(const FieldPlot& plot, const std::filesystem::path& picture) {
  const std::size_t count = plot.values.size();
  if (count == 0 || plot.positions.size() != 3 * count) fail_input("a frame without points cannot be drawn");
  const double unit = plot.units_per_metre;
  std::vector<std::size_t> order(count);
  for (std::size_t i = 0; i < count; ++i) order[i] = i;
  // The largest values are drawn last, on top, since points overlap a little.
  std::ranges::stable_sort(order, [&plot](std::size_t a, std::size_t b) {
    const double va = std::abs(plot.values[a]), vb = std::abs(plot.values[b]);
    return (std::isfinite(va) ? va : -1) < (std::isfinite(vb) ? vb : -1);
  });
  std::vector<double> x, y, v, lost_x, lost_y;
  Box box;
  for (const std::size_t i : order) {
    const double px = plot.positions[3 * i] * unit, py = plot.positions[3 * i + 1] * unit;
    if (!std::isfinite(px) || !std::isfinite(py)) continue;
    box.include(px, py);
    const bool lost = !std::isfinite(plot.values[i]);
    (lost ? lost_x : x).push_back(px);
    (lost ? lost_y : y).push_back(py);
    if (!lost) v.push_back(plot.values[i]);
  }
  std::vector<double> all_x = x, all_y = y;
  all_x.insert(all_x.end(), lost_x.begin(), lost_x.end());
  all_y.insert(all_y.end(), lost_y.begin(), lost_y.end());
  if (all_x.empty()) fail_input("a frame without points cannot be drawn");
  const double diameter = plot.point_diameter > 0 ? plot.point_diameter * unit : estimate_spacing(all_x, all_y, box);
  for (const auto& outline : plot.outlines)
    for (const auto& p : outline) box.include(p[0] * unit, p[1] * unit);
  const double pad = std::max(0.02 * std::max(box.x1 - box.x0, box.y1 - box.y0), diameter);
  box.widen(pad);

  // The frame has the aspect ratio of the data, so that lengths are true to scale and the colour bar has the same
  // height.
  const auto [w, h] = fit_frame(box);
  const double left = find_left_margin(box);
  const double title_width = estimate_width(plot.title) * 14 / 12, subtitle_width = estimate_width(plot.subtitle);
  const bool two_rows = title_width + subtitle_width + 30 > w + colours_right - 20;
  const double top = two_rows ? 66 : 46;
  const double total_w = std::max({left + w + colours_right, left + title_width + 20, left + subtitle_width + 20});
  const double total_h = axis_bottom + h + top;
  const auto sx = [total_w](double pixels) { return pixels / total_w; };
  const auto sy = [total_h](double pixels) { return pixels / total_h; };
  const double per_unit = w / (box.x1 - box.x0);
  const bool diverging = plot.signed_values.value_or(is_signed(plot.values));
  const std::array<double, 2> range = find_range(plot, diverging);

  std::string s = fmt::format(
      "set lmargin at screen {:.6f}\nset rmargin at screen {:.6f}\nset bmargin at screen {:.6f}\n"
      "set tmargin at screen {:.6f}\n",
      sx(left), sx(left + w), sy(axis_bottom), sy(axis_bottom + h));
  s += fmt::format("set xrange [{:.10g}:{:.10g}]\nset yrange [{:.10g}:{:.10g}]\n", box.x0, box.x1, box.y0, box.y1);
  s += fmt::format("set border 3 linecolor rgb '{0}'\nset tics nomirror out scale 0.6 textcolor rgb '{0}'\n",
                   text_colour);
  s += make_tics("x", box.x1 - box.x0, std::max(3.0, w / 80)) + make_tics("y", box.y1 - box.y0, std::max(3.0, h / 40));
  s += fmt::format("set xlabel {} offset 0,0.3 textcolor rgb '{}'\n", quote(make_label("x", plot.length_unit)),
                   text_colour);
  s += fmt::format("set ylabel {} textcolor rgb '{}'\n", quote(make_label("y", plot.length_unit)), text_colour);
  s += fmt::format("set label {} at screen {:.6f}, screen {:.6f} left font title_font textcolor rgb '{}'\n",
                   quote(plot.title), sx(left), 1 - sy(22), text_colour);
  if (two_rows)
    s += fmt::format("set label {} at screen {:.6f}, screen {:.6f} left textcolor rgb '{}'\n", quote(plot.subtitle),
                     sx(left), 1 - sy(44), text_colour);
  else
    s += fmt::format("set label {} at screen {:.6f}, screen {:.6f} right textcolor rgb '{}'\n", quote(plot.subtitle),
                     sx(left + w), 1 - sy(22), text_colour);
  s += fmt::format(
      "set palette defined ({})\nset cbrange [{:.10g}:{:.10g}]\nset colorbox vertical user origin screen {:.6f}, "
      "screen {:.6f} size screen {:.6f}, screen {:.6f} noborder\n",
      diverging ? blue_white_red : viridis, range[0], range[1], sx(left + w + 22), sy(axis_bottom), sx(16), sy(h));
  s += make_tics("cb", range[1] - range[0], std::max(4.0, h / 40));
  const std::string bar_label = make_label("", plot.unit);
  if (!bar_label.empty())
    s += fmt::format("set label {} at screen {:.6f}, screen {:.6f} left textcolor rgb '{}'\n", quote(bar_label),
                     sx(left + w + 22), sy(axis_bottom + h + 14), text_colour);
  s += "unset key\n";

  std::string plots;
  const auto add = [&plots](const std::string& clause) { plots += (plots.empty() ? "plot " : ", \\\n     ") + clause; };
  if (!plot.mesh_lines.empty()) {
    s += "$mesh << END\n";
    for (const auto& line : plot.mesh_lines) s += draw_line({line[0], line[1]}, unit, false);
    s += "END\n";
    add("$mesh using 1:2 with lines linewidth 0.4 linecolor rgb '#D8D8D8'");
  }
  // Discs just cover the square of their point. In SVG, discs in units of the axes would become polygons with a hundred
  // corners, so symbols of the same size are used: gnuplot draws symbol 7 there with a radius of 4.5 px.
  const double radius = std::max(0.8 * diameter, 0.6 / per_unit);
  const bool vector_picture = picture.extension() == ".svg";
  const auto disc = [&](const std::string& more) {
    return vector_picture ? fmt::format("{} with points pointtype 7 pointsize {:.4g}", more, radius * per_unit / 4.5)
                          : fmt::format(":({:.6g}){} with circles fillstyle solid noborder", radius, more);
  };
  if (!lost_x.empty()) {
    s += make_data("lost", {lost_x, lost_y});
    add("$lost using 1:2" + disc("") + " linecolor rgb '#BBBBBB'");
  }
  if (!x.empty()) {
    s += make_data("points", {x, y, v});
    add("$points using 1:2" + disc(":3") + " linecolor palette");
  }
  if (!plot.outlines.empty()) {
    s += "$outlines << END\n";
    for (const auto& outline : plot.outlines) s += draw_line(outline, unit, true);
    s += "END\n";
    add(fmt::format("$outlines using 1:2 with lines linewidth 1.2 linecolor rgb '{}'", text_colour));
  }
  run_gnuplot(picture, s + plots + "\n", static_cast<int>(std::lround(total_w)),
              static_cast<int>(std::lround(total_h)));
}

}  // namespace talus::output
