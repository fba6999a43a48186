// SPDX-License-Identifier: MIT
#pragma once
// Which constitutive law the lanes of a block follow: one for all (the common case, visited once per block), or one per
// lane, applied law by law under masks. Never a branch per point.

#include <algorithm>

#include "material/law.hpp"
#include "mpm/body/body.hpp"

namespace talus::mpm {

/// Every point of the block is of the material with this law.
template <class L>
struct OneLaw {
  static constexpr bool is_single = true;
  static constexpr bool is_plastic = L::is_plastic, softens = L::traits.softens;
  static constexpr int state_size = L::state_size;
  /// The states but the gap, which comes last and is zero in most blocks: these need not read it.
  static constexpr int core_size = [] {
    if constexpr (requires { L::gap_states; })
      return L::state_size - L::gap_states;
    else
      return L::state_size;
  }();
  static Mask find_softening(Pack /*material*/) { return Mask(softens); }
  L law;  // a copy: its parameters then live in registers, not behind a pointer that a store might alias

  template <int NS>
  TALUS_KERNEL material::Response<Pack> update(Pack* sigma, const Pack* d_epsilon, Pack* state, Mask active,
                                               Pack /*material*/, const material::Surroundings<Pack>& around) const {
    return law.template update<NS>(sigma, d_epsilon, state, active, around);
  }
};

/// Lanes may differ; `material` of update() holds each lane's material number.
struct ManyLaws {
  static constexpr bool is_single = false;
  static constexpr bool is_plastic = true, softens = true;
  const std::vector<material::Law>* laws;
  std::uint32_t present;  ///< bit set of the materials in the block
  int state_size;         ///< most state variables of a law of the body
  int core_size = state_size;

  /// The lanes whose soil softens.
  Mask find_softening(Pack material) const {
    Mask some(false);
    for (std::uint32_t m = 0; m < laws->size(); ++m)
      if ((present >> m & 1) && material::get_traits((*laws)[m]).softens)
        some = some || material == Pack(static_cast<double>(m));
    return some;
  }

  template <int NS>
  material::Response<Pack> update(Pack* sigma, const Pack* d_epsilon, Pack* state, Mask active, Pack material,
                                  const material::Surroundings<Pack>& around) const {
    material::Response<Pack> total{false, Pack(0.0), Pack(0.0)};
    Pack result[NS], result_state[material::max_state_size];
    for (int i = 0; i < NS; ++i) result[i] = sigma[i];
    for (int i = 0; i < state_size; ++i) result_state[i] = state[i];
    for (std::uint32_t m = 0; m < laws->size(); ++m) {
      if (!(present >> m & 1)) continue;
      const Mask mine = active && material == Pack(static_cast<double>(m));
      if (!any(mine)) continue;
      std::visit(
          [&](const auto& law) {
            Pack s[NS], q[material::max_state_size];
            for (int i = 0; i < NS; ++i) s[i] = sigma[i];
            for (int i = 0; i < state_size; ++i) q[i] = state[i];
            const auto r = law.template update<NS>(s, d_epsilon, q, mine, around);
            for (int i = 0; i < NS; ++i) result[i] = select(mine, s[i], result[i]);
            for (int i = 0; i < state_size; ++i) result_state[i] = select(mine, q[i], result_state[i]);
            total.any_plastic = total.any_plastic || r.any_plastic;
            total.plastic_dilation = select(mine, r.plastic_dilation, total.plastic_dilation);
            total.dissipation = select(mine, r.dissipation, total.dissipation);
            total.opened = select(mine, r.opened, total.opened);
            total.gap = select(mine, r.gap, total.gap);
          },
          (*laws)[m]);
    }
    for (int i = 0; i < NS; ++i) sigma[i] = result[i];
    for (int i = 0; i < state_size; ++i) state[i] = result_state[i];
    return total;
  }
};

/// Material number of each lane of a slot, for blocks that hold several materials.
template <int D>
Pack lane_materials(const Points<D>& points, std::int64_t slot) {
  Pack m(0.0);
  for (int l = 0; l < lane_width; ++l) {
    const int id = points.id[static_cast<std::size_t>(slot * lane_width + l)];
    if (id >= 0) m.value[l] = points.material[static_cast<std::size_t>(id)];
  }
  return m;
}

/// Most state variables of a law in the list: what the slots of a body have room for.
inline int find_state_size(const std::vector<material::Law>& laws) {
  int size = 0;
  for (const material::Law& law : laws) size = std::max(size, material::state_size(law));
  return size;
}

/// Calls work(OneLaw or ManyLaws) for the materials in `present`.
template <class Work>
void visit_laws(const std::vector<material::Law>& laws, std::uint32_t present, Work&& work) {
  if ((present & (present - 1)) != 0) {
    work(ManyLaws{&laws, present, find_state_size(laws)});
    return;
  }
  const auto m = present == 0 ? 0u : static_cast<unsigned>(__builtin_ctz(present));
  std::visit([&](const auto& law) { work(OneLaw<std::decay_t<decltype(law)>>{law}); }, laws[m]);
}

}  // namespace talus::mpm
