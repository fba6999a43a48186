// SPDX-License-Identifier: MIT
#pragma once
// The methods beside one another, design values, and results by name beside what the case expects.

#include <optional>
#include <string>
#include <vector>

#include "base/methods.hpp"
#include "results/about.hpp"
#include "results/slices.hpp"

namespace talus::results {

template <>
inline constexpr auto words<Method> = std::array{Word{Method::lem, "lem"}, Word{Method::fem, "fem"},
                                                 Word{Method::bounds, "bounds"}, Word{Method::mpm, "mpm"}};

/// Where the surface of a factor comes from.
enum class SurfaceSource { none, critical, noncircular, given, handed, optimised, band, mechanism, slip_line };
template <>
inline constexpr auto words<SurfaceSource> =
    std::array{Word{SurfaceSource::none, "none"},                // none is drawn
               Word{SurfaceSource::critical, "critical"},        // critical circle of slices
               Word{SurfaceSource::noncircular, "noncircular"},  // critical polyline of slices
               Word{SurfaceSource::given, "given"},              // of the case
               Word{SurfaceSource::handed, "handed"},            // of another method, given to slices
               Word{SurfaceSource::optimised, "optimised"},      // the same, improved by slices
               Word{SurfaceSource::band, "band"},                // of the shear strain of finite elements
               Word{SurfaceSource::mechanism, "mechanism"},      // of the upper bound
               Word{SurfaceSource::slip_line, "slip_line"}};     // of the material points

/// The criterion of a factor of finite elements: no equilibrium beyond it, or displacements that run away.
enum class FactorMeasure { equilibrium, displacement };
template <>
inline constexpr auto words<FactorMeasure> =
    std::array{Word{FactorMeasure::equilibrium, "equilibrium"}, Word{FactorMeasure::displacement, "displacement"}};

/// One factor of the table of methods.
struct MethodRow {
  Method method = Method::lem;
  std::string name;       ///< word of the method of slices, the flow rule or the criterion: "spencer", "as_given"
  std::string title;      ///< "Spencer", "Finite elements, ψ = φ"
  std::string label;      ///< the same beside its method: "Spencer", "ψ = φ"; empty: unknown to an older version
  std::string criterion;  ///< "critical circle"
  std::string surface;    ///< name of its surface; empty: none is drawn
  std::optional<SurfaceSource> source;   ///< nothing: unknown to an older version
  std::optional<FactorMeasure> measure;  ///< of finite elements alone
  std::optional<double> factor, lower, upper;
  std::optional<double> seconds;
  std::string note;
};
template <class V, As<MethodRow> R>
void describe(V& v, R& r) {
  v.key("method", r.method, {"", "method"});
  v.key("name", r.name, {"", "which of its factors"});
  v.key("title", r.title, {"", "name of the method"});
  v.key("label", r.label, {"", "what tells it from others of its method"});
  v.key("criterion", r.criterion, {"", "criterion"});
  v.key("surface", r.surface, {"", "name of the surface"});
  v.maybe("source", r.source, {"", "where the surface comes from"});
  v.maybe("measure", r.measure, {"", "what the factor is read off"});
  v.key("factor", r.factor, {"", "factor of safety"});
  v.key("lower", r.lower, {"", "lower end of the interval"});
  v.key("upper", r.upper, {"", "upper end of the interval"});
  v.key("seconds", r.seconds, {"s", "seconds"});
  v.key("note", r.note, {"", "what to know"});
}

/// Names of the lines that finite elements (ψ as given; with ψ = φ), the mechanism of the upper bound and material
/// points slide along.
inline constexpr const char *band_name = "fem.band", *associated_band_name = "fem.associated.band",
                            *mechanism_name = "bounds.mechanism", *slip_line_name = "mpm.slip_line";

/// What follows the name of a line where the soil moves to both sides, of the side that slices are not given.
inline constexpr const char* other_side_name = ".other_side";

/// A surface of a method, for the section.
struct MethodSurface {
  std::string name, title;
  Method method = Method::lem;
  std::optional<double> factor;
  std::vector<Point> points;          ///< [m]
  std::optional<std::string> source;  ///< of material points: where the line was taken from
  std::optional<int> direction;       ///< +1: its soil moves towards larger x; nothing: all soil moves one way
  std::optional<std::string> beside;  ///< the surface of the other side, which slices are given instead of this one
};
template <class V, As<MethodSurface> R>
void describe(V& v, R& r) {
  v.key("name", r.name, {"", "name of the surface"});
  v.key("title", r.title, {"", "title"});
  v.key("method", r.method, {"", "method"});
  v.key("factor", r.factor, {"", "factor of safety"});
  v.key("points", r.points, {"m", "its points"});
  v.maybe("source", r.source, {"", "where the line was taken from"});
  v.maybe("direction", r.direction, {"", "1: its soil moves towards larger x, -1: towards smaller x"});
  v.maybe("beside", r.beside, {"", "name of the surface of the other side, which slices are given instead"});
}

/// A surface of one method given to a method of slices.
struct HandedSurface {
  std::string from, to, title;
  std::optional<double> factor;
  std::string refusal;  ///< why a search would refuse it
};
template <class V, As<HandedSurface> R>
void describe(V& v, R& r) {
  v.key("from", r.from, {"", "name of the surface"});
  v.key("to", r.to, {"", "method of slices"});
  v.key("title", r.title, {"", "title"});
  v.key("factor", r.factor, {"", "factor of safety"});
  v.key("refusal", r.refusal, {"", "why a search would refuse it"});
}

/// A partial factor.
struct PartialFactor {
  std::string key, title, symbol;
  double value = 1;
};
template <class V, As<PartialFactor> R>
void describe(V& v, R& r) {
  v.key("key", r.key, {"", "key in the case"});
  v.key("title", r.title, {"", "what it divides or multiplies"});
  v.key("symbol", r.symbol, {"", "symbol"});
  v.key("value", r.value, {"", "value"});
}

/// A number of a soil before and after.
struct DesignValue {
  std::string material, quantity, symbol, unit;
  double characteristic = 0, design = 0;  ///< in `unit`
};
template <class V, As<DesignValue> R>
void describe(V& v, R& r) {
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
template <class V, As<DesignLoad> R>
void describe(V& v, R& r) {
  v.key("name", r.name, {"", "surcharge"});
  v.key("variable", r.variable, {"", "whether it is variable"});
  v.key("factor", r.factor, {"", "factor"});
}

/// The changes by partial factors, and the over-design factor.
struct DesignStatement {
  std::string set;
  std::vector<PartialFactor> values;
  std::vector<DesignValue> materials;
  std::vector<DesignLoad> surcharges;
  std::optional<double> over_design;
  std::string text;
  std::vector<std::string> notes;
};
template <class V, As<DesignStatement> R>
void describe(V& v, R& r) {
  v.key("set", r.set, {"", "set of partial factors"});
  v.key("values", r.values, {"", "partial factors"});
  v.key("materials", r.materials, {"", "design values of the soils"});
  v.key("surcharges", r.surcharges, {"", "factors of the surcharges"});
  v.key("over_design", r.over_design, {"", "degree of over-design"});
  v.key("text", r.text, {"", "the same in words"});
  v.key("notes", r.notes, {"", "notes"});
}

/// The subject of a remark.
enum class Topic { agreement, slices, elements, bounds, points, mechanism, seconds };
template <>
inline constexpr auto words<Topic> =
    std::array{Word{Topic::agreement, "agreement"}, Word{Topic::slices, "slices"}, Word{Topic::elements, "elements"},
               Word{Topic::bounds, "bounds"},       Word{Topic::points, "points"}, Word{Topic::mechanism, "mechanism"},
               Word{Topic::seconds, "seconds"}};

/// A sentence, with what it is about.
struct Remark {
  Topic topic = Topic::agreement;
  std::string text;
};
template <class V, As<Remark> R>
void describe(V& v, R& r) {
  v.key("topic", r.topic, {"", "what it is about"});
  v.key("text", r.text, {"", "sentence"});
}

/// "methods" of summary.json.
struct MethodComparison {
  std::vector<Method> asked;
  std::vector<MethodRow> table;
  std::vector<MethodSurface> surfaces;
  std::vector<HandedSurface> handed;
  std::vector<CriticalSurface> optimised;  ///< Spencer's, from the surfaces of other methods
  std::vector<std::string> warnings;       ///< on factors that lie far apart
  std::vector<Remark> remarks;
  std::optional<DesignStatement> partial_factors;

  // Compiled once, in special_members.cpp: the files that hold one would each compile them again.
  MethodComparison();
  MethodComparison(const MethodComparison&);
  MethodComparison(MethodComparison&&) noexcept;
  MethodComparison& operator=(const MethodComparison&);
  MethodComparison& operator=(MethodComparison&&) noexcept;
  ~MethodComparison();
};
template <class V, As<MethodComparison> R>
void describe(V& v, R& r) {
  v.key("asked", r.asked, {"", "methods that the case asks for"});
  v.key("table", r.table, {"", "factors of all methods"});
  v.key("surfaces", r.surfaces, {"", "surfaces of all methods"});
  v.key("handed", r.handed, {"", "surfaces that slices were given"});
  v.key("optimised", r.optimised, {"", "surfaces that slices improved from those of other methods"});
  v.key("warnings", r.warnings, {"", "warnings on factors that lie far apart"});
  v.key("remarks", r.remarks, {"", "what the differences say"});
  v.key("partial_factors", r.partial_factors, {"", "design values"});
}

/// A unit as results are shown in it: value in SI = value shown × si.
struct Unit {
  std::string name;
  double si = 1;
};
template <class V, As<Unit> R>
void describe(V& v, R& r) {
  v.key("name", r.name, {"", "unit"});
  v.key("si", r.si, {"", "one of it in SI"});
}

/// A result under the name that [[compare]] calls it by.
struct NamedResult {
  std::string name, title;
  double value = 0;  ///< SI
  Unit unit;         ///< that it is shown in
};
template <class V, As<NamedResult> R>
void describe(V& v, R& r) {
  v.key("name", r.name, {"", "name"});
  v.key("title", r.title, {"", "title"});
  v.key("value", r.value, {"", "value in SI"});
  v.key("unit", r.unit, {"", "unit that it is shown in"});
}

/// A result beside what the case expects.
struct Comparison {
  std::string name, title;
  Unit unit;
  std::optional<double> computed;  ///< SI
  double published = 0;            ///< SI
  double tolerance = 0;            ///< SI
  std::string tolerance_text, source;
  bool passes = false;
  std::string note;
};
template <class V, As<Comparison> R>
void describe(V& v, R& r) {
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
