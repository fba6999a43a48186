// SPDX-License-Identifier: MIT
// Relocation of points that left their element: search by walking through the sides, migration between ranks, and
// correction of the nodal sums, in an order that does not depend on the number of threads.
#include "mpm/kernels/element_search.hpp"

#include <algorithm>

#include "mpm/kernels/element_kernels.hpp"
#include "mpm/kernels/point_kernels.hpp"
#include "mpm/solver/step.hpp"
#include "mpm/state/partition.hpp"
#include "mpm/state/slots.hpp"
#include "mpm/two_velocity/kernels.hpp"
#include "mpm/two_velocity/two_velocity_step.hpp"

namespace talus::mpm {
namespace {

template <int D>
void record_loss(Body<D>& body, const Record<D>& r, std::vector<double>& water) {
  using P = Points<D>;
  Lost<D> lost;
  lost.id = r.id;
  lost.time = body.time;
  lost.mass = r.fields[P::mass];
  std::array<double, D> xi;
  for (int d = 0; d < D; ++d) {
    xi[d] = r.fields[P::xi + d];
    lost.momentum[d] = lost.mass * r.fields[P::velocity + d];
  }
  lost.position = mesh::to_global(body.mesh(), r.element, xi);
  body.lost.push_back(lost);
  if (body.water.is_wet()) water.push_back(r.fields[body.water.first_field + WaterFields<D>::mass]);
  body.points.element[r.id] = -1;
  body.points.place[r.id] = -1;
}

/// A point between two elements, with the strain data that are stored per element and not in its own fields.
template <int D>
struct Traveller {
  using Strain = std::array<double, Points<D>::stress_size>;
  Record<D> record;
  Strain from{};  ///< strain of the element that it left
  Strain offset{};
};

template <int D>
typename Traveller<D>::Strain read_strain(const Body<D>& body, int e) {
  typename Traveller<D>::Strain strain;
  for (std::size_t i = 0; i < strain.size(); ++i)
    strain[i] = body.elements.strain[(static_cast<std::size_t>(e / lane_width) * strain.size() + i) * lane_width +
                                     static_cast<std::size_t>(e % lane_width)];
  return strain;
}

/// Sets the strain offset of a point in its new element so that its total strain is unchanged.
template <int D>
void migrate_point(Body<D>& body, const Traveller<D>& point) {
  const auto to = read_strain(body, point.record.element);
  auto& offset = body.points.strain_offset[point.record.id];
  for (std::size_t i = 0; i < to.size(); ++i) offset[i] = point.offset[i] + (point.from[i] - to[i]);
}

/// Migrates points to the rank of their new element. Returns the points that arrive in elements of this rank (its own
/// and those of other ranks, in the order of the ranks); points that leave are removed from this rank.
template <int D>
std::vector<Traveller<D>> exchange_points(Body<D>& body, std::vector<Traveller<D>> points) {
  if (!body.partition) return points;
  const Partition<D>& share = *body.partition;
  std::vector<Message> to(static_cast<std::size_t>(share.ranks->size()));
  const auto fields = static_cast<std::size_t>(body.points.fields);
  for (const Traveller<D>& p : points) {
    const int chunk = find_interval(body.layout->chunk_start, p.record.element / lane_width);
    const auto rank = static_cast<std::size_t>(find_interval(share.chunk_of_rank, chunk));
    if (static_cast<int>(rank) != share.ranks->rank())
      body.points.element[p.record.id] = -1, body.points.place[p.record.id] = -1;
    to[rank].put(p.record.id);
    to[rank].put(p.record.element);
    to[rank].put(p.record.fields, fields);
    to[rank].put(p.from);
    to[rank].put(p.offset);
    to[rank].put(body.points.reference[p.record.id]);
    to[rank].put(body.points.material[p.record.id]);
  }
  std::vector<Bytes> sent;
  for (const Message& m : to) sent.push_back(m.bytes());
  std::vector<Traveller<D>> coming;
  for (Bytes& bytes : share.ranks->exchange(sent)) {
    Message m(std::move(bytes));
    while (!m.is_read()) {
      Traveller<D>& p = coming.emplace_back();
      p.record.id = m.get<int>();
      p.record.element = m.get<int>();
      m.get(p.record.fields, fields);
      p.from = m.get<typename Traveller<D>::Strain>();
      p.offset = m.get<typename Traveller<D>::Strain>();
      m.get(&body.points.reference[p.record.id], 1);
      m.get(&body.points.material[p.record.id], 1);
    }
  }
  return coming;
}

/// Gathers the lost points of all ranks in the order of the ranks and adds the water [kg] that left with them. Returns
/// whether any rank has elements to correct.
template <int D>
bool join_losses(Body<D>& body, std::size_t before, std::vector<double> water, bool changes) {
  if (body.partition) {
    Message mine;
    mine.put(changes);
    mine.put_list(std::vector<Lost<D>>(body.lost.begin() + static_cast<std::ptrdiff_t>(before), body.lost.end()));
    mine.put_list(water);
    body.lost.resize(before);
    water.clear();
    for (Bytes& bytes : body.partition->ranks->gather(mine.bytes(), true)) {
      Message message(std::move(bytes));
      changes = message.get<bool>() || changes;
      for (const Lost<D>& lost : message.get_list<Lost<D>>()) body.lost.push_back(lost);
      for (const double mass : message.get_list<double>()) water.push_back(mass);
    }
  }
  for (const double mass : water) body.water.left_grid += mass;
  return changes;
}

template <int D>
void add_point_force(Body<D>& body, const Record<D>& r) {
  using P = Points<D>;
  double stress[force_size<D>], g[D * D], out[D + 1][1 + 2 * D];
  for (int i = 0; i < force_size<D>; ++i) {
    stress[i] = r.fields[P::volume] * r.fields[P::stress + force_component<D>(i)];
  }
  for (int i = 0; i < D * D; ++i) g[i] = body.mesh().gradients[r.element][i];
  ElementSums<D, double>::force_to_nodes(stress, g, out);
  const std::size_t b = static_cast<std::size_t>(r.element / lane_width),
                    lane = static_cast<std::size_t>(r.element % lane_width);
  for (int k = 0; k <= D; ++k) {
    const int row = body.layout->connectivity[(b * (D + 1) + static_cast<std::size_t>(k)) * lane_width + lane];
    for (int d = 0; d < D; ++d)
      body.nodes.sums[static_cast<std::size_t>(row) * sums_stride + static_cast<std::size_t>(1 + D + d)] +=
          out[k][1 + D + d];
  }
}

/// The record with the mass of its water added to its mass, if it has any.
template <int D>
Record<D> weigh(const Body<D>& body, Record<D> r) {
  if (body.water.is_wet()) r.fields[Points<D>::mass] += r.fields[body.water.first_field + WaterFields<D>::mass];
  return r;
}

/// Clears the moments of a block that has no points yet: the pass skips such blocks, so their moments are out of date.
template <int D>
void wake_block(Body<D>& body, int b) {
  if (body.points.block_used[b] > 0) return;
  const auto clear = [b](AlignedVector<double>& field, int size) {
    std::fill_n(field.begin() + static_cast<std::int64_t>(b) * size * lane_width, size * lane_width, 0.0);
  };
  clear(body.elements.moments, moment_size<D>);
  if (!body.water.is_wet()) return;
  clear(body.water.moments, moment_size<D>);
  clear(body.water.volume, 1);
}

/// Elements whose filling or free-surface state changes when the records are inserted; sorted.
template <int D>
std::vector<int> find_changed_elements(const Body<D>& body, const std::vector<Record<D>>& records,
                                       const std::vector<int>& sources) {
  const mesh::Mesh<D>& mesh = body.mesh();
  std::vector<int> candidates;
  for (const Record<D>& r : records) candidates.push_back(r.element);
  // Elements that lost their last point or receive their first one change the surface of their neighbours.
  std::vector<int> changed = candidates;
  changed.insert(changed.end(), sources.begin(), sources.end());
  std::erase_if(changed, [&](int e) { return body.points.count[e] > 0; });
  const auto [begin, end] = own_elements(body);
  for (int e : join_lists(body, std::move(changed))) {
    candidates.push_back(e);
    for (int n : mesh.neighbours[e]) {
      if (n >= 0) candidates.push_back(n);
    }
  }
  std::erase_if(candidates, [from = begin, to = end](int e) { return e < from || e >= to; });
  std::sort(candidates.begin(), candidates.end());
  candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
  return candidates;
}

/// Inserts the records. With mixed integration, the internal force of elements whose filling or free-surface state
/// changes is recomputed. The elastic energy that their points lose by sharing one stress is added to work.mapping.
template <int D>
void insert_with_mixed_forces(Body<D>& body, const StepOptions<D>& o, const std::vector<Record<D>>& records,
                              const std::vector<int>& sources) {
  const std::vector<int> candidates = find_changed_elements(body, records, sources);
  for (int e : candidates) add_internal_force(body, e, true, -1);
  for (const Record<D>& r : records) {
    wake_block(body, r.element / lane_width);
    insert_point(body.points, r);
    add_point_mass(body, r.element, weigh(body, r).fields);
  }
  update_counts(body);
  for (int e : candidates) update_fill_limit(body, e);
  std::vector<double> losses;
  for (int e : candidates) {
    add_internal_force(body, e, true, 1);
    losses.push_back(find_sharing_loss(body, o, e));
  }
  for (const double loss : join_lists(body, std::move(losses))) body.work.mapping += loss;
}

/// The same with pore water, where the sums of an element are not sums over its points, which share one pressure.
/// Elements that became full in the pass are recomputed as well.
template <int D>
void insert_wet_points(Body<D>& body, const StepOptions<D>& o, const std::vector<Record<D>>& records,
                       const std::vector<int>& sources) {
  std::vector<int> candidates = find_changed_elements(body, records, sources);
  candidates.insert(candidates.end(), body.water.newly_full.begin(), body.water.newly_full.end());
  std::sort(candidates.begin(), candidates.end());
  candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
  // Next to dry soil an element may also gain or lose its water without becoming empty.
  const bool all_wet =
      std::all_of(body.water.laws.begin(), body.water.laws.end(), [](const auto& law) { return law.wet; });
  if (!all_wet && !sources.empty()) body.water.surface_is_stale = true;
  for (const Record<D>& r : records) {
    if (body.points.block_used[r.element / lane_width] == 0) wake_block(body, r.element / lane_width);
  }
  for (int e : candidates) {
    if (body.points.count[e] > 0) add_wet_element(body, e, o, -1);
    body.water.surface_is_stale = body.water.surface_is_stale || body.points.count[e] == 0;
  }
  for (const Record<D>& r : records) insert_point(body.points, r);
  update_counts(body);
  for (int e : candidates) update_fill_limit(body, e);
  std::vector<double> losses;
  for (int e : candidates) {
    average_wet_element(body, e, o);
    add_wet_element(body, e, o, 1);
    losses.push_back(find_sharing_loss(body, o, e));
  }
  for (const double loss : join_lists(body, std::move(losses))) body.work.mapping += loss;
}

}  // namespace

template <int D>
void relocate(Body<D>& body, const StepOptions<D>& o, const MoverLists& movers) {
  std::vector<Record<D>> records;
  std::vector<int> sources;
  for (const std::vector<Mover>& list : movers) {
    // Backwards, so that the last point of a lane, which fills the vacated slot, never is one that is still to be
    // removed.
    for (auto m = list.rbegin(); m != list.rend(); ++m) {
      for (int lane = 0; lane < lane_width; ++lane) {
        if (!(m->lanes >> lane & 1)) continue;
        const int e = m->block * lane_width + lane;
        records.push_back(
            read_point(body.points, (body.points.block_start[m->block] + m->slot) * lane_width + lane, e));
        remove_point(body.points, m->block, m->slot, lane);
        sources.push_back(e);
      }
    }
  }
  const bool wet = body.water.is_wet() && !o.darcy;
  std::vector<Traveller<D>> travellers;
  const std::size_t lost_before = body.lost.size();
  std::vector<double> lost_water;
  for (Record<D>& r : records) {
    const int from = r.element;
    if (!find_new_element<D>(body.mesh(), r.element, r.xi())) {
      record_loss(body, r, lost_water);
      continue;
    }
    travellers.push_back({r, read_strain(body, from), body.points.strain_offset[r.id]});
  }
  const bool changes = !records.empty() || (wet && !body.water.newly_full.empty());
  if (!join_losses(body, lost_before, std::move(lost_water), changes)) return;
  std::vector<Record<D>> staying;
  for (const Traveller<D>& t : exchange_points(body, std::move(travellers))) {
    migrate_point(body, t);
    staying.push_back(t.record);
  }
  if (wet) {
    insert_wet_points(body, o, staying, sources);
  } else if (o.mixed) {
    insert_with_mixed_forces(body, o, staying, sources);
  } else {
    for (const Record<D>& r : staying) {
      wake_block(body, r.element / lane_width);
      insert_point(body.points, r);
      add_point_mass(body, r.element, weigh(body, r).fields);
      add_point_force(body, r);
    }
  }
  for (const Record<D>& r : staying) sources.push_back(r.element);
  for (int e : sources) {
    note_gaps(body, o, e);
    if (body.points.count[e] == 0) body.elements.plastic_dilation[e] = body.elements.rough[e] = 0;
  }
}

template void relocate<2>(Body<2>&, const StepOptions<2>&, const MoverLists&);
template void relocate<3>(Body<3>&, const StepOptions<3>&, const MoverLists&);

}  // namespace talus::mpm
