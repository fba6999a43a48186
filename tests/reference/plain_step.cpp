// SPDX-License-Identifier: MIT
// The plain steps, compiled once for all tests.

#include "reference/plain_mpm.hpp"
#include "reference/plain_two_phase.hpp"

namespace talus::reference {

template void classify_elements(Body<2>&, const Settings&);
template void map_points_to_nodes(Body<2>&);
template void solve_momentum(Body<2>&, const Settings&);
template void compute_strain_increments(Body<2>&, const Settings&);
template void update_points(Body<2>&, const Settings&);
template std::vector<double> smooth_over_nodes(const Body<2>&, const std::vector<double>&);
template void relocate_points(Body<2>&);
template void step(Body<2>&, const Settings&);
template void classify_elements(Body<3>&, const Settings&);
template void map_points_to_nodes(Body<3>&);
template void solve_momentum(Body<3>&, const Settings&);
template void compute_strain_increments(Body<3>&, const Settings&);
template void update_points(Body<3>&, const Settings&);
template std::vector<double> smooth_over_nodes(const Body<3>&, const std::vector<double>&);
template void relocate_points(Body<3>&);
template void step(Body<3>&, const Settings&);
template void classify_wet_elements(WetBody<2>&, const WetSettings&);
template void average_wet_state(WetBody<2>&);
template void map_wet_points(WetBody<2>&);
template void add_wet_forces(WetBody<2>&);
template void load_free_surface(WetBody<2>&);
template void solve_wet_momentum(WetBody<2>&, const WetSettings&);
template void compute_wet_increments(WetBody<2>&, const WetSettings&);
template void smooth_water_increments(WetBody<2>&, const WetSettings&);
template void update_wet_points(WetBody<2>&, const WetSettings&);
template void exchange_water(WetBody<2>&, const WetSettings&);
template void move_wet_points(WetBody<2>&, const WetSettings&);
template void step(WetBody<2>&, const WetSettings&);
template void classify_wet_elements(WetBody<3>&, const WetSettings&);
template void average_wet_state(WetBody<3>&);
template void map_wet_points(WetBody<3>&);
template void add_wet_forces(WetBody<3>&);
template void load_free_surface(WetBody<3>&);
template void solve_wet_momentum(WetBody<3>&, const WetSettings&);
template void compute_wet_increments(WetBody<3>&, const WetSettings&);
template void smooth_water_increments(WetBody<3>&, const WetSettings&);
template void update_wet_points(WetBody<3>&, const WetSettings&);
template void exchange_water(WetBody<3>&, const WetSettings&);
template void move_wet_points(WetBody<3>&, const WetSettings&);
template void step(WetBody<3>&, const WetSettings&);

}  // namespace talus::reference
