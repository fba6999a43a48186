// SPDX-License-Identifier: MIT
#pragma once
// Reads a report back as its page does: the document out of the HTML, the arrays out of base64, zlib, planes and rows.

#include <gtest/gtest.h>
#include <unistd.h>
#include <zlib.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace talus::report {

inline std::string read_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// An empty folder for one test.
inline std::filesystem::path make_test_folder(const std::string& name) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("talus_report_" + name + "_" + std::to_string(getpid()));
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

/// The scripts of a page by id, cut as a browser does: up to the first "</script".
inline std::map<std::string, std::string> cut_scripts(const std::string& html) {
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

inline std::vector<unsigned char> decode_base64(const std::string& text) {
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

/// A packed array as numbers; NaN where there is none.
inline std::vector<double> decode(const nlohmann::json& array, const std::string& base64) {
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
    } else if (array.contains("range")) {
      const double min = array["range"][0], max = array["range"][1];
      values.push_back(n == 65535 ? std::nan("") : min + n / 65534.0 * (max - min));
    } else {
      values.push_back(n);
    }
  }
  return values;
}

/// A report.html.
struct ReadPage {
  nlohmann::json document;
  std::map<std::string, std::string> scripts;

  explicit ReadPage(const std::string& html) : scripts(cut_scripts(html)) {
    document = nlohmann::json::parse(scripts.at("talus-report"));
  }
  std::vector<double> values(const nlohmann::json& array) const {
    return decode(array, scripts.at(array.at("id").get<std::string>()));
  }
  const nlohmann::json& sequence(const std::string& id) const {
    for (const nlohmann::json& s : document.at("sequences"))
      if (s.at("id") == id) return s;
    throw std::runtime_error("there is no sequence " + id);
  }
};

}  // namespace talus::report
