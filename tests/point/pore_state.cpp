// SPDX-License-Identifier: MIT
// Pore pressure from the mass of water: convergence from any initial guess, and packs against doubles, for all curves.

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "material/every_law.hpp"

#include "mpm/kernels/pore_state.hpp"

namespace talus {
namespace {

mpm::WaterLaw make_law(material::Retention retention, material::Conductivity relative, double modulus) {
  mpm::WaterLaw law;
  law.wet = true;
  law.bulk_modulus = modulus;
  law.retention = std::move(retention);
  law.relative = std::move(relative);
  return mpm::finish(law);
}

std::vector<mpm::WaterLaw> make_laws() {
  std::vector<mpm::WaterLaw> laws;
  for (double modulus : {5e7, 2.2e9}) {
    for (double lambda : {0.1, 0.27, 0.5, 0.85}) {
      for (bool same : {false, true}) {
        material::Mualem mualem{lambda, material::SaturationMeasure::effective};
        mualem.same_curve = same;
        laws.push_back(make_law(material::VanGenuchten{0.1, 1, 6130, lambda}, mualem, modulus));
      }
    }
    laws.push_back(make_law(material::ExponentialRetention{0.05, 0.98, 1 / 15e3}, material::Hillel{3}, modulus));
    laws.push_back(make_law(material::LinearRetention::from_scale(0.2, 1, 8e4), material::Hillel{3}, modulus));
    laws.push_back(make_law(
        material::make_retention_table({{0, 1}, {5e3, 0.9}, {3e4, 0.5}, {1e6, 0.1}}, material::Interpolation::smooth),
        material::ConstantConductivity{}, modulus));
    laws.push_back(make_law(material::ConstantSaturation{}, material::ExponentialConductivity{1e-5}, modulus));
  }
  return laws;
}

/// Suctions and pressures [Pa] over all orders that occur.
std::vector<double> make_pressures() {
  std::vector<double> all{0};
  for (double p = 1e-2; p < 3e6; p *= 1.7) all.insert(all.end(), {p, -p});
  return all;
}

/// Error of a pressure from round-off of the content [Pa].
double find_noise(const mpm::WaterLaw& law, double p) {
  return 1e-11 * std::abs(p) + 4e-15 / mpm::find_storage(law, p);
}

TEST(PoreState, PressureIsFoundFromTheMassFromAnyGuess) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> exponent(-3, 3);
  for (const mpm::WaterLaw& law : make_laws()) {
    for (double p : make_pressures()) {
      if (mpm::find_storage(law, p) * law.bulk_modulus < 1e-3)
        continue;  // beyond the end of the curve the content does not determine p
      const double content = mpm::find_content(law, p), saturation = material::saturation(law.retention, p);
      for (double guess : {p, p * 1.0001, p * 0.7, -5e3, std::pow(10.0, exponent(random)) * std::abs(p)}) {
        const auto state = mpm::find_pore_state<double>(law, content, guess, true);
        ASSERT_NEAR(state.pressure, p, find_noise(law, p)) << "guess " << guess;
        ASSERT_NEAR(state.saturation, saturation, 1e-11) << "at " << p;
        ASSERT_NEAR(state.bishop, saturation * p, 1e-10 * std::abs(p) + find_noise(law, p));
      }
    }
  }
}

TEST(PoreState, ConductivityIsThatOfTheLawAtThePressure) {
  for (const mpm::WaterLaw& law : make_laws()) {
    for (double p : make_pressures()) {
      if (mpm::find_storage(law, p) * law.bulk_modulus < 1e-3) continue;
      const auto found = mpm::find_pore_state<double>(law, mpm::find_content(law, p), p, true);
      const auto direct = mpm::find_state_at_pressure<double>(law, p);
      ASSERT_NEAR(found.relative / direct.relative, 1, 1e-6) << "at " << p;  // k_r of Mualem is steep at saturation
      ASSERT_LE(direct.relative, 1 + 1e-12);
    }
  }
}

TEST(PoreState, CapacityIsTheSlopeOfTheContent) {
  for (const mpm::WaterLaw& law : make_laws()) {
    for (double p : {-1e5, -1e3, 800.0, 6e3, 2.5e4}) {
      const double h = 1e-4 * std::abs(p);
      const double slope = (mpm::find_content(law, p + h) - mpm::find_content(law, p - h)) / (2 * h);
      const auto state = mpm::find_pore_state<double>(law, mpm::find_content(law, p), p, true);
      EXPECT_NEAR(state.capacity / slope, 1, 1e-4) << "at " << p;
    }
  }
}

TEST(PoreState, LanesGiveWhatADoubleGives) {
  for (const mpm::WaterLaw& law : make_laws()) {
    Pack content(1.0), guess(0.0);
    for (int l = 0; l < lane_width; ++l) {
      const double p = l % 3 == 0 ? -2e4 * (l + 1) : 3e2 * std::pow(3.0, l);
      content.value[l] = mpm::find_content(law, p);
      guess.value[l] = 1.001 * p;
    }
    const auto lanes = mpm::find_pore_state<Pack>(law, content, guess, Mask(true));
    for (int l = 0; l < lane_width; ++l) {
      const auto one = mpm::find_pore_state<double>(law, content[l], guess[l], true);
      EXPECT_NEAR(lanes.pressure[l], one.pressure, find_noise(law, one.pressure));
      EXPECT_NEAR(lanes.relative[l] / one.relative, 1, 1e-9);
    }
  }
}

/// Lanes without a point hold what was there before: it must not show in those beside them, not in the last bit.
TEST(PoreState, ALaneDoesNotSeeItsNeighbours) {
  for (const mpm::WaterLaw& law : make_laws()) {
    for (const double p : make_pressures()) {
      const double far = 0.05 * law.bulk_modulus;  // where the stretch of the water is no short series
      const Pack pressure(p), content(mpm::find_content(law, p));
      Pack guess = pressure, beside = content;
      guess.value[1] = far;
      beside.value[1] = mpm::find_content(law, far);
      const auto alone = mpm::find_pore_state<Pack>(law, content, pressure, Mask(true)),
                 found = mpm::find_pore_state<Pack>(law, beside, guess, Mask(true));
      ASSERT_EQ(found.pressure[0], alone.pressure[0]) << "at " << p;
      ASSERT_EQ(found.saturation[0], alone.saturation[0]) << "at " << p;
      ASSERT_EQ(found.relative[0], alone.relative[0]) << "at " << p;
    }
  }
}

}  // namespace
}  // namespace talus
