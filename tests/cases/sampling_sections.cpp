// SPDX-License-Identifier: MIT
// Sections of samples, made without reading the case again, equal those of the case when it is read again.

#include <gtest/gtest.h>

#include "cases/sampling_slope.hpp"
#include "run/common/section_of_case.hpp"
#include "study/sampling.hpp"
#include "study/slice_factor.hpp"

namespace talus::study {
namespace {

/// Two soils over a water table: one by grains and pores, one by its unit weights.
const std::string text = R"(
[[geometry.polygon]]
name = "fill"
points = [[0, 6], [26, 6], [14, 12], [0, 12]]
[[geometry.polygon]]
name = "ground"
points = [[0, 0], [44, 0], [44, 6], [0, 6]]
[regions]
fill = "fill"
ground = "clay"
[materials.fill]
model = "mohr_coulomb"
grain_density = 2650
porosity = 0.35
cohesion = "4 kPa"
friction_angle = "30 deg"
[materials.clay]
model = "mohr_coulomb"
unit_weight = "18 kN/m3"
saturated_unit_weight = "26 kN/m3"
cohesion = "20 kPa"
friction_angle = "20 deg"
cohesion_gradient = "1 kPa/m"
cohesion_level = "6 m"
[initial]
pore_pressure = "water_table"
water_table = [[0, 8], [26, 5], [44, 5]]
[earthquake]
horizontal = 0.05
[analysis]
methods = ["lem"]
[study]
mode = "sample"
samples = 12
)";

std::string list_numbers(const std::vector<std::string>& keys) {
  std::string list;
  for (const std::string& key : keys)
    list += "[[study.random]]\nkey = \"" + key + "\"\ndistribution = \"lognormal\"\nvariation = 0.1\n";
  return list;
}

TEST(SamplingSections, AreThoseOfTheCaseWithTheseValues) {
  const std::vector<std::string> keys{
      "materials.fill.grain_density",     "materials.fill.cohesion", "materials.fill.friction_angle",
      "materials.clay.unit_weight",       "materials.clay.cohesion", "materials.clay.saturated_unit_weight",
      "materials.clay.cohesion_gradient", "earthquake.horizontal",   "materials.clay.cohesion_level"};
  const input::LoadedCase base = input::read_case_text(text + list_numbers(keys), "two_soils.toml");
  const SampleSet set = draw_samples(base);
  const SliceNumbers numbers(base, {}, set.sampled);
  EXPECT_FALSE(numbers.changes_section());
  for (std::size_t i = 0; i < set.size(); ++i) {
    const std::vector<double> values = set.get_sample(i);
    const lem::Section quick = numbers.make_section(values);
    const lem::Section read = run::make_section(read_sample(base, {}, set.sampled, values).data).section;
    ASSERT_EQ(quick.soils.size(), read.soils.size());
    EXPECT_NEAR(quick.horizontal_acceleration, read.horizontal_acceleration, 1e-15);
    for (std::size_t s = 0; s < quick.soils.size(); ++s) {
      const lem::Soil &a = quick.soils[s], &b = read.soils[s];
      EXPECT_NEAR(a.unit_weight, b.unit_weight, 1e-9 * b.unit_weight) << a.name;
      EXPECT_NEAR(a.saturated_unit_weight, b.saturated_unit_weight, 1e-9 * b.saturated_unit_weight) << a.name;
      EXPECT_NEAR(a.cohesion, b.cohesion, 1e-9 * b.cohesion) << a.name;
      EXPECT_NEAR(a.friction_angle, b.friction_angle, 1e-12) << a.name;
      EXPECT_NEAR(a.cohesion_gradient, b.cohesion_gradient, 1e-9 * 1000) << a.name;
      EXPECT_NEAR(a.cohesion_level, b.cohesion_level, 1e-9) << a.name;
    }
  }
}

TEST(SamplingSections, IdentifyKeysThatChangeMoreThanSoils) {
  const auto sort = [](const std::vector<std::string>& keys) {
    const input::LoadedCase base = input::read_case_text(text + list_numbers(keys), "two_soils.toml");
    const SampledNumbers sampled = read_sampled_numbers(base);
    const SliceNumbers numbers(base, {}, sampled);
    return numbers.section_keys();
  };
  EXPECT_TRUE(sort({"materials.fill.grain_density"}).empty());
  // With the porosity, weights are no longer linear in each number.
  EXPECT_EQ(sort({"materials.fill.grain_density", "materials.fill.porosity"}).size(), 2u);
}

}  // namespace
}  // namespace talus::study
