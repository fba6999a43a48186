// SPDX-License-Identifier: MIT
#pragma once
// Laws that are called, and the choice between these and those that are compiled into the passes (laws.hpp). For the
// passes on a processor only.

#include <type_traits>
#include <variant>

#include "mpm/kernels/laws.hpp"

namespace talus::mpm {

/// Laws that iterate or call a library, point by point: a call costs little beside their update, and the passes need
/// not be compiled for each of them.
template <class L>
inline constexpr bool is_called = L::traits.is_opaque;

/// The update of a law that is called; compiled once, in called_law.cpp.
template <int NS>
material::Response<Pack> update_called(const material::Law& law, Pack* sigma, const Pack* d_epsilon, Pack* state,
                                       MaskOf<Pack> active, const material::Surroundings<Pack>& around);

/// All points of the block have this law, which is called.
struct CalledLaw {
  static constexpr bool is_single = true;
  static constexpr bool is_plastic = true, softens = true;
  const material::Law& law;
  int state_size, core_size;
  bool is_softening;

  template <class T>
  MaskOf<T> find_softening(T /*material*/) const {
    return MaskOf<T>(is_softening);
  }
  template <int NS>
  material::Response<Pack> update(Pack* sigma, const Pack* d_epsilon, Pack* state, MaskOf<Pack> active,
                                  Pack /*material*/, const material::Surroundings<Pack>& around) const {
    return update_called<NS>(law, sigma, d_epsilon, state, active, around);
  }
};

/// Calls work(OneLaw), work(CalledLaw) or work(ManyLaws) for the set of materials in `present`.
void visit_laws(const std::vector<material::Law>& laws, std::uint32_t present, auto&& work) {
  if ((present & (present - 1)) != 0) {
    work(ManyLaws<>{&laws, present, find_state_size(laws)});
    return;
  }
  const auto m = present == 0 ? 0u : static_cast<unsigned>(__builtin_ctz(present));
  std::visit(
      [&](const auto& law) {
        const auto& kernel = material::get_kernel(law);
        using L = std::decay_t<decltype(kernel)>;
        if constexpr (is_called<L>)
          work(CalledLaw{laws[m], L::state_size, count_core_states<L>(), L::traits.softens});
        else
          work(OneLaw<L>{kernel});
      },
      laws[m]);
}

}  // namespace talus::mpm
