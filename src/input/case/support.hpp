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

/// Declares where the bars lie.
void describe_bars(auto& v, Support& s) {
  v.key("heads", s.heads, quantity("m").example("[[10, 6], [10, 4.5]]"),
        "Heads, [x, y] each, on the ground (those of geosynthetics and piles may lie in the soil). Either these, or "
        "`first` and `rows`, or `x` of piles.");
  v.key("ends", s.ends, quantity("m").example("[[2, 5], [2, 3.5]]"),
        "Ends in the soil, one for each head, instead of `inclination` and `length`.");
  v.key("x", s.x, quantity("m").allowed_with("kind", s.kind, {SupportKind::pile, SupportKind::wall}).example("[17.5]"),
        "Instead of heads: x of piles, or of vertical walls, that begin at the ground.");
  v.key("line", s.line, quantity("m").allowed_with("kind", s.kind, SupportKind::wall).example("[[10, 6], [10, -2]]"),
        "Instead of heads: a wall from its head to its toe, [x, y] each; a facing as a polyline along the ground.");
  v.key("first", s.first, quantity("m").example("[10, 6]"), "Head of the top row, on the ground.");
  v.key("rows", s.rows, plain().at_least(1).at_most(200), "Rows from `first` down the slope.");
  v.key("row_spacing", s.row_spacing, quantity("m").above(0).example("1.5"), "Distance of the rows.");
  v.key("spacing_along", s.spacing_along, plain(), "How that distance is measured.");
  v.key("inclination", s.inclination, quantity("deg").at_least(-90).at_most(90).usual(-10, 90).example("15"),
        "Inclination below the horizontal, from the head into the soil. Geosynthetics: 0 if not given; piles and "
        "walls: 90.");
  v.key("length", s.length, quantity("m").above(0).example("8"), "Length of all bars.");
  v.key("lengths", s.lengths, quantity("m").above(0).example("[8, 8, 6]"), "Instead: the length of each row or head.");
  v.key("out_of_plane_spacing", s.out_of_plane_spacing,
        quantity("m")
            .above(0)
            .needed_with("kind", s.kind, {SupportKind::nail, SupportKind::anchor, SupportKind::bolt, SupportKind::pile})
            .example("1.5"),
        "Distance of the bars of a row along the slope, from axis to axis. It divides resistances and stiffness.");
}

/// Declares tension and pull-out.
void describe_pull_out(auto& v, Support& s) {
  using K = SupportKind;
  v.key("tensile_strength", s.tensile_strength,
        quantity("kN").above(0).needed_with("kind", s.kind, {K::nail, K::anchor, K::bolt}).example("118"),
        "Tensile strength of a bar; of a bolt the least of bar, anchorage and plate.");
  v.key("plate", s.plate,
        quantity("kN").at_least(0).or_infinite().needed_with("kind", s.kind, {K::nail, K::anchor}).example("86"),
        "Resistance of head, plate and facing. 0: none, so that soil in front may strip off the bar; inf: the bar "
        "breaks before.");
  v.key("bond", s.bond, quantity("kN/m").above(0).allowed_with("kind", s.kind, {K::nail, K::anchor}).example("15"),
        "Resistance to pull-out of a bar per metre of its grouted length, instead of adhesion and friction.");
  v.key("bond_adhesion", s.bond_adhesion,
        quantity("kPa")
            .at_least(0)
            .allowed_with("kind", s.kind, {K::nail, K::anchor, K::geosynthetic, K::wall})
            .example("5"),
        "Constant part of the bond stress on the surface of the grout, or on the sides of a sheet or wall.");
  v.key("bond_friction", s.bond_friction,
        quantity("deg")
            .at_least(0)
            .below(90)
            .allowed_with("kind", s.kind, {K::nail, K::anchor, K::geosynthetic, K::wall})
            .example("24"),
        "δ: the bond stress grows by α σ'_v tan δ, with the vertical effective stress of the soil above the bar; on "
        "a wall by σ'_n tan δ of the stress across it.");
  v.key("bond_scale", s.bond_scale,
        plain().above(0).at_most(10).allowed_with("kind", s.kind, {K::nail, K::anchor, K::geosynthetic}),
        "α, a factor on the friction: scale effect of geosynthetics, or K of nails.");
  v.key("diameter", s.diameter,
        quantity("m")
            .above(0)
            .usual(0.01, 3, {{"mm", 1e-3}})
            .allowed_with("kind", s.kind, {K::nail, K::anchor, K::pile})
            .example("0.1"),
        "Diameter of the grout, on which adhesion and friction act, or of a pile.");
  v.key("free_length", s.free_length, quantity("m").at_least(0).allowed_with("kind", s.kind, K::anchor).example("10"),
        "Length behind the head without bond. An anchor needs this or `bond_length`.");
  v.key("bond_length", s.bond_length, quantity("m").above(0).allowed_with("kind", s.kind, K::anchor).example("6"),
        "Grouted length at the end of an anchor.");
  v.key("prestress", s.prestress, quantity("kN").at_least(0).allowed_with("kind", s.kind, {K::anchor, K::bolt}),
        "Force after locking off. Above 0, an active bar pulls with this force in LEM, as far as its resistances "
        "allow; at 0 with the full resistance.");
  v.key("strength", s.strength, quantity("kN/m").above(0).needed_with("kind", s.kind, K::geosynthetic).example("40"),
        "Tensile strength of a geosynthetic per metre of its width.");
  v.key("connection", s.connection,
        quantity("kN/m").at_least(0).or_infinite().needed_with("kind", s.kind, K::geosynthetic).example("0"),
        "Resistance of its head per metre of width: a connection to a facing or a wrapped face. 0: the end is loose.");
  v.key("sides", s.sides, plain().allowed_with("kind", s.kind, K::geosynthetic), "Sides with adhesion and friction.");
  v.key("coverage", s.coverage, plain().above(0).at_most(1).allowed_with("kind", s.kind, K::geosynthetic),
        "Width of the strips over the distance of their axes; 1: a sheet. It reduces strength, connection and bond.");
}

/// Declares what walls alone have.
void describe_wall(auto& v, Support& s) {
  using K = SupportKind;
  v.key("crossing", s.crossing, plain().allowed_with("kind", s.kind, K::wall),
        "Slip surfaces of LEM that cross the wall.");
  v.key("interface_strength", s.interface_strength,
        plain().above(0).at_most(1).allowed_with("kind", s.kind, K::wall).example("0.67"),
        "R_inter: cohesion and tan φ of the interface over those of the soil beside it, for FEM and limit analysis, "
        "instead of "
        "`bond_adhesion` and `bond_friction`.");
  v.key("plastic_force", s.plastic_force, quantity("kN").above(0).allowed_with("kind", s.kind, K::wall).example("2500"),
        "N_p of a metre of wall, for FEM and limit analysis: its axial strength in tension and compression. With "
        "`plastic_moment` too, "
        "axial "
        "force and moment interact: |N|/N_p + |M|/M_p ≤ 1.");
  v.key("weight", s.weight, quantity("kPa").at_least(0).allowed_with("kind", s.kind, K::wall).example("8"),
        "Weight of a square metre of wall, kN/m², less that of the soil that it replaces, for all methods. Not given: "
        "the "
        "wall weighs as much as that soil.");
  v.key("permeable", s.permeable, plain().allowed_with("kind", s.kind, K::wall).example("false"),
        "false: no water seeps through the wall. Required with a wall where pore pressures follow from seepage.");
  v.key("strut_levels", s.strut_levels, quantity("m").allowed_with("kind", s.kind, K::wall).example("[5, 2]"),
        "y of horizontal struts on the side of the wall without soil, for FEM and limit analysis.");
  v.key("strut_stiffness", s.strut_stiffness,
        quantity("kN/m").above(0).allowed_with("kind", s.kind, K::wall).example("5e4"),
        "E A over the free length of a strut, per metre of wall.");
  v.key("strut_strength", s.strut_strength,
        quantity("kN").at_least(0).or_infinite().allowed_with("kind", s.kind, K::wall).example("400"),
        "Compressive strength of a strut, per metre of wall. In tension it has none.");
  v.key("strut_prestress", s.strut_prestress, quantity("kN").at_least(0).allowed_with("kind", s.kind, K::wall),
        "Compression of a strut after the loads are applied, at which it is locked off.");
}

void describe(auto& v, Support& s) {
  using K = SupportKind;
  v.key("kind", s.kind, plain().required().example(R"("nail")"), "What the support is.");
  describe_bars(v, s);
  describe_pull_out(v, s);
  v.key("lateral_law", s.lateral_law, plain().allowed_with("kind", s.kind, K::pile),
        "Where the force of a pile on the sliding soil comes from.");
  v.key("lateral_resistance", s.lateral_resistance,
        quantity("kN").above(0).allowed_with("kind", s.kind, K::pile).example("50"),
        "Force of one pile on the sliding soil, with lateral_law = \"given\".");
  v.key("shear_strength", s.shear_strength,
        quantity("kN").above(0).allowed_with("kind", s.kind, {K::pile, K::wall}).example("300"),
        "Shear strength of one pile or of a metre of wall, an upper limit of its force.");
  describe_wall(v, s);
  v.key("sense", s.sense, plain(), "How the force enters the factor of safety. It is printed with every factor.");
  v.key("direction", s.direction, plain(), "Direction of the force on the sliding mass in LEM.");
  v.key("axial_stiffness", s.axial_stiffness,
        quantity("kN")
            .above(0)
            .allowed_with("kind", s.kind, {K::nail, K::anchor, K::bolt, K::pile, K::wall})
            .example("1e5"),
        "E A of one bar, for FEM and MPM, or of a metre of wall.");
  v.key("sheet_stiffness", s.sheet_stiffness,
        quantity("kN/m").above(0).allowed_with("kind", s.kind, K::geosynthetic).example("800"),
        "Stiffness J of a geosynthetic per metre of width, for FEM and MPM.");
  v.key("bending_stiffness", s.bending_stiffness,
        quantity("kN.m2").above(0).allowed_with("kind", s.kind, {K::nail, K::pile, K::wall}).example("2e4"),
        "E I of one bar or of a metre of wall, for FEM.");
  v.key("plastic_moment", s.plastic_moment,
        quantity("kN.m").above(0).allowed_with("kind", s.kind, {K::nail, K::pile, K::wall}).example("150"),
        "Plastic moment M_p of one bar or of a metre of wall, for FEM; that of walls for limit analysis too.");
  v.key("rupture_strain", s.rupture_strain,
        plain()
            .above(0)
            .at_most(10)
            .allowed_with("kind", s.kind, {K::nail, K::anchor, K::bolt, K::geosynthetic})
            .example("0.05"),
        "Plastic strain at which a bar tears in MPM. Without it a bar yields and holds its tensile strength.");
}

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

/// Reports methods that do not take the supports of a case, and the stiffness that FEM and MPM need.
void check_support_methods(const Case& data, Findings& findings);

/// Checks [support.NAME]: patterns, resistances, and places in the soil.
void check_supports(const Case& data, Findings& findings);

}  // namespace talus::input
