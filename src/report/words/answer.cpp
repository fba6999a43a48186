// SPDX-License-Identifier: MIT
#include "report/words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/extrapolate.hpp"
#include "report/content/choices.hpp"
#include "report/content/method_table.hpp"
#include "report/content/parts.hpp"
#include "report/content/water.hpp"
#include "report/folder/numbers.hpp"
#include "results/bounds.hpp"
#include "results/governing.hpp"
#include "results/interval.hpp"
#include "results/supports.hpp"

namespace talus::report {

using nlohmann::json;
using results::CriterionKind;

namespace {

std::string name_criterion(CriterionKind criterion) {
  switch (criterion) {
    case CriterionKind::frozen:
      return "rest or run-away at frozen geometry";
    case CriterionKind::bilinear:
      return "two lines on the displacement curve (moving geometry)";
    case CriterionKind::displacement:
      return "displacement reaches a share of the height (moving geometry)";
    default:
      return "largest jump of the displacement (moving geometry)";
  }
}

std::string describe_meshes(const results::FrozenFactor& frozen, const ShownUnit& length) {
  std::vector<std::string> parts;
  for (const results::MeshFactor* m : frozen.list_found())
    parts.push_back(fmt::format("{:.3f} at h = {}", *m->factor(), show(m->size, length)));
  return join_words(parts);
}

Factor make_factor(CriterionKind criterion, std::optional<double> value) {
  Factor factor;
  factor.name = fmt::format("factor_of_safety.{}", to_word(criterion));
  factor.title = name_criterion(criterion);
  factor.value = value;
  factor.by = criterion;
  return factor;
}

Factor make_frozen_factor(const results::FrozenFactor& frozen, const ShownUnit& length) {
  Factor factor = make_factor(CriterionKind::frozen, frozen.factor);
  if (const auto lower = frozen.lower()) factor.lower = results::show_lower(*lower);
  if (const auto upper = frozen.upper()) factor.upper = results::show_upper(*upper);
  factor.is_extrapolated = frozen.extrapolated.has_value();
  factor.note =
      !frozen.factor
          ? frozen.note
          : fmt::format("{}{}; {}", describe_meshes(frozen, length),
                        factor.is_extrapolated ? ", extrapolated to h = 0" : ", one mesh, not extrapolated",
                        frozen.mesh_effect
                            ? fmt::format("the interval holds the brackets of the search, ± {:.3f}, and what the mesh "
                                          "does, ± {:.3f}",
                                          frozen.bracket, *frozen.mesh_effect)
                            : "the mesh error is not known");
  return factor;
}

/// Returns the factors of MPM.
std::vector<Factor> list_own_factors(const ResultFolder& folder) {
  std::vector<Factor> factors;
  if (!folder.run.factor_of_safety) return factors;
  const results::PointFactors& found = *folder.run.factor_of_safety;
  if (found.frozen) factors.push_back(make_frozen_factor(*found.frozen, read_units(folder.run).length));
  if (found.criteria)
    for (const results::Criterion& c : *found.criteria) {
      Factor& factor = factors.emplace_back(make_factor(c.kind, c.factor));
      factor.note = c.note;
      if (!c.factor) continue;
      factor.lower = c.lower.value_or(*c.factor);
      factor.upper = c.upper.value_or(*c.factor);
    }
  const auto main = std::find_if(factors.begin(), factors.end(), [](const Factor& f) { return f.value.has_value(); });
  if (main != factors.end()) main->is_main = true;
  if (!is_wet(folder)) return factors;
  for (Factor& f : factors)
    if (const input::StepSettings* steps =
            f.by == CriterionKind::frozen ? find_frozen_steps(folder.data) : find_curve_steps(folder.data))
      f.water = steps->water;
  return factors;
}

constexpr const char* too_low = "A factor below one: the slope does not stand with the given strength.";

/// Adds the factors of the other methods and their differences.
void format_methods(const results::RunResult& run, const std::vector<Factor>& factors, json& sentences) {
  const std::string found = format_main_factors(run, factors), proven = format_proven(run),
                    referee = format_referee(run);
  // If limit analysis rules out all factors of LEM or cannot rule out any, its interval comes first, otherwise after
  // the answer.
  const bool is_answer =
      !run.timeline && !referee.empty() &&
      (!results::find_governing_surface(run) || (run.slices->referee->is_wide() && !run.slices->referee->upper_only));
  if (is_answer) sentences.push_back(referee);
  if (found.empty() && proven.empty()) {
    if (is_answer) return;
    sentences.push_back("No method found a factor of safety.");
    return;
  }
  const bool governs = results::is_main_factor_proven(run);
  for (const std::string& said : governs ? std::array{proven, found} : std::array{found, proven})
    if (!said.empty()) sentences.push_back(said);
  // With design values the statement on partial factors includes it.
  const bool is_low = std::any_of(factors.begin(), factors.end(),
                                  [](const Factor& f) { return f.is_main && f.value && *f.value < 1; }) ||
                      (governs && *results::find_main_factor(run) < 1);
  if (!has_design_values(run) && is_low) sentences.push_back(too_low);
  // The smallest factor over time and the factors at time 0 belong to different states, so they are not compared.
  for (const std::string& said : {run.timeline || run.construction ? std::string() : format_agreement(factors),
                                  has_design_values(run) ? run.methods->partial_factors->text : std::string()})
    if (!said.empty()) sentences.push_back(said);
  if (!is_answer && !referee.empty()) sentences.push_back(referee);
}

/// Adds the sentence that the factor is after a rapid drawdown, with the factor of the same surface before it.
void format_drawdown(const results::RunResult& run, json& sentences) {
  if (!run.slices || !run.slices->drawdown) return;
  const auto surface = results::find_governing_surface(run);
  std::string text = fmt::format("It is the factor after a rapid drawdown, by {}", get_title(*run.slices->drawdown));
  if (surface && surface->found->drawdown && surface->found->drawdown->factor_before)
    text += fmt::format("; before it the same surface has {:.3f}", *surface->found->drawdown->factor_before);
  if (surface && surface->found->drawdown && surface->found->drawdown->undrained_factor)
    text += fmt::format(", and {:.3f} with undrained strengths alone", *surface->found->drawdown->undrained_factor);
  sentences.push_back(text + ".");
}

/// Adds the convention of the supports.
void format_supports(const results::RunResult& run, json& sentences) {
  if (!run.slices) return;
  const std::string sense = results::describe_support_sense(*run.slices);
  if (!sense.empty()) sentences.push_back(fmt::format("The factors by LEM have {}.", sense));
}

/// Adds the factors of MPM. `lone`: the case has no other method; otherwise the table of the methods has the details.
void format_factor(const results::RunResult& run, const std::vector<Factor>& factors, bool lone, json& sentences) {
  const auto found = std::find_if(factors.begin(), factors.end(), [](const Factor& f) { return f.is_main; });
  if (found == factors.end()) {
    if (!factors.empty())
      sentences.push_back(
          fmt::format("No criterion {}found a factor of safety in the range that was tried.", lone ? "" : "of MPM "));
    return;
  }
  if (!lone) return;
  std::string text = fmt::format("The factor of safety is {:.3f}", *found->value);
  if (found->by == CriterionKind::frozen) {
    const results::FrozenFactor& frozen = *run.factor_of_safety->frozen;
    const std::string meshes = describe_meshes(frozen, read_units(run).length);
    const double low = frozen.dilatancy_angle_min, high = frozen.dilatancy_angle_max;
    text += low == high ? fmt::format(" with a dilatancy angle of {:.3g}°", high)
                        : fmt::format(" with dilatancy angles from {:.3g}° to {:.3g}°", low, high);
    if (found->water)
      text += found->water == input::WaterMotion::held ? " and pore pressures held (drained)"
                                                       : " and pore water that moves (coupled)";
    text +=
        frozen.extrapolated
            ? fmt::format(": {}, extrapolated to h = 0.", meshes)
            : fmt::format(": {}, on one mesh and not extrapolated; expect some percent less on a finer one.", meshes);
  } else {
    text += fmt::format(" by the criterion \"{}\".", found->title);
  }
  sentences.push_back(text);
  if (*found->value < 1) sentences.push_back(too_low);
}

/// Returns a description of the state at the end of a stage or trial.
std::string describe_end(results::StageEnd end, double time, double force_ratio) {
  if (end == results::StageEnd::rest) return fmt::format("after {} s the soil is at rest", show_number(time));
  return fmt::format(
      "the time was up after {} s{}", show_number(time),
      std::isfinite(force_ratio) ? ", with an unbalanced force of " + show_number(force_ratio, 2) + " of gravity" : "");
}

/// Sentences on the runout of a run and of each trial that was continued until rest.
class RunoutWords {
 public:
  RunoutWords(const results::RunResult& run, json& sentences)
      : length_(read_units(run).length),
        volume_(name_thickness(read_units(run).volume(get_dimension(run)))),
        sentences_(sentences) {}

  void say(const results::Runout& runout, const std::string& where, const std::string& end,
           std::optional<double> failure_time) {
    const std::string largest =
        fmt::format("{} the largest displacement is {}", where, length(runout.largest_displacement));
    const results::RunoutEstimates about(runout);
    if (runout.sides)
      format_sides(runout, *runout.sides, largest, end);
    else if (runout.moved_volume > 0)
      sentences_.push_back(fmt::format("{}, {}, {}, and {}; {}.", largest, describe_front(runout, about),
                                       describe_crest(runout, about), describe_volumes(about), end));
    else
      sentences_.push_back(fmt::format("{}: no soil moves further than 1 % of the height; {}.", largest, end));
    if (failure_time)
      sentences_.push_back(
          fmt::format("Its largest displacement passed the share of the height that counts as failure after {} s.",
                      show_number(*failure_time)));
    if (runout.moved_volume > 0) sentences_.push_back(describe_mesh(runout, about));
  }

 private:
  std::string length(double metres) const { return show(metres, length_); }

  void format_sides(const results::Runout& runout, const std::vector<results::RunoutSide>& sides,
                    const std::string& largest, const std::string& end) {
    const results::RunoutEstimates about(runout);
    sentences_.push_back(fmt::format("{}, and {}; {}.", largest, describe_volumes(about, " to both sides"), end));
    // The coarser mesh is that of the side which represents the whole runout, and has the sum of the volumes only.
    for (const results::RunoutSide& side : sides) {
      const results::RunoutEstimates own(side);
      const auto& ends = runout.coarser_mesh && side.direction == runout.direction ? about : own;
      sentences_.push_back(fmt::format("On the {} {}, {}, and {}.", side.direction < 0 ? "left" : "right",
                                       describe_front(side, ends), describe_crest(side, ends), describe_volumes(own)));
    }
  }

  std::string describe_front(const results::RunoutSide& runout, const results::RunoutEstimates& about) const {
    const results::Estimate &advance = about.front_advance, &beyond = about.toe_distance;
    const std::string first = format_estimate(advance, length_), second = format_estimate(beyond, length_);
    return fmt::format("{} and {}{}",
                       advance.is_determined() ? "the front advances " + first : "the advance of the front is " + first,
                       !beyond.is_determined() ? "its distance beyond the toe is " + second
                       : beyond.value > 0      ? "lies " + second + " beyond the toe"
                                               : "stays behind the toe",
                       runout.limits && runout.limits->front ? ", where the box ends, which limits them" : "");
  }
  std::string describe_crest(const results::RunoutSide& runout, const results::RunoutEstimates& about) const {
    const results::Estimate& retreat = about.crest_retreat;
    if (!retreat.is_determined()) return "the retreat of the crest is " + format_estimate(retreat, length_);
    if (!(retreat.value > 0)) return "the crest stays";
    return fmt::format("the crest retreats {}{}", format_estimate(retreat, length_),
                       runout.limits && runout.limits->crest ? ", to the end of the box" : "");
  }
  /// "57 ± 11 m³ per metre move, of which 20 ± 3 m³ per metre lie over the old ground".
  std::string describe_volumes(const results::RunoutEstimates& about, const char* where = "") const {
    const results::Estimate &moved = about.moved_volume, &deposit = about.deposit_volume;
    const std::string first = format_estimate(moved, volume_), second = format_estimate(deposit, volume_);
    const std::string text = moved.is_determined() ? fmt::format("{} move{}", first, where)
                                                   : fmt::format("the volume that moves{} is {}", where, first);
    if (!deposit.is_determined()) return text + ", the volume over the old ground is " + second;
    return deposit.value > 0 ? text + ", of which " + second + " lie over the old ground" : text;
  }
  std::string describe_mesh(const results::Runout& runout, const results::RunoutEstimates& about) const {
    const std::string highest = (about.highest_ground.is_determined() ? "The highest ground lies at y = "
                                                                      : "The level of the highest ground is ") +
                                format_estimate(about.highest_ground, length_);
    if (!runout.coarser_mesh) return highest + "; one mesh shows no uncertainty.";
    return fmt::format("{}. Behind ± stands three times the difference from elements of {}.", highest,
                       length(runout.coarser_mesh->size));
  }

  ShownUnit length_;
  ShownUnit volume_;
  json& sentences_;
};

/// Adds the points that left the grid, which the numbers of the answer exclude. Returns true if any soil is left.
bool format_lost(const results::RunResult& run, json& sentences) {
  if (!run.budgets || run.budgets->lost.points == 0) return true;
  if (has_lost_all(run)) {
    sentences.push_back("All soil has left the grid, so there is no runout to measure.");
    return false;
  }
  const results::LostPoints& lost = run.budgets->lost;
  sentences.push_back(fmt::format(
      "{} of {} points, {} % of the mass, left the grid; the statements on the soil apply to the remaining points.",
      lost.points, lost.points + static_cast<std::size_t>(run.budgets->points),
      show_number(100 * lost.mass / (lost.mass + run.budgets->mass), 2)));
  return true;
}

void format_runouts(const results::RunResult& run, json& sentences) {
  RunoutWords words(run, sentences);
  if (run.runouts)
    for (const results::RunoutTrial& r : *run.runouts)
      words.say(r.runout, "With the strength divided by " + show_number(r.trial.factor, 6),
                describe_end(r.trial.end, r.trial.time, r.trial.force_ratio), r.failure_time);
  if (!format_lost(run, sentences) || !run.runout) return;
  const bool has_stages = run.stages && !run.stages->empty();
  words.say(*run.runout, "At the end",
            has_stages ? describe_end(run.stages->back().end, run.stages->back().time, run.stages->back().force_ratio)
                       : describe_end(results::StageEnd::time, 0, std::nan("")),
            run.failure_time);
}

void format_comparisons(const std::vector<results::Comparison>& comparisons, json& sentences) {
  std::size_t inside = 0, outside = 0, absent = 0;
  for (const results::Comparison& c : comparisons) ++(!c.computed ? absent : c.passes ? inside : outside);
  if (comparisons.empty()) return;
  const auto are = [](std::size_t n, const char* is, const char* are_many) {
    return fmt::format("{} {}", n, n == 1 ? is : are_many);
  };
  if (comparisons.size() == 1) {
    sentences.push_back(fmt::format("The comparison that the case names {}.", inside    ? "is inside its band"
                                                                              : outside ? "is outside its band"
                                                                                        : "was not calculated"));
    return;
  }
  if (inside == comparisons.size()) {
    sentences.push_back(fmt::format("All {} comparisons that the case names are inside their bands.", inside));
    return;
  }
  std::vector<std::string> parts;
  if (inside > 0) parts.push_back(are(inside, "is inside its band", "are inside their bands"));
  if (outside > 0) parts.push_back(are(outside, "is outside its band", "are outside their bands"));
  if (absent > 0) parts.push_back(are(absent, "was not calculated", "were not calculated"));
  sentences.push_back(
      fmt::format("Of the {} comparisons that the case names, {}.", comparisons.size(), join_words(parts)));
}

void format_state(const results::RunResult& run, json& sentences) {
  using results::Status;
  if (run.status == Status::finished) return;
  if (run.status == Status::unfinished) {
    sentences.push_back(
        "This run has not finished: it is still active or was ended from outside. The report shows what is in its "
        "folder.");
    return;
  }
  const std::string reason = run.error.value_or("");
  const char* how = run.status == Status::interrupted ? "was interrupted"
                    : run.status == Status::unstable  ? "became unstable"
                                                      : "failed";
  sentences.push_back(fmt::format("This run {}, and its answer is incomplete{}{}", how, reason.empty() ? "." : ": ",
                                  reason.empty() || reason.ends_with('.') ? reason : reason + "."));
}

/// Adds the smallest factor over time, before the factors at time 0.
void format_timeline(const results::RunResult& run, json& sentences) {
  if (!run.timeline) return;
  sentences.push_back(results::format_failure(*run.timeline));
  if (std::string releases = results::format_releases(*run.timeline, read_units(run)); !releases.empty())
    sentences.push_back(std::move(releases));
}

/// Adds that the interval of FEM is the result, where its factor is extrapolated too far.
void format_far_extrapolation(const results::RunResult& run, json& sentences) {
  const auto far = results::find_far_extrapolation(run);
  if (!far) return;
  sentences.push_back(
      fmt::format("The factor of safety lies between {:.3f} and {:.3f}: that of FEM is extrapolated by {:.0f} % from "
                  "elements of {}, and above {:.0f} % two meshes do not show the error. Refine [fem] size.",
                  results::show_lower(far->lower), results::show_upper(far->upper), 100 * far->fraction,
                  format_value(far->size, read_units(run).length, 3), 100 * talus::most_extrapolated));
}

/// Adds the stages that did not reach their end, and the largest settlement.
void format_construction(const results::RunResult& run, json& sentences) {
  if (!run.construction) return;
  for (const results::ConstructionStage& stage : run.construction->stages)
    if (stage.error) sentences.push_back(fmt::format("Stage '{}' fails: there is {}.", stage.name, *stage.error));
  for (auto stage = run.construction->stages.rbegin(); stage != run.construction->stages.rend(); ++stage)
    if (!stage->steps.empty()) {
      sentences.push_back(fmt::format("The largest settlement at the end of stage '{}' is {}.", stage->name,
                                      show(stage->steps.back().settlement, read_units(run).displacement, 3)));
      return;
    }
}

/// Adds what endangers the soil by the flow of water alone.
void format_flow(const results::RunResult& run, json& sentences) {
  if (!run.flow || run.flow->states.empty()) return;
  const ShownUnits units = read_units(run);
  const results::FlowResult& flow = *run.flow;
  const auto place = [&](const std::vector<double>& at) {
    return fmt::format("x = {}, y = {}", format_coordinate(at[0], units.length),
                       format_coordinate(at[1], units.length));
  };
  const results::ExitGradient* steepest = nullptr;
  for (const results::FlowState& state : flow.states)
    for (const results::ExitGradient& exit : state.exits)
      if (steepest == nullptr || exit.gradient > steepest->gradient) steepest = &exit;
  if (steepest != nullptr)
    sentences.push_back(
        fmt::format("The largest exit gradient is {:.3g}, at '{}', {}{}{}.", steepest->gradient, steepest->name,
                    place(steepest->at),
                    steepest->factor ? fmt::format(": the factor against boiling is {:.3g}", *steepest->factor) : "",
                    steepest->grows ? "; it depends on the size of the elements there" : ""));
  if (const auto worst = results::find_worst_uplift(flow); worst.found != nullptr)
    sentences.push_back(fmt::format("The least factor against uplift is {:.3g}, of layer '{}' at {}.",
                                    worst.found->factor, worst.found->layer, place(worst.found->at)));
  for (const results::Heave& heave : flow.states.back().heaves)
    if (const auto worst = results::find_worst_heave(flow, heave.name); worst.found != nullptr)
      sentences.push_back(fmt::format("The factor against heave of '{}' is {:.3g}.", heave.name, *worst.found->factor));
}

}  // namespace

std::vector<std::string> list_unrest(const results::RunResult& run) {
  std::vector<std::string> sentences;
  for (const results::Stage& stage : run.stages.value_or(std::vector<results::Stage>{}))
    if (stage.moving)
      sentences.push_back(fmt::format("Stage '{}' did not come to rest{}.", stage.name,
                                      stage.moving->material.empty()
                                          ? ""
                                          : fmt::format(": '{}' still moves at {}", stage.moving->material,
                                                        show(stage.moving->speed, read_units(run).speed(), 2))));
  return sentences;
}

json make_answer(const ResultFolder& folder) {
  const results::RunResult& run = folder.run;
  const std::vector<Factor> own = list_own_factors(folder);
  // The order is LEM, FEM, MPM.
  std::vector<Factor> factors = list_other_factors(run);
  factors.insert(factors.end(), own.begin(), own.end());
  for (Factor& factor : factors)
    if (factor.method == Method::bounds) factor.is_main = results::is_main_factor_proven(run);
  json sentences = json::array(), listed = json::array();
  format_state(run, sentences);
  if (const auto disagreement = results::find_disagreement(run)) sentences.push_back(disagreement->text);
  format_far_extrapolation(run, sentences);
  format_timeline(run, sentences);
  const bool lone = !asks_for_others(folder);
  if (!lone) format_methods(run, factors, sentences);
  format_construction(run, sentences);
  format_drawdown(run, sentences);
  format_supports(run, sentences);
  format_factor(run, own, lone, sentences);
  format_flow(run, sentences);
  format_runouts(run, sentences);
  if (run.motion && !run.motion->sentence.empty()) sentences.push_back(run.motion->sentence);
  for (const std::string& sentence : describe_water(folder)) sentences.push_back(sentence);
  format_comparisons(run.comparisons, sentences);
  for (const Factor& factor : factors) listed.push_back(to_json(factor));
  return {{"sentences", sentences}, {"factors", listed}, {"results", json::array()}};
}

}  // namespace talus::report
