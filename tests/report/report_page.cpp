// SPDX-License-Identifier: MIT
#include "report/report_page.hpp"
#include "support/scratch.hpp"

#include <zlib.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace talus::report {

std::string read_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::filesystem::path make_test_folder(const std::string& name) {
  return support::make_scratch(name);
}

std::map<std::string, std::string> cut_scripts(const std::string& html) {
  std::map<std::string, std::string> scripts;
  const std::string mark = "\" id=\"";
  for (std::size_t at = 0; (at = html.find("<script type=\"", at)) != std::string::npos;) {
    const std::size_t open_end = html.find('>', at), id = html.find(mark, at);
    const std::size_t end = html.find("</script", open_end);
    if (id < open_end) {
      const std::size_t begin = id + mark.size();
      scripts[html.substr(begin, html.find('"', begin) - begin)] = html.substr(open_end + 1, end - open_end - 1);
    }
    at = end;
  }
  return scripts;
}

std::vector<unsigned char> decode_base64(const std::string& text) {
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<unsigned char> bytes;
  unsigned bits = 0, count = 0;
  for (const char c : text) {
    if (c == '=') break;
    const std::size_t digit = letters.find(c);
    if (digit == std::string::npos) throw std::runtime_error("no base64");
    bits = bits << 6 | static_cast<unsigned>(digit);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes.push_back(static_cast<unsigned char>(bits >> count & 255u));
  }
  return bytes;
}

std::vector<double> decode(const nlohmann::json& array, const std::string& base64) {
  const std::string type = array.at("type");
  const std::size_t width = type == "u8" ? 1 : type == "u16" ? 2 : 4;
  std::size_t count = 1;
  for (const std::size_t n : array.at("shape")) count *= n;
  const std::vector<unsigned char> packed = decode_base64(base64);
  std::vector<unsigned char> bytes(count * width + 1);
  uLongf size = bytes.size();
  if (uncompress(bytes.data(), &size, packed.data(), packed.size()) != Z_OK || size != count * width)
    throw std::runtime_error("the array's length is not that of its shape");
  std::vector<std::uint32_t> numbers(count);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 0; k < width; ++k)
      numbers[i] |= static_cast<std::uint32_t>(bytes[array.at("planes") ? k * count + i : i * width + k]) << (8 * k);
  if (array.at("delta")) {
    const std::size_t row = count / array.at("shape")[0].get<std::size_t>();
    const std::uint32_t mask = width == 4 ? ~0u : (1u << (8 * width)) - 1;
    for (std::size_t i = row; i < count; ++i) numbers[i] = (numbers[i] + numbers[i - row]) & mask;
  }
  std::vector<double> values;
  for (const std::uint32_t n : numbers) {
    if (type == "f32") {
      float value;
      std::memcpy(&value, &n, 4);
      values.push_back(value);
    } else if (array.contains("origin")) {
      values.push_back(n == 65535 ? std::nan("") : n);
    } else if (array.contains("range")) {
      const double min = array["range"][0], max = array["range"][1];
      values.push_back(n == 65535 ? std::nan("") : min + n / 65534.0 * (max - min));
    } else {
      values.push_back(n);
    }
  }
  if (!array.contains("origin")) return values;
  const std::size_t components = array["origin"].size();
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = array["origin"][i % components].get<double>() + array["step"][i % components].get<double>() * values[i];
  return values;
}

}  // namespace talus::report
