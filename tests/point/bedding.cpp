// SPDX-License-Identifier: MIT
// Soil with bedding planes at a point: Jaeger's strength of a specimen by the angle of its planes, and the return.

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "fem/solid/system.hpp"
#include "material/every_law.hpp"
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

/// Draws of the laws and steps below, about half of which reach the corner of both strengths. `fraction`: ψ over φ of
/// the rock and of the planes.
struct Case {
  double angle, tension, fraction;

  explicit Case(support::Draw& draw, double flow) : angle(draw(-90, 90) * degree), fraction(flow) {
    const double apex = plane_cohesion / std::tan(plane_friction);
    tension = draw(0, 1) < 0.3 ? 0 : draw(0, 1.5) * apex;
  }
  material::Bedding make(double turned = 0, bool mirrored = false) const {
    Blocks in;
    in.young_modulus = 200e6, in.poisson_ratio = 0.25;
    static_cast<material::MohrCoulombStrength&>(in) = {cohesion, friction, fraction * friction, tension};
    in.bedding_angle = mirrored ? -angle : angle + turned;
    in.bedding_cohesion = plane_cohesion, in.bedding_friction = plane_friction;
    in.bedding_dilatancy = fraction * plane_friction;
    return material::Bedding::make(in, {});
  }
};

template <int NS>
struct Step {
  Voigt<NS> start{}, strain{};

  explicit Step(support::Draw& draw) {
    // Most steps start near both surfaces, as in a slope that is about to fail.
    const double size = std::pow(10, draw(-5, -2.5));
    for (std::size_t i = 0; i < NS; ++i) strain[i] = draw(-size, size);
    for (std::size_t i = 0; i < 3; ++i) start[i] = -draw(0, 60e3);
    for (std::size_t i = 3; i < NS; ++i) start[i] = draw(-40e3, 40e3);
    if constexpr (NS == 4) strain[2] = 0;
  }
};

/// Returns the nearest admissible stress.
template <int NS>
void admit(const material::Bedding& law, Voigt<NS>& stress) {
  const Voigt<NS> none{};
  std::array<double, 2> state{};
  law.update<NS>(stress.data(), none.data(), state.data(), true);
}

/// Excesses of shear strength and tension on the planes and in the rock, the largest [Pa].
template <int NS>
double find_excess(const Case& c, const Voigt<NS>& stress) {
  const double s = std::sin(c.angle), k = std::cos(c.angle);
  const double normal = s * s * stress[0] + k * k * stress[1] - 2 * s * k * stress[3],
               along = s * k * (stress[1] - stress[0]) + (k * k - s * s) * stress[3],
               across = NS == 6 ? k * stress[4] - s * stress[5] : 0;
  const Eigen::Vector3d principal =
      Eigen::SelfAdjointEigenSolver<reference::Tensor>(support::to_tensor<NS>(stress)).eigenvalues();
  const double ratio = (1 + std::sin(friction)) / (1 - std::sin(friction));
  return std::max({std::hypot(along, across) + normal * std::tan(plane_friction) - plane_cohesion, normal - c.tension,
                   principal[2] - c.tension, ratio * principal[2] - principal[0] - 2 * cohesion * std::sqrt(ratio)});
}

/// The strain that is not elastic: Δε - C⁻¹(σ - σ_old).
template <int NS>
Voigt<NS> find_plastic(const Voigt<NS>& old, const Voigt<NS>& strain, const Voigt<NS>& now) {
  const double e = 200e6, nu = 0.25;
  double trace = 0;
  for (std::size_t i = 0; i < 3; ++i) trace += now[i] - old[i];
  Voigt<NS> plastic = strain;
  for (std::size_t i = 0; i < 3; ++i) plastic[i] -= ((1 + nu) * (now[i] - old[i]) - nu * trace) / e;
  for (std::size_t i = 3; i < NS; ++i) plastic[i] -= 2 * (1 + nu) * (now[i] - old[i]) / e;
  return plastic;
}

template <int NS>
double find_work(const Voigt<NS>& stress, const Voigt<NS>& strain) {
  double work = 0;
  for (std::size_t i = 0; i < NS; ++i) work += stress[i] * strain[i];
  return work;
}

/// Hill's principle of maximum plastic work: (σ - σ*):Δε^p >= 0 for every admissible σ*, if flow is associated. It
/// holds for one stress only, the nearest to the trial stress in the norm of elastic energy.
template <int NS>
void expect_most_work(unsigned seed) {
  support::Draw draw(seed);
  int plastic = 0;
  for (int n = 0; n < 1000; ++n) {
    const Case c(draw, 1);
    const material::Bedding law = c.make();
    Step<NS> step(draw);
    admit<NS>(law, step.start);
    Voigt<NS> end = step.start;
    std::array<double, 2> state{};
    if (!law.update<NS>(end.data(), step.strain.data(), state.data(), true).any_plastic) continue;
    ++plastic;
    ASSERT_LT(find_excess<NS>(c, end), 1e-2) << n;
    const Voigt<NS> flow = find_plastic<NS>(step.start, step.strain, end);
    for (int other = 0; other < 20; ++other) {
      Voigt<NS> admissible{};
      for (std::size_t i = 0; i < NS; ++i) admissible[i] = end[i] + draw(-20e3, 20e3);
      admit<NS>(law, admissible);
      for (const Voigt<NS>& s : {step.start, admissible}) {
        double size = 0;
        for (std::size_t i = 0; i < NS; ++i) size += std::abs((end[i] - s[i]) * flow[i]);
        ASSERT_GE(find_work<NS>(end, flow) - find_work<NS>(s, flow), -1e-6 * size - 1e-7) << n;
      }
    }
  }
  EXPECT_GT(plastic, 400);
}

TEST(Bedding, AssociatedFlowDoesTheMostWork) {
  expect_most_work<4>(5);
  expect_most_work<6>(6);
}

/// Plastic work at the returned stress is not negative, and that of the law is the mean of both ends of the step.
TEST(Bedding, DissipatesWithoutDilatancy) {
  support::Draw draw(7);
  int plastic = 0;
  for (int n = 0; n < 2000; ++n) {
    const Case c(draw, n % 3 * 0.3);
    const material::Bedding law = c.make();
    Step<6> step(draw);
    admit<6>(law, step.start);
    Voigt<6> end = step.start;
    std::array<double, 2> state{};
    const auto response = law.update<6>(end.data(), step.strain.data(), state.data(), true);
    if (!response.any_plastic) continue;
    ++plastic;
    ASSERT_LT(find_excess<6>(c, end), 1e-2) << n;
    const Voigt<6> flow = find_plastic<6>(step.start, step.strain, end);
    const double work = find_work<6>(end, flow);
    ASSERT_GE(work, -1e-7) << n;
    ASSERT_NEAR(response.dissipation, 0.5 * (work + find_work<6>(step.start, flow)), 1e-6 * std::abs(work) + 1e-7);
    ASSERT_NEAR(response.plastic_dilation, flow[0] + flow[1] + flow[2], 1e-12);
  }
  EXPECT_GT(plastic, 800);
}

/// Stress and strain in axes that are turned by an angle about the third axis, or mirrored in the first.
template <int NS>
Voigt<NS> turn(const Voigt<NS>& v, double angle, bool mirrored, bool is_strain) {
  Eigen::Matrix3d q = Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  if (mirrored) q = Eigen::Vector3d(-1, 1, 1).asDiagonal();
  return support::to_voigt<NS>(q * support::to_tensor<NS>(v, is_strain) * q.transpose(), is_strain);
}

template <int NS>
void expect_frame_independence(unsigned seed) {
  support::Draw draw(seed);
  for (int n = 0; n < 1000; ++n) {
    const Case c(draw, n % 2 == 0 ? 1 : 0.2);
    const double angle = draw(-180, 180) * degree;
    const bool mirrored = n % 4 == 0;
    Step<NS> step(draw);
    admit<NS>(c.make(), step.start);
    Voigt<NS> end = step.start, other = turn<NS>(step.start, angle, mirrored, false);
    const Voigt<NS> strain = turn<NS>(step.strain, angle, mirrored, true);
    std::array<double, 2> state{}, other_state{};
    const auto one = c.make().update<NS>(end.data(), step.strain.data(), state.data(), true);
    const auto two = c.make(angle, mirrored).update<NS>(other.data(), strain.data(), other_state.data(), true);
    const Voigt<NS> expected = turn<NS>(end, angle, mirrored, false);
    for (std::size_t i = 0; i < NS; ++i) ASSERT_NEAR(other[i], expected[i], 1e-2) << n << " " << angle / degree;
    ASSERT_NEAR(state[0], other_state[0], 1e-9);
    ASSERT_NEAR(one.dissipation, two.dissipation, 1e-6 * (1 + std::abs(one.dissipation)));
  }
}

TEST(Bedding, DoesNotDependOnTheFrame) {
  expect_frame_independence<4>(8);
  expect_frame_independence<6>(9);
}

/// The tangent of FEM is the derivative of the stress, and symmetric for associated flow.
template <int NS>
void expect_tangent(unsigned seed) {
  support::Draw draw(seed);
  int right = 0, plastic = 0;
  for (int n = 0; n < 500; ++n) {
    const Case c(draw, n % 2 == 0 ? 1 : 0);
    const material::Law law = c.make();
    Step<NS> step(draw);
    admit<NS>(c.make(), step.start);
    const auto update = [&](const Voigt<NS>& strain, double* tangent) {
      Voigt<NS> end = step.start;
      std::array<double, 2> state{};
      const auto answer = fem::update_point<NS>(law, 1, strain.data(), end.data(), state.data(), tangent);
      return std::pair{end, answer};
    };
    std::array<double, NS * NS> tangent{};
    const auto [end, answer] = update(step.strain, tangent.data());
    if (!answer.yields) continue;
    ++plastic;
    EXPECT_TRUE(answer.symmetric || n % 2 == 1) << n;
    double most = 0;
    for (std::size_t j = 0; j < NS; ++j) {
      Voigt<NS> up = step.strain, down = step.strain;
      up[j] += 1e-10, down[j] -= 1e-10;
      const auto high = update(up, nullptr).first, low = update(down, nullptr).first;
      for (std::size_t i = 0; i < NS; ++i)
        most = std::max(most, std::abs((high[i] - low[i]) / 2e-10 - tangent[i * NS + j]));
    }
    right += most < 1e-3 * 240e6;
  }
  EXPECT_GT(plastic, 200);
  EXPECT_GE(right, plastic - 2) << "a step may end at a kink";
}

TEST(Bedding, HasItsConsistentTangent) {
  expect_tangent<4>(10);
  expect_tangent<6>(11);
}

}  // namespace
}  // namespace talus
