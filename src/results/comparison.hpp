// SPDX-License-Identifier: MIT
#pragma once
// Comparison of the methods with one another, design values by partial factors, and the results of [[compare]] beside
// their expected values.

#include <optional>
#include <string>
#include <vector>

#include "base/methods.hpp"
#include "results/about.hpp"
#include "results/slices.hpp"

namespace talus::results {

template <>
inline constexpr auto words<Method> = std::array{"lem", "fem", "bounds", "mpm"};

/// Origin of the slip surface of a factor.
enum class SurfaceSource { none, critical, noncircular, given, handed, optimised, band, mechanism, slip_line };
template <>
inline constexpr auto words<SurfaceSource> = std::array{
    "none",         // no surface
    "critical",     // critical circle of LEM
    "noncircular",  // critical polyline of LEM
    "given",        // surface of the case
    "handed",       // surface of another method, evaluated by LEM
    "optimised",    // surface of another method, optimised by LEM
    "band",         // shear band of FEM
    "mechanism",    // mechanism of the upper bound
    "slip_line",    // slip line of MPM
};

/// Criterion of a factor of FEM: the largest factor with equilibrium, or the sharp rise of displacement.
enum class FactorMeasure { equilibrium, displacement };
template <>
inline constexpr auto words<FactorMeasure> = std::array{"equilibrium", "displacement"};

/// One factor of the table of methods.
struct MethodRow {
  Method method = Method::lem;
  std::string name;       ///< word of the method of slices, of the flow rule or of the criterion: "spencer", "as_given"
  std::string title;      ///< "Spencer", "FEM, ψ = φ"
  std::string label;      ///< title within its method: "Spencer", "ψ = φ"
  std::string criterion;  ///< such as "critical circle"
  std::string surface;    ///< name of its surface; empty if none is drawn
  SurfaceSource source = SurfaceSource::none;
  std::optional<FactorMeasure> measure;  ///< for FEM only
  std::optional<double> factor, lower, upper;
  std::optional<double> seconds;
  std::string note;
};
void describe(auto& v, As<MethodRow> auto& r) {
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

/// Names of the slip lines of FEM (ψ as given; ψ = φ), of the mechanism of the upper bound, and of MPM.
inline constexpr const char *band_name = "fem.band", *associated_band_name = "fem.associated.band",
                            *mechanism_name = "bounds.mechanism", *slip_line_name = "mpm.slip_line";

/// Suffix of the name of a second slip line where the soil moves to both sides; LEM does not evaluate this line.
inline constexpr const char* other_side_name = ".other_side";

/// Slip surface of a method, as drawn in the section.
struct MethodSurface {
  std::string name, title;
  Method method = Method::lem;
  std::optional<double> factor;
  std::vector<Point> points;          ///< [m]
  std::optional<std::string> source;  ///< for MPM: from which field the line was traced
  std::optional<int> direction;       ///< +1: towards larger x; nullopt if all soil moves in one direction
  std::optional<std::string> beside;  ///< name of the other side's surface, which LEM evaluates instead
};
void describe(auto& v, As<MethodSurface> auto& r) {
  v.key("name", r.name, {"", "name of the surface"});
  v.key("title", r.title, {"", "title"});
  v.key("method", r.method, {"", "method"});
  v.key("factor", r.factor, {"", "factor of safety"});
  v.key("points", r.points, {"m", "its points"});
  v.maybe("source", r.source, {"", "where the line was taken from"});
  v.maybe("direction", r.direction, {"", "1: its soil moves towards larger x, -1: towards smaller x"});
  v.maybe("beside", r.beside, {"", "name of the surface of the other side, which LEM evaluates instead"});
}

/// Slip surface of another method, evaluated by a method of slices.
struct HandedSurface {
  std::string from, to, title;
  std::optional<double> factor;
  std::string refusal;  ///< reason for which a search would reject it; empty if admissible
};
void describe(auto& v, As<HandedSurface> auto& r) {
  v.key("from", r.from, {"", "name of the surface"});
  v.key("to", r.to, {"", "method of slices"});
  v.key("title", r.title, {"", "title"});
  v.key("factor", r.factor, {"", "factor of safety"});
  v.key("refusal", r.refusal, {"", "why a search would refuse it"});
}

struct PartialFactor {
  std::string key, title, symbol;
  double value = 1;
};
void describe(auto& v, As<PartialFactor> auto& r) {
  v.key("key", r.key, {"", "key in the case"});
  v.key("title", r.title, {"", "what it divides or multiplies"});
  v.key("symbol", r.symbol, {"", "symbol"});
  v.key("value", r.value, {"", "value"});
}

/// A soil parameter before and after division by its partial factor.
struct DesignValue {
  std::string material, quantity, symbol, unit;
  double characteristic = 0, design = 0;  ///< [unit]
};
void describe(auto& v, As<DesignValue> auto& r) {
  v.key("material", r.material, {"", "material"});
  v.key("quantity", r.quantity, {"", "quantity"});
  v.key("symbol", r.symbol, {"", "symbol"});
  v.key("unit", r.unit, {"", "unit"});
  v.key("characteristic", r.characteristic, {"", "characteristic value"});
  v.key("design", r.design, {"", "design value"});
}

struct DesignLoad {
  std::string name;
  bool variable = false;
  double factor = 1;
};
void describe(auto& v, As<DesignLoad> auto& r) {
  v.key("name", r.name, {"", "surcharge"});
  v.key("variable", r.variable, {"", "whether it is variable"});
  v.key("factor", r.factor, {"", "factor"});
}

/// Values changed by the partial factors, and the over-design factor.
struct DesignStatement {
  std::string set;
  std::vector<PartialFactor> values;
  std::vector<DesignValue> materials;
  std::vector<DesignLoad> surcharges;
  std::optional<double> over_design;
  std::string text;
  std::vector<std::string> notes;
};
void describe(auto& v, As<DesignStatement> auto& r) {
  v.key("set", r.set, {"", "set of partial factors"});
  v.key("values", r.values, {"", "partial factors"});
  v.key("materials", r.materials, {"", "design values of the soils"});
  v.key("surcharges", r.surcharges, {"", "factors of the surcharges"});
  v.key("over_design", r.over_design, {"", "degree of over-design"});
  v.key("text", r.text, {"", "the same in words"});
  v.key("notes", r.notes, {"", "notes"});
}

enum class Topic { agreement, slices, elements, bounds, points, mechanism, seconds };
template <>
inline constexpr auto words<Topic> =
    std::array{"agreement", "slices", "elements", "bounds", "points", "mechanism", "seconds"};

/// A sentence and its topic.
struct Remark {
  Topic topic = Topic::agreement;
  std::string text;
};
void describe(auto& v, As<Remark> auto& r) {
  v.key("topic", r.topic, {"", "what it is about"});
  v.key("text", r.text, {"", "sentence"});
}

/// "methods" of summary.json.
struct MethodComparison {
  std::vector<Method> asked;
  std::vector<MethodRow> table;
  std::vector<MethodSurface> surfaces;
  std::vector<HandedSurface> handed;
  std::vector<CriticalSurface> optimised;  ///< surfaces of other methods, optimised by Spencer's method
  std::vector<std::string> warnings;       ///< on factors that differ widely
  std::vector<Remark> remarks;
  std::optional<DesignStatement> partial_factors;
  std::optional<std::string> unjudged;  ///< why limit analysis rules no factor of another method out
};
void describe(auto& v, As<MethodComparison> auto& r) {
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

/// Unit of display: value in SI = displayed value × si.
struct Unit {
  std::string name;
  double si = 1;
};
void describe(auto& v, As<Unit> auto& r) {
  v.key("name", r.name, {"", "unit"});
  v.key("si", r.si, {"", "one of it in SI"});
}

/// A result under its name in [[compare]].
struct NamedResult {
  std::string name, title;
  double value = 0;  ///< [SI]
  Unit unit;         ///< unit of display
};
void describe(auto& v, As<NamedResult> auto& r) {
  v.key("name", r.name, {"", "name"});
  v.key("title", r.title, {"", "title"});
  v.key("value", r.value, {"", "value in SI"});
  v.key("unit", r.unit, {"", "unit that it is shown in"});
}

/// A result beside the value that the case expects.
struct Comparison {
  std::string name, title;
  Unit unit;
  std::optional<double> computed;  ///< [SI]
  double published = 0;            ///< [SI]
  double tolerance = 0;            ///< [SI]
  std::string tolerance_text, source;
  bool passes = false;
  std::string note;
};
void describe(auto& v, As<Comparison> auto& r) {
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
