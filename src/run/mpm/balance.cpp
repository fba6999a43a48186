// SPDX-License-Identifier: MIT
#include "run/mpm/balance.hpp"

#include <algorithm>
#include <chrono>
#include <numeric>

#include "mpm/body/description.hpp"
#include "mpm/body/share.hpp"

namespace talus::run {
namespace {

constexpr int period = 8;              ///< looks that are measured together
constexpr double least_saving = 0.15;  ///< of the time of the slowest rank
constexpr double worth = 10;           ///< periods in which a hand-over must pay

double sum(const mpm::Timing& t) {
  return t.solve_momentum + t.remap_momentum + t.smooth_strain + t.advance_points + t.relocate;
}

/// The chunks of rank `r` of a list by chunk: [begin, end).
auto find_part(std::vector<double>& by_chunk, const std::vector<int>& chunk_of_rank, std::size_t r) {
  return std::pair{by_chunk.begin() + chunk_of_rank[r], by_chunk.begin() + chunk_of_rank[r + 1]};
}

/// The seconds of the rank that has most to do.
double find_longest(std::vector<double>& seconds, const std::vector<int>& chunk_of_rank) {
  double longest = 0;
  for (std::size_t r = 0; r + 1 < chunk_of_rank.size(); ++r) {
    const auto [begin, end] = find_part(seconds, chunk_of_rank, r);
    longest = std::max(longest, std::accumulate(begin, end, 0.0));
  }
  return longest;
}

/// What each chunk costs in a period [s], from its points and the time that its rank took for all of its own.
template <int D>
std::vector<double> measure_chunks(const mpm::Body<D>& share, double mine) {
  std::vector<double> work = mpm::count_work(share);
  mpm::complete_chunks(share, work);
  const std::vector<double> seconds = mpm::join_lists(share, std::vector{mine});
  for (std::size_t r = 0; r < seconds.size(); ++r) {
    const auto [begin, end] = find_part(work, share.share->chunk_of_rank, r);
    const double points = std::accumulate(begin, end, 0.0);
    std::for_each(begin, end, [&](double& w) { w *= seconds[r] / points; });
  }
  return work;
}

}  // namespace

template <int D>
LoadBalance<D>::LoadBalance(mpm::Body<D>* whole, const mpm::Body<D>& share)
    : whole_(get_ranks().rank() == 0 ? whole : nullptr),
      spent_(sum(share.timing)),
      sent_(get_ranks().traffic().seconds) {}

template <int D>
void LoadBalance<D>::leave_out(const std::function<void()>& work) {
  const double before = get_ranks().traffic().seconds;
  work();
  sent_ += get_ranks().traffic().seconds - before;
}

template <int D>
void LoadBalance<D>::look(mpm::Body<D>& share) {
  if (++looks_ % period != 0) return;
  Ranks& ranks = get_ranks();
  const double spent = sum(share.timing), sent = ranks.traffic().seconds;
  const double mine = std::max(0.0, spent - spent_ - (sent - sent_));
  spent_ = spent;
  sent_ = sent;
  std::vector<double> seconds = measure_chunks(share, mine);
  const std::vector<int>& now = share.share->chunk_of_rank;
  const std::vector<int> wanted = mpm::divide_chunks(seconds, ranks.size());
  const double longest = find_longest(seconds, now), saving = longest - find_longest(seconds, wanted);
  if (wanted == now || !(saving > least_saving * longest) || saving * worth < cost_) return;
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  mpm::collect(share, false, whole_);
  mpm::Body<D> description = mpm::copy_description(share);
  share = mpm::Body<D>();  // its memory, before there is another
  share = mpm::take_share<D>(whole_, std::move(description), ranks, wanted);
  cost_ = std::chrono::duration<double>(Clock::now() - start).count();
  broadcast(cost_);  // all must come to the same decision
  ++ranks.traffic().hand_overs;
  spent_ = sum(share.timing);
  sent_ = ranks.traffic().seconds;
}

template class LoadBalance<2>;
template class LoadBalance<3>;

}  // namespace talus::run
