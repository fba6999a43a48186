// SPDX-License-Identifier: MIT
// Walls in soil: nodes that they double, block that slides on an interface, cantilever under a line load, strut, pore
// pressure and surface loads on a wall, tangent against differences.

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <set>

#include "base/error.hpp"
#include "fem/solid/system.hpp"
#include "mesh/planar.hpp"
#include "support/solid_model.hpp"

namespace talus {
namespace {

constexpr double exact = 1e-3;  ///< relative error that a closed form allows

/// Elastic soil below a level of a box of 8 m × 8 m, whose base and lower sides are fixed, with a wall along a line.
struct Walled {
  mesh::Mesh<2> mesh;
  fem::SolidModel<2> model;

  Walled(double level, const std::vector<Vec<2>>& line, double size = 1, double young = 1e9) {
    mesh::Plan plan;
    plan.box_max = {8, 8};
    plan.size = size;
    plan.polygons = {{"soil", {{0, 0}, {8, 0}, {8, level}, {0, level}}}};
    plan.lines = {{"wall", line}};
    mesh = mesh::generate<2>(plan);
    model.mesh = &mesh;
    model.make_law = [young](int, double) -> material::Law { return material::LinearElastic::from_young(young, 0); };
    model.unit_weight.assign(mesh.elements.size(), 0);
    model.direction = {0, -1};
    support::add_roller<2>(model, 1, 0);
    model.supports.back().fixed = {true, true};
    fem::Wall wall;
    wall.name = "wall";
    wall.nodes = list_nodes(line);
    wall.axial_stiffness = 1e9, wall.bending_stiffness = 1e7, wall.shear_stiffness = 4e8;
    wall.normal_stiffness = 1e11, wall.tangential_stiffness = 4e10;
    model.walls = {wall};
  }
  Walled(const Walled&) = delete;
  Walled& operator=(const Walled&) = delete;

  fem::Wall& wall() { return model.walls[0]; }

  /// Returns the nodes on a straight line in its direction.
  std::vector<int> list_nodes(const std::vector<Vec<2>>& line) const {
    std::vector<std::pair<double, int>> found;
    for (int n = 0; n < mesh.node_count(); ++n)
      if (mesh::compute_distance(mesh.nodes[n], line[0], line[1]) < 1e-7)
        found.emplace_back(std::hypot(mesh.nodes[n][0] - line[0][0], mesh.nodes[n][1] - line[0][1]), n);
    std::sort(found.begin(), found.end());
    std::vector<int> nodes;
    for (const auto& [s, n] : found) nodes.push_back(n);
    return nodes;
  }
};

TEST(Walls, DoubleTheirNodesExceptTheToe) {
  const Walled case_(8, {{4, 8}, {4, 3}});
  const auto plain = fem::make_quadratic<2>(case_.mesh);
  const auto split = fem::make_quadratic<2>(case_.mesh, fem::list_cuts(case_.model));
  const std::size_t pieces = case_.model.walls[0].nodes.size() - 1;
  EXPECT_EQ(split.nodes.size(), plain.nodes.size() + 2 * pieces) << "each edge has its middle and its upper end twice";
  EXPECT_TRUE(plain.original.empty());
  // No element has nodes of both sides.
  for (std::size_t k = 0; k < split.elements.size(); ++k) {
    double left = 8, right = 0;
    for (const int n : split.elements[k]) {
      left = std::min(left, split.nodes[n][0]), right = std::max(right, split.nodes[n][0]);
      EXPECT_EQ(split.find_original(n),
                plain.elements[k][std::find(split.elements[k].begin(), split.elements[k].end(), n) -
                                  split.elements[k].begin()]);
    }
    EXPECT_TRUE(left >= 4 - 1e-9 || right <= 4 + 1e-9 || split.points[3 * k][1] < 3);
  }
  std::map<int, std::set<bool>> sides;
  for (const auto& element : split.elements) {
    double middle = 0;
    for (std::size_t i = 0; i < 3; ++i) middle += split.nodes[element[i]][0] / 3;
    for (const int n : element)
      if (std::abs(split.nodes[n][0] - 4) < 1e-9 && split.nodes[n][1] > 3 + 1e-9) sides[n].insert(middle > 4);
  }
  EXPECT_EQ(sides.size(), 4 * pieces);
  for (const auto& [n, own] : sides) EXPECT_EQ(own.size(), 1u) << n;
}

/// A block of 4 m on an interface at y = 4, with a pressure and a shear stress on its top.
struct SlidingBlock : Walled {
  static constexpr double pressure = 100e3, adhesion = 5e3, friction = 0.4;
  SlidingBlock(double size, double shear) : Walled(8, {{0, 4}, {8, 4}}, size) {
    wall().interface = [](int, const Vec<2>&) { return fem::InterfaceStrength{adhesion, friction}; };
    support::add_load<2>(model, support::find_sides_at<2>(mesh, 1, 8), {shear, -pressure});
  }
};

TEST(Walls, BlockSlidesAtTheStrengthOfItsInterface) {
  // τ = (a + σ tan δ)/F
  const double strength = SlidingBlock::adhesion + SlidingBlock::pressure * SlidingBlock::friction;
  for (const double size : {2.0, 1.0}) {
    const SlidingBlock block(size, strength / 1.5);
    fem::ReductionOptions options;
    options.from = 1, options.to = 2, options.resolution = 5e-4;
    options.solid.threads = 1;
    const auto found = fem::reduce_strength<2>(block.model, options);
    EXPECT_NEAR(found.factor, 1.5, exact * 1.5) << size;
    EXPECT_TRUE(found.flowing > 0);
  }
}

TEST(Walls, JointHasNoTensionAndFriction) {
  const fem::Joint joint{.normal_stiffness = 1e8, .tangential_stiffness = 4e7, .adhesion = 2e3, .friction = 0.5};
  auto answer = fem::update_joint(joint, {}, {0, 0}, {-1e-4, 1e-5});
  EXPECT_DOUBLE_EQ(answer.force[0], -1e4);
  EXPECT_DOUBLE_EQ(answer.force[1], 400);
  answer = fem::update_joint(joint, {}, {-1e-4, 0}, {0, -1});
  EXPECT_DOUBLE_EQ(answer.force[1], -7e3);
  EXPECT_DOUBLE_EQ(answer.elastic[1], -7e3 / 4e7) << "the rest is plastic";
  EXPECT_DOUBLE_EQ(answer.tangent[2], 0.5 * 1e8) << "compression raises the negative limit";
  EXPECT_DOUBLE_EQ(fem::update_joint(joint, {.factor = 2}, {-1e-4, 0}, {0, 1}).force[1], 3.5e3);
  answer = fem::update_joint(joint, {}, {-1e-4, 1e-4}, {2e-4, 0});
  EXPECT_DOUBLE_EQ(answer.force[0], 0);
  EXPECT_DOUBLE_EQ(answer.elastic[0], 1e-4) << "the gap closes before it presses";
  EXPECT_DOUBLE_EQ(answer.force[1], 1.8e3) << "adhesion fades over 1 mm";
  EXPECT_DOUBLE_EQ(fem::update_joint(joint, {}, {0, 1e-4}, {2e-3, 0}).force[1], 0);
}

/// Soil of 4 m with a wall that stands out of it by 3 m.
struct Cantilever : Walled {
  static constexpr double free = 3;
  explicit Cantilever(double size) : Walled(4, {{4, 7}, {4, 1}}, size, 1e13) {
    wall().normal_stiffness = wall().tangential_stiffness = 1e14;
  }
};

TEST(Walls, CantileverUnderALineLoadHasItsClosedForm) {
  for (const double size : {1.0, 0.6}) {
    Cantilever cantilever(size);
    constexpr double load = 2e3;
    cantilever.wall().line_load = {load, 0};
    const auto r = fem::find_equilibrium<2>(cantilever.model, support::make_tight());
    ASSERT_TRUE(r.converged);
    const auto forces = fem::compute_bar_forces(cantilever.model, r.at)[0];
    ASSERT_GE(forces.moment.place.size(), 6u);
    for (std::size_t i = 0; i < forces.moment.place.size(); ++i) {
      const double s = forces.moment.place[i];
      if (s > Cantilever::free) break;
      EXPECT_NEAR(std::abs(forces.moment.value[i]), load * s * s / 2, exact * load * 4.5) << size << " " << s;
      EXPECT_NEAR(std::abs(forces.shear.value[i]), load * s, exact * load * 3) << size << " " << s;
      EXPECT_NEAR(forces.axial.value[i], 0, 1);
    }
  }
}

TEST(Walls, HeadOfAnAnchorPressesOnTheWall) {
  // A prestressed anchor from 1 m below the top of a wall that stands out of the soil.
  Cantilever cantilever(0.8);
  constexpr double prestress = 10e3;
  fem::Bar anchor;
  anchor.name = "tie";
  anchor.head = {4, 6}, anchor.end = {7, 1};
  anchor.axial_stiffness = 1e8;
  anchor.free_length = 4.5;
  anchor.prestress = prestress;
  anchor.bond_stiffness = 1e9;
  anchor.plate = 1e6, anchor.plate_stiffness = 1e9;
  anchor.wall = 0;
  cantilever.model.bars = {anchor};
  constexpr double load = 1e3;
  cantilever.wall().line_load = {load, 0};
  const auto r = fem::find_equilibrium<2>(cantilever.model, support::make_tight());
  ASSERT_TRUE(r.converged);
  const auto forces = fem::compute_bar_forces(cantilever.model, r.at);
  ASSERT_EQ(forces.size(), 2u);
  EXPECT_NEAR(forces[0].plate, prestress, exact * prestress);
  const double length = std::hypot(3, 5), across = prestress * 3 / length, along = prestress * 5 / length;
  const fem::BarForces& wall = forces[1];
  double middle = 0;  // of the piece with the head, over which the force is spread
  for (std::size_t i = 0; i < wall.moment.place.size(); ++i) {
    const double s = wall.moment.place[i];
    if (s > Cantilever::free) break;
    const double lever = std::max(0.0, s - 1);
    if (std::abs(s - 1) < 0.8) {
      middle = s;
      continue;
    }
    EXPECT_NEAR(std::abs(wall.moment.value[i]), load * s * s / 2 + across * lever, exact * across * 2) << s;
    EXPECT_NEAR(std::abs(wall.shear.value[i]), load * s + (s > 1 ? across : 0), exact * across) << s;
    EXPECT_NEAR(wall.axial.value[i], s > 1 ? -along : 0, exact * along) << s;
  }
  EXPECT_GT(middle, 0);
}

TEST(Walls, SectionYieldsByAxialForceAndMoment) {
  const fem::Joint section{
      .is_section = true, .axial = 1e5, .moment = 2e4, .normal_stiffness = 1e8, .tangential_stiffness = 5e6};
  const auto sum = [&](const fem::JointAnswer& a) {
    return std::abs(a.force[0]) / section.axial + std::abs(a.force[1]) / section.moment;
  };
  const auto update = [&](double strain, double curvature) {
    return fem::update_joint(section, {.factor = 3}, {0, 0}, {strain, curvature});
  };
  auto answer = update(-4e-4, 2e-3);
  EXPECT_FALSE(answer.yields);
  EXPECT_DOUBLE_EQ(answer.force[0], -4e4);
  EXPECT_DOUBLE_EQ(answer.force[1], 1e4);
  for (const auto& [strain, curvature] : {std::pair{-6e-4, 4e-3}, {5e-4, -5e-3}, {3e-4, 3e-3}}) {
    answer = update(strain, curvature);
    EXPECT_TRUE(answer.yields);
    EXPECT_NEAR(sum(answer), 1, 1e-12) << "the factor of the trial does not divide it";
    // The plastic part is normal to the strength.
    const double plastic_strain = strain - answer.elastic[0], plastic_curvature = curvature - answer.elastic[1];
    EXPECT_NEAR(plastic_strain * section.axial * (strain < 0 ? -1 : 1),
                plastic_curvature * section.moment * (curvature < 0 ? -1 : 1), 1e-9);
  }
  answer = update(0, 1);
  EXPECT_DOUBLE_EQ(answer.force[0], 0) << "a corner: bending alone";
  EXPECT_DOUBLE_EQ(answer.force[1], 2e4);
  answer = update(-1, 1e-4);
  EXPECT_DOUBLE_EQ(answer.force[0], -1e5);
  EXPECT_DOUBLE_EQ(answer.force[1], 0);
}

TEST(Walls, AxialForceLowersTheBendingStrength) {
  // Half of N_p leaves half of M_p.
  const auto is_stable = [](double share, double compression) {
    Cantilever cantilever(0.7);
    cantilever.wall().moment = 10e3, cantilever.wall().axial = 30e3;
    cantilever.wall().line_load = {share * 2 * 10e3 / (Cantilever::free * Cantilever::free), -compression};
    return fem::find_equilibrium<2>(cantilever.model, {}).converged;
  };
  EXPECT_TRUE(is_stable(0.99, 0));
  EXPECT_TRUE(is_stable(0.49, 5e3));
  EXPECT_FALSE(is_stable(0.66, 5e3)) << "N = 15 kN at the soil; the hinge forms at the point above it";
}

TEST(Walls, CantileverFailsAtItsPlasticMoment) {
  const auto is_stable = [](double share) {
    Cantilever cantilever(0.7);
    cantilever.wall().moment = 10e3;
    cantilever.wall().line_load = {share * 2 * 10e3 / (Cantilever::free * Cantilever::free), 0};
    return fem::find_equilibrium<2>(cantilever.model, {}).converged;
  };
  EXPECT_TRUE(is_stable(0.99));
  EXPECT_FALSE(is_stable(1.15));
}

/// Soil in the left half alone, with a wall along its free side and 4 m of the soil below it.
struct Retained : Walled {
  explicit Retained(double size) : Walled(8, {{4, 8}, {4, 2}}, size, 1e9) {
    // The right half above y = 4 is empty.
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
      double x = 0, y = 0;
      for (const int n : mesh.elements[e]) x += mesh.nodes[n][0] / 3, y += mesh.nodes[n][1] / 3;
      if (x > 4 && y > 4) mesh.element_region[e] = mesh::empty_region;
    }
    wall().interface = [](int, const Vec<2>&) { return fem::InterfaceStrength{0, 0.3}; };
  }
};

TEST(Walls, PressureOnACoveredSideActsOnTheWall) {
  Retained retained(0.5);
  std::vector<std::array<int, 2>> sides;
  double length = 0;
  for (std::size_t i = 0; i + 1 < retained.wall().nodes.size(); ++i) {
    const int a = retained.wall().nodes[i], b = retained.wall().nodes[i + 1];
    if (retained.mesh.nodes[b][1] < 5) continue;
    sides.push_back({a, b});
    length += retained.mesh.nodes[a][1] - retained.mesh.nodes[b][1];
  }
  constexpr double pressure = 10e3;
  support::add_load<2>(retained.model, sides, {-pressure, 0});
  const auto r = fem::find_equilibrium<2>(retained.model, support::make_tight());
  ASSERT_TRUE(r.converged);
  const auto forces = fem::compute_bar_forces(retained.model, r.at)[0];
  const auto sum = [](const std::vector<fem::FacePoint>& face) {
    double force = 0;
    for (std::size_t i = 0; i + 2 < face.size(); i += 3)
      force += (face[i + 2].place - face[i].place) * (face[i].normal + 4 * face[i + 1].normal + face[i + 2].normal) / 6;
    return force;
  };
  EXPECT_NEAR(sum(forces.face[1]) - sum(forces.face[0]), length * pressure, exact * length * pressure);
  // The wall moves with the soil behind it, towards smaller x: the right of the way from its head down.
  ASSERT_FALSE(forces.deflection.place.empty());
  EXPECT_EQ(forces.deflection.place.front(), 0);
  const fem::SolidSystem<2> system(retained.model);
  for (std::size_t n = 0; n < r.at.displacement.size(); ++n) {
    const auto& x = system.mesh.nodes[n];
    if (std::abs(x[0] - 4) < 1e-9 && std::abs(x[1] - 8) < 1e-9) {
      EXPECT_LT(r.at.displacement[n][0], 0);
      EXPECT_NEAR(forces.deflection.value.front(), r.at.displacement[n][0], 0.01 * std::abs(r.at.displacement[n][0]));
    }
  }
}

TEST(Walls, StrutCarriesWhatPressesTheWall) {
  Retained retained(0.5);
  retained.wall().struts = {{7, 1e12, fem::unlimited, 0}};
  retained.wall().line_load = {5e3, 0};
  auto r = fem::find_equilibrium<2>(retained.model, support::make_tight());
  ASSERT_TRUE(r.converged);
  const auto forces = fem::compute_bar_forces(retained.model, r.at)[0];
  ASSERT_EQ(forces.strut.value.size(), 1u);
  EXPECT_GT(forces.strut.value[0], 5e3);
  // The shear force jumps by the force of the strut.
  double before = 0, after = 0;
  for (std::size_t i = 0; i < forces.shear.place.size(); ++i) {
    if (forces.shear.place[i] < 1) before = forces.shear.value[i];
    if (forces.shear.place[i] > 1 && after == 0) after = forces.shear.value[i];
  }
  EXPECT_NEAR(std::abs(after - before), forces.strut.value[0], 0.15 * forces.strut.value[0]);
  retained.wall().struts[0].prestress = 20e3;
  r = fem::find_equilibrium<2>(retained.model, support::make_tight());
  EXPECT_DOUBLE_EQ(fem::compute_bar_forces(retained.model, r.at)[0].strut.value[0], 20e3);
  retained.wall().struts[0].level = 3;
  EXPECT_THROW(fem::SolidSystem<2>{retained.model}, Error) << "soil is on both sides there";
}

TEST(Walls, PorePressureIsNoStressOfTheInterface) {
  // Soil in equilibrium with its pore water: a pressure on top and water of the same pressure inside.
  Walled block(8, {{4, 8}, {4, 3}});
  constexpr double pore = 30e3;
  block.model.pore_stress.assign(block.mesh.elements.size(), {-pore, -pore, -pore});
  support::add_load<2>(block.model, support::find_sides_at<2>(block.mesh, 1, 8), {0, -pore});
  support::add_load<2>(block.model, support::find_sides_at<2>(block.mesh, 0, 0), {pore, 0});
  support::add_load<2>(block.model, support::find_sides_at<2>(block.mesh, 0, 8), {-pore, 0});
  const auto r = fem::find_equilibrium<2>(block.model, support::make_tight());
  ASSERT_TRUE(r.converged);
  for (const auto& face : fem::compute_bar_forces(block.model, r.at)[0].face) {
    EXPECT_FALSE(face.empty());
    for (const auto& p : face) EXPECT_NEAR(p.normal, 0, exact * pore);
  }
}

void check_tangent(double axial) {
  Retained retained(1);
  retained.wall().axial = axial;
  retained.wall().interface = [](int, const Vec<2>& x) { return fem::InterfaceStrength{1e3 * x[1], 0.3}; };
  retained.wall().moment = 4e3, retained.wall().shear = 9e4;
  retained.wall().normal_stiffness = 1e9, retained.wall().tangential_stiffness = 4e8;
  retained.wall().struts = {{7, 1e8, 2e4, 0}};
  const fem::SolidSystem<2> system(retained.model);
  const fem::SolidAssembly<2> assembly(system, {retained.model.make_law(0, 1)}, 1);
  auto start = assembly.make_start();
  for (std::size_t s = system.springs.list.size(); s < start.bars.size(); s += 2) start.bars[s] = -5e-5;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> push(-1e-4, 1e-4);
  std::vector<double> q(static_cast<std::size_t>(system.unknowns));
  for (double& x : q) x = push(random);
  fem::SolidState<2> end;
  fem::SolidSums sums, more, less;
  assembly.evaluate(start, q, true, end, sums);
  EXPECT_FALSE(sums.symmetric);
  EXPECT_GT(sums.yielding, 5);
  double largest = 0;
  for (const double x : sums.matrix) largest = std::max(largest, std::abs(x));
  const auto find_entry = [&](int i, int j) {
    for (int k = system.column_start[j]; k < system.column_start[j + 1]; ++k)
      if (system.row[k] == i) return sums.matrix[k];
    return 0.0;
  };
  for (int j = 0; j < system.unknowns; ++j) {
    constexpr double step = 1e-10;
    auto near = q;
    near[j] += step;
    assembly.evaluate(start, near, false, end, more);
    near[j] -= 2 * step;
    assembly.evaluate(start, near, false, end, less);
    for (int i = 0; i < system.unknowns; ++i)
      ASSERT_NEAR(find_entry(i, j), (more.force[i] - less.force[i]) / (2 * step), 1e-5 * largest) << i << " " << j;
  }
}

TEST(Walls, TangentIsThatOfDifferences) {
  check_tangent(fem::unlimited);
}

TEST(Walls, TangentOfSectionsIsThatOfDifferences) {
  check_tangent(6e4);
}

TEST(Walls, WallsThatAreNoneAreRefused) {
  Walled block(8, {{4, 8}, {4, 3}});
  fem::Wall given = block.wall();
  block.wall().bending_stiffness = 0;
  EXPECT_THROW(fem::SolidSystem<2>{block.model}, Error);
  block.wall() = given;
  block.wall().nodes.resize(1);
  EXPECT_THROW(fem::SolidSystem<2>{block.model}, Error);
}

}  // namespace
}  // namespace talus
