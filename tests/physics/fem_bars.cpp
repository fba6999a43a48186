// SPDX-License-Identifier: MIT
// Bars in soil against closed forms: bar in a uniform strain, pull-out, prestress, bolted block in compression, beams;
// and the tangent against differences.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/error.hpp"
#include "fem/solid/system.hpp"
#include "sparse/solver.hpp"
#include "support/solid_model.hpp"

namespace talus {
namespace {

using support::SoilSection;
using support::SolidSlope;

constexpr double exact = 1e-3;  ///< relative error that a closed form allows

/// A block without weight, 8 m × 4 m, on rollers below and at the left.
SoilSection make_block(double size, double young = 1e8) {
  return {{{0, 0}, {8, 0}, {8, 4}, {0, 4}}, 1e9, 0, 0, 0, young, 0, size};
}

/// Rollers at x = 0 and y = 0; elastic.
struct ElasticBlock : SolidSlope<2> {
  explicit ElasticBlock(double size, double young = 1e8) : SolidSlope<2>(make_block(size, young)) {
    model.make_law = [young](int, double) -> material::Law { return material::LinearElastic::from_young(young, 0); };
    model.supports.clear();
    support::add_roller<2>(model, 0, 0);
    support::add_roller<2>(model, 1, 0);
  }
  /// Fixes the whole outline but the right side.
  void fix() {
    support::add_roller<2>(model, 0, 0);
    model.supports.back().fixed = {true, true};
    for (const double y : {0.0, 4.0}) {
      support::add_roller<2>(model, 1, y);
      model.supports.back().fixed = {true, true};
    }
  }
};

fem::Bar make_nail(const Vec<2>& head, const Vec<2>& end) {
  fem::Bar bar;
  bar.name = "nail";
  bar.head = head, bar.end = end;
  bar.axial_stiffness = 1e7;
  bar.bond_stiffness = 1e9;
  return bar;
}

double interpolate(const fem::BarCurve& curve, double place) {
  for (std::size_t i = 1; i < curve.place.size(); ++i)
    if (curve.place[i] >= place)
      return curve.value[i - 1] + (curve.value[i] - curve.value[i - 1]) * (place - curve.place[i - 1]) /
                                      (curve.place[i] - curve.place[i - 1]);
  return curve.value.back();
}

TEST(Bars, SpringYieldsSlackensAndKeepsItsPrestress) {
  fem::Spring spring{.stiffness = 10, .lower = -2, .upper = 4};
  EXPECT_DOUBLE_EQ(fem::update_spring(spring, {}, 0.1, 0.2).force, 3);
  EXPECT_DOUBLE_EQ(fem::update_spring(spring, {}, 0.1, 0.4).force, 4);
  EXPECT_DOUBLE_EQ(fem::update_spring(spring, {}, 0.1, 0.4).elastic, 0.4) << "the rest is plastic";
  EXPECT_DOUBLE_EQ(fem::update_spring(spring, {}, 0, -1).force, -2);
  spring.is_reduced = true;
  EXPECT_DOUBLE_EQ(fem::update_spring(spring, {.factor = 2}, 0.1, 0.4).force, 2);
  spring.slackens = true;
  EXPECT_DOUBLE_EQ(fem::update_spring(spring, {}, 0.1, -0.3).force, 0);
  EXPECT_DOUBLE_EQ(fem::update_spring(spring, {}, 0.1, -0.3).elastic, -0.2) << "it is taut again after 0.2";
  spring.is_jacked = true, spring.prestress = 1;
  EXPECT_DOUBLE_EQ(fem::update_spring(spring, {.is_jacked = true}, 0, 5).force, 1);
  EXPECT_DOUBLE_EQ(fem::update_spring(spring, {}, 0.1, 0.1).force, 2) << "locked off";
}

TEST(Bars, BarInUniformStrainHasItsStrainTimesItsStiffness) {
  for (const double size : {1.0, 0.5}) {
    ElasticBlock block(size);
    constexpr double pull = 1e5;
    support::add_load<2>(block.model, support::find_sides_at<2>(block.mesh, 0, 8), {pull, 0});
    fem::Bar bar = make_nail({0.5, 1.3}, {7.5, 2.7});  // inclined, across the elements
    bar.axial_stiffness = 1e3;                         // does not disturb the block
    block.model.bars = {bar};
    const auto r = fem::find_equilibrium<2>(block.model, support::make_tight());
    ASSERT_TRUE(r.converged);
    const auto forces = fem::compute_bar_forces(block.model, r.at);
    const double cosine = 7 / std::hypot(7, 1.4), strain = pull / 1e8 * cosine * cosine;
    for (const double place : {2.0, 3.5, 5.0})
      EXPECT_NEAR(interpolate(forces[0].axial, place), 1e3 * strain, exact * 1e3 * strain) << size << " " << place;
  }
}

TEST(Bars, AnchoredEndsCarryTheBlockWithoutBond) {
  // The bar is parallel to the block between the fixed wall and a plate over the whole of the loaded side.
  ElasticBlock block(1);
  constexpr double pull = 1e5;
  support::add_load<2>(block.model, support::find_sides_at<2>(block.mesh, 0, 8), {pull, 0});
  fem::Bar bar = make_nail({8, 2}, {0, 2});
  bar.axial_stiffness = 2e8, bar.bond_stiffness = 0, bar.free_length = 8;
  bar.plate = bar.anchorage = 1e9;
  bar.plate_stiffness = bar.anchorage_stiffness = 1e14;
  bar.plate_line = {{8, 0}, {8, 4}};
  block.model.bars = {bar};
  const auto r = fem::find_equilibrium<2>(block.model, support::make_tight());
  ASSERT_TRUE(r.converged);
  const auto forces = fem::compute_bar_forces(block.model, r.at)[0];
  const double force = pull * 4 * 2e8 / (2e8 + 4 * 1e8);
  EXPECT_NEAR(forces.axial.value[0], force, exact * force);
  EXPECT_NEAR(forces.plate, force, exact * force);
  EXPECT_NEAR(forces.anchorage, force, exact * force);
  EXPECT_NEAR(r.largest_displacement, force / 2e8 * 8, exact * force / 2e8 * 8);
  EXPECT_NEAR(forces.energy, 0.5 * force * force * 8 / 2e8, exact * force * force * 8 / 4e8);
}

/// A nail of 3 m that is pulled out of a rigid block by `pull`.
struct PulledNail : ElasticBlock {
  explicit PulledNail(double size, double pull, double bond, double tensile) : ElasticBlock(size, 1e12) {
    fix();
    fem::Bar bar = make_nail({8, 2}, {5, 1.6});
    const double length = std::hypot(3, 0.4);
    bar.tensile = tensile;
    bar.bond = [bond](const Vec<2>&) { return bond; };
    bar.reduces_bond = true;
    bar.head_load = {pull * 3 / length, pull * 0.4 / length};
    model.bars = {bar};
  }
  double search() const {
    fem::ReductionOptions options;
    options.from = 1, options.to = 2, options.resolution = 5e-4;
    options.solid.threads = 1;
    return fem::reduce_strength<2>(model, options).factor;
  }
};

TEST(Bars, PullOutOfANailIsItsBondTimesItsLength) {
  const double capacity = 20e3 * std::hypot(3, 0.4);
  for (const double size : {1.0, 0.5}) {
    const PulledNail nail(size, capacity / 1.5, 20e3, fem::unlimited);
    EXPECT_NEAR(nail.search(), 1.5, exact * 1.5) << size;
  }
}

TEST(Bars, StrongBondLeavesTheTensileStrength) {
  const auto is_stable = [](double pull) {
    PulledNail nail(1, pull, 1e6, 50e3);
    nail.model.bars[0].free_length = 1;  // in which the force is that of the head
    return fem::find_equilibrium<2>(nail.model, {}).converged;
  };
  EXPECT_TRUE(is_stable((1 - exact) * 50e3));
  EXPECT_FALSE(is_stable((1 + exact) * 50e3));
}

TEST(Bars, ElasticPullOutDecaysWithTheHyperbolicCosine) {
  // E A w'' = k w: N(s) = P sinh((L - s)/λ)/sinh(L/λ), λ² = E A/k
  PulledNail nail(0.5, 10e3, 1e9, fem::unlimited);
  nail.model.bars[0].bond_stiffness = 1e7;
  const auto r = fem::find_equilibrium<2>(nail.model, support::make_tight());
  ASSERT_TRUE(r.converged);
  const auto forces = fem::compute_bar_forces(nail.model, r.at)[0];
  const double length = std::hypot(3, 0.4);
  for (std::size_t i = 0; i < forces.axial.place.size(); ++i)
    EXPECT_NEAR(forces.axial.value[i], 10e3 * std::sinh(length - forces.axial.place[i]) / std::sinh(length),
                exact * 10e3)
        << forces.axial.place[i];
  // Bond and force of the bar are in balance.
  double bond = 0;
  for (std::size_t i = 0; i + 1 < forces.bond.place.size(); ++i)
    bond += 0.5 * (forces.bond.value[i] + forces.bond.value[i + 1]) * (forces.bond.place[i + 1] - forces.bond.place[i]);
  EXPECT_NEAR(bond, 10e3, 0.05 * 10e3);
}

TEST(Bars, PrestressIsTheForceAfterTheLoads) {
  ElasticBlock block(0.5, 1e7);
  block.fix();
  fem::Bar bar = make_nail({8, 2}, {1, 2});
  bar.free_length = 4;
  bar.prestress = 30e3;
  bar.plate = 1e9, bar.plate_stiffness = 1e8;
  bar.plate_line = {{8, 1}, {8, 3}};
  block.model.bars = {bar};
  const auto loaded = fem::find_equilibrium<2>(block.model, support::make_tight());
  ASSERT_TRUE(loaded.converged);
  auto forces = fem::compute_bar_forces(block.model, loaded.at)[0];
  EXPECT_DOUBLE_EQ(forces.axial.value[0], 30e3);
  EXPECT_NEAR(forces.plate, 30e3, exact * 30e3);
  EXPECT_GT(loaded.largest_displacement, 1e-4) << "the block has been compressed";
  // A second step without change keeps it, and pressure on the plate relaxes it.
  const auto kept = fem::find_equilibrium<2>(block.model, support::make_tight(), 1, &loaded.at);
  EXPECT_NEAR(fem::compute_bar_forces(block.model, kept.at)[0].axial.value[0], 30e3, 1);
  support::add_load<2>(block.model, support::find_sides_at<2>(block.mesh, 0, 8), {-1e5, 0});
  const auto pressed = fem::find_equilibrium<2>(block.model, support::make_tight(), 1, &loaded.at);
  ASSERT_TRUE(pressed.converged);
  EXPECT_LT(fem::compute_bar_forces(block.model, pressed.at)[0].axial.value[0], 25e3);
}

/// A square block of soil, 2 m × 2 m without weight, under a pressure on its top; its right side is tied back by a bar
/// that yields at `tie`.
struct BoltedBlock : SolidSlope<2> {
  static constexpr double cohesion = 10e3, pressure = 30e3;
  BoltedBlock(double size, double friction, double tie)
      : SolidSlope<2>({{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, cohesion, friction, friction, 0, 1e7, 0.3, size}) {
    model.supports.clear();
    support::add_roller<2>(model, 0, 0);
    support::add_roller<2>(model, 1, 0);
    support::add_load<2>(model, support::find_sides_at<2>(mesh, 1, 2), {0, -pressure});
    fem::Bar bar = make_nail({2, 1}, {0, 1});
    bar.bond_stiffness = 0, bar.free_length = 2, bar.tensile = tie;
    bar.plate = bar.anchorage = 1e9;
    bar.plate_stiffness = bar.anchorage_stiffness = 1e9;
    bar.plate_line = {{2, 0}, {2, 2}};
    model.bars = {bar};
  }
  double search() const {
    fem::ReductionOptions options;
    options.from = 0.5, options.to = 1.5, options.resolution = 5e-4;
    return fem::reduce_strength<2>(model, options).factor;
  }
};

TEST(Bars, TieOfAClayBlockAddsItsForceToTheConfiningStress) {
  // q = 2 c/F + T/H
  for (const double size : {1.0, 0.5})
    for (const double tie : {4e3, 16e3}) {
      const double expected = 2 * BoltedBlock::cohesion / (BoltedBlock::pressure - tie / 2);
      EXPECT_NEAR(BoltedBlock(size, 0, tie).search(), expected, exact * expected) << size << " " << tie;
    }
}

TEST(Bars, TieOfABlockWithFrictionAddsKpTimesIt) {
  // q = K_p T/H + 2 c/F √K_p with tan φ/F
  const double tie = 8e3;
  double low = 0.2, high = 5;
  while (high - low > 1e-9) {
    const double f = 0.5 * (low + high), phi = std::atan(std::tan(25 * support::degree) / f),
                 k = std::pow(std::tan(std::acos(-1.0) / 4 + phi / 2), 2);
    (k * tie / 2 + 2 * BoltedBlock::cohesion / f * std::sqrt(k) > BoltedBlock::pressure ? low : high) = f;
  }
  for (const double size : {1.0, 0.5}) EXPECT_NEAR(BoltedBlock(size, 25, tie).search(), low, exact * low) << size;
}

/// A beam that stands out of a rigid block by 3 m, with a load across.
struct Cantilever : ElasticBlock {
  static constexpr double length = 3, bending = 4e6, shear = 5e8;
  explicit Cantilever(const Vec<2>& line_load, double moment = fem::unlimited) : ElasticBlock(1, 1e14) {
    fix();
    fem::Bar bar = make_nail({11, 2.2}, {3, 2.2});
    bar.axial_stiffness = 1e9, bar.compressive = fem::unlimited;
    bar.bending_stiffness = bending, bar.shear_stiffness = shear, bar.moment = moment;
    bar.bond_stiffness = bar.lateral_stiffness = 1e14;
    bar.line_load = line_load;
    model.bars = {bar};
  }
};

TEST(Bars, CantileverUnderALineLoadHasItsClosedForm) {
  constexpr double load = 2e3;
  const Cantilever beam({0, -load});
  const fem::SolidSystem<2> system(beam.model);
  const auto r = fem::find_equilibrium<2>(beam.model, support::make_tight());
  ASSERT_TRUE(r.converged);
  const auto forces = fem::compute_bar_forces(beam.model, r.at)[0];
  for (std::size_t i = 0; i < forces.moment.place.size(); ++i) {
    const double s = forces.moment.place[i];
    if (s > Cantilever::length) break;
    EXPECT_NEAR(std::abs(forces.moment.value[i]), load * s * s / 2, exact * load * 4.5) << s;
    EXPECT_NEAR(std::abs(forces.shear.value[i]), load * s, exact * load * 3) << s;
  }
}

TEST(Bars, CantileverUnderALineLoadHasTheDeflectionOfTimoshenko) {
  // q L⁴/(8 E I) + q L²/(2 κ G A), less the motion of the section where the beam enters the block
  constexpr double load = 2e3;
  const Cantilever beam({0, -load});
  const fem::SolidSystem<2> system(beam.model);
  const fem::SolidAssembly<2> assembly(system, {beam.model.make_law(0, 1)}, 1);
  std::vector<double> matrix, q = system.load;
  assembly.find_elastic_matrix(assembly.make_start(), matrix);
  sparse::SparseSolver<> solver(system.column_start, system.row, 1);
  ASSERT_TRUE(solver.factorise(matrix, sparse::Factors::ldlt) && solver.solve(q));
  EXPECT_EQ(solver.negative_pivots(), 0);
  const auto& springs = system.springs;
  const int head = system.unknowns - springs.unknowns;
  int root = -1;  // first unknown of the node after the springs in the air
  for (const fem::Spring& spring : springs.list)
    if (spring.kind == fem::SpringKind::axial && spring.place < Cantilever::length)
      root = std::max(root, spring.unknown.back());
  const double whole = 8, rotation = q[root + 2] / whole;
  const double deflection = q[head + 1] - (q[root + 1] - rotation * Cantilever::length);
  const double expected = load * std::pow(Cantilever::length, 4) / (8 * Cantilever::bending) +
                          load * std::pow(Cantilever::length, 2) / (2 * Cantilever::shear);
  EXPECT_NEAR(std::abs(deflection), expected, exact * expected);
}

TEST(Bars, CantileverFailsAtItsPlasticMoment) {
  const auto is_stable = [](double share) {
    const double moment = 10e3, load = share * 2 * moment / (Cantilever::length * Cantilever::length);
    const Cantilever beam({0, -load}, moment);
    return fem::find_equilibrium<2>(beam.model, {}).converged;
  };
  EXPECT_TRUE(is_stable(0.99));
  EXPECT_FALSE(is_stable(1.1));
}

TEST(Bars, TangentIsSymmetricAndThatOfDifferences) {
  BoltedBlock block(1, 25, 8e3);
  fem::Bar nail = make_nail({2, 1.7}, {0.4, 0.9}), pile = nail;
  nail.plate = 2e3, nail.plate_stiffness = 1e8, nail.tensile = 3e3;
  nail.bond = [](const Vec<2>& x) { return 1e3 * x[1]; };
  pile.head = {1, 2}, pile.end = {1.1, 0.3};
  pile.bending_stiffness = 1e6, pile.shear_stiffness = 1e7, pile.moment = 500, pile.shear = 800;
  pile.lateral_stiffness = 1e8, pile.compressive = 4e3, pile.tensile = 4e3;
  pile.lateral = [](const Vec<2>&) { return 5e3; };
  block.model.bars.push_back(nail);
  block.model.bars.push_back(pile);
  const fem::SolidSystem<2> system(block.model);
  const fem::SolidAssembly<2> assembly(system, {block.model.make_law(0, 1)}, 1);
  const auto start = assembly.make_start();
  std::mt19937 random(5);
  std::uniform_real_distribution<double> push(-3e-4, 3e-4);
  std::vector<double> q(static_cast<std::size_t>(system.unknowns));
  for (double& x : q) x = push(random);
  fem::SolidState<2> end;
  fem::SolidSums sums, more, less;
  assembly.evaluate(start, q, true, end, sums);
  EXPECT_TRUE(sums.symmetric);
  double largest = 0, yielding = 0, elastic = 0;
  for (const double x : sums.matrix) largest = std::max(largest, std::abs(x));
  for (std::size_t s = 0; s < end.bars.size(); ++s)
    (std::abs(end.bars[s] - start.bars[s]) * system.springs.list[s].stiffness >= system.springs.list[s].upper * 0.999
         ? yielding
         : elastic) += 1;
  EXPECT_GT(yielding, 5);
  EXPECT_GT(elastic, 5);
  const auto find_entry = [&](int i, int j) {
    for (int k = system.column_start[j]; k < system.column_start[j + 1]; ++k)
      if (system.row[k] == i) return sums.matrix[k];
    return 0.0;
  };
  const int soil = system.unknowns - system.springs.unknowns;
  for (int j = 0; j < system.unknowns; j += j < soil ? 7 : 1) {
    constexpr double step = 1e-10;
    auto near = q;
    near[j] += step;
    assembly.evaluate(start, near, false, end, more);
    near[j] -= 2 * step;
    assembly.evaluate(start, near, false, end, less);
    for (int i = 0; i < system.unknowns; ++i) {
      EXPECT_NEAR(find_entry(i, j), (more.force[i] - less.force[i]) / (2 * step), 1e-5 * largest) << i << " " << j;
      EXPECT_NEAR(find_entry(i, j), find_entry(j, i), 1e-9 * largest);
    }
  }
}

TEST(Bars, BarsWithoutContactAreRefused) {
  ElasticBlock block(2);
  fem::Bar bar = make_nail({9, 6}, {12, 6});
  block.model.bars = {bar};
  EXPECT_THROW(fem::SolidSystem<2>{block.model}, Error);
  bar.end = bar.head;
  block.model.bars = {bar};
  EXPECT_THROW(fem::SolidSystem<2>{block.model}, Error);
}

}  // namespace
}  // namespace talus
