// SPDX-License-Identifier: MIT
#pragma once
// The nodal equations of seepage: numbering, pattern, conditions at the nodes, and the sums over elements.
// Internal to fem/; the interface is seepage.hpp.

#include "fem/seepage/seepage.hpp"

namespace talus::fem {

/// One boundary's part of a node: areas of the surface and of its projection on the horizontal.
struct BoundaryShare {
  int unknown;
  int soil;           ///< of the element behind the surface
  double area;        ///< [m²] (2D: m)
  double horizontal;  ///< its projection on the horizontal; negative where the surface looks down
  double downward;    ///< saturated conductivity times the area that looks down, for free drainage [m³/s]
};

/// The condition of one unknown at one time.
struct NodeCondition {
  bool fixed = false;
  double head = 0;   ///< where fixed [m]
  int owner = -1;    ///< boundary that the reaction belongs to: the fixed one's, or the first face
  double given = 0;  ///< flux whatever the pressure [m³/s]
  bool face = false;
  double offered = 0;                                              ///< rain [m³/s]; negative: evaporation
  double carried = 0;                                              ///< its part that ran on or stood [m³/s]
  double suction_limit = std::numeric_limits<double>::infinity();  ///< [Pa]
};

template <int D>
struct SeepageSystem {
  static constexpr int N = D + 1;
  explicit SeepageSystem(const SeepageModel<D>& m);

  const SeepageModel<D>& model;
  std::vector<int> elements;         ///< that hold soil
  std::vector<int> unknown_of_node;  ///< -1: no soil
  std::vector<int> node_of_unknown;
  /// The lowest unknown [m]. Elevations and heads of the unknowns are measured from it: pressures are their
  /// differences, and would drown in the rounding of map coordinates.
  double datum = 0;
  std::vector<double> elevation;  ///< per unknown, above the datum [m]

  // Compressed columns; the pattern is symmetric.
  std::vector<int> column_start, row;
  std::vector<std::array<int, N * N>> slots;  ///< per element: place of (i, j) at i*N+j
  std::vector<int> diagonal;                  ///< place of (i, i)

  /// Volume of one soil at one unknown.
  struct Store {
    int unknown, soil;
    double volume;
  };
  std::vector<Store> stores;
  std::vector<std::vector<BoundaryShare>> shares;  ///< per boundary

  int size() const { return static_cast<int>(node_of_unknown.size()); }
  double suction(std::size_t unknown, double head) const { return model.unit_weight * (elevation[unknown] - head); }

  /// Conditions of all unknowns at a time. Throws Error (wrong_input) when two heads contradict each other.
  std::vector<NodeCondition> find_conditions(double time) const;
  /// Water per volume of soil at a suction, and its slope d/ds.
  material::CurvePoint<double> find_content(const HydraulicSoil<D>& soil, double suction) const;
  /// Stored water per store [m³].
  std::vector<double> find_contents(const std::vector<double>& head) const;
};

/// Fills the shares of all boundaries. Throws Error (wrong_input) when one lies on no surface of the soil.
template <int D>
void build_shares(SeepageSystem<D>& system);

/// What the sums need beside the heads.
struct StepInput {
  double stretch = 1;  ///< k_r is taken at this share of the suction: 0 is saturated flow, 1 the soil's law
  double dt = 0;       ///< [s]; 0: steady
  const std::vector<double>* old_contents = nullptr;  ///< per store [m³]
  std::vector<double> sink_rates;                     ///< per sink [m/s]
  double smallest_conductivity = 1e-9;
  double chord = 0;  ///< half the range of suction over which the slope of k_r is taken [Pa]; 0: the tangent
  bool hold_conductivity = false;  ///< the Jacobian leaves out that k_r changes (Picard): it is symmetric
};

/// Potential rate of every sink at a time [m/s].
template <int D>
std::vector<double> find_sink_rates(const SeepageModel<D>& model, double time);

/// k_r of a soil as `input` says, not below the smallest one, and its slope by suction [1/Pa].
template <int D>
material::CurvePoint<double> find_relative(const HydraulicSoil<D>& soil, double suction, const StepInput& input);

/// Sums at given heads.
struct NodalSums {
  std::vector<double> outflow;   ///< from a node into elements, drainage and roots, plus growth of its store [m³/s]
  std::vector<double> drained;   ///< its part by free drainage, per boundary [m³/s]
  std::vector<double> drawn;     ///< its part by roots, per sink [m³/s]
  std::vector<double> weight;    ///< diagonal of the symmetric part, a scale of the equation [m²/s]
  std::vector<double> jacobian;  ///< d outflow / d head by column [m²/s]; empty when not wanted
  double rounding = 0;           ///< sum of the magnitudes of all terms [m³/s]
  double storage_rate = 0;       ///< [m³/s]
  bool symmetric = true;
};

template <int D>
NodalSums sum_over_elements(const SeepageSystem<D>& system, const std::vector<double>& head, const StepInput& input,
                            bool with_jacobian);

/// Mean of k_r over an element, and its slopes by the nodal suctions.
template <int D>
struct MeanConductivity {
  double relative = 0;
  std::array<double, D + 1> slope{};
};
template <int D>
MeanConductivity<D> find_mean_conductivity(const HydraulicSoil<D>& soil, const std::array<double, D + 1>& suction,
                                           const StepInput& input);

/// Mean saturation of an element.
template <int D>
double find_mean_saturation(const HydraulicSoil<D>& soil, const std::array<double, D + 1>& suction);

}  // namespace talus::fem
