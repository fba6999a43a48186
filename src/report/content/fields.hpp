// SPDX-License-Identifier: MIT
#pragma once
// Stored fields as the scalar quantities that a person looks at: magnitudes, components, titles, units, colour scales.

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "output/files/frame.hpp"
#include "report/words/numbers.hpp"

namespace talus::report {

/// A scalar made of a stored field.
struct ScalarField {
  std::string stored;  ///< name in the results, "stress"
  int component = -1;  ///< of the stored field; -1: the field itself, or the length of a vector
  std::string name;    ///< "stress_xx"
  std::string title;
  ShownUnit unit;
  bool is_signed = false;  ///< may be negative
};

/// The scalars of the stored `fields` in `dimension` dimensions that a report shows. Components that plane strain
/// leaves zero are left out, and those of velocity and strain; the results file holds them.
std::vector<ScalarField> list_scalars(const std::vector<output::Field>& fields, std::size_t dimension,
                                      const ShownUnits& units);

/// The scalar called `name` ("stress_xx") with the stored `unit`, as a table of the results has it.
ScalarField find_scalar(const std::string& name, const std::string& unit, std::size_t dimension,
                        const ShownUnits& units);

/// Value of item `i` of the stored field.
double evaluate(const ScalarField& scalar, const output::Field& stored, std::size_t i);

/// Limits of a colour scale that outliers do not stretch, and whether its middle is zero.
struct ColourScale {
  std::array<double, 2> limits{};
  bool diverging = false;
};
/// 1st to 99th percentile of the finite values; from zero for what has no sign; with equal ends about zero when both
/// signs matter (the smaller side is above a tenth of the larger). A constant field gets a scale of length `step` (SI).
ColourScale find_colour_scale(std::span<const double> values, bool is_signed, double step = 1);

// Pore water of a frame as an engineer asks for it, from what the results hold.

/// Replaces the water's own velocity w by Darcy's, nS(w - v): volume per time and area of soil [m/s]. Points of dry
/// soil, whose saturation is zero, get no pressure, saturation or flow. A dry frame stays as it is.
void show_water(output::Frame& frame);

}  // namespace talus::report
