// SPDX-License-Identifier: MIT
#pragma once
// The uncertain numbers of a study in figures: a [[study.random]] evaluated for its case.

#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/methods.hpp"
#include "input/case/case.hpp"
#include "input/case/study.hpp"
#include "input/language/spec.hpp"

namespace talus::input {

// The numbers of a material by their keys, as the case file names them: "kappa", "water.conductivity".

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

// The method of [analysis] that a sampling study asks for.

constexpr Method find_method(SampledMethod sampled) {
  return sampled == SampledMethod::lem ? Method::lem : sampled == SampledMethod::fem ? Method::fem : Method::mpm;
}

/// A number of the case file.
struct EchoedNumber {
  std::string unit;             ///< of the manual; empty: dimensionless
  std::optional<double> value;  ///< in that unit; nothing where the key is not given and has no default
};

/// The number that a dotted path names in the echo of a case; list entries by their name, side or number from 0. Throws
/// Error (wrong_input) with one sentence when there is no such key, or it holds no number.
EchoedNumber find_number(const nlohmann::json& echo, const std::string& key);

/// A [[study.random]] in figures, all in `unit`. Values that it does not give are those of the case, or infinite.
struct UncertainNumber {
  std::string key, unit;
  Distribution distribution = Distribution::normal;
  double mean = 0, deviation = 0;                            ///< normal and lognormal
  double mode = 0;                                           ///< triangular
  double lowest = -std::numeric_limits<double>::infinity();  ///< also where the range of a material's key ends
  double highest = std::numeric_limits<double>::infinity();
};

/// Throws Error (wrong_input) with one sentence when a value is missing, has another dimension, or does not fit the
/// distribution.
UncertainNumber resolve(const RandomNumber& number, const Case& data, const nlohmann::json& echo);

}  // namespace talus::input
