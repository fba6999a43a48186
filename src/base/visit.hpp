// SPDX-License-Identifier: MIT
#pragma once
// What a variant holds, where std::visit() is not to be had: on a GPU.

#include <cstddef>
#include <variant>

#include "base/portable.hpp"

namespace talus {

/// work() of what a variant holds, as std::visit() of one variant, which a GPU does not know. All kinds give the same
/// type.
template <std::size_t Kind = 0, class Work, class Variant>
TALUS_PORTABLE auto visit_kind(const Work& work, const Variant& variant) {
  if constexpr (Kind + 1 == std::variant_size_v<Variant>) {
    return work(*std::get_if<Kind>(&variant));
  } else {
    if (variant.index() == Kind) return work(*std::get_if<Kind>(&variant));
    return visit_kind<Kind + 1>(work, variant);
  }
}

}  // namespace talus
