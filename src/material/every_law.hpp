// SPDX-License-Identifier: MIT
#pragma once
// The constitutive laws of the list in soil.hpp with their equations, for code that is compiled for each of them:
// kernels, finite elements and material points. All other code takes law.hpp.

#include <algorithm>
#include <array>
#include <variant>

#include "material/cam_clay.hpp"
#include "material/curved_envelopes.hpp"
#include "material/directed_strength.hpp"
#include "material/drucker_prager.hpp"
#include "material/external.hpp"
#include "material/hoek_brown.hpp"
#include "material/law.hpp"
#include "material/linear_elastic.hpp"
#include "material/mohr_coulomb.hpp"
#include "material/rooted_mohr_coulomb.hpp"
#include "material/shansep.hpp"
#include "material/softening.hpp"
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
static_assert(max_state_size == Laws::max_state_size, "max_state_size (law.hpp) is that of the largest law");

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

}  // namespace talus::material
