// SPDX-License-Identifier: MIT
#include "input/language/codec_types.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <map>

#include "base/numbers.hpp"
#include "base/units.hpp"

namespace talus::input {

namespace {

using nlohmann::json;

const toml::array* find_list(const Decoding& in, const std::string& wanted) {
  const toml::array* list = in.node.as_array();
  if (list == nullptr) in.fail_type(wanted);
  return list;
}

}  // namespace

bool decode_words(const Decoding& in, const std::vector<std::string>& words, std::vector<std::size_t>& out) {
  const toml::array* list = find_list(in, "a list of words");
  if (list == nullptr) return false;
  bool is_good = true;
  out.assign(list->size(), 0);
  for (std::size_t i = 0; i < list->size(); ++i) {
    is_good = decode_word(in.item(i), words, out[i]) && is_good;
    in.item(i).record();
  }
  return is_good;
}

bool Codec<std::vector<std::string>>::decode(const Decoding& in, std::vector<std::string>& out) {
  const toml::array* list = find_list(in, "a list of texts");
  if (list == nullptr) return false;
  out.clear();
  for (std::size_t i = 0; i < list->size(); ++i) {
    const Decoding item = in.item(i);
    const auto* text = item.node.as_string();
    if (text == nullptr) return item.fail_type("a list of texts in quotation marks");
    item.record();
    out.push_back(text->get());
  }
  return true;
}

bool Codec<std::array<double, 2>>::decode(const Decoding& in, std::array<double, 2>& out) {
  std::vector<double> xy;
  if (!decode_numbers(in, 2, 2, "a point [x, y]", xy)) return false;
  out = {xy[0], xy[1]};
  return true;
}

std::string Codec<std::array<double, 2>>::name(const Spec& spec) {
  return spec.unit.empty() ? "[x, y]" : fmt::format("[x, y] [{}]", spec.unit);
}

bool Codec<std::uint64_t>::decode(const Decoding& in, std::uint64_t& out) {
  const auto* number = in.node.as_integer();
  if (number == nullptr) return in.fail_type("a whole number");
  if (number->get() < 0) return in.fail("'{}' is {}; it must be at least 0", in.key, number->get());
  out = static_cast<std::uint64_t>(number->get());
  return true;
}

bool Codec<TomlText>::decode(const Decoding& in, TomlText& out) {
  if (!in.node.is_number() && !in.node.is_string())
    return in.fail_type("a number, or a text with a unit such as \"2 kPa\"");
  in.record();
  out.text = write_toml(in.node);
  return true;
}

json Codec<TomlText>::encode(const TomlText& value, const Spec&) {
  if (value.text.empty()) return nullptr;
  json parsed = json::parse(value.text, nullptr, false);
  return parsed.is_discarded() ? json(value.text) : parsed;
}

namespace {

using Pairs = std::vector<std::array<double, 2>>;

const Spec seconds = quantity("s");
const Spec share = plain().at_least(0).at_most(1);

/// The methods to fill missing values of a file.
const std::vector<std::string> fillings{"zero", "previous", "linear"};

constexpr const char* file_form = "{ file = \"station.csv\", column = \"rain\" }";

/// Reads a table of texts into the targets of their names. `wanted` lists the names: "'file' and 'column'".
bool decode_texts(const Decoding& in, const toml::table& table, const std::map<std::string, std::string*>& targets,
                  const std::string& wanted) {
  bool is_good = true;
  for (const auto& [key, node] : table) {
    const std::string name(key.str());
    const auto target = targets.find(name);
    const Decoding place = in.at(node, name);
    if (target == targets.end())
      is_good = place.fail("'{}' from a file has {}, and no '{}'", in.key, wanted, name);
    else if (const auto* text = node.as_string(); text != nullptr && !text->get().empty())
      *target->second = text->get();
    else
      is_good = place.fail_type("a text in quotation marks");
  }
  return is_good;
}

bool decode_file(const Decoding& in, const toml::table& table, SeriesFile& out) {
  bool is_good = decode_texts(
      in, table, {{"file", &out.file}, {"column", &out.column}, {"minus", &out.minus}, {"fill", &out.fill}},
      "'file', 'column', 'minus' and 'fill'");
  if (std::size_t word = 0; is_good && !out.fill.empty())
    is_good = decode_word(in.at(*table.get("fill"), "fill"), fillings, word);
  if (is_good && (out.file.empty() || out.column.empty()))
    return in.fail("'{}' from a file needs 'file' and 'column', as in {}", in.key, file_form);
  if (is_good) in.record();
  return is_good;
}

/// The unit of `spec` is that of the first column.
json encode_pairs(const Pairs& rows, const Spec& spec) {
  return encode_list(rows, [&](const auto& row) { return json::array({encode_number(row[0], spec), row[1]}); });
}

}  // namespace

bool decode_pairs(const Decoding& in, const Spec& first, const Spec& second, const std::string& wanted, Pairs& out) {
  const toml::array* rows = in.node.as_array();
  if (rows == nullptr || rows->empty()) return in.fail_type(wanted);
  bool is_good = true;
  out.clear();
  for (std::size_t i = 0; i < rows->size(); ++i) {
    const Decoding place = in.item(i);
    const toml::array* row = place.node.as_array();
    if (row == nullptr || row->size() != 2) {
      is_good = place.fail_type(wanted);
      continue;
    }
    place.record();
    auto& pair = out.emplace_back();
    is_good = decode_number(place.with(first).item(0), pair[0]) && is_good;
    is_good = decode_number(place.with(second).item(1), pair[1]) && is_good;
  }
  return is_good;
}

json write_pair_schema(const Spec& first, const Spec& second) {
  json row = {{"type", "array"}, {"minItems", 2}, {"maxItems", 2}};
  row["prefixItems"] = json::array({write_number_schema(first), write_number_schema(second)});
  return write_array_schema(row, 1, -1);
}

bool Codec<Series>::decode(const Decoding& in, Series& out) {
  out.table = {};
  if (const toml::table* file = in.node.as_table()) return decode_file(in, *file, out.table.source.emplace());
  if (!in.node.is_array()) {
    double value = 0;
    if (!decode_number(in, value)) return false;
    out.table = {{0.0}, {value}};
    return true;
  }
  Pairs rows;
  if (!decode_pairs(in, seconds, in.spec, fmt::format("a value, rows [time, value], or {}", file_form), rows))
    return false;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i > 0 && rows[i][0] < rows[i - 1][0])
      return in.item(i).fail("the times of '{}' must not decrease from row to row", in.key);
    if (i > 1 && rows[i][0] == rows[i - 2][0])
      return in.item(i).fail("'{}' has three rows at one time; two are a jump", in.key);
    out.table.time.push_back(rows[i][0]);
    out.table.value.push_back(rows[i][1]);
  }
  return true;
}

json Codec<Series>::encode(const Series& value, const Spec& spec) {
  const TimeTable& table = value.table;
  if (table.time.empty()) return {};
  if (table.time.size() == 1) return encode_number(table.value[0], spec);
  json list = json::array();
  for (std::size_t i = 0; i < table.time.size(); ++i)
    list.push_back(json::array({encode_number(table.time[i], seconds), encode_number(table.value[i], spec)}));
  return list;
}

std::string Codec<Series>::name(const Spec& spec) {
  return fmt::format("number [{0}], [[time, value], ...] [s, {0}] or {{ file, column }}", spec.unit);
}

json Codec<Series>::schema(const Spec& spec) {
  const json number = write_number_schema(spec), rows = write_pair_schema(seconds, spec);
  json choices = number.contains("anyOf") ? number["anyOf"] : json::array({number});
  choices.push_back(rows);
  const json text{{"type", "string"}};
  choices.push_back(
      {{"type", "object"},
       {"properties", {{"file", text}, {"column", text}, {"minus", text}, {"fill", {{"enum", fillings}}}}},
       {"required", {"file", "column"}},
       {"additionalProperties", false}});
  return {{"anyOf", choices}};
}

bool Codec<SurveyPoints>::decode(const Decoding& in, SurveyPoints& out) {
  out = {};
  const toml::table* table = in.node.as_table();
  if (table == nullptr) {
    if (!in.node.is_array()) return in.fail_type("a list of points [x, y], or { file = \"survey.csv\" }");
    return decode_points(in, out.points);
  }
  PointsFile& file = out.source.emplace();
  if (!decode_texts(in, *table, {{"file", &file.file}, {"x", &file.x}, {"y", &file.y}}, "'file', 'x' and 'y'"))
    return false;
  if (file.file.empty() || file.x.empty() != file.y.empty())
    return in.fail(
        "'{}' from a file needs 'file', and the columns 'x' and 'y' together or not at all, as in {{ file = "
        "\"survey.csv\", x = \"x\", y = \"level\" }}",
        in.key);
  in.record();
  return true;
}

json Codec<SurveyPoints>::encode(const SurveyPoints& value, const Spec& spec) {
  if (value.points.empty()) return {};
  return Codec<std::vector<std::array<double, 2>>>::encode(value.points, spec);
}

std::string Codec<SurveyPoints>::name(const Spec& spec) {
  return Codec<std::vector<std::array<double, 2>>>::name(spec) + " or { file, x, y }";
}

json Codec<SurveyPoints>::schema(const Spec& spec) {
  const json text{{"type", "string"}};
  return {{"anyOf",
           {Codec<std::vector<std::array<double, 2>>>::schema(spec),
            {{"type", "object"},
             {"properties", {{"file", text}, {"x", text}, {"y", text}}},
             {"required", {"file"}},
             {"additionalProperties", false}}}}};
}

bool Codec<Date>::decode(const Decoding& in, Date& out) {
  std::string text;
  if (const auto* word = in.node.as_string())
    text = word->get();
  else if (in.node.is_date() || in.node.is_date_time())
    text = write_toml(in.node);
  const auto seconds = parse_date(text);
  if (!seconds) return in.fail_type("a date such as 2023-07-01 or \"2023-07-01 06:00\"");
  out.seconds = *seconds;
  in.record();
  return true;
}

json Codec<Date>::encode(const Date& value, const Spec&) {
  return format_date(value.seconds);
}

json Codec<Date>::schema(const Spec&) {
  return {{"type", "string"}};
}

bool Codec<std::vector<Date>>::decode(const Decoding& in, std::vector<Date>& out) {
  const toml::array* list = in.node.as_array();
  if (list == nullptr) return in.fail_type("a list of dates");
  in.record();
  out.assign(list->size(), {});
  bool is_good = true;
  for (std::size_t i = 0; i < list->size(); ++i) is_good = Codec<Date>::decode(in.item(i), out[i]) && is_good;
  return is_good;
}

json Codec<std::vector<Date>>::encode(const std::vector<Date>& value, const Spec& spec) {
  if (value.empty()) return {};
  return encode_list(value, [&](const Date& date) { return Codec<Date>::encode(date, spec); });
}

json Codec<std::vector<Date>>::schema(const Spec& spec) {
  return write_array_schema(Codec<Date>::schema(spec), 0, -1);
}

bool Codec<SuctionCurve>::decode(const Decoding& in, SuctionCurve& out) {
  return decode_pairs(in, in.spec, share, "rows [suction, value]", out.pairs);
}

json Codec<SuctionCurve>::encode(const SuctionCurve& value, const Spec& spec) {
  if (value.pairs.empty()) return {};
  return encode_pairs(value.pairs, spec);
}

std::string Codec<SuctionCurve>::name(const Spec& spec) {
  return fmt::format("[[suction, value], ...] [{}, -]", spec.unit);
}

json Codec<SuctionCurve>::schema(const Spec& spec) {
  return write_pair_schema(spec, share);
}

namespace {

const Spec any_share = plain().at_least(0);

}  // namespace

bool decode_per_cent(const Decoding& in, double& out) {
  if (!in.node.is_number() && !in.node.is_string())
    return in.fail_type("a number of per cent, or a text such as \"0.88 %\"");
  double fraction = 0;
  if (!decode_number(in, fraction)) return false;
  // The fraction of 0.88 % converts back to 0.8800000000000001; the conversions preserve fifteen digits.
  out = round_to_digits(100 * fraction, 15);
  return true;
}

bool Codec<ShareTable>::decode(const Decoding& in, ShareTable& out) {
  if (!decode_pairs(in, in.spec, any_share, "rows of two numbers, the second a share", out.rows)) return false;
  for (std::size_t i = 1; i < out.rows.size(); ++i)
    if (out.rows[i][0] <= out.rows[i - 1][0])
      return in.item(i).fail("the first numbers of '{}' must increase from row to row", in.key);
  return true;
}

json Codec<ShareTable>::encode(const ShareTable& value, const Spec& spec) {
  if (value.rows.empty()) return {};
  return encode_pairs(value.rows, spec);
}

std::string Codec<ShareTable>::name(const Spec& spec) {
  return fmt::format("[[{}, share], ...] [{}, -]", spec.unit == "m" ? "length" : "time", spec.unit);
}

json Codec<ShareTable>::schema(const Spec& spec) {
  return write_pair_schema(spec, any_share);
}

bool Codec<std::array<double, 4>>::decode(const Decoding& in, std::array<double, 4>& out) {
  std::vector<double> numbers;
  if (!decode_numbers(in, 4, 4, "a list of four increasing numbers", numbers)) return false;
  for (std::size_t i = 0; i < 4; ++i) {
    if (i > 0 && numbers[i] <= numbers[i - 1]) return in.item(i).fail("the four numbers of '{}' must increase", in.key);
    out[i] = numbers[i];
  }
  return true;
}

std::string Codec<std::array<double, 4>>::name(const Spec& spec) {
  return fmt::format("four numbers [{}]", spec.unit);
}

namespace {

void collect(const toml::table& table, const std::string& prefix, std::vector<PointSetting>& out) {
  for (const auto& [key, node] : table) {
    const std::string name = prefix + std::string(key.str());
    if (const toml::table* inner = node.as_table())
      collect(*inner, name + ".", out);
    else
      out.push_back({name, write_toml(node)});
  }
}

}  // namespace

bool Codec<Turns>::decode(const Decoding& in, Turns& out) {
  if (in.node.is_array())
    return decode_numbers(in, 1, std::size_t(-1), "a number or a list of at least one number", out.values);
  double value = 0;
  if (!decode_number(in, value)) return false;
  out.values = {value};
  return true;
}

json Codec<Turns>::encode(const Turns& value, const Spec& spec) {
  if (value.values.empty()) return {};
  if (value.values.size() == 1) return encode_number(value.values[0], spec);
  return Codec<std::vector<double>>::encode(value.values, spec);
}

std::string Codec<Turns>::name(const Spec& spec) {
  return spec.unit.empty() ? "number or list of numbers" : fmt::format("number or list of numbers [{}]", spec.unit);
}

json Codec<Turns>::schema(const Spec& spec) {
  const json number = write_number_schema(spec);
  json choices = number.contains("anyOf") ? number["anyOf"] : json::array({number});
  choices.push_back(write_array_schema(number, 1, -1));
  return {{"anyOf", choices}};
}

bool Codec<std::vector<PointSetting>>::decode(const Decoding& in, std::vector<PointSetting>& out) {
  const toml::table* table = in.node.as_table();
  if (table == nullptr) return in.fail_type("a table of the material's keys, such as { porosity = 0.4 }");
  in.record();
  out.clear();
  collect(*table, "", out);
  return true;
}

json Codec<std::vector<PointSetting>>::encode(const std::vector<PointSetting>& value, const Spec&) {
  if (value.empty()) return {};
  std::string text;
  for (const PointSetting& s : value) text += (text.empty() ? "" : ", ") + s.key + " = " + s.value;
  return text;
}

}  // namespace talus::input
