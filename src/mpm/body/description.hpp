// SPDX-License-Identifier: MIT
#pragma once
// A body without its soil, which several ranks have before each takes its part: conditions and totals, and room for all
// fields. What is zero takes no memory (base/aligned.hpp).

#include "base/message.hpp"
#include "mpm/body/body.hpp"

namespace talus::mpm {

/// A body like `body` with all fields zero and no point on its grid.
template <int D>
Body<D> copy_description(const Body<D>& body);

/// Into a message, but for layout, laws and the reach of softening.
template <int D>
void put_description(const Body<D>& body, Message& message);
/// Out of it; the body has no laws yet.
template <int D>
Body<D> get_description(Message& message, std::shared_ptr<const Layout<D>> layout);

/// The layout that rank 0 has, on all ranks.
template <int D>
std::shared_ptr<const Layout<D>> broadcast_layout(std::shared_ptr<const Layout<D>> layout);

}  // namespace talus::mpm
