// SPDX-License-Identifier: MIT
#pragma once
// The slices over a base: geometry, weight, loads on vertical steps of the ground, pore pressure and strength.

#include <vector>

#include "lem/section/strips.hpp"
#include "lem/slices/mass.hpp"
#include "lem/slices/solve.hpp"
#include "lem/surface/base_line.hpp"

namespace talus::lem {

/// Makes about `count` slices over the stretches of a base, with area and depth of the mass. Forces and inclinations
/// are those of a mass that slides to the left.
void fill_slices(const Slope::Strips& strips, const BaseLine& base, int count, CutSurface& cut);

/// End of the mass at which a tension crack lies.
enum class CrackEnd { none, left, right };

/// Adds ponded water and loads on the vertical steps of the ground, inside the mass and at its ends, but not at the end
/// with the crack.
void press_on_faces(const Slope::Strips& strips, std::vector<Slice>& slices, CrackEnd crack);

/// Finds the bars that the base of the mass crosses, with their forces. Bars whose stable part lies ahead of the mass
/// have none where the base shortens them.
void cross_bars(const Slope& slope, CutSurface& cut);

/// Undoes release_bars().
void tighten_bars(CutSurface& cut);

/// Makes bars slack that would drive the mass at this factor, and turns forces across a bar that would. The base moves
/// at φ_F = arctan(tan φ / F) to its own direction; along that motion a force has exactly the sign of its effect on
/// equilibrium at a given λ, so that a bar has no effect where it becomes slack. Prestress is a load and stays.
/// Returns true if a force changed; each bar changes once.
bool release_bars(const Slope& slope, CutSurface& cut, double factor);

/// Returns the slice over the same base in a slope that differs in its weights and pressures only.
Slice weigh_slice(const Slope& slope, const Slice& slice);

// Pore pressure and strength at the base of a slice.

/// Sets u, c and tanφ of a slice with known geometry; `weight` of the soil above its base [N/m²]. `before`: the same
/// slice before drawdown; nullptr without one.
void add_strength(const Slope::Strips& strips, const Strip& strip, double weight, const Slice* before, Slice& slice);

/// Sets c and tanφ of the slices in soils with a law, at σ'_n of the last solution, or without one at an estimate of it
/// by the weight above. `before`: the same slices before a rapid drawdown, with their strength, if there is one; soil
/// without drainage keeps it. Returns the largest change of the strength of a slice over the mean strength [-].
double set_law_strengths(const Slope::Strips& strips, std::vector<Slice>& slices, bool has_forces,
                         const std::vector<Slice>& before);

/// Returns the cohesion of roots at a point [Pa].
double find_root_cohesion(const Section& section, const Point& p);

}  // namespace talus::lem
