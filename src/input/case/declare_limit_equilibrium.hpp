#pragma once
// [lem], what slices need of a material, [[surcharge]], [earthquake] and [partial_factors].

#include "input/case/case.hpp"
#include "input/language/codec_list.hpp"

namespace talus::input {

template <>
inline constexpr auto choices<SliceMethod> = std::array{
    Choice{SliceMethod::fellenius, "fellenius", "ordinary method of slices; moments, circles only"},
    Choice{SliceMethod::bishop, "bishop", "Bishop's simplified method; moments"},
    Choice{SliceMethod::janbu, "janbu", "Janbu's simplified method; horizontal forces, not corrected"},
    Choice{SliceMethod::janbu_corrected, "janbu_corrected", "the same times Janbu's f₀"},
    Choice{SliceMethod::spencer, "spencer", "forces and moments; interslice forces are parallel"},
    Choice{SliceMethod::morgenstern_price, "morgenstern_price",
           "forces and moments; their inclination follows half a sine wave"},
    Choice{SliceMethod::morgenstern_price_constant, "morgenstern_price_constant", "the same with a constant function"},
};
template <>
inline constexpr auto choices<SurfaceSearch> = std::array{
    Choice{SurfaceSearch::entry_exit, "entry_exit",
           "circles through an entry and an exit on the ground, several deep each; [lem.entry_exit]"},
    Choice{SurfaceSearch::grid, "grid", "circles about the points of a grid, several radii each; [lem.grid]"},
    Choice{SurfaceSearch::none, "none", "the surfaces of [[lem.surface]] alone"},
};
template <>
inline constexpr auto choices<SuctionStrength> = std::array{
    Choice{SuctionStrength::from_water, "from_water",
           "as \"saturation\" where [materials.NAME.water] has a retention curve, else \"none\""},
    Choice{SuctionStrength::none, "none", "nothing: no pore pressure above the water table"},
    Choice{SuctionStrength::saturation, "saturation", "χ s tan φ with χ = S, Bishop's effective stress"},
    Choice{SuctionStrength::phi_b, "phi_b", "s tan φᵇ, after Fredlund"},
};
template <>
inline constexpr auto choices<DesignApproach> = std::array{
    Choice{DesignApproach::none, "none", "characteristic values"},
    Choice{DesignApproach::da1_1, "DA1-1", "A1 + M1 + R1: γ_G 1.35, γ_Q 1.5"},
    Choice{DesignApproach::da1_2, "DA1-2", "A2 + M2 + R1: γ_Q 1.3, γ_φ' 1.25, γ_c' 1.25, γ_cu 1.4"},
    Choice{DesignApproach::da2, "DA2", "A1 + M1 + R2: γ_G 1.35, γ_Q 1.5, γ_R;e 1.1"},
    Choice{DesignApproach::da3, "DA3",
           "A2 + M2 + R3: γ_Q 1.3, γ_φ' 1.25, γ_c' 1.25, γ_cu 1.4; loads on a slope count as geotechnical actions"},
    Choice{DesignApproach::by_hand, "by_hand", "the factors below; those not given are 1"},
};

template <class Visitor>
void describe(Visitor& v, SlipSurface& s) {
  v.key("name", s.name, plain().required().example(R"("A")"), "Name of the surface in tables and plots.");
  v.key("centre", s.centre, quantity("m").example("[30, 25]"), "Centre of a circle.");
  v.key("radius", s.radius, quantity("m").above(0).example("20"), "Radius of the circle.");
  v.key("ends", s.ends, quantity("m").example("[12, 32]"),
        "x of the two points on the ground between which the arc slides; if not given, those where circle and ground "
        "meet, the longest part of the soil between two of them.");
  v.key("points", s.points, quantity("m").example("[[8, 15], [20, 6], [32, 5]]"),
        "Instead of a circle: corners of a polyline from left to right. Its ends lie on the ground.");
}

template <class Visitor>
void describe(Visitor& v, EntryExit& e) {
  v.key("exit", e.exit, quantity("m").example("[28, 36]"),
        "From which x to which x surfaces come out of the ground at the toe; empty: all of the ground.");
  v.key("entry", e.entry, quantity("m").example("[2, 14]"), "The same of where they begin at the crest.");
  v.key("exits", e.exits, plain().at_least(2).at_most(1000), "Exits in that range.");
  v.key("entries", e.entries, plain().at_least(2).at_most(1000), "Entries in that range.");
  v.key("depths", e.depths, plain().at_least(1).at_most(1000), "Circles through each pair, from flat to deep.");
}

template <class Visitor>
void describe(Visitor& v, CentreGrid& g) {
  v.key("corners", g.corners, quantity("m").example("[[20, 16], [40, 36]]"),
        "Lower left and upper right corner of the grid of centres; empty: chosen from the ground.");
  v.key("columns", g.columns, plain().at_least(1).at_most(1000), "Centres side by side.");
  v.key("rows", g.rows, plain().at_least(1).at_most(1000), "Centres one above the other.");
  v.key("radii", g.radii, plain().at_least(1).at_most(1000), "Circles about each centre.");
  v.key("levels", g.levels, quantity("m").example("[0, 6]"),
        "Lowest and highest level of the deepest point of a circle; empty: from the base of the section to above the "
        "toe.");
}

template <class Visitor>
void describe(Visitor& v, TensionCrack& t) {
  v.key("depth", t.depth, quantity("m").at_least(0),
        "Depth of a vertical crack at the upper end of every surface; 0: none.");
  v.key("water", t.water, quantity("m").at_least(0), "Height of the water in it, above its bottom.");
}

template <class Visitor>
void describe(Visitor& v, LimitEquilibrium& l) {
  v.key("methods", l.methods, plain(), "Methods of slices.");
  v.key("slices", l.slices, plain().at_least(5).at_most(2000), "Slices of a surface, about.");
  v.key("search", l.search, plain(), "How the critical circle is searched for.");
  v.key("composite", l.composite, plain(),
        "Circles that reach the bottom of the section go on along it; otherwise they are refused.");
  v.key("noncircular", l.noncircular, plain(), "Go on from the critical circle to the critical polyline.");
  v.key("vertices", l.vertices, plain().at_least(3).at_most(100), "Corners of that polyline.");
  v.key("minima", l.minima, plain().at_least(1).at_most(50), "Local minima that are told apart and shown.");
  v.key("smallest_depth", l.smallest_depth, quantity("m").at_least(0),
        "Surfaces whose sliding mass is nowhere deeper than this are refused.");
  v.key("smallest_m_alpha", l.smallest_m_alpha, plain().at_least(0).below(1),
        "A surface with a smaller m_α at one of its slices fails the checks.");
  v.key("most_tension", l.most_tension, plain().at_least(0).at_most(1),
        "So does one with tensile effective normal forces on more than this share of its length.");
  v.key("most_thrust_outside", l.most_thrust_outside, plain().at_least(0).at_most(1),
        "So does one on which more than this share of the interslice forces acts outside the sliding mass (Spencer and "
        "Morgenstern–Price).");
  v.key("reject", l.reject, plain(),
        "Surfaces that fail the checks are refused and counted by their reason; false: they only bring a warning.");
  v.key("yield_acceleration", l.yield_acceleration, plain(),
        "Find the horizontal acceleration with factor 1 of the critical surfaces.");
  v.table("entry_exit", l.entry_exit, "Where search = \"entry_exit\" looks.");
  v.table("grid", l.grid, "Where search = \"grid\" looks.");
  v.table("tension_crack", l.crack, "A crack at the crest.");
  v.tables("surface", l.surfaces, 0,
           "A slip surface of your choice, by the methods of `methods`: a circle (centre and radius) or a polyline.");
}

/// What slices and finite elements need of a soil beside its strength; `unit_weight` stands further up.
template <class Visitor>
void describe_slice_soil(Visitor& v, Material& m) {
  const auto strength = {MaterialModel::mohr_coulomb, MaterialModel::rooted_mohr_coulomb};
  SliceSoil& s = m.slices;
  v.key(
      "saturated_unit_weight", s.saturated_unit_weight, quantity("kN/m3").above(0).example("20"),
      "Weight of the soil with its water below the water table, for slices and finite elements; if not given, that of "
      "grains and water where `grain_density` is given, else `unit_weight`.");
  v.key(
      "pore_pressure_ratio", s.pore_pressure_ratio, plain().at_least(0).below(1),
      "r_u, pore pressure over the weight of the soil above, in the place of a water table; slices and finite elements "
      "only.");
  v.key("suction_strength", s.suction_strength, plain(),
        "What suction s adds to the strength above the water table; slices and finite elements only. Material points "
        "follow [materials.NAME.water].");
  v.key("phi_b", s.phi_b,
        quantity("deg")
            .at_least(0)
            .below(90)
            .needed_with("suction_strength", s.suction_strength, SuctionStrength::phi_b)
            .example("15"),
        "φᵇ of that.");
  v.key("cohesion_gradient", s.cohesion_gradient,
        quantity("kPa/m").allowed_with("model", m.model, strength).example("1.5"),
        "The cohesion grows by this per metre below `cohesion_level`; slices and finite elements only.");
  v.key("cohesion_level", s.cohesion_level, quantity("m").allowed_with("model", m.model, strength).example("15"),
        "Level y at which that growth begins; `cohesion_gradient` needs it.");
}

template <class Visitor>
void describe(Visitor& v, Surcharge& s) {
  v.key("name", s.name, plain().required().example(R"("road")"), "Name of the load.");
  v.key("x", s.x, quantity("m").required().example("[2, 8]"), "Where on the ground, from left to right.");
  v.key("load", s.load, quantity("kPa").required().example("[20, 20]"),
        "Load per horizontal area at each x, downwards, linear between them; none outside.");
  v.key("variable", s.variable, plain(), "A variable action in the sense of Eurocode 7; false: a permanent one.");
}

template <class Visitor>
void describe(Visitor& v, Earthquake& e) {
  v.key("horizontal", e.horizontal, plain().at_least(0), "k_h, horizontal acceleration over g, out of the slope.");
  v.key("vertical", e.vertical, plain().above(-1),
        "k_v, vertical acceleration over g; down (more weight) is positive.");
}

template <class Visitor>
void describe(Visitor& v, PartialFactors& p) {
  const auto none = DesignApproach::none;
  v.key("set", p.set, plain(),
        "Partial factors of EN 1997-1:2004, Annex A (recommended values). Factors that are given replace those of the "
        "set.");
  v.key("cohesion", p.cohesion, plain().above(0).allowed_unless("set", p.set, none).example("1.25"),
        "γ_c', which divides c' and the cohesion of roots. M1: 1, M2: 1.25.");
  v.key("friction", p.friction, plain().above(0).allowed_unless("set", p.set, none).example("1.25"),
        "γ_φ', which divides tan φ' (and tan φᵇ). M1: 1, M2: 1.25.");
  v.key("undrained", p.undrained, plain().above(0).allowed_unless("set", p.set, none).example("1.4"),
        "γ_cu, which divides the cohesion of soils with φ = 0. M1: 1, M2: 1.4.");
  v.key("weight", p.weight, plain().above(0).allowed_unless("set", p.set, none).example("1.0"),
        "γ_γ, which divides the unit weight. M1 and M2: 1.");
  v.key(
      "permanent_load", p.permanent_load, plain().above(0).allowed_unless("set", p.set, none).example("1.35"),
      "γ_G of permanent actions: surcharges, and the weight of soil and water, whose driving and resisting parts come "
      "from one source and share one factor (2.4.2(9)P). A1: 1.35, A2: 1. As only ratios count, strengths in kPa are "
      "divided by γ_G, permanent actions keep their value, and variable ones are multiplied by γ_Q/γ_G.");
  v.key("variable_load", p.variable_load, plain().above(0).allowed_unless("set", p.set, none).example("1.5"),
        "γ_Q of variable surcharges, which are to stand only where they are unfavourable. A1: 1.5, A2: 1.3.");
  v.key("resistance", p.resistance, plain().above(0).allowed_unless("set", p.set, none).example("1.1"),
        "γ_R;e, which divides the factor of safety. R1 and R3: 1, R2: 1.1.");
}

}  // namespace talus::input
