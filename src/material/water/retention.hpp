// SPDX-License-Identifier: MIT
#pragma once
// Soil water retention curves: degree of saturation as a function of suction. Suction is the pore pressure itself,
// positive in tension; for s <= 0 every curve has S = S_max and slope 0.
//
// A curve is a plain struct with the limits `minimum` and `maximum` [-] and
//   template <class T> CurvePoint<T> evaluate(T suction) const     S [-] and dS/ds [1/Pa], for a Pack or a double
// A new curve needs its struct, one alternative in Retention, its checks in retention.cpp, and a test in
// tests/point/retention.cpp.

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/lane.hpp"
#include "base/portable.hpp"
#include "material/water/monotone_table.hpp"

namespace talus::material {

/// S = S_max at any suction.
struct ConstantSaturation {
  double minimum = 0;  ///< S_min [-]; without effect, the effective saturation is 1
  double maximum = 1;  ///< S_max [-]

  template <class T>
  TALUS_KERNEL CurvePoint<T> evaluate(T /*suction*/) const {
    return {T(maximum), T(0.0)};
  }
};

/// S = S_min + (S_max - S_min) [1 + (s/p_ref)^(1/(1-λ))]^(-λ), (3.13), after van Genuchten (1980).
struct VanGenuchten {
  double minimum = 0;    ///< S_min [-]
  double maximum = 1;    ///< S_max [-]
  double reference = 0;  ///< p_ref [Pa]
  double lambda = 0;     ///< λ [-], between 0 and 1

  template <class T>
  TALUS_KERNEL CurvePoint<T> evaluate(T suction) const {
    const auto dry = suction > T(0.0);
    const T s = lane_max(suction, T(1e-30 * reference));  // avoids the logarithm of 0
    const T u = lane_power(s * (1 / reference), 1 / (1 - lambda));
    const T v = (maximum - minimum) * lane_power(1.0 + u, -lambda);
    const T slope = v * u / ((1.0 + u) * s) * (-lambda / (1 - lambda));
    return {select(dry, minimum + v, T(maximum)), select(dry, slope, T(0.0))};
  }

  /// Expansion of the curve about a suction s_0 > 0 in y = ln(s/s_0). The curve is a power law in dry soil and nearly
  /// one close to saturation, so four terms give S_e to 1e-11 for |y| < series_reach() without a further logarithm.
  template <class T>
  struct Series {
    T effective;       ///< S_e at s_0
    T c1, c2, c3, c4;  ///< ln S_e = ln S_e(s_0) + c1 y + c2 y² + ...
    T complement;      ///< (1 - S_e^(1/λ))^λ at s_0, the factor in Mualem's k_r

    TALUS_KERNEL T find_effective(T y) const {
      const T e = y * (c1 + y * (c2 + y * (c3 + y * c4)));
      return effective * (1.0 + e * (1.0 + e * (1.0 / 2 + e * (1.0 / 6 + e * (1.0 / 24)))));
    }
    /// Returns d ln S_e/dy.
    TALUS_KERNEL T find_slope(T y) const { return c1 + y * (2.0 * c2 + y * (3.0 * c3 + y * (4.0 * c4))); }
    TALUS_KERNEL T find_complement(T y, T effective_there, double exponent) const {
      const T x = y * (exponent / (1 - exponent));  // the complement is (s/p_ref)^(λ/(1-λ)) S_e
      return complement / effective * effective_there *
             (1.0 + x * (1.0 + x * (1.0 / 2 + x * (1.0 / 6 + x * (1.0 / 24)))));
    }
  };
  double series_reach() const { return 8e-3 * (1 - lambda); }
  template <class T>
  TALUS_KERNEL Series<T> expand(T suction) const {
    const double a = 1 / (1 - lambda);
    const T x = suction * (1 / reference), u = lane_power(x, a), inverse = 1.0 / (1.0 + u);
    Series<T> s;
    s.effective = lane_power(1.0 + u, -lambda);
    const T w = u * inverse, b = w * inverse;  // dw/dy = a w (1-w)
    s.c1 = w * (-lambda * a);
    s.c2 = b * (-lambda * a * a / 2);
    s.c3 = b * (1.0 - 2.0 * w) * (-lambda * a * a * a / 6);
    s.c4 = b * (1.0 - 6.0 * b) * (-lambda * a * a * a * a / 24);
    s.complement = u / x * s.effective;
    return s;
  }
};

/// S = max(S_max - a s, S_min).
struct LinearRetention {
  double minimum = 0;
  double maximum = 1;
  double slope = 0;  ///< a [1/Pa]

  /// Returns the line that reaches S_min at the suction `scale` [Pa].
  static LinearRetention from_scale(double minimum, double maximum, double scale) {
    return {minimum, maximum, (maximum - minimum) / scale};
  }

  template <class T>
  TALUS_KERNEL CurvePoint<T> evaluate(T suction) const {
    const T line = maximum - slope * suction;
    const auto falls = suction > T(0.0) && line > T(minimum);
    return {lane_min(T(maximum), lane_max(T(minimum), line)), select(falls, T(-slope), T(0.0))};
  }
};

/// S = S_min + (S_max - S_min) e^(-αs), after Gardner (1958): the curve of the analytical solutions for infiltration of
/// Srivastava and Yeh (1991). Published values of α are per metre of head; divide them by γ_w.
struct ExponentialRetention {
  double minimum = 0;
  double maximum = 1;
  double alpha = 0;  ///< α [1/Pa]

  template <class T>
  TALUS_KERNEL CurvePoint<T> evaluate(T suction) const {
    const T v = (maximum - minimum) * lane_exp(lane_max(suction, T(0.0)) * -alpha);
    return {minimum + v, select(suction > T(0.0), v * -alpha, T(0.0))};
  }
};

/// Measured pairs of suction [Pa] and saturation [-].
struct TableRetention {
  double minimum = 0;  ///< saturation of the last pair
  double maximum = 1;  ///< saturation of the first pair
  MonotoneTable table;

  template <class T>
  TALUS_KERNEL CurvePoint<T> evaluate(T suction) const {
    return table.evaluate(suction);
  }
};

/// Throws Error (wrong_input) if the pairs do not form a decreasing curve over suctions >= 0.
TableRetention make_retention_table(const std::vector<std::array<double, 2>>& pairs, Interpolation interpolation);

using Retention = std::variant<ConstantSaturation, VanGenuchten, LinearRetention, ExponentialRetention, TableRetention>;

/// State of the pore water at a point for the laws of conductivity and storage. Slopes are d/ds [1/Pa] and never
/// positive.
template <class T>
struct SoilWater {
  T suction;           ///< s [Pa]
  T saturation;        ///< S [-]
  T slope;             ///< dS/ds
  T effective;         ///< S_e = (S - S_min)/(S_max - S_min) [-]
  T effective_slope;   ///< dS_e/ds
  T complement{-1.0};  ///< (1 - S_e^(1/λ))^λ of van Genuchten's curve [-]; negative if not available
};

/// Returns the same for one curve; visit the variant outside of loops and call this function inside.
template <class T, class Curve>
TALUS_KERNEL SoilWater<T> find_water_on(const Curve& curve, T suction) {
  const CurvePoint<T> p = curve.evaluate(suction);
  const double range = curve.maximum - curve.minimum;
  if (!(range > 0) || std::is_same_v<Curve, ConstantSaturation>) return {suction, p.value, p.slope, T(1.0), T(0.0)};
  return {suction, p.value, p.slope, (p.value - curve.minimum) / range, p.slope / range};
}

template <class T>
TALUS_PORTABLE SoilWater<T> find_water(const Retention& retention, T suction) {
  return visit_kind([&](const auto& curve) { return find_water_on(curve, suction); }, retention);
}
/// Returns S(s) [-] at a suction [Pa].
template <class T>
TALUS_PORTABLE T saturation(const Retention& retention, T suction) {
  return find_water(retention, suction).saturation;
}

/// Returns the fault of the parameters as a sentence for the user; std::nullopt if they are valid.
std::optional<std::string> find_fault(const Retention& retention);

}  // namespace talus::material
