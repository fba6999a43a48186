// SPDX-License-Identifier: MIT
#pragma once
// Selection of the water law for the lanes of a block: one for all, or one per lane under masks; the counterpart of
// laws.hpp.

#include "mpm/kernels/pore_state.hpp"
#include "mpm/state/body.hpp"

namespace talus::mpm {

/// All points of the block are of one material.
struct OneWater {
  const WaterLaw* law;
  double conductivity_factor;

  template <class T>
  TALUS_KERNEL MaskOf<T> is_wet(T /*material*/) const {
    return MaskOf<T>(law->wet);
  }
  template <class T>
  TALUS_KERNEL T get_inverse_grain_density(T /*material*/) const {
    return T(1 / law->grain_density);
  }
  template <class T>
  T get_resistance(T /*material*/) const {
    return {find_saturated_resistance(*law, conductivity_factor)};
  }
  template <class T>
  PoreState<T> find(T content, T guess, MaskOf<T> active, T /*material*/) const {
    return find_pore_state<T>(*law, content, guess, active);
  }
  template <class T>
  T find_saturation(T pressure, T /*material*/) const {
    return find_state_at_pressure<T>(*law, pressure).saturation;
  }
};

/// Lanes may have different laws; `material` is the material number of each lane. Laws: the list type of the body.
template <class Laws>
struct ManyWaters {
  const Laws* laws;
  std::uint32_t present;  ///< bit set of the materials in the block
  double conductivity_factor;

  /// Calls work(law, mask of its lanes) for each wet material of the block.
  template <class T, class Work>
  TALUS_KERNEL void visit(T material, Work&& work) const {
    for (std::uint32_t m = 0; m < laws->size(); ++m) {
      if ((present >> m & 1) && (*laws)[m].wet) work((*laws)[m], material == T(static_cast<double>(m)));
    }
  }
  template <class T>
  TALUS_KERNEL MaskOf<T> is_wet(T material) const {
    MaskOf<T> wet(false);
    visit(material, [&](const WaterLaw&, MaskOf<T> mine) { wet = wet || mine; });
    return wet;
  }
  template <class T>
  TALUS_KERNEL T get_inverse_grain_density(T material) const {
    T inverse(0.0);
    visit(material,
          [&](const WaterLaw& law, MaskOf<T> mine) { inverse = select(mine, T(1 / law.grain_density), inverse); });
    return inverse;
  }
  /// ρ_w g/k of the saturated soil [N s/m⁴]; 0 in dry soil.
  template <class T>
  T get_resistance(T material) const {
    T resistance(0.0);
    visit(material, [&](const WaterLaw& law, MaskOf<T> mine) {
      resistance = select(mine, T(find_saturated_resistance(law, conductivity_factor)), resistance);
    });
    return resistance;
  }
  template <class T>
  PoreState<T> find(T content, T guess, MaskOf<T> active, T material) const {
    PoreState<T> all{T(0.0), T(0.0), T(0.0), T(0.0), T(-1.0)};
    visit(material, [&](const WaterLaw& law, MaskOf<T> mine) {
      mine = mine && active;
      if (!any(mine)) return;
      all = select(mine, find_pore_state<T>(law, content, guess, mine), all);
    });
    return all;
  }
  template <class T>
  T find_saturation(T pressure, T material) const {
    T saturation(0.0);
    visit(material, [&](const WaterLaw& law, MaskOf<T> mine) {
      saturation = select(mine, find_state_at_pressure<T>(law, pressure).saturation, saturation);
    });
    return saturation;
  }
};

/// Water laws that correspond to the constitutive law `Law` (OneLaw or ManyLaws) of a block's lanes.
template <class Law>
using WaterLanes = std::conditional_t<Law::is_single, OneWater, ManyWaters<std::vector<WaterLaw>>>;

/// The water laws of block `b`.
template <class Law, int D>
WaterLanes<Law> get_block_water(const Body<D>& body, int b, double conductivity_factor) {
  const std::uint32_t present = body.laws.size() == 1 ? 1u : body.points.block_materials[static_cast<std::size_t>(b)];
  if constexpr (Law::is_single) {
    const auto m = present == 0 ? 0u : static_cast<unsigned>(__builtin_ctz(present));
    return OneWater{&body.water.laws[m], conductivity_factor};
  } else {
    return WaterLanes<Law>{&body.water.laws, present, conductivity_factor};
  }
}

}  // namespace talus::mpm
