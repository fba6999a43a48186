// SPDX-License-Identifier: MIT
// Slots of the points: removal, insertion, growth of blocks and packing.
#include "mpm/state/slots.hpp"

#include <algorithm>

namespace talus::mpm {
namespace {

template <int D>
void extend(Points<D>& points, std::int64_t slots) {
  points.data.resize(static_cast<std::size_t>(slots * points.fields * lane_width), 0.0);
  points.id.resize(static_cast<std::size_t>(slots * lane_width), -1);
}

template <int D>
std::int64_t slot_count(const Points<D>& points) {
  return static_cast<std::int64_t>(points.id.size()) / lane_width;
}

/// Copies the used slots of a block to `target` and updates the places of their points.
template <int D>
void copy_block(Points<D>& points, int b, AlignedVector<double>& data, std::vector<int>& id, std::int64_t target) {
  const std::int64_t source = points.block_start[b], used = points.block_used[b];
  const std::int64_t size = points.fields * lane_width;
  std::copy_n(points.data.begin() + source * size, used * size, data.begin() + target * size);
  std::copy_n(points.id.begin() + source * lane_width, used * lane_width, id.begin() + target * lane_width);
  for (std::int64_t i = 0; i < used * lane_width; ++i) {
    const int p = id[static_cast<std::size_t>(target * lane_width + i)];
    if (p >= 0) points.place[p] = target * lane_width + i;
  }
}

template <int D>
void pack_blocks(Points<D>& points) {
  const int blocks = static_cast<int>(points.block_start.size());
  Points<D> packed;
  packed.fields = points.fields;
  std::vector<std::int64_t> start(static_cast<std::size_t>(blocks));
  std::vector<int> capacity(static_cast<std::size_t>(blocks));
  std::int64_t total = 0;
  for (int b = 0; b < blocks; ++b) {
    start[b] = total;
    capacity[b] = points.block_used[b] == 0 ? 0 : points.block_used[b] + 1;
    total += capacity[b];
  }
  extend(packed, total);
  for (int b = 0; b < blocks; ++b) copy_block(points, b, packed.data, packed.id, start[b]);
  points.data = std::move(packed.data);
  points.id = std::move(packed.id);
  points.block_start = std::move(start);
  points.block_capacity = std::move(capacity);
}

template <int D>
void grow_block(Points<D>& points, int b) {
  std::int64_t owned = 0;
  for (int c : points.block_capacity) owned += c;
  if (slot_count(points) > owned + owned / 8 + 64) pack_blocks(points);
  const std::int64_t target = slot_count(points);
  const int capacity = points.block_used[b] + 2;
  extend(points, target + capacity);
  copy_block(points, b, points.data, points.id, target);
  for (std::int64_t i = 0; i < static_cast<std::int64_t>(points.block_used[b]) * lane_width; ++i) {
    points.id[static_cast<std::size_t>(points.block_start[b] * lane_width + i)] = -1;
  }
  points.block_start[b] = target;
  points.block_capacity[b] = capacity;
}

}  // namespace

template <int D>
void allocate_slots(Points<D>& points, const std::vector<int>& used) {
  const std::size_t blocks = used.size();
  points.block_start.assign(blocks, 0);
  points.block_capacity.assign(blocks, 0);
  points.block_used.assign(blocks, 0);
  points.block_materials.assign(blocks, 0);
  points.count.assign(blocks * lane_width, 0.0);
  std::int64_t total = 0;
  for (std::size_t b = 0; b < blocks; ++b) {
    points.block_start[b] = total;
    points.block_capacity[b] = used[b] == 0 ? 0 : used[b] + 1;
    total += points.block_capacity[b];
  }
  points.data.clear();
  points.id.clear();
  extend(points, total);
}

template <int D>
Record<D> read_point(const Points<D>& points, std::int64_t place, int e) {
  Record<D> r;
  r.id = points.id[static_cast<std::size_t>(place)];
  r.element = e;
  const double* p = points.slot(place / lane_width) + place % lane_width;
  for (int i = 0; i < points.fields; ++i) r.fields[i] = p[i * lane_width];
  return r;
}

template <int D>
void remove_point(Points<D>& points, int b, int k, int lane) {
  const std::size_t e = static_cast<std::size_t>(b) * lane_width + static_cast<std::size_t>(lane);
  const int last = static_cast<int>(points.count[e]) - 1;
  const std::int64_t hole = (points.block_start[b] + k) * lane_width + lane;
  const std::int64_t end = (points.block_start[b] + last) * lane_width + lane;
  if (last != k) {
    double* to = points.slot(hole / lane_width) + lane;
    const double* from = points.slot(end / lane_width) + lane;
    for (int i = 0; i < points.fields; ++i) to[i * lane_width] = from[i * lane_width];
    points.id[static_cast<std::size_t>(hole)] = points.id[static_cast<std::size_t>(end)];
    points.place[points.id[static_cast<std::size_t>(hole)]] = hole;
  }
  points.id[static_cast<std::size_t>(end)] = -1;
  points.count[e] = last;
  if (last == points.block_used[b] - 1) {
    const double* counts = &points.count[static_cast<std::size_t>(b) * lane_width];
    points.block_used[b] = static_cast<int>(*std::max_element(counts, counts + lane_width));
  }
}

template <int D>
void insert_point(Points<D>& points, const Record<D>& r) {
  const int b = r.element / lane_width, lane = r.element % lane_width;
  const int k = static_cast<int>(points.count[r.element]);
  if (k >= points.block_capacity[b]) grow_block(points, b);
  const std::int64_t place = (points.block_start[b] + k) * lane_width + lane;
  double* p = points.slot(place / lane_width) + lane;
  for (int i = 0; i < points.fields; ++i) p[i * lane_width] = r.fields[i];
  points.id[static_cast<std::size_t>(place)] = r.id;
  points.count[r.element] = k + 1;
  points.block_used[b] = std::max(points.block_used[b], k + 1);
  points.block_materials[b] |= 1u << points.material[r.id];
  points.element[r.id] = r.element;
  points.place[r.id] = place;
}

template void allocate_slots<2>(Points<2>&, const std::vector<int>&);
template void allocate_slots<3>(Points<3>&, const std::vector<int>&);
template Record<2> read_point<2>(const Points<2>&, std::int64_t, int);
template Record<3> read_point<3>(const Points<3>&, std::int64_t, int);
template void remove_point<2>(Points<2>&, int, int, int);
template void remove_point<3>(Points<3>&, int, int, int);
template void insert_point<2>(Points<2>&, const Record<2>&);
template void insert_point<3>(Points<3>&, const Record<3>&);

}  // namespace talus::mpm
