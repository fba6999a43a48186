// SPDX-License-Identifier: MIT
#pragma once
// The trial circles of a search, in a lattice that gives each circle its neighbours.

#include <array>
#include <vector>

#include "lem/search/arcs.hpp"
#include "lem/search/optimise.hpp"
#include "lem/search/search.hpp"

namespace talus::lem {

/// Trial circles in a lattice of cells: exits x entries x depths, or columns x rows x radii. A cell has no circle if
/// none fits, and one per stretch of ground below which the circle runs (both faces of a dam).
struct TrialCircles {
  std::array<int, 3> size{};
  std::vector<Surface> surfaces;          ///< cell by cell, the last index fastest
  std::vector<int> first;                 ///< index in `surfaces` of the first circle of each cell; one more at the end
  std::array<double, 2> left{}, right{};  ///< ranges of x of the left and the right ends [m]
  std::array<double, 2> step{};           ///< typical distance of neighbouring ends [m]
  bool whole_ground = false;              ///< no range of entries and exits was given
};

/// Returns x of `count` points of the ground between two x: dense on and beside slopes, with corners of the ground
/// among them. `seed`: see SearchOptions.
std::vector<double> place_points(const Slope& slope, double from, double to, int count, int seed);

/// Returns the directions of sliding (-1: to smaller x, 1) of masses between an entry and a lower exit of two ranges.
std::vector<int> list_directions(const Slope& slope, const EntryExitSearch& ranges);

/// Both throw as throw_if_search_is_interrupted(). `used`: the ranges of the options, completed.
TrialCircles make_entry_exit_circles(const Slope& slope, const Arcs& arcs, const SearchOptions& options,
                                     EntryExitSearch& used);
TrialCircles make_grid_circles(const Slope& slope, const SearchOptions& options, GridSearch& used);

/// Completes a grid: centres from above the crest up to 1.5 times the height or the width of the slopes, and deepest
/// points down to 1.5 times the height below the toe, or to `base` [m].
GridSearch choose_grid(const std::vector<Point>& ground, double base, GridSearch grid);

/// Computes the factors of all trial surfaces by all methods, in parallel, with the reasons of rejection.
void solve_trials(const Slope& slope, const SearchOptions& options, const TrialCircles& circles, SearchResult& result);

// Circles that just touch a region. The factor jumps where a circle enters a strong layer, and its minimum often lies
// at the jump, in a valley too narrow for a lattice of trial circles.

/// Returns for each region the best circle that touches it, among those with the ends of trial circles; none for a
/// region that no circle touches. `quick` ranks the circles (at most `most` for each region), `evaluate` solves the
/// best of them.
std::vector<Surface> find_touching_circles(Evaluator& evaluate, Evaluator& quick, const Arcs& arcs,
                                           const TrialCircles& circles, int most);

// Search for the critical polyline of each method, started from circles, from blocks along layers, and from the
// polylines of the other methods.

/// Returns blocks that slide along a border of a region or along the base, between a steep upper and a flat lower end,
/// for many pairs of places along each border. The surfaces are not evaluated. `seed`: see SearchOptions.
std::vector<Surface> make_blocks(const Slope& slope, int vertices, int seed);

/// Returns the best polyline of each of options.methods; one without points where a method has no solution or applies
/// to circles only. `minima`: the optimised circles of each method.
std::vector<OptimisedSurface> find_polylines(const Slope& slope, const SearchOptions& options,
                                             const TrialCircles& circles, const SearchResult& result,
                                             const std::vector<std::vector<OptimisedSurface>>& minima);

}  // namespace talus::lem
