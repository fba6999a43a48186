// SPDX-License-Identifier: MIT
// Transfer of the FEM stress to material points: a linear field is reproduced on any mesh.

#include "site/known_state.hpp"

#include <gtest/gtest.h>

#include "mesh/generate.hpp"
#include "mesh/points.hpp"

namespace talus {
namespace {

mesh::Plan make_plan(double size) {
  mesh::Plan plan;
  plan.box_min = {0, 0};
  plan.box_max = {10, 6};
  plan.polygons.push_back({.name = "soil", .points = {{0, 0}, {10, 0}, {10, 2}, {6, 2}, {3, 5}, {0, 5}}});
  plan.size = size;
  return plan;
}

/// σ_xx, σ_yy, σ_zz, σ_xy of a field that is linear in both coordinates.
std::array<double, 6> find_field(const Vec<2>& x) {
  return {-3e3 + 200 * x[0] + 50 * x[1], -9e3 + 10 * x[0] + 1800 * x[1], -4e3 + 30 * x[1], 100 * x[0] - 7 * x[1], 0, 0};
}

input::KnownStress make_known(double size) {
  input::KnownStress known;
  known.mesh = mesh::generate<2>(make_plan(size));
  known.elements.resize(known.mesh.elements.size());
  for (int e = 0; e < known.mesh.element_count(); ++e)
    for (std::size_t q = 0; q < 3; ++q) {
      Vec<2> xi{1.0 / 6, 1.0 / 6};
      if (q > 0) xi[q - 1] = 2.0 / 3;
      known.elements[e].stress[q] = find_field(mesh::to_global(known.mesh, e, xi));
      known.elements[e].plastic_strain[q] = 10 * e + static_cast<double>(q);
    }
  return known;
}

void expect_field(const input::KnownStress& known, const mesh::Mesh<2>& mesh) {
  site::StressReader reader(known, mesh);
  for (int e = 0; e < mesh.element_count(); ++e) {
    if (mesh.element_region[e] == mesh::empty_region) continue;
    for (const Vec<2>& xi : mesh::point_positions<2>(6)) {
      const site::StressAt here = reader.read(e, xi);
      const auto expected = find_field(mesh::to_global(mesh, e, xi));
      for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(here.stress[k], expected[k], 1e-6);
    }
  }
}

TEST(KnownStress, ALinearFieldIsTheSameOnItsOwnMesh) {
  const input::KnownStress known = make_known(1);
  expect_field(known, known.mesh);
}

TEST(KnownStress, ALinearFieldIsTheSameOnAnotherMesh) {
  expect_field(make_known(1), mesh::generate<2>(make_plan(0.37)));
  expect_field(make_known(0.4), mesh::generate<2>(make_plan(1.3)));
}

TEST(KnownStress, ThePlasticStrainIsThatOfTheNearestIntegrationPoint) {
  const input::KnownStress known = make_known(1);
  site::StressReader reader(known, known.mesh);
  int e = 0;
  while (known.mesh.element_region[e] == mesh::empty_region) ++e;
  EXPECT_EQ(reader.read(e, {0.1, 0.1}).plastic_strain, 10 * e);
  EXPECT_EQ(reader.read(e, {0.8, 0.1}).plastic_strain, 10 * e + 1);
  EXPECT_EQ(reader.read(e, {0.1, 0.8}).plastic_strain, 10 * e + 2);
}

}  // namespace
}  // namespace talus
