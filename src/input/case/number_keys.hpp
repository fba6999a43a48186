// SPDX-License-Identifier: MIT
#pragma once
// The numbers of a material by their keys, as the case file names them: "kappa", "water.conductivity".

#include <optional>
#include <string>
#include <vector>

#include "input/case/case.hpp"
#include "input/language/spec.hpp"

namespace talus::input {

/// A key of a material that holds one number.
struct NumberKey {
  std::string path;
  Spec spec;                    ///< unit and range for people
  double factor = 1;            ///< one `spec.unit` in the unit in which the material keeps it
  std::optional<double> value;  ///< as the material keeps it; nothing where it is not given
  bool applies = true;          ///< has a meaning with the material's model
};

std::vector<NumberKey> list_number_keys(const Material& material);
/// The key of that path; nothing when the material has none.
std::optional<NumberKey> find_number_key(const Material& material, const std::string& path);
/// Gives the key another value, and what follows from it. Throws Error (wrong_input) when there is no such key.
void set_number(Material& material, const std::string& path, double value);

}  // namespace talus::input
