// SPDX-License-Identifier: MIT
// Tangents of curved strength envelopes against their definition and finite differences.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "material/curved_envelopes.hpp"
#include "material/hoek_brown.hpp"
#include "material/shansep.hpp"

namespace talus::material {
namespace {

double find_strength(const StrengthLaw& law, double normal) {
  const StrengthTangent t = law.find_tangent({.normal = normal});
  return t.cohesion + normal * t.tan_friction;
}

void expect_tangents(const StrengthLaw& law, double from, double to) {
  double last = 1e300;
  for (int i = 0; i <= 40; ++i) {
    const double normal = from + (to - from) * i / 40, step = 1e-4 * (to - from);
    const double slope = (find_strength(law, normal + step) - find_strength(law, normal - step)) / (2 * step);
    const double found = law.find_tangent({.normal = normal}).tan_friction;
    EXPECT_NEAR(found, slope, 1e-4 * slope) << normal;
    EXPECT_LT(found, last * (1 + 1e-12)) << "an envelope is concave";
    last = found;
  }
}

struct Blocks : YoungInput, PoissonInput, HoekBrownInput, PowerCurveInput, JointInput, FlowRatio {};

TEST(StrengthEnvelopes, TangentsAreDerivatives) {
  Blocks in;
  static_cast<HoekBrownInput&>(in) = {30e6, 5, 2, 0};
  static_cast<PowerCurveInput&>(in) = {2, 0.7, 500, 1000};
  static_cast<JointInput&>(in) = {8, 50e6, 0.49};
  expect_tangents(HoekBrown::make_strength(in), 1e3, 4e5);
  expect_tangents(PowerCurve::make_strength(in), 1e3, 4e5);
  expect_tangents(BartonBandis::make_strength(in), 5e4, 4e6);
}

TEST(StrengthEnvelopes, HoekBrownParametersAreThoseOfTheEdition2002) {
  const HoekBrownMass soft = make_rock_mass({30e6, 5, 2, 0}), blasted = make_rock_mass({30e6, 45, 10, 0.9});
  EXPECT_NEAR(soft.m, 0.067225, 1e-6);
  EXPECT_NEAR(soft.s, 2.6e-5, 1e-6);
  EXPECT_NEAR(soft.a, 0.61921, 1e-5);
  EXPECT_NEAR(blasted.m, 0.281157, 1e-6);
  EXPECT_NEAR(blasted.s, 1.62e-4, 1e-6);
  EXPECT_NEAR(blasted.a, 0.508086, 1e-6);
}

TEST(StrengthEnvelopes, HoekBrownEnvelopeTouchesEveryCircle) {
  const HoekBrownMass rock = make_rock_mass({30e6, 45, 10, 0.9});
  for (const double minor : {-0.5 * rock.tensile_strength(), 0.0, 2e5, 3e6}) {
    const double major = rock.find_major(minor), centre = 0.5 * (major + minor), radius = 0.5 * (major - minor);
    const double sine = (rock.find_ratio(minor) - 1) / (rock.find_ratio(minor) + 1);
    const double normal = centre - radius * sine, shear = radius * std::sqrt(1 - sine * sine);
    const StrengthTangent t = rock.find_tangent(normal);
    EXPECT_NEAR(t.cohesion + normal * t.tan_friction, shear, 1e-9 * shear);
    EXPECT_NEAR(t.tan_friction, sine / std::sqrt(1 - sine * sine), 1e-8);
  }
}

/// Strain increments that load a point from an isotropic stress beyond its strength, in many directions.
std::vector<std::array<double, 6>> make_increments() {
  std::vector<std::array<double, 6>> list;
  for (int i = 0; i < 200; ++i) {
    auto random = [&, k = 0]() mutable { return std::sin(12.9898 * (i + 1) + 78.233 * ++k) * 0.01; };
    list.push_back({random() - 0.004, random() - 0.004, random() - 0.004, random(), random(), random()});
  }
  return list;
}

TEST(CurvedLaw, StressesLieOnTheCriterionOfHoekAndBrown) {
  const HoekBrownMass rock = make_rock_mass({30e6, 5, 2, 0});
  const LinearElastic elastic = LinearElastic::from_young(5e7, 0.3);
  const CosineThird cosine;
  for (const double ratio : {0.0, 1.0}) {
    const CurvedLaw law(elastic, rock, ratio, 1);
    int yields = 0;
    for (const auto& strain : make_increments()) {
      double sigma[6] = {-1e5, -1e5, -1e5, 0, 0, 0}, state[2] = {};
      if (!law.update<6, double>(sigma, strain.data(), state, true).any_plastic) continue;
      ++yields;
      const SpacePrincipal<double> p(sigma, cosine);
      EXPECT_LE(p.s1, rock.tensile_strength() * (1 + 1e-6));
      if (p.s1 < 0.99 * rock.tensile_strength()) {
        EXPECT_NEAR(-p.s3, rock.find_major(-p.s1), 1e-5 * std::abs(p.s3));
      }
    }
    EXPECT_GT(yields, 50);
  }
}

TEST(CurvedLaw, StraightPairsAreMohrCoulomb) {
  const LinearElastic elastic = LinearElastic::from_young(3e7, 0.3);
  const double phi = 0.5, tangent = std::tan(phi);
  for (const double factor : {1.0, 1.4}) {
    const CurvedLaw law(elastic, StrengthPairs{{0, 1e5, 4e5}, {8e3, 8e3 + 1e5 * tangent, 8e3 + 4e5 * tangent}}, 0,
                        factor);
    const MohrCoulomb expected(elastic, MohrCoulombStrength{8e3, phi, 0, 0}.reduced(factor));
    for (const auto& strain : make_increments()) {
      double a[4] = {-5e4, -8e4, -5e4, 0}, b[4] = {-5e4, -8e4, -5e4, 0}, own[2] = {}, other[2] = {};
      law.update<4, double>(a, strain.data(), own, true);
      expected.update<4, double>(b, strain.data(), other, true);
      for (int i = 0; i < 4; ++i) EXPECT_NEAR(a[i], b[i], 1e-3);
      EXPECT_NEAR(own[0], other[0], 1e-10);
    }
  }
}

TEST(StrengthEnvelopes, ShansepFollowsItsFormula) {
  const StrengthProfile none;
  for (const auto& [ocr, ratio] : {std::pair{1.0, 0.22}, {2.0, 0.38304}, {4.0, 0.66692}})
    EXPECT_NEAR(compute_shansep_strength({0.22, 0.8, 0, ocr, {}, {}}, none, 1e5, {}, 0), 1e5 * ratio, 1e5 * 1e-5);
  EXPECT_NEAR(compute_shansep_strength({0.25, 0.85, 0, 3.0, {}, {}}, none, 1e5, {}, 0), 63605, 1);
}

}  // namespace
}  // namespace talus::material
