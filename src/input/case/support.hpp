// SPDX-License-Identifier: MIT
#pragma once
// [support.NAME]: nails, anchors, bolts, geosynthetics, piles and walls, in one declaration for all methods.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "input/language/spec.hpp"
#include "mesh/planar.hpp"

namespace talus::input {

struct Case;
class Findings;

enum class SupportKind { nail, anchor, bolt, geosynthetic, pile, wall };
/// Active: a load that the factor of safety does not divide. Passive: a resistance that it divides.
enum class SupportSense { usual, active, passive };
enum class SupportDirection { usual, axial, tangent, bisector, normal };
enum class RowSpacing { elevation, face };
enum class BondSides { both, one };
enum class LateralLaw { given, ito_matsui };
/// Treatment in limit equilibrium of slip surfaces that cross a wall.
enum class WallCrossing { excluded, resisted };

/// Resistances of nails, anchors, bolts and piles are those of one bar, those of geosynthetics and walls per metre of
/// width.
struct Support {
  SupportKind kind = SupportKind::nail;
  // The place of the bars is given by heads and ends, by x, or by a pattern of rows.
  std::vector<std::array<double, 2>> heads, ends;  ///< [m]
  std::vector<double> x;                           ///< of piles and walls from the ground down [m]
  std::vector<std::array<double, 2>> line;         ///< of a wall from its head to its toe [m]
  std::optional<std::array<double, 2>> first;      ///< head of the top row [m]
  int rows = 1;
  std::optional<double> row_spacing;  ///< [m]
  RowSpacing spacing_along = RowSpacing::elevation;
  std::optional<double> inclination;  ///< below the horizontal, into the soil [rad]
  std::optional<double> length;       ///< [m]
  std::vector<double> lengths;        ///< of each row or head [m]
  double out_of_plane_spacing = 1;    ///< [m]
  // Tension and pull-out:
  double tensile_strength = 0;                     ///< [N]
  double plate = 0;                                ///< resistance of head and facing [N]
  std::optional<double> bond;                      ///< [N/m]
  std::optional<double> bond_adhesion;             ///< [Pa]
  std::optional<double> bond_friction;             ///< δ [rad]
  double bond_scale = 1;                           ///< α [-]
  std::optional<double> diameter;                  ///< of the grout, or of a pile [m]
  std::optional<double> free_length, bond_length;  ///< of an anchor [m]
  double prestress = 0;                            ///< [N]
  double strength = 0;                             ///< of a geosynthetic [N/m]
  double connection = 0;                           ///< of a geosynthetic at its head [N/m]
  BondSides sides = BondSides::both;
  double coverage = 1;  ///< [-]
  // Piles:
  LateralLaw lateral_law = LateralLaw::given;
  std::optional<double> lateral_resistance;  ///< [N]
  std::optional<double> shear_strength;      ///< [N]
  // Walls:
  WallCrossing crossing = WallCrossing::excluded;
  std::optional<double> interface_strength;  ///< strength of the interface over that of the soil, R_inter [-]
  std::optional<double> plastic_force;       ///< N_p [N]
  std::optional<double> weight;              ///< per area of wall, less that of the soil it replaces [N/m²]
  std::optional<bool> permeable;             ///< false: no seepage through the wall
  std::vector<double> strut_levels;          ///< [m]
  std::optional<double> strut_stiffness;     ///< [N/m]
  double strut_strength = 0;                 ///< [N]
  double strut_prestress = 0;                ///< [N]
  // How the force acts:
  SupportSense sense = SupportSense::usual;
  SupportDirection direction = SupportDirection::usual;
  // For FEM and MPM:
  std::optional<double> axial_stiffness;    ///< E A of one bar [N]
  std::optional<double> sheet_stiffness;    ///< of a geosynthetic [N/m]
  std::optional<double> bending_stiffness;  ///< E I of one bar [N m²]
  std::optional<double> plastic_moment;     ///< of one bar [N m]
  std::optional<double> rupture_strain;     ///< plastic strain at which a bar tears in MPM [-]

  /// Returns true if the force is a load that the factor does not divide; usual for anchors and bolts.
  bool is_active() const {
    if (sense != SupportSense::usual) return sense == SupportSense::active;
    return kind == SupportKind::anchor || kind == SupportKind::bolt;
  }
  /// Returns the direction of the force; along the slip surface for piles and walls where none is given.
  SupportDirection find_direction() const {
    if (direction != SupportDirection::usual) return direction;
    const bool is_across = kind == SupportKind::pile || kind == SupportKind::wall;
    return is_across ? SupportDirection::tangent : SupportDirection::axial;
  }
};

template <>
inline constexpr auto choices<SupportKind> = std::array{
    Choice{SupportKind::nail, "nail", "a bar that is grouted over its length, with a head in the facing"},
    Choice{SupportKind::anchor, "anchor", "a tendon that is free behind its head and grouted at its end"},
    Choice{SupportKind::bolt, "bolt", "a bar that is anchored at its end: its capacity is the same all along"},
    Choice{SupportKind::geosynthetic, "geosynthetic", "a geogrid, geotextile or strip: friction on its sides"},
    Choice{SupportKind::pile, "pile", "a pile or shear key: a force across it where the slip surface crosses"},
    Choice{SupportKind::wall, "wall", "a sheet pile, diaphragm wall, gabion or facing: a plate along the slope"},
};
template <>
inline constexpr auto choices<SupportSense> = std::array{
    Choice{SupportSense::usual, "usual", "active for anchors and bolts, passive for the others"},
    Choice{SupportSense::active, "active",
           "the force is a load: the factor of safety divides the strength of soil only"},
    Choice{SupportSense::passive, "passive", "the force is a resistance: the factor of safety divides it as well"},
};
template <>
inline constexpr auto choices<SupportDirection> = std::array{
    Choice{SupportDirection::usual, "usual", "tangent for piles and walls, axial for the others"},
    Choice{SupportDirection::axial, "axial", "along the bar"},
    Choice{SupportDirection::tangent, "tangent", "along the slip surface, against the sliding"},
    Choice{SupportDirection::bisector, "bisector", "half-way between these two"},
    Choice{SupportDirection::normal, "normal", "across the bar, against the sliding"},
};
template <>
inline constexpr auto choices<RowSpacing> = std::array{
    Choice{RowSpacing::elevation, "elevation", "difference of the levels of two rows"},
    Choice{RowSpacing::face, "face", "distance along the ground"},
};
template <>
inline constexpr auto choices<BondSides> = std::array{
    Choice{BondSides::both, "both", "upper and lower side"},
    Choice{BondSides::one, "one", "one side, as on a smooth layer"},
};
template <>
inline constexpr auto choices<LateralLaw> = std::array{
    Choice{LateralLaw::given, "given", "`lateral_resistance`, wherever the surface crosses"},
    Choice{LateralLaw::ito_matsui, "ito_matsui",
           "the pressure of soil that flows plastically between piles, from the ground to the slip surface (Ito and "
           "Matsui 1975)"},
};

template <>
inline constexpr auto choices<WallCrossing> = std::array{
    Choice{WallCrossing::excluded, "excluded", "the search leaves out surfaces that cross the wall"},
    Choice{WallCrossing::resisted, "resisted", "`shear_strength` of the wall holds the sliding mass"},
};

void describe(Visitor& v, Support& s);

/// A bar of a support in the section.
struct BarLine {
  std::array<double, 2> head{}, end{};  ///< [m]
  int row = 1;  ///< from the top of the pattern, or the number of its head; the pieces of a polyline have the same
  double length() const;  ///< [m]
};

/// The bars of a support, or the reason for which they have no place: a sentence, and the key to which it belongs.
struct BarLayout {
  std::vector<BarLine> bars;
  std::string fault, key;
};

/// Places the bars of a support on the ground of the section, from left to right. Slopes to either side are treated
/// alike: bars lead into the soil.
BarLayout lay_bars(const Support& support, const mesh::Polyline& ground, const ShownUnit& length);

/// Returns true if the factor divides the force of a support in limit equilibrium and limit analysis.
bool has_passive_supports(const Case& data);
/// Returns why limit analysis does not take the supports of a case; nullopt if it does.
std::optional<std::string> find_support_obstacle(const Case& data);
/// Returns why limit analysis cannot judge the factors of LEM beside the supports of a case, which have to be bars with
/// axial forces; nullopt if it can.
std::optional<std::string> find_axial_obstacle(const Case& data);

/// Reports methods that do not take the supports of a case, and the stiffness that FEM and MPM need.
void check_support_methods(const Case& data, Findings& findings);

/// Checks [support.NAME]: patterns, resistances, and places in the soil.
void check_supports(const Case& data, Findings& findings);

}  // namespace talus::input
