// SPDX-License-Identifier: MIT
// Frames in the page equal those of the results file: all values, points that left the grid, components, colour scales.

#include "report/content/sequence.hpp"

#include <algorithm>

#include "report/content/fields.hpp"
#include "report_page.hpp"
#include "support/draw.hpp"

namespace talus::report {
namespace {

namespace fs = std::filesystem;

/// Frames of points with a displacement, a stress and a strain; from frame 1 on the point 3 is gone.
output::Frame make_frame(int number, int points, bool space) {
  support::Draw draw(static_cast<unsigned>(number + 1));
  output::Frame frame;
  frame.time = number;
  frame.stage = "slide";
  output::Field displacement{"displacement", "m", 3, {}}, stress{"stress", "Pa", 6, {}},
      q{"deviatoric_strain", "-", 1, {}};
  for (int id = 0; id < points; ++id) {
    if (number > 0 && id == 3) continue;
    frame.ids.push_back(id);
    frame.materials.push_back(id % 2);
    for (int d = 0; d < 3; ++d) {
      frame.positions.push_back(d < 2 || space ? draw(0, 40) : 0);
      displacement.values.push_back(d < 2 || space ? draw(-2, 2) : 0);
    }
    for (int c = 0; c < 6; ++c) stress.values.push_back(c < 4 || space ? draw(-1e5, 1e4) : 0);
    q.values.push_back(draw(0, 3));
  }
  frame.point_fields = {displacement, stress, q};
  return frame;
}

struct Packed {
  nlohmann::json sequence;
  std::map<std::string, std::string> texts;
  std::vector<double> values(const nlohmann::json& array) const {
    return decode(array, texts.at(array.at("id").get<std::string>()));
  }
  std::vector<double> field(const std::string& name) const {
    for (const nlohmann::json& f : sequence.at("fields"))
      if (f.at("name") == name) return values(f.at("values"));
    throw std::runtime_error("there is no field " + name);
  }
};

Packed pack(const std::string& name, int frames, int points, bool space, const Budget& budget) {
  const fs::path folder = make_test_folder(name);
  auto writer = output::ResultsWriter::start(folder);
  for (int i = 0; i < frames; ++i) writer.write(make_frame(i, points, space));
  writer.finish();
  const auto reader = std::make_shared<const output::ResultsReader>(folder);
  SequencePlan plan{SequenceKind::stages, "stages", "Stages", {}};
  for (int i = 0; i < frames; ++i) plan.frames.push_back({reader, i, std::nullopt, "frame"});
  Packer packer;
  Packed packed{pack_sequence(plan, space ? 3 : 2, {}, budget, packer), {}};
  for (const PackedText& t : packer.compress(1)) packed.texts[t.id] = t.base64;
  fs::remove_all(folder);
  return packed;
}

TEST(Sequence, ValuesAreThoseOfTheFramesAndAPointThatLeftHasNone) {
  for (const bool space : {false, true}) {
    const std::size_t dimension = space ? 3 : 2;
    const Packed packed = pack("sequence", 3, 10, space, {48, 20000, 100000});
    ASSERT_EQ(packed.sequence.at("point_count"), 10);
    const auto positions = packed.values(packed.sequence["positions"]), q = packed.field("deviatoric_strain"),
               u = packed.field("displacement"), uy = packed.field("displacement_y"), sxy = packed.field("stress_xy"),
               materials = packed.values(packed.sequence["materials"]);
    for (int k = 0; k < 3; ++k) {
      const output::Frame frame = make_frame(k, 10, space);
      const std::size_t first = static_cast<std::size_t>(k) * 10;
      for (std::size_t i = 0; i < frame.ids.size(); ++i) {
        const std::size_t id = static_cast<std::size_t>(frame.ids[i]);
        for (std::size_t d = 0; d < dimension; ++d)
          EXPECT_NEAR(positions[(first + id) * dimension + d], frame.positions[3 * i + d], 40.0 / 65534);
        EXPECT_NEAR(q[first + id], frame.point_fields[2].values[i], 3.0 / 65534);
        const double* v = &frame.point_fields[0].values[3 * i];
        EXPECT_NEAR(uy[first + id], v[1], 4.0 / 65534);
        EXPECT_NEAR(u[first + id], std::hypot(v[0], v[1], v[2]), 4.0 / 65534);
        EXPECT_NEAR(sxy[first + id], frame.point_fields[1].values[6 * i + 3], 1.1e5 / 65534);
        EXPECT_EQ(materials[id], frame.materials[i]);
      }
      EXPECT_EQ(std::isnan(q[first + 3]), k > 0);
      EXPECT_EQ(std::isnan(positions[(first + 3) * dimension]), k > 0);
    }
    // Plane strain has no displacement along z and no shear across the plane.
    EXPECT_EQ(packed.texts.contains("stages.displacement_z"), space);
    EXPECT_EQ(packed.texts.contains("stages.stress_yz"), space);
    EXPECT_TRUE(packed.texts.contains("stages.stress_zz"));
  }
}

TEST(Sequence, ThinnedPointsKeepTheirNumbersAndValues) {
  const Packed packed = pack("thinned", 9, 100, false, {3, 30, 100000});
  EXPECT_EQ(packed.sequence["frames"].size(), 3u);
  EXPECT_EQ(packed.sequence["frames"][1]["time"], 4);
  const auto ids = packed.values(packed.sequence["ids"]), q = packed.field("deviatoric_strain");
  ASSERT_EQ(ids.size(), 25u);  // every fourth
  const output::Frame middle = make_frame(4, 100, false);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    EXPECT_EQ(ids[i], 4.0 * static_cast<double>(i));
    const auto row = std::find(middle.ids.begin(), middle.ids.end(), static_cast<int>(ids[i])) - middle.ids.begin();
    EXPECT_NEAR(q[25 + i], middle.point_fields[2].values[static_cast<std::size_t>(row)], 3.0 / 65534);
  }
}

TEST(ColourScale, OutliersDoNotStretchIt) {
  std::vector<double> values;
  for (int i = 0; i < 1000; ++i) values.push_back(i / 1000.0);
  values[500] = 1e6;
  const ColourScale scale = find_colour_scale(values, false);
  EXPECT_EQ(scale.limits[0], 0);
  EXPECT_NEAR(scale.limits[1], 0.99, 0.005);
  EXPECT_FALSE(scale.diverging);
}

TEST(ColourScale, OnlyWhatHasBothSignsRunsFromTheMiddle) {
  std::vector<double> both, compression;
  for (int i = 0; i <= 1000; ++i) {
    both.push_back(i - 300);
    compression.push_back(-i - 10);
  }
  const ColourScale middle = find_colour_scale(both, true), end = find_colour_scale(compression, true);
  EXPECT_TRUE(middle.diverging);
  EXPECT_EQ(middle.limits[0], -middle.limits[1]);
  EXPECT_FALSE(end.diverging);
  EXPECT_NEAR(end.limits[0], -1000, 1);
}

TEST(ColourScale, AFieldOfFewPointsIsStillShown) {
  std::vector<double> values(1000, 0.0);
  values[3] = 0.2;
  EXPECT_EQ(find_colour_scale(values, false).limits[1], 0.2);
  const ColourScale nothing = find_colour_scale(std::vector<double>(5, 0.0), true);
  EXPECT_LT(nothing.limits[0], nothing.limits[1]);
}

}  // namespace
}  // namespace talus::report
