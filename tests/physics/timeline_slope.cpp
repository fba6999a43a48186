// SPDX-License-Identifier: MIT
// The factor of safety over time against closed forms and hand calculations: rain on an infinite slope, and a bank with
// infinitely fast or slow drawdown.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "physics/srivastava_yeh.hpp"
#include "support/run_json.hpp"
#include "support/scratch.hpp"
#include "support/water_in_time.hpp"

namespace talus {
namespace {

constexpr double gamma_w = 9810, band = 0.01;

/// Runs cases in a folder that goes when the test ends.
class TimelineSlope : public ::testing::Test {
 protected:
  std::vector<double> find_factors(const std::string& text) {
    run::RunOptions options;
    options.folder = folder_;
    options.overwrite = true;
    const auto summary = support::run_case(input::read_case_text(text, "slope.toml"), options);
    std::vector<double> factors;
    for (const auto& f : summary.at("timeline").at("factors"))
      factors.push_back(f.at("factor").is_null() ? 0 : f.at("factor").get<double>());
    return factors;
  }

  const std::filesystem::path folder_ = support::make_scratch("timeline") / "run";
};

/// Rain on a slab of silt, 100 m long and 2 m thick, on ground that takes the water away at zero pressure. At its ends
/// the ground has steps, so that a plane through it goes from ground to ground, and no end of it holds it.
struct Slab {
  double length = 100, slope = 0.4, thickness = 2;  // m, -, m in the vertical
  double size = 0.25, size_far = 0.8;               // of elements in its middle, and 8 m from there [m]
  double cohesion = 1e3, friction = 25 * std::numbers::pi / 180, unit_weight = 18e3;
  double porosity = 0.4, driest = 0.15;
  support::SrivastavaYeh soil{1.0, 1e-6, porosity, porosity* driest, 0, 0.05, 0.8};
  std::vector<double> days{0.5, 1, 2, 5, 20};

  double beta() const { return std::atan(slope); }

  /// A plane parallel to the ground at `depth` [m, vertical] is the only surface.
  std::string write(double depth) const {
    const double rise = length * slope;
    return fmt::format(R"(
geometry.box = [[-2, -1], [{0}, {1}]]
geometry.polygon = [
  {{ name = "slab", points = [[0, {2}], [{3}, 0], [{3}, {4}], [0, {5}]] }},
  {{ name = "head", points = [[-2, {6}], [0, {6}], [0, {2}], [-2, {2}]] }},
  {{ name = "foot", points = [[{3}, -1], [{0}, -1], [{0}, 0], [{3}, 0]] }}]
geometry.line = [{{ name = "ground", points = [[0, {5}], [{3}, {4}]] }}, {{ name = "table", points = [[0, {2}], [{3}, 0]] }}]
mesh = {{ size = {19}, refine = [{{ near = [[0, {20}], [{3}, {21}]], size = {18}, distance = 8 }}] }}
regions = {{ slab = "silt", head = "rock", foot = "rock" }}
initial.pore_pressure = "seepage"
hydraulic = [
  {{ on = "table", condition = "pressure", pressure = 0 }},
  {{ on = "ground", condition = "rain", rate = [[0, "{7} m/s"], [0, "{8} m/s"]] }}]
timeline = {{ duration = "20 day", times = [0.5, 1, 2, 5, 20] }}
analysis.methods = ["lem"]
[lem]
methods = ["spencer"]
search = "none"
referee = false
[[lem.surface]]
name = "plane"
points = [[0, {9}], [{3}, {10}]]
[materials.rock]
model = "linear_elastic"
unit_weight = 25
young_modulus = "1 GPa"
poisson_ratio = 0.3
[materials.silt]
model = "mohr_coulomb"
unit_weight = {11}
porosity = {12}
cohesion = {13}
friction_angle = {14}
young_modulus = "20 MPa"
poisson_ratio = 0.3
[materials.silt.water]
retention = "exponential"
relative_conductivity = "exponential"
minimum_saturation = {15}
decay = {16}
conductivity = "{17} m/s"
)",
                       length + 2, rise + thickness + 0.5, rise, length, thickness, rise + thickness, rise - 1,
                       soil.q_a * soil.ks, soil.q_b * soil.ks, rise + thickness - depth, thickness - depth,
                       unit_weight / 1e3, porosity, cohesion / 1e3, friction * 180 / std::numbers::pi, driest,
                       soil.alpha / gamma_w * 1e3, soil.ks, size, size_far, rise + 0.5 * thickness, 0.5 * thickness);
  }

  /// Suction of the closed form [Pa].
  double find_suction(double depth, double t) const {
    auto exact = soil;
    exact.length = thickness * std::cos(beta());
    return gamma_w * support::find_suction_in_slab(exact, beta(), (thickness - depth) * std::cos(beta()), t);
  }

  /// Bishop's χ = S (T18.3) on the plane: F = [c + (γ d cos²β + S s) tan φ] / (γ d sin β cos β).
  double find_factor(double depth, double t) const {
    const double s = find_suction(depth, t), fraction = driest + (1 - driest) * std::exp(-soil.alpha * s / gamma_w);
    const double normal = unit_weight * depth * std::pow(std::cos(beta()), 2);
    return (cohesion + (normal + fraction * s) * std::tan(friction)) / (normal * slope);
  }
};

TEST_F(TimelineSlope, RainSoaksIntoASlabAsSrivastavaAndYehHaveIt) {
  Slab slab;
  slab.length = 20;  // its middle is five times as far from both ends as from the water
  const double x = 0.5 * slab.length, ground = (slab.length - x) * slab.slope + slab.thickness;
  const double scale = slab.find_suction(0, 0);  // the largest
  for (const double size : {0.3, 0.15}) {
    slab.size = slab.size_far = size;
    const support::WaterInTime water(slab.write(0.15));
    double worst = 0;
    for (std::size_t i = 0; i <= slab.days.size(); ++i)
      for (int k = 0; k < 20; ++k) {
        const double depth = 0.1 * k, t = i == 0 ? 0 : slab.days[i - 1] * 86400;
        const double error = -water.find(i, {x, ground - depth - 1e-6}) - slab.find_suction(depth, t);
        worst = std::max(worst, std::abs(error));
      }
    RecordProperty(fmt::format("error_{}", size), fmt::format("{:.0f} of {:.0f} Pa", worst, scale));
    // Elements of 0.3 m are too large for the front in its first days: a miss, stated in docs/verification.md.
    if (size > 0.2) continue;
    EXPECT_LT(worst, band * scale);
  }
}

TEST_F(TimelineSlope, FactorOfAnInfiniteSlopeInRainIsItsClosedForm) {
  const Slab slab;
  for (const double depth : {0.5, 0.9}) {  // 200 and 111 times as long as deep
    const std::vector<double> factors = find_factors(slab.write(depth));
    ASSERT_EQ(factors.size(), slab.days.size() + 1);
    for (std::size_t i = 0; i < factors.size(); ++i) {
      const double days = i == 0 ? 0 : slab.days[i - 1], exact = slab.find_factor(depth, days * 86400);
      RecordProperty(fmt::format("depth_{}_day_{}", depth, days), fmt::format("{:.4f} of {:.4f}", factors[i], exact));
      EXPECT_NEAR(factors[i] / exact, 1, band) << depth << " m, day " << days;
    }
  }
}

/// A bank of 10 m on 4 m of the same soil, closed behind and below. Its pool falls from 8 m to 4 m; until then
/// the water is at rest.
struct Bank {
  double unit_weight = 20e3, cohesion = 5e3, friction = 27 * std::numbers::pi / 180;
  double before = 8, after = 4;
  double size = 0.5;                    // of the elements at the face, and of all others 0.5 [m]
  double xc = 6, yc = 20, radius = 21;  // the only surface, a circle from the foot to the crest

  std::string write(const std::string& head, const std::string& duration, const std::string& compressibility,
                    bool pool_loading = false) const {
    return fmt::format(R"(
geometry.box = [[-15, -4], [40, 10.5]]
geometry.polygon = [{{ name = "bank", points = [[-15, -4], [40, -4], [40, 10], [20, 10], [0, 0], [-15, 0]] }}]
geometry.line = [{{ name = "face", points = [[-15, 0], [0, 0], [20, 10]] }}]
mesh = {{ size = 0.5, refine = [{{ near = [[-15, 0], [0, 0], [20, 10]], size = {6}, distance = 4 }}] }}
regions.bank = "silt"
initial.pore_pressure = "seepage"
hydraulic = [{{ on = "face", condition = "total_head", head = {0} }}]
timeline = {{ duration = "{1}", times = ["{1}"], pool_loading = {7} }}
analysis.methods = ["lem"]
[lem]
methods = ["bishop"]
search = "none"
referee = false
slices = 200
[[lem.surface]]
name = "circle"
centre = [{2}, {3}]
radius = {4}
[materials.silt]
model = "mohr_coulomb"
unit_weight = 20
porosity = 0.4
cohesion = 5
friction_angle = 27
suction_strength = "none"
young_modulus = "20 MPa"
poisson_ratio = 0.3
[materials.silt.water]
retention = "van_genuchten"
minimum_saturation = 0.1
reference_pressure = 20
lambda = 0.5
relative_conductivity = "mualem"
measure = "effective"
conductivity = "1e-7 m/s"
compressibility = "{5}"
)",
                       head, duration, xc, yc, radius, compressibility, size, pool_loading);
  }

  /// Bishop's factor by hand, with hydrostatic pressures under `inside` and the pool at `outside` [m]. The water of the
  /// pool, at rest in the soil as well, would lift what lies under its level: about the centre of the circle the pool
  /// turns the mass by that much. `loads`: with the pool the pressures under it have fallen by its weight.
  double find_factor(double inside, double outside, bool loads = false) const {
    const auto ground = [](double x) { return std::clamp(x / 2, 0.0, 10.0); };
    const double from = xc - std::sqrt(radius * radius - yc * yc);
    const double to = xc + std::sqrt(radius * radius - std::pow(yc - 10, 2));
    const int count = 4000;
    const double b = (to - from) / count, t = std::tan(friction);
    double factor = 1;
    for (int round = 0; round < 50; ++round) {
      double resisting = 0, driving = 0;
      for (int i = 0; i < count; ++i) {
        const double x = from + (i + 0.5) * b, sine = (x - xc) / radius, cosine = std::sqrt(1 - sine * sine);
        const double y = yc - radius * cosine, top = ground(x);
        const double weight = unit_weight * (top - y) * b, pool = gamma_w * std::max(0.0, outside - top) * b;
        const double lift = gamma_w * std::clamp(outside - y, 0.0, top - y) * b;
        const double gone = loads ? std::max(0.0, inside - top) - std::max(0.0, outside - top) : 0;
        const double u = gamma_w * std::max(0.0, inside - y - gone);
        driving += (weight - lift) * sine;
        resisting += (cohesion * b + (weight + pool - u * b) * t) / (cosine + sine * t / factor);
      }
      factor = resisting / driving;
    }
    return factor;
  }
};

TEST_F(TimelineSlope, APoolThatFallsInfinitelyFastLeavesItsPressures) {
  // In soil that stores very much water for its skeleton no pressure changes in a second, but at the face itself.
  Bank bank;
  const double before = bank.find_factor(bank.before, bank.before), after = bank.find_factor(bank.before, bank.after);
  double last = 1;
  for (const double size : {0.5, 0.25, 0.125}) {
    bank.size = size;
    const std::string text = bank.write("[[0, 8], [0, 4]]", "1 s", "1 kPa-1");
    const support::WaterInTime water(text);
    for (const double x : {1.0, 6.0, 12.0, 18.0})  // from two elements under the ground on
      for (const double y : {-3.0, -1.0, std::min(x / 2, 8.0) - 2 * bank.size})
        EXPECT_NEAR(water.find(1, {x, y}), gamma_w * (bank.before - y), band * gamma_w * bank.before) << x << ", " << y;
    const auto factors = find_factors(text);
    RecordProperty(fmt::format("before_{}", size), fmt::format("{:.4f} of {:.4f}", factors.at(0), before));
    RecordProperty(fmt::format("after_{}", size), fmt::format("{:.4f} of {:.4f}", factors.at(1), after));
    EXPECT_NEAR(factors.at(0) / before, 1, band);
    // Pressures rise from the face over one element, which is missed at the toe of the circle: the factor is too high
    // by more than 1 %, and ever less in smaller elements (docs/verification.md).
    const double error = factors.at(1) / after - 1;
    EXPECT_GT(error, 0);
    EXPECT_LT(error, last);
    last = error;
  }
}

// Undrained response of soil that is softer than its water: pressures fall by the removed weight.
TEST_F(TimelineSlope, APoolThatFallsInfinitelyFastUnloadsTheSoilUnderIt) {
  const Bank bank;
  const std::string text = bank.write("[[0, 8], [0, 4]]", "1 s", "1 kPa-1", true);
  const support::WaterInTime water(text);
  for (const double x : {1.0, 6.0, 12.0, 18.0}) {
    const double top = x / 2, gone = std::max(0.0, bank.before - top) - std::max(0.0, bank.after - top);
    for (const double y : {-3.0, -1.0, std::min(top, 8.0) - 1})
      EXPECT_NEAR(water.find(1, {x, y}), gamma_w * (bank.before - y - gone), band * gamma_w * bank.before)
          << x << ", " << y;
  }
  const auto factors = find_factors(text);
  const double before = bank.find_factor(bank.before, bank.before),
               after = bank.find_factor(bank.before, bank.after, true);
  RecordProperty("before", fmt::format("{:.4f} of {:.4f}", factors.at(0), before));
  RecordProperty("after", fmt::format("{:.4f} of {:.4f}", factors.at(1), after));
  EXPECT_NEAR(factors.at(0) / before, 1, band);
  EXPECT_NEAR(factors.at(1) / after, 1, band);
}

TEST_F(TimelineSlope, APoolThatFallsInfinitelySlowlyLeavesWaterAtRest) {
  const Bank bank;
  const auto factors = find_factors(bank.write("[[0, 8], [\"1e11 s\", 4]]", "1e11 s", "1e-4 kPa-1"));
  const double after = bank.find_factor(bank.after, bank.after);
  RecordProperty("after", fmt::format("{:.4f} of {:.4f}", factors.at(1), after));
  EXPECT_NEAR(factors.at(1) / after, 1, band);
}

}  // namespace
}  // namespace talus
