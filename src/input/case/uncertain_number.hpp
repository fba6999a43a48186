// SPDX-License-Identifier: MIT
#pragma once
// Numbers of a case by key: those of a material, those of an echo, and a [[study.random]] evaluated for its case.

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

// The numbers of a material by their keys in the case file: "kappa", "water.conductivity".

/// A key of a material that has one number.
struct NumberKey {
  std::string path;
  Spec spec;                    ///< unit and range of the manual
  double factor = 1;            ///< one `spec.unit` in the unit in which the material stores the key
  std::optional<double> value;  ///< as stored in the material; std::nullopt: not given
  bool applies = true;          ///< applies to the material's model
};

std::vector<NumberKey> list_number_keys(const Material& material);
/// Returns the key of that path; std::nullopt if the material has none.
std::optional<NumberKey> find_number_key(const Material& material, const std::string& path);
/// Sets the key to another value and updates what follows from it. Throws Error (wrong_input) if there is no such key.
void set_number(Material& material, const std::string& path, double value);

// The method of [analysis] that a sampling study requires.

constexpr Method find_method(SampledMethod sampled) {
  return sampled == SampledMethod::lem ? Method::lem : sampled == SampledMethod::fem ? Method::fem : Method::mpm;
}

/// A number of the case file.
struct EchoedNumber {
  std::string unit;             ///< of the manual; empty: dimensionless
  std::optional<double> value;  ///< in that unit; std::nullopt: not given and without default
};

/// Returns the number at a dotted path in the echo of a case; list entries by name, side or index from 0. Throws Error
/// (wrong_input) with one sentence if there is no such key, or if it is not a number.
EchoedNumber find_number(const nlohmann::json& echo, const std::string& key);

/// A [[study.random]] with numerical values in `unit`. Values that are not given are those of the case, or infinite.
struct UncertainNumber {
  std::string key, unit;
  Distribution distribution = Distribution::normal;
  double mean = 0, deviation = 0;                            ///< normal and lognormal
  double mode = 0;                                           ///< triangular
  double lowest = -std::numeric_limits<double>::infinity();  ///< truncation; at most the range of a material's key
  double highest = std::numeric_limits<double>::infinity();
};

/// Throws Error (wrong_input) with one sentence if a value is missing, has another dimension, or does not fit the
/// distribution.
UncertainNumber resolve(const RandomNumber& number, const Case& data, const nlohmann::json& echo);

}  // namespace talus::input
