// SPDX-License-Identifier: MIT
// Consistent tangents by dual numbers against central differences of the update, in random states of every law:
// elastic, on planes, edges, the apex and the tension cut-off, on the ellipse of Cam-clay, with roots.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "base/dual.hpp"
#include "fem/solid/system.hpp"
#include "material/every_law.hpp"
#include "support/external_model.hpp"

namespace talus::fem {
namespace {

using material::Law;

/// The state that a point starts from.
struct Start {
  std::array<double, 6> stress{};
  std::array<double, material::max_state_size> state{};
};

template <int NS>
std::array<double, 6> run(const Law& law, const Start& start, const std::array<double, 6>& strain, double saturation) {
  Start s = start;
  update_point<NS>(law, saturation, strain.data(), s.stress.data(), s.state.data(), nullptr);
  return s.stress;
}

/// Largest difference between the tangent and central differences, over the modulus; negative where the two differences
/// of different steps disagree, which means a corner lies between them.
template <int NS>
double find_error(const Law& law, double modulus, const Start& start, const std::array<double, 6>& strain,
                  double saturation, bool& yields) {
  std::array<double, NS * NS> c{}, fine{}, coarse{};
  Start s = start;
  yields = update_point<NS>(law, saturation, strain.data(), s.stress.data(), s.state.data(), c.data()).yields;
  double size = 0;
  for (double e : strain) size = std::max(size, std::abs(e));
  for (std::size_t j = 0; j < NS; ++j)
    for (const double fraction : {1e-5, 4e-5}) {
      auto up = strain, down = strain;
      up[j] += fraction * size;
      down[j] -= fraction * size;
      const auto a = run<NS>(law, start, up, saturation), b = run<NS>(law, start, down, saturation);
      for (std::size_t i = 0; i < NS; ++i)
        (fraction < 2e-5 ? fine : coarse)[i * NS + j] = (a[i] - b[i]) / (2 * fraction * size);
    }
  double error = 0, corner = 0;
  for (std::size_t k = 0; k < NS * NS; ++k) {
    error = std::max(error, std::abs(c[k] - fine[k]) / modulus);
    corner = std::max(corner, std::abs(coarse[k] - fine[k]) / modulus);
  }
  return corner > 1e-5 ? -error : error;
}

/// Tries many states; `make` gives the start from a random engine, stresses of the size `pressure`.
template <int NS, class Make>
void check(const Law& law, double modulus, double pressure, double tolerance, Make&& make, double least_yielding) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  int yielding = 0, corners = 0;
  constexpr int tries = 3000;
  for (int t = 0; t < tries; ++t) {
    const Start start = make(random);
    std::array<double, 6> strain{};
    const double size = std::pow(10.0, -1.5 + 2 * std::generate_canonical<double, 20>(random)) * pressure / modulus;
    for (std::size_t i = 0; i < NS; ++i) strain[i] = size * normal(random);
    bool yields = false;
    const double error = find_error<NS>(law, modulus, start, strain, t % 2 ? 1.0 : 0.8, yields);
    yielding += yields;
    corners += error < 0;
    if (error > 0) {
      ASSERT_LT(error, tolerance) << "try " << t;
    }
  }
  EXPECT_GT(yielding, least_yielding * tries);
  EXPECT_LT(corners, 0.05 * tries);  // differences across a corner prove nothing and must be rare
}

Start make_start(std::mt19937& random, int components, double pressure) {
  std::normal_distribution<double> normal;
  Start s;
  for (std::size_t i = 0; i < static_cast<std::size_t>(components); ++i)
    s.stress[i] = pressure * ((i < 3 ? -1.0 : 0.0) + 0.4 * normal(random));
  return s;
}

const material::LinearElastic elastic = material::LinearElastic::from_young(30e6, 0.3);

TEST(SolidTangent, MohrCoulombOnPlanesEdgesApexAndCutOff) {
  const double deg = std::acos(-1.0) / 180;
  for (const auto& [c, phi, psi, tension] :
       {std::array{2e3, 30.0, 0.0, 1e9}, std::array{2e3, 30.0, 30.0, 1e9}, std::array{20e3, 20.0, 5.0, 5e3},
        std::array{30e3, 0.0, 0.0, 10e3}, std::array{5e3, 40.0, 10.0, 0.0}}) {
    const material::MohrCoulomb law(elastic, {c, phi * deg, psi * deg, tension});
    SCOPED_TRACE(phi);
    check<4>(
        law, 30e6, 50e3, 1e-5, [](auto& r) { return make_start(r, 4, 50e3); }, 0.3);
    check<6>(
        law, 30e6, 50e3, 1e-4, [](auto& r) { return make_start(r, 6, 50e3); }, 0.3);
    check<4>(
        law, 30e6, 50e3, 1e-5, [](auto& r) { return make_start(r, 4, -10e3); }, 0.3);  // pulled apart
    check<6>(
        law, 30e6, 50e3, 1e-4, [](auto& r) { return make_start(r, 6, -10e3); }, 0.3);
  }
}

TEST(SolidTangent, MohrCoulombWithEqualPrincipalStresses) {
  // Axial symmetry, where the spectral form divides by differences of principal stresses: the tangent must be right for
  // strains that keep the symmetry, and finite for all.
  const double deg = std::acos(-1.0) / 180;
  const material::MohrCoulomb law(elastic, {5e3, 30 * deg, 10 * deg, 1e9});
  for (const double skew : {0.0, 1e-14, 1e-10, 1e-8, 1e-6}) {
    Start start;
    start.stress = {-50e3, -50e3 * (1 + skew), -50e3, 0, 0, 0};
    const std::array<double, 6> strain{-1e-2, 3e-3, 3e-3, 0, 0, 0};
    std::array<double, 36> c{};
    Start s = start;
    ASSERT_TRUE(update_point<6>(law, 1, strain.data(), s.stress.data(), s.state.data(), c.data()).yields);
    const auto far = [&](double sign) {
      auto e = strain;
      for (double& x : e) x *= 1 + sign * 1e-4;
      return run<6>(law, start, e, 1);
    };
    const auto a = far(1), b = far(-1);
    for (std::size_t i = 0; i < 6; ++i) {
      double along = 0;
      for (std::size_t j = 0; j < 6; ++j) {
        EXPECT_LT(std::abs(c[i * 6 + j]), 3 * (elastic.lambda + 2 * elastic.mu)) << skew << " " << i << " " << j;
        along += c[i * 6 + j] * strain[j];
      }
      EXPECT_NEAR(along, (a[i] - b[i]) / 2e-4, 1e-3 * 1e-2 * 30e6) << skew << " " << i;
    }
  }
}

TEST(SolidTangent, RootedMohrCoulomb) {
  const double deg = std::acos(-1.0) / 180;
  const material::RootedMohrCoulomb law(elastic, {2e3, 30 * deg, 0, 1e9}, 1.3);
  const auto make = [](auto& r) {
    auto s = make_start(r, 6, 30e3);
    s.state[1] = 8e3;
    return s;
  };
  check<4>(law, 30e6, 30e3, 1e-5, make, 0.3);
  check<6>(law, 30e6, 30e3, 1e-4, make, 0.3);
}

TEST(SolidTangent, CamClayBareAndRooted) {
  material::CamClayParameters p;
  p.compression = 0.1, p.swelling = 0.01, p.poisson_ratio = 0.3, p.critical_state_slope = 1.1, p.suction_hardening = 2;
  const material::ModifiedCamClay bare(p);
  material::RootParameters roots;
  roots.hardening = 0.5, roots.strength = 0.2, roots.breaking_strain = 0.02, roots.breaking_range = 0.05;
  const material::RootedCamClay rooted(p, roots);
  const auto make = [](const auto& law) {
    return [&law](std::mt19937& r) {
      auto s = make_start(r, 6, 60e3);
      law.set_initial_state(s.stress.data(), 0.8, 0.6, 90e3 * (0.5 + std::generate_canonical<double, 20>(r)), 0.9,
                            s.state.data());
      return s;
    };
  };
  check<4>(bare, 20e6, 60e3, 1e-4, make(bare), 0.2);
  check<6>(bare, 20e6, 60e3, 1e-4, make(bare), 0.2);
  check<4>(rooted, 20e6, 60e3, 1e-4, make(rooted), 0.2);
  check<6>(rooted, 20e6, 60e3, 1e-4, make(rooted), 0.2);
}

TEST(SolidTangent, ExternalModelByDifferences) {
  const Law law = support::open_umat({"elastic", {30e6, 0.3}});
  check<4>(
      law, 30e6, 50e3, 1e-6, [](auto& r) { return make_start(r, 4, 50e3); }, -1);
  check<6>(
      law, 30e6, 50e3, 1e-6, [](auto& r) { return make_start(r, 6, 50e3); }, -1);
}

TEST(SolidTangent, SymmetryIsDetected) {
  const double deg = std::acos(-1.0) / 180;
  const std::array<double, 6> strain{2e-3, -4e-3, 0, 1e-3, 0, 0};
  for (const double psi : {0.0, 30.0}) {
    const material::MohrCoulomb law(elastic, {2e3, 30 * deg, psi * deg, 1e9});
    Start s;
    s.stress = {-40e3, -50e3, -45e3, 0, 0, 0};
    std::array<double, 16> c{};
    const auto answer = update_point<4>(law, 1, strain.data(), s.stress.data(), s.state.data(), c.data());
    EXPECT_TRUE(answer.yields);
    EXPECT_EQ(answer.symmetric, psi == 30.0);
  }
}

TEST(SolidTangent, SoilThatSoftensKeepsItsStrength) {
  const double deg = std::acos(-1.0) / 180, strain = 0.05;  // half of the softening
  struct Blocks : material::YoungInput,
                  material::PoissonInput,
                  material::MohrCoulombStrength,
                  material::ResidualStrength,
                  material::SofteningRange {};
  Blocks in;
  in.young_modulus = 30e6, in.poisson_ratio = 0.3;
  static_cast<material::MohrCoulombStrength&>(in) = {20e3, 30 * deg, 5 * deg, 2e3};
  static_cast<material::ResidualStrength&>(in) = {4e3, 15 * deg};
  static_cast<material::SofteningRange&>(in) = {0, 2 * strain, material::LimitStrength::peak};
  const auto falling = material::SofteningMohrCoulomb::make(in, {});
  const material::MohrCoulomb constant(elastic, falling.find_strength(strain));
  const std::array<double, 6> change{2e-3, -4e-3, 0, 1e-3, 0, 0};
  Start a, b;
  a.stress = b.stress = {-40e3, -50e3, -45e3, 0, 0, 0};
  a.state[material::SofteningMohrCoulomb::softening_state] = strain;
  std::array<double, 16> c{}, d{};
  EXPECT_TRUE(update_point<4>(falling, 1, change.data(), a.stress.data(), a.state.data(), c.data()).yields);
  update_point<4>(constant, 1, change.data(), b.stress.data(), b.state.data(), d.data());
  EXPECT_EQ(a.stress, b.stress);
  EXPECT_EQ(c, d);
  EXPECT_EQ(a.state[0], b.state[0]);
  EXPECT_EQ(a.state[material::SofteningMohrCoulomb::softening_state], strain);

  in.is_associated = true, in.dilatancy_angle = in.friction_angle;
  const auto strength = material::SofteningMohrCoulomb::make(in, {1.3, {}}).find_strength(strain);
  EXPECT_NEAR(strength.dilatancy_angle, strength.friction_angle, 1e-12);
}

TEST(DualNumber, FunctionsHaveTheirDerivatives) {
  using T = Dual<2>;
  const T x = T::variable(1.7, 0), y = T::variable(0.3, 1);
  const T f = lane_sqrt(x * x + y) / (1.0 + lane_exp(y)) - lane_log(x) * lane_abs(-y) + lane_power(x, 2.5);
  const auto g = [](double a, double b) {
    return std::sqrt(a * a + b) / (1 + std::exp(b)) - std::log(a) * b + std::pow(a, 2.5);
  };
  const double h = 1e-6;
  EXPECT_NEAR(f.value, g(1.7, 0.3), 1e-14);
  EXPECT_NEAR(f.slope[0], (g(1.7 + h, 0.3) - g(1.7 - h, 0.3)) / (2 * h), 1e-9);
  EXPECT_NEAR(f.slope[1], (g(1.7, 0.3 + h) - g(1.7, 0.3 - h)) / (2 * h), 1e-9);
}

}  // namespace
}  // namespace talus::fem
