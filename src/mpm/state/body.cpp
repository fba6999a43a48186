// SPDX-License-Identifier: MIT
// Special members of Body and Water, compiled once.
#include "mpm/state/body.hpp"

namespace talus::mpm {

template <int D>
Body<D>::Body() = default;
template <int D>
Body<D>::Body(const Body&) = default;
template <int D>
Body<D>::Body(Body&&) noexcept = default;
template <int D>
Body<D>& Body<D>::operator=(const Body&) = default;
template <int D>
Body<D>& Body<D>::operator=(Body&&) noexcept = default;
template <int D>
Body<D>::~Body() = default;
template struct Body<2>;
template struct Body<3>;

template <int D>
Water<D>::Water() = default;
template <int D>
Water<D>::Water(const Water&) = default;
template <int D>
Water<D>::Water(Water&&) noexcept = default;
template <int D>
Water<D>& Water<D>::operator=(const Water&) = default;
template <int D>
Water<D>& Water<D>::operator=(Water&&) noexcept = default;
template <int D>
Water<D>::~Water() = default;
template struct Water<2>;
template struct Water<3>;

}  // namespace talus::mpm
