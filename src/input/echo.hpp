// SPDX-License-Identifier: MIT
#pragma once
// The echo of a case: every value that a calculation used, with its unit, and whether it was given or is a default.

#include <optional>
#include <string>

#include "base/json_tree.hpp"
#include "input/case/case.hpp"
#include "input/language/findings.hpp"

namespace talus::input {

/// {"mesh": {"size": {"value": 0.75, "unit": "m", "given": true}, ...}, "stage": [{...}], ...}. Keys that have no
/// meaning in the case (a cohesion of an elastic material) are left out; an optional key without a value is null.
nlohmann::json echo(const Case& data, const Places& places);

/// The case of an echo, in SI and with unit directions, as read_case() gives it. Keys that this version does not know
/// are left out, and keys that the echo lacks keep their defaults.
Case read_echo(const JsonTree& echo);

/// Hash of what decides the state of a run. A run may be resumed with other outputs, and after an instability with a
/// smaller Courant number, so neither counts.
std::string hash_input(const JsonTree& echo);

/// Whether the meshes of both cases are made from the same keys.
bool has_same_mesh_input(const JsonTree& a, const JsonTree& b);
/// `echo` with the geometry and the mesh of another one.
JsonTree replace_mesh_input(const JsonTree& echo, const JsonTree& other);
/// The models of the materials by number, which is in the order of their names. `source` names the result in the Error
/// (wrong_input) for a model that this version does not know.
std::vector<MaterialModel> list_material_models(const JsonTree& echo, const std::string& source);

/// A key of a case as its echo has it.
struct EchoedKey {
  std::string text;  ///< the value as people write it, a number with all its digits; empty: none
  std::string unit;  ///< empty: a plain number or a word
};

/// The key that a dotted path names as --set does; nothing where it has no meaning in the case.
std::optional<EchoedKey> find_key(const JsonTree& echo, const std::string& path);

/// The echo without its remarks on what was given, on one line: equal for cases that calculate the same.
std::string write_calculated(const JsonTree& echo);

/// Makes directions unit vectors; after the checks, which look for directions without length.
void normalise_directions(Case& data);

}  // namespace talus::input
