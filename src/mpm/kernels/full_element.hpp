// SPDX-License-Identifier: MIT
#pragma once
// Mixed integration: all points of a full element share one stress and one state (2.92, 2.93).

#include "mpm/kernels/laws.hpp"
#include "mpm/kernels/point_kernels.hpp"
#include "mpm/state/body.hpp"

namespace talus::mpm {

/// Stress and state that the points of a full element share (2.92).
template <class B, class Law>
struct FullElement {
  using T = typename B::Lanes;
  static constexpr int NS = material::stress_size<B::dimension>;
  MaskOf<T> full{false};
  T stress[NS], state[material::max_state_size], volume, material{0.0};
  material::Response<T> response{false, T(0.0), T(0.0)};
  material::Softening<T> softening;
};

/// Rotation and strain increment that are applied to the stress of the points of an element in one step.
template <int D, class T>
struct StressIncrement {
  Rotation<D, T> rotation;
  T d_epsilon[material::stress_size<D>];
  double time;                 ///< at the start of the step [s]
  T nonlocal_correction{0.0};  ///< nonlocal correction of the dilation, ε̄_e - ε_e (T23.2)
  bool is_nonlocal = false;    ///< nonlocal averaging is on

  /// Initialises `softening` for a law that softens, and returns it for the law to fill; nullptr without nonlocal
  /// averaging.
  template <class Law>
  TALUS_KERNEL material::Softening<T>* begin(material::Softening<T>& softening) const {
    if constexpr (Law::softens) {
      softening = {nonlocal_correction};
      return is_nonlocal ? &softening : nullptr;
    } else {
      return nullptr;
    }
  }
};

/// How a law treats gaps in a block.
template <bool Apart>
TALUS_PORTABLE material::Gaps know_gaps(bool moving) {
  using material::Gaps;
  return !moving ? Gaps::ignored : Apart ? Gaps::kept : Gaps::none;
}

/// Computes which elements of block `b` are full, and the V_p-weighted means of stress and state of their points
/// (2.93). `Apart`: a point of the block keeps a gap.
template <bool Apart, class B, class Law, class T = typename B::Lanes>
TALUS_PORTABLE FullElement<B, Law> gather_full_elements(const B& body, const Law& law, int b, T count) {
  using P = PointFields<B::dimension>;
  constexpr int NS = P::stress_size, width = B::width;
  const auto& points = body.points;
  FullElement<B, Law> e;
  T volume(0.0);
  MaskOf<T> uniform(true);
  TALUS_UNROLL
  for (int i = 0; i < NS; ++i) e.stress[i] = T(0.0);
  for (int i = 0; i < law.state_size; ++i) e.state[i] = T(0.0);
  for (int k = 0; k < count_slots(points, b); ++k) {
    const MaskOf<T> active = count > T(static_cast<double>(k));
    const double* p = points.slot(points.block_start[b] + k);
    const T v = select(active, load<T>(p + P::volume * width), T(0.0));
    volume += v;
    TALUS_UNROLL
    for (int i = 0; i < NS; ++i) e.stress[i] += v * load<T>(p + (P::stress + i) * width);
    for (int i = 0; i < law.core_size; ++i) e.state[i] += v * load<T>(p + (P::state + i) * width);
    if constexpr (Apart) {
      for (int i = law.core_size; i < law.state_size; ++i) e.state[i] += v * load<T>(p + (P::state + i) * width);
    }
    if constexpr (!Law::is_single) {
      const T m = lane_materials(body, points.block_start[b] + k);
      if (k == 0) e.material = m;
      uniform = uniform && (!active || m == e.material);
    }
  }
  e.volume = volume;
  e.full = volume > load<T>(&body.elements.fill_limit[static_cast<std::size_t>(b) * width]) && uniform;
  if (!any(e.full)) return e;
  const T inverse = 1.0 / select(e.full, volume, T(1.0));
  TALUS_UNROLL
  for (int i = 0; i < NS; ++i) e.stress[i] *= inverse;
  for (int i = 0; i < law.state_size; ++i) e.state[i] *= inverse;
  return e;
}

/// Stress and state of the full elements of block `b` at the end of the step. `saturation` is that of their pore water
/// at the end of the step.
template <bool Apart, class B, class Law, int D = B::dimension, class T = typename B::Lanes>
TALUS_KERNEL void update_full_elements(const B& body, const StepOptions<D>& options, const Law& law, int b,
                                       const StressIncrement<D, T>& increment, T saturation, FullElement<B, Law>& e) {
  if (!any(e.full)) return;
  if (options.objective) increment.rotation.apply(e.stress);
  const int* first_points = &body.points.id[static_cast<std::size_t>(body.points.block_start[b] * B::width)];
  e.response = law.template update<PointFields<D>::stress_size>(
      e.stress, increment.d_epsilon, e.state, e.full, e.material,
      {saturation, first_points, increment.time, options.dt, know_gaps<Apart>(options.moving),
       increment.template begin<Law>(e.softening)});
}

/// Inputs of the stress update of the points of a block. The new stress is that of the element where it is full, else
/// the point's own.
template <bool Mixed, bool Apart, class B, class L>
struct StressUpdate {
  using Law = L;
  static constexpr bool mixed = Mixed, apart = Apart;
  const StepOptions<B::dimension>& options;
  const Law& law;
  const StressIncrement<B::dimension, typename B::Lanes>& increment;
  const FullElement<B, Law>& element;
  bool none_partial;  ///< no lane has points in an element that is not full
};

/// Stress and state of the points of a slot at the end of the step. `saturation` is that of their pore water at the end
/// of the step.
template <class Slot, bool Mixed, bool Apart, class B, class Law, class T = typename B::Lanes>
TALUS_KERNEL material::Response<T> update_point_stress(const StressUpdate<Mixed, Apart, B, Law>& update, T saturation,
                                                       Slot& points) {
  using P = PointFields<B::dimension>;
  constexpr int NS = P::stress_size, width = B::width;
  const auto& [options, law, increment, element, none_partial] = update;
  T *s = points.s, *q = points.q;
  if (none_partial) {
    TALUS_UNROLL
    for (int i = 0; i < NS; ++i) s[i] = element.stress[i];
    for (int i = 0; i < law.state_size; ++i) q[i] = element.state[i];
    if constexpr (Law::softens) points.softened = element.softening.softened;
    return element.response;
  }
  const double* p = points.p;
  TALUS_UNROLL
  for (int i = 0; i < NS; ++i) s[i] = load<T>(p + (P::stress + i) * width);
  for (int i = 0; i < law.core_size; ++i) q[i] = load<T>(p + (P::state + i) * width);
  for (int i = law.core_size; i < law.state_size; ++i) q[i] = Apart ? load<T>(p + (P::state + i) * width) : T(0.0);
  if (options.objective) increment.rotation.apply(s);
  const MaskOf<T> own = Mixed ? points.active && !element.full : points.active;
  material::Softening<T> softening;
  material::Response<T> response =
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
