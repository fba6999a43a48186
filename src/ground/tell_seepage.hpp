// SPDX-License-Identifier: MIT
#pragma once
// The results of steady seepage.

#include "fem/seepage/seepage.hpp"
#include "results/water.hpp"

namespace talus::ground {

/// Flow by side, where water comes out, the water table and the largest suction.
template <int D>
results::Seepage tell_seepage(const mesh::Mesh<D>& mesh, const fem::SeepageResult<D>& seepage);

}  // namespace talus::ground
