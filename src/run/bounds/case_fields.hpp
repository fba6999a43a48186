// SPDX-License-Identifier: MIT
#pragma once
// Strength and pore pressure of a case at the points of its section. Limit analysis interpolates them in triangles:
// they are put on the safe side of each bound, and the fields that prove the bounds are compared with the case itself.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/vec.hpp"
#include "bounds/envelope.hpp"
#include "bounds/find_bounds.hpp"
#include "input/case/case.hpp"
#include "mesh/mesh.hpp"
#include "run/bounds/kink_points.hpp"
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
  /// Returns the lines between which strength and pore pressure are linear, unless they are curved.
  std::vector<mesh::Polyline> list_kinks() const;
  /// Returns true if the strength in a triangle may be curved between the lines of list_kinks(): it depends on a
  /// distance, a power, or the products of two interpolations.
  bool has_curved_strength(std::size_t triangle) const;
  /// Returns how far the interpolation between profiles of strengths may be from a linear function in a triangle with
  /// these corners that lies in one of the first mesh [Pa].
  double find_product_error(std::size_t triangle, const std::array<Vec<2>, 3>& corners) const;
  bool has_curved_pressure(std::size_t triangle) const;
  /// Returns how far a ratio r_u between points times the overburden may be from a linear function in a triangle [Pa].
  /// `places`: among them those of the extremes of the ratio.
  double find_ratio_error(std::size_t triangle, const std::array<Vec<2>, 3>& corners,
                          const std::vector<Vec<2>>& places) const;
  /// Returns true if pore pressures come from a spline, of which no enclosure is known.
  bool takes_spline() const;

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
  bool takes_ratio_grid() const;
  /// Returns the largest difference of depths under the ground between places in a triangle [m].
  double find_reach(const std::array<Vec<2>, 3>& corners) const;
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
/// first mesh: nowhere in a triangle is the strength of the case below that of the problem for the lower bound, or
/// above it for the upper one; pore pressures conversely. They are evaluated at the corners of the parts in which they
/// are linear, where their extremes lie. Where they are curved, the largest second difference between 45 points is
/// added: a concave or convex function lies between its chord and the extension of the next one, and a smooth one
/// differs from the chord by an eighth of it.
class CaseEnclosure {
 public:
  CaseEnclosure(std::shared_ptr<const CaseFields> fields, const bounds::Problem& first);

  /// Returns true if a strength or a pressure is not linear in some triangle.
  bool is_needed() const;
  /// Evaluates the strengths and pressures of such triangles, or of the parts into which they were divided.
  void apply(bounds::Problem& problem, bounds::Bound bound) const;
  /// Returns a sentence on what is compared at points only; empty: everything is enclosed.
  std::string describe_gap() const;

 private:
  /// Points of triangles, and strengths or pressures there.
  struct Sampled {
    std::vector<std::vector<Weights>> points;  ///< by triangle, first those of the lattice
    std::vector<std::size_t> first;            ///< index of its first value
    std::vector<double> values;

    const double* get_values(std::size_t k) const { return &values[first[k]]; }
  };
  template <class Find>
  Sampled sample(const bounds::Problem& problem, const std::vector<std::size_t>& origins,
                 const std::vector<std::size_t>& triangles, Find find) const;
  std::vector<Weights> list_points(const bounds::Problem& problem, std::size_t triangle) const;

  std::shared_ptr<const CaseFields> fields_;
  KinkPoints kinks_;
  double rounding_ = 0;                                ///< of strengths and pressures [Pa]
  std::vector<bool> bends_strength_, bends_pressure_;  ///< by triangle of the first mesh
};

/// Evaluates strength and pore pressure of the case at points of each triangle of the fields that prove the bounds:
/// corners, middles of the sides, centre, and twelve others. A bound that they do not confirm becomes that which they
/// do, or is withdrawn.
void hold_to_case(const CaseFields& fields, bounds::BoundsResult& found);

}  // namespace talus::run
