// SPDX-License-Identifier: MIT
#pragma once
// The nodal equations of seepage: numbering, pattern, conditions at the nodes, and sums over the elements. Internal to
// fem/; the interface is seepage.hpp.

#include "fem/seepage/seepage.hpp"

namespace talus::fem {

/// Contribution of one boundary to a node: areas of the surface and of its projection on the horizontal.
struct BoundaryShare {
  int unknown;
  int soil;           ///< of the element behind the surface
  double area;        ///< [m²] (2D: m)
  double horizontal;  ///< projection on the horizontal; negative where the surface faces downwards
  double downward;    ///< saturated conductivity times the area that faces downwards, for free drainage [m³/s]
};

/// The condition of one unknown at one time.
struct NodeCondition {
  bool fixed = false;
  double head = 0;   ///< prescribed head [m], if `fixed`
  int owner = -1;    ///< boundary that the reaction is assigned to: the fixed one, or the first face
  double given = 0;  ///< prescribed flux [m³/s]
  bool face = false;
  double offered = 0;                                              ///< rain [m³/s]; negative: evaporation
  double carried = 0;                                              ///< part of it that ran on or stood [m³/s]
  double suction_limit = std::numeric_limits<double>::infinity();  ///< [Pa]
};

template <int D>
struct SeepageSystem {
  static constexpr int N = D + 1;
  explicit SeepageSystem(const SeepageModel<D>& m);

  const SeepageModel<D>& model;
  std::vector<int> elements;         ///< elements with soil
  std::vector<int> unknown_of_node;  ///< -1: no soil
  std::vector<int> node_of_unknown;
  /// Lowest elevation of the unknowns [m], from which elevations and heads are measured. Pressures are their
  /// differences, which would otherwise lose digits in the rounding of map coordinates.
  double datum = 0;
  std::vector<double> elevation;  ///< per unknown, above the datum [m]

  // Matrix pattern by compressed columns; it is symmetric.
  std::vector<int> column_start, row;
  std::vector<std::array<int, N * N>> slots;  ///< per element: index of entry (i, j) at i*N+j
  std::vector<int> diagonal;                  ///< index of entry (i, i)

  /// Volume of one soil at one node.
  struct Store {
    int unknown, soil;
    double volume;
  };
  std::vector<Store> stores;
  std::vector<std::vector<BoundaryShare>> shares;  ///< per boundary

  int size() const { return static_cast<int>(node_of_unknown.size()); }
  double suction(std::size_t unknown, double head) const { return model.unit_weight * (elevation[unknown] - head); }

  /// Returns the conditions of all unknowns at a time. Throws Error (wrong_input) if two heads contradict each other.
  std::vector<NodeCondition> find_conditions(double time) const;
  /// Returns w, the volume of water per volume of soil, at a suction (T13.2), and its derivative dw/ds.
  material::CurvePoint<double> find_content(const HydraulicSoil<D>& soil, double suction) const;
  /// Returns the volume of water in each store [m³].
  std::vector<double> find_contents(const std::vector<double>& head) const;
};

/// Computes the shares of all boundaries. Throws Error (wrong_input) if one lies on no surface of the soil.
template <int D>
void build_shares(SeepageSystem<D>& system);

/// Input of the sums other than the heads.
struct StepInput {
  double stretch = 1;  ///< θ: k_r is taken at θ s; 0 is saturated flow, 1 the law of the soil
  double dt = 0;       ///< [s]; 0: steady
  const std::vector<double>* old_contents = nullptr;  ///< per store [m³]
  std::vector<double> sink_rates;                     ///< per sink [m/s]
  double smallest_conductivity = 1e-9;
  double chord = 0;                ///< half range of suction of the secant slope of k_r [Pa]; 0: the tangent
  bool hold_conductivity = false;  ///< the Jacobian omits the derivative of k_r (Picard) and is symmetric
};

/// Returns the potential rate of every sink at a time [m/s].
template <int D>
std::vector<double> find_sink_rates(const SeepageModel<D>& model, double time);

/// Returns k_r of a soil for `input`, not below the smallest one, and its derivative by the suction [1/Pa].
template <int D>
material::CurvePoint<double> find_relative(const HydraulicSoil<D>& soil, double suction, const StepInput& input);

/// Sums over the elements at given heads.
struct NodalSums {
  std::vector<double> outflow;   ///< from a node to elements, drainage, roots and its store [m³/s]
  std::vector<double> drained;   ///< its part due to free drainage, per boundary [m³/s]
  std::vector<double> drawn;     ///< its part due to roots, per sink [m³/s]
  std::vector<double> weight;    ///< diagonal of the symmetric part, the scale of the equation [m²/s]
  std::vector<double> jacobian;  ///< ∂outflow/∂head by columns [m²/s]; empty if not required
  double rounding = 0;           ///< sum of the absolute values of all terms [m³/s]
  double storage_rate = 0;       ///< [m³/s]
  bool symmetric = true;
};

template <int D>
NodalSums sum_over_elements(const SeepageSystem<D>& system, const std::vector<double>& head, const StepInput& input,
                            bool with_jacobian);

/// Mean of k_r over an element, and its derivatives by the nodal suctions.
template <int D>
struct MeanConductivity {
  double relative = 0;
  std::array<double, D + 1> slope{};
};
template <int D>
MeanConductivity<D> find_mean_conductivity(const HydraulicSoil<D>& soil, const std::array<double, D + 1>& suction,
                                           const StepInput& input);

/// Returns the mean saturation of an element.
template <int D>
double find_mean_saturation(const HydraulicSoil<D>& soil, const std::array<double, D + 1>& suction);

}  // namespace talus::fem
