#pragma once
// The list of constitutive models. Adding one: its header, its input block, one word here, one point test.

#include <algorithm>
#include <variant>

#include "material/linear_elastic.hpp"
#include "material/mohr_coulomb.hpp"

namespace talus::material {

using Law = std::variant<LinearElastic, MohrCoulomb>;

/// Most state variables of any model.
inline constexpr int max_state_size = std::max({LinearElastic::state_size, MohrCoulomb::state_size});

inline int state_size(const Law& law) {
  return std::visit([](const auto& l) { return l.state_size; }, law);
}
inline double constrained_modulus(const Law& law) {
  return std::visit([](const auto& l) { return l.constrained_modulus(); }, law);
}

}  // namespace talus::material
