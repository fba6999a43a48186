#include "report/content/roots.hpp"

#include <fmt/format.h>

#include <cmath>

#include "input/language/time_table.hpp"
#include "material/root_bundle.hpp"
#include "report/look_up.hpp"

namespace talus::report {

using nlohmann::json;

namespace {

/// A row of the echo has its first number in the unit of the key; so has the time that is looked up.
double find_share(const json& roots, const char* time, const char* table) {
  const json* at = find(roots, {time, "value"});
  if (at == nullptr || !at->is_number()) return 1;
  input::TimeTable shares;
  for (const json& row : find_list(roots, {table, "value"})) {
    shares.time.push_back(row.at(0).get<double>());
    shares.value.push_back(row.at(1).get<double>());
  }
  return shares.at(at->get<double>());
}

void read_bundle(const json& bundle, RootBlock& block) {
  const std::vector<double> diameters = get_si_vector(bundle, "diameters"),
                            ratios = get_si_vector(bundle, "area_ratios"),
                            strengths = get_si_vector(bundle, "strengths");
  std::vector<material::RootClass> classes;
  for (std::size_t i = 0; i < ratios.size() && i < strengths.size(); ++i)
    classes.push_back({i < diameters.size() ? diameters[i] : 0, ratios[i], strengths[i]});
  const double orientation = get_si(bundle, "orientation", 1.2);
  const bool breaks_one_by_one = get_word(bundle, "model") == "fibre_bundle";
  block.cohesion = breaks_one_by_one ? material::find_fibre_bundle_cohesion(classes, orientation)
                                     : material::find_wu_waldron_cohesion(classes, orientation);
  block.bundle =
      fmt::format("{} {} class{} of roots", breaks_one_by_one ? "a fibre bundle of" : "Wu and Waldron's sum over",
                  classes.size(), classes.size() == 1 ? "" : "es");
}

/// "falling with exp(−z/0.2 m) down to 0.5 m".
std::string tell_profile(const json& roots, const ShownUnit& length) {
  const std::string depth = show(get_si(roots, "depth", 0), length), profile = get_word(roots, "profile");
  const std::string along = find_list(roots, {"along", "value"}).empty() ? "" : ", not the same along the ground";
  if (profile == "exponential")
    return fmt::format("falling with exp(−z/{}) down to {}{}", show(get_si(roots, "decay_depth", 0), length), depth,
                       along);
  if (profile == "table") return fmt::format("by a table of depth down to {}{}", depth, along);
  return fmt::format("the same down to {}{}", depth, along);
}

std::string tell_worth(const RootBlock& block, const ShownUnits& units) {
  if (block.content) return fmt::format("{} % of the dry mass at the ground", show_number(100 * *block.content));
  return fmt::format("a cohesion of {} at the ground{}", show(*block.cohesion, units.stress),
                     block.bundle.empty() ? "" : " (" + block.bundle + ")");
}

bool has_breaking_roots(const json& soil) {
  const auto strain = find_si(soil, "root_breaking_strain");
  return strain && std::isfinite(*strain);
}

}  // namespace

std::vector<RootBlock> read_roots(const json& summary) {
  std::vector<RootBlock> blocks;
  for (const json& roots : find_list(summary, {"input", "roots"})) {
    RootBlock block;
    block.ground = get_word(roots, "ground");
    block.depth = get_si(roots, "depth", 0);
    block.content = find_si(roots, "content");
    block.cohesion = find_si(roots, "cohesion");
    if (const json* bundle = find(roots, {"bundle"})) read_bundle(*bundle, block);
    block.age_share = find_share(roots, "age", "growth") * find_share(roots, "felled", "decay");
    block.transpires = find(roots, {"transpiration"}) != nullptr;
    blocks.push_back(block);
  }
  return blocks;
}

std::vector<std::string> list_root_assumptions(const json& summary) {
  std::vector<std::string> sentences;
  const ShownUnits units = read_units(summary);
  const std::vector<RootBlock> blocks = read_roots(summary);
  const json& echo = find_list(summary, {"input", "roots"});
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const RootBlock& block = blocks[i];
    if (block.content || block.cohesion)
      sentences.push_back(fmt::format(
          "Roots under '{}': {}, {}.{}", block.ground, tell_worth(block, units), tell_profile(echo[i], units.length),
          block.age_share == 1 ? ""
                               : fmt::format(" {} % of that holds at their age.", show_number(100 * block.age_share))));
    if (block.transpires)
      sentences.push_back(
          fmt::format("Plants on '{}' transpire at the given rate, less by Feddes' reduction; rain that "
                      "their leaves keep and what roots do to the conductivity are not calculated.",
                      block.ground));
  }
  std::vector<std::string> clay, cohesive, breaking;
  if (const json* materials = find(summary, {"input", "materials"}))
    for (const auto& [name, soil] : materials->items()) {
      const std::string model = get_word(soil, "model");
      if (model == "rooted_cam_clay") (has_breaking_roots(soil) ? breaking : clay).push_back(name);
      if (model == "rooted_mohr_coulomb") cohesive.push_back(name);
    }
  if (!clay.empty())
    sentences.push_back(
        fmt::format("Soil and roots are one material in {}, and the roots never break: after large "
                    "movements their part of the strength is too high.",
                    join_words(clay)));
  if (!breaking.empty())
    sentences.push_back(
        fmt::format("Soil and roots are one material in {}; roots break as the activation strain grows, "
                    "in every direction alike.",
                    join_words(breaking)));
  if (!cohesive.empty())
    sentences.push_back(
        fmt::format("The roots of {} are a cohesion that is there from the first strain on and does not "
                    "fade: it raises the strength at failure, and says nothing of how the soil gets "
                    "there or of broken roots after it.",
                    join_words(cohesive)));
  return sentences;
}

}  // namespace talus::report
