// SPDX-License-Identifier: MIT
#pragma once
// The site: geometry, soils, water and loads of a case, from which LEM, FEM, limit analysis and MPM build their models
// (docs/decisions/0045-site.md). An object that acts on every method, such as a support, enters here once.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/vec.hpp"
#include "input/case/case.hpp"
#include "mesh/mesh.hpp"
#include "site/ground_line.hpp"
#include "site/standing_water.hpp"

namespace talus::site {

/// Immutable. Copies share the case.
class Site {
 public:
  // Not explicit: a function of the site takes a case as well. A section without a unique ground is refused where the
  // ground is asked for, since FEM and MPM need none without water and loads on it.
  Site(const input::Case& data) : Site(std::make_shared<const input::Case>(data)) {}
  explicit Site(std::shared_ptr<const input::Case> data);

  const input::Case& data() const { return *data_; }

  // Geometry.

  /// Returns true for a section of polygons, plane or extruded to 3D, with soil from the ground down: ground() does not
  /// throw.
  bool has_ground() const { return !ground_.empty(); }
  /// Returns the ground from left to right, as find_ground(); empty for a ready mesh. Throws Error
  /// (wrong_input) for a section with gaps, overhangs or cavities.
  const Polyline& ground() const;
  /// Returns H [m], see find_slope_height(). Throws as ground().
  double find_slope_height() const { return site::find_slope_height(data_->mesh, ground()); }

  // Soils.

  /// Returns the material of a region. Throws Error (wrong_input) if it has none.
  const input::Material& get_soil(const std::string& region) const;

  // Water.

  double water_weight() const;  ///< γ_w [N/m³] under the gravity of the model
  /// Returns the water table of the case; empty where the case gives none.
  const Polyline& water_table() const;
  /// Returns the ponds on the ground at `time` [s]; none without ground.
  std::vector<Pond> find_ponds(double time) const;
  /// Returns those at the time at which the methods start.
  const std::vector<Pond>& ponds() const { return ponds_; }
  /// Returns warnings on ponds() without a bank.
  std::vector<std::string> list_open_ends() const;
  /// Returns the level of the water standing over the ground at x [m]; nothing where the ground is dry.
  std::optional<double> find_standing_level(double x) const;

  // Loads.

  /// Returns the sum of all surcharges at x [Pa per horizontal metre].
  double find_surcharge(double x) const;
  /// Returns the pressure of the slurries of the case at a place on the ground [Pa].
  double find_slurry_pressure(double x, double y) const;
  /// Returns the weight of the water standing on the ground at x [Pa]; zero without ground.
  double find_standing_load(double x) const;
  /// Returns the acceleration over g of a pseudo-static earthquake. If the case gives no direction, it is towards the
  /// lower end of the ground, and towards larger x where there is none or it is level from end to end. Throws as
  /// ground() if there is an earthquake.
  template <int D>
  Vec<D> find_earthquake() const;
  /// Returns the acceleration of the soil over g: gravity and earthquake.
  template <int D>
  Vec<D> find_body_force() const {
    Vec<D> direction = find_earthquake<D>();
    for (std::size_t d = 0; d < D; ++d) direction[d] += data_->gravity.direction[d];
    return direction;
  }

 private:
  std::shared_ptr<const input::Case> data_;
  Polyline ground_;
  std::optional<Error> fault_;  ///< of the ground
  std::vector<Pond> ponds_;
};

/// Shear strength of a soil for LEM and limit analysis.
struct PlaneStrength : material::SliceStrength {
  bool yields = true;  ///< false: elastic, with a cohesion so large that no slip surface through it is critical
};

/// Throws Error (wrong_input) for a law without cohesion and friction angle.
PlaneStrength find_plane_strength(const input::Material& soil);

/// Returns γ_w [N/m³] under the gravity of the model.
double find_water_weight(const input::Case& data);

/// Throws Error (wrong_input) unless gravity acts along -y, as heads and water tables are levels of y. `what` begins
/// the sentence: "a water table".
void check_upright(const input::Case& data, const char* what);

/// Returns the material that fills element `e` at the start; nullptr where there is no soil. Throws Error (wrong_input)
/// if its region has no material.
template <int D>
const input::Material* find_soil(const input::Case& data, const mesh::Mesh<D>& mesh, int e);

}  // namespace talus::site
