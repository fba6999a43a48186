// SPDX-License-Identifier: MIT
#include "mpm/state/body.hpp"

#include "material/every_law.hpp"

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

}  // namespace talus::mpm
