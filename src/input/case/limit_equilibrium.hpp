// SPDX-License-Identifier: MIT
#pragma once
// [lem]: slip surfaces, limit equilibrium methods and the search for the critical surface.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/methods.hpp"
#include "input/language/spec.hpp"

namespace talus::input {

using talus::DrawdownMethod;
using talus::SliceMethod;
enum class SurfaceSearch { none, entry_exit, grid, block };
enum class SlidingDirection { both, left, right };
enum class LayerSide { top, bottom };

/// A slip surface given by the user: a circle or a polyline.
struct SlipSurface {
  std::string name;
  std::optional<std::array<double, 2>> centre;  ///< of a circle [m]
  std::optional<double> radius;                 ///< [m]
  std::vector<double> ends;  ///< x of the ends of the arc on the ground [m]; empty: intersections with the ground
  std::vector<std::array<double, 2>> points;  ///< of a polyline, from left to right [m]
};

/// Search by entry and exit ranges on the ground and depths between them.
struct EntryExit {
  std::vector<double> exit, entry;  ///< [from, to] in x [m]; empty: the whole ground
  int exits = 25, entries = 25, depths = 15;
};

/// Search by a grid of centres, with radii between two tangent levels.
struct CentreGrid {
  std::vector<std::array<double, 2>> corners;  ///< lower left, upper right [m]; empty: derived from the ground
  int columns = 20, rows = 20, radii = 21;
  std::vector<double>
      levels;  ///< [lowest, highest] deepest point of the circles [m]; empty: from the base to above the toe
};

/// A part of the section through which slip surfaces pass: a point, a polyline or a box.
struct SurfaceWindow {
  std::string name;
  std::vector<std::array<double, 2>> points;  ///< one point, or a polyline [m]
  std::vector<std::array<double, 2>> box;     ///< two opposite corners [m]
};

/// An area that no slip surface enters.
struct ExcludedArea {
  std::string name;
  std::vector<std::array<double, 2>> points;  ///< corners of a polygon [m]
};

/// Search for polylines with a vertex in each of several windows, or along a layer or line.
struct BlockSearch {
  std::string along;  ///< region, material or line that the surfaces follow; empty: windows
  /// Ranges of the inclination of the upper and the lower end of the surface [rad].
  std::vector<double> active{0.785398163397448, 1.221730476396031}, passive{0.261799387799149, 0.785398163397448};
  int angles = 5, surfaces = 5000;
  std::vector<SurfaceWindow> windows;
};

/// Restriction of circles to those whose deepest point lies at a level, or that touch a layer.
struct TangentCircles {
  std::vector<double> levels;       ///< one level, or [lowest, highest] [m]
  std::string layer;                ///< region, material or line that the circles touch
  LayerSide side = LayerSide::top;  ///< side of the layer
};

struct TensionCrack {
  double depth = 0;   ///< [m]; 0: none
  double water = 0;   ///< height of water in it [m]
  bool limit = true;  ///< limit the depth to the zone in tension
};

/// Rapid drawdown: the water beside the slope falls faster than the soil drains.
struct Drawdown {
  DrawdownMethod method = DrawdownMethod::three_stage;
  std::vector<std::array<double, 2>> water_table;  ///< after drawdown [m]; horizontal beyond its ends
};

struct LimitEquilibrium {
  std::vector<SliceMethod> methods{SliceMethod::bishop, SliceMethod::janbu_corrected, SliceMethod::spencer,
                                   SliceMethod::morgenstern_price};
  int slices = 50;
  SurfaceSearch search = SurfaceSearch::entry_exit;
  EntryExit entry_exit;
  CentreGrid grid;
  BlockSearch block;
  std::optional<TangentCircles> tangent;
  std::vector<ExcludedArea> excluded;
  std::vector<SurfaceWindow> passages;
  std::vector<std::string> impenetrable;  ///< materials whose top surfaces follow
  SlidingDirection slides = SlidingDirection::both;
  std::optional<double> smallest_area;    ///< of the sliding mass [m²]
  std::optional<double> smallest_weight;  ///< of the sliding mass [N/m]
  bool composite = false;                 ///< composite surfaces: circles follow the bottom of the model
  bool noncircular = true;                ///< also search a non-circular surface
  int vertices = 12;                      ///< of the non-circular surface
  int minima = 5;                         ///< number of reported local minima
  int seed = 0;                           ///< of the random starts of the search
  std::optional<double> smallest_depth;   ///< of the sliding mass [m]
  double smallest_m_alpha = 0.2;          ///< [-]
  double most_tension = 0.2;              ///< limit of the fraction of the base with tensile N' [-]
  double most_thrust_outside = 0.3;       ///< limit of the fraction of E whose line of thrust is outside the mass [-]
  double smallest_lambda = -0.1, largest_lambda = 1.5;  ///< limits of λ in Spencer and Morgenstern–Price [-]
  bool reject = true;                                   ///< reject surfaces that fail these checks
  bool yield_acceleration = true;                       ///< compute k_y of the critical surfaces
  bool referee = true;                                  ///< compare the factors with bounds by limit analysis
  TensionCrack crack;
  std::optional<Drawdown> drawdown;
  std::vector<SlipSurface> surfaces;
};

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
    Choice{SliceMethod::corps_1, "corps_1", "forces; interslice forces parallel to the line between the ends"},
    Choice{SliceMethod::corps_2, "corps_2", "forces; interslice forces parallel to the ground above them"},
    Choice{SliceMethod::lowe_karafiath, "lowe_karafiath", "forces; inclined as the mean of ground and base"},
    Choice{SliceMethod::modified_swedish, "modified_swedish",
           "forces; interslice forces parallel to the face, from the lower end to the crest of the mass"},
};
template <>
inline constexpr auto choices<SurfaceSearch> = std::array{
    Choice{SurfaceSearch::entry_exit, "entry_exit",
           "circles through an entry and an exit on the ground, several deep each; [lem.entry_exit]"},
    Choice{SurfaceSearch::grid, "grid", "circles about the points of a grid, several radii each; [lem.grid]"},
    Choice{SurfaceSearch::block, "block", "polylines through windows or along a layer; [lem.block]"},
    Choice{SurfaceSearch::none, "none", "the surfaces of [[lem.surface]] alone"},
};
template <>
inline constexpr auto choices<SlidingDirection> = std::array{
    Choice{SlidingDirection::both, "both", "to either side"},
    Choice{SlidingDirection::left, "left", "towards smaller x: the slope faces left"},
    Choice{SlidingDirection::right, "right", "towards larger x: the slope faces right"},
};
template <>
inline constexpr auto choices<LayerSide> = std::array{
    Choice{LayerSide::top, "top", "its upper side"},
    Choice{LayerSide::bottom, "bottom", "its lower side"},
};

template <>
inline constexpr auto choices<DrawdownMethod> = std::array{
    Choice{DrawdownMethod::corps_1970, "corps_1970",
           "two stages: the lower of the R envelope and the effective one, at the effective normal stress before"},
    Choice{DrawdownMethod::lowe_karafiath, "lowe_karafiath",
           "two stages: between the undrained strengths of isotropic consolidation and of consolidation at failure"},
    Choice{DrawdownMethod::three_stage, "three_stage",
           "the same, and the drained strength where that is lower (Duncan, Wright and Wong)"},
    Choice{DrawdownMethod::b_bar, "b_bar",
           "effective stresses: pore pressures fall by B̄ times the weight of the standing water that is gone"},
};

void describe(auto& v, SlipSurface& s) {
  v.key("name", s.name, plain().required().example(R"("A")"), "Name of the surface in tables and plots.");
  v.key("centre", s.centre, quantity("m").example("[30, 25]"), "Centre of a circle.");
  v.key("radius", s.radius, quantity("m").above(0).example("20"), "Radius of the circle.");
  v.key("ends", s.ends, quantity("m").example("[12, 32]"),
        "x of the two points on the ground between which the arc slides; if not given, those where circle and ground "
        "meet, the longest part of the soil between two of them.");
  v.key("points", s.points, quantity("m").example("[[8, 15], [20, 6], [32, 5]]"),
        "Instead of a circle: corners of a polyline from left to right. Its ends lie on the ground.");
}

void describe(auto& v, EntryExit& e) {
  v.key("exit", e.exit, quantity("m").example("[28, 36]"),
        "From which x to which x surfaces come out of the ground at the toe; empty: all of the ground.");
  v.key("entry", e.entry, quantity("m").example("[2, 14]"), "The same of where they begin at the crest.");
  v.key("exits", e.exits, plain().at_least(2).at_most(1000), "Exits in that range.");
  v.key("entries", e.entries, plain().at_least(2).at_most(1000), "Entries in that range.");
  v.key("depths", e.depths, plain().at_least(1).at_most(1000), "Circles through each pair, from flat to deep.");
}

void describe(auto& v, CentreGrid& g) {
  v.key("corners", g.corners, quantity("m").example("[[20, 16], [40, 36]]"),
        "Lower left and upper right corner of the grid of centres; empty: chosen from the ground.");
  v.key("columns", g.columns, plain().at_least(1).at_most(1000), "Centres side by side.");
  v.key("rows", g.rows, plain().at_least(1).at_most(1000), "Centres one above the other.");
  v.key("radii", g.radii, plain().at_least(1).at_most(1000), "Circles about each centre.");
  v.key("levels", g.levels, quantity("m").example("[0, 6]"),
        "Lowest and highest level of the deepest point of a circle; empty: from the base of the section to above the "
        "toe.");
}

void describe(auto& v, SurfaceWindow& w) {
  v.key("name", w.name, plain().required().example(R"("A")"), "Name of the window in messages and pictures.");
  v.key("points", w.points, quantity("m").example("[[10, 3], [18, 4]]"), "A point or a polyline.");
  v.key("box", w.box, quantity("m").example("[[10, 2], [18, 4]]"), "Instead of points: two opposite corners of a box.");
}

void describe(auto& v, ExcludedArea& e) {
  v.key("name", e.name, plain().required().example(R"("cellar")"), "Name of the area in messages and pictures.");
  v.key("points", e.points, quantity("m").required().example("[[20, 2], [28, 2], [28, 8], [20, 8]]"),
        "Corners of its polygon, in order. A surface may run along its sides.");
}

void describe(auto& v, BlockSearch& b) {
  v.key(
      "along", b.along, plain().example(R"("seam")"),
      "Region, material or [[geometry.line]] that the surfaces follow, instead of windows: in a layer from its bottom "
      "to its top, along a line in the soil above it.");
  v.key("active", b.active, quantity("deg").at_least(1).at_most(89),
        "From which to which inclination the surface rises at its upper end, measured from the horizontal. In "
        "drawings of a slope that falls to the left this is the right projection angle.");
  v.key("passive", b.passive, quantity("deg").at_least(-60).at_most(80),
        "The same at the lower end, where it rises to the ground; negative: it falls. A vertex on the ground is an "
        "end and has no such line.");
  v.key("angles", b.angles, plain().at_least(1).at_most(100), "Inclinations in each of these ranges.");
  v.key("surfaces", b.surfaces, plain().at_least(10).at_most(1000000),
        "About so many surfaces are tried, evenly over windows and inclinations; the best are then optimised within "
        "them.");
  v.tables("window", b.windows, 0,
           "Each surface has a vertex in each window, two windows at least and eight at most. The vertices are "
           "ordered by x.");
}

void describe(auto& v, TangentCircles& t) {
  v.key("levels", t.levels, quantity("m").example("[2, 4]"),
        "Level of the deepest point of every circle: one number, or from where to where.");
  v.key("layer", t.layer, plain().example(R"("clay")"),
        "Instead of levels: region, material or [[geometry.line]] that every circle touches from above.");
  v.key("side", t.side, plain(), "Which side of the layer.");
}

void describe(auto& v, TensionCrack& t) {
  v.key("depth", t.depth, quantity("m").at_least(0),
        "Depth of a vertical crack at the upper end of every surface; 0: none.");
  v.key("water", t.water, quantity("m").at_least(0), "Height of the water in it, above its bottom.");
  v.key("limit", t.limit, plain(),
        "The crack ends where the soil would no longer be in tension beside it: Rankine's active stress, less the "
        "pressure of the water in the crack, is zero there (2c/γ·tan(45° + φ/2) where all is dry). With water in it "
        "each surface has this depth or the given one, whichever is weaker. false: it is as deep as `depth`, as a "
        "joint that was measured.");
}

void describe(auto& v, Drawdown& d) {
  v.key("method", d.method, plain().required().example(R"("three_stage")"), "Where the strength after it comes from.");
  v.key("water_table", d.water_table, quantity("m").required().example("[[0, 7], [60, 7]]"),
        "The water table after drawdown, from left to right, as [initial] water_table: level beyond its ends, and "
        "standing water where it is above the ground.");
}

void describe(auto& v, LimitEquilibrium& l) {
  v.key("methods", l.methods, plain(), "Methods of slices.");
  v.key("slices", l.slices, plain().at_least(5).at_most(2000), "Slices of a surface, about.");
  v.key("search", l.search, plain(), "How the critical circle is searched for.");
  v.key("composite", l.composite, plain(),
        "Circles that reach the bottom of the section continue along it; otherwise they are rejected.");
  v.key("noncircular", l.noncircular, plain(), "Continue from the critical circle to the critical polyline.");
  v.key("vertices", l.vertices, plain().at_least(3).at_most(100), "Corners of that polyline.");
  v.key("minima", l.minima, plain().at_least(1).at_most(50), "Distinct local minima that are shown.");
  v.key("seed", l.seed, plain().at_least(0),
        "Another number starts the search elsewhere: entries, exits and blocks along layers move by random parts of "
        "the distance to their neighbours. A minimum that moves with it was not found; 0: they stand evenly.");
  v.key("smallest_depth", l.smallest_depth, quantity("m").at_least(0).example("1"),
        "Surfaces whose sliding mass is nowhere deeper than this are refused; if not given, the search refuses those "
        "below a fiftieth of the ground's relief, or below 0.5 m where that is less.");
  v.key("smallest_area", l.smallest_area, quantity("m2").above(0).example("5"),
        "Surfaces with a smaller area of the sliding mass are refused.");
  v.key("smallest_weight", l.smallest_weight, quantity("kN/m").above(0).example("100"),
        "Surfaces with a lighter sliding mass, per length of the slope, are refused.");
  v.key("slides", l.slides, plain(),
        "Only surfaces that slide to this side; the exit lies there. It serves a section with two slopes, such as a "
        "dam.");
  v.key("impenetrable", l.impenetrable, plain().example(R"(["rock"])"),
        "Materials that no surface enters: circles and polylines that would cut below their top follow it "
        "in the soil above.");
  v.key("smallest_m_alpha", l.smallest_m_alpha, plain().at_least(0).below(1),
        "A surface with a smaller m_α at one of its slices fails the checks.");
  v.key("most_tension", l.most_tension, plain().at_least(0).at_most(1),
        "A surface with tensile effective normal forces on more than this fraction of its length fails the checks.");
  v.key("most_thrust_outside", l.most_thrust_outside, plain().at_least(0).at_most(1),
        "A surface with more than this fraction of its interslice forces outside the sliding mass fails the checks "
        "(Spencer and Morgenstern–Price).");
  v.key("reject", l.reject, plain(),
        "Surfaces that fail these checks are refused and counted by their reason; false: they only bring a warning.");
  v.key(
      "largest_lambda", l.largest_lambda, plain().above(0),
      "A solution of Spencer or Morgenstern–Price with a larger λ has no factor, whatever `reject` is: its interslice "
      "forces are steeper than the strength of soil allows.");
  v.key("smallest_lambda", l.smallest_lambda, plain().at_most(0),
        "Surfaces with a smaller λ have no factor either: the interslice shear would oppose sliding.");
  v.key("yield_acceleration", l.yield_acceleration, plain(),
        "Find the horizontal acceleration with factor 1 of the critical surfaces; not with [lem.drawdown].");
  v.key("referee", l.referee, plain(),
        "Hold every factor against limit analysis (ψ = φ, tension up to the apex): a factor below the lower bound "
        "or above the upper bound never governs.");
  v.table("entry_exit", l.entry_exit, "Where search = \"entry_exit\" looks.");
  v.table("grid", l.grid, "Where search = \"grid\" looks.");
  v.table("block", l.block, "Where search = \"block\" looks.");
  v.optional_table("tangent", l.tangent,
                   "Circles are only tried where they are tangent to a level or layer. No polyline is searched then.");
  v.tables("exclude", l.excluded, 0, "An area that no surface enters.");
  v.tables("through", l.passages, 0, "A window through which every surface passes: a polyline that it cuts, or a box.");
  v.table("tension_crack", l.crack, "A crack at the crest.");
  v.optional_table("drawdown", l.drawdown,
                   "Rapid drawdown: the water that [initial] names falls to another level, while soils with an "
                   "`undrained_envelope` (or a `b_bar`) do not drain. Every factor is then that after drawdown.");
  v.tables("surface", l.surfaces, 0,
           "A slip surface of your choice, by the methods of `methods`: a circle (centre and radius) or a polyline.");
}

/// Returns the methods of slices that evaluate the surface of another method: Spencer and Morgenstern–Price, which
/// satisfy complete equilibrium, and those of the case that suit polylines.
std::vector<SliceMethod> list_polyline_methods(const LimitEquilibrium& settings);

}  // namespace talus::input
