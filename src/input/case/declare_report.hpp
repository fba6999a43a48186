#pragma once
// [project] and [[compare]]: what a report shows besides the results.

#include "input/case/case.hpp"
#include "input/language/codec.hpp"

namespace talus::input {

template <class Visitor>
void describe(Visitor& v, Project& p) {
  v.key("name", p.name, plain().example(R"("Bypass, cut 3")"), "Name or number of the project.");
  v.key("client", p.client, plain().example(R"("County road office")"), "For whom.");
  v.key("author", p.author, plain().example(R"("A. Engineer")"), "Who prepared the case.");
  v.key("checked_by", p.checked_by, plain().example(R"("B. Engineer")"), "Who checked it.");
  v.key("revision", p.revision, plain().example(R"("A")"), "Revision of the case.");
  v.key("notes", p.notes, plain().example(R"("Preliminary design")"), "Anything a reader of the report must know.");
}

template <class Visitor>
void describe(Visitor& v, Compare& c) {
  v.key("name", c.name, plain().required().example(R"("factor_of_safety")"),
        "The result: `factor_of_safety`, `factor_of_safety.bilinear` (or another criterion), "
        "`curve.displacement[1.45]` (of the trial at that factor), `runout[1.75].moved_volume`, "
        "`stage[gravity].displacement`, `mesh.critical_time_step` and so on; `results` in `summary.json` lists all. Of "
        "element tests "
        "`test[NAME].q[0.1]` (at axial strain 0.1), `test[NAME].void_ratio` (at the end), `test[NAME].peak_q`. Of "
        "slices `lem.spencer` (critical circle), "
        "`lem.noncircular.spencer`, `lem.surface[NAME].bishop`, `lem.yield_acceleration.spencer`; of finite elements "
        "`fem.factor`, `fem.by_displacement`, `fem.associated.factor`; of one on the surface of another "
        "`lem.handed[fem.band].spencer`.");
  v.key("value", c.value, plain().required().example("1.4"),
        "The published or measured value: a number in SI units, or a text with a unit.");
  v.key("tolerance", c.tolerance, plain().at_least(0).required().example(R"("5 %")"),
        "Largest difference that passes: in per cent of the value, or an amount; a plain number is in the unit of the "
        "value.");
  v.key("source", c.source, plain().required().example(R"("Bishop, hand calculation")"), "Where the value comes from.");
}

}  // namespace talus::input
