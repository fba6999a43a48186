// SPDX-License-Identifier: MIT
// Strength laws of LEM against moment integrals over circles, published slopes, and Mohr–Coulomb soil where they
// coincide with it; undrained strengths by profile and stress history in all methods.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "support/run_json.hpp"
#include "support/scratch.hpp"

namespace talus {
namespace {

class StrengthLaws : public testing::Test {
 protected:
  nlohmann::json run(const std::string& text) {
    run::RunOptions options;
    options.folder = folder_ / "run";
    options.overwrite = true;
    return support::run_case(input::read_case_text(text, (folder_ / "slope.toml").string()), options);
  }
  double find_critical(const std::string& text) {
    const nlohmann::json summary = run(text);
    const nlohmann::json& critical = summary.at("lem").at("critical");
    return critical.empty() ? 0 : critical[0].at("factor").get<double>();
  }
  /// Factors of the first given surface by all methods.
  std::vector<double> list_given(const std::string& text) {
    const nlohmann::json summary = run(text);
    std::vector<double> factors;
    for (const nlohmann::json& given : summary.at("lem").at("given"))
      factors.push_back(given.at("factor").get<double>());
    return factors;
  }
  const std::filesystem::path folder_ = support::make_scratch("strength_laws");
};

std::string write_circle(double x, double y, double radius) {
  return fmt::format(R"(
lem.search = "none"
lem.referee = false
lem.slices = 400
lem.surface = [{{ name = "circle", centre = [{}, {}], radius = {} }}]
)",
                     x, y, radius);
}

/// A slope of 1:2, 10 m high; `soil` gives its strength.
std::string write_undrained(const std::string& soil, bool deep, bool wet = false) {
  return R"(
analysis.methods = ["lem"]
lem.methods = ["fellenius", "bishop", "spencer"]
geometry.polygon = [{ name = "clay", points = [[-60, -10], [90, -10], [90, 10], [20, 10], [0, 0], [-60, 0]] }]
regions.clay = "clay"
)" +
         (wet ? std::string(
                    "initial = { pore_pressure = \"water_table\", water_table = [[-60, 0], [0, 0], [20, 10], [90, "
                    "10]] }\n")
              : "") +
         (deep ? write_circle(9, 16, 22) : write_circle(8, 18, 19.697715603592)) +
         "[materials.clay]\nunit_weight = 18\n" + soil;
}

std::string write_shansep(double added, double ocr) {
  return fmt::format(
      "model = \"shansep\"\nstrength_ratio = 0.22\nstrength_exponent = 0.8\nadded_strength = {}\nocr = {}\n", added,
      ocr);
}

TEST_F(StrengthLaws, ShansepOnCirclesIsTheMomentIntegral) {
  // Without friction the moment factor of a circle is R ∫ s_u ds over Σ W x, here by quadrature with 40,000 points.
  struct Known {
    double added, ocr;
    bool wet, deep;
    double factor;
  };
  for (const Known& k : std::initializer_list<Known>{{0, 1, false, false, 0.80603},
                                                     {0, 2, false, false, 1.40338},
                                                     {5, 2, false, false, 1.59872},
                                                     {5, 2, true, false, 0.83388},
                                                     {0, 1, false, true, 1.05856},
                                                     {0, 2, false, true, 1.84307},
                                                     {5, 2, false, true, 2.01523},
                                                     {5, 2, true, true, 1.01076}}) {
    const auto factors = list_given(write_undrained(write_shansep(k.added, k.ocr), k.deep, k.wet));
    ASSERT_EQ(factors.size(), 3u);
    for (const double factor : factors) EXPECT_NEAR(factor, k.factor, 5e-4 * k.factor) << k.added << " " << k.ocr;
  }
}

TEST_F(StrengthLaws, PreconsolidationIsTheOcrThatItGives) {
  // σ'_p = 2 σ'_v under level ground: 18 kPa/m times the depth.
  const std::string level = R"(
analysis.methods = ["lem"]
lem.methods = ["spencer"]
geometry.polygon = [{ name = "clay", points = [[-60, -10], [90, -10], [90, 10], [0, 10], [0, 0], [-60, 0]] }]
regions.clay = "clay"
)" + write_circle(-3, 16, 16.5) +
                            "[materials.clay]\nunit_weight = 18\nmodel = \"shansep\"\nstrength_ratio = 0.22\n"
                            "strength_exponent = 0.8\n";
  const auto one = list_given(level + "ocr = 2\n"),
             other = list_given(level + "profile_depths = [0, 40]\nprofile_preconsolidation = [1e-9, \"1440 kPa\"]\n"),
             places = list_given(level + "profile_levels = [5, 0]\nprofile_ocr = [2, 2]\n");
  ASSERT_EQ(one.size(), 1u);
  EXPECT_NEAR(other.at(0), one[0], 1e-9);
  EXPECT_NEAR(places.at(0), one[0], 1e-12);
}

TEST_F(StrengthLaws, ProfilesOnCirclesAreTheMomentIntegral) {
  const std::string tresca = "model = \"tresca\"\n";
  for (const double factor :
       list_given(write_undrained(tresca + "profile_depths = [3]\nprofile_strengths = [40]\n", true)))
    EXPECT_NEAR(factor, 1.37731, 5e-4 * 1.37731);
  for (const double factor :
       list_given(write_undrained(tresca + "profile_levels = [10, -10]\nprofile_strengths = [20, 60]\n", true)))
    EXPECT_NEAR(factor, 1.49312, 5e-4 * 1.49312);
}

std::string write_adp(double base, const std::string& surface, bool mirrored) {
  const auto points = [&](std::vector<std::array<double, 2>> list) {
    std::string text;
    for (const auto& p : list)
      text += fmt::format("{}[{}, {}]", text.empty() ? "" : ", ", mirrored ? -p[0] : p[0], p[1]);
    return text;
  };
  return fmt::format(
      R"(
analysis.methods = ["lem"]
lem.methods = ["fellenius", "bishop"]
geometry.polygon = [{{ name = "clay", points = [{}] }}]
regions.clay = "clay"
{}
[materials.clay]
unit_weight = 20
model = "adp"
undrained_strength = 40
direct_ratio = 0.63
passive_ratio = 0.35
)",
      points(base < 0 ? std::vector<std::array<double, 2>>{{-50, base}, {60, base}, {60, 5}, {5, 5}, {0, 0}, {-50, 0}}
                      : std::vector<std::array<double, 2>>{{0, 0}, {60, 0}, {60, 5}, {5, 5}}),
      surface);
}

TEST_F(StrengthLaws, AdpOnCirclesIsTheMomentIntegral) {
  struct Known {
    double base, x, y, radius, factor;
  };
  for (const Known& k : std::initializer_list<Known>{
           {-10, 2.438, 11.768, 21.768, 1.559}, {-2.5, 2.516, 7.449, 9.949, 1.745}, {0, 1.891, 8.112, 8.112, 2.104}}) {
    const auto factors = list_given(write_adp(k.base, write_circle(k.x, k.y, k.radius), false));
    const auto mirrored = list_given(write_adp(k.base, write_circle(-k.x, k.y, k.radius), true));
    ASSERT_EQ(factors.size(), 2u);
    ASSERT_EQ(mirrored.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_NEAR(factors[i], k.factor, 1e-3 * k.factor) << k.base;
      EXPECT_NEAR(mirrored[i], factors[i], 1e-9);
    }
  }
}

std::string write_frictional(const std::string& soil) {
  return R"(
analysis.methods = ["lem"]
lem.methods = ["fellenius", "bishop", "janbu", "spencer", "morgenstern_price"]
geometry.polygon = [{ name = "soil", points = [[0, 0], [50, 0], [50, 12], [30, 12], [12, 2], [0, 2]] }]
regions.soil = "soil"
initial = { pore_pressure = "water_table", water_table = [[0, 2], [12, 2], [50, 8]] }
)" + write_circle(17, 22, 21) +
         "[materials.soil]\nunit_weight = 19\n" + soil;
}

TEST_F(StrengthLaws, LawsThatCoincideWithMohrCoulombHaveItsFactors) {
  const auto expected = list_given(write_frictional("model = \"mohr_coulomb\"\ncohesion = 8\nfriction_angle = 30\n"));
  ASSERT_EQ(expected.size(), 5u);
  for (const char* soil :
       {"model = \"power_curve\"\npower_factor = 0.5773502691896258\npower_exponent = 1\npower_cohesion = 8\n",
        "model = \"strength_table\"\nnormal_stresses = [0, 50, 100]\nshear_strengths = [8, 36.86751345948129, "
        "65.73502691896258]\n",
        "model = \"anisotropic\"\nbase_inclinations = [-30, 10]\ninclined_cohesions = [8, 8]\ninclined_frictions = "
        "[30, "
        "30]\n",
        "model = \"bedding\"\ncohesion = 8\nfriction_angle = 30\nbedding_angle = 20\nbedding_cohesion = "
        "8\nbedding_friction = 30\nbedding_range = 10\nbedding_transition = 40\n"}) {
    const auto factors = list_given(write_frictional(soil));
    ASSERT_EQ(factors.size(), expected.size()) << soil;
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(factors[i], expected[i], 1e-8) << soil << i;
  }
  const auto loose = list_given(write_frictional("model = \"mohr_coulomb\"\ncohesion = 0\nfriction_angle = 30\n")),
             joint = list_given(write_frictional("model = \"barton_bandis\"\njoint_roughness = 0\njoint_strength = "
                                                 "50\nresidual_friction = 30\n"));
  ASSERT_EQ(joint.size(), loose.size());
  for (std::size_t i = 0; i < loose.size(); ++i) EXPECT_NEAR(joint[i], loose[i], 1e-8) << i;
}

TEST_F(StrengthLaws, WeakBeddingLowersTheFactorWhereItIsParallelToTheBase) {
  const auto write = [](double angle) {
    return write_frictional(
        fmt::format("model = \"bedding\"\ncohesion = 8\nfriction_angle = 30\nbedding_angle = "
                    "{}\nbedding_cohesion = 2\nbedding_friction = 15\nbedding_range = 10\n",
                    angle));
  };
  const double along = list_given(write(25)).at(1), across = list_given(write(-80)).at(1),
               none =
                   list_given(write_frictional("model = \"mohr_coulomb\"\ncohesion = 8\nfriction_angle = 30\n")).at(1);
  EXPECT_LT(along, 0.9 * none);
  EXPECT_NEAR(across, none, 1e-12);
}

TEST_F(StrengthLaws, CurvedEnvelopesHaveTheirStrengthOnEveryBase) {
  const nlohmann::json summary =
      run(write_frictional("model = \"power_curve\"\npower_factor = 1.4\npower_exponent = 0.8\n"));
  int solved = 0;
  for (const nlohmann::json& given : summary.at("lem").at("given")) {
    const nlohmann::json& s = given.at("slices");
    if (given.at("factor").is_null()) continue;  // a check rejects this solution
    ++solved;
    const double factor = given.at("factor").get<double>();
    for (std::size_t i = 0; i < s.at("normal").size(); ++i) {
      const double length = s.at("length")[i].get<double>(),
                   normal = s.at("normal")[i].get<double>() / length - s.at("pore_pressure")[i].get<double>(),
                   shear = s.at("shear")[i].get<double>() / length;
      if (normal < 200) continue;
      EXPECT_NEAR(shear * factor, 1e3 * 1.4 * std::pow(normal / 1e3, 0.8), 1e-5 * shear) << i;
    }
  }
  EXPECT_GE(solved, 3);
}

std::string write_search(const std::string& polygon, const std::string& material, const std::string& more = "",
                         const std::string& methods = R"("lem")") {
  return fmt::format(R"(
analysis.methods = [{}]
lem = {{ methods = ["spencer", "bishop"], referee = false, noncircular = false }}
geometry.polygon = [{{ name = "soil", points = {} }}]
regions.soil = "soil"
{}
[materials.soil]
{}
)",
                     methods, polygon, more, material);
}

TEST_F(StrengthLaws, PublishedSlopesWithPowerCurves) {
  // Charles and Soares (1984) with r_u = 0.3, Bishop: 1.66; Slide2 verification problem 41: 1.656.
  const nlohmann::json soares = run(write_search("[[0, 0], [93, 0], [93, 10], [85, 10], [5, 30], [0, 30]]",
                                                 "model = \"power_curve\"\npower_factor = 1.4\npower_exponent = "
                                                 "0.8\nunit_weight = 20\npore_pressure_ratio = 0.3"));
  EXPECT_NEAR(soares.at("lem").at("critical")[1].at("factor").get<double>(), 1.656, 0.01 * 1.656);
  // Baker (2003): example 2, Slide2 problem 45: Spencer 2.662; London clay of example 3, problem 61: Spencer 1.468,
  // Baker 1.48.
  EXPECT_NEAR(find_critical(write_search(
                  "[[0, 0], [100, 0], [100, 12], [48, 12]]",
                  "model = \"power_curve\"\npower_factor = 1.107\npower_exponent = 0.86\nunit_weight = 18")),
              2.662, 0.01 * 2.662);
  EXPECT_NEAR(find_critical(write_search("[[-6, -4], [20, -4], [20, 6], [6.43, 6], [0, 0], [-6, 0]]",
                                         "model = \"power_curve\"\npower_factor = 3.39344\npower_exponent = "
                                         "0.6\npower_shift = 0.152\nunit_weight = 18")),
              1.468, 0.01 * 1.468);
}

TEST_F(StrengthLaws, HammahsSlopeOfHoekBrownRock) {
  // Hammah et al. (2005): Bishop 1.153, Spencer 1.152.
  const nlohmann::json summary =
      run(write_search("[[0, 0], [40, 0], [40, 20], [25, 20], [15, 10], [0, 10]]",
                       "model = \"hoek_brown\"\nintact_strength = 30\ngsi = 5\nintact_constant = 2\nunit_weight = 25"));
  const nlohmann::json& critical = summary.at("lem").at("critical");
  EXPECT_NEAR(critical[0].at("factor").get<double>(), 1.152, 0.01 * 1.152);
  EXPECT_NEAR(critical[1].at("factor").get<double>(), 1.153, 0.01 * 1.153);
}

/// A dry slope of 1:1.5, 8 m high, by FEM and MPM.
std::string write_deforming(const std::string& methods, const std::string& soil) {
  return fmt::format(R"(
analysis.methods = [{}]
mesh = {{ size = 1.2, points_per_element = 3 }}
fem = {{ meshes = 1, flow = "as_given", resolution = 0.002 }}
bounds.gap = 0.05
lem = {{ methods = ["spencer"], referee = false }}
geometry.box = [[0, 0], [36, 14]]
geometry.polygon = [{{ name = "soil", points = [[0, 0], [36, 0], [36, 12], [24, 12], [12, 4], [0, 4]] }}]
regions.soil = "soil"
boundary = [{{ on = "bottom", fix = "full" }}, {{ on = "left", fix = "normal" }}, {{ on = "right", fix = "normal" }}]
stage = [{{ name = "gravity", duration = 0.5, damping = 0.5 }}]
[materials.soil]
grain_density = 2600
porosity = 0.3
young_modulus = 2e4
poisson_ratio = 0.3
{}
)",
                     methods, soil);
}

constexpr const char* straight_soil =
    "model = \"mohr_coulomb\"\ncohesion = 5\nfriction_angle = 30\ndilatancy_angle = "
    "0\ntensile_strength = 0\n";
constexpr const char* straight_pairs =
    "model = \"strength_table\"\nnormal_stresses = [0, 50, 100]\nshear_strengths = [5, 33.86751345948129, "
    "62.73502691896258]\ndilatancy_ratio = 0\n";

TEST_F(StrengthLaws, StraightPairsAreMohrCoulombInFemAndMpm) {
  const nlohmann::json one = run(write_deforming(R"("fem")", straight_soil)),
                       other = run(write_deforming(R"("fem")", straight_pairs));
  EXPECT_NEAR(other.at("fem").at("runs")[0].at("factor").get<double>(),
              one.at("fem").at("runs")[0].at("factor").get<double>(), 0.003);
  const nlohmann::json a = run(write_deforming(R"("mpm")", straight_soil)),
                       b = run(write_deforming(R"("mpm")", straight_pairs));
  for (const char* key : {"elastic_energy", "plastic_work"}) {
    const double expected = a.at("budgets").at(key).get<double>();
    EXPECT_NEAR(b.at("budgets").at(key).get<double>(), expected, 1e-6 * std::abs(expected)) << key;
  }
}

TEST_F(StrengthLaws, FemReturnsToTheEnvelopeOfHammahsRock) {
  // Hammah et al. (2005): FEM 1.15.
  const nlohmann::json summary =
      run(write_search("[[0, 0], [40, 0], [40, 20], [25, 20], [15, 10], [0, 10]]",
                       "model = \"hoek_brown\"\nintact_strength = 30\ngsi = 5\nintact_constant = 2\nunit_weight = "
                       "25\nyoung_modulus = 5e6\npoisson_ratio = 0.3\ndilatancy_ratio = 0",
                       R"(
mesh.size = 1
fem = { meshes = 1, flow = "as_given", from = 1.1, to = 1.2, resolution = 0.005 }
boundary = [{ on = "bottom", fix = "full" }, { on = "left", fix = "normal" }, { on = "right", fix = "normal" }]
)",
                       R"("fem")"));
  EXPECT_NEAR(summary.at("fem").at("runs")[0].at("factor").get<double>(), 1.15, 0.02 * 1.15);
}

TEST_F(StrengthLaws, UndrainedStrengthsAgreeInAllMethods) {
  const auto write = [](const std::string& soil) { return write_deforming(R"("lem", "fem", "bounds")", soil); };
  for (const std::string soil :
       {"model = \"shansep\"\nstrength_ratio = 0.25\nstrength_exponent = 0.8\nadded_strength = 12\nocr = 2\n",
        "model = \"shansep\"\nstrength_ratio = 0.3\nstrength_exponent = 0.8\nadded_strength = 12\nocr = 2\n"
        "pore_pressure_ratio = 0.3\n",
        "model = \"tresca\"\nprofile_depths = [0, 6, 10]\nprofile_strengths = [20, 30, 60]\n"}) {
    const nlohmann::json summary = run(write(soil));
    const double lem = summary.at("lem").at("critical")[0].at("factor").get<double>(),
                 fem = summary.at("fem").at("runs")[0].at("factor").get<double>(),
                 lower = summary.at("bounds").at("lower").get<double>(),
                 upper = summary.at("bounds").at("upper").get<double>();
    EXPECT_GT(lem, 0.98 * lower) << soil;
    EXPECT_LT(lem, 1.05 * upper) << soil;
    EXPECT_GT(fem, 0.98 * lower) << soil;
    EXPECT_LT(fem, 1.03 * upper) << soil;
  }
}

/// Soil does not consolidate under a variable load: its strength is that without the load.
TEST_F(StrengthLaws, VariableLoadsDoNotConsolidate) {
  const std::string clay =
      "model = \"shansep\"\nstrength_ratio = 0.25\nstrength_exponent = 0.8\nadded_strength = 8\nocr = 1\n";
  const auto find = [&](const std::string& load) {
    const nlohmann::json summary = run(write_deforming(R"("lem", "fem")", clay + load));
    return std::pair{summary.at("lem").at("critical")[0].at("factor").get<double>(),
                     summary.at("fem").at("runs")[0].at("factor").get<double>()};
  };
  const auto write = [](bool variable) {
    return fmt::format("[[surcharge]]\nname = \"lorry\"\nx = [24, 36]\nload = [30, 30]\nvariable = {}\n", variable);
  };
  const auto variable = find(write(true)), permanent = find(write(false));
  EXPECT_LT(variable.first, 0.97 * permanent.first);
  EXPECT_LT(variable.second, 0.98 * permanent.second);
  EXPECT_NEAR(variable.second, variable.first, 0.06 * variable.first);
}

TEST_F(StrengthLaws, BoundsOfACurvedStrengthMeetThoseOfFinerMeshes) {
  // The strength bends below crest and toe and at the water table. Coarse triangles must not cut the bends off.
  const auto find_bounds = [&](double size) {
    std::string text =
        write_deforming(R"("bounds")",
                        "model = \"shansep\"\nstrength_ratio = 0.25\nstrength_exponent = 0.8\nadded_strength = "
                        "4\nprofile_depths = [0, 12]\nprofile_preconsolidation = [40, 150]\n[initial]\npore_pressure = "
                        "\"water_table\"\nwater_table = [[0, 2], [36, 8]]\n");
    const std::string gap = "bounds.gap = 0.05\n";
    text.replace(text.find(gap), gap.size(), gap + fmt::format("bounds.size = {}\n", size));
    const nlohmann::json summary = run(text);
    return std::pair{summary.at("bounds").at("lower").get<double>(), summary.at("bounds").at("upper").get<double>()};
  };
  const auto [lower, upper] = find_bounds(3);
  const auto [finer_lower, finer_upper] = find_bounds(0.8);
  EXPECT_LE(lower, finer_upper);
  EXPECT_GE(upper, finer_lower);
  // Refined triangles evaluate the law anew, so that both reach the gap, and neither end of one encloses the other.
  EXPECT_LE(upper - lower, 0.05 * 0.5 * (upper + lower));
  EXPECT_LE(finer_upper - finer_lower, 0.05 * 0.5 * (finer_upper + finer_lower));
}

TEST_F(StrengthLaws, AProfileOfAGradientIsThatGradient) {
  const std::string gradient =
                        "model = \"tresca\"\nundrained_strength = 20\nundrained_gradient = 3\nundrained_level = 12\n",
                    profile = "model = \"tresca\"\nprofile_levels = [12, 0]\nprofile_strengths = [20, 56]\n";
  const nlohmann::json a = run(write_deforming(R"("lem", "fem", "bounds", "mpm")", gradient)),
                       b = run(write_deforming(R"("lem", "fem", "bounds", "mpm")", profile));
  EXPECT_NEAR(b.at("lem").at("critical")[0].at("factor").get<double>(),
              a.at("lem").at("critical")[0].at("factor").get<double>(), 1e-9);
  EXPECT_NEAR(b.at("fem").at("runs")[0].at("factor").get<double>(),
              a.at("fem").at("runs")[0].at("factor").get<double>(), 1e-9);
  for (const char* bound : {"lower", "upper"})
    EXPECT_NEAR(b.at("bounds").at(bound).get<double>(), a.at("bounds").at(bound).get<double>(), 1e-6);
  EXPECT_NEAR(b.at("budgets").at("elastic_energy").get<double>(), a.at("budgets").at("elastic_energy").get<double>(),
              1e-6 * a.at("budgets").at("elastic_energy").get<double>());
}

}  // namespace
}  // namespace talus
