// SPDX-License-Identifier: MIT
// Soil with bedding planes at a point: Jaeger's strength of a specimen by the angle of its planes, and the return.

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "material/directed_strength.hpp"
#include "support/draw.hpp"
#include "support/soil_point.hpp"

namespace talus {
namespace {

using support::Voigt;
constexpr double degree = std::numbers::pi / 180;
constexpr double cohesion = 60e3, friction = 35 * degree, plane_cohesion = 15e3, plane_friction = 20 * degree;

struct Blocks : material::YoungInput, material::PoissonInput, material::MohrCoulombStrength, material::BeddingInput {};

material::Bedding make_rock(double angle, double dilatancy = 0, double tension = 0) {
  Blocks in;
  in.young_modulus = 200e6, in.poisson_ratio = 0.25;
  static_cast<material::MohrCoulombStrength&>(in) = {cohesion, friction, 0.5 * dilatancy, tension};
  in.bedding_angle = angle, in.bedding_cohesion = plane_cohesion, in.bedding_friction = plane_friction;
  in.bedding_dilatancy = dilatancy;
  return material::Bedding::make(in, {});
}

/// Compresses a specimen along y in plane strain under a constant stress along x, free to shear, and returns the
/// largest compressive stress along y [Pa].
double compress(const material::Bedding& law, double cell) {
  Voigt<4> stress{-cell, -cell, -cell, 0};
  std::array<double, 2> state{};
  double largest = 0;
  for (int n = 0; n < 1500; ++n) {
    // Strains along x and in shear with which σ_x is the cell pressure and τ_xy zero, by Newton's method.
    Voigt<4> d{0.25e-5, -1e-5, 0, 0}, end{};
    std::array<double, 2> end_state{};
    const auto evaluate = [&](const Voigt<4>& strain) {
      end = stress, end_state = state;
      law.update<4>(end.data(), strain.data(), end_state.data(), true);
      return std::array{end[0] + cell, end[3]};
    };
    for (int i = 0; i < 100; ++i) {
      const auto f = evaluate(d);
      if (std::abs(f[0]) + std::abs(f[1]) < 1e-6 * cell) break;
      const double step = 1e-9;
      Voigt<4> at_x = d, at_s = d;
      at_x[0] += step, at_s[3] += step;
      const auto fx = evaluate(at_x), fs = evaluate(at_s);
      const double a = (fx[0] - f[0]) / step, b = (fs[0] - f[0]) / step, c = (fx[1] - f[1]) / step,
                   e = (fs[1] - f[1]) / step, det = a * e - b * c;
      if (!(std::abs(det) > 1e-9 * 200e6 * 200e6)) break;  // it slides: no further stress
      d[0] -= (e * f[0] - b * f[1]) / det, d[3] -= (a * f[1] - c * f[0]) / det;
    }
    evaluate(d);
    if (std::abs(end[0] + cell) > 1e-3 * cell || std::abs(end[3]) > 1e-3 * cell) break;
    stress = end, state = end_state;
    largest = std::max(largest, -stress[1]);
  }
  return largest;
}

TEST(Bedding, SpecimensHaveJaegersStrength) {
  // Jaeger (1960): σ1 = σ3 + 2 (c + σ3 tan φ)/((1 - tan φ/tan β) sin 2β) by slip along planes at β to the minor stress,
  // where that is less than the strength of the rock itself.
  constexpr double cell = 50e3;
  const double k = (1 + std::sin(friction)) / (1 - std::sin(friction)), rock = k * cell + 2 * cohesion * std::sqrt(k);
  int sliding = 0;
  for (const double beta : {0.0, 10.0, 30.0, 45.0, 55.0, 65.0, 75.0, 90.0}) {
    const double b = beta * degree, t = std::tan(plane_friction);
    double strength = rock;
    if (beta > 0 && beta < 90 && std::tan(b) > t)
      strength = std::min(rock, cell + 2 * (plane_cohesion + cell * t) / ((1 - t / std::tan(b)) * std::sin(2 * b)));
    sliding += strength < rock;
    EXPECT_NEAR(compress(make_rock(b), cell), strength, 5e-3 * strength) << beta;
    EXPECT_NEAR(compress(make_rock(-b), cell), strength, 5e-3 * strength) << -beta;
  }
  EXPECT_EQ(sliding, 5);
}

template <int NS>
void expect_a_return(unsigned seed) {
  support::Draw draw(seed);
  int plastic = 0;
  for (int n = 0; n < 2000; ++n) {
    const double angle = draw(-90, 90) * degree, s = std::sin(angle), c = std::cos(angle);
    const material::Bedding law = make_rock(angle, draw(0, 1) * plane_friction, n % 2 == 0 ? 0 : 10e3);
    Voigt<NS> start{}, d{};
    for (std::size_t i = 0; i < NS; ++i) d[i] = draw(-2e-3, 2e-3);
    for (std::size_t i = 0; i < 3; ++i) start[i] = -draw(30e3, 60e3);
    if constexpr (NS == 4) d[2] = 0;
    std::array<double, 2> state{};
    Voigt<NS> end = start;
    const auto response = law.update<NS>(end.data(), d.data(), state.data(), true);
    const double normal = s * s * end[0] + c * c * end[1] - 2 * s * c * end[3],
                 along = s * c * (end[1] - end[0]) + (c * c - s * s) * end[3],
                 across = NS == 6 ? c * end[4] - s * end[5] : 0;
    double scale = cohesion;
    for (const double x : end) scale = std::max(scale, std::abs(x));
    EXPECT_LT(std::hypot(along, across) + normal * std::tan(plane_friction) - plane_cohesion, 1e-6 * scale);
    const reference::Tensor tensor = support::to_tensor<NS>(end);
    const Eigen::Vector3d principal = Eigen::SelfAdjointEigenSolver<reference::Tensor>(tensor).eigenvalues();
    const double k = (1 + std::sin(friction)) / (1 - std::sin(friction));
    EXPECT_LT(k * principal[2] - principal[0] - 2 * cohesion * std::sqrt(k), 1e-6 * scale);
    if (!response.any_plastic) continue;
    ++plastic;
    // Balance of the step: ½(σ_old + σ):Δε is the change of elastic energy and the dissipation.
    double work = 0;
    for (std::size_t i = 0; i < NS; ++i) work += 0.5 * (start[i] + end[i]) * d[i];
    const double stored = law.elastic_energy<NS>(end.data()) - law.elastic_energy<NS>(start.data());
    EXPECT_NEAR(stored + response.dissipation, work, 1e-6 * (std::abs(work) + 1e-3 * scale));
  }
  EXPECT_GT(plastic, 1000);
}

TEST(Bedding, ReturnsToBothSurfaces) {
  expect_a_return<4>(1);
  expect_a_return<6>(2);
}

TEST(Bedding, WithStrongPlanesIsMohrCoulomb) {
  Blocks in;
  in.young_modulus = 200e6, in.poisson_ratio = 0.25;
  static_cast<material::MohrCoulombStrength&>(in) = {cohesion, friction, 0, 5e3};
  in.bedding_angle = 0.3, in.bedding_cohesion = 1e9, in.bedding_friction = friction;
  in.tensile_strength = 5e3;
  const material::Bedding law = material::Bedding::make(in, {});
  const material::MohrCoulomb plain(material::LinearElastic::from_young(200e6, 0.25), in);
  support::Draw draw(4);
  int plastic = 0;
  for (int n = 0; n < 500; ++n) {
    Voigt<4> a{-50e3, -60e3, -40e3, 5e3}, d{draw(-1e-3, 1e-3), draw(-1e-3, 1e-3), 0, draw(-1e-3, 1e-3)};
    Voigt<4> b = a;
    std::array<double, 2> p{}, q{};
    const auto one = law.update<4>(a.data(), d.data(), p.data(), true),
               other = plain.update<4>(b.data(), d.data(), q.data(), true);
    plastic += other.any_plastic;
    for (std::size_t i = 0; i < 4; ++i) ASSERT_NEAR(a[i], b[i], 1e-6);
    ASSERT_NEAR(one.dissipation, other.dissipation, 1e-6);
  }
  EXPECT_GT(plastic, 100);
}

}  // namespace
}  // namespace talus
