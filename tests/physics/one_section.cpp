// SPDX-License-Identifier: MIT
// One section under all methods: LEM, FEM and limit analysis take the same weights, loads, pore pressures, strengths
// and supports from a random case, before and after a stage that changes nothing, and drawn to either side.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <optional>

#include "fem/solid/system.hpp"
#include "input/read.hpp"
#include "lem/section/bars.hpp"
#include "lem/slices/solve.hpp"
#include "material/every_law.hpp"
#include "mesh/locate.hpp"
#include "run/bounds/case_fields.hpp"
#include "run/bounds/problem_of_case.hpp"
#include "run/common/section_of_case.hpp"
#include "run/construction/stage_model.hpp"
#include "run/fem/solid_of_case.hpp"
#include "support/draw.hpp"
#include "support/scratch.hpp"

namespace talus {
namespace {

constexpr double gamma_w = 9810, width = 24;

/// A bank of sand on clay that falls to the right, or its mirror image, with whatever a draw gives it.
struct Bank {
  double height, crest, toe, border;  // the ground falls from `crest` to `toe` (x), the border is level
  double strip_from, strip_to, strip_left, strip_right;  // surcharge on the crest [kPa]
  double level_left, level_right;                        // of the water, straight between the sides
  bool is_mirrored, has_stage, has_bars, has_roots, has_quake, bond_grows;
  std::string source, wet, clay;
  std::filesystem::path folder;

  Bank(unsigned seed, const std::filesystem::path& scratch) : folder(scratch) {
    support::Draw draw(seed);
    const auto pick = [&](std::initializer_list<const char*> words) {
      return std::string(words.begin()[std::min<std::size_t>(
          words.size() - 1, static_cast<std::size_t>(draw(0, static_cast<double>(words.size()))))]);
    };
    const auto round = [](double v) { return std::round(1e3 * v) / 1e3; };
    height = round(draw(3, 6)), crest = round(draw(6, 9)), toe = round(crest + height * draw(1, 2));
    border = round(draw(-2, 0.8 * height));
    strip_from = round(draw(1.5, 3)), strip_to = round(draw(4, 5.5));
    strip_left = round(draw(0, 40)), strip_right = round(draw(0, 40));
    level_left = round(draw(-1, 0.9 * height)), level_right = round(std::min(level_left, draw(-2, 1.5)));
    is_mirrored = draw(0, 1) < 0.5, has_stage = draw(0, 1) < 0.4, has_bars = draw(0, 1) < 0.4;
    has_roots = draw(0, 1) < 0.3, has_quake = draw(0, 1) < 0.3, bond_grows = draw(0, 1) < 0.5;
    source = pick({"none", "table", "table", "lines", "grid", "ratio", "ratio_grid"});
    wet = pick({"none", "none", "sand", "clay", "both"});
    clay = pick({"mohr_coulomb", "mohr_coulomb", "tresca", "gradient", "profile", "shansep"});
    // Stages start from one field of pressure.
    if (has_stage && source != "table" && source != "grid" && source != "none") wet = "none";
    if (source == "none") wet = "none";
    if (has_stage) has_quake = false;
    // Soil in total stresses has pore water of its own in stages alone.
    if (!has_stage && clay != "mohr_coulomb") wet = wet == "both" || wet == "sand" ? "sand" : "none";
  }

  double to_x(double x) const { return is_mirrored ? width - x : x; }
  double find_ground(double x) const {
    const double u = to_x(x);
    return u < crest ? height : u < toe ? height * (toe - u) / (toe - crest) : 0;
  }
  double find_level(double x) const { return level_left + (level_right - level_left) * to_x(x) / width; }
  bool has_standing_water() const { return source == "table" || source == "lines"; }

  std::string write_line(std::vector<std::array<double, 2>> points) const {
    for (auto& p : points) p[0] = to_x(p[0]);
    if (is_mirrored) std::reverse(points.begin(), points.end());
    std::string text;
    for (const auto& [x, y] : points) text += fmt::format("{}[{}, {}]", text.empty() ? "" : ", ", x, y);
    return "[" + text + "]";
  }

  std::string write_water() const {
    const std::string table = write_line({{0, level_left}, {width, level_right}}),
                      raised = write_line({{0, level_left + 0.7}, {width, level_right + 0.7}});
    if (source == "table")
      return fmt::format("initial = {{ pore_pressure = \"water_table\", water_table = {} }}\n", table);
    if (source == "lines")
      return fmt::format(
          "initial = {{ pore_pressure = \"water_table\", water_table = {}, piezometric_line = [{{ materials = "
          "[\"clay\"], points = {} }}] }}\n",
          table, raised);
    if (source == "grid" || source == "ratio_grid") {
      const bool is_ratio = source == "ratio_grid";
      std::ofstream file(folder / "grid.csv");
      file << "x [m], y [m], " << (is_ratio ? "r_u" : "head [m]") << "\n";
      for (const double x : {-1.0, width + 1})
        for (const double y : {-9.0, 9.0})
          file << fmt::format("{}, {}, {:.17g}\n", x, y, is_ratio ? 0.2 : find_level(x));
      return fmt::format(
          "initial = {{ pore_pressure = \"grid\", pressure_grid = {{ file = \"grid.csv\", quantity = \"{}\" }} }}\n",
          is_ratio ? "r_u" : "head");
    }
    return "initial = { pore_pressure = \"zero\" }\n";
  }

  std::string write_soils() const {
    std::string text;
    for (const std::string soil : {"sand", "clay"}) {
      const bool is_plain = soil == "sand" || clay == "mohr_coulomb";
      text += fmt::format(
          "[materials.{}]\nmodel = \"{}\"\nunit_weight = 18\nsaturated_unit_weight = 20.5\nporosity = 0.4\n"
          "young_modulus = 3e4\npoisson_ratio = 0.3\n",
          soil,
          is_plain            ? (has_roots && soil == "sand" ? "rooted_mohr_coulomb" : "mohr_coulomb")
          : clay == "shansep" ? "shansep"
                              : "tresca");
      if (is_plain)
        text += fmt::format("cohesion = {}\nfriction_angle = {}\ndilatancy_angle = 0\ntensile_strength = 0\n",
                            soil == "sand" ? 4 : 12, soil == "sand" ? 33 : 24);
      else if (clay == "shansep")
        text += "strength_ratio = 0.25\nstrength_exponent = 0.8\nocr = 2\n";
      else if (clay == "profile")
        text += "profile_depths = [0, 2, 9]\nprofile_strengths = [30, 22, 61]\n";
      else
        text += fmt::format("undrained_strength = 25\n{}",
                            clay == "gradient" ? "undrained_gradient = 1.7\nundrained_level = 1\n" : "");
      if (source == "ratio" && is_plain) text += "pore_pressure_ratio = 0.2\n";
      if (wet == "both" || wet == soil)
        text += fmt::format("[materials.{}.water]\nretention = \"saturated\"\nconductivity = \"1e-8 m/s\"\n", soil);
    }
    return text;
  }

  std::string write() const {
    std::string text = fmt::format(R"(
analysis.methods = ["lem", "fem", "bounds"]
unusual = ["materials"]
mesh.size = 1.5
bounds.size = 1.5
fem = {{ size = 1.5, meshes = 1 }}
geometry.ground = {}
geometry.layer = [{{ name = "sand", level = {} }}, {{ name = "clay", level = -5 }}]
geometry.line = [{{ name = "bench", points = {} }}]
regions = {{ sand = "sand", clay = "clay" }}
surcharge = [{{ name = "store", x = [{}, {}], load = [{}, {}] }}]
)",
                                   write_line({{0, height}, {crest, height}, {toe, 0}, {width, 0}}), border,
                                   write_line({{crest, height}, {toe, 0}}), is_mirrored ? to_x(strip_to) : strip_from,
                                   is_mirrored ? to_x(strip_from) : strip_to, is_mirrored ? strip_right : strip_left,
                                   is_mirrored ? strip_left : strip_right);
    text += fmt::format("traction = [{{ on = \"bench\", traction = [{}, -7] }}]\n", is_mirrored ? -3 : 3);
    text += write_water();
    if (has_stage) text += "construction = [{ name = \"nothing\", duration = \"1 s\", add = [] }]\n";
    if (has_quake) text += "earthquake = { horizontal = 0.1, vertical = 0.05, direction = \"right\" }\n";
    if (has_roots) text += "roots = [{ ground = \"bench\", depth = 1.2, cohesion = 6, profile = \"uniform\" }]\n";
    if (has_bars)
      text += fmt::format(
          "[support.nails]\nkind = \"nail\"\nheads = {}\nends = {}\nout_of_plane_spacing = 1.5\n"
          "tensile_strength = 120\nplate = 30\naxial_stiffness = 8e4\n{}\n",
          write_line({{crest + 0.3 * (toe - crest), 0.7 * height}}), write_line({{crest - 3, 0.7 * height - 1}}),
          bond_grows ? "bond_adhesion = 20\nbond_friction = 20\ndiameter = 0.1" : "bond = 15");
    return text + write_soils();
  }
  std::string describe() const {
    return fmt::format("water {}, pore water of {}, clay {}{}{}{}{}{}", source, wet, clay,
                       is_mirrored ? ", mirrored" : "", has_stage ? ", stage" : "", has_bars ? ", nails" : "",
                       has_roots ? ", roots" : "", has_quake ? ", earthquake" : "");
  }

  /// Integrates over the ground between two places; the steps make jumps of the load an error of 1e-4.
  template <class Value>
  double integrate(double from, double to, Value value) const {
    constexpr int steps = 40000;
    double sum = 0;
    for (int i = 0; i < steps; ++i) sum += value(from + (i + 0.5) / steps * (to - from));
    return sum * (to - from) / steps;
  }
  /// Returns the loads on the ground by hand: down and towards larger x [N/m].
  std::array<double, 2> sum_loads(double from, double to) const {
    std::array<double, 2> sum{};
    const double rise = (is_mirrored ? 1 : -1) * height / (toe - crest), along = std::sqrt(1 + rise * rise);
    sum[0] = integrate(from, to, [&](double x) {
      const double u = to_x(x), share = (u - strip_from) / (strip_to - strip_from);
      double down = share >= 0 && share <= 1 ? 1e3 * (strip_left + (strip_right - strip_left) * share) : 0;
      if (u > crest && u < toe) down += 7e3 * along;
      if (has_standing_water()) down += gamma_w * std::max(0.0, find_level(x) - find_ground(x));
      return down;
    });
    sum[1] = integrate(from, to, [&](double x) {
      const double u = to_x(x);
      if (u <= crest || u >= toe) return 0.0;
      const double water = has_standing_water() ? gamma_w * std::max(0.0, find_level(x) - find_ground(x)) : 0;
      return (is_mirrored ? -3e3 : 3e3) * along + water * rise;
    });
    return sum;
  }
};

/// Models of the three methods of one case.
struct Models {
  site::Site site;
  lem::Slope slope;
  run::SolidOfCase<2> solid;
  run::ProblemOfCase made;

  explicit Models(const input::Case& data)
      : site(data),
        slope(run::make_section(site).section),
        solid(run::make_solid<2>(site)),
        made(run::make_bounds_problem(site)) {}

  const std::string& get_soil(int region) const {
    return site.data().regions.at(solid.mesh->region_names[static_cast<std::size_t>(region)]);
  }
};

input::Case read_bank(const Bank& bank) {
  input::Case data = input::read_case_text(bank.write(), (bank.folder / "case.toml").string()).data;
  if (!bank.has_stage) return data;
  std::vector<std::string> notes;
  return run::make_stage_model(data, run::before_stages, run::make_whole_mesh(data, notes), nullptr)->data;
}

/// Weight of the section and resultants of its loads.
void expect_same_loads(const Bank& bank, const Models& models) {
  const mesh::Mesh<2>& mesh = *models.solid.mesh;
  double fem = 0, limit = 0, uncertain = 0;
  for (int e = 0; e < mesh.element_count(); ++e) {
    const auto n = static_cast<std::size_t>(e);
    if (mesh.element_region[n] == mesh::empty_region) continue;
    fem += models.solid.model.unit_weight[n] * mesh.volumes[n];
    // The soil of an element through which the water table passes weighs what it does at its middle.
    double low = 1e9, high = -1e9;
    for (const int node : mesh.elements[n]) {
      const auto& x = mesh.nodes[static_cast<std::size_t>(node)];
      for (const double raised : {0.0, bank.source == "lines" ? 0.7 : 0.0})
        low = std::min(low, x[1] - bank.find_level(x[0]) - raised), high = std::max(high, x[1] - bank.find_level(x[0]));
    }
    if (low < 0 && high > 0) uncertain += 2500 * mesh.volumes[n];
  }
  const bounds::Problem& problem = models.made.problem;
  for (std::size_t e = 0; e < problem.size(); ++e)
    limit -= problem.body_force[e][1] * bounds::find_shape(problem, e).area;
  int soil = 0;
  const double lem = bank.integrate(0, width, [&](double x) { return models.slope.weight_above(x, -5, soil); });
  const double vertical = bank.has_quake ? 1.05 : 1;
  EXPECT_NEAR(fem, lem, 1e-5 * lem + uncertain) << "weight in FEM and LEM";
  EXPECT_NEAR(limit, vertical * lem, 1e-5 * lem + uncertain) << "weight in limit analysis and LEM";
  EXPECT_NEAR(models.solid.model.direction[1], -vertical, 1e-12);
  EXPECT_NEAR(std::abs(models.solid.model.direction[0]), bank.has_quake ? 0.1 : 0, 1e-12);
  EXPECT_NEAR(models.slope.section().horizontal_acceleration, bank.has_quake ? 0.1 : 0, 1e-12);

  const auto [down, right] = bank.sum_loads(0, width);
  const double near = 1e-3 * down;
  std::array<double, 2> of_fem{}, of_limit{};
  for (const auto& load : models.solid.model.loads)
    for (std::size_t s = 0; s < load.sides.size(); ++s) {
      const auto &a = mesh.nodes[static_cast<std::size_t>(load.sides[s][0])],
                 &b = mesh.nodes[static_cast<std::size_t>(load.sides[s][1])];
      for (const Vec<2>& t : load.traction[s])
        for (std::size_t d = 0; d < 2; ++d) of_fem[d] += 0.5 * t[d] * std::hypot(a[0] - b[0], a[1] - b[1]);
    }
  for (const bounds::Side& side : problem.sides) {
    const auto &a = problem.nodes[static_cast<std::size_t>(side.from)],
               &b = problem.nodes[static_cast<std::size_t>(side.to)];
    for (const Vec<2>& t : side.traction)
      for (std::size_t d = 0; d < 2; ++d) of_limit[d] += 0.5 * t[d] * std::hypot(a[0] - b[0], a[1] - b[1]);
  }
  EXPECT_NEAR(of_fem[1], -down, near) << "FEM";
  EXPECT_NEAR(of_fem[0], right, near) << "FEM";
  EXPECT_NEAR(of_limit[1], -down, near) << "limit analysis";
  EXPECT_NEAR(of_limit[0], right, near) << "limit analysis";
}

/// A deep surface from the crest to the foreland, cut into slices.
lem::CutSurface cut(const Bank& bank, const lem::Slope& slope) {
  lem::Surface surface;
  std::vector<lem::Point> points{
      {bank.to_x(1), 0}, {bank.to_x(bank.height + 3), -1.9}, {bank.to_x(width - 4.5), -3.1}, {bank.to_x(width - 1), 0}};
  if (bank.is_mirrored) std::reverse(points.begin(), points.end());
  for (lem::Point* end : {&points.front(), &points.back()}) (*end)[1] = slope.ground((*end)[0]);
  surface.line = points;
  surface.from = points.front()[0], surface.to = points.back()[0];
  lem::Checks checks;
  checks.reject = false;
  return lem::cut_surface(slope, surface, 60, checks);
}

void expect_same_slices(const Bank& bank, const lem::CutSurface& cut) {
  ASSERT_EQ(cut.refusal, lem::Refusal::none);
  double down = 0, right = 0;
  for (const lem::Slice& slice : cut.slices) {
    down += slice.surface_load;
    right += (cut.slides_left ? 1 : -1) * slice.surface_thrust;
  }
  const auto sum = bank.sum_loads(cut.slices.front().left, cut.slices.back().right);
  EXPECT_NEAR(down, sum[0], 1e-3 * sum[0]) << "LEM";
  EXPECT_NEAR(right, sum[1], 1e-3 * sum[0]) << "LEM";
}

/// Returns how far Mohr's circle is from the envelope of c and φ after shear far beyond yield, from a mean stress
/// [Pa].
double miss_strength(const Models& models, int region, const Vec<2>& x, double cohesion, double tan_friction) {
  const material::Law law = models.solid.model.make_law(region, 1);
  std::array<double, material::max_state_size> state{};
  if (models.solid.model.set_state) models.solid.model.set_state(region, x, state.data());
  std::array<double, 4> stress{-80e3, -80e3, -80e3, 0};
  for (int i = 0; i < 40; ++i) {
    const std::array<double, 4> increment{0, 0, 0, 1e-3};
    fem::update_point<4>(law, 1, increment.data(), stress.data(), state.data(), nullptr);
  }
  const double radius = std::hypot(0.5 * (stress[0] - stress[1]), stress[3]), mean = 0.5 * (stress[0] + stress[1]),
               cosine = 1 / std::sqrt(1 + tan_friction * tan_friction);
  return radius - cosine * (cohesion - mean * tan_friction);
}

/// Pressures and strengths at the bases of the slices.
void expect_same_soil(const Models& models, const lem::CutSurface& cut) {
  const mesh::Mesh<2>& mesh = *models.solid.mesh;
  const bounds::Problem& problem = models.made.problem;
  const std::size_t count = problem.size();
  for (const lem::Slice& slice : cut.slices) {
    const Vec<2> x{0.5 * (slice.base_left[0] + slice.base_right[0]), 0.5 * (slice.base_left[1] + slice.base_right[1])};
    const lem::Soil& soil = models.slope.section().soils[static_cast<std::size_t>(slice.soil)];
    const int e = mesh::find_element(mesh, x);
    ASSERT_GE(e, 0);
    const int region = mesh.element_region[static_cast<std::size_t>(e)];
    ASSERT_EQ(models.get_soil(region), soil.name);
    std::optional<std::size_t> in;
    for (std::size_t t = 0; t < count && !in; ++t) {
      bool holds = true;
      for (std::size_t c = 0; c < 3; ++c) {
        const auto &a = problem.nodes[static_cast<std::size_t>(problem.triangles[t][c])],
                   &b = problem.nodes[static_cast<std::size_t>(problem.triangles[t][(c + 1) % 3])];
        holds = holds && (b[0] - a[0]) * (x[1] - a[1]) - (b[1] - a[1]) * (x[0] - a[0]) > 1e-9;
      }
      if (holds) in = t;
    }
    if (!in) continue;  // on an edge
    const std::string where = fmt::format("{} at {}, {}", soil.name, x[0], x[1]);
    const double pressure = models.made.fields->find_pressures({{*in, x}})[0];
    const double in_slice = soil.undrained ? 0 : std::max(0.0, slice.pore_pressure);
    EXPECT_NEAR(std::max(0.0, pressure), in_slice, 1e-6 * gamma_w + 1e-6 * in_slice) << where;
    const double cohesion = models.made.fields->find_cohesions({{*in, x}}, bounds::Bound::lower)[0];
    const double own = slice.cohesion - slice.suction_strength;  // suction is a stress in limit analysis and FEM
    EXPECT_NEAR(cohesion, own, 1e-6 * own + 1) << where;
    EXPECT_NEAR(miss_strength(models, region, x, own, slice.tan_friction), 0, 1e-3 * (own + 80e3)) << "FEM, " << where;
  }
}

/// Places and largest forces of the bars.
void expect_same_bars(const Models& models) {
  const lem::Section& section = models.slope.section();
  ASSERT_EQ(section.bars.size(), models.solid.model.bars.size());
  for (std::size_t i = 0; i < section.bars.size(); ++i) {
    const lem::Bar& bar = section.bars[i];
    const fem::Bar& other = models.solid.model.bars[i];
    EXPECT_EQ(bar.head, other.head);
    EXPECT_EQ(bar.end, other.end);
    EXPECT_NEAR(bar.tensile, other.tensile, 1e-9 * bar.tensile);
    EXPECT_NEAR(bar.plate, other.plate, 1e-9 * bar.plate);
    const lem::BarDiagram diagram = lem::make_bar_diagram(models.slope, bar);
    const double length = std::hypot(bar.end[0] - bar.head[0], bar.end[1] - bar.head[1]);
    constexpr int parts = 400;
    double behind = 0;
    for (int k = parts; k-- > 0;) {
      const double s = (k + 0.5) / parts * length;
      behind += other.bond({bar.head[0] + s / length * (bar.end[0] - bar.head[0]),
                            bar.head[1] + s / length * (bar.end[1] - bar.head[1])}) *
                length / parts;
      if (k % 100 == 0) {
        EXPECT_NEAR(behind, diagram.find_part(k * length / parts, length), 2e-3 * behind) << k;
      }
    }
    for (const bounds::BarEdge& edge : models.made.problem.bars)
      for (std::size_t end = 0; end < 2; ++end) {
        const Vec<2>& x = models.made.problem.nodes[static_cast<std::size_t>(end == 0 ? edge.from : edge.to)];
        const double s = std::hypot(x[0] - bar.head[0], x[1] - bar.head[1]);
        const double most = std::min({bar.tensile, bar.plate + diagram.find_part(0, s), diagram.find_part(s, length)});
        EXPECT_LE(edge.force[end], most * (1 + 1e-6) + 1) << s;
        EXPECT_GE(edge.force[end], 0.97 * most - 1) << s;
      }
  }
}

void expect_one_section(unsigned from, unsigned to) {
  const auto scratch = support::make_scratch("one_section");
  for (unsigned seed = from; seed < to; ++seed) {
    const Bank bank(seed, scratch);
    SCOPED_TRACE(fmt::format("seed {}: {}", seed, bank.describe()));
    const Models models(read_bank(bank));
    const lem::CutSurface surface = cut(bank, models.slope);
    expect_same_loads(bank, models);
    expect_same_slices(bank, surface);
    expect_same_soil(models, surface);
    expect_same_bars(models);
    if (testing::Test::HasFailure()) break;
  }
}

TEST(OneSection, IsThatOfAllMethods) {
  expect_one_section(1, 7);
}

TEST(OneSectionOfManyCases, IsThatOfAllMethods) {
  expect_one_section(7, 201);
}

}  // namespace
}  // namespace talus
