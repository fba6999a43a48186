// SPDX-License-Identifier: MIT
#pragma once
// Hydraulic conditions at the boundary of the soil.

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "input/language/time_table.hpp"
#include "material/water/feddes.hpp"
#include "mesh/mesh.hpp"

namespace talus::fem {

enum class HydraulicKind {
  total_head,    ///< head [m] on the whole set, above its level as suction
  reservoir,     ///< head [m] below its level, a seepage face above it
  pressure,      ///< pore pressure [Pa], positive in tension
  flux,          ///< water that enters whatever the pressure [m/s]; negative: is pumped out
  rain,          ///< water that is offered [m/s]: enters while the surface is unsaturated, the rest runs off. Negative:
                 ///< evaporation, until the suction reaches `suction_limit`
  seepage_face,  ///< water leaves at zero pressure, none enters
  free_drainage,  ///< water leaves under a unit gradient of head, as above a deep water table
  no_flow
};

/// How a flux is measured.
enum class FluxMeasure {
  normal,   ///< per area of the surface
  vertical  ///< per area of its projection on the horizontal, as rain gauges do; overhangs get none
};

/// A condition on named sides. Where sets meet, prescribed heads and pressures win over faces, and fluxes add up.
template <int D>
struct HydraulicBoundary {
  std::string name;
  HydraulicKind kind = HydraulicKind::no_flow;
  std::vector<typename mesh::Mesh<D>::Side> sides;
  double value = 0;  ///< head [m], pressure [Pa] or flux [m/s]
  /// Pairs of time [s] and value, with increasing times, replacing `value` when there are any: straight lines between,
  /// constant before and after. Two equal times are a jump, whose second value holds from then on.
  std::vector<std::array<double, 2>> history;
  FluxMeasure measure = FluxMeasure::normal;
  double suction_limit = std::numeric_limits<double>::infinity();  ///< where evaporation stops [Pa]

  /// Of rain, in time: what does not enter stands on the ground up to this depth [m], and runs on from there to where
  /// it can enter, or else is gone.
  double standing_depth = 0;
  bool runs_on = false;

  double value_at(double time) const;
};

extern template struct HydraulicBoundary<2>;
extern template struct HydraulicBoundary<3>;

// Water that roots draw from the soil: a sink in the nodal equations of seepage (T16.1).

/// Plants that draw water where their roots are. Node i loses α(s_i) T(t) W_i.
struct RootSink {
  std::string name;
  material::Feddes reduction;   ///< α
  input::TimeTable rate;        ///< T, potential per horizontal area of ground [m/s]
  std::vector<double> weights;  ///< W per node of the mesh: the roots' share times the ground covered [m²] (2D: m)
};

/// Water drawn through one sink [m³/s] (per metre of thickness in 2D); for a time range [m³].
struct Uptake {
  std::string name;
  double potential = 0;  ///< potential transpiration
  double actual = 0;     ///< actual transpiration
};

}  // namespace talus::fem
