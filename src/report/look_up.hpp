#pragma once
// Reading summary.json and its echo of the input, where any key may be missing: older folders know fewer.

#include <array>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "results/run.hpp"

namespace talus::report {

/// What stands at `path`; nullptr when it is not there or null.
const nlohmann::json* find(const nlohmann::json& node, std::initializer_list<const char*> path);
/// The list at `path`; an empty one when there is none.
const nlohmann::json& find_list(const nlohmann::json& node, std::initializer_list<const char*> path);
std::optional<double> find_number(const nlohmann::json& node, std::initializer_list<const char*> path);
double get_number(const nlohmann::json& node, std::initializer_list<const char*> path, double otherwise = 0);
std::string get_text(const nlohmann::json& node, std::initializer_list<const char*> path,
                     const std::string& otherwise = "");

/// A leaf of the echo is {"value", "unit", "given"}; these read its value, numbers in SI.
std::optional<double> find_si(const nlohmann::json& table, const char* key);
double get_si(const nlohmann::json& table, const char* key, double otherwise);
std::vector<double> get_si_vector(const nlohmann::json& table, const char* key);
std::vector<std::vector<double>> get_si_points(const nlohmann::json& table, const char* key);
std::string get_word(const nlohmann::json& table, const char* key, const std::string& otherwise = "");
bool get_flag(const nlohmann::json& table, const char* key, bool otherwise = false);

/// 2 or 3.
std::size_t get_dimension(const nlohmann::json& summary);
std::size_t get_dimension(const results::RunResult& run);

/// A unit of display: value in SI = value shown × si.
struct ShownUnit {
  std::string name;
  double si = 1;
};
nlohmann::json to_json(const ShownUnit& unit);
struct ShownUnits {
  ShownUnit length{"m", 1}, displacement{"mm", 1e-3}, stress{"kPa", 1e3};
};
ShownUnits read_units(const nlohmann::json& summary);
ShownUnits read_units(const results::RunResult& run);
/// "3.23", "−0.061", "4.06 × 10⁻⁶": `digits` significant digits, and all before the point; "–" for what is no number.
std::string show_number(double value, int digits = 3);
/// "3.23 m".
std::string show(double si, const ShownUnit& unit, int digits = 3);
/// "a, b and c".
std::string join_words(const std::vector<std::string>& words);

}  // namespace talus::report
