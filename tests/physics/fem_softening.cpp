// SPDX-License-Identifier: MIT
// Strength reduction of soil that softens: closed forms of a shear column, and slopes between their factors with
// residual and with peak strength.

#include <gtest/gtest.h>

#include <cmath>

#include "support/solid_model.hpp"

namespace talus {
namespace {

using support::degree;

struct Blocks : material::YoungInput,
                material::PoissonInput,
                material::MohrCoulombStrength,
                material::ResidualStrength,
                material::SofteningRange {};

/// Soil that softens over plastic strains from 0 to `end`.
Blocks make_soil(const material::MohrCoulombStrength& peak, const material::ResidualStrength& residual, double end) {
  Blocks in;
  in.young_modulus = 1e7, in.poisson_ratio = 0.3;
  static_cast<material::MohrCoulombStrength&>(in) = peak;
  static_cast<material::ResidualStrength&>(in) = residual;
  static_cast<material::SofteningRange&>(in) = {0, end, material::LimitStrength::peak};
  return in;
}

/// Two layers of 1 m in simple shear between fixed plates, with a stiff layer between them that a horizontal body force
/// pulls along: both are sheared by the same displacement, and the sum of their shear stresses is `load` [Pa]. The
/// lower layer softens, the upper one has a third of its stiffness and is perfectly plastic.
struct ShearColumn {
  static constexpr double cohesion = 10e3, stiff = 0.2;
  mesh::Mesh<2> mesh;
  fem::SolidModel<2> model;

  ShearColumn(double load, double residual, double end) {
    mesh::Plan plan;
    plan.box_min = {0, 0};
    plan.box_max = {1, 2 + stiff};
    plan.size = 0.5;
    const auto add = [&](const char* name, double low, double high) {
      plan.polygons.push_back({name, {{0, low}, {1, low}, {1, high}, {0, high}}});
    };
    add("soft", 0, 1);
    add("stiff", 1, 1 + stiff);
    add("plastic", 1 + stiff, 2 + stiff);
    mesh = mesh::generate<2>(plan);
    model.mesh = &mesh;
    const Blocks in = make_soil({cohesion, 0, 0, 1e9}, {residual, 0}, end);
    model.make_law = [in, names = mesh.region_names](int region, double factor) -> material::Law {
      const std::string& name = names[static_cast<std::size_t>(region)];
      if (name == "soft") return material::SofteningMohrCoulomb::make(in, {factor, {}});
      if (name == "stiff") return material::LinearElastic::from_young(1e4 * in.young_modulus, 0.3);
      return material::MohrCoulomb(material::LinearElastic::from_young(in.young_modulus / 3, 0.3),
                                   material::MohrCoulombStrength{cohesion, 0, 0, 1e9}.reduced(factor));
    };
    for (const int region : mesh.element_region)
      model.unit_weight.push_back(mesh.region_names[static_cast<std::size_t>(region)] == "stiff" ? load / stiff : 0);
    model.direction = {1, 0};
    for (const double x : {0.0, 1.0}) {
      fem::Support<2> side;
      side.name = "side";
      side.sides = support::find_sides_at<2>(mesh, 0, x);
      side.fixed[1] = true;
      model.supports.push_back(side);
    }
    for (const double y : {0.0, 2 + stiff}) {
      fem::Support<2> plate;
      plate.name = "plate";
      plate.sides = support::find_sides_at<2>(mesh, 1, y);
      plate.fixed = {true, true};
      model.supports.push_back(plate);
    }
    model.softening_length = 2;  // the strain of the layer is uniform
  }
  ShearColumn(const ShearColumn&) = delete;

  fem::ReductionResult<2> reduce() const {
    fem::ReductionOptions options;
    options.from = 1.23, options.to = 1.86, options.resolution = 0.002;
    return fem::reduce_strength<2>(model, options);
  }
};

/// Both layers have c. The upper one yields at three times the strain of the lower one. There, with the strengths c/F,
/// the lower one has the plastic strain (3 - 0.7) c/(F G) and has fallen to 0.7 c/F, half the way to 0.4 c/F. The sum
/// 1.7 c/F is the largest load; with peak strength it is 2 c/F, with residual strength 1.4 c/F.
TEST(FemSoftening, ShearColumnFailsAfterItsWeakerLayerHasSoftened) {
  constexpr double factor = 1.5, c = ShearColumn::cohesion, shear = 1e7 / 2.6;
  const double end = 2 * 2.3 * c / (factor * shear) / std::sqrt(3.0);
  const ShearColumn column(1.7 * c / factor, 0.4 * c, end);
  const auto r = column.reduce();
  EXPECT_NEAR(r.factor, factor, 0.005 * factor);
  for (const auto& t : r.trials) EXPECT_TRUE(t.converged || t.flows) << t.factor;
}

/// The lower layer falls to 0.2 c at once when it yields, where the upper one has c/3: the load 4/3 c/F is the largest,
/// since c/F + 0.2 c/F is less.
TEST(FemSoftening, ShearColumnOfBrittleSoilFailsAtItsFirstYield) {
  constexpr double factor = 1.5, c = ShearColumn::cohesion;
  const ShearColumn column(4.0 / 3 * c / factor, 0.2 * c, 1e-5);
  const auto r = column.reduce();
  EXPECT_NEAR(r.factor, factor, 0.005 * factor);
  for (const auto& t : r.trials) EXPECT_TRUE(t.converged || t.flows) << t.factor;
}

/// Slopes whose soil softens from the strength of the section to a residual one.
struct SofteningSlope {
  support::SoilSection section;
  material::ResidualStrength residual;
  double end;  ///< plastic strain at which the strength is residual [-]

  enum class Strength { softening, peak, residual };
  fem::ReductionResult<2> reduce(Strength strength, double length) const {
    support::SolidSlope<2> slope(section);
    Blocks in = make_soil(support::find_strength(section), residual, end);
    in.tensile_strength = 0;
    slope.model.make_law = [=](int, double factor) -> material::Law {
      const auto law = material::SofteningMohrCoulomb::make(in, {factor, {}});
      if (strength == Strength::softening) return law;
      return law.make_frozen(strength == Strength::peak ? 0 : 1);
    };
    slope.model.softening_length = length;
    fem::ReductionOptions options;
    options.resolution = 0.01;
    return fem::reduce_strength<2>(slope.model, options);
  }
};

SofteningSlope make_stiff_clay(double size) {
  return {{{{0, 0}, {14, 0}, {14, 2}, {11, 2}, {4, 6}, {0, 6}}, 8e3, 25, 0, 18e3, 1e7, 0.3, size},
          {2e3, 15 * degree},
          0.02};
}
SofteningSlope make_sensitive_clay(double size) {
  return {{{{0, 0}, {14, 0}, {14, 2}, {10, 2}, {6, 6}, {0, 6}}, 25e3, 0, 0, 18e3, 1e7, 0.45, size}, {10e3, 0}, 0.02};
}

TEST(FemSoftening, FactorLiesBetweenThoseOfResidualAndPeakStrength) {
  using Strength = SofteningSlope::Strength;
  for (const SofteningSlope& slope : {make_stiff_clay(0.8), make_sensitive_clay(0.8)}) {
    const auto falling = slope.reduce(Strength::softening, 1.6), peak = slope.reduce(Strength::peak, 0),
               residual = slope.reduce(Strength::residual, 0);
    EXPECT_GT(falling.stable, residual.failed);
    EXPECT_LT(falling.failed, peak.stable);
  }
}

TEST(FemSoftening, FactorDoesNotDependOnTheMeshWithANonlocalLength) {
  using Strength = SofteningSlope::Strength;
  const auto search = [](double size, double length) {
    return make_stiff_clay(size).reduce(Strength::softening, length).factor;
  };
  const double coarse = search(0.8, 1.6), fine = search(0.4, 1.6), own_coarse = search(1.6, 0),
               own_fine = search(0.8, 0);
  EXPECT_NEAR(coarse, fine, 0.02 * fine);
  EXPECT_GT(own_coarse - own_fine, 2 * std::abs(coarse - fine));
}

}  // namespace
}  // namespace talus
