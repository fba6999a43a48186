#include "report/content/sampling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>

#include "report/look_up.hpp"

namespace talus::report {

using nlohmann::json;

namespace {

using Keys = std::initializer_list<const char*>;

/// Numbers that are there; null for the others.
void take_numbers(const json& from, Keys keys, json& to) {
  for (const char* key : keys) {
    const auto value = find_number(from, {key});
    to[key] = value ? json(*value) : json();
  }
}

/// Counts and shares, which are always there.
void take_counts(const json& from, Keys keys, json& to) {
  for (const char* key : keys) to[key] = get_number(from, {key});
}

void take_texts(const json& from, Keys keys, json& to) {
  for (const char* key : keys) to[key] = get_text(from, {key});
}

json list_numbers(const json& block) {
  json list = json::array();
  for (const json& n : find_list(block, {"numbers"})) {
    json row, sampled;
    take_texts(n, {"key", "name", "unit", "distribution", "text"}, row);
    take_numbers(n, {"mean", "deviation"}, row);
    take_numbers(n.value("sampled", json::object()), {"mean", "deviation", "smallest", "largest"}, sampled);
    row["sampled"] = std::move(sampled);
    list.push_back(std::move(row));
  }
  return list;
}

json list_correlations(const json& block) {
  json list = json::array();
  for (const json& c : find_list(block, {"correlations"})) {
    json row{{"keys", find_list(c, {"keys"})}, {"asked", get_number(c, {"asked"})}};
    take_numbers(c, {"sampled"}, row);
    list.push_back(std::move(row));
  }
  return list;
}

json take_values(const json& values) {
  json taken, quantiles = json::array();
  take_counts(values, {"count", "none"}, taken);
  take_numbers(values, {"mean", "deviation", "skewness", "smallest", "largest"}, taken);
  for (const json& q : find_list(values, {"quantiles"})) {
    json row{{"share", get_number(q, {"share"})}};
    take_numbers(q, {"value"}, row);
    quantiles.push_back(std::move(row));
  }
  taken["quantiles"] = quantiles;
  taken["histogram"] = {{"edges", find_list(values, {"histogram", "edges"})},
                        {"counts", find_list(values, {"histogram", "counts"})}};
  return taken;
}

json list_ranks(const json& block) {
  json list = json::array();
  for (const json& r : find_list(block, {"ranks"})) {
    json row;
    take_texts(r, {"name"}, row);
    take_numbers(r, {"coefficient"}, row);
    list.push_back(std::move(row));
  }
  return list;
}

json take_failure(const json& failure) {
  json taken{{"interval", get_text(failure, {"interval"})}, {"growth", find_list(failure, {"growth"})}};
  take_counts(failure, {"limit", "count", "samples", "probability", "lower", "upper", "confidence"}, taken);
  take_numbers(failure, {"index", "index_lower", "index_upper", "standard_error"}, taken);
  return taken;
}

json take_design_point(const json& point) {
  json taken{{"converged", point.value("converged", false)}}, values = json::array();
  take_numbers(point, {"index", "probability"}, taken);
  for (const json& v : find_list(point, {"values"})) {
    json row;
    take_texts(v, {"name", "unit"}, row);
    take_numbers(v, {"value", "importance"}, row);
    values.push_back(std::move(row));
  }
  taken["values"] = values;
  return taken;
}

json take_runout(const json& runout) {
  json taken = take_values(runout), exceedance = json::array();
  taken["unit"] = get_text(runout, {"unit"}, "m");
  taken["curve"] = find_list(runout, {"curve"});
  taken["ranks"] = list_ranks(runout);
  for (const json& e : find_list(runout, {"exceedance"})) {
    json row;
    take_counts(e, {"distance", "count", "samples", "probability", "lower", "upper"}, row);
    exceedance.push_back(std::move(row));
  }
  taken["exceedance"] = exceedance;
  return taken;
}

/// "2.4 %", "0.031 %", "0".
std::string show_share(double share) {
  return share == 0 ? "0" : show_number(100 * share, 2) + " %";
}

}  // namespace

json make_sampling(const json& block) {
  json taken{{"numbers", list_numbers(block)},
             {"correlations", list_correlations(block)},
             {"tornado", json::array()},
             {"ranks", list_ranks(block)},
             {"notes", find_list(block, {"notes"})}};
  take_counts(block, {"samples", "seed", "replicates", "seconds", "surfaces"}, taken);
  take_texts(block, {"plan", "method", "method_title"}, taken);
  for (const json& bar : find_list(block, {"tornado"})) {
    json row;
    take_texts(bar, {"name", "unit"}, row);
    take_numbers(bar, {"low_value", "high_value", "low_factor", "high_factor"}, row);
    taken["tornado"].push_back(std::move(row));
  }
  if (const json* factor = find(block, {"factor"})) taken["factor"] = take_values(*factor);
  if (const json* failure = find(block, {"failure"})) taken["failure"] = take_failure(*failure);
  if (const json* point = find(block, {"design_point"})) taken["design_point"] = take_design_point(*point);
  if (const json* runout = find(block, {"runout"})) taken["runout"] = take_runout(*runout);
  if (const json* first = find(block, {"first_order"})) {
    json row;
    take_numbers(*first, {"mean_factor", "deviation", "index_normal", "index_lognormal"}, row);
    taken["first_order"] = std::move(row);
  }
  if (const json* fits = find(block, {"fits"})) {
    taken["fits"] = json::array();
    for (const char* name : {"normal", "lognormal"}) {
      const json* fit = find(*fits, {name});
      if (fit == nullptr) continue;
      json row{{"name", name}};
      take_numbers(*fit, {"index", "probability"}, row);
      taken["fits"].push_back(std::move(row));
    }
  }
  return taken;
}

void say_sampling(const json& block, json& sentences) {
  if (const json* failure = find(block, {"failure"})) {
    const auto index = find_number(*failure, {"index"});
    sentences.push_back(
        fmt::format("The probability of failure is {}, between {} and {} with {:g} % confidence{}.",
                    show_share(get_number(*failure, {"probability"})), show_share(get_number(*failure, {"lower"})),
                    show_share(get_number(*failure, {"upper"})), 100 * get_number(*failure, {"confidence"}, 0.95),
                    index ? fmt::format("; the reliability index is {:.2f}", *index) : ""));
  }
  if (const json* factor = find(block, {"factor"}))
    sentences.push_back(fmt::format(
        "The factor of safety of {:.0f} samples has the mean {:.3f} and the standard deviation {:.3f}; {:.3f} is the "
        "smallest, {:.3f} the largest.",
        get_number(*factor, {"count"}), get_number(*factor, {"mean"}), get_number(*factor, {"deviation"}),
        get_number(*factor, {"smallest"}), get_number(*factor, {"largest"})));
  if (const json* runout = find(block, {"runout"}))
    for (const json& e : find_list(*runout, {"exceedance"}))
      sentences.push_back(fmt::format("The soil comes farther than {} m with a probability of {} ({} to {}).",
                                      show_number(get_number(e, {"distance"})),
                                      show_share(get_number(e, {"probability"})), show_share(get_number(e, {"lower"})),
                                      show_share(get_number(e, {"upper"}))));
  if (const json& bars = find_list(block, {"tornado"}); !bars.empty()) {
    std::string name = get_text(bars[0], {"name"});
    std::replace(name.begin(), name.end(), '_', ' ');
    sentences.push_back(fmt::format("The factor depends most on the {}.", name));
  }
  sentences.push_back(
      fmt::format("{:.0f} samples by {}{}, seed {:.0f}; {} s.", get_number(block, {"samples"}),
                  get_text(block, {"plan"}) == "random" ? "random drawing" : "Latin hypercube",
                  get_text(block, {"method_title"}).empty() ? "" : ", " + get_text(block, {"method_title"}),
                  get_number(block, {"seed"}), show_number(get_number(block, {"seconds"}))));
}

}  // namespace talus::report
