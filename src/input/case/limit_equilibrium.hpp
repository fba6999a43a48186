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

void describe(Visitor& v, SlipSurface& s);

void describe(Visitor& v, EntryExit& e);

void describe(Visitor& v, CentreGrid& g);

void describe(Visitor& v, SurfaceWindow& w);

void describe(Visitor& v, ExcludedArea& e);

void describe(Visitor& v, BlockSearch& b);

void describe(Visitor& v, TangentCircles& t);

void describe(Visitor& v, TensionCrack& t);

void describe(Visitor& v, Drawdown& d);

void describe(Visitor& v, LimitEquilibrium& l);

/// Returns the methods of slices that evaluate the surface of another method: Spencer and Morgenstern–Price, which
/// satisfy complete equilibrium, and those of the case that suit polylines.
std::vector<SliceMethod> list_polyline_methods(const LimitEquilibrium& settings);

}  // namespace talus::input
