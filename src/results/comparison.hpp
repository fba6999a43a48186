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
void describe(Visitor& v, MethodRow& r);

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
void describe(Visitor& v, MethodSurface& r);

/// Slip surface of another method, evaluated by a method of slices.
struct HandedSurface {
  std::string from, to, title;
  std::optional<double> factor;
  std::string refusal;  ///< reason for which a search would reject it; empty if admissible
};
void describe(Visitor& v, HandedSurface& r);

struct PartialFactor {
  std::string key, title, symbol;
  double value = 1;
};
void describe(Visitor& v, PartialFactor& r);

/// A soil parameter before and after division by its partial factor.
struct DesignValue {
  std::string material, quantity, symbol, unit;
  double characteristic = 0, design = 0;  ///< [unit]
};
void describe(Visitor& v, DesignValue& r);

struct DesignLoad {
  std::string name;
  bool variable = false;
  double factor = 1;
};
void describe(Visitor& v, DesignLoad& r);

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
void describe(Visitor& v, DesignStatement& r);

enum class Topic { agreement, slices, elements, bounds, points, mechanism, seconds };
template <>
inline constexpr auto words<Topic> =
    std::array{"agreement", "slices", "elements", "bounds", "points", "mechanism", "seconds"};

/// A sentence and its topic.
struct Remark {
  Topic topic = Topic::agreement;
  std::string text;
};
void describe(Visitor& v, Remark& r);

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
void describe(Visitor& v, MethodComparison& r);

/// Unit of display: value in SI = displayed value × si.
struct Unit {
  std::string name;
  double si = 1;
};
void describe(Visitor& v, Unit& r);

/// A result under its name in [[compare]].
struct NamedResult {
  std::string name, title;
  std::optional<double> value;                   ///< [SI]; nullopt if it is not determined
  Unit unit;                                     ///< unit of display
  std::optional<std::string> undetermined = {};  ///< why it is not determined
};
void describe(Visitor& v, NamedResult& r);

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
void describe(Visitor& v, Comparison& r);

}  // namespace talus::results
