// SPDX-License-Identifier: MIT
// Separation of soil: the gap in closed form, for every law that stores one.

#include <gtest/gtest.h>

#include <array>

#include "material/every_law.hpp"

namespace talus::material {
namespace {

constexpr double young = 10e6, poisson = 0.3;

LinearElastic make_elastic() {
  return LinearElastic::from_young(young, poisson);
}

/// A point in plane strain that is strained step by step.
template <class L>
struct Point {
  const L& law;
  std::array<double, 4> stress{};
  std::array<double, max_state_size> state{};
  double dissipated = 0, work = 0;

  Response<double> strain(double x, double y, double xy = 0, Gaps gaps = Gaps::kept) {
    const double d[4]{x, y, 0, xy};
    const std::array<double, 4> before = stress;
    Surroundings<double> around;
    around.gaps = gaps;
    const Response<double> r = law.template update<4, double>(stress.data(), d, state.data(), true, around);
    for (std::size_t i = 0; i < 4; ++i) work += 0.5 * (before[i] + stress[i]) * d[i];
    dissipated += r.dissipation;
    return r;
  }
  double gap() const { return law.find_gap(state.data()); }
  double energy() const { return law.template elastic_energy<4>(stress.data(), state.data()); }
};

TEST(Separation, SandOpensAtNoStressAndBearsAgainWhenTheGapIsClosed) {
  const MohrCoulomb sand(make_elastic(), {0, 0.5, 0, 0});
  Point<MohrCoulomb> p{sand};
  EXPECT_NEAR(p.strain(0.01, 0.02).opened, 0.03, 1e-15);
  EXPECT_NEAR(p.gap(), 0.03, 1e-15);
  const auto closing = p.strain(-0.01, -0.01);
  EXPECT_NEAR(closing.opened, -0.02, 1e-15);
  for (const double s : p.stress) EXPECT_NEAR(s, 0, 1e-6 * young * 0.01);
  // Half of this step closes what is left, the other half presses: with the in-plane stiffness λ + μ per volume strain.
  p.strain(-0.01, -0.01);
  EXPECT_EQ(p.gap(), 0);
  const LinearElastic e = make_elastic();
  EXPECT_NEAR(p.stress[0], -0.01 * (e.lambda + e.mu), 1e-9 * young);
  EXPECT_NEAR(p.stress[1], p.stress[0], 1e-9 * young);
  EXPECT_NEAR(p.dissipated, 0, 1e-9) << "no stress, no work";
}

TEST(Separation, WithoutItStressComesBackAtOnce) {
  const MohrCoulomb sand(make_elastic(), {0, 0.5, 0, 0});
  Point<MohrCoulomb> p{sand};
  EXPECT_GT(p.strain(0.01, 0.02, 0, Gaps::ignored).opened, 0) << "it is reported and not stored";
  EXPECT_EQ(p.gap(), 0);
  p.strain(-0.001, -0.001, 0, Gaps::ignored);
  EXPECT_LT(p.stress[0], -1e3);
}

TEST(Separation, TensionIsTakenAwayElasticallyBeforeTheGapCloses) {
  const double cohesion = 20e3, friction = 0.5, tension = 5e3;
  const MohrCoulomb clay(make_elastic(), {cohesion, friction, 0, tension});
  Point<MohrCoulomb> p{clay};
  p.strain(0.01, 0.01);
  const LinearElastic e = make_elastic();
  for (int i = 0; i < 2; ++i) EXPECT_NEAR(p.stress[static_cast<std::size_t>(i)], tension, 1e-6);
  const double gap = p.gap();
  // The gap is the strain minus the elastic strain of this tension; there is no out-of-plane yielding.
  EXPECT_NEAR(gap, 0.02 - tension / (e.lambda + e.mu), 1e-12);
  const double unload = tension / (e.lambda + e.mu);
  p.strain(-unload / 4, -unload / 4);
  EXPECT_NEAR(p.stress[0], tension / 2, 1e-6) << "half of the tension is gone";
  EXPECT_EQ(p.gap(), gap);
  p.strain(-unload / 4 - 0.002, -unload / 4 - 0.002);
  EXPECT_NEAR(p.stress[0], 0, 1e-6);
  EXPECT_NEAR(p.gap(), gap - 0.004, 1e-12);
}

TEST(Separation, ACrackInOneDirectionIsNoGap) {
  const MohrCoulomb clay(make_elastic(), {20e3, 0.5, 0, 0});
  Point<MohrCoulomb> p{clay};
  p.stress = {-10e3, -30e3, -10e3, 0};
  const auto r = p.strain(0.0012, 0);  // opens along x, bears along y
  EXPECT_NEAR(p.stress[0], 0, 1e-6);
  EXPECT_LT(p.stress[1], -20e3);
  EXPECT_EQ(r.opened, 0);
}

TEST(Separation, WorkOverACycleIsDissipatedOrStored) {
  const MohrCoulomb soil(make_elastic(), {8e3, 0.5, 0.1, 3e3});
  Point<MohrCoulomb> p{soil};
  p.stress = {-10e3, -20e3, -12e3, 0};
  const double start = p.energy();
  for (int n = 0; n < 2000; ++n) {
    const double phase = 0.01 * n, size = 2e-5;
    p.strain(size * std::cos(phase), size * std::sin(1.3 * phase + 1), size * std::sin(0.7 * phase));
  }
  EXPECT_GT(p.dissipated, 0);
  // The gap closes without stress here, so all work is elastic energy or plastic work.
  EXPECT_NEAR(p.work, p.energy() - start + p.dissipated, 5e-3 * p.dissipated);
}

TEST(Separation, RootedSoilKeepsItsGapBesideItsRoots) {
  const LinearElastic e = make_elastic();
  const RootedMohrCoulomb rooted(e, {0, 0.5, 0, 0});
  Point<RootedMohrCoulomb> r{rooted};
  r.strain(0.01, 0.01);
  EXPECT_NEAR(r.gap(), 0.02, 1e-15);
  EXPECT_EQ(r.state[1], 0) << "the root cohesion stays";
  EXPECT_EQ(find_gap(Law(rooted), r.state.data()), r.gap());
  EXPECT_EQ(find_gap(Law(e), r.state.data()), 0);
}

}  // namespace
}  // namespace talus::material
