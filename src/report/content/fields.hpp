// SPDX-License-Identifier: MIT
#pragma once
// Scalar quantities that the report shows of stored fields: magnitudes, components, titles, units and colour scales;
// and the conversion of the fields of pore water to Darcy's velocity.

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "output/files/frame.hpp"
#include "report/folder/numbers.hpp"

namespace talus::report {

/// A scalar derived from a stored field.
struct ScalarField {
  std::string stored;  ///< name of the field in the result files, "stress"
  int component = -1;  ///< component of the field; -1: the scalar field itself or the magnitude of a vector
  std::string name;    ///< such as "stress_xx"
  std::string title;
  ShownUnit unit;
  bool is_signed = false;  ///< the scalar may be negative
};

/// Returns the scalars that a report shows of the stored `fields`. Components of velocity and strain, and those that
/// vanish in plane strain, are omitted; the result files contain them.
std::vector<ScalarField> list_scalars(const std::vector<output::Field>& fields, std::size_t dimension,
                                      const ShownUnits& units);

/// Returns the scalar `name` ("stress_xx") of a column in a result table with the stored `unit`.
ScalarField find_scalar(const std::string& name, const std::string& unit, std::size_t dimension,
                        const ShownUnits& units);

/// Returns the value of the scalar at point `i` of the stored field.
double evaluate(const ScalarField& scalar, const output::Field& stored, std::size_t i);

/// Limits of a colour scale without outliers; `diverging` if it is centred at zero.
struct ColourScale {
  std::array<double, 2> limits{};
  bool diverging = false;
};
/// Returns the colour scale between the 1st and the 99th percentile of the finite values. It starts at zero for a
/// scalar without sign, and is symmetric about zero if the smaller side exceeds a tenth of the larger. The scale of a
/// constant field has the length `step` (SI).
ColourScale find_colour_scale(std::span<const double> values, bool is_signed, double step = 1);

/// Replaces the velocity of the water, w, by Darcy's, nS(w - v): the volume per time and area of soil [m/s]. Pressure,
/// saturation and flow at points of dry soil (saturation 0) are set to NaN. Dry frames are not changed.
void show_water(output::Frame& frame);

}  // namespace talus::report
