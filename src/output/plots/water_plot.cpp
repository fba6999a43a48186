// SPDX-License-Identifier: MIT
#include "output/plots/water_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "input/case/soil_water_law.hpp"
#include "output/files/history.hpp"
#include "output/plots/gnuplot.hpp"

namespace talus::output {

namespace {

constexpr int steps_per_decade = 60;

/// Retention and conductivity laws of a soil, made once.
struct Laws {
  material::Retention retention;
  material::Conductivity relative;

  material::SoilWater<double> at(double suction) const { return material::find_water(retention, suction); }
  double relative_at(double suction) const { return material::find_relative_conductivity(relative, at(suction)).value; }
};

std::string describe_limits(const input::PoreWater& soil) {
  return fmt::format("S from {:.4g} to {:.4g}", soil.maximum_saturation, soil.minimum_saturation);
}

std::string describe_retention(const input::PoreWater& soil, const ShownUnit& stress) {
  using enum input::RetentionCurve;
  switch (soil.retention) {
    case van_genuchten:
      return fmt::format("van Genuchten, p_ref = {}, λ = {:.4g}, {}", format_value(soil.reference_pressure, stress, 4),
                         soil.lambda, describe_limits(soil));
    case linear:
      return fmt::format("linear, {} at {}", describe_limits(soil), format_value(soil.dry_suction, stress, 4));
    case exponential:
      return fmt::format("exponential, α = {:.4g} 1/{}, {}", soil.decay * stress.si, stress.name,
                         describe_limits(soil));
    case table:
      return fmt::format("table of {} pairs", soil.retention_table.size());
    case dry:
    case saturated:
      break;
  }
  return fmt::format("saturated at any suction, S = {:.4g}", soil.maximum_saturation);
}

std::string describe_relative(const input::PoreWater& soil, const ShownUnit& stress) {
  using enum input::ConductivityCurve;
  const std::string measure = soil.measure == input::SaturationShare::total ? "S" : "S_e";
  switch (soil.relative_conductivity) {
    case mualem:
      return fmt::format(
          "Mualem in {}, λ = {:.4g}{}", measure, soil.lambda,
          soil.air_entry.value_or(0) > 0 ? ", air entry " + format_value(*soil.air_entry, stress, 4) : "");
    case hillel:
      return fmt::format("Hillel in {}, r = {:.4g}", measure, soil.exponent);
    case exponential:
      return fmt::format("exponential, α = {:.4g} 1/{}", soil.decay * stress.si, stress.name);
    case table:
      return fmt::format("table of {} pairs", soil.conductivity_table.size());
    case constant:
      break;
  }
  return "constant";
}

/// Writes 1e-9 instead of 1e-09.
std::string shorten(double value) {
  std::string text = fmt::format("{:.3g}", value);
  const std::size_t at = text.find("e-0");
  return at == std::string::npos ? text : text.erase(at + 2, 1);
}

std::string describe_conductivity(const input::PoreWater& soil, double saturated, const ShownUnits& units) {
  const ShownUnit area = units.area(), speed = units.speed();
  const std::string source =
      soil.conductivity ? "" : fmt::format(" (κ = {} {})", shorten(soil.permeability.value_or(0) / area.si), area.name);
  return fmt::format("{}, k = {} {} when saturated{}", describe_relative(soil, units.stress),
                     shorten(saturated / speed.si), speed.name, source);
}

/// Returns Bishop's χ after Khalili and Khabbaz (1998).
double find_chi(double suction, double air_entry) {
  return suction > air_entry ? std::pow(suction / air_entry, -0.55) : 1;
}

/// Returns true if a curve of the soil changes visibly between two suctions [Pa].
bool changes(const Laws& laws, double from, double to) {
  return std::abs(laws.at(from).saturation - laws.at(to).saturation) > 5e-3 ||
         std::abs(std::log10(std::max(laws.relative_at(from), 1e-12) / std::max(laws.relative_at(to), 1e-12))) > 0.02;
}

/// Returns the first and the last power of ten [Pa] of the suction axis.
std::pair<int, int> find_decades(const std::vector<std::pair<const input::Material*, Laws>>& soils) {
  int low = 1, high = 7;
  std::vector<double> pairs;
  for (const auto& [material, laws] : soils) {
    for (const auto& pair : material->water.retention_table) pairs.push_back(pair[0]);
    for (const auto& pair : material->water.conductivity_table) pairs.push_back(pair[0]);
  }
  std::erase_if(pairs, [](double s) { return !(s > 0); });
  double first = 1e300, last = 0;
  for (const double s : pairs) first = std::min(first, s), last = std::max(last, s);
  if (last > 0) low = std::min(low, static_cast<int>(std::floor(std::log10(first))));
  if (last > 0) high = std::max(high, static_cast<int>(std::ceil(std::log10(last))));
  const auto quiet = [&](int decade) {
    const double from = std::pow(10, decade), to = 10 * from;
    return std::ranges::none_of(soils, [&](const auto& soil) { return changes(soil.second, from, to); }) &&
           std::ranges::none_of(pairs, [&](double s) { return s >= from && s <= to; });
  };
  if (std::ranges::all_of(soils, [](const auto& soil) { return !changes(soil.second, 10, 1e7); })) return {low, high};
  while (high - low > 2 && quiet(low)) ++low;
  while (high - low > 2 && quiet(high - 1)) --high;
  return {low, high};
}

WaterCurves sample(const std::string& name, const input::PoreWater& soil, const Laws& laws, double saturated,
                   std::pair<int, int> decades, const ShownUnits& units) {
  WaterCurves curves;
  curves.units = units;
  curves.material = name;
  curves.retention = describe_retention(soil, units.stress);
  curves.conductivity = describe_conductivity(soil, saturated, units);
  curves.saturated_conductivity = saturated;
  const bool has_chi = soil.chi == input::BishopChi::khalili_khabbaz;
  const int steps = (decades.second - decades.first) * steps_per_decade;
  for (int i = 0; i <= steps; ++i) {
    const double s = std::pow(10, decades.first + static_cast<double>(i) / steps_per_decade);
    const material::SoilWater<double> water = laws.at(s);
    curves.suction.push_back(s);
    curves.saturation.push_back(water.saturation);
    curves.slope.push_back(water.slope);
    curves.relative.push_back(laws.relative_at(s));
    if (has_chi) curves.chi.push_back(find_chi(s, soil.chi_air_entry));
  }
  if (soil.retention == input::RetentionCurve::table) curves.saturation_pairs = soil.retention_table;
  if (soil.relative_conductivity == input::ConductivityCurve::table) curves.relative_pairs = soil.conductivity_table;
  if (soil.relative_conductivity == input::ConductivityCurve::mualem && soil.air_entry.value_or(0) > 0)
    curves.air_entry = soil.air_entry;
  return curves;
}

}  // namespace

std::vector<WaterCurves> sample_water_curves(const input::Case& data) {
  std::vector<std::pair<const input::Material*, Laws>> soils;
  std::vector<std::string> names;
  for (const auto& [name, material] : data.materials) {
    if (!material.water.is_wet()) continue;
    names.push_back(name);
    soils.push_back(
        {&material, {input::make_retention(material.water), input::make_relative_conductivity(material.water)}});
  }
  std::vector<WaterCurves> curves;
  if (soils.empty()) return curves;
  const std::pair<int, int> decades = find_decades(soils);
  for (std::size_t i = 0; i < soils.size(); ++i) {
    const input::PoreWater& soil = soils[i].first->water;
    // The measured conductivity refers to the gravity of the laboratory.
    const double saturated = input::find_saturated_conductivity(soil, data.water, data.water.drag_gravity);
    curves.push_back(sample(names[i], soil, soils[i].second, saturated, decades, data.units()));
  }
  return curves;
}

std::string make_water_table(const std::vector<WaterCurves>& soils) {
  const ShownUnits units = soils.empty() ? ShownUnits{} : soils.front().units;
  const ShownUnit &stress = units.stress, speed = units.speed();
  std::string text = fmt::format(
      "material,suction [{0}],saturation [-],saturation_slope [1/{0}],bishop_chi [-],relative_conductivity "
      "[-],conductivity [{1}]\n",
      stress.name, speed.name);
  for (const WaterCurves& soil : soils)
    for (std::size_t i = 0; i < soil.suction.size(); ++i)
      text += fmt::format(
          "{},{},{},{},{},{},{}\n", quote_field(soil.material), write_shortest(soil.suction[i] / stress.si),
          write_shortest(soil.saturation[i]), write_shortest(soil.slope[i] * stress.si),
          write_shortest(soil.chi.empty() ? soil.saturation[i] : soil.chi[i]), write_shortest(soil.relative[i]),
          write_shortest(soil.relative[i] * soil.saturated_conductivity / speed.si));
  return text;
}

namespace {

constexpr double sheet_width = 1060;  ///< [px]
constexpr double sheet_top = 44, sheet_row = 350, sheet_above = 58,
                 sheet_below = 62;   ///< rows: heading and captions, axis
constexpr double most_decades = 12;  ///< of a conductivity axis

struct Place {
  double left, right;  ///< edges of a panel [px]
};
constexpr Place saturation_place{72, 500}, conductivity_place{592, 984};

std::string write_label(const std::string& text, double x, double y, double height, const char* font = "") {
  return fmt::format("set label {} at screen {:.5f}, screen {:.5f} left {} textcolor rgb '{}'\n", quote(text),
                     x / sheet_width, 1 - y / height, font, text_colour);
}

std::string open_panel(Place place, double row_top, double height, const std::string& y_label) {
  return fmt::format(
      "unset label\nunset arrow\n"
      "set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\nset tmargin at screen {:.5f}\n"
      "set bmargin at screen {:.5f}\nset ylabel {} textcolor rgb '{}'\n",
      place.left / sheet_width, place.right / sheet_width, 1 - (row_top + sheet_above) / height,
      1 - (row_top + sheet_row - sheet_below) / height, quote(y_label), text_colour);
}

/// Writes the pairs of a table; a pair at suction 0 is drawn at the left end of the logarithmic axis.
std::string make_pairs(const std::string& name, const std::vector<std::array<double, 2>>& pairs,
                       const WaterCurves& soil, double factor) {
  std::vector<double> x, y;
  for (const auto& pair : pairs)
    x.push_back(std::max(pair[0], soil.suction.front()) / soil.units.stress.si), y.push_back(pair[1] * factor);
  return make_data(name, {x, y});
}

std::vector<double> scale_all(std::vector<double> values, double factor) {
  for (double& v : values) v *= factor;
  return values;
}

/// Returns the saturated conductivity in the unit of display.
double find_shown_conductivity(const WaterCurves& soil) {
  return soil.saturated_conductivity / soil.units.speed().si;
}

/// Returns the smallest range of decades that contains the curve and the saturated conductivity.
std::array<double, 2> find_conductivity_range(const WaterCurves& soil) {
  const double saturated = find_shown_conductivity(soil);
  double least = saturated;
  for (const double k : soil.relative) least = std::min(least, k * saturated);
  for (const auto& pair : soil.relative_pairs) least = std::min(least, pair[1] * saturated);
  const double high = std::ceil(std::log10(saturated) + 0.15);
  const double low = std::floor(std::log10(std::max(least, 1e-300)) - 0.15);
  return {std::max(low, high - most_decades), high};
}

/// Returns the script of a panel; `heading` is the script of the labels above it.
std::string draw_saturation(const WaterCurves& soil, std::size_t row, double row_top, double height,
                            const std::string& heading) {
  std::string script = open_panel(saturation_place, row_top, height, "degree of saturation S [-]") + heading;
  script += write_label(soil.material, saturation_place.left, row_top + 14, height, "font title_font");
  script += write_label(soil.retention, saturation_place.left, row_top + 40, height);
  script +=
      "set border 3\nunset logscale y\nset yrange [0:1.05]\nset ytics 0.2\nset format y '%.1f'\nunset y2tics\nunset "
      "y2label\n";
  script += "set key bottom left Left reverse samplen 2.5 spacing 1.3\n";
  script += fmt::format("plot $curve{} using 1:2 with lines linewidth 2.5 linecolor rgb '{}' title 'S'", row,
                        line_colours[0]);
  if (!soil.chi.empty())
    script += fmt::format(", \\\n     $chi{} using 1:2 with lines linewidth 2 dashtype 2 linecolor rgb '{}' title {}",
                          row, line_colours[2], quote("Bishop's χ"));
  if (!soil.saturation_pairs.empty())
    script += fmt::format(
        ", \\\n     $pairs{} using 1:2 with points pointtype 7 pointsize 0.7 linecolor rgb '#000000' title 'pairs of "
        "the table'",
        row);
  return script + "\n";
}

std::string draw_conductivity(const WaterCurves& soil, std::size_t row, double row_top, double height) {
  std::string script =
      open_panel(conductivity_place, row_top, height, fmt::format("conductivity k [{}]", soil.units.speed().name));
  script += write_label(soil.conductivity, conductivity_place.left, row_top + 40, height);
  const auto [low, high] = find_conductivity_range(soil);
  const double step = std::max(1.0, std::ceil((high - low) / 8)), saturated = find_shown_conductivity(soil);
  script += fmt::format(
      "set border 11\nset logscale y\nset yrange [1e{0:g}:1e{1:g}]\nset ytics 1e{2:g}\nset format y '10^{{%L}}'\n"
      "set logscale y2\nset y2range [{3:.10g}:{4:.10g}]\nset y2tics 1e{2:g}\nset my2tics 1\nset format y2 '10^{{%L}}'\n"
      "set y2label {5} textcolor rgb '{6}'\n",
      low, high, step, std::pow(10, low) / saturated, std::pow(10, high) / saturated,
      quote("relative conductivity [-]"), text_colour);
  script += "set key bottom left Left reverse samplen 2.5 spacing 1.3\n";
  if (soil.air_entry && *soil.air_entry >= soil.suction.front())
    script += fmt::format(
        "set arrow from {0:.10g}, graph 0 to {0:.10g}, graph 1 nohead linewidth 1.5 dashtype 2 linecolor rgb "
        "'#666666'\n",
        *soil.air_entry / soil.units.stress.si);
  script += fmt::format("plot $curve{} using 1:3 with lines linewidth 2.5 linecolor rgb '{}' title 'k'", row,
                        line_colours[1]);
  if (soil.air_entry)
    script += ", \\\n     NaN with lines linewidth 1.5 dashtype 2 linecolor rgb '#666666' title 'air entry'";
  if (!soil.relative_pairs.empty())
    script += fmt::format(
        ", \\\n     $relative_pairs{} using 1:2 with points pointtype 7 pointsize 0.7 linecolor rgb '#000000' title "
        "'pairs of the table'",
        row);
  return script + "\n";
}

}  // namespace

void draw(const WaterPlot& plot, const std::filesystem::path& picture) {
  if (plot.soils.empty()) fail_input("soil-water curves cannot be drawn: there is no wet soil");
  const double height = sheet_top + sheet_row * static_cast<double>(plot.soils.size());
  std::string script;
  for (std::size_t i = 0; i < plot.soils.size(); ++i) {
    const WaterCurves& soil = plot.soils[i];
    const std::string row = std::to_string(i);
    if (!(soil.saturated_conductivity > 0))
      fail_input("the conductivity of '{}' cannot be drawn: it is not above 0", soil.material);
    const double saturated = find_shown_conductivity(soil);
    const std::vector<double> suction = scale_all(soil.suction, 1 / soil.units.stress.si);
    script += make_data("curve" + row, {suction, soil.saturation, scale_all(soil.relative, saturated)});
    if (!soil.chi.empty()) script += make_data("chi" + row, {suction, soil.chi});
    if (!soil.saturation_pairs.empty()) script += make_pairs("pairs" + row, soil.saturation_pairs, soil, 1);
    if (!soil.relative_pairs.empty())
      script += make_pairs("relative_pairs" + row, soil.relative_pairs, soil, saturated);
  }
  const std::vector<double>& s = plot.soils.front().suction;
  const ShownUnit& stress = plot.soils.front().units.stress;
  script += fmt::format(
      "set border 3 linecolor rgb '{0}'\nset tics nomirror out scale 0.6,0.3 textcolor rgb '{0}'\n"
      "set grid xtics ytics linetype 1 linewidth 0.7 linecolor rgb '{1}'\nset key textcolor rgb '{0}'\n"
      "set logscale x\nset xrange [{2:.10g}:{3:.10g}]\nset xtics 10\nset mxtics 10\nset format x '%g'\n"
      "set xlabel 'suction [{4}]' textcolor rgb '{0}'\n",
      text_colour, grid_colour, s.front() / stress.si, s.back() / stress.si, stress.name);
  script += "set multiplot\n";
  for (std::size_t i = 0; i < plot.soils.size(); ++i) {
    const double row_top = sheet_top + sheet_row * static_cast<double>(i);
    const std::string heading =
        i == 0 ? write_label(plot.title, saturation_place.left, 24, height, "font title_font") : "";
    script += draw_saturation(plot.soils[i], i, row_top, height, heading);
    script += draw_conductivity(plot.soils[i], i, row_top, height);
  }
  run_gnuplot(picture, script + "unset multiplot\n", static_cast<int>(sheet_width), static_cast<int>(height));
}

}  // namespace talus::output
