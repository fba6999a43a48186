// SPDX-License-Identifier: MIT
#pragma once
// Results by the names that [[compare]], studies and Python call them by: "runout[1.75].front_advance".

#include <optional>
#include <string>
#include <vector>

#include "results/run.hpp"

namespace talus::results {

/// What a result is about.
enum class ResultKind { factor, yield_acceleration, over_design, runout, motion, stage, mesh, water, seepage, other };
template <>
inline constexpr auto words<ResultKind> = std::array{Word{ResultKind::factor, "factor"},
                                                     Word{ResultKind::yield_acceleration, "yield_acceleration"},
                                                     Word{ResultKind::over_design, "over_design"},
                                                     Word{ResultKind::runout, "runout"},
                                                     Word{ResultKind::motion, "motion"},
                                                     Word{ResultKind::stage, "stage"},
                                                     Word{ResultKind::mesh, "mesh"},
                                                     Word{ResultKind::water, "water"},
                                                     Word{ResultKind::seepage, "seepage"},
                                                     Word{ResultKind::other, "other"}};

/// A number of a run under its name.
/// The uncertainty that the mesh leaves in a value; nothing where it was calculated on one mesh.
struct MeshUncertainty {
  std::optional<double> value;
};

struct NamedValue {
  std::string name;   ///< "runout[1.75].moved_volume"
  std::string title;  ///< "moved volume, runout at SRF 1.75"
  std::string unit;   ///< SI, as UDUNITS writes it; empty for a plain number
  ResultKind kind = ResultKind::other;
  std::string quantity;           ///< "moved_volume"
  std::optional<SliceMethod> by;  ///< of the slices, factors and accelerations
  double value = 0;               ///< [unit]
  /// Uncertainty of a runout by its mesh; nothing where the number has none.
  std::optional<MeshUncertainty> uncertainty = {};
};

/// All numbers that `run` holds, in the order of the report, but the displacements of single trials. `dimension` is
/// that of the section: a plane one is one metre thick.
std::vector<NamedValue> list_values(const RunResult& run, int dimension);

/// Whether two names call one result. A time of the timeline is a number, which a reader may round or write otherwise:
/// `timeline.factor[1110093]` is the factor at a time within a millionth of that.
bool is_same_result(const std::string& known, const std::string& asked);

/// The one called `name` [SI]; nothing when the run did not reach it.
std::optional<double> find_value(const RunResult& run, const std::string& name);

/// The displacement at a factor of the curve, interpolated between its neighbours where no trial has that factor.
struct CurveValue {
  std::optional<double> displacement;  ///< [m]
  std::string note;                    ///< between which trials it was interpolated; empty: it was calculated
};
CurveValue find_displacement(const RunResult& run, double factor);

}  // namespace talus::results
