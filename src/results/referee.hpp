// SPDX-License-Identifier: MIT
#pragma once
// The interval of limit analysis that the factors of limit equilibrium are held against.

#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "results/about.hpp"

namespace talus::results {

/// What limit analysis proves of a factor.
enum class Verdict { possible, too_low, too_high };
template <>
inline constexpr auto words<Verdict> =
    std::array{Word{Verdict::possible, "possible"}, Word{Verdict::too_low, "below_lower_bound"},
               Word{Verdict::too_high, "above_upper_bound"}};

/// A bound as it is shown, with the three digits of a factor: rounded away from the interval's middle, so that what is
/// shown is proven too.
inline double show_lower(double factor) {
  return std::floor(1e3 * factor) / 1e3;
}
inline double show_upper(double factor) {
  return std::ceil(1e3 * factor) / 1e3;
}

/// "lem.referee" of summary.json. Soil as limit equilibrium has it: ψ = φ, tension up to the apex c/tan φ, ends and
/// base of the section fixed.
struct Referee {
  std::optional<std::string> why_not;  ///< why limit analysis cannot judge; then nothing below
  std::optional<double> lower, upper;
  std::string no_lower, no_upper;         ///< why there is no bound; empty where there is one
  std::optional<std::string> upper_only;  ///< why factors below the lower bound are not refused
  int triangles = 0, programs = 0;
  double seconds = 0;

  bool is_interval() const { return lower && upper; }
  /// Of a factor of limit equilibrium. Bounds are taken as they are shown.
  Verdict judge(double factor) const {
    if (upper && factor > show_upper(*upper)) return Verdict::too_high;
    return lower && !upper_only && factor < show_lower(*lower) ? Verdict::too_low : Verdict::possible;
  }
};
template <class V, As<Referee> R>
void describe(V& v, R& r) {
  v.maybe("why_not", r.why_not, {"", "why limit analysis cannot judge the factors of limit equilibrium"});
  if (r.why_not) return;
  v.key("lower", r.lower, {"", "proven lower bound for the soil of limit equilibrium"});
  v.key("upper", r.upper, {"", "proven upper bound for the soil of limit equilibrium"});
  v.key("no_lower", r.no_lower, {"", "why there is no lower bound"});
  v.key("no_upper", r.no_upper, {"", "why there is no upper bound"});
  v.maybe("upper_only", r.upper_only, {"", "why factors below the lower bound are not refused"});
  v.key("triangles", r.triangles, {"", "triangles of the finest mesh"});
  v.key("programs", r.programs, {"", "cone programs"});
  v.key("seconds", r.seconds, {"s", "seconds"});
}

}  // namespace talus::results
