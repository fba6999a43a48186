// SPDX-License-Identifier: MIT
#pragma once
// Results of limit analysis: the bounds, the interval that limits the factors of limit equilibrium, the meshes, and the
// fields that prove the bounds.

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "results/about.hpp"
#include "results/water.hpp"

namespace talus::results {

/// Classification of a factor by the bounds of limit analysis.
enum class Verdict { possible, too_low, too_high };
template <>
inline constexpr auto words<Verdict> = std::array{"possible", "below_lower_bound", "above_upper_bound"};

/// Return a bound as printed, with three decimals. Rounding is away from the middle of the interval, so that the
/// printed bound is also proven.
inline double show_lower(double factor) {
  return std::floor(1e3 * factor) / 1e3;
}
inline double show_upper(double factor) {
  return std::ceil(1e3 * factor) / 1e3;
}

/// Factors within this fraction of a bound are not judged by it: searches and slices scatter by as much.
inline constexpr double judging_tolerance = 2e-3;
/// Width of an interval over its middle above which no factor is ruled out as too low: the factors left may be too high
/// by as much as the interval is wide, which would be unsafe.
inline constexpr double widest_judging = 0.05;

/// "lem.referee" of summary.json: the interval that limit analysis proves for the soil of limit equilibrium. It assumes
/// ψ = φ, tension up to the apex c/tan φ, and fixed ends and base of the section.
struct Referee {
  std::optional<std::string> why_not;  ///< why no interval was computed
  std::optional<double> lower, upper;
  std::string no_lower, no_upper;         ///< why there is no bound; empty if there is one
  std::optional<std::string> upper_only;  ///< why factors below the lower bound are not rejected
  int triangles = 0, programs = 0;
  double seconds = 0;

  bool is_interval() const { return lower && upper; }
  /// Returns the width of the interval over its middle; infinity without one.
  double find_width() const {
    return is_interval() ? 2 * (*upper - *lower) / (*upper + *lower) : std::numeric_limits<double>::infinity();
  }
  bool is_wide() const { return find_width() > widest_judging; }
  /// Classifies a factor of limit equilibrium against the printed bounds. Only a narrow interval rules factors out as
  /// too low.
  Verdict judge(double factor) const {
    if (upper && factor > (1 + judging_tolerance) * show_upper(*upper)) return Verdict::too_high;
    const bool is_low = !is_wide() && !upper_only && factor < (1 - judging_tolerance) * show_lower(*lower);
    return is_low ? Verdict::too_low : Verdict::possible;
  }
};
void describe(Visitor& v, Referee& r);

/// Returns "to the left" or "to the right"; x grows to the right.
inline const char* name_side(int direction) {
  return direction < 0 ? "to the left" : "to the right";
}

struct SideLine {
  int direction = 1;          ///< +1: the soil moves towards larger x
  std::vector<Point> points;  ///< [m]
};
void describe(Visitor& v, SideLine& r);

/// Direction of the governing earthquake, where both directions were tried.
struct EarthquakeSide {
  int direction = 0;                   ///< -1: towards smaller x, +1: towards larger x
  std::optional<double> other_stable;  ///< factor at which the slope is stable under the other direction
};
void describe(Visitor& v, EarthquakeSide& r);

/// Returns "the earthquake towards smaller x governs (towards larger x WHAT 1.620)"; `what` replaces WHAT.
std::string describe_side(const EarthquakeSide& side, const char* what);
inline constexpr const char *stable_on_mesh = "the same mesh is in equilibrium at",
                            *proven_stable = "the lower bound is";

/// One of the nested meshes of the adaptive refinement.
struct BoundsMesh {
  int triangles = 0;
  std::optional<double> lower, upper;  ///< best bounds proven on this mesh and the coarser ones
  int programs = 0, iterations = 0;
  double seconds = 0;  ///< since the start of the first mesh
};
void describe(Visitor& v, BoundsMesh& r);

/// "bounds" of summary.json.
struct BoundsResult {
  std::optional<std::string> error;  ///< why limit analysis gave no result
  std::vector<std::string> warnings;
  std::optional<double> lower, upper;
  std::string no_lower, no_upper;  ///< why there is no bound; empty if there is one
  double asked_gap = 0;            ///< required width of the interval over its middle
  bool is_davis = false;           ///< the strength is that of Davis, so the bounds do not hold for the given soil
  bool takes_tension = false;      ///< the given tensile strength of the soils is used
  double imbalance = 0;            ///< largest imbalance of the stress field over the largest load or overburden [-]
  std::vector<BoundsMesh> meshes;
  std::optional<std::vector<SideLine>> sides;  ///< slip lines of the mechanism
  std::optional<EarthquakeSide> earthquake;    ///< nullopt if there is no earthquake or the case gives its direction
  std::string fields_file;
  std::optional<Seepage> seepage;
  std::optional<double> seconds;

  /// Returns true if both bounds were proven.
  bool is_interval() const { return lower && upper; }
};
void describe(Visitor& v, BoundsResult& r);

/// Stress field of the lower bound.
struct HoldingField {
  std::vector<Point> nodes;  ///< [m]
  std::vector<std::vector<int>> triangles;
  std::vector<std::vector<double>> stress;  ///< by triangle: effective xx, yy, xy at its corners [Pa], tension positive
  /// By triangle: pore pressure at its corners [Pa], positive in compression and linear between them. It is not below
  /// that of the case. Without a value there is none.
  std::optional<std::vector<std::vector<double>>> pressure;
  std::vector<double> utilisation;  ///< by triangle: factor of the field over that of its worst corner
};
void describe(Visitor& v, HoldingField& r);

/// Velocity field of the upper bound.
struct MovingField {
  std::vector<Point> nodes;  ///< corner nodes, then midside nodes [m]
  std::vector<std::vector<int>> triangles;
  std::vector<Point> velocity;     ///< of the nodes, scaled so that the largest is 1
  std::vector<double> shear_rate;  ///< by triangle, scaled so that the largest is 1
};
void describe(Visitor& v, MovingField& r);

/// bounds.json: the results that a resumed run reads instead of computing them again, and the fields.
struct BoundsFile {
  std::string input_hash;
  BoundsResult summary;
  HoldingField holds;
  MovingField moves;
};
void describe(Visitor& v, BoundsFile& r);

}  // namespace talus::results
