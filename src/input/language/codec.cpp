// SPDX-License-Identifier: MIT
#include "input/language/codec.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <sstream>

#include "base/numbers.hpp"
#include "base/text.hpp"
#include "base/units.hpp"

namespace talus::input {
namespace {

using nlohmann::json;

std::string name_type(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "a list";
    case toml::node_type::string:
      return "a text";
    case toml::node_type::integer:
      return "a whole number";
    case toml::node_type::floating_point:
      return "a number";
    case toml::node_type::boolean:
      return "a truth value";
    default:
      return "a date or time";
  }
}

std::string write_unit(const Spec& spec) {
  return spec.unit.empty() ? "" : " [" + spec.unit + "]";
}

/// Limit on the entries of a list: points of a section, rows of a table.
constexpr std::size_t most_entries = 10000;

/// Returns a list of `least` to `most` entries; nullptr and a finding otherwise.
const toml::array* find_list(const Decoding& in, std::size_t least, std::size_t most, const std::string& wanted) {
  const toml::array* list = in.node.as_array();
  if (list == nullptr || list->size() < least || list->size() > most) {
    in.fail_type(wanted);
    return nullptr;
  }
  if (list->size() > most_entries) {
    in.fail("'{}' has {} entries, and at most {} are read; a table in time may stand in a CSV file", in.key,
            list->size(), most_entries);
    return nullptr;
  }
  return list;
}

bool decode_point(const Decoding& in, std::array<double, 2>& out) {
  std::vector<double> xy;
  const toml::array* list = in.node.as_array();
  // [4,98, 5] is a point whose x was written with a decimal comma.
  if (list != nullptr && (list->size() == 3 || list->size() == 4) && list->is_homogeneous<int64_t>())
    return in.fail("'{}' must be points [x, y], not a list of {}; decimals have a point, not a comma", in.key,
                   list->size());
  if (!decode_numbers(in, 2, 2, "points [x, y]", xy)) return false;
  in.record();
  out = {xy[0], xy[1]};
  return true;
}

}  // namespace

bool Decoding::fail(const std::string& sentence) const {
  const toml::source_position at = node.source().begin;
  findings.add_at(findings.places.locate(path, static_cast<int>(at.line), static_cast<int>(at.column)), path, sentence);
  return false;
}

bool Decoding::fail_type(const std::string& wanted) const {
  const toml::array* list = node.as_array();
  const std::string given = list == nullptr ? name_type(node) : fmt::format("a list of {}", list->size());
  return fail("'{}' must be {}, not {}", key, wanted, given);
}

void Decoding::record() const {
  const toml::source_position at = node.source().begin;
  findings.places.record(path, static_cast<int>(at.line), static_cast<int>(at.column));
}

std::string write_toml(const json& value) {
  if (value.is_number_float()) return fmt::format("{:.15g}", value.get<double>());
  if (!value.is_array()) return value.dump();
  std::string text;
  for (const json& item : value) text += (text.empty() ? "" : ", ") + write_toml(item);
  return "[" + text + "]";
}

std::string write_toml(const toml::node& node) {
  if (const auto* text = node.as_string()) return json(text->get()).dump();
  if (const auto* number = node.as_floating_point()) {
    std::string text = fmt::format("{}", number->get());
    return text.find_first_of(".einf") == std::string::npos ? text + ".0" : text;
  }
  if (const auto* list = node.as_array()) {
    std::string text;
    for (const toml::node& item : *list) text += (text.empty() ? "" : ", ") + write_toml(item);
    return "[" + text + "]";
  }
  if (const auto* table = node.as_table()) {
    std::string text;
    for (const auto& [key, item] : *table)
      text += (text.empty() ? "" : ", ") + json(std::string(key.str())).dump() + " = " + write_toml(item);
    return "{ " + text + " }";
  }
  if (const auto* number = node.as_integer()) return std::to_string(number->get());
  if (const auto* truth = node.as_boolean()) return truth->get() ? "true" : "false";
  std::ostringstream date;
  if (const auto* day = node.as_date()) date << day->get();
  if (const auto* time = node.as_date_time()) date << time->get();
  return date.str();
}

bool decode_number(const Decoding& in, double& out) {
  const std::string& unit = in.spec.unit;
  double value = 0;
  double shown = 0;  // in the unit of the manual, as the range is
  if (const auto number = in.node.value<double>(); number && !in.node.is_boolean()) {
    shown = *number;
    if (std::isnan(shown) || (std::isinf(shown) && !in.spec.allows_infinity))
      return in.fail("'{}' must be a finite number", in.key);
    value = unit.empty() ? shown : shown * units::get_si_factor(unit);
  } else if (const auto* text = in.node.as_string(); text != nullptr && !unit.empty()) {
    try {
      value = units::parse_as_si(text->get(), unit, in.key);
    } catch (const Error& error) {
      return in.fail(error.what());
    }
    shown = encode_number(value, in.spec).get<double>();
  } else {
    return in.fail_type(unit.empty()
                            ? "a number"
                            : fmt::format("{} (a number in {} or a text such as \"{}\")",
                                          units::get_dimension_name(unit), unit, units::get_dimension_example(unit)));
  }
  if (!in.spec.allows(shown))
    return in.fail("'{}' is {:.15g}{}; it must be {}", in.key, shown, unit.empty() ? "" : " " + unit,
                   in.spec.write_range());
  if (const std::string oddity = in.spec.find_oddity(in.path, shown, !in.node.is_string()); !oddity.empty())
    in.findings.warn(in.path, oddity);
  out = value;
  return true;
}

bool decode_numbers(const Decoding& in, std::size_t least, std::size_t most, const std::string& wanted,
                    std::vector<double>& out) {
  const toml::array* list = find_list(in, least, most, wanted);
  if (list == nullptr) return false;
  out.assign(list->size(), 0.0);
  bool is_good = true;
  for (std::size_t i = 0; i < list->size(); ++i) is_good = decode_number(in.item(i), out[i]) && is_good;
  return is_good;
}

bool decode_points(const Decoding& in, std::vector<std::array<double, 2>>& out) {
  const toml::array* list = find_list(in, 0, std::size_t(-1), "a list of points [x, y]");
  if (list == nullptr) return false;
  out.assign(list->size(), {});
  bool is_good = true;
  for (std::size_t i = 0; i < list->size(); ++i) is_good = decode_point(in.item(i), out[i]) && is_good;
  return is_good;
}

bool decode_word(const Decoding& in, const std::vector<std::string>& words, std::size_t& out) {
  const auto* text = in.node.as_string();
  if (text == nullptr) return in.fail_type(fmt::format("one of the words {}", fmt::join(words, ", ")));
  for (out = 0; out < words.size(); ++out)
    if (words[out] == text->get()) return true;
  const std::string near = find_nearest(text->get(), words);
  std::string hint = near.empty() ? "" : fmt::format("did you mean '{}'? ", near);
  if (near.empty() && in.findings.describe_owners)
    if (const std::string owners = in.findings.describe_owners(text->get()); !owners.empty()) hint = owners + "; ";
  return in.fail("'{}' is no choice for '{}'; {}choose one of {}", text->get(), in.key, hint, fmt::join(words, ", "));
}

json encode_number(double si, const Spec& spec) {
  if (spec.unit.empty()) return si;
  // 35° in radians converts back to 35.00000000000001; the conversions preserve fifteen digits.
  return round_to_digits(si / units::get_si_factor(spec.unit), 15);
}

json write_number_schema(const Spec& spec) {
  json number = {{"type", "number"}};
  if (spec.low) number[spec.low->open ? "exclusiveMinimum" : "minimum"] = spec.low->value;
  if (spec.high) number[spec.high->open ? "exclusiveMaximum" : "maximum"] = spec.high->value;
  if (spec.unit.empty()) return number;
  const json text = {{"type", "string"},
                     {"pattern", R"(^\s*[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?\s*[^\s0-9+.-].*$)"}};
  return {{"anyOf", json::array({number, text})}};
}

json write_array_schema(const json& items, int least, int most) {
  json schema = {{"type", "array"}, {"items", items}};
  if (least > 0) schema["minItems"] = least;
  if (most > 0) schema["maxItems"] = most;
  return schema;
}

std::string Codec<double>::name(const Spec& spec) {
  return "number" + write_unit(spec);
}

bool Codec<int>::decode(const Decoding& in, int& out) {
  const auto* number = in.node.as_integer();
  if (number == nullptr) return in.fail_type("a whole number");
  const auto value = static_cast<double>(number->get());
  if (!in.spec.allows(value) || std::abs(value) > 1e9)
    return in.fail("'{}' is {}; it must be {}", in.key, number->get(), in.spec.write_range());
  out = static_cast<int>(number->get());
  return true;
}

json Codec<int>::schema(const Spec& spec) {
  json schema = write_number_schema(spec);
  schema["type"] = "integer";
  return schema;
}

bool Codec<bool>::decode(const Decoding& in, bool& out) {
  const auto* truth = in.node.as_boolean();
  if (truth == nullptr) return in.fail_type("true or false");
  out = truth->get();
  return true;
}

bool Codec<std::string>::decode(const Decoding& in, std::string& out) {
  const auto* text = in.node.as_string();
  if (text == nullptr) return in.fail_type("a text in quotation marks");
  if (text->get().empty() && in.spec.is_required) return in.fail("'{}' must not be empty", in.key);
  if (in.key == "name" && text->get().find_first_of("\n\r") != std::string::npos)
    return in.fail("'name' must be one line");
  out = text->get();
  return true;
}

bool Codec<std::array<double, 3>>::decode(const Decoding& in, std::array<double, 3>& out) {
  std::vector<double> parts;
  if (!decode_numbers(in, 2, 3, "a vector [x, y] or [x, y, z]", parts)) return false;
  out = {parts[0], parts[1], parts.size() == 3 ? parts[2] : 0.0};
  return true;
}

json Codec<std::array<double, 3>>::encode(const std::array<double, 3>& value, const Spec& spec) {
  json list = json::array({encode_number(value[0], spec), encode_number(value[1], spec)});
  if (value[2] != 0) list.push_back(encode_number(value[2], spec));
  return list;
}

std::string Codec<std::array<double, 3>>::name(const Spec& spec) {
  return "[x, y] or [x, y, z]" + write_unit(spec);
}

std::string Codec<std::vector<double>>::name(const Spec& spec) {
  return "list of numbers" + write_unit(spec);
}

std::string Codec<std::vector<std::array<double, 2>>>::name(const Spec& spec) {
  return "[[x, y], ...]" + write_unit(spec);
}

json Codec<std::vector<std::array<double, 2>>>::schema(const Spec& spec) {
  return write_array_schema(write_array_schema(write_number_schema(spec), 2, 2), 1, -1);
}

bool Codec<Corners>::decode(const Decoding& in, Corners& out) {
  const std::string wanted = "two corners [[x_min, y_min], [x_max, y_max]]";
  const toml::array* list = find_list(in, 2, 2, wanted);
  if (list == nullptr) return false;
  std::vector<std::array<double, 2>> corners;
  if (!decode_points(in, corners)) return false;
  if (!(corners[0][0] < corners[1][0] && corners[0][1] < corners[1][1]))
    return in.fail("'{}' is empty: it must be {}, the smaller corner first", in.key, wanted);
  out.min = corners[0];
  out.max = corners[1];
  return true;
}

json Codec<Corners>::encode(const Corners& value, const Spec& spec) {
  return Codec<std::vector<std::array<double, 2>>>::encode({value.min, value.max}, spec);
}

std::string Codec<Corners>::name(const Spec& spec) {
  return "[[x_min, y_min], [x_max, y_max]]" + write_unit(spec);
}

json Codec<Corners>::schema(const Spec& spec) {
  return write_array_schema(write_array_schema(write_number_schema(spec), 2, 2), 2, 2);
}

bool Codec<TimeTable>::decode(const Decoding& in, TimeTable& out) {
  const std::string wanted = "a table of rows [time, factor]";
  const toml::array* rows = find_list(in, 0, std::size_t(-1), wanted);
  if (rows == nullptr) return false;
  const Spec no_unit;
  bool is_good = true;
  out = {};
  for (std::size_t i = 0; i < rows->size(); ++i) {
    const Decoding place = in.item(i);
    const toml::array* row = find_list(place, 2, 2, wanted);
    double t = 0, f = 0;
    if (row == nullptr || !decode_number(place.item(0), t) || !decode_number(place.with(no_unit).item(1), f)) {
      is_good = false;
      continue;
    }
    if (!out.time.empty() && t <= out.time.back())
      is_good = place.fail("the times of '{}' must increase from row to row", in.key);
    out.time.push_back(t);
    out.value.push_back(f);
  }
  return is_good;
}

json Codec<TimeTable>::encode(const TimeTable& value, const Spec& spec) {
  json list = json::array();
  for (std::size_t i = 0; i < value.time.size(); ++i)
    list.push_back(json::array({encode_number(value.time[i], spec), value.value[i]}));
  return list;
}

std::string Codec<TimeTable>::name(const Spec& spec) {
  return fmt::format("[[time, factor], ...] [{}, -]", spec.unit);
}

json Codec<TimeTable>::schema(const Spec& spec) {
  json row = {{"type", "array"}, {"minItems", 2}, {"maxItems", 2}};
  row["prefixItems"] = json::array({write_number_schema(spec), json{{"type", "number"}}});
  return write_array_schema(row, 1, -1);
}

bool Codec<Amount>::decode(const Decoding& in, Amount& out) {
  if (const auto number = in.node.value<double>(); number && !in.node.is_boolean()) {
    if (!std::isfinite(*number)) return in.fail("'{}' must be a finite number", in.key);
    out = {*number, "", fmt::format("{:.15g}", *number)};
  } else if (const auto* text = in.node.as_string()) {
    try {
      const units::Quantity quantity = units::parse_quantity(text->get());
      units::get_si_factor(quantity.unit);
      out = {quantity.value, quantity.unit, text->get()};
    } catch (const Error& error) {
      return in.fail(error.what());
    }
  } else {
    return in.fail_type("a number or a text with a unit, such as \"212 mm\"");
  }
  if (!in.spec.allows(out.number)) return in.fail("'{}' is {}; it must be {}", in.key, out.text, in.spec.write_range());
  in.record();
  return true;
}

nlohmann::json Codec<Amount>::encode(const Amount& value, const Spec&) {
  return value.unit.empty() ? json(value.number) : json(value.text);
}

bool Codec<TomlTexts>::decode(const Decoding& in, TomlTexts& out) {
  const toml::array* list = find_list(in, 1, std::size_t(-1), "a list of at least one value");
  if (list == nullptr) return false;
  out.texts.clear();
  for (std::size_t i = 0; i < list->size(); ++i) {
    in.item(i).record();
    out.texts.push_back(write_toml(*list->get(i)));
  }
  return true;
}

}  // namespace talus::input
