// SPDX-License-Identifier: MIT
#pragma once
// Upper bound of limit analysis for a polyline: rigid wedges that slide on its straight parts and on the interfaces
// between them.

#include <vector>

#include "lem/slices/mass.hpp"

namespace talus::lem {

/// The mechanism of Giam and Donald (1989) and Donald and Chen (1997). A kink of the base implies a velocity jump
/// across an interface from there to the ground, where the strength is mobilised as on the base. The flow rule is
/// associated with tan φ/F. The inclinations of the interfaces are those that give the smallest factor.
class WedgeMechanism {
 public:
  /// Sets up the wedges. `cut`: of a polyline, from cut_surface(). `horizontal`: acceleration over g.
  void set(const Slope& slope, const CutSurface& cut, double horizontal);

  /// Returns the power of weights, loads and pore pressures less the dissipation (T18.11), per unit velocity of the
  /// uppermost wedge, with the strength divided by `factor` and the best interfaces [W/m per m/s]. If it is positive
  /// the mass slides; -infinity if no interfaces are compatible.
  double compute_net_power(double factor) const;

  /// Returns the factor with compute_net_power() = 0; infinity if there is none below 1000.
  double search_factor(double start) const;

 private:
  /// One wedge: the forces on it, and the strength of its base.
  struct Base {
    /// Components of a unit velocity, downwards and in the direction of sliding, and sine and cosine of the dilation
    /// angle.
    struct Motion {
      double fall = 0, run = 1, cosine = 1, sine = 0;
    };
    Motion move(double q) const;  ///< with tan φ times q
    double sine = 0, cosine = 1;  ///< of the inclination, positive where it falls in the direction of sliding
    double length = 0;            ///< [m]
    double down = 0;              ///< weight and vertical loads between vertical sides [N]
    double push = 0;              ///< horizontal force, positive in the direction of sliding [N]
    Held held;                    ///< of passive bars, which the factor divides [N]
    double cohesion = 0;          ///< c l [N]
    double uplift = 0;            ///< u l [N]
    double tan_friction = 0;
    bool reduced = true;          ///< false: the factor does not divide the strength
    double end_x = 0, end_y = 0;  ///< lower end of the base [m]
  };
  /// One trial interface at the lower end of a base.
  struct Interface {
    double sine = 0, cosine = 1;  ///< of the tilt from the vertical, positive in the direction of sliding
    double top = 0;               ///< intersection with the ground, along the sliding [m]
    double cohesion = 0;          ///< ∫ c dl [N]
    double uplift = 0;            ///< ∫ u dl [N]
    double tan_friction = 0;      ///< mean over the length of the interface
    double kept_cohesion = 0;     ///< the same of soil that the factor does not divide [N]
    double kept_friction = 0;
    double down = 0, push = 0;  ///< forces that the tilt moves from the upper wedge to the lower one [N]
    /// Returns the power of everything below the upper wedge, per unit velocity of that wedge; `power_below` is per
    /// unit velocity of the lower one.
    double compute_power(double q, const Base::Motion& above, const Base::Motion& below, double power_below) const;
  };
  void add_bases(const Slope& slope, const CutSurface& cut, double horizontal);
  /// Adds the force of a bar on `slice`, on the base alone: bars that cross an interface would add power that the soil
  /// has to do.
  void add_bar(const Slope& slope, const CutSurface& cut, const BarPart& part, const Slice& slice, Base& base) const;
  /// Merges short bases beside a change of φ with the longer of their neighbours.
  void join_short_bases();
  bool measure_interface(const Slope& slope, const Base& base, double horizontal, Interface& interface) const;

  double way_ = 1;                ///< -1: sliding towards smaller x
  double upper_ = 0, lower_ = 0;  ///< ends of the mass along the sliding [m]
  std::vector<Base> bases_;       ///< from the upper end to the lower one
  std::vector<Interface> interfaces_;
  std::vector<std::size_t> first_;  ///< index of the first trial interface of each base; one more at the end
};

/// Returns true if a factor is compared with the mechanism: for polylines, by methods of complete equilibrium. Not
/// after a drawdown, whose undrained strengths are known on the base alone.
inline bool has_wedge_check(const Slope& slope, const CutSurface& cut, Method method) {
  return !cut.surface.circle && is_rigorous(method) && slope.before() == nullptr;
}

}  // namespace talus::lem
