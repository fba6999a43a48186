// SPDX-License-Identifier: MIT
// Input of pore water: units, time series, hydraulic laws of the soil.

#include <cmath>
#include <limits>

#include "input/case/soil_water_law.hpp"
#include "wet_slope.hpp"

namespace talus::input {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Case read(const std::string& text) {
  return read_case_text(text, "slope.toml").data;
}

/// The wet slope with rain on its crest.
std::string rain(const std::string& keys) {
  return change(wet_slope, "on = \"crest\"\ncondition = \"seepage_face\"",
                "on = \"crest\"\ncondition = \"rain\"\n" + keys);
}

std::string soil(const std::string& keys) {
  return change(wet_slope,
                "retention = \"van_genuchten\"\nminimum_saturation = 0.15\nreference_pressure = 6.13\nlambda = "
                "0.27\npermeability = 6e-11",
                keys);
}

const PoreWater& water_of(const Case& data) {
  return data.materials.at("sand").water;
}

TEST(WetSlope, HasTheNumbersOfTheSource) {
  const Case data = read(wet_slope);
  const PoreWater& water = water_of(data);
  EXPECT_DOUBLE_EQ(data.water.bulk_modulus, 8e7);
  EXPECT_DOUBLE_EQ(data.water.viscosity, 1e-3);
  EXPECT_DOUBLE_EQ(data.water.density, 1000);
  // Printed: k = 5.89e-4 m/s from κ = 6e-11 m²; S = 0.52 at the suction of the crest, 56 kPa.
  EXPECT_NEAR(find_saturated_conductivity(water, data.water, 9.81), 5.886e-4, 1e-10);
  EXPECT_NEAR(material::saturation(make_retention(water), 56e3), 0.5203, 5e-5);
  EXPECT_EQ(material::find_relative_conductivity(make_relative_conductivity(water),
                                                 material::find_water(make_retention(water), 56e3))
                .value,
            1);
  ASSERT_EQ(data.hydraulics.size(), 4u);
  EXPECT_EQ(data.hydraulics[0].condition, WaterCondition::total_head);
  EXPECT_EQ(data.hydraulics[0].values().at(7), 10);
  EXPECT_EQ(data.hydraulics[3].on, "toe");
  EXPECT_EQ(data.hydraulics[3].values().at(0), 5);
  EXPECT_EQ(data.initial.water.pressure, InitialPressure::seepage);
  EXPECT_DOUBLE_EQ(data.stages.at(0).step.conductivity_factor, 2);
}

TEST(DryCase, HasNoWater) {
  const Case data = read(slope);
  EXPECT_FALSE(water_of(data).is_wet());
  EXPECT_TRUE(data.hydraulics.empty());
  EXPECT_EQ(data.initial.water.pressure, InitialPressure::zero);
}

TEST(Steps, OfTheFrozenFactorHoldTheWater) {
  const StrengthReduction reduction = read(wet_slope).strength_reduction;
  EXPECT_EQ(reduction.frozen.step_settings.water, WaterMotion::held);
  EXPECT_EQ(reduction.curve.step_settings.water, WaterMotion::seeps);
  EXPECT_EQ(Stage().step.water, WaterMotion::seeps);
}

TEST(Steps, TakeTheKeysOfWater) {
  const StepSettings step = read(change(wet_slope, "conductivity_factor = 2",
                                        "drag = \"explicit\"\ndamped_force = \"without_drag\"\npressure_smoothing = "
                                        "true\nconductivity_factor = 10\ngeometry = \"frozen\"\nwater = \"held\""))
                                .stages.at(0)
                                .step;
  EXPECT_EQ(step.drag, Drag::explicit_at_nodes);
  EXPECT_EQ(step.damped_force, DampedForce::without_drag);
  EXPECT_TRUE(step.pressure_smoothing);
  EXPECT_EQ(step.conductivity_factor, 10);
  EXPECT_EQ(step.water, WaterMotion::held);
}

TEST(Rain, IsGivenInMillimetresAnHourOrWithAUnit) {
  const double ten = 0.010 / 3600;
  EXPECT_DOUBLE_EQ(read(rain("rate = 10")).hydraulics.at(1).values().at(5), ten);
  EXPECT_DOUBLE_EQ(read(rain("rate = \"10 mm/h\"")).hydraulics.at(1).values().at(5), ten);
  EXPECT_DOUBLE_EQ(read(rain("rate = \"240 mm/day\"")).hydraulics.at(1).values().at(5), ten);
  EXPECT_DOUBLE_EQ(read(rain("rate = \"1e-6 m/s\"")).hydraulics.at(1).values().at(5), 1e-6);
  const Hydraulic evaporation =
      read(rain("rate = \"-5 mm/day\"\nsuction_limit = 100\nrain = \"normal\"")).hydraulics[1];
  EXPECT_DOUBLE_EQ(evaporation.values().at(0), -0.005 / 86400);
  EXPECT_DOUBLE_EQ(evaporation.suction_limit, 1e5);
  EXPECT_EQ(evaporation.rain, RainDirection::normal);
  EXPECT_EQ(read(rain("rate = 1")).hydraulics[1].suction_limit, infinity);
}

TEST(Series, OfStepsIsAHyetograph) {
  const TimeTable rate =
      read(rain("rate = [[0, 3.6], [\"1 h\", \"7.2 mm/h\"], [7200, 0]]\nseries = \"steps\"")).hydraulics.at(1).values();
  EXPECT_DOUBLE_EQ(rate.at(0), 1e-6);
  EXPECT_DOUBLE_EQ(rate.at(3599.9), 1e-6);
  EXPECT_DOUBLE_EQ(rate.at(3600), 2e-6) << "the second value holds from the jump on";
  EXPECT_DOUBLE_EQ(rate.at(7199.9), 2e-6);
  EXPECT_DOUBLE_EQ(rate.at(7200), 0);
  EXPECT_DOUBLE_EQ(rate.at(1e9), 0);
}

TEST(Series, IsLinearWithJumpsBetweenItsRows) {
  const TimeTable head = read(change(wet_slope, "head = 10", "head = [[0, 10], [10, \"800 cm\"], [10, 6], [20, 5]]"))
                             .hydraulics.at(0)
                             .values();
  EXPECT_DOUBLE_EQ(head.at(-1), 10);
  EXPECT_DOUBLE_EQ(head.at(5), 9);
  EXPECT_DOUBLE_EQ(head.at(10), 6);
  EXPECT_DOUBLE_EQ(head.at(15), 5.5);
  EXPECT_DOUBLE_EQ(head.at(25), 5);
}

TEST(TimeTable, JumpsAtItsEndsToo) {
  const TimeTable table{{0, 0, 1, 1}, {1, 2, 3, 4}};
  EXPECT_EQ(table.at(-1e-9), 1);
  EXPECT_EQ(table.at(0), 2);
  EXPECT_DOUBLE_EQ(table.at(0.5), 2.5);
  EXPECT_EQ(table.at(1), 4);
}

TEST(Series, OfConditionsWithoutAValueIsZero) {
  EXPECT_EQ(read(wet_slope).hydraulics.at(1).values().at(3), 0) << "an empty table would be 1";
}

TEST(Pressure, KeepsTheSignOfEngineers) {
  const Case data = read(change(wet_slope, "condition = \"total_head\"\nhead = 10",
                                "condition = \"pressure\"\npressure = [[0, -20], [5, \"0.01 MPa\"]]"));
  EXPECT_DOUBLE_EQ(data.hydraulics.at(0).values().at(0), -2e4);
  EXPECT_DOUBLE_EQ(data.hydraulics.at(0).values().at(5), 1e4);
}

TEST(Conductivity, IsProportionalToGravity) {
  const Case data = read(soil("retention = \"saturated\"\nconductivity = \"1e-3 cm/s\""));
  EXPECT_DOUBLE_EQ(find_saturated_conductivity(water_of(data), data.water, data.water.drag_gravity), 1e-5);
  EXPECT_DOUBLE_EQ(find_saturated_conductivity(water_of(data), data.water, 15 * 9.81), 15e-5);
  const Case tight = read(wet_slope);
  EXPECT_DOUBLE_EQ(find_saturated_conductivity(water_of(tight), tight.water, 15 * 9.81), 15 * 5.886e-4);
}

TEST(Soil, WithALinearCurve) {
  const Case data =
      read(soil("retention = \"linear\"\nminimum_saturation = 0.2\nmaximum_saturation = 0.9\ndry_suction = \"70 kPa\"\n"
                "conductivity = 1e-6\nrelative_conductivity = \"hillel\"\nexponent = 3\nmeasure = \"effective\""));
  const auto water = material::find_water(make_retention(water_of(data)), 35e3);
  EXPECT_DOUBLE_EQ(water.saturation, 0.55);
  EXPECT_DOUBLE_EQ(water.slope, -1e-5);
  EXPECT_NEAR(material::find_relative_conductivity(make_relative_conductivity(water_of(data)), water).value, 0.125,
              1e-12);
}

TEST(Soil, WithExponentialLaws) {
  const Case data = read(
      soil("retention = \"exponential\"\ndecay = 0.1\nconductivity = 1e-6\nrelative_conductivity = \"exponential\""));
  EXPECT_DOUBLE_EQ(water_of(data).decay, 1e-4);
  const auto water = material::find_water(make_retention(water_of(data)), 20e3);
  EXPECT_NEAR(water.saturation, std::exp(-2.0), 1e-14);
  EXPECT_NEAR(material::find_relative_conductivity(make_relative_conductivity(water_of(data)), water).value,
              std::exp(-2.0), 1e-14);
  EXPECT_DOUBLE_EQ(water_of(read(soil("retention = \"exponential\"\ndecay = \"0.1 MPa-1\"\nconductivity = 1"))).decay,
                   1e-7);
}

TEST(Soil, WithMeasuredCurves) {
  const Case data =
      read(soil("retention = \"table\"\nretention_table = [[0, 0.98], [\"10 kPa\", 0.8], [\"0.1 MPa\", 0.3]]\n"
                "conductivity = 1e-6\nrelative_conductivity = \"table\"\nconductivity_table = [[0, 1], [100, 1e-4]]"));
  const auto curve = make_retention(water_of(data));
  EXPECT_DOUBLE_EQ(material::saturation(curve, 0.0), 0.98);
  EXPECT_DOUBLE_EQ(material::saturation(curve, 10e3), 0.8);
  EXPECT_DOUBLE_EQ(material::saturation(curve, 1e6), 0.3);
  const auto middle = material::find_water(curve, 50e3);
  EXPECT_NEAR(material::find_relative_conductivity(make_relative_conductivity(water_of(data)), middle).value, 1e-2,
              1e-12)
      << "the logarithm is joined";
}

TEST(Soil, OfMualemTakesAnAirEntry) {
  const Case data = read(change(wet_slope, "lambda = 0.27",
                                "lambda = 0.27\nrelative_conductivity = \"mualem\"\nmeasure = "
                                "\"effective\"\nair_entry = 2"));
  const auto curve = make_retention(water_of(data));
  const auto law = make_relative_conductivity(water_of(data));
  EXPECT_DOUBLE_EQ(material::find_relative_conductivity(law, material::find_water(curve, 2e3)).value, 1);
  // Beyond it (4.16) over its value at the entry, with X = S_e.
  const auto mualem = [](double x) {
    return std::sqrt(x) * std::pow(1 - std::pow(1 - std::pow(x, 1 / 0.27), 0.27), 2);
  };
  const auto share = [&](double s) { return material::find_water(curve, s).effective; };
  EXPECT_NEAR(material::find_relative_conductivity(law, material::find_water(curve, 20e3)).value,
              mualem(share(20e3)) / mualem(share(2e3)), 1e-10);
}

TEST(Start, FromAWaterTable) {
  const Case data = read(change(wet_slope, "pore_pressure = \"seepage\"",
                                "pore_pressure = \"water_table\"\nwater_table = [[0, 10], [\"3200 cm\", 5]]\n"
                                "largest_suction = 30"));
  ASSERT_EQ(data.initial.water.water_table.size(), 2u);
  EXPECT_DOUBLE_EQ(data.initial.water.water_table[1][0], 32);
  EXPECT_DOUBLE_EQ(data.initial.water.largest_suction, 3e4);
  EXPECT_EQ(InitialWater().largest_suction, infinity);
}

TEST(Overrides, ReachTheWaterOfAMaterialAndACondition) {
  const Case data = read_case_text(wet_slope, "slope.toml",
                                   {{"materials.sand.water.permeability", "1e-12"},
                                    {"hydraulic.left.head", "9 m"},
                                    {"hydraulic.toe.head", "[[0, 5], [10, 7]]"}})
                        .data;
  EXPECT_DOUBLE_EQ(*water_of(data).permeability, 1e-12);
  EXPECT_DOUBLE_EQ(data.hydraulics.at(0).values().at(0), 9);
  EXPECT_DOUBLE_EQ(data.hydraulics.at(3).values().at(5), 6);
}

TEST(Echo, HasTheWaterWithItsUnits) {
  using nlohmann::json;
  const json echo = read_case_text(rain("rate = [[0, \"1e-5 m/s\"], [\"1 h\", 0]]"), "slope.toml").echo.get();
  const json& water = echo["materials"]["sand"]["water"];
  EXPECT_EQ(water["reference_pressure"], (json{{"value", 6.13}, {"unit", "kPa"}, {"given", true}}));
  EXPECT_EQ(water["permeability"]["unit"], "m2");
  EXPECT_FALSE(water.contains("decay")) << "no exponential law here";
  EXPECT_EQ(echo["hydraulic"][1]["rate"]["value"], (json::array({{0.0, 36.0}, {3600.0, 0.0}})));
  EXPECT_EQ(echo["hydraulic"][1]["rate"]["unit"], "mm/h");
  EXPECT_EQ(echo["hydraulic"][0]["head"], (json{{"value", 10.0}, {"unit", "m"}, {"given", true}}));
  EXPECT_FALSE(echo["hydraulic"][2].contains("series"));
  EXPECT_EQ(echo["initial"]["pore_pressure"]["value"], "seepage");
  EXPECT_EQ(echo["water"]["bulk_modulus"]["value"], 80000.0);
}

TEST(Documents, HaveTheBlockWithinAMaterial) {
  EXPECT_NE(write_manual().find("## `[materials.NAME.water]`"), std::string::npos);
  EXPECT_NE(write_manual().find("\n[materials.sand.water]\n"), std::string::npos) << "in the example";
  EXPECT_NE(write_manual().find("required where `retention = \"van_genuchten\" or relative_conductivity = \"mualem\"`"),
            std::string::npos);
  EXPECT_NE(write_template().find("\n[materials.sand.water]\n"), std::string::npos);
  const auto schema = write_schema();
  const auto& water = schema["properties"]["materials"]["additionalProperties"]["properties"]["water"];
  EXPECT_EQ(water["properties"]["retention"]["default"], "dry");
  EXPECT_FALSE(water["additionalProperties"].get<bool>());
  const auto& rate = schema["properties"]["hydraulic"]["items"]["properties"]["rate"]["anyOf"];
  ASSERT_EQ(rate.size(), 4u) << "a number, a text, rows, or a file";
  EXPECT_EQ(rate[2]["items"]["prefixItems"].size(), 2u);
}

TEST(WeightStage, OfWetSoilIsDrainedByDefault) {
  const std::string rest =
      change(wet_slope, "damping = 0.7\nconductivity_factor = 2", "damping = 0.7\nuntil = \"rest\"");
  const auto read_first = [](const std::string& text, const std::vector<Override>& changes = {}) {
    return read_case_text(text, "wet.toml", changes).data.stages.at(0).step;
  };
  EXPECT_EQ(read_first(rest).water, WaterMotion::held);
  EXPECT_EQ(read_first(rest).geometry, Geometry::frozen);
  EXPECT_EQ(read(rest + "[[stage]]\nname = \"rain\"\nduration = 5\nuntil = \"rest\"\n").stages.at(1).step.water,
            WaterMotion::seeps)
      << "only the first stage brings weight";
  for (const auto& [key, value] : std::vector<Override>{{"stage.0.water", "seeps"},
                                                        {"stage.0.geometry", "moving"},
                                                        {"stage.0.conductivity_factor", "1"},
                                                        {"initial.stress", "k0"},
                                                        {"stage.0.until", "time"}}) {
    EXPECT_EQ(read_first(rest, {{key, value}}).water, WaterMotion::seeps) << key;
    EXPECT_EQ(read_first(rest, {{key, value}}).geometry, Geometry::moving) << key;
  }
  EXPECT_EQ(read_first(slope).water, WaterMotion::seeps) << "dry soil";
}

/// n = 1/(1 - λ) below 2: the slope of k_r at saturation is infinite.
TEST(SeepageOverTime, HasAnAirEntryWhereMualemsCurveNeedsOne) {
  PoreWater soil;
  soil.retention = RetentionCurve::van_genuchten;
  soil.relative_conductivity = ConductivityCurve::mualem;
  soil.lambda = 0.36;
  EXPECT_DOUBLE_EQ(add_air_entry(soil).air_entry.value_or(-1), 200);
  soil.air_entry = 1000;
  EXPECT_DOUBLE_EQ(add_air_entry(soil).air_entry.value_or(-1), 1000) << "as given";
  soil.air_entry = 0;
  EXPECT_DOUBLE_EQ(add_air_entry(soil).air_entry.value_or(-1), 0) << "none, as asked for";
  soil.air_entry.reset();
  soil.lambda = 0.5;
  EXPECT_FALSE(add_air_entry(soil).air_entry);
  soil.lambda = 0.36;
  soil.relative_conductivity = ConductivityCurve::constant;
  EXPECT_FALSE(add_air_entry(soil).air_entry);
}

}  // namespace
}  // namespace talus::input
