// SPDX-License-Identifier: MIT
#include "input/case/support.hpp"
#include "input/language/visitor.hpp"

namespace talus::input {

namespace {

/// Declares where the bars lie.
void describe_bars(Visitor& v, Support& s) {
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

}  // namespace

namespace {

/// Declares tension and pull-out.
void describe_pull_out(Visitor& v, Support& s) {
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
        "Diameter of the grout, on which adhesion and friction act, or of a pile. A row of piles without it holds on "
        "to the stable soil of LEM as a wall does.");
  v.key("free_length", s.free_length, quantity("m").at_least(0).allowed_with("kind", s.kind, K::anchor).example("10"),
        "Length behind the head without bond. An anchor needs this or `bond_length`.");
  v.key("bond_length", s.bond_length, quantity("m").above(0).allowed_with("kind", s.kind, K::anchor).example("6"),
        "Grouted length at the end of an anchor.");
  v.key("prestress", s.prestress, quantity("kN").at_least(0).allowed_with("kind", s.kind, {K::anchor, K::bolt}),
        "Force after locking off. In LEM an active bar has at least this force, also where it drives the mass; a "
        "mass that moves stretches it to its resistance.");
  v.key("strength", s.strength, quantity("kN/m").above(0).needed_with("kind", s.kind, K::geosynthetic).example("40"),
        "Tensile strength of a geosynthetic per metre of its width.");
  v.key("connection", s.connection,
        quantity("kN/m").at_least(0).or_infinite().needed_with("kind", s.kind, K::geosynthetic).example("0"),
        "Resistance of its head per metre of width: a connection to a facing or a wrapped face. 0: the end is loose.");
  v.key("sides", s.sides, plain().allowed_with("kind", s.kind, K::geosynthetic), "Sides with adhesion and friction.");
  v.key("coverage", s.coverage, plain().above(0).at_most(1).allowed_with("kind", s.kind, K::geosynthetic),
        "Width of the strips over the distance of their axes; 1: a sheet. It reduces strength, connection and bond.");
}

}  // namespace

namespace {

/// Declares what walls alone have.
void describe_wall(Visitor& v, Support& s) {
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

}  // namespace

void describe(Visitor& v, Support& s) {
  using K = SupportKind;
  v.key("kind", s.kind, plain().required().example(R"("nail")"), "What the support is.");
  describe_bars(v, s);
  describe_pull_out(v, s);
  v.key("lateral_law", s.lateral_law, plain().allowed_with("kind", s.kind, K::pile),
        "Where the force of a pile on the sliding soil comes from.");
  v.key("lateral_resistance", s.lateral_resistance,
        quantity("kN").above(0).allowed_with("kind", s.kind, K::pile).example("50"),
        "Largest force of one pile on the sliding soil, with lateral_law = \"given\"; its embedment and its plastic "
        "moment limit it too.");
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
        "Plastic moment M_p of one bar or of a metre of wall, for FEM; that of piles for LEM too, that of walls for "
        "limit analysis.");
  v.key("rupture_strain", s.rupture_strain,
        plain()
            .above(0)
            .at_most(10)
            .allowed_with("kind", s.kind, {K::nail, K::anchor, K::bolt, K::geosynthetic})
            .example("0.05"),
        "Plastic strain at which a bar tears in MPM. Without it a bar yields and holds its tensile strength.");
}

}  // namespace talus::input
