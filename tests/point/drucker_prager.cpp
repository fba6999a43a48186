// SPDX-License-Identifier: MIT
// The cone of Drucker and Prager at a point: its match to Mohr–Coulomb, the return, and the work of a step.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "material/drucker_prager.hpp"
#include "support/draw.hpp"
#include "support/soil_point.hpp"

namespace talus {
namespace {

using material::ConeMatch;
using material::DruckerPrager;
using material::DruckerPragerCone;
using support::Voigt;

constexpr double degree = std::numbers::pi / 180;
constexpr std::array matches{ConeMatch::plane_strain, ConeMatch::compression, ConeMatch::extension,
                             ConeMatch::inscribed};

struct Point {
  double mean = 0, root_j2 = 0;
};
template <int NS>
Point find_point(const Voigt<NS>& s) {
  const double p = (s[0] + s[1] + s[2]) / 3;
  double j2 = 0;
  for (std::size_t i = 0; i < NS; ++i) j2 += i < 3 ? 0.5 * (s[i] - p) * (s[i] - p) : s[i] * s[i];
  return {p, std::sqrt(j2)};
}

DruckerPrager make_law(const material::MohrCoulombStrength& strength, ConeMatch match) {
  return {material::LinearElastic::from_young(20e6, 0.3), strength, match};
}

TEST(DruckerPrager, FailsInPlaneStrainWithTheMatchedStrength) {
  for (const double psi : {0.0, 10 * degree, 30 * degree}) {
    const material::MohrCoulombStrength strength{10e3, 30 * degree, psi, 0};
    const DruckerPrager law = make_law(strength, ConeMatch::plane_strain);
    // At failure the volume grows by sin ψ of the shear, so that the stress no longer changes.
    const double growth = 0.5 * std::sin(psi) * std::hypot(2e-5, 0.5e-5);
    Voigt<4> stress{-200e3, -200e3, -200e3, 0}, d{1e-5 + growth, -1e-5 + growth, 0, 0.5e-5};
    std::array<double, 2> state{};
    for (int i = 0; i < 20000; ++i) law.update<4>(stress.data(), d.data(), state.data(), true);
    const double radius = std::hypot(0.5 * (stress[0] - stress[1]), stress[3]), mean = 0.5 * (stress[0] + stress[1]);
    EXPECT_NEAR(radius, 10e3 * std::cos(30 * degree) - mean * std::sin(30 * degree), 1e-6 * radius) << psi;
  }
}

TEST(DruckerPrager, FailsInTriaxialCompressionAndExtensionWhereItIsMatched) {
  const double c = 10e3, phi = 30 * degree, k = (1 + std::sin(phi)) / (1 - std::sin(phi));
  for (const bool compression : {true, false}) {
    const DruckerPragerCone cone =
        DruckerPragerCone::match(compression ? ConeMatch::compression : ConeMatch::extension, phi, 0);
    const double minor = -50e3, major = k * minor - 2 * c * std::sqrt(k);  // σ3 is the larger compression
    const Voigt<6> s = compression ? Voigt<6>{minor, major, minor, 0, 0, 0} : Voigt<6>{major, minor, major, 0, 0, 0};
    const Point at = find_point<6>(s);
    EXPECT_NEAR(at.root_j2 + cone.slope * at.mean, cone.offset * c, 1e-9 * at.root_j2);
  }
}

TEST(DruckerPrager, LiesInsideThePyramidWhereItIsInscribed) {
  support::Draw draw(5);
  const double c = 10e3, phi = 30 * degree, k = (1 + std::sin(phi)) / (1 - std::sin(phi));
  const DruckerPragerCone cone = DruckerPragerCone::match(ConeMatch::inscribed, phi, 0);
  double nearest = 1e300;
  for (int n = 0; n < 20000; ++n) {
    const double p = -draw(0, 100e3), lode = draw(0, std::numbers::pi / 3), root = cone.offset * c - cone.slope * p,
                 r = 2 / std::sqrt(3.0) * root;
    const double s1 = p + r * std::cos(lode), s3 = p + r * std::cos(lode + 2 * std::numbers::pi / 3);
    nearest = std::min(nearest, (2 * c * std::sqrt(k) - (k * s1 - s3)) / root);
  }
  EXPECT_GT(nearest, -1e-9);
  EXPECT_LT(nearest, 1e-3) << "it must touch the pyramid";
}

template <int NS>
void expect_a_return(unsigned seed) {
  support::Draw draw(seed);
  int cone_returns = 0, tensile_returns = 0;
  for (int n = 0; n < 3000; ++n) {
    const double c = draw(0, 20e3), phi = draw(5, 40) * degree, apex = c / std::tan(phi);
    const material::MohrCoulombStrength strength{c, phi, draw(0, 1) * phi, draw(0, 1) < 0.5 ? 0 : draw(0, 1) * apex};
    const ConeMatch match = matches[static_cast<std::size_t>(n) % matches.size()];
    const DruckerPragerCone cone = DruckerPragerCone::match(match, phi, strength.dilatancy_angle);
    const DruckerPrager law = make_law(strength, match);
    Voigt<NS> old{}, d{};
    for (std::size_t i = 0; i < NS; ++i) old[i] = draw(-5e3, 5e3), d[i] = draw(-4e-3, 4e-3);
    for (std::size_t i = 0; i < 3; ++i) old[i] -= draw(0, 60e3);
    if constexpr (NS == 4) d[2] = 0;
    std::array<double, 2> state{};
    Voigt<NS> start = old;
    const Voigt<NS> none{};
    law.update<NS>(start.data(), none.data(), state.data(), true);  // from a stress within the strength
    state = {};
    Voigt<NS> s = start;
    const auto response = law.update<NS>(s.data(), d.data(), state.data(), true);
    const Point at = find_point<NS>(s);
    const double scale = at.root_j2 + std::abs(at.mean) + c + 1e3;
    EXPECT_LT(at.root_j2 + cone.slope * at.mean - cone.offset * c, 1e-9 * scale);
    EXPECT_LT(at.mean - strength.tensile_strength, 1e-9 * scale);
    if (!response.any_plastic) continue;
    (at.mean > strength.tensile_strength - 1e-6 * scale ? tensile_returns : cone_returns) += 1;
    // Balance of the step: ½(σ_old + σ):Δε is the change of elastic energy and the dissipation.
    double work = 0;
    for (std::size_t i = 0; i < NS; ++i) work += 0.5 * (start[i] + s[i]) * d[i];
    const double stored = law.elastic_energy<NS>(s.data()) - law.elastic_energy<NS>(start.data());
    EXPECT_NEAR(stored + response.dissipation, work, 1e-9 * (std::abs(work) + scale * 1e-3));
    // A second update without strain changes nothing.
    Voigt<NS> again = s;
    law.update<NS>(again.data(), none.data(), state.data(), true);
    for (std::size_t i = 0; i < NS; ++i) EXPECT_NEAR(again[i], s[i], 1e-9 * scale);
  }
  EXPECT_GT(cone_returns, 300);
  EXPECT_GT(tensile_returns, 300);
}

TEST(DruckerPrager, ReturnsToTheConeAndClosesTheWorkOfAStep) {
  expect_a_return<4>(1);
  expect_a_return<6>(2);
}

TEST(DruckerPrager, LanesAreSinglePoints) {
  support::Draw draw(3);
  const DruckerPrager law = make_law({5e3, 25 * degree, 5 * degree, 1e3}, ConeMatch::compression);
  for (int n = 0; n < 200; ++n) {
    Pack s[6], d[6], q[2]{Pack(0.0), Pack(0.0)};
    double s1[lane_width][6], d1[lane_width][6];
    for (int i = 0; i < 6; ++i)
      for (int l = 0; l < lane_width; ++l) {
        s1[l][i] = draw(-5e3, 5e3) - (i < 3 ? 20e3 : 0), d1[l][i] = draw(-4e-3, 4e-3);
        s[i].value[l] = s1[l][i], d[i].value[l] = d1[l][i];
      }
    const auto lanes = law.update<6, Pack>(s, d, q, MaskOf<Pack>(true));
    for (int l = 0; l < lane_width; ++l) {
      double state[2]{};
      const auto one = law.update<6>(s1[l], d1[l], state, true);
      for (int i = 0; i < 6; ++i) EXPECT_NEAR(s[i][l], s1[l][i], 1e-9 * 20e3);
      EXPECT_NEAR(lanes.dissipation[l], one.dissipation, 1e-9 * (1 + std::abs(one.dissipation)));
      EXPECT_NEAR(q[0][l], state[0], 1e-12);
    }
  }
}

}  // namespace
}  // namespace talus
