// SPDX-License-Identifier: MIT
#pragma once
// The echo of a case: every value of a calculation with its unit, and whether it was given or is a default.

#include <optional>
#include <string>
#include <vector>

#include "base/json_tree.hpp"
#include "input/case/case.hpp"
#include "input/language/findings.hpp"

namespace talus::input {

/// Returns {"mesh": {"size": {"value": 0.75, "unit": "m", "given": true}, ...}, "stage": [{...}], ...}. Keys that do
/// not apply to the case (a cohesion of an elastic material) are left out; an optional key without a value is null.
nlohmann::json echo(const Case& data, const Places& places);

/// Returns the case of an echo, in SI and with unit vectors, as read_case() does. Unknown keys are ignored; missing
/// keys keep their defaults.
Case read_echo(const JsonTree& echo);

/// Returns an echo without the regions, surcharges, supports and vertical drains that `data` does not have, and without
/// stages of construction: that of the case at the end of a stage.
JsonTree drop_absent(const JsonTree& echo, const Case& data);

/// Returns a hash of the input that determines the state of a run. Outputs and the Courant number are excluded: a run
/// may be resumed with other outputs, and after an instability with a smaller Courant number. `data` of the echo: the
/// values of its tables that the echo does not hold count as well.
std::string hash_input(const JsonTree& echo, const Case& data);

/// Returns true if the keys of the mesh are equal in both cases.
bool has_same_mesh_input(const JsonTree& a, const JsonTree& b);
/// Returns `echo` with the geometry and the mesh of another one.
JsonTree replace_mesh_input(const JsonTree& echo, const JsonTree& other);
/// Returns the models of the materials by number, in the order of their names. `source` names the result in the Error
/// (wrong_input) for a model that does not exist in this version.
std::vector<MaterialModel> list_material_models(const JsonTree& echo, const std::string& source);

/// A key of a case in its echo.
struct EchoedKey {
  std::string text;  ///< the value for messages, a number with all its digits; empty: none
  std::string unit;  ///< empty: a plain number or a word
};

/// Returns the key at a dotted path as for --set; std::nullopt if it does not apply to the case.
std::optional<EchoedKey> find_key(const JsonTree& echo, const std::string& path);

/// A key of a case with its path, for lists of the input.
struct ListedKey {
  std::string path;              ///< "materials.sand.cohesion", "stage.0.duration"
  std::optional<double> number;  ///< for a number
  std::string text;              ///< for every other value, lists as JSON; empty: none
  std::string unit;              ///< empty: a plain number or a word
  bool is_given = false;         ///< false: a default
};

/// Returns all keys of an echo, in its order.
std::vector<ListedKey> list_keys(const JsonTree& echo);

/// Returns the echo without the marks of given values, on one line: equal for cases with equal calculations.
std::string write_calculated(const JsonTree& echo);

/// Converts directions to unit vectors. The checks, which report zero vectors, must precede.
void normalise_directions(Case& data);

}  // namespace talus::input
