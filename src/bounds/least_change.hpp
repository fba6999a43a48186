// SPDX-License-Identifier: MIT
#pragma once
// From nearly to exactly: equations that a solver fulfils to its tolerance, fulfilled to rounding.

#include <vector>

#include "bounds/conic/program.hpp"

namespace talus::bounds {

/// The least change of x (weighted sum of squares) with A x = b, for the first `rows` rows of A: [W Aᵀ; A −δ] again and
/// again, which takes δ's effect away. Rows may repeat one another. No weights are weights of one.
void fulfil(const SparseRows& a, int rows, const std::vector<double>& right, std::vector<double>& x,
            const std::vector<double>& weights = {});

}  // namespace talus::bounds
