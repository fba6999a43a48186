// SPDX-License-Identifier: MIT
#include "run/mpm/stage/ranks_stage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <numeric>

#include "base/error.hpp"
#include "base/hash.hpp"
#include "base/ranks.hpp"
#include "mpm/solver/build.hpp"
#include "mpm/state/loads.hpp"
#include "mpm/state/partition.hpp"
#include "run/mpm/start/prepare.hpp"

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
std::vector<double> measure_chunks(const mpm::Body<D>& share, double mine) {
  std::vector<double> work = mpm::count_work(share);
  mpm::complete_chunks(share, work);
  const std::vector<double> seconds = mpm::join_lists(share, std::vector{mine});
  for (std::size_t r = 0; r < seconds.size(); ++r) {
    const auto [begin, end] = find_part(work, share.partition->chunk_of_rank, r);
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
  const std::vector<int>& now = share.partition->chunk_of_rank;
  const std::vector<int> wanted = mpm::divide_chunks(seconds, ranks.size());
  const double longest = find_longest(seconds, now), saving = longest - find_longest(seconds, wanted);
  if (wanted == now || !(saving > least_saving * longest) || saving * worth < cost_) return;
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  mpm::collect(share, false, whole_);
  mpm::Body<D> description = mpm::copy_description(share);
  share = mpm::Body<D>();  // frees the memory of the old part before the new one is made
  share = mpm::scatter_body<D>(whole_, std::move(description), ranks, wanted);
  cost_ = std::chrono::duration<double>(Clock::now() - start).count();
  broadcast(cost_);  // all ranks must come to the same decision
  ++ranks.traffic().hand_overs;
  spent_ = sum(share.timing);
  sent_ = ranks.traffic().seconds;
}

template class LoadBalance<2>;
template class LoadBalance<3>;

}  // namespace talus::run

namespace talus {

template <class Visit>
void visit_members(Visit&& visit, Like<ShownUnit> auto& u) {
  visit(u.name, u.si);
}
template <class Visit>
void visit_members(Visit&& visit, Like<ShownUnits> auto& u) {
  visit(u.length, u.displacement, u.stress, u.stiffness, u.unit_weight, u.line_force, u.span);
}

}  // namespace talus

namespace talus::results {

template <class Visit>
void visit_members(Visit&& visit, Like<Retry> auto& s) {
  visit(s.time, s.back_to, s.courant, s.smoothing, s.reason);
}

}  // namespace talus::results

namespace talus::run {

template <class Visit>
void visit_members(Visit&& visit, Like<StageState> auto& s) {
  visit(s.started, s.start_time, s.steps, s.dt, s.gravity_share, s.calm_since, s.next_output);
  visit(s.largest_speed, s.wave_speed, s.soft_band, s.soft_size, s.setbacks);
}
template <class Visit, class P>
requires Like<P, StagePlan<2>> || Like<P, StagePlan<3>>
void visit_members(Visit&& visit, P& p) {
  visit(p.name, p.cohesion, p.strength_factor, p.duration, p.until_rest, p.step, p.rest, p.gravity, p.gravity_ramp);
  visit(p.soil_height, p.failed_displacement, p.equalises_mass, p.threads, p.units);
}

namespace {

template <class T>
void put_text(const T& values, std::string& text) {
  text.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(values[0]));
}

/// Throws Error if the bodies differ between ranks. Every rank has prepared the body by itself, and another program or
/// library would prepare another one.
template <int D>
void check_equal(const mpm::Body<D>& body) {
  std::string text;
  put_text(body.mesh().nodes, text);
  put_text(body.mesh().elements, text);
  put_text(body.points.element, text);
  put_text(body.points.data, text);
  const std::string hash = hash_text(text);
  const std::vector<Bytes> all = [&] {
    Message mine;
    mine.put(hash.data(), hash.size());
    return get_ranks().gather(mine.bytes(), true);
  }();
  for (std::size_t r = 1; r < all.size(); ++r)
    if (all[r] != all[0])
      throw Error(ExitCode::wrong_input,
                  fmt::format("rank {} has prepared another body than rank 0: the program, its libraries or the "
                              "processors of their machines differ",
                              r));
}

/// The hooks that rank 0 has. All ranks must take part in them.
struct Hooked {
  bool output = false, look = false, tell = false, save_last_good = false, mark = false;
};

/// A stage of a body that rank 0 alone or every rank (`all_have_it`) has as a whole; on the other ranks `whole` is
/// null.
template <int D>
class SharedStage {
 public:
  SharedStage(mpm::Body<D>* whole, const StageHooks<D>& hooks, const Hooked& hooked)
      : whole_(whole), hooks_(hooks), hooked_(hooked) {}

  results::StageEnd run(mpm::Body<D> description, bool all_have_it, const StagePlan<D>& plan, StageState& state) {
    Ranks& ranks = get_ranks();
    std::vector<int> chunks;
    if (ranks.rank() == 0) chunks = mpm::divide_chunks(mpm::count_work(*whole_), ranks.size());
    broadcast(chunks);
    mpm::Body<D> share = mpm::scatter_body<D>(whole_, std::move(description), ranks, chunks);
    LoadBalance<D> balance(whole_, share);
    balance_ = &balance;
    const results::StageEnd end = run_stage(share, plan, state, make_hooks());
    mpm::collect(share, all_have_it, whole_);
    if (whole_ != nullptr) mpm::gather_loads(*whole_);
    return end;
  }

 private:
  StageHooks<D> make_hooks() {
    StageHooks<D> shared;
    shared.rebalance = [this](mpm::Body<D>& share) { balance_->look(share); };
    if (hooked_.output)
      shared.output = [this](Pause<D>& now, StageState& s) {
        balance_->leave_out([&] {
          record(now.whole(), [&] {
            PauseHere<D> here(*whole_);
            hooks_.output(here, s);
          });
          for (double* result : {&s.next_output, &s.soft_band, &s.soft_size}) broadcast(*result);
        });
      };
    if (hooked_.look) {
      shared.look_is_due = [this] {
        bool due = !hooks_.look_is_due || hooks_.look_is_due();
        balance_->leave_out([&] { broadcast(due); });
        return due;
      };
      shared.look = [this](const mpm::Body<D>& share, const StageState& s) {
        balance_->leave_out([&] { record(share, [&] { hooks_.look(*whole_, s); }); });
      };
    }
    if (hooked_.tell) {
      shared.report_is_due = [this] {
        bool due = hooks_.report_is_due && hooks_.report_is_due();
        balance_->leave_out([&] { broadcast(due); });
        return due;
      };
      shared.report = [this](const mpm::Body<D>& share, const StageState& s, double moved) {
        if (hooks_.report) hooks_.report(share, s, moved);
      };
    }
    if (hooked_.save_last_good)
      shared.save_last_good = [this](const mpm::Body<D>& share, const StageState& s) {
        std::string saved;
        record(share, [&] { saved = hooks_.save_last_good(*whole_, s); });
        return saved;
      };
    if (hooked_.mark)
      shared.mark = [this]() -> GoBack<D> {
        GoBack<D> inner;
        lead_ranks([&] { inner = hooks_.mark(); });
        return [this, inner](const mpm::Body<D>& share, const StageState& s, const StagePlan<D>& p) {
          record(share, [&] { inner(*whole_, s, p); });
        };
      };
    return shared;
  }

  /// Gathers the whole body on rank 0 and calls `work` there.
  void record(const mpm::Body<D>& share, const std::function<void()>& work) {
    mpm::collect(share, false, get_ranks().rank() == 0 ? whole_ : nullptr);
    lead_ranks(work);
  }

  mpm::Body<D>* whole_;
  const StageHooks<D>& hooks_;
  const Hooked hooked_;
  LoadBalance<D>* balance_ = nullptr;
};

template <int D>
Hooked find_hooked(const StageHooks<D>& hooks) {
  return {static_cast<bool>(hooks.output), static_cast<bool>(hooks.look), static_cast<bool>(hooks.report),
          static_cast<bool>(hooks.save_last_good), static_cast<bool>(hooks.mark)};
}

enum class Request { stage, stage_on_another_mesh, leave };

}  // namespace

template <int D>
results::StageEnd run_on_ranks(mpm::Body<D>& body, const StagePlan<D>& plan, StageState& state,
                               const StageHooks<D>& hooks) {
  if (plan.helpers != nullptr) return plan.helpers->run(body, plan, state, hooks);
  check_equal(body);
  return SharedStage<D>(&body, hooks, find_hooked(hooks)).run(mpm::copy_description(body), true, plan, state);
}

template <int D>
results::StageEnd Helpers<D>::run(mpm::Body<D>& body, const StagePlan<D>& plan, StageState& state,
                                  const StageHooks<D>& hooks) {
  Request request = body.layout == layout_ ? Request::stage : Request::stage_on_another_mesh;
  broadcast(request);
  if (request == Request::stage_on_another_mesh) layout_ = mpm::broadcast_layout(body.layout);
  const Hooked hooked = find_hooked(hooks);
  Message message;
  mpm::put_description(body, message);
  Putting{message}(plan, state, hooked);
  Bytes bytes = message.take();
  get_ranks().broadcast(bytes);
  bytes = {};
  knows_failure_ = true;
  const results::StageEnd end =
      SharedStage<D>(&body, hooks, hooked).run(mpm::copy_description(body), false, plan, state);
  knows_failure_ = false;
  return end;
}

template <int D>
void Helpers<D>::dismiss(const Failure& failure) {
  if (knows_failure_) return;
  Request request = Request::leave;
  broadcast(request);
  lead_ranks([&] {
    if (failure.code != ExitCode::success) throw Error(failure.code, failure.sentence);
  });
}

template <int D>
void help_with_stages(const input::Case& data) {
  std::shared_ptr<const mpm::Layout<D>> layout;
  for (;;) {
    Request request{};
    broadcast(request);
    if (request == Request::leave) return lead_ranks([] {});
    if (request == Request::stage_on_another_mesh) layout = mpm::broadcast_layout<D>(nullptr);
    Bytes bytes;
    get_ranks().broadcast(bytes);
    Message message(std::move(bytes));
    mpm::Body<D> description = mpm::get_description(message, layout);
    StagePlan<D> plan;
    StageState state;
    Hooked hooked;
    Taking{message}(plan, state, hooked);
    set_strength(description, data, plan.cohesion, plan.strength_factor);
    SharedStage<D>(nullptr, {}, hooked).run(std::move(description), false, plan, state);
  }
}

#define TALUS_INSTANTIATE(D)                                                                                         \
  template results::StageEnd run_on_ranks<D>(mpm::Body<D>&, const StagePlan<D>&, StageState&, const StageHooks<D>&); \
  template class Helpers<D>;                                                                                         \
  template void help_with_stages<D>(const input::Case&);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

}  // namespace talus::run
