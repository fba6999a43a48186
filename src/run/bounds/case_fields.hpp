// SPDX-License-Identifier: MIT
#pragma once
// Strength and pore pressure of a case at the points of its section. Limit analysis interpolates them in triangles:
// they are put on the safe side of each bound, and the fields that prove the bounds are compared with the case itself.

#include <memory>
#include <optional>
#include <vector>

#include "base/vec.hpp"
#include "bounds/envelope.hpp"
#include "bounds/find_bounds.hpp"
#include "input/case/case.hpp"
#include "mesh/mesh.hpp"
#include "run/common/soil_column.hpp"
#include "site/pore_water.hpp"
#include "site/site.hpp"

namespace talus::run {

/// A point in a triangle of the first mesh of limit analysis.
struct SoilPlace {
  std::size_t triangle = 0;
  Vec<2> x{};
};

class CaseFields {
 public:
  /// `mesh`: the first mesh, whose elements with soil are the triangles, in their order. Pore pressures of steady
  /// seepage are computed on it. `water` receives their origin.
  CaseFields(const site::Site& site, const mesh::Mesh<2>& mesh, site::WaterResult& water);

  const site::HeldWater<2>& water() const { return water_; }

  /// Returns the triangle of the first mesh that contains each of a problem that was refined from it.
  std::vector<std::size_t> find_origins(const bounds::Problem& problem) const;

  /// Makes polygons of curved envelopes; `usual`: largest overburden [Pa].
  void enclose_envelopes(double usual);
  bool has_envelopes() const;

  /// Returns the strengths at the corners of the triangles. Of a curved envelope it is the polygon inside for the lower
  /// bound, and the one outside for the upper one.
  std::vector<std::array<bounds::Strength, 3>> find_strengths(bounds::Bound bound) const;
  /// Returns the cohesions at places, of the first line of these strengths [Pa].
  std::vector<double> find_cohesions(const std::vector<SoilPlace>& places, bounds::Bound bound) const;
  /// Returns the pore pressures at places, positive in compression [Pa].
  std::vector<double> find_pressures(const std::vector<SoilPlace>& places) const;

  /// Returns true if the strength of the soil of a triangle depends on the place.
  bool has_variable_strength(std::size_t triangle) const;
  /// Returns true if the case has pore pressures.
  bool has_pressure() const { return has_pressure_; }

 private:
  /// The soil of a region of the mesh.
  struct Soil {
    input::Material material;  ///< that of limit analysis
    site::PlaneStrength strength;
    std::optional<bounds::EnvelopePolygons> envelope;  ///< of a curved envelope
    bool is_variable = false;

    /// Returns the law in the place of c and φ; null: there is none, or it is that of weak planes, which have their own
    /// criterion.
    const StrengthLaw* get_law() const { return strength.planes ? nullptr : strength.law.get(); }
  };

  const Soil& get_soil(std::size_t triangle) const;
  std::vector<double> find_root_cohesions(const std::vector<SoilPlace>& places) const;
  /// Returns the first line and the further ones of an envelope, without tension and weak planes.
  bounds::Strength find_lines(const Soil& soil, const Vec<2>& x, double root_cohesion, bounds::Bound bound) const;
  bounds::Strength find_strength(const Soil& soil, const Vec<2>& x, double root_cohesion, bounds::Bound bound) const;
  double find_nodal(std::size_t element, const Vec<2>& x) const;
  double find_known(std::size_t element, const Vec<2>& x) const;
  double find_pressure(const SoilPlace& place) const;

  const site::Site site_;
  const input::Case& data_;
  const SoilColumns columns_;
  const mesh::Mesh<2> mesh_;
  mesh::Mesh<2> cut_;  ///< the same elements, with the nodes along impermeable walls doubled
  std::vector<std::size_t> elements_;
  std::vector<double> nodal_;  ///< pressures at the nodes of `cut_`, positive in tension [Pa]
  site::HeldWater<2> water_;
  std::vector<Soil> soils_;  ///< of the regions
  bool has_pressure_ = false;
  mutable int last_known_ = 0;  ///< element of the known water in which the last place lay
};

/// Puts strengths and pore pressures on the safe side of a bound, where they are not linear in the triangles of the
/// first mesh: at 45 points of each triangle the strength of the case is not below that of the problem for the lower
/// bound, and not above it for the upper one; pore pressures conversely.
class CaseEnclosure {
 public:
  CaseEnclosure(std::shared_ptr<const CaseFields> fields, const bounds::Problem& first);

  /// Returns true if a strength or a pressure is not linear in some triangle.
  bool is_needed() const;
  /// Evaluates the strengths and pressures of such triangles, or of the parts into which they were divided.
  void apply(bounds::Problem& problem, bounds::Bound bound) const;

 private:
  std::shared_ptr<const CaseFields> fields_;
  double rounding_ = 0;                                ///< of strengths and pressures [Pa]
  std::vector<bool> bends_strength_, bends_pressure_;  ///< by triangle of the first mesh
};

/// Evaluates strength and pore pressure of the case at points of each triangle of the fields that prove the bounds:
/// corners, middles of the sides, centre, and twelve others. A bound that they do not confirm becomes that which they
/// do, or is withdrawn.
void hold_to_case(const CaseFields& fields, bounds::BoundsResult& found);

}  // namespace talus::run
