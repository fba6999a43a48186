// SPDX-License-Identifier: MIT
#include "run/mpm/ranks_stage.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "base/hash.hpp"
#include "base/ranks.hpp"
#include "mpm/body/share.hpp"
#include "run/mpm/balance.hpp"

namespace talus::run {
namespace {

template <class T>
void put_text(const T& values, std::string& text) {
  text.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(values[0]));
}

/// Every rank has made the body by itself. Another program or library would make another one, and nobody would see it.
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

}  // namespace

template <int D>
results::StageEnd run_on_ranks(mpm::Body<D>& body, const StagePlan<D>& plan, StageState& state,
                               const StageHooks<D>& hooks) {
  using Body = mpm::Body<D>;
  Ranks& ranks = get_ranks();
  check_equal(body);
  Body share = mpm::take_share(body, ranks, mpm::divide_chunks(mpm::count_work(body), ranks.size()));
  StageHooks<D> shared;
  Balance<D> balance(body);
  shared.rebalance = [&](Body& b) { balance.look(b); };
  if (hooks.output)
    shared.output = [&](const Body& b, StageState& s) {
      balance.leave_out([&] {
        mpm::collect(b, false, body);
        lead_ranks([&] { hooks.output(body, s); });
        for (double* told : {&s.next_output, &s.soft_band, &s.soft_size}) broadcast(*told);
      });
    };
  if (hooks.look) {
    shared.look_is_due = [&] {
      bool due = !hooks.look_is_due || hooks.look_is_due();
      balance.leave_out([&] { broadcast(due); });
      return due;
    };
    shared.look = [&](const Body& b, const StageState& s) {
      balance.leave_out([&] {
        mpm::collect(b, false, body);
        lead_ranks([&] { hooks.look(body, s); });
      });
    };
  }
  if (hooks.save_last_good)
    shared.save_last_good = [&](const Body& b, const StageState& s) {
      mpm::collect(b, false, body);
      std::string saved;
      lead_ranks([&] { saved = hooks.save_last_good(body, s); });
      return saved;
    };
  if (hooks.mark)
    shared.mark = [&]() -> GoBack<D> {
      GoBack<D> inner;
      lead_ranks([&] { inner = hooks.mark(); });
      return [&body, inner](const Body& b, const StageState& s, const StagePlan<D>& p) {
        mpm::collect(b, false, body);
        lead_ranks([&] { inner(body, s, p); });
      };
    };
  const results::StageEnd end = run_stage(share, plan, state, shared);
  mpm::collect(share, true, body);
  mpm::gather_loads(body);
  return end;
}

template results::StageEnd run_on_ranks<2>(mpm::Body<2>&, const StagePlan<2>&, StageState&, const StageHooks<2>&);
template results::StageEnd run_on_ranks<3>(mpm::Body<3>&, const StagePlan<3>&, StageState&, const StageHooks<3>&);

}  // namespace talus::run
