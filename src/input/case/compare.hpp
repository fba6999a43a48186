// SPDX-License-Identifier: MIT
#pragma once
// [[compare]]: a reference value for a result.

#include <string>

#include "input/language/forms.hpp"
#include "input/language/spec.hpp"

namespace talus::input {

/// A published or measured reference value for a result.
struct Compare {
  std::string name;  ///< name of the result, see result_names.hpp
  Amount value;
  Amount tolerance;  ///< in per cent of the value, or in its unit
  std::string source;
};

/// Returns `amount` in SI. A plain number is in SI already.
double to_si(const Amount& amount);

/// Returns true if a tolerance is in per cent of the value.
bool is_relative(const Amount& tolerance);

/// Returns the allowed difference [SI]: per cent are of the value, a plain number is in its unit.
double find_tolerance(const Compare& compare);

void describe(Visitor& v, Compare& c);

}  // namespace talus::input
