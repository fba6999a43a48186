// SPDX-License-Identifier: MIT
#include "report/pack/pack.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "base/text.hpp"

namespace talus::report {

namespace {

/// Level 9 reduces the page of examples/dry_slope by 5 % and takes ten times as long.
constexpr int compression_level = 3;
constexpr double largest_code = 65534;
constexpr std::uint16_t no_value = 65535;

/// Splits numbers into byte planes, little-endian, lowest bytes first. High bytes of neighbours are similar and
/// compress better side by side.
template <class T>
std::vector<std::uint8_t> split_planes(const std::vector<T>& numbers) {
  const std::size_t count = numbers.size();
  std::vector<std::uint8_t> bytes(count * sizeof(T));
  for (std::size_t k = 0; k < sizeof(T); ++k)
    for (std::size_t i = 0; i < count; ++i)
      bytes[k * count + i] = static_cast<std::uint8_t>((numbers[i] >> (8 * k)) & 0xffu);
  return bytes;
}

/// Replaces rows along the first axis by their differences, modulo the range of the type.
template <class T>
void subtract_rows(std::vector<T>& numbers, const std::vector<std::size_t>& shape) {
  if (shape.empty() || shape[0] < 2 || numbers.empty()) return;
  const std::size_t row = numbers.size() / shape[0];
  for (std::size_t i = numbers.size(); i-- > row;) numbers[i] = static_cast<T>(numbers[i] - numbers[i - row]);
}

/// Returns one component of the last axis, whose length is `width`.
std::vector<double> take_component(std::span<const double> values, std::size_t width, std::size_t component) {
  std::vector<double> taken;
  taken.reserve(values.size() / width);
  for (std::size_t i = component; i < values.size(); i += width) taken.push_back(values[i]);
  return taken;
}

std::vector<std::uint8_t> deflate_bytes(const std::vector<std::uint8_t>& bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::vector<std::uint8_t> packed(size);
  const int code = compress2(packed.data(), &size, bytes.data(), static_cast<uLong>(bytes.size()), compression_level);
  if (code != Z_OK) throw Error(ExitCode::internal_error, "zlib could not compress an array of the report");
  packed.resize(size);
  return packed;
}

}  // namespace

std::string encode_base64(std::span<const std::uint8_t> bytes) {
  static constexpr char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t left = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (k < left ? bytes[i + k] : 0u);
    for (std::size_t k = 0; k < 4; ++k) text += k <= left ? letters[group >> (18 - 6 * k) & 63u] : '=';
  }
  return text;
}

Quantised quantise(std::span<const double> values) {
  Quantised q;
  q.min = std::numeric_limits<double>::infinity();
  q.max = -q.min;
  for (const double v : values) {
    if (!std::isfinite(v)) continue;
    q.min = std::min(q.min, v);
    q.max = std::max(q.max, v);
  }
  if (q.min > q.max) q.min = q.max = 0;
  const double scale = q.max > q.min ? largest_code / (q.max - q.min) : 0;
  q.codes.reserve(values.size());
  for (const double v : values)
    q.codes.push_back(std::isfinite(v) ? static_cast<std::uint16_t>(std::lround((v - q.min) * scale)) : no_value);
  return q;
}

void Packer::throw_if_interrupted() const {
  if (is_interrupted() && !was_interrupted_)
    throw Error(ExitCode::interrupted,
                "interrupted while the report was written; the results are whole, `talus report` writes it");
}

nlohmann::json Packer::keep(const std::string& id, const char* type, const std::vector<std::size_t>& shape, bool delta,
                            std::vector<std::uint8_t> bytes) {
  throw_if_interrupted();
  arrays_.push_back({id, std::move(bytes)});
  return {{"id", id}, {"type", type}, {"shape", shape}, {"delta", delta}, {"planes", true}};
}

nlohmann::json Packer::add_values(const std::string& id, std::span<const double> values,
                                  const std::vector<std::size_t>& shape, bool delta) {
  Quantised q = quantise(values);
  if (delta) subtract_rows(q.codes, shape);
  nlohmann::json array = keep(id, "u16", shape, delta, split_planes(q.codes));
  array["range"] = {q.min, q.max};
  return array;
}

nlohmann::json Packer::add_quantised_places(const std::string& id, std::span<const double> values,
                                            const std::vector<std::size_t>& shape, bool delta) {
  const std::size_t width = shape.back();
  std::vector<std::uint16_t> codes(values.size());
  std::vector<double> origin, step;
  for (std::size_t c = 0; c < width; ++c) {
    const Quantised q = quantise(take_component(values, width, c));
    for (std::size_t i = 0; i < q.codes.size(); ++i) codes[i * width + c] = q.codes[i];
    origin.push_back(q.min);
    step.push_back((q.max - q.min) / largest_code);
  }
  if (delta) subtract_rows(codes, shape);
  nlohmann::json array = keep(id, "u16", shape, delta, split_planes(codes));
  array["origin"] = origin;
  array["step"] = step;
  return array;
}

nlohmann::json Packer::add_places(const std::string& id, std::span<const double> values,
                                  const std::vector<std::size_t>& shape) {
  const std::size_t width = shape.back();
  std::vector<double> local(values.begin(), values.end()), origin;
  for (std::size_t c = 0; c < width; ++c) {
    const std::vector<double> component = take_component(values, width, c);
    const auto [least, most] = std::minmax_element(component.begin(), component.end());
    origin.push_back(component.empty() ? 0 : *least + (*most - *least) / 2);
    for (std::size_t i = c; i < local.size(); i += width) local[i] -= origin[c];
  }
  nlohmann::json array = add_reals(id, local, shape);
  array["origin"] = origin;
  array["step"] = std::vector<double>(width, 1.0);
  return array;
}

nlohmann::json Packer::add_bytes(const std::string& id, std::span<const std::uint8_t> values,
                                 const std::vector<std::size_t>& shape) {
  return keep(id, "u8", shape, false, {values.begin(), values.end()});
}

nlohmann::json Packer::add_numbers(const std::string& id, std::span<const std::uint32_t> values,
                                   const std::vector<std::size_t>& shape, bool delta) {
  std::vector<std::uint32_t> numbers(values.begin(), values.end());
  if (delta) subtract_rows(numbers, shape);
  return keep(id, "u32", shape, delta, split_planes(numbers));
}

nlohmann::json Packer::add_reals(const std::string& id, std::span<const double> values,
                                 const std::vector<std::size_t>& shape) {
  std::vector<std::uint32_t> numbers;
  numbers.reserve(values.size());
  for (const double v : values) numbers.push_back(std::bit_cast<std::uint32_t>(static_cast<float>(v)));
  return keep(id, "f32", shape, false, split_planes(numbers));
}

std::vector<PackedText> Packer::compress(int threads) const {
  std::vector<PackedText> texts(arrays_.size());
  parallel_tasks(static_cast<int>(arrays_.size()), threads, [&](int i) {
    throw_if_interrupted();
    const Array& array = arrays_[static_cast<std::size_t>(i)];
    texts[static_cast<std::size_t>(i)] = {array.id, encode_base64(deflate_bytes(array.bytes))};
  });
  return texts;
}

}  // namespace talus::report

// The symbols are defined in page_data.S, which the build generates.
extern "C" {
extern const char talus_report_page[];
extern const char talus_report_page_end[];
}

namespace talus::report {
namespace {

constexpr std::string_view mark = "<!--TALUS_DATA-->";

std::string escape_html(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '<')
      safe += "&lt;";
    else if (c == '>')
      safe += "&gt;";
    else if (c == '&')
      safe += "&amp;";
    else
      safe += c;
  }
  return safe;
}

/// Replaces '<' by its Unicode escape: "</script" would end the script and "<!--" would change how its rest is parsed.
/// In JSON, '<' occurs inside strings only.
std::string write_script(const nlohmann::json& json) {
  // Invalid UTF-8, for example in a title, is replaced rather than rejected.
  const std::string text = json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  std::string safe;
  safe.reserve(text.size());
  for (const char c : text) {
    if (c == '<')
      safe += "\\u003c";
    else
      safe += c;
  }
  return safe;
}

}  // namespace

std::string_view get_page() {
  return {talus_report_page, static_cast<std::size_t>(talus_report_page_end - talus_report_page)};
}

std::string fill_page(std::string_view page, const std::string& title, const nlohmann::json& results,
                      const nlohmann::json& document, const std::vector<PackedText>& arrays) {
  // The last placeholder is used, since the script of the page precedes it and may contain the same text.
  const std::size_t at = page.rfind(mark);
  if (at == std::string_view::npos) {
    throw Error(
        ExitCode::internal_error,
        "the page for reports inside this program has no place for data; build it again (docs/manual/report.md)");
  }
  std::string data;
  for (const auto& [id, part] : {std::pair{"talus-report", &document}, std::pair{"talus-results", &results}})
    data += fmt::format("<script type=\"application/json\" id=\"{}\">{}</script>\n", id, write_script(*part));
  for (const PackedText& array : arrays)
    data += "<script type=\"text/plain\" id=\"" + array.id + "\">" + array.base64 + "</script>\n";

  std::string head(page.substr(0, at));
  const std::size_t name = head.find("<title>"), name_end = head.find("</title>");
  if (!title.empty() && name != std::string::npos && name_end != std::string::npos && name < name_end)
    head.replace(name + 7, name_end - name - 7, escape_html(make_printable(title)));
  return head + data + std::string(page.substr(at + mark.size()));
}

}  // namespace talus::report
