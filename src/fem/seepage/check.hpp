// SPDX-License-Identifier: MIT
#pragma once
// Faults of a seepage model, as sentences for the user.

#include "fem/seepage/seepage.hpp"

namespace talus::fem {

/// Throws Error (wrong_input) with the first fault of the soils and boundaries.
template <int D>
void check_model(const SeepageModel<D>& model);

/// Throws Error (wrong_input) when a body of soil can store no change of water and no pressure is given, so that time
/// has no meaning: a curve without slope while the water cannot be compressed.
template <int D>
void check_storage(const SeepageModel<D>& model);

template <int D>
std::string describe_inner_side(const mesh::Mesh<D>& mesh, const std::string& boundary,
                                const typename mesh::Mesh<D>::Side& side);

template <int D>
std::string describe_contradiction(const mesh::Mesh<D>& mesh, int node, const std::string& one, double one_head,
                                   const std::string& other, double other_head);

}  // namespace talus::fem
