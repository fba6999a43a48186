// SPDX-License-Identifier: MIT
#pragma once
// Cases on a box, without a mesh generator: named sides, regions by height or by any other rule, rollers.

#include <cmath>
#include <functional>

#include "run/mpm/stage/stage.hpp"
#include "run/mpm/start/prepare.hpp"
#include "support/filling.hpp"

namespace talus::support {

/// Names the sides of a mesh of the box [0, size]: left right bottom top (front back).
template <int D>
void name_sides(mesh::Mesh<D>& mesh, const std::type_identity_t<Vec<D>>& size);

/// A jittered mesh of the box with its sides named; `region` gives each centroid's region (-1: empty).
template <int D>
mesh::Mesh<D> make_box_mesh(const std::array<int, D>& cells, const std::type_identity_t<Vec<D>>& size,
                            std::vector<std::string> names, const Filling<D>& region, double jitter = 0.15);

input::Material make_elastic(double young_modulus = 10e6, double poisson_ratio = 0.3, double density = 1800);

input::Boundary make_boundary(const std::string& on, input::Fix fix);

/// One material "soil" in the region "soil"; rollers on every face but the top.
template <int D>
input::Case make_box_case(const input::Material& soil);

/// A plan that runs `duration` seconds under the case's gravity.
template <int D>
run::StagePlan<D> make_stage(const input::Case& data, const mpm::Body<D>& body, double duration,
                             input::StepSettings step);

/// The same until rest, with a strict criterion.
template <int D>
run::StagePlan<D> make_rest_stage(const input::Case& data, const mpm::Body<D>& body, double longest,
                                  input::StepSettings step, double force_ratio = 1e-6);

/// Runs a stage from its start.
template <int D>
results::StageEnd run_plan(mpm::Body<D>& body, const run::StagePlan<D>& plan);

}  // namespace talus::support
