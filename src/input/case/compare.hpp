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

void describe(auto& v, Compare& c) {
  v.key(
      "name", c.name, plain().required().example(R"("factor_of_safety")"),
      "The result: `factor_of_safety`, `factor_of_safety.bilinear` (or another criterion), `curve.displacement[1.45]` "
      "(of the trial at that factor), `runout[1.75].moved_volume`, `stage[gravity].displacement`, "
      "`mesh.critical_time_step` and so on; `results` in `summary.json` lists all. Of element tests "
      "`test[NAME].q[0.1]` (at axial strain 0.1), `test[NAME].void_ratio` (at the end), `test[NAME].peak_q`. Of LEM "
      "`lem.spencer` (critical circle), `lem.noncircular.spencer`, `lem.surface[NAME].bishop`, "
      "`lem.yield_acceleration.spencer`; of FEM `fem.factor`, `fem.by_displacement`, "
      "`fem.associated.factor`; of one on the surface of another `lem.handed[fem.band].spencer`.");
  v.key("value", c.value, plain().required().example("1.4"),
        "The published or measured value: a number in SI units, or a text with a unit.");
  v.key("tolerance", c.tolerance, plain().at_least(0).required().example(R"("5 %")"),
        "Largest difference that passes: in per cent of the value, or an amount; a plain number is in the unit of the "
        "value.");
  v.key("source", c.source, plain().required().example(R"("Bishop, hand calculation")"), "Where the value comes from.");
}

}  // namespace talus::input
