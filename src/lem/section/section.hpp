// SPDX-License-Identifier: MIT
#pragma once
// The slope as limit equilibrium sees it: ground, soils, water and loads of a section, per metre of thickness. Lengths
// in metres, x to the right, y up. Pore pressure u and loads are positive in compression here, as in every text on
// slices.

#include <array>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/methods.hpp"

namespace talus::lem {

using Point = std::array<double, 2>;

/// What suction above the water table adds to the strength.
enum class Suction {
  ignored,     ///< nothing: u = 0 above the water table
  saturation,  ///< χ s tanφ with χ = S_w(s), Bishop's effective stress
  phi_b        ///< s tanφ_b (Fredlund et al. 1978)
};

/// The R envelope τ = c_R + σ' tanφ_R of isotropically consolidated undrained tests, in total stresses (USACE EM
/// 1110-2-1902, 2003).
struct UndrainedEnvelope {
  double cohesion = 0;        ///< c_R [Pa]
  double friction_angle = 0;  ///< φ_R [rad]
};

/// Strength τ_f = c(y) + σ'_n tanφ of a soil and its weight.
struct Soil {
  std::string name;
  double unit_weight = 0;            ///< γ above the water table [N/m³]
  double saturated_unit_weight = 0;  ///< γ below it [N/m³]
  double cohesion = 0;               ///< c, or c_u where φ = 0 [Pa]
  double friction_angle = 0;         ///< φ [rad]; 0: undrained
  double cohesion_gradient = 0;      ///< growth of c with depth below `cohesion_level` [Pa/m]
  double cohesion_level = 0;         ///< elevation where the growth starts; c stays constant above it [m]
  double pore_pressure_ratio = 0;    ///< r_u = u over the weight of the soil above; used when > 0 [-]
  Suction suction = Suction::ignored;
  double phi_b = 0;                                                  ///< [rad]
  double largest_suction = std::numeric_limits<double>::infinity();  ///< suction is not taken above it [Pa]
  std::function<double(double)> saturation;                          ///< S_w of a suction [Pa]; for Suction::saturation
  bool undrained = false;                     ///< u plays no part in the strength (φ = 0); total stress
  std::optional<UndrainedEnvelope> envelope;  ///< for rapid drawdown by total stresses; without it the soil drains
  std::optional<double> b_bar;  ///< B̄ for rapid drawdown by effective stresses; without it it drains [-]
};

/// A polygon of one soil. Later ones replace earlier ones where they overlap.
struct Region {
  int soil = 0;
  std::vector<Point> polygon;  ///< either way round, first point not repeated
};

/// Pore pressures at the corners of triangles, from a seepage calculation.
struct PressureGrid {
  std::vector<Point> nodes;
  std::vector<std::array<int, 3>> triangles;
  std::vector<double> pressure;  ///< u per node, negative is suction [Pa]
};

/// A load on the ground, linear between its points, none outside [Pa per horizontal metre].
struct Surcharge {
  std::vector<std::array<double, 3>> load;  ///< x [m], part down and part to larger x [Pa]
};

/// A uniform load on a vertical step of the ground.
struct FaceLoad {
  double x = 0, low = 0, high = 0;   ///< [m]
  std::array<double, 2> traction{};  ///< to larger x and up [Pa]
};

/// Cohesion of roots by depth under the ground [Pa]: linear between the rows, none below the last.
struct RootCohesion {
  std::vector<std::array<double, 2>> profile;              ///< depth normal to the ground [m], c_r [Pa]
  double from = -std::numeric_limits<double>::infinity();  ///< x range where the plants stand [m]
  double to = std::numeric_limits<double>::infinity();
};

struct TensionCrack {
  double depth = 0;      ///< under the ground [m]; the slip surface ends in a vertical crack where it is less deep
  double water = 0;      ///< height of the water in it above its bottom [m]
  bool limited = false;  ///< it ends where the soil beside it would no longer be in tension
};

struct Section;

/// The section is that after a rapid drawdown.
struct Drawdown {
  DrawdownMethod method = DrawdownMethod::three_stage;
  std::shared_ptr<const Section> before;  ///< the same but for its water and the weights that follow from it
};

struct Section {
  std::vector<Point> ground;  ///< from left to right, x never decreasing; overhangs are refused
  std::vector<Soil> soils;
  std::vector<Region> regions;
  double base = 0;  ///< elevation that no surface goes below: the bottom of the model [m]
  /// Piezometric line: u = γ_w times the vertical depth below it; level beyond its ends; above the ground it is
  /// ponded water that loads the ground. Empty: none.
  std::vector<Point> water_table;
  std::optional<PressureGrid> pressure_grid;  ///< used instead of the line for u where it has triangles
  double water_unit_weight = 9810;            ///< γ_w [N/m³]
  std::vector<Surcharge> surcharges;
  std::vector<FaceLoad> face_loads;
  std::vector<RootCohesion> roots;
  double horizontal_acceleration = 0;  ///< k_h over g: out of the slope positive, or as `push` says [-]
  /// Direction of the horizontal acceleration: smaller x (-1), larger x (1), or the sliding of each mass (0).
  int push = 0;
  double vertical_acceleration = 0;  ///< k_v over g, down positive [-]
  std::optional<TensionCrack> crack;
  std::optional<Drawdown> drawdown;

  /// `acceleration` as it acts on a mass, with its sliding positive.
  double turn_to_sliding(double acceleration, bool slides_left) const {
    return push == 0 || slides_left == (push < 0) ? acceleration : -acceleration;
  }

  // Compiled once, in section.cpp: the files that hold one would each compile them again.
  Section();
  Section(const Section&);
  Section(Section&&) noexcept;
  Section& operator=(const Section&);
  Section& operator=(Section&&) noexcept;
  ~Section();
};

/// Whether a soil keeps its water through the section's drawdown.
bool holds_water(const Section& section, const Soil& soil);

/// Height of the highest point of the ground above its lowest [m].
double find_relief(const Section& section);

/// Faults of a section that no surface could be calculated in, each a sentence that names its item: a polygon that
/// crosses itself, ground that runs backwards, soil without region, weight that is not positive …
std::vector<std::string> find_faults(const Section& section);

// Finds the pore pressure at a place in a grid of triangles.

/// Triangles sorted into square buckets: about one triangle is tried per question.
class PressureLocator {
 public:
  PressureLocator() = default;
  explicit PressureLocator(const PressureGrid& grid);

  bool empty() const { return planes_.empty(); }
  /// u, linear in the triangle that holds the place; none outside all triangles [Pa].
  std::optional<double> find(const Point& p) const;

 private:
  /// Pressure and barycentric coordinates of a triangle, linear in the distance from its first corner.
  struct Plane {
    Point corner{};
    Point second{}, third{};                           ///< gradients of the shares of the other two corners [1/m]
    double pressure = 0, to_second = 0, to_third = 0;  ///< at the corner, and how much more there is at the others
  };
  static std::optional<double> read(const Plane& plane, const Point& p);
  std::size_t find_bucket(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }

  std::vector<Plane> planes_;  ///< in the order of the buckets
  Point low_{};
  double size_ = 1;  ///< side of a bucket [m]
  int columns_ = 0, rows_ = 0;
  std::vector<int> first_;  ///< per bucket, and one more: where its triangles begin
};

}  // namespace talus::lem
