// SPDX-License-Identifier: MIT
// Checks of [seepage].
#include "input/case/seepage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "input/case/checks.hpp"
#include "input/case/soil_plan.hpp"
#include "input/language/visitor.hpp"

namespace talus::input {

void describe(Visitor& v, FlowSection& s) {
  v.key("name", s.name, plain().required().example(R"("core")"), "Name of the section in results.");
  v.key("points", s.points, quantity("m").required().example("[[30, 0], [30, 12]]"),
        "A line through the soil. Flow is positive to its right, seen from its first point to its last.");
}

void describe(Visitor& v, HeaveBlock& b) {
  v.key("name", b.name, plain().required().example(R"("behind the wall")"), "Name of the block in results.");
  v.key("x", b.x, quantity("m").required().example("[20, 22.5]"),
        "From where to where it reaches. Behind a cut-off: half its embedded depth (Terzaghi).");
  v.key("level", b.level, quantity("m").required().example("5"), "Level of its base, such as the tip of the cut-off.");
}

void describe(Visitor& v, SeepageAnalysis& s) {
  v.key("times", s.times, quantity("day").above(0).example(R"(["6 h", 1, 3])"),
        "Times after time 0 at which transient flow is written. It begins with the pore pressure of [initial]; the "
        "[[hydraulic]] series give the boundaries. Without times the flow is steady.");
  v.tables("section", s.sections, 0, "A line through which the discharge is computed.");
  v.tables("heave", s.blocks, 0,
           "A block of soil that upward flow may lift: F = buoyant weight over the force of the excess pore pressure "
           "at its base (Terzaghi).");
}

namespace {

/// Places on the base of a block, as in site/flow_measures.cpp.
constexpr int heave_places = 400;

bool knows_soil(const Case& data, const Findings& findings) {
  return data.mesh.file.empty() && data.mesh.dimension == 2 && findings.is_sound("geometry") &&
         findings.is_sound("mesh") && findings.is_sound("regions") && findings.is_sound("materials");
}

void check_plane(const Case& data, Findings& findings) {
  if (data.mesh.dimension == 2) return;
  if (!data.seepage.sections.empty())
    findings.add("seepage.section", "a section is a line, and 'dimension' is 3: it needs a plane case");
  if (!data.seepage.blocks.empty())
    findings.add("seepage.heave", "a block has two sides, and 'dimension' is 3: it needs a plane case");
}

void check_sections(const Case& data, Findings& findings) {
  check_names(data.seepage.sections, "seepage.section", "sections", findings);
  for (std::size_t i = 0; i < data.seepage.sections.size(); ++i) {
    const auto& points = data.seepage.sections[i].points;
    const std::string path = fmt::format("seepage.section.{}.points", i);
    if (!findings.is_sound(path)) continue;
    if (points.size() < 2)
      findings.add(path, "'points' has {} point{}; a line needs two", points.size(), points.size() == 1 ? "" : "s");
    else if (std::adjacent_find(points.begin(), points.end()) != points.end())
      findings.add(path, "'points' has the same point twice in a row");
    else if (knows_soil(data, findings) && !SoilPlan(data, data.mesh).meets_water(points))
      findings.add(path, "'points' of section '{}' cross no soil with pore water", data.seepage.sections[i].name);
  }
}

/// Checks that the base of a block is in soil with pore water, at as many places as its force is computed at.
void check_base(const Case& data, const HeaveBlock& block, const std::string& path, Findings& findings) {
  const SoilPlan soil(data, data.mesh);
  const ShownUnit& length = data.units().length;
  for (int i = 0; i < heave_places; ++i) {
    const double x = block.x[0] + (i + 0.5) * (block.x[1] - block.x[0]) / heave_places;
    if (soil.has_water_at({x, block.level})) continue;
    findings.add(path, "the base of block '{}' is not in soil with pore water at x = {}, y = {}", block.name,
                 format_coordinate(x, length), format_coordinate(block.level, length));
    return;
  }
}

void check_blocks(const Case& data, Findings& findings) {
  check_names(data.seepage.blocks, "seepage.heave", "blocks", findings);
  for (std::size_t i = 0; i < data.seepage.blocks.size(); ++i) {
    const HeaveBlock& block = data.seepage.blocks[i];
    const std::string path = fmt::format("seepage.heave.{}", i);
    if (findings.is_sound(path + ".x") && !(block.x[0] < block.x[1]))
      findings.add(path + ".x", "'x' goes from {} to {}; the second must be larger",
                   format_coordinate(block.x[0], data.units().length),
                   format_coordinate(block.x[1], data.units().length));
    else if (findings.is_sound(path) && knows_soil(data, findings))
      check_base(data, block, path, findings);
  }
}

}  // namespace

void check_seepage(const Case& data, Findings& findings) {
  const SeepageAnalysis& seepage = data.seepage;
  if (!uses(data, Method::seepage)) {
    const bool asks = !seepage.times.empty() || !seepage.sections.empty() || !seepage.blocks.empty();
    if (asks && findings.is_sound("seepage"))
      findings.add("seepage", "[seepage] needs \"seepage\" among the 'methods' of [analysis]");
    return;
  }
  if (!is_wet(data) && findings.is_sound("materials"))
    findings.add("analysis.methods",
                 "\"seepage\" needs soil with pore water, and no material has a table [materials.NAME.water]");
  const InitialPressure start = data.initial.water.pressure;
  if (start != InitialPressure::seepage && seepage.times.empty() && data.initial.water.season == 0 &&
      findings.is_sound("initial.pore_pressure") && findings.is_sound("seepage.times"))
    findings.add("initial.pore_pressure",
                 "nothing flows: give [seepage] times, or pore_pressure = \"seepage\" for steady flow");
  if (findings.is_sound("seepage.times") &&
      !std::is_sorted(seepage.times.begin(), seepage.times.end(), std::less_equal<>()))
    findings.add("seepage.times", "the times must increase");
  if (!seepage.times.empty() && data.initial.water.table && start == InitialPressure::grid &&
      data.initial.water.table->quantity == GridQuantity::ratio)
    findings.add("initial.pressure_grid.quantity", "transient flow cannot start from r_u; give pressures or heads");
  if (!seepage.times.empty() && !data.initial.water.lines.empty())
    findings.add("initial.piezometric_line",
                 "transient flow starts from one field of pressure; start from pore_pressure = \"seepage\" or from one "
                 "water table");
  check_plane(data, findings);
  check_sections(data, findings);
  check_blocks(data, findings);
}

}  // namespace talus::input
