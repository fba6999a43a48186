// SPDX-License-Identifier: MIT
// Samples by LEM: a published first-order estimate, bitwise identity for any number of threads, and factors on common
// surfaces against separate searches.

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "cases/sampling_slope.hpp"
#include "results/json.hpp"
#include "study/distributions.hpp"
#include "study/sampling.hpp"
#include "support/scratch.hpp"

namespace talus::study {
namespace {

using nlohmann::json;
using sampling_slope::deviations;

const std::string sample = "[study]\nmode = \"sample\"\n";

json run(const std::string& study, const std::string& name, int threads = 1,
         const std::vector<input::Override>& changes = {}) {
  StudyOptions options;
  options.folder = sampling_slope::make_folder(name);
  options.threads = threads;
  const SamplingResult result = run_sampling(sampling_slope::read(study, changes), changes, options);
  return results::to_json(result.study).at("sampling");
}

/// Hassan and Wolff's problem (1999); the numbers are an independent recomputation by Bishop's method with a search for
/// every evaluation. They publish β = 2.336 for a lognormal factor, another program 2.482.
TEST(SamplingSlices, FirstOrderEstimateIsThePublishedOne) {
  const json block = run(sample + "samples = 20\n" + deviations, "first_order");
  const json& first = block.at("first_order");
  EXPECT_NEAR(first.at("mean_factor").get<double>(), 1.3336, 0.003 * 1.3336);
  const std::map<std::string, double> change{
      {"cohesion", 0.1422}, {"friction_angle", 0.0754}, {"unit_weight", -0.0356}, {"pore_pressure_ratio", -0.0264}};
  for (const json& bar : block.at("tornado")) {
    const double half = 0.5 * (bar.at("high_factor").get<double>() - bar.at("low_factor").get<double>());
    EXPECT_NEAR(half, change.at(bar.at("name")), 0.002) << bar.at("name");
  }
  EXPECT_NEAR(first.at("deviation").get<double>(), 0.1669, 0.01 * 0.1669);
  EXPECT_NEAR(first.at("index_normal").get<double>(), 1.999, 0.02);
  EXPECT_NEAR(first.at("index_lognormal").get<double>(), 2.247, 0.025);
}

/// The interval of limit analysis is a note, for the means and for the design point.
TEST(SamplingSlices, MeansAndDesignPointAreComparedWithLimitAnalysis) {
  const json block = run(sample + "samples = 20\n" + deviations, "referee", 2, {{"lem.referee", "true"}});
  const std::string notes = block.at("notes").dump();
  for (const char* where : {"at the means", "at the design point"}) {
    const std::size_t at = notes.find(std::string("the factor ") + where + " lies between ");
    ASSERT_NE(at, std::string::npos) << notes;
    double lower = 0, upper = 0, factor = 0;
    const std::string sentence = notes.substr(notes.find("between ", at));
    ASSERT_EQ(std::sscanf(sentence.c_str(), "between %lf and %lf; the samples have %lf", &lower, &upper, &factor), 3);
    EXPECT_LT(lower, upper);
    EXPECT_GE(factor, 0.99 * lower) << where;
    EXPECT_LE(factor, 1.01 * upper) << where;
  }
  EXPECT_EQ(run(sample + "samples = 20\n" + deviations, "no_referee").at("notes").dump().find("Limit analysis"),
            std::string::npos);
}

/// Four ways to the probability of failure of one slope agree as far as they should.
TEST(SamplingSlices, IndicesAgreeAndTheQuickFactorsAreThoseOfSearches) {
  const json block = run(sample + "samples = 2000\n" + deviations, "indices", 2);
  const json& failure = block.at("failure");
  const double form = block.at("design_point").at("index");
  EXPECT_TRUE(block.at("design_point").at("converged").get<bool>());
  EXPECT_NEAR(block.at("design_point").at("factor").get<double>(), 1, 2e-3);
  EXPECT_LT(failure.at("index_lower").get<double>(), form + 0.1);  // the surface F = 1 is slightly bent
  EXPECT_GT(failure.at("index_upper").get<double>(), form - 0.1);
  EXPECT_NEAR(block.at("first_order").at("mean_factor").get<double>(), block.at("factor").at("mean").get<double>(),
              0.02);
  EXPECT_NEAR(block.at("first_order").at("deviation").get<double>(), block.at("factor").at("deviation").get<double>(),
              0.01);
  EXPECT_EQ(block.at("factor").at("none"), 0);
  EXPECT_GE(block.at("check").at("samples").get<int>(), 30);
  EXPECT_LT(block.at("check").at("largest").get<double>(), 0.01);
  EXPECT_GT(block.at("surfaces").get<int>(), 20);
  // Cohesion and friction hold, weight and pore pressure drive.
  for (const json& r : block.at("ranks")) {
    const bool holds = r.at("name") == "cohesion" || r.at("name") == "friction_angle";
    EXPECT_GT((holds ? 1 : -1) * r.at("coefficient").get<double>(), 0.1) << r.at("name");
  }
}

TEST(SamplingSlices, IdenticalForAnyThreadsAndOnlyForTheSameSeed) {
  const auto read = [](const std::string& name) {
    std::ifstream file(support::name_scratch(name) / "samples.csv");
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  const std::string study = sample + "samples = 120\n" + deviations;
  run(study, "one", 1);
  run(study, "three", 3);
  run(study, "other", 2, {{"study.seed", "2"}});
  const std::string one = read("one");
  EXPECT_EQ(std::count(one.begin(), one.end(), '\n'), 121);
  EXPECT_EQ(one, read("three"));
  EXPECT_NE(one, read("other"));
}

/// A Tresca soil is one without friction, sampled on the same surfaces and not searched anew for every sample.
TEST(SamplingSlices, TrescaHasTheFactorsOfFrictionlessSoil) {
  const auto write = [](const std::string& soil, const std::string& key) {
    std::string text = sampling_slope::write_case(sample + "samples = 40\n[[study.random]]\nkey = \"materials.soil." +
                                                  key + "\"\ndistribution = \"lognormal\"\nvariation = 0.2\n");
    const auto from = text.find("model ="), to = text.find("[analysis]");
    return text.replace(from, to - from, soil);
  };
  const auto calculate = [](const std::string& text, const std::string& name) {
    StudyOptions options;
    options.folder = sampling_slope::make_folder(name);
    options.threads = 1;
    const auto result = run_sampling(input::read_case_text(text, "clay.toml", {}), {}, options);
    return results::to_json(result.study).at("sampling");
  };
  const std::string weight = "unit_weight = 18\n", growing = "_gradient = 1.5\n";
  for (const char* uncertain : {"", "_gradient"}) {
    const std::string moduli = "young_modulus = \"10 MPa\"\npoisson_ratio = 0.49\n";
    const json tresca = calculate(write("model = \"tresca\"\nundrained_strength = 30\nundrained_level = 15\nundrained" +
                                            growing + weight + moduli,
                                        uncertain[0] ? "undrained_gradient" : "undrained_strength"),
                                  "tresca");
    const json frictionless =
        calculate(write("model = \"mohr_coulomb\"\ncohesion = 30\nfriction_angle = 0\ncohesion_level = 15\ncohesion" +
                            growing + weight,
                        uncertain[0] ? "cohesion_gradient" : "cohesion"),
                  "frictionless");
    EXPECT_GT(tresca.at("surfaces"), 0);
    EXPECT_GT(tresca.at("factor").at("deviation"), 0);
    for (const char* key : {"mean", "deviation", "count"})
      EXPECT_EQ(tresca.at("factor").at(key), frictionless.at("factor").at(key)) << key << uncertain;
  }
}

/// Bedding that no base is parallel to changes nothing, but its soil has a law, whose numbers come from a section of
/// its own for every sample.
TEST(SamplingSlices, ALawHasTheNumbersOfEverySample) {
  const auto calculate = [](bool has_law) {
    std::string text = sampling_slope::write_case(sample + "samples = 8\n" + deviations);
    const std::string plain = "model = \"mohr_coulomb\"\n";
    if (has_law)
      text.replace(
          text.find(plain), plain.size(),
          "model = \"bedding\"\nbedding_range = 0\nbedding_angle = -85\nbedding_cohesion = 0\nbedding_friction = 5\n");
    StudyOptions options;
    options.folder = sampling_slope::make_folder(has_law ? "law" : "no_law");
    options.threads = 1;
    const std::vector<input::Override> changes{{"lem.entry_exit.exits", "9"}, {"lem.entry_exit.entries", "9"}};
    const auto result = run_sampling(input::read_case_text(text, "law.toml", changes), changes, options);
    return results::to_json(result.study).at("sampling");
  };
  const json law = calculate(true), plain = calculate(false);
  EXPECT_NE(law.at("notes").dump().find("strength law"), std::string::npos);
  for (const char* key : {"mean", "deviation"})
    EXPECT_NEAR(law.at("factor").at(key).get<double>(), plain.at("factor").at(key).get<double>(), 0.01) << key;
  EXPECT_GT(law.at("factor").at("deviation"), 0.02);
}

/// A key of the section for LEM: every sample is searched anew, and a deeper crack never raises the factor here.
TEST(SamplingSlices, AKeyOfTheSectionIsSearchedSampleBySample) {
  const json block = run(sample + R"(samples = 6
[[study.random]]
key = "lem.tension_crack.depth"
distribution = "uniform"
lowest = "0.5 m"
highest = "3 m"
)",
                         "section", 2, {{"lem.entry_exit.exits", "9"}, {"lem.entry_exit.entries", "9"}});
  EXPECT_EQ(block.at("surfaces"), 0);
  EXPECT_TRUE(block.at("check").is_null());
  EXPECT_EQ(block.at("factor").at("count"), 6);
  EXPECT_LT(block.at("ranks")[0].at("coefficient").get<double>(), 0);
  EXPECT_NE(block.at("notes").dump().find("searched anew for every sample"), std::string::npos);
}

TEST(SamplingSlices, CorrelationIsThatOfTheCaseAndChangesTheAnswer) {
  const std::string correlation = R"(
[[study.correlation]]
keys = ["materials.soil.cohesion", "materials.soil.friction_angle"]
coefficient = )";
  const json against = run(sample + "samples = 1000\n" + deviations + correlation + "-0.7\n", "against", 2);
  const json with = run(sample + "samples = 1000\n" + deviations + correlation + "0.7\n", "with", 2);
  EXPECT_NEAR(against.at("correlations")[0].at("sampled").get<double>(), -0.7, 0.01);
  EXPECT_LT(against.at("failure").at("probability").get<double>(), with.at("failure").at("probability").get<double>());
  // σ_F² = Σ a² + 2 ρ a_c a_φ
  const double v = 0.1669 * 0.1669, cross = 2 * 0.7 * 0.1422 * 0.0754;
  EXPECT_NEAR(against.at("first_order").at("deviation").get<double>(), std::sqrt(v - cross), 0.003);
  EXPECT_NEAR(with.at("first_order").at("deviation").get<double>(), std::sqrt(v + cross), 0.003);
}

/// Areas are those of the slices themselves, whatever a crack or the limits of the search do with other unit weights.
TEST(SamplingSlices, KeepItsMassesUnderCracksAndLimits) {
  const std::string study = sample + "samples = 40\n" + deviations;
  const auto find = [&](const char* name, const std::vector<input::Override>& changes) {
    return run(study, name, 1, changes).at("factor").at("mean").get<double>();
  };
  const double free = find("free", {});
  EXPECT_NEAR(find("weight", {{"lem.smallest_weight", "5"}}), free, 1e-3 * free);
  for (const char* depth : {"0.4", "1.2", "5"}) {
    const double cracked = find((std::string("crack") + depth).c_str(), {{"lem.tension_crack.depth", depth}});
    EXPECT_GT(cracked, 0.8 * free) << depth;
    EXPECT_LT(cracked, 1.02 * free) << depth;
  }
}

TEST(SamplingSlices, ReportsUnsupportedSettings) {
  const std::string study = sample + "samples = 20\n" + deviations;
  StudyOptions options;
  options.folder = sampling_slope::make_folder("refused");
  const auto refuse = [&](const input::LoadedCase& loaded) {
    try {
      run_sampling(loaded, {}, options);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THROW(sampling_slope::read(study, {{"partial_factors.set", "DA1-2"}}), InputError);  // known when it is read
  EXPECT_EQ(refuse(sampling_slope::read(study)), "");
  EXPECT_NE(refuse(sampling_slope::read(study)).find("is not empty"), std::string::npos);
}

/// A normal cohesion near zero: no sample is negative, and a note states the probability that was cut.
TEST(SamplingSlices, NoSampleLeavesWhatItsKeyAllows) {
  const json block = run(sample + R"(samples = 200
[[study.random]]
key = "materials.soil.cohesion"
mean = "5 kPa"
deviation = "4 kPa"
)",
                         "cut");
  EXPECT_GE(block.at("numbers")[0].at("sampled").at("smallest").get<double>(), 0);
  EXPECT_NEAR(block.at("numbers")[0].at("sampled").at("mean").get<double>(),
              block.at("numbers")[0].at("mean").get<double>(), 0.02);
  EXPECT_GT(block.at("numbers")[0].at("mean").get<double>(), 5.3);
  EXPECT_NE(block.at("notes").dump().find("11 % of the distribution"), std::string::npos);
}

}  // namespace
}  // namespace talus::study
