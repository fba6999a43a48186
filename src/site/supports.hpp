// SPDX-License-Identifier: MIT
#pragma once
// The supports of a case as straight bars in the section, per metre of slope, for all methods
// (docs/decisions/0051-supports.md).

#include <limits>
#include <string>
#include <vector>

#include "input/case/support.hpp"
#include "site/site.hpp"

namespace talus::site {

/// A straight support in the section. Resistances and stiffness are per metre of slope: those of one bar over the
/// spacing along the slope, those of a geosynthetic times its coverage.
struct Bar {
  std::string support;  ///< its name in the case
  int row = 1;          ///< from the top of the pattern
  input::SupportKind kind = input::SupportKind::nail;
  Point head{}, end{};     ///< [m]; the head lies on the ground, except for buried geosynthetics and piles
  double free_length = 0;  ///< from the head, without bond [m]
  double tensile = 0;      ///< tensile strength [N/m]; 0 for piles
  double plate = 0;        ///< resistance of the head (plate, facing, connection) [N/m]; may be infinite
  double bond = 0;         ///< pull-out resistance per metre of bar, constant part [N/m per m]
  double bond_factor = 0;  ///< its increase with σ'_v [N/m per m per Pa]
  double prestress = 0;    ///< [N/m]
  double lateral = 0;      ///< given lateral resistance of a pile; 0: by Ito and Matsui, or only `shear` [N/m]
  double shear = std::numeric_limits<double>::infinity();  ///< shear strength of a pile [N/m]
  double stiffness = 0;                                    ///< E A or J [N]; 0: not given
  double bending = 0, moment = 0;                          ///< E I [N m], M_p [N m/m]; 0: not given
  double diameter = 0, spacing = 1;                        ///< [m]
  bool is_active = false;                                  ///< the factor does not divide the force
  input::SupportDirection direction = input::SupportDirection::axial;
  double weight = 0;               ///< of a wall per area, less that of the soil it replaces [N/m²]
  bool is_barrier = false;         ///< a wall that slip surfaces of LEM do not cross
  bool has_soil_pressure = false;  ///< lateral force of a pile by Ito and Matsui (1975)

  double length() const;  ///< [m]
};

/// Returns the bars of a case, support by support in the order of their names. Throws Error (wrong_input), as
/// Site::ground(), and for a support without a place.
std::vector<Bar> list_bars(const Site& site);

/// Writes the convention of a factor with supports: "anchors are active (loads), nails passive (F divides them)"; empty
/// without supports.
std::string describe_sense(const input::Case& data);

}  // namespace talus::site
