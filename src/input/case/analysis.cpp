// SPDX-License-Identifier: MIT
#include "input/case/analysis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "base/text.hpp"
#include "base/user_file.hpp"
#include "input/case/checks.hpp"
#include "input/case/output.hpp"
#include "input/language/visitor.hpp"

namespace talus::input {

void describe(Visitor& v, AnalysisBlock& a) {
  v.key("methods", a.methods, plain(),
        "The methods of the calculation, in one report. Without \"mpm\" a case needs no box, no stage, no boundary "
        "and, with \"lem\" alone, no mesh and no stiffness; with \"seepage\" alone, no weight and no strength either. "
        "Where "
        "such keys are given, they are not used.");
  v.key("kind", a.kind, plain(), "Analysis by MPM.");
}

void describe(Visitor& v, DisplacementCurve& c) {
  v.key("enabled", c.enabled, plain(), "Calculate the curve.");
  v.key("from", c.from, plain().above(0), "First strength reduction factor.");
  v.key("to", c.to, plain().above(0), "Last strength reduction factor.");
  v.key("step", c.step, plain().above(0), "Distance of the factors.");
  v.key("refine", c.refine, plain(), "Halve the intervals where the curve bends.");
  v.key("refine_step", c.refine_step, plain().above(0), "Smallest interval.");
  v.key("window", c.window, quantity("s").above(0), "Observation time of a trial.");
  describe(v, c.step_settings);
  v.key("initial_branch", c.initial_branch, plain().above(0).example("[1.0, 1.2]"),
        "From and to which factor the first line is fitted; empty: chosen from the data.");
  v.key("final_branch", c.final_branch, plain().above(0).example("[1.5, 1.7]"),
        "From and to which factor the second line is fitted; empty: chosen from the data.");
  v.key("displacement_ratio", c.displacement_ratio, plain().above(0),
        "Displacement over the relief of the ground that counts as failure in the second criterion.");
  v.key("runout", c.runout, plain().above(0).example("[1.6, 1.7]"), "Factors whose trials continue until rest.");
  v.key("runout_time", c.runout_time, quantity("s").above(0), "Longest time of such a trial.");
}

void describe(Visitor& v, FrozenFactor& f) {
  v.key("enabled", f.enabled, plain(), "Calculate this factor of safety.");
  v.key("from", f.from, plain().above(0), "Lower end of the first bracket; widened when the factor is not in it.");
  v.key("to", f.to, plain().above(0), "Upper end of the first bracket.");
  v.key("resolution", f.resolution, plain().above(0), "Width of the last bracket.");
  v.key(
      "meshes", f.meshes, plain().at_least(1).at_most(3),
      "1: one mesh of the case's element size. 2: also one of half that size and one of twice it, which costs little; "
      "the factor is extrapolated to size zero by a line through the three. 3: instead of twice it, a quarter.");
  v.key("mesh_scatter", f.mesh_scatter, plain(),
        "With two meshes, calculate the coarse one by another mesher too. The interval that is printed is no narrower "
        "than the distance of the two factors.");
  v.key("algorithm", f.algorithm, plain(),
        "Gmsh's algorithm for these meshes (a ready mesh file is used as it is). Irregular ones lock least.");
  v.key("corner_refinement", f.corner_refinement, plain().at_least(1).at_most(16),
        "How many times smaller the elements of these meshes are at corners of the ground that point into the soil, "
        "such as a slope's toe. They reach the general size 8 sizes away. 1: no smaller. A ready mesh file, or a "
        "result's, is used as it is.");
  v.key("window", f.window, quantity("s").above(0), "A trial that has not decided by then is reported as undecided.");
  v.key("failed_displacement", f.failed_displacement, plain().above(0),
        "Displacement over the relief of the ground that decides \"failed\".");
  describe(v, f.step_settings);
  v.table("rest", f.rest, "What decides \"at rest\" in a trial.");
}

void describe(Visitor& v, StrengthReduction& s) {
  v.table("curve", s.curve,
          "Displacement over strength reduction factor on moving geometry, and the constructions on that curve.");
  v.table("frozen", s.frozen, "The factor of safety from rest or run-away at frozen geometry, by bisection.");
}

namespace {

bool some_material(const Case& data, auto holds) {
  return std::any_of(data.materials.begin(), data.materials.end(),
                     [&](const auto& entry) { return holds(entry.second); });
}

/// Lists the models with a strength that a factor can divide.
std::string list_strong() {
  return material::list_words([](const material::Traits& t) { return t.strength == material::Strength::known; });
}

bool has_cohesion(const Material& m) {
  return m.traits().has_friction;
}

/// Returns true if the case has a strength that a factor can divide.
bool has_strength(const Case& data) {
  return some_material(data,
                       [](const Material& m) { return m.traits().strength == material::Strength::known && m.reduced; });
}

/// Reports external models, because the constants of a UMAT that are its strength are unknown.
void check_no_external(const Case& data, const std::string& path, const std::string& what, Findings& findings) {
  for (const auto& [name, material] : data.materials)
    if (material.traits().strength == material::Strength::hidden && material.reduced)
      return findings.add(path,
                          "{} is not possible with material '{}': which of the constants of an external model are its "
                          "strength is not known",
                          what, name);
}

void check_stages(const Case& data, Findings& findings) {
  if (data.stages.empty() && uses(data, Method::mpm) && findings.is_sound("stage") &&
      findings.is_sound("analysis.methods"))
    findings.add("stage", "there is no stage: add a [[stage]] with a name and a duration");
  check_names(data.stages, "stage", "stages", findings);
  for (std::size_t i = 0; i < data.stages.size(); ++i) {
    const Stage& stage = data.stages[i];
    const std::string path = fmt::format("stage.{}", i);
    if (findings.is_sound(path + ".gravity_ramp") && findings.is_sound(path + ".duration") &&
        stage.gravity_ramp > stage.duration)
      findings.add(path + ".gravity_ramp", "'gravity_ramp' is {:.6g} s; it must not be longer than the stage, {:.6g} s",
                   stage.gravity_ramp, stage.duration);
    if (!findings.is_sound("materials")) continue;
    if (stage.cohesion && !some_material(data, has_cohesion))
      findings.add(path + ".cohesion",
                   "'cohesion' needs a material with model = " +
                       material::list_words([](const material::Traits& t) { return t.has_friction; }));
    if (!stage.strength_factor) continue;
    if (!has_strength(data))
      findings.add(path + ".strength_factor",
                   "'strength_factor' needs a material with a strength: model = " + list_strong());
    else
      check_no_external(data, path + ".strength_factor", "'strength_factor'", findings);
  }
}

void check_interval(const auto& trials, const std::string& path, Findings& findings) {
  if (findings.is_sound(path + ".from") && findings.is_sound(path + ".to") && trials.from >= trials.to)
    findings.add(findings.places.is_given(path + ".from") ? path + ".from" : path + ".to",
                 "'from' is {:.6g} and 'to' is {:.6g}; 'from' must be smaller", trials.from, trials.to);
}

void check_branch(const std::vector<double>& branch, const std::string& path, Findings& findings) {
  if (branch.empty() || !findings.is_sound(path)) return;
  if (branch.size() != 2 || branch[0] >= branch[1])
    findings.add(path, "'{}' must be [from, to], two increasing factors", path.substr(path.rfind('.') + 1));
}

void check_strength_reduction(const Case& data, Findings& findings) {
  const StrengthReduction& reduction = data.strength_reduction;
  const std::string curve = "strength_reduction.curve", frozen = "strength_reduction.frozen";
  check_interval(reduction.curve, curve, findings);
  check_interval(reduction.frozen, frozen, findings);
  check_branch(reduction.curve.initial_branch, curve + ".initial_branch", findings);
  check_branch(reduction.curve.final_branch, curve + ".final_branch", findings);
  if (findings.is_sound(curve + ".refine_step") && findings.is_sound(curve + ".step") &&
      reduction.curve.refine_step > reduction.curve.step)
    findings.add(findings.places.is_given(curve + ".refine_step") ? curve + ".refine_step" : curve + ".step",
                 "'refine_step' is {:.6g} and 'step' is {:.6g}; 'refine_step' must not be larger",
                 reduction.curve.refine_step, reduction.curve.step);
  if (data.analysis != AnalysisKind::strength_reduction || !uses(data, Method::mpm)) return;
  if (!findings.is_sound("analysis.kind")) return;
  if (findings.is_sound("materials")) {
    if (!has_strength(data))
      findings.add("analysis.kind", "strength reduction needs a material with a strength: model = " + list_strong());
    else
      check_no_external(data, "analysis.kind", "strength reduction", findings);
  }
  if (!reduction.curve.enabled && !reduction.frozen.enabled && findings.is_sound(frozen + ".enabled"))
    findings.add(frozen + ".enabled", "both the curve and the frozen factor are switched off; one must be enabled");
}

}  // namespace

void check_analysis(const Case& data, Findings& findings) {
  check_stages(data, findings);
  check_strength_reduction(data, findings);
  check_names(data.output.monitors, "output.monitor", "monitors", findings);
  for (std::size_t i = 0; i < data.output.monitors.size(); ++i)
    if (const std::string at = fmt::format("output.monitor.{}.name", i);
        findings.is_sound(at) && data.output.monitors[i].name.find_first_of(",\"\n\r") != std::string::npos)
      findings.add(
          at,
          "a monitor's name heads columns of monitors.csv; it must not hold commas, quotation marks or line breaks");
  std::set<std::string> keys;
  for (std::size_t i = 0; i < data.study.vary.size(); ++i)
    if (const std::string path = fmt::format("study.vary.{}.key", i);
        findings.is_sound(path) && !keys.insert(data.study.vary[i].key).second)
      findings.add(path, "the key '{}' is varied twice", data.study.vary[i].key);
}

// Checks of [output]: the stage at which times start, and sections.

namespace {

void check_section(const SectionLine& section, const std::string& path, Findings& findings) {
  // The name is used as a file name, as an anchor on the page, and in texts like those of [[compare]].
  if (findings.is_sound(path + ".name")) {
    if (section.name.empty() || section.name.front() == '.' ||
        section.name.find_first_of("/\\,\"[]") != std::string::npos)
      findings.add(
          path + ".name",
          "a section's name is that of a file; it must not be empty, begin with a point, or hold / \\ , \" [ ]");
    else if (const std::string fault = find_name_fault(make_printable(section.name)); !fault.empty())
      findings.add(path + ".name", "a section's name is that of a file: " + fault);
  }
  if (!findings.is_sound(path + ".from") || !findings.is_sound(path + ".to")) return;
  double square = 0;
  for (std::size_t d = 0; d < 3; ++d) square += (section.to[d] - section.from[d]) * (section.to[d] - section.from[d]);
  if (square == 0) findings.add(path + ".to", "'from' and 'to' are the same point; a section needs a length");
}

}  // namespace

void check_output(const Case& data, Findings& findings) {
  const std::string& stage = data.output.count_from;
  if (!stage.empty() && findings.is_sound("stage") && findings.is_sound("output.count_from") &&
      std::none_of(data.stages.begin(), data.stages.end(), [&](const Stage& s) { return s.name == stage; }))
    findings.add("output.count_from", "there is no stage '{}'", stage);
  for (std::size_t i = 0; i < data.output.sections.size(); ++i)
    check_section(data.output.sections[i], fmt::format("output.section.{}", i), findings);
  check_names(data.output.sections, "output.section", "sections", findings);
}

}  // namespace talus::input
