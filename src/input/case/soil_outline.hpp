// SPDX-License-Identifier: MIT
#pragma once
// The outline of the soil in a plane section: how far it reaches, and the level of its ground.

#include <limits>
#include <string>

#include "mesh/plan.hpp"

namespace talus::input {

class SoilOutline {
 public:
  explicit SoilOutline(const mesh::Plan& plan);

  double left() const { return left_; }      ///< [m]
  double right() const { return right_; }    ///< [m]
  double bottom() const { return bottom_; }  ///< lowest soil [m]
  double top() const { return top_; }        ///< highest soil [m]
  /// A billionth of the width: lengths below it are rounding errors [m].
  double slack() const { return 1e-9 * (right_ - left_); }
  /// Whether there is ground at x.
  bool spans(double x) const { return x >= left_ - slack() && x <= right_ + slack(); }
  /// "which goes from x = 0 m to x = 44 m".
  std::string write_span() const;
  /// Highest soil at x [m]; minus infinity where there is none.
  double find_ground(double x) const;

 private:
  static constexpr double far_ = std::numeric_limits<double>::infinity();
  const mesh::Plan& plan_;
  double left_ = far_, right_ = -far_, bottom_ = far_, top_ = -far_;
};

}  // namespace talus::input
