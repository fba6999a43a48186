// SPDX-License-Identifier: MIT
// GeoStudio models as case files.
#include "drawing/geostudio.hpp"

#include <gtest/gtest.h>
#include <zip.h>

#include <algorithm>

#include "base/error.hpp"
#include "input/read.hpp"
#include "support/program.hpp"
#include "support/scratch.hpp"

namespace talus::drawing {
namespace {

/// A slope of 10 ft with two soils, made by hand after files of GeoStudio 2024. Zero values are left out, as there.
const std::string model =
    support::read_text(std::string(TALUS_SOURCE_DIR) + "/tests/data/drawings/geostudio_model.xml");

bool has_remark(const ImportedCase& found, const std::string& part) {
  return std::any_of(found.remarks.begin(), found.remarks.end(),
                     [&](const std::string& r) { return r.find(part) != std::string::npos; });
}

std::string find_fault(auto&& act) {
  try {
    act();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

/// Writes a zip archive.
std::string write_archive(const std::string& name, const std::string& content) {
  const std::string path = (support::make_scratch("geostudio") / "model.gsz").string();
  zip_t* archive = zip_open(path.c_str(), ZIP_CREATE | ZIP_TRUNCATE, nullptr);
  zip_source_t* source = zip_source_buffer(archive, content.data(), content.size(), 0);
  zip_file_add(archive, name.c_str(), source, 0);
  zip_close(archive);
  return path;
}

TEST(GeoStudio, AnAnalysisBecomesACase) {
  const ImportedCase found = translate_model(model, "", "model.gsz");
  const input::LoadedCase loaded = input::read_case_text(found.text, "model.toml");
  const input::Case& data = loaded.data;
  ASSERT_EQ(data.mesh.polygons.size(), 2u);
  EXPECT_DOUBLE_EQ(data.mesh.polygons[1].points[2][0], 6.096) << "20 ft";
  EXPECT_EQ(data.regions.at("region 1"), "Soft _clay_");
  const input::Material &clay = data.materials.at("Soft _clay_"), &sand = data.materials.at("Sand");
  EXPECT_NEAR(clay.cohesion, 500 * 47.880258980336, 1e-6);
  EXPECT_EQ(clay.friction_angle, 0);
  EXPECT_NEAR(*sand.slices.unit_weight, 110 * 157.08746385, 1e-3);
  EXPECT_NEAR(*sand.slices.saturated_unit_weight, 120 * 157.08746385, 1e-3);
  EXPECT_EQ(sand.cohesion, 0);
  EXPECT_NEAR(sand.friction_angle, 32 * 3.14159265358979 / 180, 1e-12);
  EXPECT_EQ(data.initial.water.water_table.front(), (std::array<double, 2>{0, 2.4384}))
      << "turned to run from left to right";
  ASSERT_EQ(data.initial.water.lines.size(), 1u) << "the clay uses no surface";
  EXPECT_EQ(data.initial.water.lines[0].materials, std::vector<std::string>{"Soft _clay_"});
  EXPECT_EQ(data.initial.water.lines[0].points.front()[1], 0);
  EXPECT_EQ(data.earthquake.horizontal, 0.1);
  EXPECT_EQ(data.lem.entry_exit.entry, (std::vector{1.524, 4.572}));
  EXPECT_TRUE(has_remark(found, "others, for --analysis: 'Later'"));
  EXPECT_TRUE(has_remark(found, "region 3 has no material in this analysis"));
  EXPECT_TRUE(has_remark(found, "material 'Soft _clay_' has no piezometric surface"));
  EXPECT_TRUE(has_remark(found, "surcharges are not translated"));
  EXPECT_TRUE(has_remark(found, "the exit is one point, x = 12.192 m"));
}

TEST(GeoStudio, FaultsAreOneSentence) {
  const auto translate = [](const std::string& xml, const std::string& analysis = "") {
    return find_fault([&] { translate_model(xml, analysis, "a.gsz"); });
  };
  EXPECT_EQ(translate("<GSIData/>"), "a.gsz has no SLOPE/W analysis");
  EXPECT_EQ(translate("<Other/>"), "the model of a.gsz is not one of GeoStudio");
  EXPECT_NE(translate("<GSIData>").find("is damaged"), std::string::npos);
  EXPECT_EQ(translate(model, "Flow"), "a.gsz has no SLOPE/W analysis 'Flow'; it has 'Slope', 'Later'");
  EXPECT_NE(translate(model, "Later").find("has no region with a material"), std::string::npos);
  std::string wrong = model;
  wrong.replace(wrong.find(">500<"), 5, ">x<");
  EXPECT_EQ(translate(wrong), "the GeoStudio model has 'x' for Cohesion, which is not a number");
  wrong = model;
  wrong.replace(wrong.find("Horizontal=\"0.1\""), 16, "Horizontal=\"much\"");
  EXPECT_EQ(translate(wrong), "the GeoStudio model has 'much' for the Horizontal acceleration, which is not a number");
}

TEST(GeoStudio, ArchivesAreBounded) {
  EXPECT_EQ(read_model(write_archive("any name.xml", model)), model);
  const std::string deep = write_archive("Slope/model.xml", model);
  EXPECT_NE(find_fault([&] { read_model(deep); }).find("no XML file at the root"), std::string::npos);
  const std::string bomb = write_archive("model.xml", std::string(2'000'000, ' '));
  EXPECT_NE(find_fault([&] { read_model(bomb); }).find("times are read"), std::string::npos);
  EXPECT_NE(find_fault([] { read_model(TALUS_SOURCE_DIR "/README.md"); }).find("it is no zip archive"),
            std::string::npos);
}

}  // namespace
}  // namespace talus::drawing
