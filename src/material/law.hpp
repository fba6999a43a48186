// SPDX-License-Identifier: MIT
#pragma once
// Functions on a law of unknown type, without the equations of the laws (every_law.hpp).

#include <optional>
#include <string>
#include <vector>

#include "material/blocks.hpp"
#include "material/soil.hpp"

namespace talus::material {

/// A call of an external model without a usable result.
struct LawFailure {
  int point = -1;      ///< -1: unknown
  std::string model;   ///< "the external model 'clay' (umat_ in libclay.so)"
  std::string answer;  ///< the answer and the arguments that led to it

  /// Returns the failure as one sentence; `place` follows the number of the point, e.g. " at (3.2, 1.5) m".
  std::string describe(const std::string& place) const;
};

/// Number of stress components: xx yy zz xy (plane strain), and yz zx in three dimensions. Shear strains are
/// engineering strains (2ε_xy), stresses positive in tension.
template <int D>
inline constexpr int stress_size = D == 2 ? 4 : 6;

/// Largest number of state variables of any law. The first one is common to all plastic laws: the deviatoric plastic
/// strain.
inline constexpr int max_state_size = 27, common_state_size = 1;

int state_size(const Law& law);
const Traits& traits_of(const Law& law);

// Functions of a point.

/// Sets the initial state variables of a point; `state` has room for max_state_size values.
void set_initial_state(const Law& law, const SoilNumbers& in, const StateStart& start, double* state);
/// Copies the roots of a point from its state to `start`.
void read_start(const Law& law, const double* state, StateStart& start);
/// Returns E_c of (2.84) at stress `sigma` and state variables `state` [Pa].
double constrained_modulus(const Law& law, const double* sigma, const double* state);
/// Returns E_c where it depends on neither.
std::optional<double> find_constant_modulus(const Law& law);
/// Returns the elastic energy density [J/m³].
template <int NS>
double elastic_energy(const Law& law, const double* sigma, const double* state);
/// Lists the state fields of the results beside stress and plastic strain, in the order of show_state().
std::vector<StateField> list_state_fields(const Law& law);
/// Writes one value per state field. `saturation` is that of the pore water, 1 in dry soil.
void show_state(const Law& law, const double* state, double saturation, double* values);
/// Returns the gap as a volumetric strain [-]; 0 for laws without gaps.
double find_gap(const Law& law, const double* state);
/// Returns and clears the failure with the lowest point number since the last call.
std::optional<LawFailure> take_failure(const Law& law);

}  // namespace talus::material
