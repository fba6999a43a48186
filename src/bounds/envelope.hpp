// SPDX-License-Identifier: MIT
#pragma once
// Polygons inside and outside a concave strength envelope. A circle below every line of the inner one is below the
// envelope, so that it serves the lower bound; one below the envelope is below every line of the outer one, which
// serves the upper bound.

#include <array>
#include <functional>
#include <vector>

#include "base/strength_law.hpp"
#include "bounds/problem.hpp"

namespace talus::bounds {

struct EnvelopeRange {
  double lowest = 0;  ///< σ'_n below which the envelope is straight [Pa]
  double usual = 0;   ///< largest σ'_n of the section, about; at this one the strength defines small differences [Pa]
  double tolerance = 0;  ///< of the strength between both polygons: of itself, and half of that at `usual`
};

struct EnvelopePolygons {
  Strength inner, outer;
};

/// Returns both polygons of the tangents of an envelope, by σ'_n (positive in compression). The lines inside are the
/// tangent at the lowest stress, chords, and a horizontal one above the last chord.
EnvelopePolygons enclose_envelope(const std::function<StrengthTangent(double)>& find_tangent,
                                  const EnvelopeRange& range);

/// Stresses in the order of the unknowns of a program, and the factor of that program.
struct TriedStresses {
  double factor = 1;
  const std::vector<double>* unknowns = nullptr;  ///< [units of stress]
};

/// Limits the lines in the programs of each triangle to those that are nearest to Mohr's circles of the stresses, and
/// one more on either side. Few of the lines of an envelope matter in a triangle, and the cost grows with their number.
void choose_lines(Problem& problem, const Units& units, const std::array<TriedStresses, 2>& tried);

/// Adds the lines that the stresses of a program exceed and that it did not have. Returns true if there are any.
bool add_exceeded_lines(Problem& problem, const Units& units, const TriedStresses& tried);

}  // namespace talus::bounds
