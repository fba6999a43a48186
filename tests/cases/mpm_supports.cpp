// SPDX-License-Identifier: MIT
// Supports in MPM from a case file: factor beside that of FEM, motion with and without them, results, and refusals.

#include <cmath>

#include "cases/methods_slope.hpp"
#include "support/run_json.hpp"

namespace talus {
namespace {

using nlohmann::json;

const std::string cut = R"(
geometry.polygon = [{ name = "soil", points = [[-6, -4], [26, -4], [26, 8], [12, 8], [8, 0], [-6, 0]] }]
geometry.box = [[-6, -4], [26, 9]]
regions.soil = "silt"
mesh.size = 1.3
boundary = [{ on = "bottom", fix = "full" }, { on = "left", fix = "normal" }, { on = "right", fix = "normal" }]
[materials.silt]
model = "mohr_coulomb"
unit_weight = 19
cohesion = 6
friction_angle = 28
dilatancy_angle = 0
tensile_strength = 0
young_modulus = "30 MPa"
poisson_ratio = 0.3
[[stage]]
name = "gravity"
duration = 10
until = "rest"
damping = 0.75
cohesion = "200 kPa"
)";

const std::string nails = R"([support.nails]
kind = "nail"
heads = [[11.25, 6.5], [10.25, 4.5], [9.25, 2.5]]
inclination = 10
length = 7
out_of_plane_spacing = 1.5
tensile_strength = 120
plate = 40
bond = 18
axial_stiffness = 1.2e5
)";

class MpmSupports : public MethodsTest {
 protected:
  /// Lets the cut move for two seconds.
  json slide(const std::string& supports) {
    return run("analysis.methods = [\"mpm\"]\nanalysis.kind = \"run\"\n" + cut +
               "[[stage]]\nname = \"weak\"\nduration = 2\ndamping = 0.02\n"
               "reset_displacement = true\n" +
               supports);
  }
  std::string explain(const std::string& methods, const std::string& supports,
                      const std::vector<input::Override>& overrides = {}) {
    try {
      run("analysis.methods = [" + methods + "]\nanalysis.kind = \"run\"\n" + cut + supports, overrides);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }
};

double read_displacement(const json& summary) {
  return summary.at("runout").at("largest_displacement").get<double>();
}

TEST_F(MpmSupports, HoldACutThatWouldSlide) {
  const json bare = slide(""), held = slide(nails);
  EXPECT_GT(read_displacement(bare), 1);
  EXPECT_LT(read_displacement(held), 0.02);
  const json& supports = held.at("supports");
  ASSERT_EQ(supports.size(), 3u);
  for (const json& bar : supports) {
    EXPECT_EQ(bar.at("support"), "nails");
    EXPECT_GT(bar.at("largest").get<double>(), 5e3);
    EXPECT_LE(bar.at("tension").get<double>(), 1);
    EXPECT_LE(bar.at("pull_out").get<double>(), 1 + 1e-9);
    EXPECT_GT(bar.at("line").at(0).at(0).get<double>(), 0);
    EXPECT_LT(bar.at("slip").back().get<double>(), 0) << "its end slips out of the soil behind";
  }
  EXPECT_GT(held.at("budgets").at("support_work").get<double>(), 0);
  EXPECT_FALSE(bare.contains("supports"));
}

/// A row of nails that tears holds less.
TEST_F(MpmSupports, TornNailsLetItGo) {
  std::string weak = nails;
  weak.replace(weak.find("= 120"), 5, "= 20");
  const json held = slide(weak), torn = slide(weak + "rupture_strain = 0.002\n");
  int pieces = 0;
  for (const json& bar : torn.at("supports")) pieces += bar.at("torn").get<int>();
  EXPECT_GE(pieces, 3);
  EXPECT_EQ(torn.at("supports").at(0).at("limit"), "torn");
  EXPECT_GT(read_displacement(torn), 1.5 * read_displacement(held));
}

/// FEM and MPM have the same bars: on elements of one size the factor is the same but for their meshes.
TEST_F(MpmSupports, HaveTheFactorOfFem) {
  const json summary =
      run("analysis.methods = [\"fem\", \"mpm\"]\n"
          "analysis.kind = \"strength_reduction\"\n" +
              cut + nails +
              "[fem]\nmeshes = 1\nsize = 1.3\n[strength_reduction.frozen]\nmeshes = 1\n"
              "[strength_reduction.curve]\nfrom = 1.0\nto = 1.1\nstep = 0.1\nrefine = false\n"
              "window = 0.5\n",
          {{"materials.silt.dilatancy_angle", "20"}});
  const double elements = summary.at("fem").at("runs").at(0).at("factor").get<double>();
  const double points = summary.at("factor_of_safety").at("frozen").at("factor").get<double>();
  EXPECT_NEAR(points / elements, 1, 0.03);
}

/// A case that starts from the result of another with a nail between those of that one continues their forces.
TEST_F(MpmSupports, KeepTheirForcesBesideOneMore) {
  const auto run_into = [&](const std::string& name, const std::string& text) {
    run::RunOptions options;
    options.folder = folder_ / name;
    return support::run_case(
        input::read_case_text("analysis.methods = [\"mpm\"]\nanalysis.kind = \"run\"\n" + text, "cut.toml"), options);
  };
  const std::string two = "heads = [[11.25, 6.5], [9.25, 2.5]]",
                    three = "heads = [[11.25, 6.5], [10.25, 4.5], [9.25, 2.5]]";
  std::string fewer = nails, soil = cut.substr(0, cut.find("[[stage]]"));
  fewer.replace(fewer.find(three), three.size(), two);
  const json before = run_into("two", cut + fewer);
  const json after =
      run_into("three", soil + "[[stage]]\nname = \"instant\"\nduration = 1e-4\ncohesion = \"200 kPa\"\n" + nails +
                            "[initial]\nresult = \"" + (folder_ / "two").string() + "\"\n");
  ASSERT_EQ(after.at("supports").size(), 3u);
  for (const std::size_t i : {0u, 1u}) {
    const json &held = before.at("supports").at(i), &kept = after.at("supports").at(2 * i);
    const double force = held.at("largest").get<double>();
    EXPECT_GT(force, 100);
    EXPECT_NEAR(kept.at("largest").get<double>(), force, 0.01 * force);
    EXPECT_NEAR(kept.at("plate").get<double>(), held.at("plate").get<double>(), 0.01 * force);
    EXPECT_NEAR(kept.at("slip").back().get<double>(), held.at("slip").back().get<double>(), 1e-6);
  }
  EXPECT_LT(after.at("supports").at(1).at("largest").get<double>(), 1) << "the new one is installed without force";
}

TEST_F(MpmSupports, RefuseWhatTheyCannotCarry) {
  std::string loose = nails;
  loose.erase(loose.find("axial_stiffness"));
  EXPECT_NE(explain("\"mpm\"", loose).find("MPM needs its 'axial_stiffness'"), std::string::npos);
  const std::string pile =
      "[support.row]\nkind = \"pile\"\nx = [10]\nlength = 6\nout_of_plane_spacing = 2\nlateral_resistance = 50\n"
      "axial_stiffness = 1e6\nbending_stiffness = 1e4\n";
  EXPECT_NE(explain("\"mpm\"", pile).find("MPM takes bars in tension only"), std::string::npos);
  EXPECT_NE(explain("\"mpm\"", nails, {{"initial.stress", "elements"}}).find("would begin without force"),
            std::string::npos);
  run::RunOptions options;
  options.folder = folder_ / "device";
  options.device = run::DeviceKind::emulated;
  const std::string text = "analysis.methods = [\"mpm\"]\nanalysis.kind = \"run\"\n" + cut + nails;
  EXPECT_THROW(support::run_case(input::read_case_text(text, "cut.toml"), options), Error) << "no device has bars";
  EXPECT_FALSE(std::filesystem::exists(options.folder)) << "before anything is written";
}

}  // namespace
}  // namespace talus
