// SPDX-License-Identifier: MIT
#include "results/named.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>

#include "base/numbers.hpp"
#include "base/units.hpp"
#include "results/bounds.hpp"
#include "results/described.hpp"
#include "results/governing.hpp"

namespace talus::results {
namespace {

/// Factors that differ by less count as equal.
constexpr double same_factor = 1e-9;
/// End of the title of a discharge; [[compare]] counts inflow negative.
constexpr const char* inflow_sign = ", counted negative";

/// Visitor that selects a number of a described struct by its key.
class Member : public Visitor {
 public:
  explicit Member(std::string_view wanted) : wanted_(wanted) {}

  About about{};
  std::optional<double> value{};

 protected:
  void visit(const Key& key, Value member) override {
    if (key.name != wanted_) return;
    about = key.about;
    if (member.shape() == Shape::optional) member = member.get_held();
    if (member.is_null()) return;
    if (member.shape() == Shape::number) value = member.get_number();
    if (member.shape() == Shape::integer) value = static_cast<double>(member.get_integer());
  }
  void visit_merged(const char* /*sign*/, Value /*block*/) override {}

 private:
  std::string_view wanted_;
};

/// Returns a description of the slip line `name`.
const char* describe_line(const MethodComparison& methods, const std::string& name) {
  const auto found = std::find_if(methods.surfaces.begin(), methods.surfaces.end(),
                                  [&](const MethodSurface& s) { return s.name == name; });
  if (found != methods.surfaces.end() && found->method == Method::fem) return "the shear band of FEM";
  if (found != methods.surfaces.end() && found->method == Method::bounds) return "the mechanism of the upper bound";
  return "the slip line of MPM";
}

constexpr std::string_view factor_at = "timeline.factor[";

/// Returns the time [s] in a name such as "timeline.factor[43200]"; nullopt for any other name.
std::optional<double> read_time(const std::string& name) {
  if (!name.starts_with(factor_at) || !name.ends_with("]")) return std::nullopt;
  double time = 0;
  const char *first = name.data() + factor_at.size(), *last = name.data() + name.size() - 1;
  return parse_number(first, last, time) == last ? std::optional(time) : std::nullopt;
}

class Values {
 public:
  explicit Values(int dimension) : dimension_(dimension) {}

  void add_slices(const SliceResult& slices) {
    for (const CriticalSurface& c : slices.critical) add_surface("lem.", c, "the critical circle");
    for (const CriticalSurface& c : slices.noncircular) add_surface("lem.noncircular.", c, "the critical polyline");
    for (const CriticalSurface& c : slices.given) {
      const std::string name = c.surface.name.value_or("");
      add_surface(fmt::format("lem.surface[{}].", name), c, fmt::format("surface '{}'", name));
    }
    for (const CriticalSurface& c : slices.critical) {
      const SliceMethod by = c.surface.method;
      add(ResultKind::yield_acceleration, fmt::format("lem.yield_acceleration.{}", to_word(by)),
          fmt::format("{}, yield acceleration over g of the critical circle", get_title(by)), "", "yield_acceleration",
          c.yield_acceleration, by);
    }
  }

  void add_main_factor(const RunResult& run) {
    add_factor("main_factor", "factor of safety that governs", find_main_factor(run));
  }

  /// Adds the bounds of the referee, and the factor and the yield acceleration of the governing surface.
  void add_governing(const RunResult& run) {
    const std::optional<GoverningSurface> governing = find_governing_surface(run);
    if (run.slices && run.slices->referee) {
      add_factor("lem.referee.lower", "lower bound by limit analysis, for the soil of LEM", run.slices->referee->lower);
      add_factor("lem.referee.upper", "upper bound by limit analysis, for the soil of LEM", run.slices->referee->upper);
    }
    if (!governing) return add_factor("lem.factor", "factor of safety that governs, LEM", find_slices_factor(run));
    const CriticalSurface& c = *governing->found;
    add_factor("lem.factor", "factor of safety that governs, LEM", c.surface.factor);
    if (c.drawdown) {
      add_factor("lem.drawdown.before", "factor of safety of the same slip surface before drawdown",
                 c.drawdown->factor_before);
      if (c.drawdown->undrained_factor)
        add_factor("lem.drawdown.undrained", "factor of safety of the same slip surface, second stage",
                   c.drawdown->undrained_factor);
    }
    add(ResultKind::yield_acceleration, "lem.yield_acceleration",
        "yield acceleration over g of the slip surface that governs", "", "yield_acceleration", c.yield_acceleration);
  }

  void add_methods(const MethodComparison& methods) {
    for (const HandedSurface& h : methods.handed) {
      const auto by = from_word<SliceMethod>(h.to);  // nullopt for a surface that was optimised
      const char* line = describe_line(methods, h.from);
      add(ResultKind::factor, fmt::format("lem.handed[{}].{}", h.from, h.to),
          by ? fmt::format("{}, factor of safety on {}", get_title(*by), line) : h.title, "", "factor", h.factor, by);
    }
  }

  void add_elements(const ElementResult& elements) {
    for (const ElementRun& run : elements.runs) {
      const bool associated = run.flow == Flow::associated;
      const char *stem = associated ? "fem.associated." : "fem.", *flow = associated ? " with ψ = φ" : "";
      add_factor(fmt::format("{}factor", stem), fmt::format("factor of safety, FEM{}", flow), run.factor);
      add_factor(fmt::format("{}by_displacement", stem), fmt::format("factor of safety by displacement, FEM{}", flow),
                 run.by_displacement);
    }
  }

  void add_bounds(const BoundsResult& bounds) {
    add_factor("bounds.lower", "lower bound of the factor of safety", bounds.lower);
    add_factor("bounds.upper", "upper bound of the factor of safety", bounds.upper);
  }

  template <class Name>
  void add_release(const ConstructionStage& stage, const Name& name, const std::string& at) {
    if (!stage.release || stage.release->error) return;
    const RunoutEstimates about = make_estimates(*stage.release);
    const auto add_estimate = [&](const char* key, const char* title, const char* unit, const Estimate& estimate) {
      add(ResultKind::motion, name(key), title + at, unit, key, estimate.value);
      list.back().estimate = estimate;
    };
    add_estimate("moved_volume", "moved volume, released", "m3", about.moved_volume);
    add_estimate("toe_distance", "runout beyond the toe, released", "m", about.toe_distance);
  }

  /// Root mean square differences from measurements.
  void add_misfits(const ConstructionMonitor& monitor) {
    const auto add_one = [&](const char* quantity, const char* title, const char* unit, ResultKind kind,
                             const std::optional<MeasuredCurve>& curve) {
      if (curve)
        add(kind, fmt::format("construction.monitor[{}].{}_misfit", monitor.name, quantity),
            fmt::format("root mean square difference from the measured {} of monitor '{}'", title, monitor.name), unit,
            "misfit", curve->rms);
    };
    add_one("settlement", "settlement", "m", ResultKind::motion, monitor.measured_settlement);
    add_one("lateral", "horizontal displacement", "m", ResultKind::motion, monitor.measured_lateral);
    add_one("pressure", "pore pressure", "Pa", ResultKind::water, monitor.measured_pressure);
  }

  void add_construction(const Construction& construction) {
    add_factor("construction.least", "least factor of safety at the ends of the stages", construction.least);
    for (const ConstructionStage& stage : construction.stages) {
      const auto name = [&](const char* quantity) { return fmt::format("construction[{}].{}", stage.name, quantity); };
      const std::string at = fmt::format(" at the end of stage '{}'", stage.name);
      for (const StageFactor& factor : stage.factors)
        add_factor(name(to_word(factor.method)) + (factor.undrained ? ".undrained" : ""),
                   fmt::format("factor of safety{}, {}{}", at, get_title(factor.method),
                               factor.undrained ? ", without drainage" : ""),
                   factor.factor);
      if (stage.steps.empty() || !stage.converged) continue;
      const ConstructionStep& last = stage.steps.back();
      add(ResultKind::motion, name("settlement"), "largest settlement" + at, "m", "settlement", last.settlement);
      add(ResultKind::motion, name("heave"), "largest heave" + at, "m", "heave", last.heave);
      add(ResultKind::motion, name("lateral"), "largest horizontal displacement" + at, "m", "lateral", last.lateral);
      add(ResultKind::water, name("excess"), "largest excess pore pressure" + at, "Pa", "excess", last.excess);
      add(ResultKind::water, name("least_excess"), "least excess pore pressure" + at, "Pa", "least_excess",
          last.least_excess);
      add_release(stage, name, at);
    }
    for (const ConstructionMonitor& monitor : construction.monitors) add_misfits(monitor);
  }

  void add_timeline(const Timeline& timeline) {
    add_factor("timeline.least", "least factor of safety in time", timeline.least);
    add(ResultKind::other, "timeline.least_time", "when the factor of safety is least", "s", "least_time",
        timeline.least_time);
    add(ResultKind::other, "timeline.failure_time",
        "time at which the factor of safety is first found below the target", "s", "failure_time",
        timeline.failure ? std::optional(timeline.failure->to) : std::nullopt);
    if (const TimedReduction* elements = find_least_reduction(timeline))
      add_factor("timeline.elements", "least factor of safety by FEM at later times", elements->runs.front().factor);
    if (timeline.chosen) return;
    for (const TimedFactor& f : timeline.factors)
      add_factor(fmt::format("{}{:.15g}]", factor_at, f.time),
                 fmt::format("factor of safety at {}", units::format_time(f.time)), f.factor);
  }

  void add_factors(const PointFactors& factors) {
    add_factor("factor_of_safety", "factor of safety", factors.value);
    if (factors.frozen)
      add_factor("factor_of_safety.frozen", "factor of safety, rest or run-away at frozen geometry",
                 factors.frozen->factor);
    if (!factors.criteria) return;
    for (const Criterion& c : *factors.criteria) {
      const char* word = to_word(c.kind);
      add_factor(fmt::format("factor_of_safety.{}", word), fmt::format("factor of safety, {} criterion", word),
                 c.factor);
    }
  }

  /// Adds the runout; `of` is appended to the titles: ", runout at SRF 1.75".
  void add_runout(const std::string& path, const std::string& of, const Runout& runout) {
    add_side(path, of, runout);
    const RunoutEstimates about(runout);
    for (NamedValue& v : list) {
      if (v.kind != ResultKind::runout || v.name != path + "." + v.quantity) continue;
      if (const Estimate* estimate = about.find(v.quantity)) v.estimate = *estimate;
    }
    if (!runout.sides) return;
    for (const RunoutSide& side : *runout.sides)
      add_side(path + (side.direction < 0 ? ".left" : ".right"), fmt::format(" {}{}", name_side(side.direction), of),
               side);
  }
  void add_side(const std::string& path, const std::string& of, const auto& side) {
    for (const char* key : {"moved_volume", "deposit_volume", "front_advance", "toe_distance", "crest_retreat",
                            "mass_front_advance", "centre_advance", "centre_drop", "largest_displacement"})
      add_member(path, side, key, ResultKind::runout, of);
  }
  void add_times(const std::string& path, const std::string& of, std::optional<double> failure, StageEnd end,
                 double time) {
    const auto add_time = [&](const char* key, const char* title, std::optional<double> value) {
      add(ResultKind::runout, fmt::format("{}.{}", path, key), title + of, "s", key, value);
    };
    add_time("failure_time", "time of failure", failure);
    add_time("rest_time", "time to rest", end == StageEnd::rest ? std::optional(time) : std::nullopt);
  }

  void add_motion(const Motion& motion) {
    for (const MonitorMotion& m : motion.monitors) {
      add(ResultKind::motion, fmt::format("onset[{}]", m.name),
          fmt::format("onset of movement of '{}' after the start of '{}'", m.name, motion.stage), "s", "onset",
          m.onset);
      add(ResultKind::motion, fmt::format("displacement[{}]", m.name),
          fmt::format("displacement of '{}' at the end", m.name), "m", "displacement", m.displacement);
    }
  }

  void add_stage(const Stage& stage) {
    add(ResultKind::stage, fmt::format("stage[{}].displacement", stage.name),
        fmt::format("largest displacement at the end of '{}'", stage.name), "m", "displacement", stage.displacement);
    add(ResultKind::stage, fmt::format("stage[{}].time", stage.name),
        fmt::format("simulated time at the end of '{}'", stage.name), "s", "time", stage.time);
  }

  void add_water(const WaterBudget& water) {
    for (const SurfaceWater& s : water.surfaces) {
      if (s.name == other_surfaces) continue;
      const auto add_volume = [&](const char* key, const char* title, double mass) {
        add(ResultKind::water, fmt::format("water.{}[{}]", key, s.name), fmt::format("{} '{}'", title, s.name), "m3",
            key, mass / water.density);
      };
      add_volume("inflow", "water that came in through", s.entered);
      add_volume("outflow", "water that left through", s.left);
      if (s.condition == SurfaceCondition::rain) add_volume("runoff", "rain that ran off", s.runoff);
    }
    add_member("water", water, "largest_suction", ResultKind::water);
    add_member("water", water, "largest_pressure", ResultKind::water);
    add_member("water", water, "error", ResultKind::water, "", "budget_error");
  }

  void add_seepage(const Seepage& seepage) {
    for (const Discharge& d : seepage.discharges) {
      if (d.name == other_surfaces) continue;
      add(ResultKind::seepage, fmt::format("seepage.discharge[{}]", d.name),
          fmt::format("steady seepage {} through '{}'{}", d.inflow > d.outflow ? "in" : "out", d.name,
                      d.inflow > d.outflow ? inflow_sign : ""),
          "m3/s", "discharge", d.outflow - d.inflow);
    }
    add_member("seepage", seepage, "largest_suction", ResultKind::seepage);
  }

  /// Adds the discharges of the last state, and the worst of all states of what endangers the soil.
  void add_flow(const FlowResult& flow) {
    if (flow.states.empty()) return;
    const FlowState& last = flow.states.back();
    for (const SectionFlow& s : last.sections)
      add(ResultKind::seepage, fmt::format("flow.section[{}]", s.name), fmt::format("discharge through '{}'", s.name),
          "m3/s", "discharge", s.discharge);
    std::set<std::string> named;
    for (const FlowState& state : flow.states)
      for (const ExitGradient& exit : state.exits) {
        if (!named.insert(exit.name).second) continue;
        const ExitGradient* worst = find_worst_exit(flow, exit.name).found;
        if (worst == nullptr) continue;
        add(ResultKind::seepage, fmt::format("flow.exit_gradient[{}]", exit.name),
            fmt::format("largest exit gradient at '{}'", exit.name), "", "exit_gradient", worst->gradient);
        add(ResultKind::seepage, fmt::format("flow.boiling[{}]", exit.name),
            fmt::format("factor of safety against boiling at '{}'", exit.name), "", "boiling", worst->factor);
      }
    if (const auto worst = find_worst_uplift(flow); worst.found != nullptr)
      add(ResultKind::seepage, "flow.uplift", "factor of safety against uplift", "", "uplift", worst.found->factor);
    for (const Heave& heave : last.heaves)
      if (const auto worst = find_worst_heave(flow, heave.name); worst.found != nullptr)
        add(ResultKind::seepage, fmt::format("flow.heave[{}]", heave.name),
            fmt::format("factor of safety against heave of '{}'", heave.name), "", "heave", worst.found->factor);
  }

  /// Adds the number of `owner` with the key `key`, named `called` or, if that is null, `key`.
  void add_member(const std::string& path, const auto& owner, const char* key, ResultKind kind,
                  const std::string& of = "", const char* called = nullptr) {
    Member member(key);
    make_value(owner).describe(member);
    const std::string quantity = called != nullptr ? called : key;
    add(kind, path + "." + quantity, member.about.title + of, member.about.unit, quantity, member.value);
  }

  void add_over_design(std::optional<double> value) {
    add(ResultKind::over_design, "partial_factors.over_design", "degree of over-design with partial factors", "",
        "over_design", value);
  }

  std::vector<NamedValue> list;

 private:
  void add(ResultKind kind, std::string name, std::string title, std::string unit, std::string quantity,
           std::optional<double> value, std::optional<SliceMethod> by = {}) {
    if (!value) return;
    if (dimension_ == 2 && unit.starts_with("m3")) unit += "/m";
    list.push_back({std::move(name), std::move(title), std::move(unit), kind, std::move(quantity), by, *value});
  }
  void add_factor(std::string name, std::string title, std::optional<double> value) {
    add(ResultKind::factor, std::move(name), std::move(title), "", "factor", value);
  }
  void add_surface(const std::string& path, const CriticalSurface& c, const std::string& of) {
    const SliceMethod by = c.surface.method;
    add(ResultKind::factor, path + to_word(by), fmt::format("{}, factor of safety of {}", get_title(by), of), "",
        "factor", c.surface.factor, by);
  }

  int dimension_;
};

}  // namespace

std::vector<NamedValue> list_values(const RunResult& run, int dimension) {
  Values values(dimension);
  values.add_main_factor(run);
  values.add_governing(run);
  if (run.slices) values.add_slices(*run.slices);
  if (run.methods) values.add_methods(*run.methods);
  if (run.elements) values.add_elements(*run.elements);
  if (run.bounds) values.add_bounds(*run.bounds);
  if (run.timeline) values.add_timeline(*run.timeline);
  if (run.construction) values.add_construction(*run.construction);
  if (run.flow) values.add_flow(*run.flow);
  if (run.methods && run.methods->partial_factors) values.add_over_design(run.methods->partial_factors->over_design);
  if (run.factor_of_safety) values.add_factors(*run.factor_of_safety);
  if (run.runouts)
    for (const RunoutTrial& r : *run.runouts) {
      const std::string path = fmt::format("runout[{:g}]", r.trial.factor),
                        of = fmt::format(", runout at SRF {:g}", r.trial.factor);
      values.add_runout(path, of, r.runout);
      values.add_times(path, of, r.failure_time, r.trial.end, r.trial.time);
    }
  if (run.runout) values.add_runout("runout", "", *run.runout);
  if (run.runout && run.stages && !run.stages->empty())
    values.add_times("runout", "", run.failure_time, run.stages->back().end, run.stages->back().time);
  if (run.motion) values.add_motion(*run.motion);
  if (run.stages)
    for (const Stage& stage : *run.stages) values.add_stage(stage);
  if (run.water) values.add_water(*run.water);
  if (run.seepage) values.add_seepage(*run.seepage);
  if (run.mesh)
    for (const char* key : {"critical_time_step", "points", "soil_elements"})
      values.add_member("mesh", *run.mesh, key, ResultKind::mesh);
  return std::move(values.list);
}

bool is_same_result(const std::string& known, const std::string& asked) {
  constexpr double near = 1e-6;
  if (known == asked) return true;
  const auto one = read_time(known), other = read_time(asked);
  return one && other && std::abs(*one - *other) <= near * std::abs(*one);
}

std::optional<NamedValue> find_named(const RunResult& run, const std::string& name) {
  for (NamedValue& value : list_values(run, run.mesh ? run.mesh->dimension : 2))
    if (is_same_result(value.name, name)) return std::move(value);
  return std::nullopt;
}

std::optional<double> find_value(const RunResult& run, const std::string& name) {
  const auto value = find_named(run, name);
  return value && value->is_determined() ? std::optional(value->value) : std::nullopt;
}

std::string explain_undetermined(const NamedValue& value) {
  if (value.is_determined()) return "";
  const bool is_volume = value.unit.starts_with("m3");
  return format_estimate(*value.estimate, {is_volume ? "m³" + value.unit.substr(2) : value.unit, 1});
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

}  // namespace talus::results
