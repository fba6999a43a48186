// SPDX-License-Identifier: MIT
// Exact equilibrium of quadratic elements: every stress that is linear in space is reproduced on any mesh; and the
// messages on invalid meshes.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/error.hpp"
#include "support/solid_model.hpp"
#include "unit/mesh_grid.hpp"

namespace talus {
namespace {

using support::add_load;
using support::add_roller;
using support::find_sides_at;

constexpr double young = 20e6, poisson = 0.3, weight = 18e3;

template <int D>
mesh::Mesh<D> make_block(int n, double h) {
  if constexpr (D == 2)
    return mesh::make_grid(n, n, h);
  else
    return mesh::make_grid(n, n, n, h);
}

/// A cube whose inner nodes are pushed about, elastic, on rollers at the three coordinate planes.
template <int D>
struct Block {
  mesh::Mesh<D> mesh;
  fem::SolidModel<D> model;
  static constexpr double edge = 2;
  Block() : mesh(make_block<D>(4, 0.5)) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> push(-0.09, 0.09);
    for (auto& x : mesh.nodes) {
      bool inside = true;
      for (double v : x) inside = inside && v > 1e-9 && v < edge - 1e-9;
      for (double& v : x) v += inside ? push(random) : 0;
    }
    mesh::finish(mesh);
    model.mesh = &mesh;
    model.make_law = [](int, double) -> material::Law { return material::LinearElastic::from_young(young, poisson); };
    model.unit_weight.assign(mesh.elements.size(), 0);
    for (std::size_t d = 0; d < D; ++d) add_roller<D>(model, d, 0);
  }
  Block(const Block&) = delete;
};

template <class T>
class Equilibrium : public testing::Test {};
template <int N>
struct Dimension {
  static constexpr int value = N;
};
using Dimensions = testing::Types<Dimension<2>, Dimension<3>>;
TYPED_TEST_SUITE(Equilibrium, Dimensions);

TYPED_TEST(Equilibrium, PatchOfUniformStress) {
  constexpr int D = TypeParam::value;
  Block<D> block;
  const std::array<double, 3> traction{-50e3, -80e3, 20e3};
  for (std::size_t d = 0; d < D; ++d) {
    Vec<D> t{};
    t[d] = traction[d];
    add_load<D>(block.model, find_sides_at<D>(block.mesh, d, block.edge), t);
  }
  const auto r = fem::find_equilibrium<D>(block.model, {});
  ASSERT_TRUE(r.converged);
  const double out = D == 2 ? poisson * (traction[0] + traction[1]) : traction[2];
  for (const auto& s : r.at.stress) {
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(s[i], i == 2 ? out : traction[i], 1e-3);
    for (std::size_t i = 3; i < 6; ++i) EXPECT_NEAR(s[i], 0, 1e-3);
  }
  const auto mesh = fem::make_quadratic<D>(block.mesh);
  const double sum = traction[0] + traction[1] + out;
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
    for (std::size_t d = 0; d < D; ++d)
      EXPECT_NEAR(r.at.displacement[n][d], mesh.nodes[n][d] * ((1 + poisson) * traction[d] - poisson * sum) / young,
                  1e-9);
}

/// Hardly compressible soil, with a bulk modulus of 10⁸ times the shear modulus: factors in single precision do not
/// suffice for the tolerance.
TYPED_TEST(Equilibrium, HardlyCompressibleSoil) {
  constexpr int D = TypeParam::value;
  constexpr double pressure = 50e3;
  Block<D> block;
  block.model.make_law = [](int, double) -> material::Law {
    return material::LinearElastic::from_young(young, 0.5 - 1e-8);
  };
  Vec<D> down{};
  down[1] = -pressure;
  add_load<D>(block.model, find_sides_at<D>(block.mesh, 1, block.edge), down);
  const auto r = fem::find_equilibrium<D>(block.model, {});
  ASSERT_TRUE(r.converged);
  for (const auto& s : r.at.stress) {
    EXPECT_NEAR(s[1], -pressure, 5);
    EXPECT_NEAR(s[0], 0, 5);
  }
}

TYPED_TEST(Equilibrium, ColumnUnderItsWeightAndPorePressure) {
  constexpr int D = TypeParam::value;
  Block<D> block;
  block.model.unit_weight.assign(block.mesh.elements.size(), weight);
  block.model.direction[1] = -1;
  const double water = 9810;  // below the surface; all walls are rollers
  for (std::size_t d = 0; d < D; ++d)
    if (d != 1) add_roller<D>(block.model, d, block.edge);
  for (const auto& element : block.mesh.elements) {
    std::array<double, D + 1> p;
    for (std::size_t i = 0; i <= D; ++i)
      p[i] = -water * (block.edge - block.mesh.nodes[static_cast<std::size_t>(element[i])][1]);
    block.model.pore_stress.push_back(p);
  }
  const auto r = fem::find_equilibrium<D>(block.model, {});
  ASSERT_TRUE(r.converged);
  EXPECT_EQ(r.iterations, r.load_steps) << "an elastic step is one linear system";
  const auto mesh = fem::make_quadratic<D>(block.mesh);
  const double effective = weight - water, k0 = poisson / (1 - poisson);
  for (std::size_t p = 0; p < mesh.points.size(); ++p) {
    const double vertical = -effective * (block.edge - mesh.points[p][1]);
    EXPECT_NEAR(r.at.stress[p][1], vertical, 1e-3);
    EXPECT_NEAR(r.at.stress[p][0], k0 * vertical, 1e-3);
    EXPECT_NEAR(r.at.stress[p][2], k0 * vertical, 1e-3);
  }
  const double modulus = young * (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson));
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    const double y = mesh.nodes[n][1];
    EXPECT_NEAR(r.at.displacement[n][1], -effective / modulus * (block.edge * y - y * y / 2), 1e-9);
  }
}

TEST(SolidEquilibrium, TurnedWorldGivesTurnedAnswer) {
  // The column of above turned by 30°: rollers along walls that no coordinate axis is normal to.
  const double angle = 30 * support::degree, c = std::cos(angle), s = std::sin(angle);
  std::array<fem::SolidResult<2>, 2> results;
  for (std::size_t turned = 0; turned < 2; ++turned) {
    Block<2> block;
    const auto left = find_sides_at<2>(block.mesh, 0, 0), right = find_sides_at<2>(block.mesh, 0, block.edge),
               base = find_sides_at<2>(block.mesh, 1, 0);
    block.model.supports.clear();
    for (const auto& sides : {left, right, base}) {
      fem::Support<2> support;
      support.sides = sides;
      support.along_normal = true;
      block.model.supports.push_back(support);
    }
    block.model.unit_weight.assign(block.mesh.elements.size(), weight);
    block.model.direction = {0.2, -1};  // with an earthquake
    block.model.make_law = [](int, double) -> material::Law {
      return material::MohrCoulomb(material::LinearElastic::from_young(young, poisson),
                                   {3e3, 25 * support::degree, 0, 3e3});
    };
    if (turned) {
      for (auto& x : block.mesh.nodes) x = {c * x[0] - s * x[1], s * x[0] + c * x[1]};
      auto& d = block.model.direction;
      d = {c * d[0] - s * d[1], s * d[0] + c * d[1]};
    }
    results[turned] = fem::find_equilibrium<2>(block.model, {});
    ASSERT_TRUE(results[turned].converged);
  }
  const auto &a = results[0].at, &b = results[1].at;
  double largest = 0;
  for (const auto& u : a.displacement) largest = std::max(largest, norm(u));
  for (std::size_t n = 0; n < a.displacement.size(); ++n) {
    const auto& u = a.displacement[n];
    EXPECT_NEAR(b.displacement[n][0], c * u[0] - s * u[1], 1e-6 * largest);
    EXPECT_NEAR(b.displacement[n][1], s * u[0] + c * u[1], 1e-6 * largest);
  }
}

TEST(SolidEquilibrium, ThreadsDoNotChangeABit) {
  support::SoilSection section{{{0, 0}, {12, 0}, {12, 3}, {9, 3}, {3, 7}, {0, 7}}, 3e3, 25, 0, 18e3};
  const support::SolidSlope<2> slope(section);
  std::array<fem::SolidResult<2>, 2> r;
  for (std::size_t k = 0; k < 2; ++k) {
    fem::SolidOptions options;
    options.threads = k == 0 ? 1 : 3;
    r[k] = fem::find_equilibrium<2>(slope.model, options);
  }
  EXPECT_EQ(r[0].at.displacement, r[1].at.displacement);
  EXPECT_EQ(r[0].at.stress, r[1].at.stress);
}

TEST(SolidEquilibrium, ClayInTheOedometerFollowsItsLaw) {
  // from initial stress and state to twice the load, against the law alone in a thousand steps
  material::CamClayParameters p;
  p.compression = 0.1, p.swelling = 0.01, p.poisson_ratio = 0.3, p.critical_state_slope = 1.1;
  const material::ModifiedCamClay clay(p);
  Block<2> block;
  add_roller<2>(block.model, 0, block.edge);
  add_load<2>(block.model, find_sides_at<2>(block.mesh, 1, block.edge), {0, -200e3});
  std::array<double, 6> start{-60e3, -100e3, -60e3};
  block.model.initial_stress.assign(block.mesh.elements.size(), start);
  block.model.make_law = [&](int, double) -> material::Law { return clay; };
  const auto set = [&](double* state) { clay.set_initial_state(start.data(), 0.8, 0, 80e3, 1, state); };
  block.model.set_state = [&](int, const Vec<2>&, double* state) { set(state); };
  fem::SolidOptions options;
  options.load_steps = 200;
  options.force_tolerance = 1e-8;
  const auto r = fem::find_equilibrium<2>(block.model, options);
  ASSERT_TRUE(r.converged);
  std::array<double, 3> state{};
  set(state.data());
  auto stress = start;
  const double strain = r.at.strain[0][1];
  for (int k = 0; k < 1000; ++k) {
    const std::array<double, 4> d{0, strain / 1000, 0, 0};
    clay.update<4, double>(stress.data(), d.data(), state.data(), true);
  }
  EXPECT_NEAR(stress[1], -200e3, 600);  // what 200 steps leave
  for (std::size_t q = 0; q < r.at.stress.size(); ++q) {
    EXPECT_NEAR(r.at.stress[q][1], -200e3, 1);
    EXPECT_NEAR(r.at.stress[q][0], stress[0], 600);
    EXPECT_NEAR(r.at.state[q * 3 + 2], state[2], 1e-4);
    EXPECT_TRUE(r.at.yields[q]);
  }
}

std::string find_sentence(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ExitCode::wrong_input);
    return e.what();
  }
  return "nothing was thrown";
}

TEST(SolidEquilibrium, FaultsAreNamed) {
  Block<2> block;
  const auto run = [&] { fem::find_equilibrium<2>(block.model, {}); };
  std::swap(block.mesh.elements[17][0], block.mesh.elements[17][1]);
  EXPECT_NE(find_sentence(run).find("element 17 of 'soil' at ("), std::string::npos) << find_sentence(run);
  EXPECT_NE(find_sentence(run).find("is inverted"), std::string::npos);
  std::swap(block.mesh.elements[17][0], block.mesh.elements[17][1]);
  const auto regions = block.mesh.element_region;
  block.mesh.element_region.assign(regions.size(), mesh::empty_region);
  EXPECT_NE(find_sentence(run).find("no element with soil"), std::string::npos) << find_sentence(run);
  block.mesh.element_region = regions;
  block.model.supports.clear();
  EXPECT_NE(find_sentence(run).find("support"), std::string::npos) << find_sentence(run);
}

}  // namespace
}  // namespace talus
