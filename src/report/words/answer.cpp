#include "report/words/answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "report/content/asked_methods.hpp"
#include "report/content/method_table.hpp"
#include "report/content/soil_water.hpp"
#include "report/content/water_choices.hpp"
#include "report/look_up.hpp"
#include "report/words/water_words.hpp"

namespace talus::report {

using nlohmann::json;

namespace {

std::string to_title(const std::string& criterion) {
  static const std::map<std::string, std::string> titles{
      {"frozen", "rest or run-away at frozen geometry"},
      {"bilinear", "two lines on the displacement curve (moving geometry)"},
      {"displacement", "displacement reaches a share of the height (moving geometry)"},
      {"jump", "largest jump of the displacement (moving geometry)"},
  };
  const auto found = titles.find(criterion);
  return found != titles.end() ? found->second : criterion;
}

json make_factor(const std::string& criterion, const json& value, const json& lower, const json& upper,
                 const std::string& note) {
  return {{"method", "mpm"},
          {"name", "factor_of_safety." + criterion},
          {"title", to_title(criterion)},
          {"value", value},
          {"lower", lower},
          {"upper", upper},
          {"note", note},
          {"main", false}};
}

std::string describe_meshes(const json& frozen, const ShownUnit& length) {
  std::vector<std::string> parts;
  for (const json& m : find_list(frozen, {"meshes"}))
    parts.push_back(fmt::format("{:.3f} at h = {}", get_number(m, {"factor"}), show(get_number(m, {"size"}), length)));
  return join_words(parts);
}

/// Factors by material points.
json list_own_factors(const json& summary) {
  json factors = json::array();
  const json* block = find(summary, {"factor_of_safety"});
  if (block == nullptr) return factors;
  if (const json* frozen = find(*block, {"frozen"})) {
    const double value = get_number(*frozen, {"factor"}), width = get_number(*frozen, {"uncertainty"});
    const bool extrapolated = find(*frozen, {"extrapolated"}) != nullptr;
    factors.push_back(
        make_factor("frozen", value, value - width, value + width,
                    fmt::format("{}{}; the bracket is that of the search on these meshes only",
                                describe_meshes(*frozen, read_units(summary).length),
                                extrapolated ? ", extrapolated to h = 0" : ", one mesh, not extrapolated")));
  }
  for (const json& c : find_list(*block, {"criteria"})) {
    const auto factor = find_number(c, {"factor"});
    const auto end = [&](const char* key) { return factor ? json(get_number(c, {key}, *factor)) : json(); };
    factors.push_back(make_factor(get_text(c, {"name"}), factor ? json(*factor) : json(), end("lower"), end("upper"),
                                  get_text(c, {"note"})));
  }
  for (json& f : factors) {
    if (f["value"].is_null()) continue;
    f["main"] = true;
    break;
  }
  if (is_wet(summary))
    for (json& f : factors) {
      const std::string water =
          find_water_of_trials(summary, f["name"] == "factor_of_safety.frozen" ? "frozen" : "curve");
      if (!water.empty()) f["water"] = water;
    }
  return factors;
}

/// By slices, by finite elements, by material points.
json list_factors(const json& summary) {
  json factors = list_other_factors(summary);
  for (json& factor : list_own_factors(summary)) factors.push_back(std::move(factor));
  return factors;
}

constexpr const char* too_low = "A factor below one: the slope does not stand with the given strength.";

/// What the other methods found, and how they differ.
void say_methods(const json& summary, const json& factors, json& sentences) {
  const std::string sentence = say_main_factors(summary, factors);
  if (sentence.empty()) {
    sentences.push_back("No method found a factor of safety.");
    return;
  }
  sentences.push_back(sentence);
  // Of design values the statement on partial factors says it.
  if (!has_design_values(summary) && std::any_of(factors.begin(), factors.end(), [](const json& f) {
        return f["main"] == true && f["value"].get<double>() < 1;
      }))
    sentences.push_back(too_low);
  for (const std::string& said : {say_agreement(factors), say_weakest_surface(factors),
                                  get_text(summary, {"methods", "partial_factors", "text"})})
    if (!said.empty()) sentences.push_back(said);
}

/// Of material points. `lone`: no other method was asked; the table of the methods has the details otherwise.
void say_factor(const json& summary, const json& factors, bool lone, json& sentences) {
  const auto found = std::find_if(factors.begin(), factors.end(), [](const json& f) { return f["main"] == true; });
  if (found == factors.end()) {
    if (!factors.empty())
      sentences.push_back(fmt::format("No criterion {}found a factor of safety in the range that was tried.",
                                      lone ? "" : "of the material points "));
    return;
  }
  if (!lone) return;
  const double value = (*found)["value"].get<double>();
  const bool by_frozen = (*found)["name"] == "factor_of_safety.frozen";
  std::string text = fmt::format("The factor of safety is {:.3f}", value);
  if (by_frozen) {
    const json& frozen = summary["factor_of_safety"]["frozen"];
    const ShownUnit length = read_units(summary).length;
    const double low = get_number(frozen, {"dilatancy_angle_min"}), high = get_number(frozen, {"dilatancy_angle_max"});
    text += low == high ? fmt::format(" with a dilatancy angle of {:.3g}°", high)
                        : fmt::format(" with dilatancy angles from {:.3g}° to {:.3g}°", low, high);
    if (found->contains("water"))
      text +=
          (*found)["water"] == "held" ? " and pore pressures held (drained)" : " and pore water that flows (coupled)";
    text += find(frozen, {"extrapolated"}) != nullptr
                ? fmt::format(": {}, extrapolated to h = 0.", describe_meshes(frozen, length))
                : fmt::format(": {}, on one mesh and not extrapolated; expect some percent less on a finer one.",
                              describe_meshes(frozen, length));
  } else {
    text += fmt::format(" by the criterion \"{}\".", (*found)["title"].get<std::string>());
  }
  sentences.push_back(text);
  if (value < 1) sentences.push_back(too_low);
}

/// What has become of the soil when a calculation ended.
std::string describe_end(const json& report) {
  const double time = get_number(report, {"time"});
  if (get_text(report, {"end"}) == "rest") return fmt::format("after {} s the soil is at rest", show_number(time));
  const auto force = find_number(report, {"force_ratio"});
  return fmt::format("the time was up after {} s{}", show_number(time),
                     force ? ", with an unbalanced force of " + show_number(*force, 2) + " of gravity" : "");
}

/// Of a run, and of each trial that went on until rest.
class RunoutWords {
 public:
  RunoutWords(const json& summary, json& sentences)
      : length_(read_units(summary).length),
        volume_(get_dimension(summary) == 2 ? "m³ per metre" : "m³"),
        sentences_(sentences) {}

  void say(const json& runout, const std::string& where, const json& end, std::optional<double> failure_time) {
    const double moved = get_number(runout, {"moved_volume"});
    const std::string largest =
        fmt::format("{} the largest displacement is {}", where, length(get_number(runout, {"largest_displacement"})));
    if (moved > 0)
      sentences_.push_back(fmt::format("{}, {}, {}, and {} {} move; {}.", largest, describe_front(runout),
                                       describe_crest(runout), show_number(moved, 4), volume_, describe_end(end)));
    else
      sentences_.push_back(
          fmt::format("{}: no soil moves further than 1 % of the height; {}.", largest, describe_end(end)));
    if (failure_time)
      sentences_.push_back(
          fmt::format("Its largest displacement passed the share of the height that counts as failure after {} s.",
                      show_number(*failure_time)));
  }

 private:
  std::string length(double metres) const { return show(metres, length_); }

  std::string describe_front(const json& runout) const {
    const double advance = get_number(runout, {"front_advance"}), beyond = get_number(runout, {"toe_distance"});
    return fmt::format("the front {} {} and {}", advance < 0 ? "goes back by" : "advances", length(std::abs(advance)),
                       beyond > 0 ? "passes the toe by " + length(beyond) : "stays behind the toe");
  }
  std::string describe_crest(const json& runout) const {
    const double retreat = get_number(runout, {"crest_retreat"});
    return retreat > 0 ? "the crest retreats " + length(retreat) : "the crest stays";
  }

  ShownUnit length_;
  std::string volume_;
  json& sentences_;
};

bool has_lost_all(const json& summary) {
  return get_number(summary, {"budgets", "lost", "points"}) > 0 && get_number(summary, {"budgets", "points"}) <= 0;
}

/// The results, without the zeros that a runout without any soil comes to.
json list_results(const json& summary) {
  json results = json::array();
  for (const json& r : find_list(summary, {"results"}))
    if (!has_lost_all(summary) || !get_text(r, {"name"}).starts_with("runout.")) results.push_back(r);
  return results;
}

/// Points that left the grid are in no number of the answer. Returns whether any soil is left.
bool say_lost(const json& summary, json& sentences) {
  const double lost = get_number(summary, {"budgets", "lost", "points"});
  if (lost <= 0) return true;
  const double left = get_number(summary, {"budgets", "points"});
  if (has_lost_all(summary)) {
    sentences.push_back("All soil has left the grid: nothing is there to be measured.");
    return false;
  }
  const double mass = get_number(summary, {"budgets", "lost", "mass"});
  const double share = 100 * mass / (mass + get_number(summary, {"budgets", "mass"}));
  sentences.push_back(fmt::format(
      "{:.0f} of {:.0f} points, {} % of the mass, left the grid: what is said of the soil holds for the rest of it.",
      lost, lost + left, show_number(share, 2)));
  return true;
}

void say_runouts(const json& summary, json& sentences) {
  static const json none = json::object();
  RunoutWords words(summary, sentences);
  for (const json& r : find_list(summary, {"runouts"}))
    if (const json* runout = find(r, {"runout"}))
      words.say(*runout, "With the strength divided by " + show_number(get_number(r, {"srf"}), 6), r,
                find_number(r, {"failure_time"}));
  const json* runout = find(summary, {"runout"});
  if (!say_lost(summary, sentences) || runout == nullptr) return;
  const json& stages = find_list(summary, {"stages"});
  words.say(*runout, "At the end", stages.empty() ? none : stages.back(), find_number(summary, {"failure_time"}));
}

void say_comparisons(const json& comparisons, json& sentences) {
  std::size_t inside = 0, outside = 0, absent = 0;
  for (const json& c : comparisons)
    ++(!find_number(c, {"computed"}) ? absent : c.value("passes", false) ? inside : outside);
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

void say_state(const ResultFolder& folder, json& sentences) {
  const std::string status = find_status(folder.summary);
  const std::string reason = get_text(folder.summary, {"error"});
  if (status == "finished") return;
  if (status == "unfinished") {
    sentences.push_back(
        "This run has not finished: it still goes on or was ended from outside. The report shows what is in its "
        "folder.");
    return;
  }
  const char* how = status == "interrupted" ? "was interrupted" : status == "unstable" ? "became unstable" : "failed";
  sentences.push_back(fmt::format("This run {}, and its answer is incomplete{}{}", how, reason.empty() ? "." : ": ",
                                  reason.empty() || reason.ends_with('.') ? reason : reason + "."));
}

}  // namespace

std::optional<double> find_main_factor(const json& summary) {
  for (const json& factors : {list_own_factors(summary), list_other_factors(summary)})
    for (const json& f : factors)
      if (f["main"] == true) return f["value"].get<double>();
  return std::nullopt;
}

std::string find_status(const json& summary) {
  const std::string status = get_text(summary, {"status"}, "unfinished");
  for (const char* known : {"finished", "interrupted", "unstable", "failed"})
    if (status == known) return status;
  return "unfinished";
}

json make_answer(const ResultFolder& folder) {
  const json& summary = folder.summary;
  const json factors = list_factors(summary);
  json sentences = json::array();
  say_state(folder, sentences);
  const bool lone = !asks_for(summary, "lem") && !asks_for(summary, "fem");
  if (!lone) say_methods(summary, factors, sentences);
  say_factor(summary, list_own_factors(summary), lone, sentences);
  say_runouts(summary, sentences);
  if (const std::string motion = get_text(summary, {"motion", "sentence"}); !motion.empty())
    sentences.push_back(motion);
  for (const std::string& sentence : tell_water(summary)) sentences.push_back(sentence);
  say_comparisons(find_list(summary, {"comparisons"}), sentences);
  return {{"sentences", sentences}, {"factors", factors}, {"results", list_results(summary)}};
}

}  // namespace talus::report
