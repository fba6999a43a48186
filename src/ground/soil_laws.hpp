#pragma once
// Constitutive laws of the materials of a case, with the strength of a stage or trial.

#include <optional>

#include "input/case/case.hpp"
#include "material/law.hpp"

namespace talus::ground {

/// The law of a material, its strength with another cohesion [Pa] of Mohr–Coulomb soils and reduced by `factor`
/// (3.14-3.15): c, c_r and tanφ, or the tangent of Cam-clay's critical state. Throws Error (wrong_input) when an
/// external model is to be reduced, or its library cannot be opened.
material::Law make_law(const input::Material& material, std::optional<double> cohesion = {}, double factor = 1);

}  // namespace talus::ground
