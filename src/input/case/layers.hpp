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

void describe(auto& v, LayerInput& l) {
  v.key("name", l.name, plain().required().example(R"("clay")"), "Name of the region; [regions] gives it a material.");
  v.key("bottom", l.bottom, quantity("m").example("[[0, 4], [44, 2]]"),
        "Lower boundary as points from left to right, or a table. A line that ends inside the section at the boundary "
        "above pinches out there; otherwise it continues level. Each layer needs one of `bottom`, `level`, `thickness` "
        "and `depths`.");
  v.key("level", l.level, quantity("m").example("-5"), "Level of a horizontal lower boundary.");
  v.key("thickness", l.thickness, quantity("m").above(0).example("0.5"),
        "Vertical distance of the lower boundary from the one above, or from the ground.");
  v.key("depths", l.depths, quantity("m").example("[[4, 3.2], [20, 2.5]]"),
        "Boreholes: position along x, and depth of the lower boundary below the ground there. A layer that a borehole "
        "does not meet has the depth of the one above. In a table, boreholes that end higher have an empty cell.");
  v.key("between", l.between, plain(),
        "How the boundary runs between boreholes. Beyond the first and the last its depth is constant.");
  v.key("cut", l.cut, plain(),
        "true: the boundary above cuts this one where they cross, as an erosion surface does. By default, crossing "
        "boundaries are a fault. The ground always cuts, and boundaries between boreholes are always cut.");
}

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
