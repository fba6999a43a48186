// SPDX-License-Identifier: MIT
#pragma once
// [geometry] ground and [[geometry.layer]]: a section by its boundary lines, from which the polygons are built.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "input/language/forms.hpp"
#include "input/language/spec.hpp"

namespace talus::input {

struct Case;
class Findings;

enum class Interpolation { linear, spline };

template <>
inline constexpr auto choices<Interpolation> = std::array{
    Choice{Interpolation::linear, "linear", "straight lines between boreholes"},
    Choice{Interpolation::spline, "spline", "a smooth curve through the boreholes that does not overshoot (PCHIP)"},
};

/// A layer and its lower boundary, which is given in one of four ways.
struct LayerInput {
  std::string name;
  SurveyPoints bottom;
  std::optional<double> level;      ///< [m]
  std::optional<double> thickness;  ///< [m]
  SurveyPoints depths;              ///< (x, depth below the ground) [m]
  Interpolation between = Interpolation::linear;
  bool cut = false;
};

void describe(Visitor& v, LayerInput& l);

/// The section as given; empty after build_layers().
struct Layering {
  SurveyPoints ground;
  double smallest_thickness = 0.01;  ///< [m]
  std::vector<LayerInput> layers;
};

/// Makes the polygons of a section that is given by layers, with paths relative to the folder of the case file `file`,
/// and empties data.layering. Faults and changes of the lines are added to `findings`.
void build_layers(Case& data, const std::string& file, Findings& findings);

}  // namespace talus::input
