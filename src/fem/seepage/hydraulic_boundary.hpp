// SPDX-License-Identifier: MIT
#pragma once
// Hydraulic conditions at the boundary of the soil, and the sinks of roots.

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "input/language/time_table.hpp"
#include "material/water/feddes.hpp"
#include "mesh/mesh.hpp"

namespace talus::fem {

enum class HydraulicKind {
  total_head,     ///< head [m] on the whole set; above its level this is suction
  reservoir,      ///< head [m] below its level, a seepage face above it
  pressure,       ///< pore pressure [Pa], positive in tension
  flux,           ///< inflow whatever the pressure [m/s]; negative: pumping
  rain,           ///< rain [m/s]: infiltrates while the surface is unsaturated, the rest runs off. Negative:
                  ///< evaporation, until the suction reaches `suction_limit`
  seepage_face,   ///< water flows out at zero pressure, none enters
  free_drainage,  ///< outflow under a unit gradient of head, as above a deep water table
  no_flow
};

/// Area that a flux refers to.
enum class FluxMeasure {
  normal,   ///< per area of the surface
  vertical  ///< per area of the projection on the horizontal, as measured by rain gauges; zero on overhangs
};

/// A condition on named sides. Where sets meet, prescribed heads and pressures take precedence over faces, and fluxes
/// are summed.
template <int D>
struct HydraulicBoundary {
  std::string name;
  HydraulicKind kind = HydraulicKind::no_flow;
  std::vector<typename mesh::Mesh<D>::Side> sides;
  double value = 0;  ///< head [m], pressure [Pa] or flux [m/s]
  /// Pairs of time [s] and value that replace `value` if there are any. Times increase; the value is linear between
  /// them and constant before and after. Two equal times are a jump, whose second value holds from then on.
  std::vector<std::array<double, 2>> history;
  /// Level of the water behind a seepage face at each node of the mesh [m], which gives the head of nodes below
  /// it, unless another boundary does. Empty: there is none.
  std::vector<double> levels{};
  FluxMeasure measure = FluxMeasure::normal;
  double suction_limit = std::numeric_limits<double>::infinity();  ///< suction at which evaporation stops [Pa]

  /// Treatment of rain that does not infiltrate, in transient flow: it stands on the ground up to this depth [m], and
  /// the rest runs on to where it can infiltrate if `runs_on`, or else leaves the model.
  double standing_depth = 0;
  bool runs_on = false;

  double value_at(double time) const;
};

extern template struct HydraulicBoundary<2>;
extern template struct HydraulicBoundary<3>;

// Water uptake by roots: a sink in the nodal equations of seepage (T16.1).

/// Sink of the roots of one kind of plants: node i loses α(s_i) T(t) W_i (T16.3).
struct RootSink {
  std::string name;
  material::Feddes reduction;   ///< α
  input::TimeTable rate;        ///< T, potential transpiration per horizontal area of ground [m/s]
  std::vector<double> weights;  ///< W per node of the mesh: the node's fraction of the uptake times the ground area
                                ///< covered [m²] (2D: m)
};

/// Water taken up by one sink [m³/s] (per metre of thickness in 2D); over a time range [m³].
struct Uptake {
  std::string name;
  double potential = 0;
  double actual = 0;
};

}  // namespace talus::fem
