// SPDX-License-Identifier: MIT
#pragma once
// [geometry] and [mesh]: soil polygons in the background box, lines that the mesh conforms to, and mesh settings.

#include <array>
#include <limits>
#include <optional>
#include <string>

#include "input/case/layers.hpp"
#include "input/language/forms.hpp"
#include "input/language/spec.hpp"
#include "mesh/plan.hpp"

namespace talus::input {

void describe(Visitor& v, mesh::Polygon& p);

void describe(Visitor& v, mesh::Line& l);

struct GeometryBlock {
  mesh::Plan& plan;
  Layering& layering;
};

void describe(Visitor& v, GeometryBlock& g);

// [mesh]: the background mesh and its material points.

template <>
inline constexpr auto choices<mesh::Algorithm> = std::array{
    Choice{mesh::Algorithm::frontal, "frontal", "the most regular elements; regular patterns lock in some directions"},
    Choice{mesh::Algorithm::delaunay, "delaunay", "irregular; the best agreement with published curves"},
    Choice{mesh::Algorithm::meshadapt, "meshadapt", "irregular; locks least, for the factor of safety"},
};

void describe(Visitor& v, mesh::Refinement& r);

struct MeshBlock {
  mesh::Plan& plan;
  int& points_per_element;
  std::optional<double>& softening_length;
};

void describe(Visitor& v, MeshBlock& m);

// The outline of the soil in a plane section: extent and ground level.

class SoilOutline {
 public:
  explicit SoilOutline(const mesh::Plan& plan);

  double left() const { return left_; }      ///< [m]
  double right() const { return right_; }    ///< [m]
  double bottom() const { return bottom_; }  ///< [m]
  double top() const { return top_; }        ///< [m]
  /// Returns 1e-9 of the width, the tolerance for rounding errors [m].
  double slack() const { return 1e-9 * (right_ - left_); }
  /// Returns true if there is ground at x.
  bool spans(double x) const { return x >= left_ - slack() && x <= right_ + slack(); }
  const ShownUnits& units() const { return plan_.units; }
  /// Writes the extent: "which goes from x = 0 m to x = 44 m".
  std::string write_span() const;
  /// Returns the highest level of soil at x [m]; minus infinity if there is none.
  double find_ground(double x) const;

 private:
  static constexpr double far_ = std::numeric_limits<double>::infinity();
  const mesh::Plan& plan_;
  double left_ = far_, right_ = -far_, bottom_ = far_, top_ = -far_;
};

}  // namespace talus::input
