// SPDX-License-Identifier: MIT
#pragma once
// Kernels of relocation and of the null-mode filter, one thread per element, node or point. Points that left their
// element are removed in the order of the elements, search their new element independently, and are inserted sorted by
// it, so that the place of a point depends on the body only. The sums of changed elements are recomputed.

#include "base/portable.hpp"
#include "mpm/backend/device_kernels.hpp"
#include "mpm/backend/thread_body.hpp"
#include "mpm/kernels/element_kernels.hpp"
#include "mpm/kernels/element_search.hpp"
#include "mpm/kernels/null_mode_kernels.hpp"

namespace talus::mpm::device {

// filter_null_modes(), the filter of null modes.

/// Work arrays of the iteration for the nodal velocities (T2.5).
template <int D>
struct FadeRows {
  View<double> u;          ///< [node][filter_stride] velocities [m/s]
  View<double> direction;  ///< [node][D] last change of u
  View<double> product;    ///< [element][D+1][D] contribution of an element to M u
};

/// Sums momentum and mass of a node over its elements.
template <int D>
TALUS_PORTABLE void sum_momentum(const ThreadBody<D>& body, int i, double* t) {
  const int first = body.layout->row_start[i], count = body.layout->row_start[i + 1] - first;
  for (int q = 0; q <= D; ++q) t[q] = 0;
  if (count > 0) sum_rows<1 + D, sums_stride>(body.nodes.sums, &body.layout->node_rows[first], count, t);
}

template <int D>
struct StartFilter {
  ThreadBody<D> body;
  FadeRows<D> rows;

  TALUS_PORTABLE void operator()(int i) const {
    double t[1 + D];
    sum_momentum(body, i, t);
    const double inverse = t[0] > 1e-12 * body.smallest_mass ? 1 / t[0] : 0;
    for (int d = 0; d < D; ++d) {
      rows.u[static_cast<std::size_t>(i) * filter_stride + static_cast<std::size_t>(d)] = t[1 + d] * inverse;
      rows.direction[static_cast<std::size_t>(i) * D + static_cast<std::size_t>(d)] = 0;
    }
  }
};

template <int D>
struct MultiplyMass {
  ThreadBody<D> body;
  FadeRows<D> rows;

  TALUS_PORTABLE void operator()(int e) const {
    const ThreadBody<D> mine = body.for_element(e);
    double value[D + 1][D], out[D + 1][D] = {};
    if (count_slots(mine.points, e / device_width) > 0)
      multiply_mass(mine, mine.elements.moments, rows.u, e / device_width, value, out);
    double* product = &rows.product[static_cast<std::size_t>(e) * (D + 1) * D];
    for (int k = 0; k <= D; ++k)
      for (int d = 0; d < D; ++d) product[k * D + d] = out[k][d];
  }
};

template <int D>
struct ImproveVelocity {
  ThreadBody<D> body;
  FadeRows<D> rows;
  FilterWeights weights;

  TALUS_PORTABLE void operator()(int i) const {
    double t[1 + D], Mu[D] = {};
    sum_momentum(body, i, t);
    const double inverse = t[0] > 1e-12 * body.smallest_mass ? 1 / t[0] : 0;
    for (int r = body.layout->row_start[i]; r < body.layout->row_start[i + 1]; ++r) {
      const double* product = &rows.product[static_cast<std::size_t>(body.layout->node_rows[r]) * D];
      for (int d = 0; d < D; ++d) Mu[d] += product[d];
    }
    double* u = &rows.u[static_cast<std::size_t>(i) * filter_stride];
    double* direction = &rows.direction[static_cast<std::size_t>(i) * D];
    for (int d = 0; d < D; ++d) {
      direction[d] = weights.keep * direction[d] + weights.step * (t[1 + d] - Mu[d]) * inverse;
      u[d] += direction[d];
    }
  }
};

/// G2P of the filter: replaces the velocities of an element's points by those of its nodes. The energy lost is added to
/// `shared` of `accounts`.
template <int D>
struct FadeElement {
  ThreadBody<D> body;
  FadeRows<D> rows;
  int more_mass;  ///< field of a mass that moves with the points (pore water); -1: none
  View<ElementAccount> accounts;

  TALUS_PORTABLE void operator()(int e) const {
    ThreadBody<D> mine = body.for_element(e);
    const int b = e / device_width;
    double value[D + 1][D], out[D + 1][D], lost = 0;
    if (count_slots(mine.points, b) > 0) {
      multiply_mass(mine, mine.elements.moments, rows.u, b, value, out);
      for (int k = 0; k <= D; ++k)
        for (int d = 0; d < D; ++d) sums_row(mine, e, k)[1 + d] = out[k][d];
      filter_points(mine, b, value, {PointFields<D>::mass, PointFields<D>::velocity, more_mass}, lost);
    }
    accounts[static_cast<std::size_t>(e)] = {0, lost};
  }
};

/// Points that migrate between elements, [mover].
struct Movers {
  View<double> fields;  ///< [field][mover]
  View<int> id, from;
  View<unsigned> to;      ///< new element; the number of elements: outside the grid
  View<int> order;        ///< permutation that sorts movers by `to`
  View<unsigned> sorted;  ///< `to` in that order
};

/// Why the sums of an element are recomputed, as bits.
enum Change : int { lost_points = 1, got_points = 2, changed_surface = 4 };

/// Flags that the host reads.
struct Signals {
  int leave_grid = 0;  ///< some points left the grid
  int overflow = 0;    ///< some block has too few slots for arriving points
};

/// Removes the points that left an element from its slots.
template <int D>
struct TakeOut {
  using P = PointFields<D>;
  ThreadBody<D> body;
  View<const int> leaving, first;  ///< [element] number of movers, and index of the first one
  Movers movers;
  View<int> change;

  TALUS_PORTABLE void operator()(int e) const {
    change[static_cast<std::size_t>(e)] = 0;
    if (leaving[static_cast<std::size_t>(e)] == 0) return;
    change[static_cast<std::size_t>(e)] = lost_points;
    const std::int64_t begin = body.points.block_start[static_cast<std::size_t>(e / device_width)];
    const int lane = e % device_width;
    double& count = body.points.count[static_cast<std::size_t>(e)];
    int to = first[static_cast<std::size_t>(e)];
    // Backwards, so that the last point, which fills the vacated slot, never is one that is still to be removed.
    for (int k = static_cast<int>(count) - 1; k >= 0; --k) {
      const double* p = body.points.slot(begin + k) + lane;
      double xi[D];
      for (int d = 0; d < D; ++d) xi[d] = p[(P::xi + d) * device_width];
      if (!(smallest_shape<D>(xi) < 0)) continue;
      note(begin + k, lane, to++, e);
      count -= 1;
      fill_gap(begin + k, begin + static_cast<std::int64_t>(count), lane);
    }
  }

 private:
  TALUS_PORTABLE void note(std::int64_t slot, int lane, int m, int e) const {
    const double* p = body.points.slot(slot) + lane;
    for (int f = 0; f < body.points.fields; ++f)
      movers.fields[static_cast<std::size_t>(f) * movers.id.count + static_cast<std::size_t>(m)] = p[f * device_width];
    movers.id[static_cast<std::size_t>(m)] = body.points.id[static_cast<std::size_t>(slot * device_width + lane)];
    movers.from[static_cast<std::size_t>(m)] = e;
  }
  TALUS_PORTABLE void fill_gap(std::int64_t hole, std::int64_t last, int lane) const {
    int& id = body.points.id[static_cast<std::size_t>(last * device_width + lane)];
    if (hole != last) {
      double* to = body.points.slot(hole) + lane;
      const double* from = body.points.slot(last) + lane;
      for (int f = 0; f < body.points.fields; ++f) to[f * device_width] = from[f * device_width];
      body.points.id[static_cast<std::size_t>(hole * device_width + lane)] = id;
      body.points.place[static_cast<std::size_t>(id)] = hole * device_width + lane;
    }
    id = -1;
  }
};

/// Searches the new element of a mover.
template <int D>
struct Walk {
  ThreadBody<D> body;
  Movers movers;
  View<Signals> signals;

  TALUS_PORTABLE void operator()(int m) const {
    const auto at = static_cast<std::size_t>(m);
    const std::size_t stride = movers.id.count;
    double* fields = &movers.fields[at];
    double xi[D];
    for (int d = 0; d < D; ++d) xi[d] = fields[static_cast<std::size_t>(PointFields<D>::xi + d) * stride];
    int element = movers.from[at];
    const bool stays = find_new_element<D>(body.mesh(), element, xi);
    for (int d = 0; d < D; ++d) fields[static_cast<std::size_t>(PointFields<D>::xi + d) * stride] = xi[d];
    movers.to[at] = static_cast<unsigned>(stays ? element : body.element_count);
    movers.order[at] = m;
    const auto id = static_cast<std::size_t>(movers.id[at]);
    if (stays) {
      migrate_point(id, movers.from[at], element);
      return;
    }
    movers.from[at] = element;  // the element where it left the grid
    body.points.element[id] = -1;
    body.points.place[id] = -1;
    raise_flag(signals[0].leave_grid);
  }

 private:
  /// Sets the strain offset of a point so that its total strain is unchanged: strain is stored by element.
  TALUS_PORTABLE void migrate_point(std::size_t id, int from, int to) const {
    constexpr int NS = PointFields<D>::stress_size;
    const auto begin = [this](int e) {
      return &body.elements.strain[static_cast<std::size_t>(e / device_width) * NS * device_width] + e % device_width;
    };
    const double *before = begin(from), *after = begin(to);
    auto& offset = body.points.strain_offset[id];
    for (int i = 0; i < NS; ++i)
      offset[static_cast<std::size_t>(i)] += before[i * device_width] - after[i * device_width];
  }
};

/// Number of movers into one element: length of the run of equal entries that starts at the sorted mover `m`; 0 if no
/// run starts there.
TALUS_PORTABLE inline int count_run(const View<const unsigned>& sorted, int m, unsigned elements) {
  const unsigned* here = sorted.start + m;
  const unsigned* end = sorted.start + sorted.count;
  if (*here == elements || (m > 0 && here[-1] == *here)) return 0;
  int length = 1;
  while (here + length < end && here[length] == *here) ++length;
  return length;
}

/// Checks that blocks have enough slots for arriving points; `room` [block] receives the number needed.
template <int D>
struct AskForRoom {
  ThreadBody<D> body;
  View<const unsigned> sorted;
  View<int> arrivals;
  View<Signals> signals;

  TALUS_PORTABLE void operator()(int m) const {
    const int length = count_run(sorted, m, static_cast<unsigned>(body.element_count));
    if (length == 0) return;
    const std::size_t e = sorted[static_cast<std::size_t>(m)];
    arrivals[e] = length;
    const int needed = static_cast<int>(body.points.count[e]) + length;
    if (needed > body.points.block_capacity[e / device_width]) raise_flag(signals[0].overflow);
  }
};

/// Number of slots that a block needs.
template <int D>
struct CountRoom {
  ThreadBody<D> body;
  View<const int> arrivals;
  View<int> room;

  TALUS_PORTABLE void operator()(int b) const {
    int most = 0;
    for (int lane = 0; lane < device_width; ++lane) {
      const auto e = static_cast<std::size_t>(b) * device_width + static_cast<std::size_t>(lane);
      const int needed = static_cast<int>(body.points.count[e]) + arrivals[e];
      most = needed > most ? needed : most;
    }
    room[static_cast<std::size_t>(b)] = most;
  }
};

/// A block and its new place.
struct MovedBlock {
  int block, capacity;
  std::int64_t start;
};

/// Copies the slots of blocks to their new places; one thread per lane of a block.
template <int D>
struct MoveSlots {
  ThreadBody<D> body;  ///< before the move
  View<const MovedBlock> blocks;
  DevicePoints<D> to;

  TALUS_PORTABLE void operator()(int t) const {
    const MovedBlock& moved = blocks[static_cast<std::size_t>(t / device_width)];
    const int lane = t % device_width;
    const auto b = static_cast<std::size_t>(moved.block);
    const int count = static_cast<int>(body.points.count[b * device_width + static_cast<std::size_t>(lane)]);
    for (int k = 0; k < count; ++k) {
      const std::int64_t old = body.points.block_start[b] + k, now = moved.start + k;
      const double* from = body.points.slot(old) + lane;
      double* there = to.slot(now) + lane;
      for (int f = 0; f < to.fields; ++f) there[f * device_width] = from[f * device_width];
      const int id = body.points.id[static_cast<std::size_t>(old * device_width + lane)];
      to.id[static_cast<std::size_t>(now * device_width + lane)] = id;
      body.points.place[static_cast<std::size_t>(id)] = now * device_width + lane;
    }
  }
};

/// Updates start and capacity of the moved blocks.
struct NoteMoved {
  View<const MovedBlock> blocks;
  View<std::int64_t> block_start;
  View<int> block_capacity;

  TALUS_PORTABLE void operator()(int i) const {
    const MovedBlock& moved = blocks[static_cast<std::size_t>(i)];
    block_start[static_cast<std::size_t>(moved.block)] = moved.start;
    block_capacity[static_cast<std::size_t>(moved.block)] = moved.capacity;
  }
};

/// Appends the movers of an element to its points.
template <int D>
struct PutIn {
  ThreadBody<D> body;
  Movers movers;
  View<int> arrivals, change;

  TALUS_PORTABLE void operator()(int m) const {
    const View<const unsigned> sorted{movers.sorted.start, movers.sorted.count};
    const int length = count_run(sorted, m, static_cast<unsigned>(body.element_count));
    if (length == 0) return;
    const std::size_t e = sorted[static_cast<std::size_t>(m)], stride = movers.id.count;
    const int lane = static_cast<int>(e % device_width);
    double& count = body.points.count[e];
    for (int i = 0; i < length; ++i) {
      const auto mover = static_cast<std::size_t>(movers.order.start[m + i]);
      const std::int64_t slot = body.points.block_start[e / device_width] + static_cast<std::int64_t>(count);
      double* p = body.points.slot(slot) + lane;
      for (int f = 0; f < body.points.fields; ++f)
        p[f * device_width] = movers.fields[static_cast<std::size_t>(f) * stride + mover];
      const int id = movers.id[mover];
      body.points.id[static_cast<std::size_t>(slot * device_width + lane)] = id;
      body.points.element[static_cast<std::size_t>(id)] = static_cast<int>(e);
      body.points.place[static_cast<std::size_t>(id)] = slot * device_width + lane;
      count += 1;
    }
    arrivals[e] = 0;
    change[e] |= got_points;
  }
};

/// Mixed integration: updates the fill limit of an element.
template <int D>
struct UpdateSurface {
  ThreadBody<D> body;
  View<int> change;

  TALUS_PORTABLE void operator()(int e) const {
    ThreadBody<D> mine = body;
    if (update_fill_limit(mine, e)) change[static_cast<std::size_t>(e)] |= changed_surface;
  }
};

/// Value of DevicePoints::soil for an element.
template <int D>
TALUS_PORTABLE int find_soil(const ThreadBody<D>& body, int e) {
  int soil = no_soil;
  const std::int64_t first = body.points.block_start[static_cast<std::size_t>(e / device_width)];
  for (int k = 0; k < static_cast<int>(body.points.count[static_cast<std::size_t>(e)]); ++k) {
    const int id = body.points.id[static_cast<std::size_t>((first + k) * device_width + e % device_width)];
    const int own = body.points.material[static_cast<std::size_t>(id)];
    soil = soil == no_soil || soil == own ? own : many_soils;
  }
  return soil;
}

/// Recomputes the sums of an element that changed, from its points. `all`: of every element, after the transfer of the
/// body.
template <int D>
struct SumAnew {
  ThreadBody<D> body;
  StepOptions<D> options;
  bool all;
  int more_mass;  ///< field of a mass that moves with the points (pore water); -1: none
  View<int> change;
  View<ElementAccount> accounts;

  TALUS_PORTABLE void operator()(int e) const {
    const int why = change[static_cast<std::size_t>(e)];
    if (!all && why == 0) return;
    ThreadBody<D> mine = body;
    for (int k = 0; k <= D; ++k) {
      double* row = sums_row(mine, e, k);
      for (int c = 0; c < sums_stride; ++c) row[c] = 0;
    }
    double* moments =
        &mine.elements.moments[static_cast<std::size_t>(e / device_width) * moment_size<D> * device_width +
                               static_cast<std::size_t>(e % device_width)];
    for (int i = 0; i < moment_size<D>; ++i) moments[i * device_width] = 0;
    if (all || (why & (lost_points | got_points)) != 0) note_gaps(mine, options, e);
    gather_points(mine, options, e, more_mass);
    mine.points.soil[static_cast<std::size_t>(e)] = static_cast<std::uint8_t>(find_soil(mine, e));
    if (mine.points.count[static_cast<std::size_t>(e)] == 0)
      mine.elements.plastic_dilation[static_cast<std::size_t>(e)] = mine.elements.rough[static_cast<std::size_t>(e)] =
          0;
    if (!all && (why & (got_points | changed_surface)) != 0)
      accounts[static_cast<std::size_t>(e)].shared = find_sharing_loss(mine, options, e);
  }
};

}  // namespace talus::mpm::device
