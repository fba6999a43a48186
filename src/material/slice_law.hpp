// SPDX-License-Identifier: MIT
#pragma once
// Laws whose strength LEM alone uses. Their stresses are those of linear elasticity, and FEM, limit analysis and MPM
// refuse them.

#include "material/linear_elastic.hpp"

namespace talus::material {

/// Base of these laws; `L` is the law.
template <class L>
struct SliceLaw : LinearElastic {
  using Kernel = LinearElastic;  ///< class whose update a step calls

  template <class In>
  static L make(const In& in, const StrengthChange&) {
    L law;
    static_cast<LinearElastic&>(law) = LinearElastic::make(in);
    return law;
  }
  static SliceStrength find_slice_strength(const auto& in) {
    SliceStrength strength;
    strength.law = std::make_shared<const StrengthLaw>(L::make_strength(in));
    return strength;
  }
};

}  // namespace talus::material
