// SPDX-License-Identifier: MIT
#include "run/lem/slice_run.hpp"

#include <cmath>

#include "results/governing.hpp"
#include "run/common/head.hpp"

namespace talus::run {

namespace {

results::SliceTable make_slice_table(const lem::Slope& slope, const lem::CutSurface& cut) {
  results::SliceTable t;
  for (const lem::Slice& s : cut.slices) {
    t.left.push_back(s.left);
    t.right.push_back(s.right);
    t.base_left.push_back(s.base_left);
    t.base_right.push_back(s.base_right);
    t.top_left.push_back(s.top_left);
    t.top_right.push_back(s.top_right);
    t.soil.push_back(slope.section().soils.at(static_cast<std::size_t>(s.soil)).name);
    t.alpha.push_back(s.alpha());
    t.length.push_back(s.length);
    t.weight.push_back(s.weight);
    t.surface_load.push_back(s.surface_load);
    t.surface_thrust.push_back(s.surface_thrust);
    t.earthquake.push_back(s.earthquake);
    t.pore_pressure.push_back(s.pore_pressure);
    t.cohesion.push_back(s.cohesion);
    t.root_cohesion.push_back(s.root_cohesion);
    t.suction_strength.push_back(s.suction_strength);
    t.tan_friction.push_back(s.tan_friction);
    t.normal.push_back(s.normal);
    t.shear.push_back(s.shear);
    t.m_alpha.push_back(s.m_alpha);
    t.normal_right.push_back(s.normal_right);
    t.shear_right.push_back(s.shear_right);
    t.thrust_right.push_back(s.thrust_right);
  }
  return t;
}

std::vector<results::SupportForce> list_supports(const lem::Slope& slope, const lem::Critical& c) {
  constexpr std::array limits{results::SupportLimit::tension,   results::SupportLimit::pull_out,
                              results::SupportLimit::stripping, results::SupportLimit::prestress,
                              results::SupportLimit::lateral,   results::SupportLimit::shear,
                              results::SupportLimit::embedment, results::SupportLimit::rotation,
                              results::SupportLimit::one_hinge, results::SupportLimit::two_hinges};
  std::vector<results::SupportForce> list;
  // F of the equations, without Janbu's correction.
  const double factor = c.solution.factor / c.solution.correction;
  for (const lem::BarPull& pull : c.cut.pulls) {
    if (pull.force() == 0) continue;
    const lem::Bar& bar = slope.section().bars[static_cast<std::size_t>(pull.bar)];
    results::SupportForce& out = list.emplace_back();
    out.support = bar.name;
    out.kind = bar.kind;
    out.row = bar.row;
    out.is_active = bar.is_active;
    out.head = bar.head;
    out.end = bar.end;
    out.crossing = pull.at;
    out.distance = pull.distance;
    out.resistance = pull.resistance;
    out.force = pull.force();
    // Below F = 1 the equations have R/F, more than the bar can bear.
    if (!bar.is_active && factor > 0) {
      const double required = pull.resistance / factor;
      if (required > pull.resistance) out.required = required;
      out.force = std::min(required, pull.resistance);
    }
    out.direction = pull.direction;
    const auto set = [](std::optional<double>& limit, double value) {
      if (std::isfinite(value)) limit = value;
    };
    if (bar.hold == lem::BarHold::bond || bar.hold == lem::BarHold::end_anchor) {
      set(out.tension, bar.tensile);
      set(out.pull_out, pull.behind);
      set(out.stripping, pull.front);
    }
    out.limit = pull.is_slack ? results::SupportLimit::prestress : limits[static_cast<std::size_t>(pull.limit)];
  }
  return list;
}

results::DrawnSurface make_drawdown_result(const lem::Critical& c) {
  results::DrawnSurface out;
  if (c.solution.before > 0) out.factor_before = c.solution.before;
  if (c.solution.undrained > 0) out.undrained_factor = c.solution.undrained;
  for (const lem::DrawnBase& base : c.cut.bases) {
    out.normal.push_back(base.normal);
    out.shear.push_back(base.shear);
    out.strength.push_back(base.strength);
    out.counts.push_back(base.drains ? results::Drainage::drained : results::Drainage::undrained);
  }
  return out;
}

}  // namespace

std::vector<lem::Point> list_points(const lem::CutSurface& cut) {
  std::vector<lem::Point> points;
  for (const lem::Slice& s : cut.slices) {
    if (points.empty()) points.push_back(s.base_left);
    points.push_back(s.base_right);
  }
  return points.empty() ? cut.surface.line : points;
}

results::SlipSurface make_surface_result(const lem::Critical& c) {
  results::SlipSurface out;
  out.method = c.method;
  out.title = get_title(c.method);
  out.circular = c.surface.circle.has_value();
  if (c.solution.factor > 0) out.factor = c.solution.factor;
  if (c.surface.circle) out.circle = {c.surface.circle->centre, c.surface.circle->radius};
  out.points = list_points(c.cut);
  if (!c.surface.name.empty()) out.name = c.surface.name;
  return out;
}

results::CriticalSurface make_critical_result(const lem::Slope& slope, const lem::Critical& c) {
  results::CriticalSurface out;
  out.surface = make_surface_result(c);
  if (is_rigorous(c.method)) out.lambda = c.solution.lambda;
  out.correction = c.solution.correction;
  out.area = c.cut.area;
  out.depth = c.cut.depth;
  if (c.surface.crack > 0) out.crack = c.surface.crack;
  out.slides_left = c.cut.slides_left;
  out.yield_acceleration = c.yield_acceleration;
  if (slope.before() != nullptr) out.drawdown = make_drawdown_result(c);
  if (!slope.section().bars.empty()) out.supports = list_supports(slope, c);
  const lem::Refusal refusal = c.cut.refusal != lem::Refusal::none ? c.cut.refusal : c.solution.refusal;
  out.checks = {c.solution.smallest_m_alpha, c.solution.tensile_share, c.solution.thrust_outside, c.solution.residual,
                refusal == lem::Refusal::none ? "" : lem::name_refusal(refusal)};
  out.slices = make_slice_table(slope, c.cut);
  out.warnings = c.warnings;
  return out;
}

results::SliceSearch make_search_result(const lem::SearchOptions& options, const lem::SearchResult& result) {
  results::SliceSearch out;
  out.kind = options.kind == lem::SearchKind::grid    ? results::SearchKind::grid
             : options.kind == lem::SearchKind::block ? results::SearchKind::block
                                                      : results::SearchKind::entry_exit;
  out.tried = result.tried;
  for (std::size_t m = 0; m < result.refused.size(); ++m) {
    auto& counts = out.refused[to_word(options.methods[m])];
    for (const auto& [why, count] : result.refused[m]) counts[lem::name_refusal(why)] = count;
  }
  for (const lem::LimitHit& hit : result.limit_hits) out.limit_hits.push_back({get_title(hit.method), hit.limit});
  if (const auto& e = result.entry_exit; e && options.kind == lem::SearchKind::entry_exit) {
    out.ranges.exit = e->exit;
    out.ranges.entry = e->entry;
    out.ranges.exits = e->exits;
    out.ranges.entries = e->entries;
    out.ranges.depths = e->depths;
  }
  if (const auto& g = result.grid; g && options.kind == lem::SearchKind::grid) {
    out.ranges.grid = {g->from, g->to, g->columns, g->rows, g->radii, std::nullopt};
    if (g->lowest && g->highest) out.ranges.grid->levels = {*g->lowest, *g->highest};
  }
  out.smallest_depth = result.smallest_depth;
  out.seconds = result.seconds;
  out.circles_per_second = result.seconds > 0 ? static_cast<double>(result.tried) / result.seconds : 0;
  return out;
}

results::SliceTrials make_trials_result(const lem::SearchOptions& options, const lem::SearchResult& result) {
  constexpr double digits = 1e4;
  results::SliceTrials out;
  for (const lem::Method m : options.methods) out.methods.emplace_back(to_word(m));
  for (const lem::TriedCircle& t : result.trials) {
    if (!t.surface.circle) continue;
    std::vector<double>& row = out.trials.emplace_back();
    for (const double x : {t.surface.circle->centre[0], t.surface.circle->centre[1], t.surface.circle->radius,
                           t.surface.from, t.surface.to})
      row.push_back(round_to(x, digits));
    for (const float f : t.factors) row.push_back(round_to(f, digits));
  }
  for (std::size_t m = 0; m < result.maps.size(); ++m) {
    const auto& map = result.maps[m];
    results::FactorMap& shown = out.maps[to_word(options.methods[m])];
    shown = {map.from, map.to, map.columns, map.rows, {}};
    for (const float f : map.factor)
      shown.factor.push_back(std::isfinite(f) ? std::optional(round_to(f, digits)) : std::nullopt);
  }
  return out;
}

SliceRun::SliceRun(const site::Site& site, bool alone, const RunOptions& options, std::string input_hash)
    : MethodRun("limit equilibrium", "lem.json", alone, options, std::move(input_hash)),
      site_(site),
      data_(site_.data()),
      prepared_(prepare_slope(site_)) {
  water_ = prepared_.water;
}

void SliceRun::calculate() {
  is_kept_ = read_kept();
  if (!is_kept_) {
    show("searching for the critical slip surface");
    try_part([&] {
      SliceOutcome found = run_lem(data_, prepared_, options_.threads);
      file_ = {hash_, std::move(found.result), std::move(found.trials)};
      if (const auto governing = results::find_governing_surface(file_.summary, nullptr))
        show("the critical slip surface is found", {.method = "lem",
                                                    .series = governing->found->surface.title,
                                                    .factor = governing->found->surface.factor,
                                                    .surface = governing->found->surface.points});
    });
    clear_progress();
  }
  is_done_ = true;
}

void SliceRun::take_referee(results::Referee referee) {
  results::take_referee(std::move(referee), file_.summary);
}

void SliceRun::keep() {
  file_.input_hash = hash_;
  if (is_done_ && !is_kept_) write_kept();
}

void SliceRun::write_result(results::RunResult& run) const {
  if (!is_done_) return;
  run.slices = file_.summary;
  add_warnings(run);
  site::give(water_, run);
}

}  // namespace talus::run
