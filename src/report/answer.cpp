#include "report/answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "report/look_up.hpp"

namespace talus::report {

using nlohmann::json;

namespace {

const ShownUnit metre{"m", 1};

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

std::string describe_meshes(const json& frozen) {
  std::string text;
  for (const json& m : find_list(frozen, {"meshes"}))
    text += fmt::format("{}{:.3f} at h = {:.3g} m", text.empty() ? "" : " and ", get_number(m, {"factor"}),
                        get_number(m, {"size"}));
  return text;
}

json list_factors(const json& summary) {
  json factors = json::array();
  const json* block = find(summary, {"factor_of_safety"});
  if (block == nullptr) return factors;
  if (const json* frozen = find(*block, {"frozen"})) {
    const double value = get_number(*frozen, {"factor"}), width = get_number(*frozen, {"uncertainty"});
    const bool extrapolated = find(*frozen, {"extrapolated"}) != nullptr;
    factors.push_back(make_factor(
        "frozen", value, value - width, value + width,
        fmt::format("{}{}; the bracket is that of the search on these meshes only", describe_meshes(*frozen),
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
  return factors;
}

void say_factor(const json& summary, const json& factors, json& sentences) {
  const auto found = std::find_if(factors.begin(), factors.end(), [](const json& f) { return f["main"] == true; });
  const json* main = found == factors.end() ? nullptr : &*found;
  if (main == nullptr) {
    if (!factors.empty()) sentences.push_back("No criterion found a factor of safety in the range that was tried.");
    return;
  }
  const double value = (*main)["value"].get<double>();
  const bool by_frozen = (*main)["name"] == "factor_of_safety.frozen";
  std::string text = fmt::format("The factor of safety is {:.3f}", value);
  if (by_frozen) {
    const json& frozen = summary["factor_of_safety"]["frozen"];
    const double low = get_number(frozen, {"dilatancy_angle_min"}), high = get_number(frozen, {"dilatancy_angle_max"});
    text += low == high ? fmt::format(" with a dilatancy angle of {:.3g}°", high)
                        : fmt::format(" with dilatancy angles from {:.3g}° to {:.3g}°", low, high);
    text += find(frozen, {"extrapolated"}) != nullptr
                ? fmt::format(": {}, extrapolated to h = 0.", describe_meshes(frozen))
                : fmt::format(": {}, on one mesh and not extrapolated; expect some percent less on a finer one.",
                              describe_meshes(frozen));
  } else {
    text += fmt::format(" by the criterion \"{}\".", (*main)["title"].get<std::string>());
  }
  sentences.push_back(text);
  if (value < 1) sentences.push_back("A factor below one: the slope does not stand with the given strength.");
}

/// Of a run, and of each trial that went on until rest.
void say_runout(const json& runout, std::size_t dimension, const std::string& where, const std::string& end,
                double time, std::optional<double> failure_time, json& sentences) {
  const double beyond = get_number(runout, {"toe_distance"});
  const std::string toe =
      beyond > 0 ? fmt::format("passes the toe by {}", show(beyond, metre)) : "stays behind the toe";
  sentences.push_back(
      fmt::format("{} the largest displacement is {}, the front advances {} and {}, the crest retreats {}, and {:.4g} "
                  "{} move; after "
                  "{:.3g} s the soil is {}.",
                  where, show(get_number(runout, {"largest_displacement"}), metre),
                  show(get_number(runout, {"front_advance"}), metre), toe,
                  show(get_number(runout, {"crest_retreat"}), metre), get_number(runout, {"moved_volume"}),
                  dimension == 2 ? "m³ per metre" : "m³", time, end == "rest" ? "at rest" : "still moving"));
  if (failure_time)
    sentences.push_back(
        fmt::format("Its largest displacement passed the share of the height that counts as failure after {:.3g} s.",
                    *failure_time));
}

void say_comparisons(const json& comparisons, json& sentences) {
  if (comparisons.empty()) return;
  std::size_t missed = 0, absent = 0;
  for (const json& c : comparisons) {
    if (find_number(c, {"computed"}))
      missed += c.value("passes", false) ? 0u : 1u;
    else
      ++absent;
  }
  const std::size_t all = comparisons.size();
  std::string text =
      missed == 0 && absent == 0
          ? fmt::format("All {} comparisons that the case names are inside their bands.", all)
          : fmt::format("Of {} comparisons that the case names, {} inside {} and {} outside", all,
                        all - missed - absent == 1 ? "1 is" : fmt::format("{} are", all - missed - absent), "the band",
                        missed);
  if (missed + absent > 0) text += absent > 0 ? fmt::format("; {} were not calculated.", absent) : ".";
  sentences.push_back(text);
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
  for (const json& f : list_factors(summary))
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
  say_factor(summary, factors, sentences);
  for (const json& r : find_list(summary, {"runouts"}))
    if (const json* runout = find(r, {"runout"}))
      say_runout(*runout, get_dimension(summary),
                 fmt::format("With the strength divided by {:g}", get_number(r, {"srf"})), get_text(r, {"end"}),
                 get_number(r, {"time"}), find_number(r, {"failure_time"}), sentences);
  if (const json* runout = find(summary, {"runout"})) {
    const json& stages = find_list(summary, {"stages"});
    static const json none = json::object();
    const json& last = stages.empty() ? none : stages.back();
    say_runout(*runout, get_dimension(summary), "At the end", get_text(last, {"end"}), get_number(last, {"time"}),
               find_number(summary, {"failure_time"}), sentences);
  }
  say_comparisons(find_list(summary, {"comparisons"}), sentences);
  return {{"sentences", sentences}, {"factors", factors}, {"results", find_list(summary, {"results"})}};
}

}  // namespace talus::report
