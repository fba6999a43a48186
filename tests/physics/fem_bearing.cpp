// SPDX-License-Identifier: MIT
// A strip footing on weightless clay: convergence of quadratic triangles to Prandtl's N_c = 2 + π under mesh
// refinement.

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/bisect.hpp"
#include "run/fem/adapted_mesh.hpp"
#include "run/fem/element_run.hpp"
#include "support/solid_model.hpp"

namespace talus {
namespace {

constexpr double half_width = 1, cohesion = 10e3;

constexpr double pressure = 4 * cohesion;  ///< stable at full strength

/// Half of a flexible strip of half-width 1 m on a block of 5 m × 3 m, elements of `size` near the strip, or of four
/// times that everywhere.
mesh::Mesh<2> make_strip_block(double size, bool is_even = false) {
  mesh::Plan plan;
  plan.box_min = {0, 0};
  plan.box_max = {5, 3};
  plan.size = 4 * size;
  plan.polygons = {{"clay", {{0, 0}, {5, 0}, {5, 3}, {half_width, 3}, {0, 3}}}};
  if (!is_even) plan.refinements = {{{{0, 3}, {half_width, 3}}, size, 3}, {{{half_width, 3}}, size / 3, 1}};
  return mesh::generate<2>(plan);
}

fem::ReductionResult<2> reduce_strip(const mesh::Mesh<2>& mesh, double dilatancy, double from = 1.1, double to = 1.4) {
  fem::SolidModel<2> model;
  model.mesh = &mesh;
  model.make_law = [&](int, double factor) -> material::Law {
    return material::MohrCoulomb(material::LinearElastic::from_young(1e7, 0.45),
                                 material::MohrCoulombStrength{cohesion, 0, dilatancy, 1e9}.reduced(factor));
  };
  model.unit_weight.assign(mesh.elements.size(), 0);
  support::add_roller<2>(model, 0, 0);
  support::add_roller<2>(model, 0, 5);
  fem::Support<2> base;
  base.sides = support::find_sides_at<2>(mesh, 1, 0);
  base.fixed = {true, true};
  model.supports.push_back(base);
  support::add_load<2>(model,
                       support::find_sides<2>(
                           mesh, [](const Vec<2>& x) { return std::abs(x[1] - 3) < 1e-9 && x[0] < half_width + 1e-9; }),
                       {0, -pressure});
  fem::ReductionOptions options;
  options.from = from, options.to = to, options.resolution = 0.002;
  return fem::reduce_strength<2>(model, options);
}

fem::ReductionResult<2> reduce_strip(double size, double dilatancy) {
  return reduce_strip(make_strip_block(size), dilatancy);
}

/// N_c.
double find_bearing_factor(double size, double dilatancy) {
  return pressure / cohesion * reduce_strip(size, dilatancy).factor;
}

TEST(StripFooting, BearingCapacityOfClayIsPrandtls) {
  const double exact = 2 + std::acos(-1.0);
  std::vector<double> errors;
  for (const double size : {0.3, 0.15}) errors.push_back(find_bearing_factor(size, 0) / exact - 1);
  EXPECT_GT(errors[0], -0.005);  // elements of displacements are an upper bound, but for their points
  EXPECT_LT(errors[1], 0.015);
  EXPECT_LT(errors[1], 0.7 * errors[0]);
}

TEST(StripFooting, FirstBracketOnEitherSideLeadsToTheSameFactor) {
  const mesh::Mesh<2> mesh = make_strip_block(0.25, true);
  const double expected = reduce_strip(mesh, 0).factor;
  for (const double away : {-0.2, -0.003, 0.003, 0.2}) {
    const auto found = reduce_strip(mesh, 0, expected + away, expected + away + 0.004);
    EXPECT_NEAR(found.factor, expected, 0.002) << away;
    EXPECT_LE(found.failed - found.stable, 0.002 * (1 + 1e-9)) << away;
    if (std::abs(away) < 0.1) {
      EXPECT_LE(found.trials.size(), 4u) << "a bracket beside the factor is widened by its width";
    }
  }
}

TEST(StripFooting, IntervalOfTwoMeshesHoldsPrandtlsFactor) {
  const double exact = (2 + std::acos(-1.0)) * cohesion / pressure;
  const auto interval = run::find_mesh_interval(run::make_mesh_factor_result(reduce_strip(0.3, 0), 0.3),
                                                run::make_mesh_factor_result(reduce_strip(0.15, 0), 0.15));
  ASSERT_TRUE(interval.has_value());
  EXPECT_LE(interval->lower, exact);
  EXPECT_GE(interval->upper, exact);
  EXPECT_LT(interval->upper - interval->lower, 0.05 * exact) << "and the interval is narrow";
}

TEST(StripFooting, IntervalOfAdaptedMeshesHoldsPrandtlsFactor) {
  const double exact = (2 + std::acos(-1.0)) * cohesion / pressure;
  std::vector<results::ElementMeshFactor> meshes;
  mesh::Mesh<2> mesh = make_strip_block(0.25, true);
  const std::size_t most = 10 * mesh.elements.size();
  for (;;) {
    const auto quadratic = fem::make_quadratic<2>(mesh);
    const auto found = reduce_strip(mesh, 0);
    const auto work = run::compute_shear_work(quadratic, found.at_failure, found.mechanism);
    meshes.push_back(run::make_mesh_factor_result(found, run::compute_shear_size(mesh, quadratic, work)));
    const auto marked = run::mark_shear(mesh, quadratic, work, most);
    if (!marked || meshes.size() == 3) break;
    mesh = mesh::refine(mesh, *marked);
    EXPECT_LE(mesh.elements.size(), most);
  }
  ASSERT_EQ(meshes.size(), 3u);
  EXPECT_GT(meshes[0].size, 1.10 * meshes[1].size) << "the size of the mechanism nearly halves";
  const auto interval = run::find_sequence_interval(meshes);
  ASSERT_TRUE(interval.has_value());
  EXPECT_LE(interval->lower, exact);
  EXPECT_GE(interval->upper, exact);
  EXPECT_LT(interval->upper - interval->lower, run::widest_interval * exact);
}

}  // namespace
}  // namespace talus
