// SPDX-License-Identifier: MIT
#include "input/language/codec_shares.hpp"

#include <fmt/format.h>

#include <cstdlib>

#include "base/numbers.hpp"
#include "input/language/codec_series.hpp"

namespace talus::input {
namespace {

using nlohmann::json;

const Spec any_share = plain().at_least(0);

}  // namespace

bool decode_per_cent(const Decoding& in, const toml::node& node, const std::string& path, double& out) {
  if (!node.is_number() && !node.is_string())
    return in.fail_type(node, path, "a number of per cent, or a text such as \"0.88 %\"");
  double fraction = 0;
  if (!decode_number(in, node, path, fraction)) return false;
  // 0.88 comes back from the fraction as 0.8800000000000001: fifteen digits are what the conversions keep.
  out = round_to_digits(100 * fraction, 15);
  return true;
}

bool Codec<ShareTable>::decode(const Decoding& in, const toml::node& node, const std::string& path, ShareTable& out) {
  if (!decode_pairs(in, node, path, in.spec, any_share, "rows of two numbers, the second a share", out.rows))
    return false;
  for (std::size_t i = 1; i < out.rows.size(); ++i)
    if (out.rows[i][0] <= out.rows[i - 1][0])
      return in.fail(*node.as_array()->get(i), fmt::format("{}.{}", path, i),
                     fmt::format("the first numbers of '{}' must increase from row to row", in.key));
  return true;
}

json Codec<ShareTable>::encode(const ShareTable& value, const Spec& spec) {
  if (value.rows.empty()) return {};
  json list = json::array();
  for (const auto& [place, part] : value.rows) list.push_back(json::array({encode_number(place, spec), part}));
  return list;
}

std::string Codec<ShareTable>::name(const Spec& spec) {
  return fmt::format("[[{}, share], ...] [{}, -]", spec.unit == "m" ? "length" : "time", spec.unit);
}

json Codec<ShareTable>::schema(const Spec& spec) {
  return write_pair_schema(spec, any_share);
}

bool Codec<std::array<double, 4>>::decode(const Decoding& in, const toml::node& node, const std::string& path,
                                          std::array<double, 4>& out) {
  std::vector<double> numbers;
  if (!decode_numbers(in, node, path, 4, 4, "a list of four increasing numbers", numbers)) return false;
  for (std::size_t i = 0; i < 4; ++i) {
    if (i > 0 && numbers[i] <= numbers[i - 1])
      return in.fail(*node.as_array()->get(i), fmt::format("{}.{}", path, i),
                     fmt::format("the four numbers of '{}' must increase", in.key));
    out[i] = numbers[i];
  }
  return true;
}

json Codec<std::array<double, 4>>::encode(const std::array<double, 4>& value, const Spec& spec) {
  json list = json::array();
  for (const double x : value) list.push_back(encode_number(x, spec));
  return list;
}

std::string Codec<std::array<double, 4>>::name(const Spec& spec) {
  return fmt::format("four numbers [{}]", spec.unit);
}

}  // namespace talus::input
