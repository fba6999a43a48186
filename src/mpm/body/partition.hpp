// SPDX-License-Identifier: MIT
#pragma once
// One rank's share of a body: consecutive chunks, with the points in their elements. A shared body has the layout and
// the numbers of the whole one, and is filled where its rank works, which alone takes memory (base/aligned.hpp): its
// chunks, and of the nodes between chunks also the rows of other ranks. As chunks are what is summed up, and in their
// order, all numbers are those of a single process.

#include <algorithm>
#include <array>
#include <memory>

#include "base/parallel.hpp"
#include "base/ranks.hpp"
#include "mpm/body/body.hpp"

namespace talus::mpm {

template <int D>
struct Share {
  Ranks* ranks = nullptr;
  std::vector<int> chunk_of_rank;          ///< first chunk of each rank, [ranks + 1]
  std::vector<std::array<int, 2>> guests;  ///< ranges of nodes that touch these chunks, and are summed up by others
  std::unique_ptr<Halo> rows;              ///< of nodes between ranks
  std::unique_ptr<Halo> elements;          ///< of other ranks that touch a node of these chunks
  std::unique_ptr<Halo> nodes;             ///< of these elements that other ranks sum up
  std::unique_ptr<Halo> reach;             ///< elements that these soften with; null without a length
  std::vector<int> outer, inner;           ///< own chunks with rows that other ranks need, and without
  std::vector<std::uint8_t> is_near;       ///< by element: it touches a node of these chunks

  int first_chunk() const { return chunk_of_rank[static_cast<std::size_t>(ranks->rank())]; }
  int last_chunk() const { return chunk_of_rank[static_cast<std::size_t>(ranks->rank()) + 1]; }
};

/// The chunks [first, last) that are worked on here.
template <int D>
std::array<int, 2> own_chunks(const Body<D>& body) {
  if (!body.share) return {0, body.layout->chunks};
  return {body.share->first_chunk(), body.share->last_chunk()};
}

/// Which of the intervals that begin at `starts` an item is in.
inline int find_interval(const std::vector<int>& starts, int item) {
  return static_cast<int>(std::upper_bound(starts.begin(), starts.end(), item) - starts.begin()) - 1;
}

/// The elements [first, last) of these chunks.
template <int D>
std::array<int, 2> own_elements(const Body<D>& body) {
  const auto [first, last] = own_chunks(body);
  const auto& start = body.layout->chunk_start;
  const int count = body.mesh().element_count();
  const auto element = [&](int c) { return std::min(start[static_cast<std::size_t>(c)] * lane_width, count); };
  return {element(first), element(last)};
}

/// Calls work(c) for the chunks that are worked on here.
template <int D, class Work>
void for_chunks(const Body<D>& body, int threads, Work&& work) {
  const auto [first, last] = own_chunks(body);
  parallel_for(last - first, threads, [&, begin = first](int i) { work(begin + i); });
}

/// First node of piece `c`: the nodes whose first row belongs to that chunk.
template <int D>
int first_node(const Body<D>& body, int c) {
  return body.layout->node_start[static_cast<std::size_t>(c)];
}

/// Calls work(begin, end, c) for the pieces of the nodes that are worked on here; c is -1 for nodes of other ranks'
/// pieces, whose sums are counted there.
template <int D, class Work>
void for_node_pieces(const Body<D>& body, int threads, Work&& work) {
  const auto [first, last] = own_chunks(body);
  const int own = last - first, guests = body.share ? static_cast<int>(body.share->guests.size()) : 0;
  parallel_for(own + guests, threads, [&, begin = first](int i) {
    if (i < own)
      work(first_node(body, begin + i), first_node(body, begin + i + 1), begin + i);
    else
      work(body.share->guests[static_cast<std::size_t>(i - own)][0],
           body.share->guests[static_cast<std::size_t>(i - own)][1], -1);
  });
}

namespace detail {

// Compiled once, however many loops call it: a copy that is inlined elsewhere may be contracted to other fused
// operations.
template <class Work, class... Arguments>
[[gnu::noinline]] void work_on(const Work& work, Arguments... arguments) {
  work(arguments...);
}

}  // namespace detail

/// Calls work(c) for the chunks that are worked on here, which fill `rows`; then rows of other ranks are up to date.
/// They travel while chunks that no other rank touches are worked on.
template <int D, class Work>
void for_chunks_and_update(const Body<D>& body, int threads, AlignedVector<double>& rows, int stride,
                           const Work& work) {
  if (!body.share) return for_chunks(body, threads, [&](int c) { detail::work_on(work, c); });
  const Share<D>& share = *body.share;
  const auto run = [&](const std::vector<int>& chunks) {
    parallel_for(static_cast<int>(chunks.size()), threads,
                 [&](int i) { detail::work_on(work, chunks[static_cast<std::size_t>(i)]); });
  };
  run(share.outer);
  share.rows->begin({{rows.data(), stride}});
  run(share.inner);
  share.rows->end();
}

/// The same as for_node_pieces() with rows of other ranks up to date: they travel while nodes are worked on that need
/// none.
template <int D, class Work>
void update_and_for_node_pieces(const Body<D>& body, int threads, AlignedVector<double>& rows, int stride,
                                const Work& work) {
  if (!body.share)
    return for_node_pieces(body, threads, [&](int begin, int end, int c) { detail::work_on(work, begin, end, c); });
  const Share<D>& share = *body.share;
  const auto run = [&](const std::vector<int>& chunks, int i) {
    const int c = chunks[static_cast<std::size_t>(i)];
    detail::work_on(work, first_node(body, c), first_node(body, c + 1), c);
  };
  const int inner = static_cast<int>(share.inner.size()), outer = static_cast<int>(share.outer.size()),
            guests = static_cast<int>(share.guests.size());
  share.rows->begin({{rows.data(), stride}});
  parallel_for(inner, threads, [&](int i) { run(share.inner, i); });
  share.rows->end();
  parallel_for(outer + guests, threads, [&](int i) {
    if (i < outer) return run(share.outer, i);
    const auto& range = share.guests[static_cast<std::size_t>(i - outer)];
    detail::work_on(work, range[0], range[1], -1);
  });
}

/// An array by node or by element as the functions below take it, of numbers or of vectors.
template <class Array>
HaloArray as_halo(Array& array) {
  using Item = typename Array::value_type;
  if constexpr (std::is_same_v<Item, double>)
    return {array.data(), 1};
  else
    return {array.empty() ? nullptr : array.front().data(), sizeof(Item) / sizeof(double)};
}

/// What other ranks have found for the elements that touch a node here, in arrays by element.
template <int D, class... Arrays>
void update_elements(const Body<D>& body, Arrays&... arrays) {
  if (body.share) body.share->elements->update({as_halo(arrays)...});
}
/// What they have found for the nodes of these elements, in arrays by node. With these two a loop over elements may
/// read all nodes of its elements, and one over nodes all elements round them with their nodes.
template <int D, class... Arrays>
void update_nodes(const Body<D>& body, Arrays&... arrays) {
  if (body.share) body.share->nodes->update({as_halo(arrays)...});
}

/// Numbers of points in the elements of other ranks beside those here.
template <int D>
void update_counts(Body<D>& body) {
  update_elements(body, body.points.count);
}

/// What other ranks have of a list with `per` items for every chunk.
template <int D, class T>
void complete_chunks(const Body<D>& body, std::vector<T>& by_chunk, std::size_t per = 1) {
  if (!body.share) return;
  const auto [first, last] = own_chunks(body);
  Message mine;
  mine.put(by_chunk.data() + static_cast<std::size_t>(first) * per, static_cast<std::size_t>(last - first) * per);
  std::size_t at = 0;
  for (Bytes& bytes : body.share->ranks->gather(mine.bytes(), true)) {
    const std::size_t count = bytes.size() / sizeof(T);
    Message(std::move(bytes)).get(by_chunk.data() + at, count);
    at += count;
  }
}

/// A list that every rank has a part of, in the order of the ranks.
template <int D, class T>
std::vector<T> join_lists(const Body<D>& body, std::vector<T> mine) {
  if (!body.share) return mine;
  Message message;
  message.put_list(mine);
  std::vector<T> all;
  for (Bytes& bytes : body.share->ranks->gather(message.bytes(), true)) {
    const std::vector<T> part = Message(std::move(bytes)).get_list<T>();
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

/// Whether it is so on any rank.
template <int D>
bool is_any(const Body<D>& body, bool here) {
  if (!body.share) return here;
  const std::vector<char> all = join_lists(body, std::vector<char>{here ? '\1' : '\0'});
  return std::any_of(all.begin(), all.end(), [](char c) { return c != 0; });
}

/// What a step has to do in each chunk, in points: those of this rank's chunks, and an element costs a little.
template <int D>
std::vector<double> count_work(const Body<D>& body);

/// First chunk of each of so many ranks, [ranks + 1], such that each has about as much of `work`, by chunk.
std::vector<int> divide_chunks(const std::vector<double>& work, int ranks);

/// The share of this rank, of a body that rank 0 has as a whole (elsewhere null); chunk_of_rank as of divide_chunks().
/// Throws Error (wrong_input) for a mesh whose nodes are not in the order of their elements.
template <int D>
Body<D> take_share(const Body<D>* whole, Body<D> description, Ranks& ranks, const std::vector<int>& chunk_of_rank);

/// Puts the whole body together again, in what the shares were taken of: on rank 0 (elsewhere null), or on all ranks.
template <int D>
void collect(const Body<D>& share, bool to_all, Body<D>* whole);

}  // namespace talus::mpm
