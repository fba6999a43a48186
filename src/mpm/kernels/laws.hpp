// SPDX-License-Identifier: MIT
#pragma once
// Selection of the constitutive law for the lanes of a block: one law for all lanes (the common case, dispatched once
// per block), or one per lane, applied law by law under masks. There is no branch per point.

#include <algorithm>

#include "material/every_law.hpp"
#include "mpm/state/body.hpp"

namespace talus::mpm {

/// Number of states without the gap, which is the last one and zero in most blocks, where it need not be read.
template <class L>
constexpr int count_core_states() {
  if constexpr (requires { L::gap_states; })
    return L::state_size - L::gap_states;
  else
    return L::state_size;
}

/// All points of the block have this law. Kept is the law itself, whose copied parameters stay in registers and not
/// behind a pointer that a store might alias, or a reference where registers are scarce (GPU).
template <class L, class Kept = L>
struct OneLaw {
  static constexpr bool is_single = true;
  static constexpr bool is_plastic = L::is_plastic, softens = L::traits.softens;
  static constexpr int state_size = L::state_size;
  static constexpr int core_size = count_core_states<L>();
  template <class T>
  TALUS_PORTABLE static MaskOf<T> find_softening(T /*material*/) {
    return MaskOf<T>(softens);
  }
  Kept law;

  template <int NS, class T>
  TALUS_KERNEL material::Response<T> update(T* sigma, const T* d_epsilon, T* state, MaskOf<T> active, T /*material*/,
                                            const material::Surroundings<T>& around) const {
    return law.template update<NS>(sigma, d_epsilon, state, active, around);
  }
};

// Functions of a law in a list, by material number.

inline int count_states(const std::vector<material::Law>& laws, int m) {
  return material::state_size(laws[m]);
}
inline double find_modulus(const std::vector<material::Law>& laws, int m, const double* sigma, const double* state) {
  return material::constrained_modulus(laws[m], sigma, state);
}
template <int NS>
double find_energy(const std::vector<material::Law>& laws, int m, const double* sigma, const double* state) {
  return material::elastic_energy<NS>(laws[m], sigma, state);
}
inline double find_gap(const std::vector<material::Law>& laws, int m, const double* state) {
  return material::find_gap(laws[m], state);
}
inline bool law_softens(const std::vector<material::Law>& laws, std::uint32_t m) {
  return material::traits_of(laws[m]).softens;
}
void visit_law(const std::vector<material::Law>& laws, std::uint32_t m, auto&& work) {
  std::visit([&](const auto& law) { work(material::get_kernel(law)); }, laws[m]);
}

/// Lanes may have different laws; `material` of update() is the material number of each lane.
template <class Laws = std::vector<material::Law>>
struct ManyLaws {
  static constexpr bool is_single = false;
  static constexpr bool is_plastic = true, softens = true;
  const Laws* laws;
  std::uint32_t present;  ///< bit set of the materials in the block
  int state_size;         ///< largest number of state variables of a law of the body
  int core_size = state_size;

  /// Mask of the lanes whose law softens.
  template <class T>
  TALUS_PORTABLE MaskOf<T> find_softening(T material) const {
    MaskOf<T> some(false);
    for (std::uint32_t m = 0; m < laws->size(); ++m)
      if ((present >> m & 1) && law_softens(*laws, m)) some = some || material == T(static_cast<double>(m));
    return some;
  }

  template <int NS, class T>
  TALUS_PORTABLE material::Response<T> update(T* sigma, const T* d_epsilon, T* state, MaskOf<T> active, T material,
                                              const material::Surroundings<T>& around) const {
    material::Response<T> total{false, T(0.0), T(0.0)};
    T result[NS], result_state[material::max_state_size];
    for (int i = 0; i < NS; ++i) result[i] = sigma[i];
    for (int i = 0; i < state_size; ++i) result_state[i] = state[i];
    for (std::uint32_t m = 0; m < laws->size(); ++m) {
      if (!(present >> m & 1)) continue;
      const MaskOf<T> mine = active && material == T(static_cast<double>(m));
      if (!any(mine)) continue;
      visit_law(*laws, m, [&](const auto& law) {
        T s[NS], q[material::max_state_size];
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
      });
    }
    for (int i = 0; i < NS; ++i) sigma[i] = result[i];
    for (int i = 0; i < state_size; ++i) state[i] = result_state[i];
    return total;
  }
};

/// Material number of each lane of a slot, for blocks with several materials.
template <class B>
TALUS_PORTABLE typename B::Lanes lane_materials(const B& body, std::int64_t slot) {
  typename B::Lanes m(0.0);
  for (int l = 0; l < LaneTraits<typename B::Lanes>::width; ++l) {
    const int id = body.points.id[static_cast<std::size_t>(slot * B::width + l)];
    if (id >= 0) set_lane(m, l, body.points.material[static_cast<std::size_t>(id)]);
  }
  return m;
}

/// Largest number of state variables of a law in the list; the slots of a body are sized for it.
inline int find_state_size(const std::vector<material::Law>& laws) {
  int size = 0;
  for (const material::Law& law : laws) size = std::max(size, material::state_size(law));
  return size;
}

}  // namespace talus::mpm
