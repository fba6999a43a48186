// SPDX-License-Identifier: MIT
#include "run/fem/thin_layers.hpp"

#include <algorithm>
#include <cmath>

#include "run/fem/tell_elements.hpp"

namespace talus::run {
namespace {

/// Fraction of the elements that do not reach γ_c.
constexpr double below_band = 0.97;

/// Elements, area, outline and altitudes of a region, and its largest shear strain.
struct Layer {
  int elements = 0;
  double area = 0;       ///< [m²]
  double perimeter = 0;  ///< [m]
  double altitudes = 0;  ///< sum over the elements [m]
  double strain = 0;

  /// Twice the area over the perimeter is the thickness of a long layer.
  double count_rows() const { return perimeter > 0 ? 2 * area / perimeter / (altitudes / elements) : 0; }
};

/// Length of the sides of element `e` that border on another region or on nothing [m].
double find_outline(const mesh::Mesh<2>& mesh, int e) {
  double length = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const int other = mesh.neighbours[e][k];
    if (other >= 0 && mesh.element_region[other] == mesh.element_region[e]) continue;
    const auto &a = mesh.nodes[mesh.elements[e][(k + 1) % 3]], &b = mesh.nodes[mesh.elements[e][(k + 2) % 3]];
    length += std::hypot(b[0] - a[0], b[1] - a[1]);
  }
  return length;
}

/// Mean shear strain of each quadratic element.
std::vector<double> find_strains(const fem::QuadraticMesh<2>& mesh, const fem::SolidState<2>& motion) {
  std::vector<double> strains;
  const std::size_t elements = mesh.elements.size(), per = elements > 0 ? mesh.points.size() / elements : 0;
  for (std::size_t e = 0; e < elements; ++e) {
    double sum = 0;
    for (std::size_t k = e * per; k < (e + 1) * per; ++k) sum += find_shear_strain(motion.strain[k]);
    strains.push_back(sum / static_cast<double>(per));
  }
  return strains;
}

double find_band_strain(std::vector<double> strains) {
  const auto at = strains.begin() + static_cast<std::ptrdiff_t>(below_band * static_cast<double>(strains.size() - 1));
  std::nth_element(strains.begin(), at, strains.end());
  return *at;
}

}  // namespace

std::vector<std::string> list_thin_layers(const mesh::Mesh<2>& mesh, const fem::QuadraticMesh<2>& quadratic,
                                          const fem::SolidState<2>& motion) {
  const std::vector<double> strains = find_strains(quadratic, motion);
  if (strains.empty()) return {};
  std::vector<Layer> layers(mesh.region_names.size());
  for (std::size_t i = 0; i < strains.size(); ++i) {
    const int e = quadratic.linear_element[i];
    Layer& layer = layers[static_cast<std::size_t>(mesh.element_region[e])];
    ++layer.elements;
    layer.area += mesh.volumes[e];
    layer.perimeter += find_outline(mesh, e);
    layer.altitudes += mesh.altitudes[e];
    layer.strain = std::max(layer.strain, strains[i]);
  }
  const double band = find_band_strain(strains);
  std::vector<std::string> thin;
  for (std::size_t r = 0; r < layers.size(); ++r)
    if (layers[r].elements > 0 && layers[r].strain >= band && layers[r].count_rows() < fewest_element_rows)
      thin.push_back(mesh.region_names[r]);
  return thin;
}

}  // namespace talus::run
