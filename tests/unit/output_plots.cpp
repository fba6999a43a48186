// SPDX-License-Identifier: MIT
// Plots: labels do not overlap, lengths are true to scale, and the kept script draws the same picture again.

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "output/files/frames_reader.hpp"
#include "output/plots/curve_plot.hpp"
#include "output/plots/field_plot.hpp"
#include "output/plots/gnuplot.hpp"
#include "output/plots/section_plot.hpp"
#include "support/program.hpp"
#include "support/scratch.hpp"

namespace {

namespace fs = std::filesystem;
using namespace talus;

class Pictures : public testing::Test {
 protected:
  void SetUp() override {
    if (std::system("gnuplot --version > /dev/null 2>&1") != 0)
      GTEST_SKIP() << "gnuplot is not installed: no picture was drawn";
  }
  std::string read(const std::string& name) const { return support::read_text(folder_ / name); }
  const fs::path folder_ = support::make_scratch("plots");
};

output::CurvePlot make_curve() {
  output::CurvePlot plot;
  plot.title = "A slope_with 'odd' {name}";
  for (int i = 0; i <= 15; ++i) {
    const double f = 1 + 0.05 * i;
    plot.factors.push_back(f);
    plot.displacements.push_back(std::max(0.003 * f - 0.002, 0.06 * f - 0.0855));
  }
  plot.first = results::Branch{0.003, -0.002, {1, 1.05, 1.1}};
  plot.second = results::Branch{0.06, -0.0855, {1.65, 1.7, 1.75}};
  plot.intersection = 0.0835 / 0.057;
  plot.criteria = {{"bilinear", 0.0835 / 0.057, {}, {}},
                   {"displacement ratio", 1.58, {}, {}},
                   {"rest or run-away at frozen geometry", 1.455, 1.45, 1.46},
                   {"loss of rest", 1.46, {}, {}},
                   {"far to the right with a long name", 1.74, {}, {}}};
  plot.references = {{"Published (2019)", {1.0, 1.6}, {0.0012, 0.011}}};
  return plot;
}

/// A number of the script after `key`, e.g. "set lmargin at screen ".
double find_number(const std::string& script, const std::string& key) {
  const std::size_t at = script.find(key);
  EXPECT_NE(at, std::string::npos) << key;
  return at == std::string::npos ? 0 : std::stod(script.substr(at + key.size()));
}

struct DrawnFrame {
  double left, right, bottom, top, x0, x1, y0, y1, width, height;
};
DrawnFrame read_frame(const std::string& s) {
  const double size_at = find_number(s, "size ");
  const std::size_t comma = s.find(',', s.find("size "));
  const auto range_end = [&s](const char* key) { return std::stod(s.substr(s.find(':', s.find(key)) + 1)); };
  return {find_number(s, "lmargin at screen "),
          find_number(s, "rmargin at screen "),
          find_number(s, "bmargin at screen "),
          find_number(s, "tmargin at screen "),
          find_number(s, "set xrange ["),
          range_end("set xrange ["),
          find_number(s, "set yrange ["),
          range_end("set yrange ["),
          size_at,
          std::stod(s.substr(comma + 1))};
}

TEST_F(Pictures, OfACurveHaveLabelsThatDoNotCoverEachOtherOrALine) {
  output::draw(make_curve(), folder_ / "curve.svg");
  const std::string script = read("curve.gp");
  const DrawnFrame frame = read_frame(script);
  struct Label {
    double from, to, y, line;
  };
  std::vector<Label> labels;
  const std::regex pattern("set label '([^']*)' at ([0-9.]+), screen ([0-9.]+) left offset");
  for (std::sregex_iterator it(script.begin(), script.end(), pattern), end; it != end; ++it) {
    const double x = std::stod((*it)[2]);
    const double pixel =
        frame.width * (frame.left + (frame.right - frame.left) * (x - frame.x0) / (frame.x1 - frame.x0));
    labels.push_back({pixel, pixel + output::estimate_width((*it)[1]), frame.height * std::stod((*it)[3]), pixel});
  }
  ASSERT_EQ(labels.size(), 5u);
  for (const Label& a : labels) {
    EXPECT_GT(a.y, frame.height * frame.top);  // above the curve
    EXPECT_LE(a.to, frame.width);              // inside the picture
    for (const Label& b : labels) {
      if (&a == &b) continue;
      const bool apart = a.to < b.from || b.to < a.from || std::abs(a.y - b.y) >= 14;
      EXPECT_TRUE(apart) << a.from << " " << b.from;
      const bool crossed = b.line > a.from && b.line < a.to && b.y > a.y - 7;  // b's line goes up to b's label
      EXPECT_FALSE(crossed) << a.from << " " << b.from;
    }
  }
}

TEST_F(Pictures, ShowTheGivenData) {
  output::draw(make_curve(), folder_ / "curve.svg");
  const std::string svg = read("curve.svg");
  for (const char* text : {"displacement [mm]", "strength reduction factor", "1.58  displacement ratio",
                           "Published (2019)", "A slope_with 'odd' {name}"}) {
    std::string plain = std::regex_replace(svg, std::regex("&#39;|&apos;"), "'");
    EXPECT_NE(plain.find(text), std::string::npos) << text;
  }
}

TEST_F(Pictures, AreDrawnAgainByTheScriptBesideThem) {
  output::draw(make_curve(), folder_ / "curve.svg");
  const std::string first = read("curve.svg");
  fs::remove(folder_ / "curve.svg");
  ASSERT_EQ(std::system(("cd '" + folder_.string() + "' && gnuplot curve.gp").c_str()), 0);
  EXPECT_EQ(read("curve.svg"), first);
}

TEST_F(Pictures, OfAFieldShowTrueLengths) {
  for (const double height : {0.1, 3.0, 10.0, 80.0}) {
    output::FieldPlot plot;
    plot.title = "x";
    for (int i = 0; i < 20; ++i)
      for (int j = 0; j < 20; ++j) {
        plot.positions.insert(plot.positions.end(), {10.0 * i / 19, height * j / 19, 0});
        plot.values.push_back(i);
      }
    plot.values[7] = std::nan("");
    output::draw(plot, folder_ / "field.svg");
    const DrawnFrame f = read_frame(read("field.gp"));
    const double per_x = f.width * (f.right - f.left) / (f.x1 - f.x0);
    const double per_y = f.height * (f.top - f.bottom) / (f.y1 - f.y0);
    EXPECT_NEAR(per_x / per_y, 1, 0.01) << height;  // pixels are whole
    EXPECT_LE(f.x0, 0);
    EXPECT_GE(f.y1, height);
  }
}

TEST_F(Pictures, OfASignedFieldHaveWhiteAtZero) {
  output::FieldPlot plot;
  plot.positions = {0, 0, 0, 1, 0, 0, 1, 1, 0};
  plot.values = {-2, 1, 0.5};
  output::draw(plot, folder_ / "field.png");
  EXPECT_NE(read("field.gp").find("set cbrange [-2:2]"), std::string::npos);
  plot.values = {1, 2, 3};
  output::draw(plot, folder_ / "field.png");
  EXPECT_NE(read("field.gp").find("set cbrange [1:3]"), std::string::npos);
  EXPECT_EQ(read("field.png").substr(1, 3), "PNG");
}

TEST_F(Pictures, WithoutGnuplotAreOneSentence) {
  const pid_t child = fork();
  if (child == 0) {
    setenv("PATH", folder_.c_str(), 1);
    try {
      output::draw(make_curve(), folder_ / "curve.svg");
    } catch (const Error& error) {
      const std::string expected = "cannot draw '" + (folder_ / "curve.svg").string() +
                                   "': gnuplot is not installed (Debian: apt install gnuplot-nox); the script for it "
                                   "stands beside it";
      _exit(error.what() == expected && error.code() == ExitCode::cannot_write ? 0 : 1);
    }
    _exit(2);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  EXPECT_FALSE(fs::exists(folder_ / "curve.svg"));
  EXPECT_TRUE(fs::exists(folder_ / "curve.gp"));
}

TEST_F(Pictures, ThatGnuplotCannotDrawLeaveNoFile) {
  EXPECT_THROW(output::run_gnuplot(folder_ / "bad.svg", "plot nonsense(\n", 100, 100), Error);
  EXPECT_FALSE(fs::exists(folder_ / "bad.svg"));
  EXPECT_FALSE(fs::exists(folder_ / "bad.svg.part"));
  EXPECT_THROW(output::run_gnuplot(folder_ / "bad.pdf", "plot x\n", 100, 100), Error);
}

TEST_F(Pictures, OfASectionNameEverySurfaceWithItsFactor) {
  output::SectionPlot plot;
  plot.title = "A bank";
  plot.outlines = {{{0, 0}, {20, 0}, {20, 5}, {10, 5}, {5, 10}, {0, 10}}};
  plot.surfaces = {
      {"lem.bishop", "Bishop, critical circle", Method::lem, 1.2344, {{2, 10}, {6, 6}, {12, 5}}, {}, {}, {}},
      {"fem.band", "Shear band of FEM", Method::fem, 1.1, {{1, 10}, {6, 5}, {13, 5}}, {}, {}, {}}};
  plot.length_unit = "cm";
  output::draw(plot, folder_ / "section.svg");
  const std::string script = read("section.gp");
  for (const char* part : {"'1.234  Bishop, critical circle'", "'1.100  Shear band of FEM'", "'A bank'", "'x [cm]'",
                           "$outlines << END\n0 0\n2000 0\n", "$surface0 << END\n200 1000\n600 600\n"})
    EXPECT_NE(script.find(part), std::string::npos) << part;
  EXPECT_LT(script.find("$surface1 using"), script.find("$surface0 using")) << "lines lie on bands";
  const DrawnFrame frame = read_frame(script);
  const double wide = frame.width * (frame.right - frame.left), high = frame.height * (frame.top - frame.bottom);
  EXPECT_NEAR(wide / high, (frame.x1 - frame.x0) / (frame.y1 - frame.y0), 0.01) << "lengths are true";
  EXPECT_EQ(script.find("$ponds"), std::string::npos);
  plot.water.emplace();
  plot.water->water_table = {{{0, 8}, {8, 7}}};
  plot.water->ponds = {{{8, 7}, {10, 5}, 7, 7}, {{10, 5}, {20, 5}, 7, 7}};
  output::draw(plot, folder_ / "wet.svg");
  const std::string wet = read("wet.gp");
  for (const char* part : {"$ponds << END\n800 700\n800 700\n1000 700\n1000 500\n", "$table << END\n0 800\n800 700\n"})
    EXPECT_NE(wet.find(part), std::string::npos) << part;
  EXPECT_LT(wet.find("$ponds using"), wet.find("$surface0 using")) << "surfaces lie on the water";
  plot.surfaces.clear();
  EXPECT_THROW(output::draw(plot, folder_ / "none.svg"), Error);
}

TEST_F(Pictures, OfASectionInMapCoordinatesHaveAllDigits) {
  output::SectionPlot plot;
  plot.title = "A bank";
  plot.outlines = {{{441871.25, 6329700.5}, {441891.25, 6329700.5}, {441881.125, 6329710.0625}}};
  plot.surfaces = {
      {"lem.bishop", "Bishop", Method::lem, 1.2344, {{441873.3333, 6329707}, {441880, 6329701}}, {}, {}, {}}};
  output::draw(plot, folder_ / "section.svg");
  const std::string script = read("section.gp");
  for (const char* part :
       {"441871.25 6329700.5\n", "441881.125 6329710.0625\n", "$surface0 << END\n441873.3333 6329707\n"})
    EXPECT_NE(script.find(part), std::string::npos) << part;
  const DrawnFrame map = read_frame(script);
  plot.outlines = {{{0, 0}, {20, 0}, {9.875, 9.5625}}};
  plot.surfaces[0].points = {{2.0833, 6.5}, {8.75, 0.5}};
  output::draw(plot, folder_ / "local.svg");
  const DrawnFrame local = read_frame(read("local.gp"));
  EXPECT_NEAR(map.x1 - map.x0, local.x1 - local.x0, 1e-6);
  // The heights of a map need three digits more than the margin had space for.
  EXPECT_NEAR(map.width * map.left - local.width * local.left, 3 * 7, 1);
}

TEST(Coordinates, NameAPlaceOfAMap) {
  EXPECT_EQ(format_coordinate(4000012.5), "4000012.5");
  EXPECT_EQ(format_coordinate(6329707.123456), "6329707.12346");
  EXPECT_EQ(format_coordinate(-1e-9), "0");
  EXPECT_EQ(format_coordinate(20.0 / 3), "6.66667");
  EXPECT_EQ(format_point(std::array{441871.25, 850.0, -0.5}), "(441871.25, 850, -0.5)");
}

/// Exit code and output of the program.
std::pair<int, std::string> run_program(const std::string& arguments) {
  std::FILE* pipe = popen((std::string(TALUS_PROGRAM) + " " + arguments + " 2>&1").c_str(), "r");
  std::string text;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) text += static_cast<char>(c);
  const int status = pclose(pipe);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text};
}

TEST_F(Pictures, AreDrawnByTheCommandPlot) {
  output::Frame frame;
  frame.time = 2.5;
  frame.stage = "failure";
  frame.positions = {0, 0, 0, 1, 0, 0, 1, 1, 0};
  frame.ids = {0, 1, 2};
  frame.materials = {0, 0, 0};
  frame.point_fields = {{"deviatoric_strain", "-", 1, {0, 0.1, 0.2}},
                        {"stress", "Pa", 6, {-1e3, -2e3, -3e3, 0, 0, 0, -2e3, -4e3, -6e3, 0, 0, 0, 0, 0, 0, 0, 0, 0}}};
  output::ResultsWriter::start(folder_).write(frame);
  std::ofstream(folder_ / "summary.json")
      << R"({"format": 2, "curve": {"points": [{"srf": 1.0, "displacement": 0.001}, {"srf": 1.5, "displacement": 0.002},
             {"srf": 1.6, "displacement": 0.01}, {"srf": 1.7, "displacement": 0.02}],
             "bilinear": {"factor": 1.5, "first": {"slope": 0.002, "intercept": -0.001, "points": [1.0, 1.5]},
                          "second": {"slope": 0.1, "intercept": -0.15, "points": [1.6, 1.7]}},
             "criteria": [{"name": "bilinear", "factor": 1.5, "lower": null, "upper": null},
                          {"name": "jump", "factor": null}]}})";
  const std::string folder = folder_.string();
  auto [code, text] = run_program("plot '" + folder + "'");
  EXPECT_EQ(code, 0) << text;
  EXPECT_EQ(text, folder + "/curve.svg\n" + folder + "/deviatoric_strain_0000.svg\n");
  std::tie(code, text) = run_program("plot '" + folder + "' --field stress --frame 0 --format png");
  EXPECT_EQ(code, 0) << text;
  EXPECT_NE(read("stress_0000.gp").find("set cbrange [-4:0]"), std::string::npos);  // means in kPa: -2, -4, 0
  EXPECT_NE(read("stress_0000.gp").find("[kPa]"), std::string::npos);
  std::tie(code, text) = run_program("plot '" + folder + "' --field suction");
  EXPECT_EQ(code, 2);
  EXPECT_NE(text.find("there is no field 'suction' in '" + folder + "'; the fields are deviatoric_strain, stress"),
            std::string::npos)
      << text;
  std::tie(code, text) = run_program("plot '" + folder + "' --field stress.yy --frame 7");
  EXPECT_EQ(code, 2);
  EXPECT_NE(text.find("there is no frame 7"), std::string::npos) << text;
}

TEST_F(Pictures, OfSlicesAloneAreTheSection) {
  const std::string folder = folder_.string();
  const auto write = [&](const std::string& surfaces) {
    std::ofstream(folder_ / "summary.json")
        << R"({"format": 2, "title": "Bank", "outlines": [[[0, 0], [9, 0], [0, 9]]], "lem": {},
                                                   "methods": {"surfaces": [)" +
               surfaces + "]}}";
  };
  write(R"({"name": "lem.bishop", "title": "Bishop", "method": "lem", "factor": 1.5, "points": [[0, 9], [5, 4]]})");
  auto [code, text] = run_program("plot '" + folder + "'");
  EXPECT_EQ(code, 0) << text;
  EXPECT_EQ(text, folder + "/section.svg\n");
  EXPECT_NE(read("section.svg").find("1.500  Bishop"), std::string::npos);
  write("");
  std::tie(code, text) = run_program("plot '" + folder + "'");
  EXPECT_EQ(code, 2);
  EXPECT_NE(text.find("have found no slip surface"), std::string::npos) << text;
}

}  // namespace
