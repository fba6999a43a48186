#include "report/look_up.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/units.hpp"

namespace talus::report {

using nlohmann::json;

namespace {

double find_factor(const json& leaf) {
  const std::string unit = leaf.value("unit", "");
  return unit.empty() ? 1 : units::get_si_factor(unit);
}

/// The value of a leaf; nullptr when the key is absent or null.
const json* find_value(const json& table, const char* key) {
  return find(table, {key, "value"});
}

std::vector<double> scale(const json& list, double factor) {
  std::vector<double> values;
  for (const json& v : list) values.push_back(v.get<double>() * factor);
  return values;
}

}  // namespace

const json* find(const json& node, std::initializer_list<const char*> path) {
  const json* at = &node;
  for (const char* step : path) {
    if (!at->is_object() || !at->contains(step)) return nullptr;
    at = &at->at(step);
  }
  return at->is_null() ? nullptr : at;
}

const json& find_list(const json& node, std::initializer_list<const char*> path) {
  static const json empty = json::array();
  const json* found = find(node, path);
  return found != nullptr && found->is_array() ? *found : empty;
}

std::optional<double> find_number(const json& node, std::initializer_list<const char*> path) {
  const json* found = find(node, path);
  return found != nullptr && found->is_number() ? std::optional(found->get<double>()) : std::nullopt;
}

double get_number(const json& node, std::initializer_list<const char*> path, double otherwise) {
  return find_number(node, path).value_or(otherwise);
}

std::string get_text(const json& node, std::initializer_list<const char*> path, const std::string& otherwise) {
  const json* found = find(node, path);
  return found != nullptr && found->is_string() ? found->get<std::string>() : otherwise;
}

std::optional<double> find_si(const json& table, const char* key) {
  const json* value = find_value(table, key);
  if (value == nullptr || !value->is_number()) return std::nullopt;
  return value->get<double>() * find_factor(table.at(key));
}

double get_si(const json& table, const char* key, double otherwise) {
  return find_si(table, key).value_or(otherwise);
}

std::vector<double> get_si_vector(const json& table, const char* key) {
  const json* value = find_value(table, key);
  return value == nullptr || !value->is_array() ? std::vector<double>{} : scale(*value, find_factor(table.at(key)));
}

std::vector<std::vector<double>> get_si_points(const json& table, const char* key) {
  std::vector<std::vector<double>> points;
  const json* value = find_value(table, key);
  if (value == nullptr || !value->is_array()) return points;
  const double factor = find_factor(table.at(key));
  for (const json& point : *value) points.push_back(scale(point, factor));
  return points;
}

std::string get_word(const json& table, const char* key, const std::string& otherwise) {
  return get_text(table, {key, "value"}, otherwise);
}

bool get_flag(const json& table, const char* key, bool otherwise) {
  const json* value = find_value(table, key);
  return value != nullptr && value->is_boolean() ? value->get<bool>() : otherwise;
}

std::size_t get_dimension(const json& summary) {
  const double given = get_number(summary, {"mesh", "dimension"}, 2);
  return given == 3 ? 3 : 2;
}

std::size_t get_dimension(const results::RunResult& run) {
  return run.mesh && run.mesh->dimension == 3 ? 3 : 2;
}

json to_json(const ShownUnit& unit) {
  return {{"name", unit.name}, {"si", unit.si}};
}

ShownUnits read_units(const json& summary) {
  ShownUnits shown;
  const auto read = [&](const char* key, ShownUnit& unit) {
    unit.name = get_text(summary, {"units", key}, unit.name);
    unit.si = units::get_si_factor(unit.name);
  };
  read("length", shown.length);
  read("displacement", shown.displacement);
  read("stress", shown.stress);
  return shown;
}

ShownUnits read_units(const results::RunResult& run) {
  const auto read = [](const std::string& name) { return ShownUnit{name, units::get_si_factor(name)}; };
  return {read(run.units.length), read(run.units.displacement), read(run.units.stress)};
}

std::string show_number(double value, int digits) {
  if (value == 0 || !std::isfinite(value)) return value == 0 ? "0" : "–";
  const double size = std::abs(value);
  std::string text = fmt::format("{:.{}g}", size, digits);
  if (const std::size_t e = text.find('e'); e != std::string::npos && size >= 1 && size < 1e7) {
    text = fmt::format("{:.0f}", size);
  } else if (e != std::string::npos) {
    static const char* const raised[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string power;
    for (const char c : std::to_string(std::stoi(text.substr(e + 1)))) power += c == '-' ? "⁻" : raised[c - '0'];
    text = text.substr(0, e) + " × 10" + power;
  }
  return (value < 0 ? "−" : "") + text;
}

std::string show(double si, const ShownUnit& unit, int digits) {
  return show_number(si / unit.si, digits) + " " + unit.name;
}

std::string join_words(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 < words.size() ? ", " : " and ") + words[i];
  return text;
}

}  // namespace talus::report
