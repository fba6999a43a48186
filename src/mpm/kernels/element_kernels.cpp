// SPDX-License-Identifier: MIT
// Instances of the element kernels for a Body in 2D and 3D.
#include "mpm/kernels/element_kernels.hpp"

namespace talus::mpm {

template void add_internal_force<Body<2>>(Body<2>&, int, bool, double);
template bool update_fill_limit<Body<2>>(Body<2>&, int);
template double find_sharing_loss<Body<2>>(const Body<2>&, const StepOptions<2>&, int);
template void note_gaps<Body<2>>(Body<2>&, const StepOptions<2>&, int);
template void add_point_mass<Body<2>>(Body<2>&, int, const double*);
template void add_internal_force<Body<3>>(Body<3>&, int, bool, double);
template bool update_fill_limit<Body<3>>(Body<3>&, int);
template double find_sharing_loss<Body<3>>(const Body<3>&, const StepOptions<3>&, int);
template void note_gaps<Body<3>>(Body<3>&, const StepOptions<3>&, int);
template void add_point_mass<Body<3>>(Body<3>&, int, const double*);

}  // namespace talus::mpm
