// SPDX-License-Identifier: MIT
#include "results/comparison.hpp"

#include "results/described.hpp"

namespace talus::results {

void describe(Visitor& v, MethodRow& r) {
  v.key("method", r.method, {"", "method"});
  v.key("name", r.name, {"", "which of its factors"});
  v.key("title", r.title, {"", "name of the method"});
  v.key("label", r.label, {"", "what distinguishes it from others of its method"});
  v.key("criterion", r.criterion, {"", "criterion"});
  v.key("surface", r.surface, {"", "name of the surface"});
  v.key("source", r.source, {"", "where the surface comes from"});
  v.maybe("measure", r.measure, {"", "what the factor is read off"});
  v.key("factor", r.factor, {"", "factor of safety"});
  v.key("lower", r.lower, {"", "lower end of the interval"});
  v.key("upper", r.upper, {"", "upper end of the interval"});
  v.key("seconds", r.seconds, {"s", "seconds"});
  v.key("note", r.note, {"", "what to know"});
}

void describe(Visitor& v, MethodSurface& r) {
  v.key("name", r.name, {"", "name of the surface"});
  v.key("title", r.title, {"", "title"});
  v.key("method", r.method, {"", "method"});
  v.key("factor", r.factor, {"", "factor of safety"});
  v.key("points", r.points, {"m", "its points"});
  v.maybe("source", r.source, {"", "where the line was taken from"});
  v.maybe("direction", r.direction, {"", "1: its soil moves towards larger x, -1: towards smaller x"});
  v.maybe("beside", r.beside, {"", "name of the surface of the other side, which LEM evaluates instead"});
}

void describe(Visitor& v, HandedSurface& r) {
  v.key("from", r.from, {"", "name of the surface"});
  v.key("to", r.to, {"", "method of slices"});
  v.key("title", r.title, {"", "title"});
  v.key("factor", r.factor, {"", "factor of safety"});
  v.key("refusal", r.refusal, {"", "why a search would refuse it"});
}

void describe(Visitor& v, PartialFactor& r) {
  v.key("key", r.key, {"", "key in the case"});
  v.key("title", r.title, {"", "what it divides or multiplies"});
  v.key("symbol", r.symbol, {"", "symbol"});
  v.key("value", r.value, {"", "value"});
}

void describe(Visitor& v, DesignValue& r) {
  v.key("material", r.material, {"", "material"});
  v.key("quantity", r.quantity, {"", "quantity"});
  v.key("symbol", r.symbol, {"", "symbol"});
  v.key("unit", r.unit, {"", "unit"});
  v.key("characteristic", r.characteristic, {"", "characteristic value"});
  v.key("design", r.design, {"", "design value"});
}

void describe(Visitor& v, DesignLoad& r) {
  v.key("name", r.name, {"", "surcharge"});
  v.key("variable", r.variable, {"", "whether it is variable"});
  v.key("factor", r.factor, {"", "factor"});
}

void describe(Visitor& v, DesignStatement& r) {
  v.key("set", r.set, {"", "set of partial factors"});
  v.key("values", r.values, {"", "partial factors"});
  v.key("materials", r.materials, {"", "design values of the soils"});
  v.key("surcharges", r.surcharges, {"", "factors of the surcharges"});
  v.key("over_design", r.over_design, {"", "degree of over-design"});
  v.key("text", r.text, {"", "the same in words"});
  v.key("notes", r.notes, {"", "notes"});
}

void describe(Visitor& v, Remark& r) {
  v.key("topic", r.topic, {"", "what it is about"});
  v.key("text", r.text, {"", "sentence"});
}

void describe(Visitor& v, MethodComparison& r) {
  v.key("asked", r.asked, {"", "methods of the case"});
  v.key("table", r.table, {"", "factors of all methods"});
  v.key("surfaces", r.surfaces, {"", "surfaces of all methods"});
  v.key("handed", r.handed, {"", "surfaces of other methods evaluated by LEM"});
  v.key("optimised", r.optimised, {"", "surfaces that LEM optimised from those of other methods"});
  v.key("warnings", r.warnings, {"", "warnings on factors that lie far apart"});
  v.key("remarks", r.remarks, {"", "reasons of the differences"});
  v.key("partial_factors", r.partial_factors, {"", "design values"});
  v.maybe("unjudged", r.unjudged, {"", "why limit analysis rules no factor of another method out"});
}

void describe(Visitor& v, Unit& r) {
  v.key("name", r.name, {"", "unit"});
  v.key("si", r.si, {"", "one of it in SI"});
}

void describe(Visitor& v, NamedResult& r) {
  v.key("name", r.name, {"", "name"});
  v.key("title", r.title, {"", "title"});
  v.key("value", r.value, {"", "value in SI; null if it is not determined"});
  v.key("unit", r.unit, {"", "unit that it is shown in"});
  v.maybe("undetermined", r.undetermined, {"", "why it is not determined"});
}

void describe(Visitor& v, Comparison& r) {
  v.key("name", r.name, {"", "name"});
  v.key("title", r.title, {"", "title"});
  v.key("unit", r.unit, {"", "unit that it is shown in"});
  v.key("computed", r.computed, {"", "computed value in SI"});
  v.key("published", r.published, {"", "published value in SI"});
  v.key("tolerance", r.tolerance, {"", "tolerance in SI"});
  v.key("tolerance_text", r.tolerance_text, {"", "tolerance as the case has it"});
  v.key("source", r.source, {"", "source"});
  v.key("passes", r.passes, {"", "whether the difference is within the tolerance"});
  v.key("note", r.note, {"", "what to know"});
}

}  // namespace talus::results
