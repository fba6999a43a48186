// SPDX-License-Identifier: MIT
#include "report/content/fields.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace talus::report {

namespace {

struct Words {
  const char* title;
  bool is_signed;
  const char* unit = nullptr;  ///< unit of display instead of the stored one, with si = 1
};

/// Titles of the stored fields. Stresses and strains keep the sign convention of the result files, which the title
/// states.
const std::map<std::string, Words>& list_words() {
  static const std::map<std::string, Words> words{
      {"displacement", {"displacement", false}},
      {"velocity", {"velocity", false}},
      {"stress", {"stress", true}},
      {"strain", {"strain", true}},
      {"mean_stress", {"mean stress (tension positive)", true}},
      {"deviatoric_stress", {"deviatoric stress", false}},
      {"volumetric_strain", {"volumetric strain (dilation positive)", true}},
      {"deviatoric_strain", {"deviatoric strain", false}},
      {"plastic_strain", {"plastic deviatoric strain", false}},
      {"volume", {"volume of the point", false}},
      {"pore_pressure", {"pore pressure (compression positive)", true}},
      // The colour scale does not start at zero, so that differences are visible.
      {"saturation", {"degree of saturation", true}},
      {"porosity", {"porosity", true}},
      {"darcy_velocity", {"flow of the water (Darcy)", false}},
      {"water_velocity", {"velocity of the water", false}},
      {"preconsolidation_pressure", {"preconsolidation pressure p'c", false}},
      // Changes of the void ratio are small compared with its value.
      {"void_ratio", {"void ratio e", true}},
      {"root_content", {"root content", false, "%"}},
      {"root_activation_strain", {"activation strain of the roots", false}},
      {"separation", {"gap that the soil has come apart by", false}},
      {"intact_roots", {"share of the roots that is intact", false}},
      {"root_cohesion", {"root cohesion", false}},
  };
  return words;
}

std::string to_title(const std::string& name) {
  std::string title = name;
  std::replace(title.begin(), title.end(), '_', ' ');
  return title;
}

ShownUnit choose_unit(const std::string& stored, std::size_t dimension, const ShownUnits& units) {
  if (stored == "m") return units.displacement;
  if (stored == "Pa") return units.stress;
  if (stored == "m3") return units.volume(dimension);
  if (stored == "m/s") return units.speed();
  return {stored.empty() ? "-" : stored, 1};
}

}  // namespace

std::vector<ScalarField> list_scalars(const std::vector<output::Field>& fields, std::size_t dimension,
                                      const ShownUnits& units) {
  static const char* const axes[] = {"x", "y", "z"};
  static const char* const pairs[] = {"xx", "yy", "zz", "xy", "yz", "xz"};
  std::vector<ScalarField> scalars;
  for (const output::Field& f : fields) {
    const auto known = list_words().find(f.name);
    const std::string title = known != list_words().end() ? known->second.title : to_title(f.name);
    const bool is_signed = known == list_words().end() || known->second.is_signed;
    ShownUnit unit = choose_unit(f.unit, dimension, units);
    if (known != list_words().end() && known->second.unit != nullptr) unit.name = known->second.unit;
    if (f.components == 1) {
      scalars.push_back({f.name, -1, f.name, title, unit, is_signed});
    } else if (f.components == 3) {
      scalars.push_back({f.name, -1, f.name, title, unit, false});
      for (std::size_t d = 0; d < dimension; ++d)
        scalars.push_back({f.name, static_cast<int>(d), f.name + "_" + axes[d], title + " in " + axes[d], unit, true});
    } else if (f.components == 6) {
      for (std::size_t c = 0; c < 6; ++c) {
        if (dimension == 2 && c > 3) continue;
        const char* sign = c < 3 && f.name == "stress" ? " (tension positive)" : "";
        scalars.push_back(
            {f.name, static_cast<int>(c), f.name + "_" + pairs[c], title + " " + pairs[c] + sign, unit, is_signed});
      }
    }
  }
  return scalars;
}

ScalarField find_scalar(const std::string& name, const std::string& unit, std::size_t dimension,
                        const ShownUnits& units) {
  // "stress_xx" is a component of "stress", but "void_ratio" is a field of its own.
  const std::size_t cut = name.rfind('_');
  const std::string base = cut == std::string::npos ? name : name.substr(0, cut);
  int components = 1;
  if (!list_words().contains(name) && list_words().contains(base)) components = name.size() - cut == 2 ? 3 : 6;
  const output::Field field{components == 1 ? name : base, unit, components, {}};
  for (const ScalarField& scalar : list_scalars({field}, dimension, units))
    if (scalar.name == name) return scalar;
  return {name, -1, name, to_title(name), choose_unit(unit, dimension, units), true};
}

double evaluate(const ScalarField& scalar, const output::Field& stored, std::size_t i) {
  const auto n = static_cast<std::size_t>(stored.components);
  const double* v = &stored.values[i * n];
  if (scalar.component >= 0) return v[scalar.component];
  if (n == 1) return v[0];
  double square = 0;
  for (std::size_t c = 0; c < n; ++c) square += v[c] * v[c];
  return std::sqrt(square);
}

ColourScale find_colour_scale(std::span<const double> values, bool is_signed, double step) {
  std::vector<double> finite;
  finite.reserve(values.size());
  std::copy_if(values.begin(), values.end(), std::back_inserter(finite), [](double v) { return std::isfinite(v); });
  ColourScale scale{{0, step}, false};
  if (finite.empty()) return scale;
  const auto percentile = [&](double share) {
    const auto at = finite.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(finite.size() - 1));
    std::nth_element(finite.begin(), at, finite.end());
    return *at;
  };
  double low = is_signed ? percentile(0.01) : 0, high = percentile(0.99);
  // A strain localised in less than a hundredth of the points is outside the percentiles.
  if (low == high) {
    const auto [least, most] = std::minmax_element(finite.begin(), finite.end());
    low = is_signed ? *least : 0;
    high = *most;
  }
  if (low < 0 && high > 0 && std::min(-low, high) > 0.1 * std::max(-low, high)) {
    scale.diverging = true;
    high = std::max(-low, high);
    low = -high;
  }
  if (!(high > low)) high = low + step;
  scale.limits = {low, high};
  return scale;
}

void show_water(output::Frame& frame) {
  const auto find = [&](const char* name) {
    const auto found = std::find_if(frame.point_fields.begin(), frame.point_fields.end(),
                                    [&](const output::Field& f) { return f.name == name; });
    return found == frame.point_fields.end() ? nullptr : &*found;
  };
  output::Field *water = find("water_velocity"), *pressure = find("pore_pressure"), *saturation = find("saturation");
  const output::Field *velocity = find("velocity"), *porosity = find("porosity");
  if (!water || !pressure || !saturation || !velocity || !porosity) return;
  const auto n = static_cast<std::size_t>(water->components);
  for (std::size_t i = 0; i < water->values.size(); ++i)
    water->values[i] = porosity->values[i / n] * saturation->values[i / n] * (water->values[i] - velocity->values[i]);
  water->name = "darcy_velocity";
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < saturation->values.size(); ++i) {
    if (saturation->values[i] > 0) continue;
    saturation->values[i] = pressure->values[i] = none;
    std::fill_n(water->values.begin() + static_cast<std::ptrdiff_t>(i * n), n, none);
  }
}

}  // namespace talus::report
