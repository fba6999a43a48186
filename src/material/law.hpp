#pragma once
// The list of constitutive models. Adding one: its header, its input block, one word here, one point test.

#include <algorithm>
#include <variant>
#include <vector>

#include "material/cam_clay.hpp"
#include "material/external.hpp"
#include "material/linear_elastic.hpp"
#include "material/mohr_coulomb.hpp"
#include "material/rooted_mohr_coulomb.hpp"

namespace talus::material {

using Law = std::variant<LinearElastic, MohrCoulomb, RootedMohrCoulomb, ModifiedCamClay, RootedCamClay, External>;

/// Laws whose stiffness and state at the start follow from the stress.
template <class L>
inline constexpr bool is_cam_clay = std::is_same_v<L, ModifiedCamClay> || std::is_same_v<L, RootedCamClay>;

/// Most state variables of any model.
inline constexpr int max_state_size =
    std::max({LinearElastic::state_size, MohrCoulomb::state_size, RootedMohrCoulomb::state_size,
              ModifiedCamClay::state_size, RootedCamClay::state_size, External::state_size});

inline int state_size(const Law& law) {
  return std::visit([](const auto& l) { return l.state_size; }, law);
}
/// E_c of (2.84) of a point with stress `sigma` and state variables `state` [Pa].
double constrained_modulus(const Law& law, const double* sigma, const double* state);

/// Whether the stiffness of the law follows stress and state, so that the critical step must be looked at often.
bool has_changing_stiffness(const Law& law);

/// Elastic energy density [J/m³].
template <int NS>
double elastic_energy(const Law& law, const double* sigma, const double* state);

/// What results show of a law beside stress and plastic strain, in the order of show_state().
std::vector<StateField> list_state_fields(const Law& law);
/// Writes one value per field. `saturation` is that of the pore water, 1 in dry soil.
void show_state(const Law& law, const double* state, double saturation, double* values);

}  // namespace talus::material
