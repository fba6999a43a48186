// SPDX-License-Identifier: MIT
// Saturated columns with storage by the compressibility of the skeleton, through the seepage of a [timeline]: a pool
// falls instantly, and the excess pressure drains at the top.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numbers>

#include "support/water_in_time.hpp"

namespace talus {
namespace {

constexpr double gamma_w = 9810, water_modulus = 2.2e9, porosity = 0.4;
constexpr double height = 10, fall = 10;  // of the column, and of the pool [m]
constexpr double p0 = gamma_w * fall;     // [Pa]
constexpr double band = 0.01;             // of p0

/// Conductivity [m/s], compressibility of the skeleton [1/Pa].
struct Soil {
  double k, m_v;
  double storage() const { return m_v + porosity / water_modulus; }  // (T24.1)
  double c_v() const { return k / (gamma_w * storage()); }
};

/// `upper` above `level` [m], `lower` below. The pool is 10 m above the ground and falls to it at time 0.
std::string write_column(const Soil& upper, const Soil& lower, double level, const std::vector<double>& times,
                         bool pool_loading = false) {
  std::string text = fmt::format(R"(
geometry.box = [[0, 0], [0.5, {0}]]
geometry.polygon = [{{ name = "lower", points = [[0, 0], [0.5, 0], [0.5, {1}], [0, {1}]] }},
                    {{ name = "upper", points = [[0, {1}], [0.5, {1}], [0.5, {0}], [0, {0}]] }}]
mesh.size = 0.2
regions = {{ lower = "lower", upper = "upper" }}
initial.pore_pressure = "seepage"
hydraulic = [{{ on = "top", condition = "total_head", head = [[0, {2}], [0, {0}]] }}]
timeline.duration = "{3} s"
timeline.times = [{4}]
timeline.pool_loading = {5}
analysis.methods = ["lem"]
lem.referee = false
)",
                                 height, level, height + fall, times.back(),
                                 [&] {
                                   std::string list;
                                   for (const double t : times) list += fmt::format("\"{} s\", ", t);
                                   return list;
                                 }(),
                                 pool_loading);
  for (const auto& [name, soil] : {std::pair("lower", lower), std::pair("upper", upper)})
    text += fmt::format(R"(
[materials.{0}]
model = "mohr_coulomb"
grain_density = 2650
porosity = {1}
cohesion = 5
friction_angle = 30
young_modulus = "20 MPa"
poisson_ratio = 0.3
[materials.{0}.water]
retention = "saturated"
conductivity = "{2} m/s"
compressibility = "{3} kPa-1"
)",
                        name, porosity, soil.k, 1e3 * soil.m_v);
  return text;
}

/// The largest difference of p/p0 from `series(z, t)`, z the depth [m], in eight depths.
template <class Series>
double find_error(const support::WaterInTime& water, const std::vector<double>& times, const Series& series) {
  double worst = 0;
  for (std::size_t i = 0; i < times.size(); ++i)
    for (const double z : {0.5, 1.0, 2.0, 3.0, 4.5, 6.0, 8.0, 10.0}) {
      const double excess = water.find(i + 1, {0.25, height - z}) - gamma_w * z;
      worst = std::max(worst, std::abs(excess / p0 - series(z, times[i])));
    }
  return worst;
}

/// Excess pressure over p0 of two layers, drained at the top and closed at the bottom: eigenfunctions sin(ωz/√c) above
/// and cos(ω(H-z)/√c) below, with pressure and flow continuous between them.
class TwoLayers {
 public:
  TwoLayers(const Soil& upper, const Soil& lower, double thickness)
      : upper_(upper), lower_(lower), h1_(thickness), h2_(height - thickness) {
    const double quarter = 0.5 * std::numbers::pi / (h1_ / std::sqrt(upper_.c_v()) + h2_ / std::sqrt(lower_.c_v()));
    const double step = quarter / 47.3;  // roots are about two quarters apart
    for (double a = step; roots_.size() < 200; a += step) {
      if (flow_jump(a) * flow_jump(a + step) > 0) continue;
      double low = a, high = a + step;
      for (int i = 0; i < 80; ++i) {
        const double middle = 0.5 * (low + high);
        (flow_jump(low) * flow_jump(middle) > 0 ? low : high) = middle;
      }
      roots_.push_back(low);
    }
  }

  double operator()(double z, double t) const {
    double sum = 0;
    for (const double root : roots_) {
      const double a1 = root / std::sqrt(upper_.c_v()), a2 = root / std::sqrt(lower_.c_v());
      // Amplitudes that join the pressures, or the flow where both pressures vanish.
      double above = std::cos(a2 * h2_), below = std::sin(a1 * h1_);
      if (std::abs(above) + std::abs(below) < 1e-3) {
        above = lower_.k / std::sqrt(lower_.c_v()) * std::sin(a2 * h2_);
        below = upper_.k / std::sqrt(upper_.c_v()) * std::cos(a1 * h1_);
      }
      const double s1 = upper_.storage(), s2 = lower_.storage();
      const double start = s1 * above * (1 - std::cos(a1 * h1_)) / a1 + s2 * below * std::sin(a2 * h2_) / a2;
      const double norm = s1 * above * above * (0.5 * h1_ - std::sin(2 * a1 * h1_) / (4 * a1)) +
                          s2 * below * below * (0.5 * h2_ + std::sin(2 * a2 * h2_) / (4 * a2));
      const double shape = z < h1_ ? above * std::sin(a1 * z) : below * std::cos(a2 * (height - z));
      sum += start / norm * shape * std::exp(-root * root * t);
    }
    return sum;
  }

 private:
  double flow_jump(double root) const {
    const double r1 = std::sqrt(upper_.c_v()), r2 = std::sqrt(lower_.c_v()), a1 = root * h1_ / r1, a2 = root * h2_ / r2;
    return upper_.k / r1 * std::cos(a1) * std::cos(a2) - lower_.k / r2 * std::sin(a1) * std::sin(a2);
  }

  Soil upper_, lower_;
  double h1_, h2_;
  std::vector<double> roots_;  ///< ω, whose decay is ω² [1/s]
};

double find_terzaghi(double z, double time_factor) {
  double sum = 0;
  for (int m = 0; m < 200; ++m) {
    const double a = 0.5 * std::numbers::pi * (2 * m + 1);
    sum += 2 / a * std::sin(a * z / height) * std::exp(-a * a * time_factor);
  }
  return sum;
}

TEST(TimelineConsolidation, AColumnIsTerzaghis) {
  const Soil soil{1e-8, 1e-7};
  std::vector<double> times;
  for (const double t : {0.02, 0.05, 0.1, 0.2, 0.5, 1.0}) times.push_back(t * height * height / soil.c_v());
  const support::WaterInTime water(write_column(soil, soil, 4, times));
  for (const double z : {1.0, 5.0, 9.0}) EXPECT_NEAR(water.find(0, {0.25, height - z}) - gamma_w * z, p0, 1e-6 * p0);
  const double error = find_error(
      water, times, [&](double z, double t) { return find_terzaghi(z, t * soil.c_v() / (height * height)); });
  RecordProperty("error", fmt::format("{:.5f}", error));
  EXPECT_LT(error, band);
}

// The pool takes its weight with it: B = m_v / (m_v + n / K_w) of the pressure goes at once, and the rest drains.
TEST(TimelineConsolidation, APoolThatLoadsTheSoilLeavesWhatTheWaterBears) {
  for (const double m_v : {1e-7, 1e-10}) {
    const Soil soil{1e-8, m_v};
    const double fraction = 1 - m_v / soil.storage();
    std::vector<double> times;
    for (const double t : {0.02, 0.05, 0.1, 0.2, 0.5, 1.0}) times.push_back(t * height * height / soil.c_v());
    const support::WaterInTime water(write_column(soil, soil, 4, times, true));
    const double error = find_error(water, times, [&](double z, double t) {
      return fraction * find_terzaghi(z, t * soil.c_v() / (height * height));
    });
    RecordProperty(fmt::format("error_{}", m_v), fmt::format("{:.5f}, share {:.4f}", error, fraction));
    EXPECT_LT(error, band);
  }
}

TEST(TimelineConsolidation, TwoLayersDrainByTheirEigenfunctions) {
  const Soil quick{1e-8, 3e-7}, slow{1e-9, 1e-7};  // factors of 10 and 3
  for (const auto& [upper, lower] : {std::pair(quick, slow), std::pair(slow, quick)}) {
    const double thickness = 4;
    const TwoLayers series(upper, lower, thickness);
    // The series itself: one layer is Terzaghi's, and at the start the pressure is p0 everywhere but near its drain.
    const TwoLayers same(upper, upper, thickness);
    const double whole = thickness * thickness / upper.c_v() + 36 / lower.c_v();
    EXPECT_NEAR(same(7, 0.2 * height * height / upper.c_v()), find_terzaghi(7, 0.2), 1e-9);
    EXPECT_NEAR(series(7, 1e-3 * whole), 1, 1e-3);
    std::vector<double> times;
    for (const double t : {0.02, 0.05, 0.1, 0.2, 0.5, 1.0}) times.push_back(t * whole);
    const support::WaterInTime water(write_column(upper, lower, height - thickness, times));
    const double error = find_error(water, times, series);
    RecordProperty(upper.k > lower.k ? "error_quick_above" : "error_slow_above", fmt::format("{:.5f}", error));
    EXPECT_LT(error, band);
  }
}

}  // namespace
}  // namespace talus
