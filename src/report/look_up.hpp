#pragma once
// Reading summary.json and its echo of the input, where any key may be missing: older folders know fewer.

#include <array>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "report/words/numbers.hpp"

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

ShownUnits read_units(const nlohmann::json& summary);

}  // namespace talus::report
