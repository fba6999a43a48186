// SPDX-License-Identifier: MIT
#include "ground/root_content.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/error.hpp"
#include "ground/nearest_side.hpp"
#include "material/root_bundle.hpp"

namespace talus::ground {
namespace {

using Rows = std::vector<std::array<double, 2>>;

/// Linear between rows, constant beyond them; 1 without rows.
double interpolate(const Rows& rows, double at) {
  input::TimeTable table;
  for (const auto& [x, value] : rows) {
    table.time.push_back(x);
    table.value.push_back(value);
  }
  return table.at(at);
}

}  // namespace

template <int D>
std::vector<double> find_depths(const mesh::Mesh<D>& mesh, const std::string& ground,
                                const std::vector<Vec<D>>& places) {
  const auto named = mesh.sides.find(ground);
  if (named == mesh.sides.end() || named->second.empty())
    throw Error(ExitCode::wrong_input, fmt::format("[[roots]]: the mesh has no line '{}' for the ground", ground));
  std::vector<LabelledSide<D>> sides;
  for (const auto& side : named->second) {
    std::array<Vec<D>, D> corners;
    for (std::size_t i = 0; i < D; ++i) corners[i] = mesh.nodes[static_cast<std::size_t>(side[i])];
    sides.push_back(make_labelled_side<D>(corners, 0));
  }
  const SideSet<D> set(std::move(sides));
  std::vector<double> depths;
  depths.reserve(places.size());
  std::size_t guess = 0;
  for (const Vec<D>& x : places) depths.push_back(set.find_nearest(x, 0, guess).distance);
  return depths;
}

double find_root_share(const input::Roots& roots, double depth, double x) {
  if (depth > roots.depth) return 0;
  double share = interpolate(roots.along, x);
  if (roots.profile == input::RootProfile::exponential) share *= std::exp(-depth / roots.decay_depth);
  if (roots.profile == input::RootProfile::table) share *= interpolate(roots.depth_table, depth);
  return share;
}

double find_age_share(const input::Roots& roots) {
  double share = 1;
  if (roots.age) share *= interpolate(roots.growth, *roots.age);
  if (roots.felled) share *= interpolate(roots.decay, *roots.felled);
  return share;
}

std::optional<double> find_ground_cohesion(const input::Roots& roots) {
  if (roots.cohesion) return roots.cohesion;
  if (!roots.bundle) return std::nullopt;
  const input::RootBundle& bundle = *roots.bundle;
  const bool breaks_one_by_one = bundle.model == input::RootBundleModel::fibre_bundle;
  std::vector<material::RootClass> classes;
  for (std::size_t i = 0; i < bundle.area_ratios.size(); ++i) {
    const double diameter = i < bundle.diameters.size() ? bundle.diameters[i] : 0;  // the plain sum does not use it
    classes.push_back({diameter, bundle.area_ratios[i], bundle.strengths.at(i)});
  }
  return breaks_one_by_one ? material::find_fibre_bundle_cohesion(classes, bundle.orientation)
                           : material::find_wu_waldron_cohesion(classes, bundle.orientation);
}

template <int D>
std::vector<RootsAt> find_roots(const input::Case& data, const mesh::Mesh<D>& mesh, const std::vector<Vec<D>>& places,
                                const std::vector<const input::Material*>& soils) {
  const auto takes_content = [&](std::size_t i) { return soils[i]->traits().roots == material::RootEffect::content; };
  const auto takes_cohesion = [&](std::size_t i) { return soils[i]->traits().roots == material::RootEffect::cohesion; };
  std::vector<std::size_t> rooted;  // the places that may have roots
  for (std::size_t i = 0; i < places.size(); ++i)
    if (takes_content(i) || takes_cohesion(i)) rooted.push_back(i);
  std::vector<RootsAt> result(places.size());
  if (rooted.empty()) return result;

  std::vector<bool> reached(places.size(), false);
  std::vector<Vec<D>> asked;
  for (const std::size_t i : rooted) asked.push_back(places[i]);
  for (const input::Roots& block : data.roots) {
    const std::optional<double> cohesion = find_ground_cohesion(block);
    if (!block.content && !cohesion) continue;
    const std::vector<double> depths = find_depths<D>(mesh, block.ground, asked);
    const double age_share = find_age_share(block);
    for (std::size_t k = 0; k < rooted.size(); ++k) {
      const std::size_t i = rooted[k];
      const std::optional<double>& given = takes_content(i) ? block.content : cohesion;
      if (!given || depths[k] > block.depth) continue;
      reached[i] = true;
      (takes_content(i) ? result[i].content : result[i].cohesion) +=
          *given * age_share * find_root_share(block, depths[k], places[i][0]);
    }
  }
  for (const std::size_t i : rooted) {
    if (reached[i]) continue;
    if (takes_content(i))
      result[i].content = soils[i]->root_content;
    else
      result[i].cohesion = soils[i]->root_cohesion;
  }
  return result;
}

std::string write_root_input(const input::Case& data) {
  std::string text;
  const auto add = [&](double number) { text += fmt::format(" {}", number); };
  const auto add_rows = [&](const Rows& rows) {
    for (const auto& [x, value] : rows) {
      add(x);
      add(value);
    }
    text += ';';
  };
  for (const auto& [region, material] : data.regions) {
    const input::Material& soil = data.materials.at(material);
    text += fmt::format("{} {} {} {}\n", region, soil.traits().word, soil.root_content, soil.root_cohesion);
  }
  for (const input::Roots& block : data.roots) {
    text += fmt::format("{} {}", block.ground, static_cast<int>(block.profile));
    for (const double number : {block.depth, block.decay_depth, block.content.value_or(-1),
                                find_ground_cohesion(block).value_or(-1), find_age_share(block)})
      add(number);
    add_rows(block.depth_table);
    add_rows(block.along);
    text += '\n';
  }
  return text;
}

#define TALUS_INSTANTIATE(D)                                                                                         \
  template std::vector<double> find_depths<D>(const mesh::Mesh<D>&, const std::string&, const std::vector<Vec<D>>&); \
  template std::vector<RootsAt> find_roots<D>(const input::Case&, const mesh::Mesh<D>&, const std::vector<Vec<D>>&,  \
                                              const std::vector<const input::Material*>&);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

}  // namespace talus::ground
