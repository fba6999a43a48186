// SPDX-License-Identifier: MIT
// Meshes read from files of Gmsh, in text and in binary form, and the messages on files that cannot be used.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "base/error.hpp"
#include "mesh/generate.hpp"
#include "mesh/gmsh_mesh.hpp"
#include "mesh/quality.hpp"
#include "support/scratch.hpp"

namespace talus::mesh {
namespace {

std::string get_path(const std::string& name) {
  return support::name_scratch(name).string();
}

template <int D>
Mesh<D> read(const std::string& path) {
  Plan plan;
  plan.dimension = D;
  plan.file = path;
  return generate<D>(plan);
}

std::string get_message(const std::string& path, int dimension = 2) {
  try {
    dimension == 2 ? void(read<2>(path)) : void(read<3>(path));
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::wrong_input);
    return error.what();
  }
  return "no error";
}

/// A box of 2 × 1 × 1 with groups, written by Gmsh itself (tests/box_file).
struct BoxFile {
  std::string words;
  const char* version = "4.1";

  std::string write(const std::string& name) const {
    const std::string path = get_path(name + ".msh");
    const std::string command = std::string(TALUS_BOX_FILE) + " '" + path + "' " + version + " " + words;
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    return path;
  }
};

TEST(MeshFile, OfTheIndependentRunIsReadWithItsGroups) {
  const auto mesh = read<2>(TALUS_SOURCE_DIR "/examples/data/dry_slope_h075.msh");
  EXPECT_EQ(mesh.region_names, std::vector<std::string>{"soil"});
  double area = 0;
  int count = 0;
  for (int e = 0; e < mesh.element_count(); ++e)
    if (mesh.element_region[e] == 0) {
      area += mesh.volumes[e];
      ++count;
    } else {
      ASSERT_EQ(mesh.element_region[e], empty_region);
    }
  EXPECT_EQ(count, 1781);
  EXPECT_NEAR(area, 440, 1e-9 * 440);
  const auto measure = [&](const char* name) {
    double length = 0;
    for (const auto& [a, b] : mesh.sides.at(name))
      length += std::hypot(mesh.nodes[a][0] - mesh.nodes[b][0], mesh.nodes[a][1] - mesh.nodes[b][1]);
    return length;
  };
  EXPECT_NEAR(measure("left"), 17, 1e-9);
  EXPECT_NEAR(measure("bottom"), 44, 1e-9);
  EXPECT_NEAR(measure("ground"), 12 + std::sqrt(500.0) + 12, 1e-9);
  // Δt = 0.98 L_min / c of that run; its altitude was about 0.41 m.
  EXPECT_NEAR(measure_quality(mesh).min_altitude, 0.41, 0.01);
}

TEST(MeshFile, InBinaryFormHoldsTheSameMeshAsInText) {
  const auto binary = read<3>(BoxFile().write("binary"));
  const auto text = read<3>(BoxFile{"text"}.write("text"));
  EXPECT_EQ(binary.elements, text.elements);
  ASSERT_EQ(binary.node_count(), text.node_count());
  for (int i = 0; i < binary.node_count(); ++i)  // text keeps 16 digits
    for (int d = 0; d < 3; ++d) EXPECT_NEAR(binary.nodes[i][d], text.nodes[i][d], 1e-15);
  double volume = 0;
  for (double v : binary.volumes) volume += v;
  EXPECT_NEAR(volume, 2, 1e-12);
  EXPECT_EQ(binary.region_names, std::vector<std::string>{"clay"});
  EXPECT_GT(binary.sides.at("first").size(), 10u);
}

TEST(MeshFile, ThatCannotBeUsedIsRefusedWithItsName) {
  const auto expect_words = [](const std::string& message, const std::vector<std::string>& words) {
    for (const auto& word : words) EXPECT_NE(message.find(word), std::string::npos) << word << " in: " << message;
  };
  expect_words(get_message("/nowhere/slope.msh"), {"/nowhere/slope.msh", "cannot be opened"});
  expect_words(get_message(TALUS_SOURCE_DIR "/examples/data/dry_slope_h075.csv"),
               {"dry_slope_h075.csv", "not a Gmsh mesh"});
  expect_words(get_message(TALUS_SOURCE_DIR "/examples/data/dry_slope_h075.msh", 3),
               {"dry_slope_h075.msh", "no tetrahedra"});
  expect_words(get_message(BoxFile{"flat quads"}.write("quads")), {"quads.msh", "Quad", "triangles"});
  expect_words(get_message(BoxFile{"unnamed"}.write("unnamed"), 3), {"unnamed.msh", "no physical group"});
  expect_words(get_message(BoxFile{"", "2.2"}.write("old"), 3), {"old.msh", "2.2", "version 4"});
  expect_words(get_message(BoxFile{"flat tilted"}.write("tilted")), {"tilted.msh", "plane"});
}

TEST(MeshFile, CutOffInTheMiddleIsRefused) {
  const BoxFile file{"text"};
  const std::string path = file.write("cut");
  const auto size = std::filesystem::file_size(path);
  for (double fraction : {0.01, 0.1, 0.3, 0.5, 0.8, 0.95}) {
    file.write("cut");
    std::filesystem::resize_file(path, static_cast<std::uintmax_t>(fraction * static_cast<double>(size)));
    EXPECT_NE(get_message(path, 3), "no error") << fraction;
  }
}

// Gmsh does not check the numbers of a text file, and crashes.
TEST(MeshFile, WithNumbersThatDoNotFitNamesTheLine) {
  const std::string path = BoxFile{"flat text"}.write("text");
  EXPECT_GT(read<2>(path).element_count(), 10);
  std::ifstream file(path);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const auto damage = [&](const std::string& section, int line, int word, const std::string& by) {
    std::size_t at = text.find(section + "\n");
    for (int i = 0; i < line; ++i) at = text.find('\n', at) + 1;
    for (int i = 1; i < word; ++i) at = text.find(' ', at) + 1;
    const std::string damaged = text.substr(0, at) + by + text.substr(text.find_first_of(" \n", at));
    const std::string bad = get_path("damaged.msh");
    std::ofstream(bad) << damaged;
    return get_message(bad);
  };
  EXPECT_NE(damage("$Elements", 3, 2, "-1").find("has node -1, which does not exist"), std::string::npos)
      << damage("$Elements", 3, 2, "-1");
  EXPECT_NE(damage("$Nodes", 1, 1, "x").find(": 'x' is not the number of blocks, a whole number"), std::string::npos);
  EXPECT_NE(damage("$Nodes", 2, 4, "999999999999").find("the size of a block cannot be 999999999999"),
            std::string::npos);
  EXPECT_NE(damage("$Nodes", 3, 1, "-5").find("a node has the number -5; they count from 1"), std::string::npos);
  // Faults that are not checked before make Gmsh refuse the file, or crash in its own process.
  for (const char* by : {"-7", "1e300", "nan", "99999999999999999999"})
    for (int word = 1; word <= 4; ++word) EXPECT_NE(damage("$Entities", 1, word, by), "");
}

}  // namespace
}  // namespace talus::mesh
