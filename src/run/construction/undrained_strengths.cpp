// SPDX-License-Identifier: MIT
#include "run/construction/undrained_strengths.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "material/mohr_coulomb.hpp"
#include "material/softening.hpp"
#include "site/site.hpp"

namespace talus::run {
namespace {

bool has_constant_friction(const input::Material& m) {
  return m.model == material::model_of<material::MohrCoulomb> ||
         m.model == material::model_of<material::SofteningMohrCoulomb>;
}

/// Returns why the undrained strength of a soil is not known; empty if it is.
std::string find_obstacle(const std::string& name, const input::Material& m) {
  if (!has_constant_friction(m))
    return fmt::format("material '{}' of the model \"{}\" has no undrained strength that is known beforehand", name,
                       m.traits().word);
  if (m.dilatancy_angle > 0)
    return fmt::format("material '{}' dilates: without drainage its strength has no limit (dilatancy_angle = 0)", name);
  return {};
}

bool is_sheared_undrained(const input::Material& m) {
  return m.water.is_wet() && m.model != material::model_of<material::LinearElastic> &&
         !material::is_total_stress(m.model, m);
}

}  // namespace

class UndrainedStrengths::Field {
 public:
  Field(const input::KnownStress& known, const std::vector<bool>& holds) {
    const mesh::Mesh<2>& mesh = known.mesh;
    std::vector<double> sum(mesh.nodes.size()), share(mesh.nodes.size());
    for (std::size_t e = 0; e < known.elements.size(); ++e) {
      if (!holds[e]) continue;
      const auto& corner = mesh.elements[e];
      grid_.triangles.push_back(corner);
      const double area = mesh.volumes[e];
      std::array<double, input::KnownStress::points> mean{};
      double middle = 0;
      for (std::size_t q = 0; q < mean.size(); ++q) {
        mean[q] = -0.5 * (known.elements[e].stress[q][0] + known.elements[e].stress[q][1]);
        middle += mean[q] / static_cast<double>(mean.size());
      }
      // The linear field through the points, which lie half-way between the middle and the corners.
      for (std::size_t q = 0; q < mean.size(); ++q) {
        sum[static_cast<std::size_t>(corner[q])] += area * (2 * mean[q] - middle);
        share[static_cast<std::size_t>(corner[q])] += area;
      }
    }
    grid_.nodes.assign(mesh.nodes.begin(), mesh.nodes.end());
    for (std::size_t i = 0; i < sum.size(); ++i) grid_.pressure.push_back(share[i] > 0 ? sum[i] / share[i] : 0);
    for (std::size_t i = 0; i < sum.size(); ++i)
      if (share[i] > 0) nodes_.push_back(i);
    locator_ = lem::PressureLocator(grid_);
  }

  /// Returns s' [Pa], that of the nearest node outside the soil.
  double find(const std::array<double, 2>& x) const {
    if (const auto found = locator_.find(x)) return std::max(0.0, *found);
    double nearest = std::numeric_limits<double>::infinity(), mean = 0;
    for (const std::size_t i : nodes_)
      if (const double far = std::hypot(x[0] - grid_.nodes[i][0], x[1] - grid_.nodes[i][1]); far < nearest)
        nearest = far, mean = grid_.pressure[i];
    return std::max(0.0, mean);
  }

 private:
  lem::PressureGrid grid_;
  lem::PressureLocator locator_;
  std::vector<std::size_t> nodes_;  ///< those of the soil
};

UndrainedStrengths::UndrainedStrengths(const input::Case& later) : later_(later) {
  const input::KnownStress& known = *later.initial.known_stress;
  const mesh::Mesh<2>& mesh = known.mesh;
  std::map<std::string, std::vector<bool>> elements;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    if (mesh.element_region[e] == mesh::empty_region) continue;
    const std::string& name = later.regions.at(mesh.region_names[static_cast<std::size_t>(mesh.element_region[e])]);
    if (!is_sheared_undrained(later.materials.at(name))) continue;
    std::vector<bool>& holds = elements[name];
    holds.resize(mesh.elements.size());
    holds[e] = true;
  }
  for (const auto& [name, holds] : elements) {
    if (fault_ = find_obstacle(name, later.materials.at(name)); !fault_.empty()) return;
    fields_[name] = std::make_shared<const Field>(known, holds);
  }
}

double UndrainedStrengths::find_cosine(const std::string& name, double factor) const {
  const input::Material& soil = later_.materials.at(name);
  return 1 / std::hypot(1, std::tan(site::find_plane_strength(soil).friction_angle) / (soil.reduced ? factor : 1));
}

double UndrainedStrengths::correct(double found, double factor) const {
  constexpr int repetitions = 60;  // each leaves at most sin²φ of the error of the one before
  double corrected = found;
  for (int i = 0; i < repetitions && found < factor; ++i) {
    double least = 1;
    for (const auto& [name, field] : fields_)
      least = std::min(least, find_cosine(name, corrected) / find_cosine(name, factor));
    corrected = found * least;
  }
  return std::min(corrected, factor);
}

input::Case UndrainedStrengths::make_case(double factor) const {
  input::Case made = later_;
  for (const auto& [name, field] : fields_) {
    input::Material& soil = made.materials.at(name);
    const site::PlaneStrength own = site::find_plane_strength(soil);
    const double tan = std::tan(own.friction_angle), cos = find_cosine(name, factor);
    StrengthLaw law;
    law.find_tangent = [own, s = field, tan, cos](const StrengthPlane& plane) {
      const double c = own.cohesion + own.cohesion_gradient * std::max(0.0, own.cohesion_level - plane.at[1]);
      return StrengthTangent{cos * (c + s->find(plane.at) * tan), 0};
    };
    soil.known_strength = std::make_shared<const StrengthLaw>(std::move(law));
  }
  return made;
}

}  // namespace talus::run
