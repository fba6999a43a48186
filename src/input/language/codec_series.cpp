// SPDX-License-Identifier: MIT
#include "input/language/codec_series.hpp"

#include <fmt/format.h>

#include "base/dates.hpp"

namespace talus::input {
namespace {

using nlohmann::json;
using Pairs = std::vector<std::array<double, 2>>;

const Spec seconds = quantity("s");
const Spec share = plain().at_least(0).at_most(1);

/// How missing values of a file are filled.
const std::vector<std::string> fillings{"zero", "previous", "linear"};

constexpr const char* file_form = "{ file = \"station.csv\", column = \"rain\" }";

bool decode_file(const Decoding& in, const toml::table& table, const std::string& path, SeriesFile& out) {
  bool is_good = true;
  for (const auto& [key, node] : table) {
    const std::string name(key.str());
    std::string* part = name == "file"     ? &out.file
                        : name == "column" ? &out.column
                        : name == "minus"  ? &out.minus
                        : name == "fill"   ? &out.fill
                                           : nullptr;
    if (part == nullptr)
      is_good =
          in.fail(node, path,
                  fmt::format("'{}' from a file has 'file', 'column', 'minus' and 'fill', and no '{}'", in.key, name));
    else if (const auto* text = node.as_string(); text != nullptr && !text->get().empty())
      *part = text->get();
    else
      is_good = in.fail_type(node, fmt::format("{}.{}", path, name), "a text in quotation marks");
  }
  if (std::size_t word = 0; is_good && !out.fill.empty())
    is_good = decode_word(in, *table.get("fill"), path + ".fill", fillings, word);
  if (is_good && (out.file.empty() || out.column.empty()))
    return in.fail(table, path, fmt::format("'{}' from a file needs 'file' and 'column', as in {}", in.key, file_form));
  if (is_good) in.record(table, path);
  return is_good;
}

}  // namespace

bool decode_pairs(const Decoding& in, const toml::node& node, const std::string& path, const Spec& first,
                  const Spec& second, const std::string& wanted, Pairs& out) {
  const toml::array* rows = node.as_array();
  if (rows == nullptr || rows->empty()) return in.fail_type(node, path, wanted);
  const Decoding left{first, in.key, in.findings}, right{second, in.key, in.findings};
  bool is_good = true;
  out.clear();
  for (std::size_t i = 0; i < rows->size(); ++i) {
    const std::string row_path = fmt::format("{}.{}", path, i);
    const toml::array* row = rows->get(i)->as_array();
    if (row == nullptr || row->size() != 2) {
      is_good = in.fail_type(*rows->get(i), row_path, wanted);
      continue;
    }
    in.record(*row, row_path);
    auto& pair = out.emplace_back();
    is_good = decode_number(left, *row->get(0), row_path + ".0", pair[0]) && is_good;
    is_good = decode_number(right, *row->get(1), row_path + ".1", pair[1]) && is_good;
  }
  return is_good;
}

json write_pair_schema(const Spec& first, const Spec& second) {
  json row = {{"type", "array"}, {"minItems", 2}, {"maxItems", 2}};
  row["prefixItems"] = json::array({write_number_schema(first), write_number_schema(second)});
  return write_array_schema(row, 1, -1);
}

bool Codec<Series>::decode(const Decoding& in, const toml::node& node, const std::string& path, Series& out) {
  out.table = {};
  if (const toml::table* file = node.as_table()) return decode_file(in, *file, path, out.table.source.emplace());
  if (!node.is_array()) {
    double value = 0;
    if (!decode_number(in, node, path, value)) return false;
    out.table = {{0.0}, {value}};
    return true;
  }
  Pairs rows;
  if (!decode_pairs(in, node, path, seconds, in.spec, fmt::format("a value, rows [time, value], or {}", file_form),
                    rows))
    return false;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i > 0 && rows[i][0] < rows[i - 1][0])
      return in.fail(*node.as_array()->get(i), fmt::format("{}.{}", path, i),
                     fmt::format("the times of '{}' must not decrease from row to row", in.key));
    if (i > 1 && rows[i][0] == rows[i - 2][0])
      return in.fail(*node.as_array()->get(i), fmt::format("{}.{}", path, i),
                     fmt::format("'{}' has three rows at one time; two are a jump", in.key));
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

bool Codec<Date>::decode(const Decoding& in, const toml::node& node, const std::string& path, Date& out) {
  std::string text;
  if (const auto* word = node.as_string())
    text = word->get();
  else if (node.is_date() || node.is_date_time())
    text = write_toml(node);
  const auto seconds = parse_date(text);
  if (!seconds) return in.fail_type(node, path, "a date such as 2023-07-01 or \"2023-07-01 06:00\"");
  out.seconds = *seconds;
  in.record(node, path);
  return true;
}

json Codec<Date>::encode(const Date& value, const Spec&) {
  return format_date(value.seconds);
}

json Codec<Date>::schema(const Spec&) {
  return {{"type", "string"}};
}

bool Codec<std::vector<Date>>::decode(const Decoding& in, const toml::node& node, const std::string& path,
                                      std::vector<Date>& out) {
  const toml::array* list = node.as_array();
  if (list == nullptr) return in.fail_type(node, path, "a list of dates");
  in.record(node, path);
  out.assign(list->size(), {});
  bool is_good = true;
  for (std::size_t i = 0; i < list->size(); ++i)
    is_good = Codec<Date>::decode(in, *list->get(i), write_item_path(path, i), out[i]) && is_good;
  return is_good;
}

json Codec<std::vector<Date>>::encode(const std::vector<Date>& value, const Spec& spec) {
  if (value.empty()) return {};
  json list = json::array();
  for (const Date& date : value) list.push_back(Codec<Date>::encode(date, spec));
  return list;
}

json Codec<std::vector<Date>>::schema(const Spec& spec) {
  return write_array_schema(Codec<Date>::schema(spec), 0, -1);
}

bool Codec<SuctionCurve>::decode(const Decoding& in, const toml::node& node, const std::string& path,
                                 SuctionCurve& out) {
  return decode_pairs(in, node, path, in.spec, share, "rows [suction, value]", out.pairs);
}

json Codec<SuctionCurve>::encode(const SuctionCurve& value, const Spec& spec) {
  if (value.pairs.empty()) return {};
  json list = json::array();
  for (const auto& [suction, y] : value.pairs) list.push_back(json::array({encode_number(suction, spec), y}));
  return list;
}

std::string Codec<SuctionCurve>::name(const Spec& spec) {
  return fmt::format("[[suction, value], ...] [{}, -]", spec.unit);
}

json Codec<SuctionCurve>::schema(const Spec& spec) {
  return write_pair_schema(spec, share);
}

}  // namespace talus::input
