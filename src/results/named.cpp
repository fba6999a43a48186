#include "results/named.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace talus::results {
namespace {

/// Two factors are one when they differ by less.
constexpr double same_factor = 1e-9;

class Values {
 public:
  void add(std::string name, std::optional<double> value) {
    if (value) list.push_back({std::move(name), *value});
  }

  void add_slices(const SliceResult& slices) {
    for (const CriticalSurface& c : slices.critical) add(fmt::format("lem.{}", word(c)), c.surface.factor);
    for (const CriticalSurface& c : slices.noncircular)
      add(fmt::format("lem.noncircular.{}", word(c)), c.surface.factor);
    for (const CriticalSurface& c : slices.given)
      add(fmt::format("lem.surface[{}].{}", c.surface.name.value_or(""), word(c)), c.surface.factor);
    for (const CriticalSurface& c : slices.critical)
      add(fmt::format("lem.yield_acceleration.{}", word(c)), c.yield_acceleration);
  }

  void add_elements(const ElementResult& elements) {
    for (const ElementRun& run : elements.runs) {
      const std::string stem = run.flow == Flow::associated ? "fem.associated." : "fem.";
      add(stem + "factor", run.factor);
      add(stem + "by_displacement", run.by_displacement);
    }
  }

  void add_factors(const PointFactors& factors) {
    add("factor_of_safety", factors.value);
    if (factors.frozen) add("factor_of_safety.frozen", factors.frozen->factor);
    if (factors.criteria)
      for (const Criterion& c : *factors.criteria) add(fmt::format("factor_of_safety.{}", to_word(c.kind)), c.factor);
  }

  void add_runout(const std::string& stem, const Runout& r) {
    add(stem + "moved_volume", r.moved_volume);
    add(stem + "front_advance", r.front_advance);
    add(stem + "toe_distance", r.toe_distance);
    add(stem + "crest_retreat", r.crest_retreat);
    add(stem + "centre_advance", r.centre_advance);
    add(stem + "centre_drop", r.centre_drop);
    add(stem + "largest_displacement", r.largest_displacement);
  }

  void add_times(const std::string& stem, std::optional<double> failure, StageEnd end, double time) {
    add(stem + "failure_time", failure);
    if (end == StageEnd::rest) add(stem + "rest_time", time);
  }

  void add_water(const WaterBudget& water) {
    for (const SurfaceWater& s : water.surfaces) {
      add(fmt::format("water.inflow[{}]", s.name), s.entered / water.density);
      add(fmt::format("water.outflow[{}]", s.name), s.left / water.density);
      add(fmt::format("water.runoff[{}]", s.name), s.runoff / water.density);
    }
    add("water.largest_suction", water.largest_suction);
    add("water.largest_pressure", water.largest_pressure);
    add("water.budget_error", water.error);
  }

  void add_seepage(const Seepage& seepage) {
    for (const Discharge& d : seepage.discharges)
      add(fmt::format("seepage.discharge[{}]", d.name), d.outflow - d.inflow);
    add("seepage.largest_suction", seepage.largest_suction);
  }

  std::vector<NamedValue> list;

 private:
  static const char* word(const CriticalSurface& c) { return to_word(c.surface.method); }
};

}  // namespace

std::vector<NamedValue> list_values(const RunResult& run) {
  Values values;
  if (run.slices) values.add_slices(*run.slices);
  if (run.methods)
    for (const HandedSurface& h : run.methods->handed)
      values.add(fmt::format("lem.handed[{}].{}", h.from, h.to), h.factor);
  if (run.elements) values.add_elements(*run.elements);
  if (run.methods && run.methods->partial_factors)
    values.add("partial_factors.over_design", run.methods->partial_factors->over_design);
  if (run.factor_of_safety) values.add_factors(*run.factor_of_safety);
  if (run.runouts)
    for (const RunoutTrial& r : *run.runouts) {
      const std::string stem = fmt::format("runout[{:g}].", r.trial.factor);
      values.add_runout(stem, r.runout);
      values.add_times(stem, r.failure_time, r.trial.end, r.trial.time);
    }
  if (run.runout) values.add_runout("runout.", *run.runout);
  if (run.stages && !run.stages->empty())
    values.add_times("runout.", run.failure_time, run.stages->back().end, run.stages->back().time);
  if (run.motion)
    for (const MonitorMotion& m : run.motion->monitors) {
      values.add(fmt::format("onset[{}]", m.name), m.onset);
      values.add(fmt::format("displacement[{}]", m.name), m.displacement);
    }
  if (run.stages)
    for (const Stage& s : *run.stages) {
      values.add(fmt::format("stage[{}].displacement", s.name), s.displacement);
      values.add(fmt::format("stage[{}].time", s.name), s.time);
    }
  if (run.water) values.add_water(*run.water);
  if (run.seepage) values.add_seepage(*run.seepage);
  if (run.mesh) {
    values.add("mesh.critical_time_step", run.mesh->critical_time_step);
    values.add("mesh.points", run.mesh->points);
    values.add("mesh.soil_elements", run.mesh->soil_elements);
  }
  return std::move(values.list);
}

CurveValue find_displacement(const RunResult& run, double factor) {
  if (!run.curve) return {};
  const std::vector<Trial>& points = run.curve->points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double here = points[i].factor, u = points[i].displacement;
    if (std::abs(here - factor) < same_factor) return {u, ""};
    if (here < factor || i == 0) continue;
    const double before = points[i - 1].factor, u_before = points[i - 1].displacement;
    return {u_before + (u - u_before) * (factor - before) / (here - before),
            fmt::format("no trial at SRF {:g}: interpolated between those at {:g} and {:g}", factor, before, here)};
  }
  return {};
}

std::optional<double> find_main_factor(const RunResult& run) {
  if (run.factor_of_safety) {
    if (run.factor_of_safety->value) return run.factor_of_safety->value;
    if (run.factor_of_safety->criteria)
      for (const Criterion& c : *run.factor_of_safety->criteria)
        if (c.factor) return c.factor;
  }
  if (run.elements && !run.elements->runs.empty()) return run.elements->runs.front().factor;
  if (!run.slices) return std::nullopt;
  std::optional<double> rigorous, any;
  const auto take = [](double f, std::optional<double>& least) { least = least ? std::min(*least, f) : f; };
  for (const auto* list : {&run.slices->critical, &run.slices->noncircular, &run.slices->given})
    for (const CriticalSurface& c : *list) {
      const double f = c.surface.factor.value_or(0);
      if (f <= 0) continue;
      take(f, any);
      const SliceMethod m = c.surface.method;
      if (m == SliceMethod::spencer || m == SliceMethod::morgenstern_price ||
          m == SliceMethod::morgenstern_price_constant)
        take(f, rigorous);
    }
  return rigorous ? rigorous : any;
}

}  // namespace talus::results
