// SPDX-License-Identifier: MIT
#pragma once
// The constitutive laws of the list in soil.hpp, and the functions on a law of unknown type.

#include <algorithm>
#include <array>
#include <variant>
#include <vector>

#include "material/cam_clay.hpp"
#include "material/curved_envelopes.hpp"
#include "material/directed_strength.hpp"
#include "material/drucker_prager.hpp"
#include "material/external.hpp"
#include "material/hoek_brown.hpp"
#include "material/linear_elastic.hpp"
#include "material/mohr_coulomb.hpp"
#include "material/rooted_mohr_coulomb.hpp"
#include "material/shansep.hpp"
#include "material/softening.hpp"
#include "material/soil.hpp"
#include "material/tresca.hpp"

namespace talus::material {

/// Returns the law as the class whose update a step calls: laws may share it.
template <class L>
const auto& get_kernel(const L& law) {
  if constexpr (requires { typename L::Kernel; })
    return static_cast<const typename L::Kernel&>(law);
  else
    return law;
}

template <class Laws>
struct OfLaws;
template <class... L>
struct OfLaws<std::variant<L...>> {
  /// Union of the blocks of all laws.
  using Numbers = typename Joined<material::Numbers<>, typename L::Input...>::type;
  static constexpr std::array<Traits, sizeof...(L)> traits{L::traits...};
  static constexpr int max_state_size = std::max({L::state_size...});

  /// Returns the models whose law needs a block, `now` being the model of the material.
  template <class Block>
  static Users list_users(Model now) {
    Users users;
    const auto add = [&]<class One>() {
      if constexpr (One::Input::template has<Block>)
        users.models.push_back({"model", '"' + std::string(One::traits.word) + '"', model_of<One> == now});
    };
    (add.template operator()<L>(), ...);
    return users;
  }
  /// Calls work.template operator()<L>() for the law of a model.
  static void visit(Model model, auto&& work) {
    static_cast<void>(((model_of<L> == model ? (work.template operator()<L>(), true) : false) || ...));
  }
};
using Laws = OfLaws<Law>;
static_assert(std::is_same_v<SoilNumbers, Laws::Numbers>, "SoilNumbers (soil.hpp) lists every block of every law");

/// Largest number of state variables of any law. The first one is common to all plastic laws: the deviatoric plastic
/// strain.
inline constexpr int max_state_size = Laws::max_state_size, common_state_size = 1;

inline int state_size(const Law& law) {
  return std::visit([](const auto& l) { return l.state_size; }, law);
}
inline const Traits& get_traits(const Law& law) {
  return Laws::traits[law.index()];
}

/// Laws with a preconsolidation, which may be set after a stage of equilibrium.
template <class L>
concept IsPreconsolidated = requires(const L& l, const double* state) {
  l.find_preconsolidation(state, 1.0);
};

/// Completes the input with what depends on the folder of the case.
void complete_soil(SoilNumbers& in, const std::string& name, const auto& find_file) {
  [&]<class... L>(std::variant<L...>*) {
    const auto complete = [&]<class One>() {
      if constexpr (requires { One::complete(typename One::Input::Changeable(in), name, find_file); })
        One::complete(typename One::Input::Changeable(in), name, find_file);
    };
    (complete.template operator()<L>(), ...);
  }(static_cast<Law*>(nullptr));
}

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
