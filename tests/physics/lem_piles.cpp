// SPDX-License-Identifier: MIT
// Force of a pile across a slip surface: the six mechanisms of Viggiani (1981) in two uniform soils, the kinematic
// theorem with pressures that grow with depth, and limits of piles in a slope.

#include "lem/section/piles.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <random>

#include "support/lem_sections.hpp"

namespace talus::lem {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A pressure over a pile, with `parts` stations.
BarDiagram sum_pressure(double length, int parts, const std::function<double(double)>& pressure) {
  BarDiagram diagram{.from = 0, .step = length / parts, .sum = {0}, .moment = {0}};
  for (int i = 0; i < parts; ++i) {
    const double middle = (i + 0.5) * diagram.step, force = pressure(middle) * diagram.step;
    diagram.sum.push_back(diagram.sum.back() + force);
    diagram.moment.push_back(diagram.moment.back() + force * middle);
  }
  return diagram;
}

/// Forces of the modes A, B, B1, B2, BY and C over that of C, with λ = l₂/l₁, χ = p₂/p₁ and 4 M_p/(p₁ l₁²) (Viggiani
/// 1981). The pile fails by the least of them.
std::array<double, 6> compute_viggiani(double lambda, double chi, double moment) {
  const double a = chi / (1 + chi);
  return {
      lambda * chi,
      std::sqrt(std::pow((1 + lambda) * a, 2) + a * (1 + lambda * lambda * chi)) - (1 + lambda) * a,
      chi / (2 + chi) * (std::sqrt((2 * chi + 2) / chi + moment * (chi + 2) / chi) - 1),
      chi * lambda / (2 * chi + 1) * (std::sqrt(2 * chi + 2 + moment * (2 * chi + 1) / (chi * lambda * lambda)) - 1),
      std::sqrt(moment * a),
      1};
}

TEST(LemPiles, TwoUniformSoilsHaveTheLeastOfViggianisSixModes) {
  constexpr std::array mechanisms{BarLimit::embedment, BarLimit::rotation,   BarLimit::one_hinge,
                                  BarLimit::one_hinge, BarLimit::two_hinges, BarLimit::lateral};
  constexpr double above = 4, pressure = 30;
  std::array<int, 6> seen{};
  std::mt19937 random(3);
  const auto draw = [&](double low, double high) {
    return low * std::pow(high / low, static_cast<double>(random() % 10000) / 10000);
  };
  for (int i = 0; i < 2000; ++i) {
    const double lambda = draw(0.1, 4), chi = draw(0.3, 10), ratio = draw(0.02, 20);
    const auto modes = compute_viggiani(lambda, chi, ratio);
    const auto least = static_cast<std::size_t>(std::min_element(modes.begin(), modes.end()) - modes.begin());
    ++seen[least];
    const double length = above * (1 + lambda), all = pressure * above;
    const BarDiagram mass = sum_pressure(length, 256, [&](double) { return pressure; }),
                     stable = sum_pressure(length, 256, [&](double) { return chi * pressure; });
    const PileForce found = compute_pile_force({&mass, above, 0}, {&stable, above, length},
                                               {0.25 * ratio * pressure * above * above, infinity, infinity});
    EXPECT_NEAR(found.force, modes[least] * all, 1e-9 * all) << lambda << " " << chi << " " << ratio;
    EXPECT_EQ(found.limit, mechanisms[least]) << lambda << " " << chi << " " << ratio;
    // Seen from the other end it is the same pile.
    EXPECT_NEAR(compute_pile_force({&mass, length - above, length}, {&stable, length - above, 0},
                                   {0.25 * ratio * pressure * above * above, infinity, infinity})
                    .force,
                found.force, 1e-9 * all);
  }
  for (const int number : seen) EXPECT_GT(number, 20);
}

/// Least dissipation of a part of the pile of unit length from the slip surface in its motion relative to its soil,
/// with the displacement `start` at the surface and the rotation `turn`: rigid, or with a hinge beyond which it is at
/// rest.
double scan_dissipation(double start, double turn, double plastic_moment, double from, double growth) {
  // Pressure `from` + `growth` ζ on a part of the length 1.
  const auto dissipate = [&](double length) {
    constexpr int parts = 100;
    double sum = 0;
    for (int i = 0; i < parts; ++i) {
      const double z = (i + 0.5) * length / parts;
      sum += (from + growth * z) * std::abs(start - turn * z) * length / parts;
    }
    return sum;
  };
  double least = dissipate(1);
  if (const double rest = turn > 0 ? start / turn : 1; rest < 1)
    least = std::min(least, dissipate(rest) + plastic_moment * turn);
  return least;
}

TEST(LemPiles, PressuresThatGrowWithDepthAgreeWithTheKinematicTheorem) {
  // Mass: 10 + 20 (1 - ζ), stable soil: 40 + 60 ζ, both over 1 m. T = min of the dissipation over the motions whose
  // jump at the surface is 1.
  const BarDiagram mass = sum_pressure(2, 4096, [](double z) { return z < 1 ? 10 + 20 * z : 40 + 60 * (z - 1); });
  for (const double moment : {0.5, 2.0, 4.0, 20.0}) {
    double least = infinity;
    for (int i = 0; i <= 50; ++i)
      for (int k = 0; k <= 100; ++k) {
        const double above = i / 50.0, turn = k / 25.0;
        least = std::min(
            least, scan_dissipation(above, turn, moment, 30, -20) + scan_dissipation(1 - above, turn, moment, 40, 60));
      }
    const double force = compute_pile_force({&mass, 1, 0}, {&mass, 1, 2}, {moment, infinity, infinity}).force;
    EXPECT_LE(force, least * (1 + 1e-3)) << moment;
    EXPECT_GT(force, 0.99 * least) << moment;
  }
}

/// A slope with a row of piles of 0.8 m from (17.5, 5), and a circle that crosses it.
Section make_piled_slope(BarHold hold, double length) {
  Section section = make_section({{0, 0}, {10, 0}, {25, 10}, {35, 10}}, make_soil(10, 20, 20), -10);
  Bar& pile = section.bars.emplace_back();
  pile.head = {17.5, 5}, pile.end = {17.5, 5 - length};
  pile.hold = hold, pile.direction = BarDirection::tangent;
  pile.lateral = 60;
  pile.diameter = 0.8, pile.spacing = 2.4;
  pile.is_pile = true;
  return section;
}

BarPull cross(const Section& section) {
  const Slope slope{Section(section)};
  const CutSurface cut = cut_surface(slope, make_circle(slope, {14, 16}, 16.5), 60, report_only());
  return cut.pulls.empty() ? BarPull{} : cut.pulls[0];
}

TEST(LemPiles, ADeepStrongPileHasTheForceOfTheSoilAboveTheSurface) {
  Section section = make_piled_slope(BarHold::soil_pressure, 14.9);
  const BarPull pull = cross(section);
  const double soil = make_bar_diagram(Slope(Section(section)), section.bars[0]).find_part(0, pull.distance);
  EXPECT_NEAR(pull.resistance, soil, 1e-9 * soil);
  EXPECT_EQ(pull.limit, BarLimit::lateral);
  section = make_piled_slope(BarHold::across, 14.9);
  EXPECT_NEAR(cross(section).resistance, 60, 1e-9);
  section.bars[0].shear = 25;
  EXPECT_NEAR(cross(section).resistance, 25, 1e-9);
  EXPECT_EQ(cross(section).limit, BarLimit::shear);
}

TEST(LemPiles, ForceGrowsWithEmbedmentAndPlasticMomentFromZero) {
  for (const BarHold hold : {BarHold::soil_pressure, BarHold::across}) {
    const double crossing = cross(make_piled_slope(hold, 14)).distance;
    EXPECT_EQ(cross(make_piled_slope(hold, crossing - 0.01)).resistance, 0) << "the surface passes below the pile";
    EXPECT_LT(cross(make_piled_slope(hold, crossing + 1e-3)).resistance, 1);
    double last = 0;
    for (double length = crossing + 0.1; length < 14.9; length += 0.3) {
      const double force = cross(make_piled_slope(hold, length)).resistance;
      EXPECT_GE(force, last * (1 - 1e-3)) << length;  // the diagram has 256 parts
      last = force;
    }
    last = 0;
    Section section = make_piled_slope(hold, 12);
    for (const double moment : {0.1, 1.0, 10.0, 30.0, 100.0, 300.0, 1e4, infinity}) {
      section.bars[0].moment = moment;
      const double force = cross(section).resistance;
      EXPECT_GE(force, last * (1 - 1e-9)) << moment;
      last = force;
    }
    // Hinges close to the surface, where the pressures are p₁ and p₂: T² = 4 M_p p₁ p₂ / (p₁ + p₂).
    section.bars[0].moment = 0.1;
    const BarPull weak = cross(section);
    const Slope slope{Section(section)};
    const BarDiagram below = make_embedded_diagram(slope, section.bars[0]),
                     above = hold == BarHold::across ? below : make_bar_diagram(slope, section.bars[0]);
    const auto find_pressure = [&](const BarDiagram& d) {
      return d.find_part(weak.distance - 0.05, weak.distance + 0.05) / 0.1;
    };
    const double p1 = find_pressure(above), p2 = find_pressure(below);
    EXPECT_NEAR(weak.resistance, std::sqrt(0.4 * p1 * p2 / (p1 + p2)), 0.02 * weak.resistance);
    EXPECT_EQ(weak.limit, BarLimit::two_hinges);
  }
}

TEST(LemPiles, StableSoilHasThePressureOfBromsOrOfAWall) {
  const double passive = 3, active = 1 / 3.0, tangent = std::tan(30 * degree);
  EXPECT_NEAR(compute_embedded_pressure({20, 0}, 100, 4, 0.8), 9 * 20 * 0.8, 1e-9);
  EXPECT_NEAR(compute_embedded_pressure({20, 0}, 100, 1, 0.8), 4 * 20 * 1, 1e-9) << "a wall in clay: ± 2 c";
  EXPECT_NEAR(compute_embedded_pressure({0, tangent}, 100, 4, 0.8), 3 * (passive - active) * 100 * 0.8, 1e-9);
  EXPECT_NEAR(compute_embedded_pressure({0, tangent}, 100, 2, 0.8), (passive - active) * 100 * 2, 1e-9);
  EXPECT_NEAR(compute_embedded_pressure({5, tangent}, 100, 2, 0),
              2 * ((passive - active) * 100 + 2 * 5 * (std::sqrt(passive) + std::sqrt(active))), 1e-9);
}

}  // namespace
}  // namespace talus::lem
