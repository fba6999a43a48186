#include "report/content/method_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "report/content/asked_methods.hpp"
#include "report/look_up.hpp"

namespace talus::report {

using nlohmann::json;

namespace {

/// null for what is absent, no number, or no factor.
json take_factor(const json& node, const char* key) {
  const auto value = find_number(node, {key});
  return value && *value > 0 ? json(*value) : json();
}

json take_row(const json& row) {
  json taken;
  for (const char* key : {"method", "name", "title", "criterion", "surface", "note"}) taken[key] = get_text(row, {key});
  for (const char* key : {"factor", "lower", "upper"}) taken[key] = take_factor(row, key);
  const auto seconds = find_number(row, {"seconds"});
  taken["seconds"] = seconds ? json(*seconds) : json();
  return taken;
}

json take_partial_factors(const json& block) {
  struct Name {
    const char *key, *title, *symbol;
  };
  static constexpr std::array names{Name{"cohesion", "effective cohesion, divided by", "γ_c"},
                                    Name{"friction", "tan φ, divided by", "γ_φ"},
                                    Name{"undrained", "undrained strength, divided by", "γ_cu"},
                                    Name{"weight", "unit weight, divided by", "γ_γ"},
                                    Name{"permanent_load", "permanent loads, multiplied by", "γ_G"},
                                    Name{"variable_load", "variable loads, multiplied by", "γ_Q"},
                                    Name{"resistance", "factor of safety, divided by", "γ_R"}};
  json values = json::array(), materials = json::array();
  for (const json& v : find_list(block, {"values"}))
    values.push_back({{"key", get_text(v, {"key"})},
                      {"title", get_text(v, {"title"})},
                      {"symbol", get_text(v, {"symbol"})},
                      {"value", get_number(v, {"value"})}});
  for (const json& m : find_list(block, {"materials"})) {
    json row;
    for (const char* key : {"material", "quantity", "symbol", "unit"}) row[key] = get_text(m, {key});
    for (const char* key : {"characteristic", "design"}) row[key] = get_number(m, {key});
    materials.push_back(std::move(row));
  }
  for (const Name& n : names)
    if (const auto value = find_number(block, {"values", n.key}))
      values.push_back({{"key", n.key}, {"title", n.title}, {"symbol", n.symbol}, {"value", *value}});
  return {{"set", get_text(block, {"set"})},
          {"values", values},
          {"materials", materials},
          {"notes", find_list(block, {"notes"})},
          {"over_design", take_factor(block, "over_design")},
          {"text", get_text(block, {"text"})}};
}

/// "Spencer, critical circle".
std::string describe(const json& row) {
  std::string title = get_text(row, {"title"});
  const std::string criterion = get_text(row, {"criterion"});
  // The method stands before it already.
  if (title == "Finite elements") title.clear();
  if (title.starts_with("Finite elements, ")) title.erase(0, std::string("Finite elements, ").size());
  return criterion.empty() || title.empty() ? title + criterion : title + ", " + criterion;
}

/// As comparisons name it: "lem.noncircular.spencer", "lem.handed[fem.band].spencer", "fem.by_displacement".
std::string name_result(const json& row) {
  const std::string name = get_text(row, {"name"}), surface = get_text(row, {"surface"});
  if (get_text(row, {"method"}) == "lem") {
    if (surface.empty()) return "lem." + name;
    return surface.starts_with("lem.") ? surface : fmt::format("lem.handed[{}].{}", surface, name);
  }
  const std::string stem = name == "associated" ? "fem.associated." : "fem.";
  return stem + (get_text(row, {"criterion"}).starts_with("displacement") ? "by_displacement" : "factor");
}

/// A surface that slices found themselves, not one that they were given.
bool is_critical(const json& row) {
  const std::string surface = get_text(row, {"surface"});
  return surface.starts_with("lem.") && !surface.starts_with("lem.surface[") && !surface.starts_with("lem.handed[");
}

const char* name_method(const std::string& method) {
  return method == "lem" ? "slices" : method == "fem" ? "finite elements" : "material points";
}

/// The factor that stands for its method in the answer.
void mark_main(json& factors, const std::string& method, const std::vector<std::string_view>& wanted) {
  json* main = nullptr;
  std::size_t best = wanted.size() + 1;
  for (json& factor : factors) {
    if (factor["method"] != method || factor["value"].is_null()) continue;
    const std::string whole = factor["name"], name = whole.substr(whole.rfind('.') + 1);
    const auto rank =
        static_cast<std::size_t>(std::find(wanted.begin(), wanted.end(), std::string_view(name)) - wanted.begin());
    if (rank >= best) continue;
    best = rank;
    main = &factor;
  }
  if (main != nullptr) (*main)["main"] = true;
}

/// "to 0.4 %", "to three digits".
std::string format_closeness(double difference) {
  const double percent = 100 * std::abs(difference);
  return percent < 0.05 ? "to three digits" : fmt::format("to {:.1f} %", percent);
}

/// What a sentence of the comparison is about, by how it begins.
const char* find_topic(const std::string& sentence) {
  struct Beginning {
    const char *text, *topic;
  };
  static constexpr const char *slices = "Slices", *elements = "Finite elements", *points = "Material points",
                              *mechanism = "Mechanism";
  static constexpr std::array beginnings{
      Beginning{"Bishop", slices},
      Beginning{"Simplified Janbu", slices},
      Beginning{"The best polyline", slices},
      Beginning{"The search of the slices", slices},
      Beginning{"Suction gives", slices},
      Beginning{"Finite elements", elements},
      Beginning{"The finite elements", elements},
      Beginning{"The flow rule", elements},
      Beginning{"With ψ", elements},
      Beginning{"Material points", points},
      Beginning{"The criterion", points},
      Beginning{"The bilinear construction", points},
      Beginning{"One mechanism", mechanism},
      Beginning{"The band", mechanism},
      Beginning{"The slip line", mechanism},
      Beginning{"Computing time", "Computing time"},
  };
  for (const Beginning& b : beginnings)
    if (sentence.starts_with(b.text)) return b.topic;
  return "Agreement";
}

/// In the order of the topics' first sentences.
json group_reading(const json& sentences) {
  json groups = json::array();
  for (const json& sentence : sentences) {
    const std::string topic = find_topic(sentence);
    const auto found = std::find_if(groups.begin(), groups.end(), [&](const json& g) { return g["topic"] == topic; });
    json& group = found != groups.end() ? *found : groups.emplace_back(json{{"topic", topic}});
    group["sentences"].push_back(sentence);
  }
  return groups;
}

}  // namespace

json make_method_table(const json& summary) {
  const json* block = find(summary, {"methods"});
  if (block == nullptr || (!asks_for(summary, "lem") && !asks_for(summary, "fem"))) return {};
  json table{{"asked", find_list(*block, {"asked"})},
             {"rows", json::array()},
             {"surfaces", json::array()},
             {"handed", json::array()},
             {"reading", group_reading(find_list(*block, {"reading"}))}};
  for (const json& row : find_list(*block, {"table"})) table["rows"].push_back(take_row(row));
  for (const json& s : find_list(*block, {"surfaces"}))
    table["surfaces"].push_back({{"name", get_text(s, {"name"})},
                                 {"title", get_text(s, {"title"})},
                                 {"method", get_text(s, {"method"})},
                                 {"factor", take_factor(s, "factor")},
                                 {"points", find_list(s, {"points"})}});
  for (const json& h : find_list(*block, {"handed"}))
    table["handed"].push_back({{"from", get_text(h, {"from"})},
                               {"to", get_text(h, {"to"})},
                               {"title", get_text(h, {"title"})},
                               {"factor", take_factor(h, "factor")},
                               {"refusal", get_text(h, {"refusal"})}});
  if (const json* partial = find(*block, {"partial_factors"}); partial != nullptr && partial->is_object())
    table["partial_factors"] = take_partial_factors(*partial);
  return table;
}

json list_other_factors(const json& summary) {
  json factors = json::array();
  const json& rows = find_list(summary, {"methods", "table"});
  const bool has_critical = std::any_of(rows.begin(), rows.end(), is_critical);
  for (const json& row : rows) {
    const std::string method = get_text(row, {"method"});
    if (method != "lem" && method != "fem") continue;
    if (method == "lem" && !is_critical(row) && has_critical) continue;
    factors.push_back({{"method", method},
                       {"name", name_result(row)},
                       {"title", describe(row)},
                       {"value", take_factor(row, "factor")},
                       {"lower", take_factor(row, "lower")},
                       {"upper", take_factor(row, "upper")},
                       {"note", get_text(row, {"note"})},
                       {"main", false}});
  }
  mark_main(factors, "lem", {"spencer", "morgenstern_price", "morgenstern_price_constant", "bishop"});
  mark_main(factors, "fem", {"factor"});
  return factors;
}

std::string say_main_factors(const json& summary, const json& factors) {
  std::vector<std::string> parts;
  for (const json& factor : factors)
    if (factor["main"] == true)
      parts.push_back(fmt::format("{:.3f} by {} ({})", factor["value"].get<double>(),
                                  name_method(factor["method"].get<std::string>()),
                                  factor["title"].get<std::string>()));
  if (parts.empty()) return "";
  return fmt::format("The factor of safety{} is {}.", has_design_values(summary) ? " with design values" : "",
                     join_words(parts));
}

std::string say_agreement(const json& factors) {
  // Less is not worth a reason.
  constexpr double close = 0.02;
  std::vector<double> values;
  const json *given = nullptr, *associated = nullptr, *points = nullptr;
  for (const json& factor : factors) {
    if (factor["value"].is_null()) continue;
    if (factor["main"] == true) values.push_back(factor["value"]);
    if (factor["name"] == "fem.factor") given = &factor;
    if (factor["name"] == "fem.associated.factor") associated = &factor;
    if (factor["name"] == "factor_of_safety.frozen") points = &factor;
  }
  if (values.size() < 2) return "";
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double spread = *high / *low - 1;
  if (spread < close)
    return fmt::format("The {} methods agree {}.", values.size() == 2 ? "two" : "three", format_closeness(spread));
  std::vector<std::string> reasons;
  if (given != nullptr && associated != nullptr) {
    const double a = (*given)["value"], b = (*associated)["value"];
    if (std::abs(a / b - 1) > close / 2)
      reasons.push_back(
          fmt::format("the flow rule alone makes {:.1f} % in the finite elements ({:.3f} as given, {:.3f} with ψ = φ), "
                      "and slices know none",
                      100 * std::abs(a / b - 1), a, b));
  }
  if (points != nullptr && (*points)["note"].get<std::string>().find("not extrapolated") != std::string::npos)
    reasons.push_back("material points are those of one mesh, not extrapolated");
  return fmt::format("The methods lie within {:.1f} % of each other{}{}.", 100 * spread, reasons.empty() ? "" : "; ",
                     fmt::join(reasons, "; "));
}

std::string say_weakest_surface(const json& factors) {
  // Other methods leave a part of the equilibrium out: a lower factor of theirs says less.
  constexpr double noticed = 0.995;
  const json *main = nullptr, *weakest = nullptr;
  for (const json& factor : factors) {
    if (factor["method"] != "lem" || factor["value"].is_null()) continue;
    if (factor["main"] == true) main = &factor;
    const std::string name = factor["name"];
    if (!name.ends_with(".spencer") && name.find(".morgenstern_price") == std::string::npos) continue;
    if (weakest == nullptr || factor["value"] < (*weakest)["value"]) weakest = &factor;
  }
  if (main == nullptr || weakest == nullptr ||
      (*weakest)["value"].get<double>() > noticed * (*main)["value"].get<double>())
    return "";
  return fmt::format("The weakest surface by a method that satisfies all equilibrium has {:.3f} ({}).",
                     (*weakest)["value"].get<double>(), (*weakest)["title"].get<std::string>());
}

bool has_design_values(const json& summary) {
  const json* partial = find(summary, {"methods", "partial_factors"});
  return partial != nullptr && partial->is_object();
}

}  // namespace talus::report
