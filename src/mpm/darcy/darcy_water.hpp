// SPDX-License-Identifier: MIT
#pragma once
// Pore water of the step of the mixture (docs/theory/22-mixture.md), as plain data: pressures at the nodes, what nodes
// and elements hold, and the coefficients of one step. Pressure is positive in tension.

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/aligned.hpp"
#include "base/lane.hpp"
#include "base/vec.hpp"
#include "mpm/darcy/pressures.hpp"

namespace talus::mpm {

/// Pores of a wet point are this share of its volume at least: a volume that smoothing leads may fall below that of the
/// grains, and the water stays [-].
inline constexpr double smallest_porosity = 1e-3;
template <class T>
TALUS_KERNEL T find_pores(T volume, T grains) {
  return lane_max(volume - grains, smallest_porosity * volume);
}

template <int D>
struct DarcyWater {
  std::shared_ptr<const NodeGraph<D>> graph;  ///< made by the first step

  bool is_used = false;  ///< the nodes' sums are those of one velocity

  // What stays from step to step, by node.
  std::vector<double> pressure;      ///< [Pa]; NaN where there is no water
  std::vector<std::uint8_t> ponded;  ///< water stands on the surface, or leaves it
  std::vector<double> own;           ///< water beside the share in that of the elements (T22.2) [m³]

  // By element; pores and volume by material as well, [material][element].
  std::vector<AlignedVector<double>> pores;            ///< of wet points [m³]
  std::vector<AlignedVector<double>> volume;           ///< of wet points, as integrated [m³]
  AlignedVector<double> water;                         ///< of the points, at zero pressure [m³]
  AlignedVector<double> share;                         ///< what a step takes from every pore [-]
  std::vector<double> saturated, effective, coupling;  ///< Σ V S, Σ V χ, Σ V √(Sχ) [m³]
  std::vector<double> conductive;                      ///< Σ V k k_r/(ρ_w g) [m⁵/(N s)]
  std::vector<double> soft;                            ///< τ Σ V [m³/Pa]
  std::array<AlignedVector<double>, D> flux;           ///< of water against the grains, at the end of the step [m/s]
  AlignedVector<double> drawn;                         ///< by roots in this step [m³]

  // By node.
  std::vector<std::vector<double>> node_pores;  ///< [material][node] [m³]
  std::vector<double> node_water;               ///< [m³]
  std::vector<double> change, out, passed;      ///< δ [Pa]; what leaves the node, and of it the surface [m³]
  std::vector<Vec<D>> velocity, acceleration;   ///< predicted [m/s], [m/s²]
  std::vector<double> mobility;                 ///< Δt² s/(β M), see T22.3 [s²/kg]
  std::vector<Vec<D>> pore_force;               ///< in the sums of the nodes [N]
  std::vector<Vec<D>> area;                     ///< of the open sides that touch the node, outwards [m²]

  int rounds = 0, iterations = 0;  ///< of the last step: of lines, and of the linear solver in all
};

}  // namespace talus::mpm
