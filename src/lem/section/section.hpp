// SPDX-License-Identifier: MIT
#pragma once
// The section of limit equilibrium: ground, soils, water and loads, per metre of thickness. Lengths are in metres, x to
// the right, y up. Pore pressure u and loads are positive in compression here, as in the literature on the method of
// slices.

#include <array>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/methods.hpp"
#include "base/shown_units.hpp"
#include "base/strength_law.hpp"

namespace talus::lem {

using Point = std::array<double, 2>;

/// Contribution of suction above the water table to the strength (T18.3).
enum class Suction {
  ignored,     ///< nothing: u = 0 above the water table
  saturation,  ///< χ s tanφ with χ = S_w(s), Bishop's effective stress
  phi_b        ///< s tanφ_b (Fredlund et al. 1978)
};

/// R envelope τ = c_R + σ' tanφ_R of isotropically consolidated undrained tests, in total stresses (USACE EM
/// 1110-2-1902, 2003).
struct UndrainedEnvelope {
  double cohesion = 0;        ///< c_R [Pa]
  double friction_angle = 0;  ///< φ_R [rad]
};

/// Strength τ_f = c(y) + σ'_n tanφ, or that of a law, and unit weights of a soil.
struct Soil {
  std::string name;
  double unit_weight = 0;                  ///< γ above the water table [N/m³]
  double saturated_unit_weight = 0;        ///< γ below it [N/m³]
  double cohesion = 0;                     ///< c, or c_u where φ = 0 [Pa]
  double friction_angle = 0;               ///< φ [rad]; 0: undrained
  double cohesion_gradient = 0;            ///< increase of c with depth below `cohesion_level` [Pa/m]
  double cohesion_level = 0;               ///< elevation below which c increases; c is constant above it [m]
  std::shared_ptr<const StrengthLaw> law;  ///< replaces c, φ and the increase of c
  double pore_pressure_ratio = 0;          ///< r_u = u over the weight of the soil above; used if > 0 [-]
  int piezometric_line = -1;               ///< index of the line of this soil; -1: the water table
  Suction suction = Suction::ignored;
  double phi_b = 0;                                                  ///< [rad]
  double largest_suction = std::numeric_limits<double>::infinity();  ///< upper limit of the suction that is used [Pa]
  std::function<double(double)> saturation;                          ///< S_w of a suction [Pa]; for Suction::saturation
  bool reduced = true;                        ///< false: the factor of safety does not divide the strength
  bool takes_roots = true;                    ///< false: the cohesion of roots does not act in it
  bool undrained = false;                     ///< total stress analysis (φ = 0): u has no effect on the strength
  std::optional<UndrainedEnvelope> envelope;  ///< for rapid drawdown by total stresses; without it the soil is drained
  std::optional<double> b_bar;  ///< B̄ for rapid drawdown by effective stresses; without it the soil is drained [-]
};

/// A polygon of one soil. Where regions overlap the later one counts.
struct Region {
  int soil = 0;
  std::vector<Point> polygon;  ///< in either sense of rotation, first point not repeated
};

/// Pore pressures at the nodes of triangles, from a seepage calculation.
struct PressureGrid {
  std::vector<Point> nodes;
  std::vector<std::array<int, 3>> triangles;
  std::vector<double> pressure;  ///< u per node, negative is suction [Pa]
};

/// A load on the ground, per horizontal metre, linear between its points and zero outside.
struct Surcharge {
  std::vector<std::array<double, 3>> load;  ///< x [m], component downwards and component towards larger x [Pa]
  bool is_variable = false;                 ///< soil does not consolidate under it
};

/// A uniform load on a vertical step of the ground.
struct FaceLoad {
  double x = 0, low = 0, high = 0;   ///< [m]
  std::array<double, 2> traction{};  ///< towards larger x, and up [Pa]
};

/// A liquid on the ground that presses on its vertical steps; its load on the rest of the ground is a surcharge.
struct Slurry {
  double from = 0, to = 0, level = 0;  ///< [m]
  double unit_weight = 0;              ///< [N/m³]
};

/// Cohesion of roots over the depth [Pa]: linear between the rows, zero below the last.
struct RootCohesion {
  std::vector<std::array<double, 2>> profile;              ///< depth normal to the ground [m], c_r [Pa]
  double from = -std::numeric_limits<double>::infinity();  ///< range of x of the plants [m]
  double to = std::numeric_limits<double>::infinity();
};

/// Direction of the force of a bar on the sliding mass.
enum class BarDirection {
  axial,     ///< along the bar
  tangent,   ///< along the slip surface, against the sliding
  bisector,  ///< half-way between these two
  normal     ///< across the bar, against the sliding
};

/// How a bar holds the sliding mass.
enum class BarHold {
  bond,          ///< by bond along the bar and at its head
  end_anchor,    ///< by an anchorage at its end and a plate at its head: the same force all along
  across,        ///< by a force across it, which is given
  soil_pressure  ///< by that of the soil that flows between piles (Ito and Matsui 1975)
};

/// A straight support; resistances are per metre of thickness.
struct Bar {
  std::string name, kind;  ///< words of the case
  int row = 1;
  Point head{}, end{};  ///< [m]
  BarHold hold = BarHold::bond;
  double free_length = 0;                                   ///< from the head, without bond [m]
  double tensile = 0;                                       ///< [N/m]
  double plate = 0;                                         ///< at the head [N/m]
  double bond = 0;                                          ///< pull-out per metre of bar [N/m per m]
  double bond_factor = 0;                                   ///< its increase with σ'_v [N/m per m per Pa]
  double prestress = 0;                                     ///< of an active bar, where it would be slack [N/m]
  double lateral = 0;                                       ///< largest of BarHold::across [N/m]
  double shear = std::numeric_limits<double>::infinity();   ///< limit of forces across the bar [N/m]
  double diameter = 0, spacing = 1;                         ///< of piles [m]
  bool is_pile = false;                                     ///< the soil on both sides of a surface limits its force
  double moment = std::numeric_limits<double>::infinity();  ///< plastic moment of a pile [N m/m]
  bool is_active = false;  ///< a load, which the factor does not divide; else a resistance, which it divides
  BarDirection direction = BarDirection::axial;
};

struct TensionCrack {
  double depth = 0;      ///< under the ground [m]; the slip surface ends in a vertical crack where its depth is smaller
  double water = 0;      ///< height of the water above the bottom of the crack [m]
  bool limited = false;  ///< the depth is limited to the tension zone of the soil beside the crack
};

struct Section;

/// Rapid drawdown that led to this section.
struct Drawdown {
  DrawdownMethod method = DrawdownMethod::three_stage;
  std::shared_ptr<const Section> before;  ///< differs in its water and the weights due to it
};

struct Section {
  std::vector<Point> ground;  ///< from left to right, x never decreasing; overhangs are rejected
  std::vector<Soil> soils;
  std::vector<Region> regions;
  double base = 0;  ///< elevation of the bottom of the model, which no surface crosses [m]
  /// Indices of the soils that no surface enters: one that would cut below their top follows it.
  std::vector<int> impenetrable;
  /// Piezometric line: u = γ_w times the vertical depth below it; level beyond its ends. Above the ground it is ponded
  /// water that loads the ground. Empty: no water.
  std::vector<Point> water_table;
  /// Piezometric lines of single soils, as the water table, but without ponded water.
  std::vector<std::vector<Point>> piezometric_lines;
  std::optional<PressureGrid> pressure_grid;           ///< takes precedence over the line for u inside its triangles
  std::function<double(const Point&)> pressure_ratio;  ///< r_u at a point [-]; replaces that of the soils
  double water_unit_weight = 9810;                     ///< γ_w [N/m³]
  std::vector<Surcharge> surcharges;
  std::vector<FaceLoad> face_loads;
  std::vector<Slurry> slurries;
  std::vector<RootCohesion> roots;
  std::vector<Bar> bars;
  double horizontal_acceleration = 0;  ///< k_h over g: positive out of the slope, or in the direction of `push` [-]
  /// Direction of the horizontal acceleration: smaller x (-1), larger x (1), or the direction of sliding of each mass
  /// (0).
  int push = 0;
  double vertical_acceleration = 0;  ///< k_v over g, down positive [-]
  std::optional<TensionCrack> crack;
  std::optional<Drawdown> drawdown;
  ShownUnits units;  ///< units of messages

  /// Returns r_u of a soil at a point; 0: u follows from the water.
  double find_pressure_ratio(const Soil& soil, const Point& p) const {
    return pressure_ratio ? pressure_ratio(p) : soil.pore_pressure_ratio;
  }
  /// Returns `acceleration` as it acts on a mass, positive in the direction of sliding.
  double turn_to_sliding(double acceleration, bool slides_left) const {
    return push == 0 || slides_left == (push < 0) ? acceleration : -acceleration;
  }
};

/// Returns c and tanφ of a soil on a plane, without roots and suction.
StrengthTangent find_strength(const Soil& soil, const StrengthPlane& plane);

/// Returns true if a soil does not drain during the drawdown of the section.
bool holds_water(const Section& section, const Soil& soil);

/// Returns the height of the highest point of the ground above its lowest [m], the scale of its smallest slip surfaces;
/// on level ground a twentieth of the depth.
double find_relief(const Section& section);

/// Returns the faults of a section that prevent a calculation, each as a sentence that names its item: a polygon that
/// crosses itself, ground that runs backwards, soil without region, weight that is not positive …
std::vector<std::string> find_faults(const Section& section);

// Pore pressure at a point of a grid of triangles.

/// Triangles sorted into square buckets, so that about one triangle is tested per look-up.
class PressureLocator {
 public:
  PressureLocator() = default;
  explicit PressureLocator(const PressureGrid& grid);

  bool empty() const { return planes_.empty(); }
  /// Returns u, linear in the triangle that contains the point; nothing outside all triangles [Pa].
  std::optional<double> find(const Point& p) const;

 private:
  /// Pressure and barycentric coordinates of a triangle, as linear functions of the distance from its first corner.
  struct Plane {
    Point corner{};
    Point second{}, third{};                           ///< gradients of the other two barycentric coordinates [1/m]
    double pressure = 0, to_second = 0, to_third = 0;  ///< u at the first corner, increments to the others [Pa]
  };
  static std::optional<double> read(const Plane& plane, const Point& p);
  std::size_t find_bucket(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }

  std::vector<Plane> planes_;  ///< in the order of the buckets
  Point low_{};
  double size_ = 1;  ///< side of a bucket [m]
  int columns_ = 0, rows_ = 0;
  std::vector<int> first_;  ///< index of the first triangle of each bucket; one more at the end
};

}  // namespace talus::lem
