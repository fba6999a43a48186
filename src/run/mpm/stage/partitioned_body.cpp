// SPDX-License-Identifier: MIT
#include "run/mpm/stage/partitioned_body.hpp"

#include <algorithm>
#include <chrono>
#include <numeric>

#include "base/ranks.hpp"
#include "mpm/solver/build.hpp"
#include "mpm/state/body.hpp"
#include "mpm/state/partition.hpp"

namespace talus::run {

namespace {

constexpr int period = 8;  ///< looks per measurement
constexpr double least_saving =
    0.15;  ///< least saving that justifies a rebalance, as a fraction of the time of the slowest rank
constexpr double worth = 10;  ///< periods within which a rebalance must pay off

double sum(const mpm::Timing& t) {
  return t.solve_momentum + t.remap_momentum + t.smooth_strain + t.advance_points + t.relocate;
}

/// The range [begin, end) of the chunks of rank `r` in a list by chunk.
auto find_part(std::vector<double>& by_chunk, const std::vector<int>& chunk_of_rank, std::size_t r) {
  return std::pair{by_chunk.begin() + chunk_of_rank[r], by_chunk.begin() + chunk_of_rank[r + 1]};
}

/// Returns the time of the slowest rank [s].
double find_longest(std::vector<double>& seconds, const std::vector<int>& chunk_of_rank) {
  double longest = 0;
  for (std::size_t r = 0; r + 1 < chunk_of_rank.size(); ++r) {
    const auto [begin, end] = find_part(seconds, chunk_of_rank, r);
    longest = std::max(longest, std::accumulate(begin, end, 0.0));
  }
  return longest;
}

/// Returns the cost of each chunk in a period [s]: the time of its rank, distributed in proportion to the points.
template <int D>
std::vector<double> measure_chunks(const mpm::Body<D>& part, double mine) {
  std::vector<double> work = mpm::count_work(part);
  mpm::complete_chunks(part, work);
  const std::vector<double> seconds = mpm::join_lists(part, std::vector{mine});
  for (std::size_t r = 0; r < seconds.size(); ++r) {
    const auto [begin, end] = find_part(work, part.partition->chunk_of_rank, r);
    const double points = std::accumulate(begin, end, 0.0);
    std::for_each(begin, end, [&](double& w) { w *= seconds[r] / points; });
  }
  return work;
}

}  // namespace

template <int D>
double find_largest(const mpm::Body<D>& body, double here) {
  const std::vector<double> all = mpm::join_lists(body, std::vector{here});
  return *std::max_element(all.begin(), all.end());
}

template <int D>
PartitionedBody<D>::PartitionedBody(mpm::Body<D>* whole, mpm::Body<D> description, bool all_have_it)
    : whole_(whole), all_have_it_(all_have_it) {
  Ranks& ranks = get_ranks();
  std::vector<int> chunks;
  if (ranks.rank() == 0) chunks = mpm::divide_chunks(mpm::count_work(*whole), ranks.size());
  broadcast(chunks);
  part_ = mpm::scatter_body<D>(whole, std::move(description), ranks, chunks);
  spent_ = sum(part_.timing);
  sent_ = ranks.traffic().seconds;
}

template <int D>
void PartitionedBody<D>::leave_out(const std::function<void()>& work) {
  const double before = get_ranks().traffic().seconds;
  work();
  sent_ += get_ranks().traffic().seconds - before;
}

template <int D>
void PartitionedBody<D>::rebalance() {
  if (++looks_ % period != 0) return;
  Ranks& ranks = get_ranks();
  const double spent = sum(part_.timing), sent = ranks.traffic().seconds;
  const double mine = std::max(0.0, spent - spent_ - (sent - sent_));
  spent_ = spent;
  sent_ = sent;
  std::vector<double> seconds = measure_chunks(part_, mine);
  const std::vector<int>& now = part_.partition->chunk_of_rank;
  const std::vector<int> wanted = mpm::divide_chunks(seconds, ranks.size());
  const double longest = find_longest(seconds, now), saving = longest - find_longest(seconds, wanted);
  if (wanted == now || !(saving > least_saving * longest) || saving * worth < cost_) return;
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  mpm::Body<D>* const whole = ranks.rank() == 0 ? whole_ : nullptr;
  mpm::collect(part_, false, whole);
  mpm::Body<D> description = mpm::copy_description(part_);
  part_ = mpm::Body<D>();  // frees the memory of the old part before the new one is made
  part_ = mpm::scatter_body<D>(whole, std::move(description), ranks, wanted);
  cost_ = std::chrono::duration<double>(Clock::now() - start).count();
  broadcast(cost_);  // all ranks must come to the same decision
  ++ranks.traffic().hand_overs;
  spent_ = sum(part_.timing);
  sent_ = ranks.traffic().seconds;
}

template <int D>
void PartitionedBody<D>::lead(const mpm::Body<D>& part, const std::function<void(const mpm::Body<D>&)>& work) {
  leave_out([&] {
    mpm::collect(part, false, get_ranks().rank() == 0 ? whole_ : nullptr);
    lead_ranks([&] { work(*whole_); });
  });
}

template <int D>
void PartitionedBody<D>::finish() {
  mpm::collect(part_, all_have_it_, whole_);
  if (whole_ != nullptr) mpm::gather_loads(*whole_);
}

template double find_largest<2>(const mpm::Body<2>&, double);
template double find_largest<3>(const mpm::Body<3>&, double);
template class PartitionedBody<2>;
template class PartitionedBody<3>;

}  // namespace talus::run
