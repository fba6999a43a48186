// SPDX-License-Identifier: MIT
// The MPM step equals the textbook step to round-off at every point, for every option and dimension. Damping is off,
// because Cundall's sign(v) amplifies round-off at a node at rest to a finite force.

#include <gtest/gtest.h>

#include <string>

#include "golden/plain_translation.hpp"
#include "material/every_law.hpp"
#include "mpm/solver/observe.hpp"
#include "mpm/solver/step.hpp"
#include "reference/plain_mpm.hpp"

namespace talus {
namespace {

using namespace golden;

struct Difference {
  double position = 0, velocity = 0, stress = 0, strain = 0, volume = 0, plastic = 0, gap = 0;
  double largest_velocity = 0, largest_stress = 0, largest_displacement = 0, largest_plastic = 0, largest_gap = 0;
};

template <int D>
Difference compare(const reference::Body<D>& plain, const mpm::Body<D>& body) {
  constexpr int row[6] = {0, 1, 2, 0, 1, 2}, column[6] = {0, 1, 2, 1, 2, 0};
  Difference r;
  for (const reference::Point<D>& p : plain.points) {
    const auto q = mpm::view_point(body, p.id);
    for (int d = 0; d < D; ++d) {
      r.position = std::max(r.position, std::abs(p.x[d] - q.position[d]));
      r.velocity = std::max(r.velocity, std::abs(p.v[d] - q.velocity[d]));
      r.largest_velocity = std::max(r.largest_velocity, std::abs(p.v[d]));
      r.largest_displacement = std::max(r.largest_displacement, std::abs(q.displacement[d]));
    }
    for (std::size_t i = 0; i < q.stress.size(); ++i) {
      r.stress = std::max(r.stress, std::abs(p.sigma(row[i], column[i]) - q.stress[i]));
      r.strain = std::max(r.strain, std::abs(p.strain(row[i], column[i]) * (i < 3 ? 1 : 2) - q.strain[i]));
      r.largest_stress = std::max(r.largest_stress, std::abs(q.stress[i]));
    }
    r.volume = std::max(r.volume, std::abs(p.volume - q.volume) / p.volume);
    r.plastic = std::max(r.plastic, std::abs(p.plastic_strain - q.plastic_strain));
    r.largest_plastic = std::max(r.largest_plastic, q.plastic_strain);
    r.gap = std::max(r.gap, std::abs(p.gap - material::find_gap(body.laws[q.material], q.state.data())));
    r.largest_gap = std::max(r.largest_gap, p.gap);
  }
  return r;
}

/// Steps both bodies and expects agreement to 1e-10 of the largest value of each field.
template <int D>
void expect_same(reference::Body<D> plain, const PlainVariant& v, int steps, bool must_move) {
  mpm::Body<D> body = translate(plain, 3);
  reference::Settings settings;
  settings.time_step = 0.4 * mpm::find_critical_step(body, 1.0).dt;
  settings.mixed = v.mixed;
  settings.smoothing = v.smoothing;
  settings.objective = v.objective;
  settings.frozen = v.frozen;
  settings.mass_scaling = v.mass_scaling;
  mpm::StepOptions<D> options;
  options.dt = settings.time_step;
  for (int d = 0; d < D; ++d) options.gravity[d] = plain.gravity[d];
  options.mass_scaling = v.mass_scaling;
  options.mixed = v.mixed;
  options.smoothing = translate(v.smoothing);
  options.objective = v.objective;
  options.moving = !v.frozen;
  mpm::gather_nodal_sums(body, options);
  const std::vector<int> before = body.points.element;
  for (int s = 0; s < steps; ++s) {
    reference::step(plain, settings);
    mpm::step(body, options);
    if (v.filter_interval > 0 && s % v.filter_interval == 0) {
      reference::filter_null_modes(plain);
      mpm::filter_null_modes(body, options);
    }
  }
  const Difference d = compare(plain, body);
  const double tolerance = 1e-10;
  EXPECT_LT(d.position, tolerance * std::max(1.0, d.largest_displacement)) << v.name;
  EXPECT_LT(d.velocity, tolerance * d.largest_velocity) << v.name;
  EXPECT_LT(d.stress, tolerance * d.largest_stress) << v.name;
  EXPECT_LT(d.strain, tolerance) << v.name;
  EXPECT_LT(d.volume, tolerance) << v.name;
  EXPECT_LT(d.plastic, tolerance * std::max(1.0, d.largest_plastic)) << v.name;
  EXPECT_LT(d.gap, tolerance) << v.name;
  if (v.comes_apart) {
    EXPECT_GT(d.largest_gap, 0) << v.name;
  }
  EXPECT_GT(d.largest_plastic, 0) << v.name << ": the case must yield to test anything";
  if (must_move && !v.frozen) {
    EXPECT_NE(before, body.points.element) << v.name << ": points must change their elements to test relocation";
  }
}

TEST(EngineAgainstReference, PlaneSlopeIsTheSamePointByPoint) {
  for (const PlainVariant& v : all_variants()) expect_same(set_in_motion(reference::make_slope<2>()), v, 120, true);
}

TEST(EngineAgainstReference, SpatialSlopeIsTheSamePointByPoint) {
  for (const PlainVariant& v : all_variants()) expect_same(set_in_motion(reference::make_slope<3>()), v, 60, true);
}

TEST(EngineAgainstReference, TwoMaterialsInOneBlockAreTheSamePointByPoint) {
  for (const PlainVariant& v : all_variants()) {
    auto plain = set_in_motion(reference::make_slope<2>());
    reference::Material other = plain.materials[0];
    other.plastic = false;
    other.young_modulus *= 2;
    plain.materials.push_back(other);
    for (auto& p : plain.points) p.material = std::sin(3 * p.x[0]) > 0.5 ? 1 : 0;
    expect_same(plain, v, 120, true);
  }
}

TEST(EngineAgainstReference, SandThatComesApartAndIsPressedAgainIsTheSame) {
  // Thrown up, it opens; heavy, it is back soon. Half of it is another sand, so that some blocks hold both.
  for (PlainVariant v : all_variants()) {
    auto plain = reference::make_slope<2>();
    reference::Material& sand = plain.materials[0];
    sand.cohesion = sand.tensile_strength = 0;
    plain.materials.push_back(sand);
    plain.materials.back().young_modulus *= 2;
    plain.gravity *= 20;
    for (auto& p : plain.points) {
      p.v[1] = 2 * p.x[1];
      if (std::sin(3 * p.x[0]) > 0.5) p.material = 1;
    }
    v.comes_apart = !v.frozen;
    expect_same(plain, v, 150, true);
  }
}

TEST(EngineAgainstReference, WallThatIsPushedInIsTheSame) {
  auto plane = reference::make_slope<2>();
  auto spatial = reference::make_slope<3>();
  reference::push_left_wall(plane.mesh, plane.constraints);
  reference::push_left_wall(spatial.mesh, spatial.constraints);
  for (const PlainVariant& v : all_variants()) {
    expect_same(plane, v, 120, true);
    expect_same(spatial, v, 40, false);
  }
}

TEST(EngineAgainstReference, FastLandslideThroughManyElementsIsTheSame) {
  auto plain = reference::make_slope<2>();
  for (auto& p : plain.points) p.v[0] = 4 * p.x[1];
  expect_same(plain, {"fast", true, reference::Smoothing::none, true, false, 1}, 150, true);
}

}  // namespace
}  // namespace talus
