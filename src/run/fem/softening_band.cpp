// SPDX-License-Identifier: MIT
#include "run/fem/softening_band.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <set>
#include <vector>

#include "run/fem/solid_of_case.hpp"

namespace talus::run {
namespace {

/// Ratio of element size to nonlocal length up to which a band is independent of the elements: 0.5, plus a tenth for
/// the scatter of element sizes, as in MPM.
constexpr double coarse_share = 0.55;

/// Returns the side of an equilateral simplex of that volume, in metres.
template <int D>
double compute_size(double volume) {
  return D == 2 ? std::sqrt(4 * volume / std::sqrt(3.0)) : std::cbrt(6 * std::sqrt(2.0) * volume);
}

}  // namespace

template <int D>
std::optional<std::string> describe_soft_band(const input::Case& data, const mesh::Mesh<D>& mesh,
                                              const fem::QuadraticMesh<D>& quadratic,
                                              const fem::SolidState<D>& motion) {
  const std::vector<double> strains = compute_element_strains<D>(quadratic, motion);
  if (strains.empty()) return std::nullopt;
  const double band = compute_band_strain(strains);
  std::set<std::string> soils;
  double volume = 0;
  int count = 0;
  for (std::size_t k = 0; k < strains.size(); ++k) {
    const auto e = static_cast<std::size_t>(quadratic.linear_element[k]);
    const std::string& soil = data.regions.at(mesh.region_names[static_cast<std::size_t>(mesh.element_region[e])]);
    if (strains[k] < band || !material::needs<material::SofteningRange>(data.materials.at(soil).model)) continue;
    soils.insert("'" + soil + "'");
    volume += mesh.volumes[e];
    ++count;
  }
  if (count == 0) return std::nullopt;
  const double size = compute_size<D>(volume / count);
  const ShownUnits units = data.units();
  if (!data.softening_length)
    return fmt::format(
        "soil that softens ({}) has no nonlocal length and shears in a band of elements of {}: the factor depends on "
        "their size. Give mesh.softening_length, at least twice that",
        fmt::join(soils, ", "), format_value(size, units.length, 2));
  if (size <= coarse_share * *data.softening_length) return std::nullopt;
  return fmt::format(
      "soil that softens ({}) shears in a band of elements of {}: the factor depends on their size. "
      "mesh.softening_length = {} must be at least twice that",
      fmt::join(soils, ", "), format_value(size, units.length, 2), format_value(*data.softening_length, units.length));
}

template std::optional<std::string> describe_soft_band<2>(const input::Case&, const mesh::Mesh<2>&,
                                                          const fem::QuadraticMesh<2>&, const fem::SolidState<2>&);
template std::optional<std::string> describe_soft_band<3>(const input::Case&, const mesh::Mesh<3>&,
                                                          const fem::QuadraticMesh<3>&, const fem::SolidState<3>&);

}  // namespace talus::run
