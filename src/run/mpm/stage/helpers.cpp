// SPDX-License-Identifier: MIT
#include "run/mpm/stage/helpers.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/hash.hpp"
#include "base/ranks.hpp"
#include "mpm/state/partition.hpp"
#include "run/mpm/stage/stage.hpp"
#include "run/mpm/start/prepare.hpp"

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

enum class Request { stage, stage_on_another_mesh, leave };

}  // namespace

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

template <int D>
void Helpers<D>::begin(const mpm::Body<D>& body, const StagePlan<D>& plan, const StageState& state,
                       const HooksOfRank0& hooks) {
  Request request = body.layout == layout_ ? Request::stage : Request::stage_on_another_mesh;
  broadcast(request);
  if (request == Request::stage_on_another_mesh) layout_ = mpm::broadcast_layout(body.layout);
  Message message;
  mpm::put_description(body, message);
  Putting{message}(plan, state, hooks);
  Bytes bytes = message.take();
  get_ranks().broadcast(bytes);
  knows_failure_ = true;
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
    HooksOfRank0 hooks;
    Taking{message}(plan, state, hooks);
    set_strength(description, data, plan.cohesion, plan.strength_factor);
    SteppedBody<D> stepped(std::move(description), plan, hooks);
    advance_stage(stepped, state);
  }
}

#define TALUS_INSTANTIATE(D)                         \
  template void check_equal<D>(const mpm::Body<D>&); \
  template class Helpers<D>;                         \
  template void help_with_stages<D>(const input::Case&);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

}  // namespace talus::run
