// SPDX-License-Identifier: MIT
#pragma once
// Mixed integration: one stress and one state for all points of an element that is full (2.92).

#include "mpm/step/kernels.hpp"
#include "mpm/step/laws.hpp"
#include "mpm/step/step.hpp"

namespace talus::mpm {

/// Stress and state that a full element (2.92) gives to all its points.
template <int D, class Law>
struct FullElement {
  static constexpr int NS = material::stress_size<D>;
  Mask full{false};
  Pack stress[NS], state[material::max_state_size], volume, material{0.0};
  material::Response<Pack> response{false, Pack(0.0), Pack(0.0)};
  material::Softening<Pack> softening;
};

/// What a step does to the stress of an element's points.
template <int D>
struct StressIncrement {
  Rotation<D, Pack> rotation;
  Pack d_epsilon[material::stress_size<D>];
  double time;  ///< at the start of the step [s]
  Pack lent{0.0};
  bool lends = false;  ///< softening has a length

  /// What a law is given and answers of it, in `softening`.
  template <class Law>
  TALUS_KERNEL material::Softening<Pack>* begin(material::Softening<Pack>& softening) const {
    if constexpr (Law::softens) {
      softening = {lent};
      return lends ? &softening : nullptr;
    } else {
      return nullptr;
    }
  }
};

/// What the law is told of the gaps of a block.
template <bool Apart>
material::Gaps know_gaps(bool moving) {
  using material::Gaps;
  return !moving ? Gaps::ignored : Apart ? Gaps::kept : Gaps::none;
}

/// Which elements of block `b` are full, and the means of their points' stress and state. `Apart`: a point of the block
/// keeps a gap.
template <bool Apart, int D, class Law>
FullElement<D, Law> gather_full_elements(const Body<D>& body, const Law& law, int b, Pack count) {
  using P = Points<D>;
  constexpr int NS = P::stress_size;
  const P& points = body.points;
  FullElement<D, Law> e;
  Pack volume(0.0);
  Mask uniform(true);
  TALUS_UNROLL
  for (int i = 0; i < NS; ++i) e.stress[i] = Pack(0.0);
  for (int i = 0; i < law.state_size; ++i) e.state[i] = Pack(0.0);
  for (int k = 0; k < points.block_used[b]; ++k) {
    const Mask active = count > Pack(static_cast<double>(k));
    const double* p = points.slot(points.block_start[b] + k);
    const Pack v = select(active, load<Pack>(p + P::volume * lane_width), Pack(0.0));
    volume += v;
    TALUS_UNROLL
    for (int i = 0; i < NS; ++i) e.stress[i] += v * load<Pack>(p + (P::stress + i) * lane_width);
    for (int i = 0; i < law.core_size; ++i) e.state[i] += v * load<Pack>(p + (P::state + i) * lane_width);
    if constexpr (Apart) {
      for (int i = law.core_size; i < law.state_size; ++i)
        e.state[i] += v * load<Pack>(p + (P::state + i) * lane_width);
    }
    if constexpr (!Law::is_single) {
      const Pack m = lane_materials(points, points.block_start[b] + k);
      if (k == 0) e.material = m;
      uniform = uniform && (!active || m == e.material);
    }
  }
  e.volume = volume;
  e.full = volume > load<Pack>(&body.elements.fill_limit[static_cast<std::size_t>(b) * lane_width]) && uniform;
  if (!any(e.full)) return e;
  const Pack inverse = 1.0 / select(e.full, volume, Pack(1.0));
  TALUS_UNROLL
  for (int i = 0; i < NS; ++i) e.stress[i] *= inverse;
  for (int i = 0; i < law.state_size; ++i) e.state[i] *= inverse;
  return e;
}

/// Stress and state of the full elements of block `b` at the end of the step. `saturation`: of their pore water then.
template <bool Apart, int D, class Law>
TALUS_KERNEL void update_full_elements(const Body<D>& body, const StepOptions<D>& options, const Law& law, int b,
                                       const StressIncrement<D>& increment, Pack saturation, FullElement<D, Law>& e) {
  if (!any(e.full)) return;
  if (options.objective) increment.rotation.apply(e.stress);
  const int* first_points = &body.points.id[static_cast<std::size_t>(body.points.block_start[b] * lane_width)];
  e.response = law.template update<Points<D>::stress_size>(
      e.stress, increment.d_epsilon, e.state, e.full, e.material,
      {saturation, first_points, increment.time, options.dt, know_gaps<Apart>(options.moving),
       increment.template begin<Law>(e.softening)});
}

/// Where the points of a block take their new stress from: their element where it is full, else their own.
template <bool Mixed, bool Apart, int D, class L>
struct StressUpdate {
  using Law = L;
  static constexpr bool mixed = Mixed, apart = Apart;
  const StepOptions<D>& options;
  const Law& law;
  const StressIncrement<D>& increment;
  const FullElement<D, Law>& element;
  bool none_partial;  ///< no lane has points in an element that is not full
};

/// Stress and state of the points of a slot at the end of the step. `saturation`: of their pore water then.
template <class Slot, bool Mixed, bool Apart, int D, class Law>
TALUS_KERNEL material::Response<Pack> update_point_stress(const StressUpdate<Mixed, Apart, D, Law>& update,
                                                          Pack saturation, Slot& points) {
  using P = Points<D>;
  constexpr int NS = P::stress_size;
  const auto& [options, law, increment, element, none_partial] = update;
  Pack *s = points.s, *q = points.q;
  if (none_partial) {
    TALUS_UNROLL
    for (int i = 0; i < NS; ++i) s[i] = element.stress[i];
    for (int i = 0; i < law.state_size; ++i) q[i] = element.state[i];
    if constexpr (Law::softens) points.softened = element.softening.softened;
    return element.response;
  }
  const double* p = points.p;
  TALUS_UNROLL
  for (int i = 0; i < NS; ++i) s[i] = load<Pack>(p + (P::stress + i) * lane_width);
  for (int i = 0; i < law.core_size; ++i) q[i] = load<Pack>(p + (P::state + i) * lane_width);
  for (int i = law.core_size; i < law.state_size; ++i)
    q[i] = Apart ? load<Pack>(p + (P::state + i) * lane_width) : Pack(0.0);
  if (options.objective) increment.rotation.apply(s);
  const Mask own = Mixed ? points.active && !element.full : points.active;
  material::Softening<Pack> softening;
  material::Response<Pack> response =
      law.template update<NS>(s, increment.d_epsilon, q, own, points.material,
                              {saturation, points.ids, increment.time, options.dt, know_gaps<Apart>(options.moving),
                               increment.template begin<Law>(softening)});
  if constexpr (Law::softens)
    points.softened = Mixed ? select(element.full, element.softening.softened, softening.softened) : softening.softened;
  if constexpr (Mixed) {
    TALUS_UNROLL
    for (int i = 0; i < NS; ++i) s[i] = select(element.full, element.stress[i], s[i]);
    for (int i = 0; i < law.state_size; ++i) q[i] = select(element.full, element.state[i], q[i]);
    response.any_plastic = response.any_plastic || element.response.any_plastic;
    response.dissipation = select(element.full, element.response.dissipation, response.dissipation);
    response.plastic_dilation = select(element.full, element.response.plastic_dilation, response.plastic_dilation);
    response.opened = select(element.full, element.response.opened, response.opened);
    response.gap = select(element.full, element.response.gap, response.gap);
  }
  return response;
}

}  // namespace talus::mpm
