// SPDX-License-Identifier: MIT
// Partition of a body over ranks: halos of a rank, scatter of chunks from rank 0, and gather of the whole body.
#include "mpm/state/partition.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "mpm/state/body.hpp"
#include "mpm/state/slots.hpp"

namespace talus::mpm {

namespace {

template <int D>
std::shared_ptr<const Partition<D>> make_partition(const Body<D>& body, Ranks& ranks,
                                                   const std::vector<int>& chunk_of_rank) {
  const Layout<D>& layout = *body.layout;
  auto share = std::make_shared<Partition<D>>();
  share->ranks = &ranks;
  share->chunk_of_rank = chunk_of_rank;
  std::vector<int> rank_of_chunk;
  for (int r = 0; r < ranks.size(); ++r)
    for (int c = share->chunk_of_rank[r]; c < share->chunk_of_rank[r + 1]; ++c) rank_of_chunk.push_back(r);
  const int first = share->first_chunk(), last = share->last_chunk(), nodes = body.mesh().node_count();
  std::vector<Guest> rows;
  std::vector<std::uint8_t> touched(static_cast<std::size_t>(nodes), 0);  // nodes of these chunks
  std::vector<std::uint8_t> is_outer(static_cast<std::size_t>(layout.chunks), 0);
  for (int i = 0; i < nodes; ++i) {
    const auto begin = layout.node_rows.begin() + layout.row_start[i],
               end = layout.node_rows.begin() + layout.row_start[i + 1];
    const auto is_own = [&](int row) {
      const int c = find_interval(layout.chunk_row, row);
      return c >= first && c < last;
    };
    if (std::none_of(begin, end, is_own)) continue;
    touched[i] = 1;
    if (!std::all_of(begin, end, is_own))
      for (auto row = begin; row != end; ++row) is_outer[find_interval(layout.chunk_row, *row)] = 1;
    for (auto row = begin; row != end; ++row)
      if (!is_own(*row)) rows.push_back({*row, rank_of_chunk[find_interval(layout.chunk_row, *row)]});
    const int piece = find_interval(layout.node_start, i);
    if (piece >= first && piece < last) continue;
    if (!share->guests.empty() && share->guests.back()[1] == i)
      ++share->guests.back()[1];
    else
      share->guests.push_back({i, i + 1});
  }
  for (int c = first; c < last; ++c) (is_outer[c] ? share->outer : share->inner).push_back(c);
  std::vector<Guest> elements, near_nodes;
  std::vector<std::uint8_t> is_read(touched.size(), 0);  // nodes of elements that touch nodes of these chunks
  for (int e = 0; e < body.mesh().element_count(); ++e) {
    const auto& of_element = body.mesh().elements[e];
    const bool near = std::any_of(of_element.begin(), of_element.end(), [&](int i) { return touched[i] != 0; });
    share->is_near.push_back(near);
    if (!near) continue;
    for (const int i : of_element) is_read[i] = 1;
    const int chunk = find_interval(layout.chunk_start, e / lane_width);
    if (chunk < first || chunk >= last) elements.push_back({e, rank_of_chunk[chunk]});
  }
  for (int i = 0; i < nodes; ++i) {
    const int piece = find_interval(layout.node_start, i);
    if (is_read[i] && (piece < first || piece >= last)) near_nodes.push_back({i, rank_of_chunk[piece]});
  }
  share->rows = ranks.make_halo(layout.rows, rows);
  share->elements = ranks.make_halo(layout.blocks * lane_width, elements);
  share->nodes = ranks.make_halo(nodes, near_nodes);
  if (!body.softening_reach) return share;
  const SofteningReach& reach = *body.softening_reach;
  std::vector<std::uint8_t> is_reached(body.mesh().elements.size(), 0);
  const int begin = std::min(layout.chunk_start[first] * lane_width, body.mesh().element_count()),
            end = std::min(layout.chunk_start[last] * lane_width, body.mesh().element_count());
  for (std::int64_t k = reach.start[begin]; k < reach.start[end]; ++k) is_reached[reach.element[k]] = 1;
  std::vector<Guest> reached;
  for (int e = 0; e < body.mesh().element_count(); ++e)
    if (is_reached[e] && (e < begin || e >= end))
      reached.push_back({e, rank_of_chunk[find_interval(layout.chunk_start, e / lane_width)]});
  share->reach = ranks.make_halo(layout.blocks * lane_width, reached);
  return share;
}

/// Calls visit(array, first, count) for the part of each array of a body that these chunks own: by element, by row, by
/// node.
template <int D, class B, class Visit>
void visit_own(B& body, int first_chunk, int last_chunk, Visit&& visit) {
  const Layout<D>& layout = *body.layout;
  const auto by_block = [&](auto& array, int size) {
    if (array.empty()) return;
    const std::size_t width = static_cast<std::size_t>(size) * lane_width,
                      from = static_cast<std::size_t>(layout.chunk_start[first_chunk]) * width,
                      to = static_cast<std::size_t>(layout.chunk_start[last_chunk]) * width;
    visit(array.data() + from, to - from);
  };
  const auto by_row = [&](auto& array, int stride) {
    const std::size_t from = static_cast<std::size_t>(layout.chunk_row[first_chunk]),
                      to = static_cast<std::size_t>(layout.chunk_row[last_chunk]);
    visit(array.data() + from * static_cast<std::size_t>(stride), (to - from) * static_cast<std::size_t>(stride));
  };
  by_block(body.elements.moments, moment_size<D>);
  by_block(body.elements.strain, Points<D>::stress_size);
  for (auto* field :
       {&body.elements.fill_limit, &body.elements.apart, &body.elements.rough, &body.elements.plastic_dilation})
    by_block(*field, 1);
  for (auto* field : {&body.elements.softened, &body.elements.softening_volume, &body.elements.held_saturation})
    by_block(*field, 1);
  by_row(body.nodes.sums, sums_stride);
  by_row(body.nodes.motion, motion_stride<D>);
  const auto by_node = [&](auto& array) {
    if (array.empty()) return;
    const auto node = static_cast<std::size_t>(layout.node_start[first_chunk]),
               end = static_cast<std::size_t>(layout.node_start[last_chunk]);
    visit(array.data() + node, end - node);
  };
  by_node(body.nodes.displacement);
  if (body.water.is_wet()) {
    auto& water = body.water;
    by_block(water.moments, moment_size<D>);
    for (auto* field : {&water.volume, &water.stretch, &water.mean_saturation, &water.mean_pressure, &water.mean_bishop,
                        &water.mean_resistance, &water.surplus})
      by_block(*field, 1);
    by_row(water.sums, wet_sums_stride<D>);
    by_row(water.motion, wet_motion_stride<D>);
    for (auto* field : {&water.darcy.pressure, &water.darcy.change, &water.darcy.own}) by_node(*field);
    by_node(water.darcy.ponded);
  }
  const auto block = static_cast<std::size_t>(layout.chunk_start[first_chunk]),
             last = static_cast<std::size_t>(layout.chunk_start[last_chunk]);
  visit(body.points.block_materials.data() + block, last - block);
}

template <int D>
int first_element(const Layout<D>& layout, int chunk) {
  return std::min(layout.chunk_start[static_cast<std::size_t>(chunk)] * lane_width, layout.mesh.element_count());
}

/// Numbers of points of the elements [first, last).
template <int D>
std::vector<int> list_counts(const Points<D>& points, int first, int last) {
  std::vector<int> counts;
  for (int e = first; e < last; ++e) counts.push_back(static_cast<int>(points.count[static_cast<std::size_t>(e)]));
  return counts;
}

/// Writes number and fields of the points of the elements [first, last), element by element.
template <int D>
void put_points(const Points<D>& points, int first, int last, Message& message) {
  for (int e = first; e < last; ++e)
    for (int k = 0; k < static_cast<int>(points.count[static_cast<std::size_t>(e)]); ++k) {
      const Record<D> r = read_point(points, (points.block_start[e / lane_width] + k) * lane_width + e % lane_width, e);
      message.put(r.id);
      message.put(r.fields, static_cast<std::size_t>(points.fields));
      message.put(points.strain_offset[r.id]);
      message.put(points.reference[r.id]);
      message.put(points.material[r.id]);
    }
}

template <int D>
void get_points(Message& message, int first_element, const std::vector<int>& counts, Points<D>& points) {
  Record<D> r;
  for (std::size_t i = 0; i < counts.size(); ++i)
    for (int k = 0; k < counts[i]; ++k) {
      r.element = first_element + static_cast<int>(i);
      r.id = message.get<int>();
      message.get(r.fields, static_cast<std::size_t>(points.fields));
      message.get(&points.strain_offset[r.id], 1);
      message.get(&points.reference[r.id], 1);
      message.get(&points.material[r.id], 1);
      insert_point(points, r);
    }
}

/// Raises used[b] to the slots that block b needs for the given numbers of points of the elements from `first` on.
void count_slots(const std::vector<int>& counts, int first, std::vector<int>& used) {
  for (std::size_t i = 0; i < counts.size(); ++i) {
    int& most = used[(static_cast<std::size_t>(first) + i) / lane_width];
    most = std::max(most, counts[i]);
  }
}

/// Writes the nonlocal neighbours and weights of the elements [first, last).
void put_reach(const SofteningReach& reach, int first, int last, Message& message) {
  const std::int64_t begin = reach.start[static_cast<std::size_t>(first)],
                     end = reach.start[static_cast<std::size_t>(last)];
  for (int e = first; e < last; ++e)
    message.put(reach.start[static_cast<std::size_t>(e) + 1] - reach.start[static_cast<std::size_t>(e)]);
  Putting{message}(std::vector<int>(reach.element.begin() + begin, reach.element.begin() + end),
                   std::vector<double>(reach.weight.begin() + begin, reach.weight.begin() + end));
}
std::shared_ptr<const SofteningReach> get_reach(Message& message, int first, int last, int elements) {
  auto reach = std::make_shared<SofteningReach>();
  reach->start.assign(static_cast<std::size_t>(elements) + 1, 0);
  for (int e = 0; e < elements; ++e) {
    const auto count = e >= first && e < last ? message.get<std::int64_t>() : 0;
    reach->start[static_cast<std::size_t>(e) + 1] = reach->start[static_cast<std::size_t>(e)] + count;
  }
  Taking{message}(reach->element, reach->weight);
  return reach;
}

/// Writes the fields and points of a chunk.
template <int D>
void put_chunk(const Body<D>& body, int c, Message& message) {
  put_points(body.points, first_element(*body.layout, c), first_element(*body.layout, c + 1), message);
  visit_own<D>(body, c, c + 1, [&](const auto* values, std::size_t count) { message.put(values, count); });
}
/// Reads them into a body with slots for `counts` points in its elements.
template <int D>
void get_chunk(Message& message, int c, const std::vector<int>& counts, Body<D>& body) {
  const int first = first_element(*body.layout, c), last = first_element(*body.layout, c + 1);
  get_points(message, first, {counts.begin() + first, counts.begin() + last}, body.points);
  visit_own<D>(body, c, c + 1, [&](auto* values, std::size_t count) { message.get(values, count); });
}

/// Scatters one message to each rank; rank 0 makes them with make(rank).
Bytes deal_one_each(Ranks& ranks, const std::function<Bytes(int)>& make) {
  Bytes mine;
  ranks.scatter(
      {ranks.size(), [](int rank) { return rank; }, make, [&](int, Bytes bytes) { mine = std::move(bytes); }});
  return mine;
}

/// Scatter: fills the chunks of this rank from the whole body of rank 0.
template <int D>
void take_chunks(const Body<D>* whole, Ranks& ranks, const std::vector<int>& chunk_of_rank, Body<D>& body) {
  const Layout<D>& layout = *body.layout;
  const auto find_elements = [&](int rank) {
    return std::array{first_element(layout, chunk_of_rank[static_cast<std::size_t>(rank)]),
                      first_element(layout, chunk_of_rank[static_cast<std::size_t>(rank) + 1])};
  };
  const auto [first, last] = find_elements(ranks.rank());
  Message result(deal_one_each(ranks, [&](int r) {
    const auto [begin, end] = find_elements(r);
    Message message;
    message.put_list(list_counts(whole->points, begin, end));
    if (whole->softening_reach) put_reach(*whole->softening_reach, begin, end, message);
    return message.take();
  }));
  const std::vector<int> own = result.get_list<int>();
  if (!body.elements.nonlocal_correction.empty())
    body.softening_reach = get_reach(result, first, last, layout.mesh.element_count());
  std::vector<int> used(static_cast<std::size_t>(layout.blocks), 0);
  count_slots(own, first, used);
  allocate_slots(body.points, used);
  std::vector<int> counts(static_cast<std::size_t>(layout.mesh.element_count()), 0);
  std::copy(own.begin(), own.end(), counts.begin() + first);
  ranks.scatter({layout.chunks, [&](int c) { return find_interval(chunk_of_rank, c); },
                 [&](int c) {
                   Message message;
                   put_chunk(*whole, c, message);
                   return message.take();
                 },
                 [&](int c, Bytes bytes) {
                   Message message(std::move(bytes));
                   get_chunk(message, c, counts, body);
                 }});
}

/// Halo exchange of the elements and nodes around those of this rank.
template <int D>
void update_surroundings(Body<D>& body) {
  update_counts(body);
  Elements<D>& e = body.elements;
  update_elements(body, e.fill_limit, e.apart, e.rough, e.plastic_dilation);
  if (!e.held_saturation.empty()) update_elements(body, e.held_saturation);
  update_nodes(body, body.nodes.displacement);
  Water<D>& w = body.water;
  if (!w.is_wet()) return;
  update_elements(body, w.volume, w.stretch, w.mean_saturation, w.mean_pressure, w.mean_bishop, w.mean_resistance,
                  w.surplus);
  for (auto* field : {&w.darcy.pressure, &w.darcy.change, &w.darcy.own})
    if (!field->empty()) update_nodes(body, *field);
}

/// Copies the totals of the water, which every rank has, and allocates the arrays of which each rank has a part.
template <int D>
void copy_totals(const Water<D>& share, Water<D>& whole) {
  whole.budgets = share.budgets;
  whole.transpired = share.transpired;
  whole.lost_between = share.lost_between;
  whole.left_grid = share.left_grid;
  whole.pressed_in = share.pressed_in;
  whole.axes = share.axes;
  whole.axes_of_node = share.axes_of_node;
  whole.darcy.is_used = share.darcy.is_used;
  whole.darcy.graph = share.darcy.graph;
  whole.surface_is_stale = true;
  whole.darcy.pressure.resize(share.darcy.pressure.size());
  whole.darcy.change.resize(share.darcy.change.size());
  whole.darcy.own.resize(share.darcy.own.size());
  whole.darcy.ponded.resize(share.darcy.ponded.size());
}

}  // namespace

template <int D>
std::vector<double> count_work(const Body<D>& body) {
  constexpr double of_element = 0.1;
  const Layout<D>& layout = *body.layout;
  std::vector<double> work(static_cast<std::size_t>(layout.chunks), 0.0);
  const auto [first, last] = own_chunks(body);
  for (int c = first; c < last; ++c)
    for (int e = layout.chunk_start[c] * lane_width; e < layout.chunk_start[c + 1] * lane_width; ++e)
      work[static_cast<std::size_t>(c)] += of_element + body.points.count[static_cast<std::size_t>(e)];
  return work;
}

std::vector<int> divide_chunks(const std::vector<double>& work, int ranks) {
  std::vector<double> before{0};
  for (const double w : work) before.push_back(before.back() + w);
  std::vector<int> start;
  for (int r = 0; r <= ranks; ++r) {
    const double wanted = before.back() * r / ranks;
    const auto nearest = std::min_element(
        before.begin(), before.end(), [&](double a, double b) { return std::abs(a - wanted) < std::abs(b - wanted); });
    start.push_back(static_cast<int>(nearest - before.begin()));
  }
  start.back() = static_cast<int>(work.size());
  return start;
}

template <int D>
Body<D> scatter_body(const Body<D>* whole, Body<D> description, Ranks& ranks, const std::vector<int>& chunk_of_rank) {
  Body<D> body = std::move(description);
  if (!body.layout->is_ordered)
    fail_input("the nodes of the mesh are not in the order of its elements, which several ranks need: run it on one");
  take_chunks(whole, ranks, chunk_of_rank, body);
  body.partition = make_partition(body, ranks, chunk_of_rank);
  update_surroundings(body);
  body.water.surface_is_stale = true;
  gather_loads(body);
  return body;
}

/// Copies what all ranks have of a body: everything except its fields.
template <int D>
void copy_common(const Body<D>& share, Body<D>& whole) {
  if (share.water.is_wet()) copy_totals(share.water, whole.water);
  whole.lost = share.lost;
  whole.work = share.work;
  whole.monitor = share.monitor;
  whole.timing = share.timing;
  whole.time = share.time;
  whole.step_count = share.step_count;
  whole.nodes.motion_step = share.nodes.motion_step;
}

template <int D>
void collect(const Body<D>& share, bool to_all, Body<D>* whole) {
  Ranks& ranks = *share.partition->ranks;
  const std::vector<int>& chunks = share.partition->chunk_of_rank;
  const auto [first, last] = own_elements(share);
  Message mine;
  mine.put_list(list_counts(share.points, first, last));
  std::vector<int> counts;
  for (Bytes& bytes : ranks.gather(mine.take(), to_all))
    for (const int n : Message(std::move(bytes)).get_list<int>()) counts.push_back(n);
  if (!counts.empty()) {  // gathers the whole body on this rank
    copy_common(share, *whole);
    std::vector<int> used(static_cast<std::size_t>(whole->layout->blocks), 0);
    count_slots(counts, 0, used);
    allocate_slots(whole->points, used);
    std::fill(whole->points.element.begin(), whole->points.element.end(), -1);
    std::fill(whole->points.place.begin(), whole->points.place.end(), -1);
  }
  const auto make = [&](int c) {
    Message message;
    put_chunk(share, c, message);
    return message.take();
  };
  const auto take = [&](int c, Bytes bytes) {
    Message message(std::move(bytes));
    get_chunk(message, c, counts, *whole);
  };
  if (!to_all)
    return ranks.collect({share.layout->chunks, [&](int c) { return find_interval(chunks, c); }, make, take});
  const auto [from, to] = own_chunks(share);
  for (int c = from; c < to; ++c) put_chunk(share, c, mine);
  std::vector<Bytes> all = ranks.gather(mine.take(), true);
  for (std::size_t r = 0; r < all.size(); ++r) {
    Message message(std::move(all[r]));
    for (int c = chunks[r]; c < chunks[r + 1]; ++c) get_chunk(message, c, counts, *whole);
  }
}

#define TALUS_INSTANTIATE(D)                                                                  \
  template std::vector<double> count_work<D>(const Body<D>&);                                 \
  template Body<D> scatter_body<D>(const Body<D>*, Body<D>, Ranks&, const std::vector<int>&); \
  template void collect<D>(const Body<D>&, bool, Body<D>*);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

}  // namespace talus::mpm
