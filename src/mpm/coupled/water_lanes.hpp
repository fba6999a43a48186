// SPDX-License-Identifier: MIT
#pragma once
// Which water law the lanes of a block follow: one for all, or one per lane under masks; the counterpart of laws.hpp.

#include "mpm/body/body.hpp"
#include "mpm/coupled/pore_state.hpp"

namespace talus::mpm {

/// Every point of the block is of one material.
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
  Pack get_resistance(Pack /*material*/) const { return {find_saturated_resistance(*law, conductivity_factor)}; }
  PoreState<Pack> find(Pack content, Pack guess, Mask active, Pack /*material*/) const {
    return find_pore_state<Pack>(*law, content, guess, active);
  }
  Pack find_saturation(Pack pressure, Pack /*material*/) const {
    return find_state_at_pressure<Pack>(*law, pressure).saturation;
  }
};

/// Lanes may differ; `material` holds each lane's material number. Laws: as the body has them.
template <class Laws>
struct ManyWaters {
  const Laws* laws;
  std::uint32_t present;  ///< bit set of the materials in the block
  double conductivity_factor;

  /// Calls work(law, lanes of it) for each wet material of the block.
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
  /// ρ_w g/k of the saturated soil [N s/m⁴]; 0 of dry soil.
  Pack get_resistance(Pack material) const {
    Pack resistance(0.0);
    visit(material, [&](const WaterLaw& law, Mask mine) {
      resistance = select(mine, Pack(find_saturated_resistance(law, conductivity_factor)), resistance);
    });
    return resistance;
  }
  PoreState<Pack> find(Pack content, Pack guess, Mask active, Pack material) const {
    PoreState<Pack> all{Pack(0.0), Pack(0.0), Pack(0.0), Pack(0.0), Pack(-1.0)};
    visit(material, [&](const WaterLaw& law, Mask mine) {
      mine = mine && active;
      if (!any(mine)) return;
      all = select(mine, find_pore_state<Pack>(law, content, guess, mine), all);
    });
    return all;
  }
  Pack find_saturation(Pack pressure, Pack material) const {
    Pack saturation(0.0);
    visit(material, [&](const WaterLaw& law, Mask mine) {
      saturation = select(mine, find_state_at_pressure<Pack>(law, pressure).saturation, saturation);
    });
    return saturation;
  }
};

/// The water laws that go with the constitutive law `Law` (OneLaw or ManyLaws) of a block's lanes.
template <class Law>
using WaterLanes = std::conditional_t<Law::is_single, OneWater, ManyWaters<std::vector<WaterLaw>>>;

/// Those of block `b`.
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
