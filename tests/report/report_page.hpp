// SPDX-License-Identifier: MIT
#pragma once
// Reads a report as its page does: the document from the HTML, the arrays from base64, zlib, byte planes and row
// differences.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace talus::report {

std::string read_text(const std::filesystem::path& path);

/// An empty folder for one test.
std::filesystem::path make_test_folder(const std::string& name);

/// The scripts of a page by id, cut as a browser does: up to the first "</script".
std::map<std::string, std::string> cut_scripts(const std::string& html);

std::vector<unsigned char> decode_base64(const std::string& text);

/// A packed array as numbers; NaN where there is none.
std::vector<double> decode(const nlohmann::json& array, const std::string& base64);

/// A report.html.
struct ReadPage {
  nlohmann::json document, results;
  std::map<std::string, std::string> scripts;

  explicit ReadPage(const std::string& html) : scripts(cut_scripts(html)) {
    document = nlohmann::json::parse(scripts.at("talus-report"));
    results = nlohmann::json::parse(scripts.at("talus-results"));
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
