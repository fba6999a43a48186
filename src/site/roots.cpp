// SPDX-License-Identifier: MIT
// Root content and cohesion at points, and the integration of the distribution of water uptake over the elements.
#include "site/roots.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/error.hpp"
#include "material/rooted_mohr_coulomb.hpp"
#include "site/mesh_sides.hpp"
#include "site/pore_water.hpp"

namespace talus::site {

namespace {

using Rows = std::vector<std::array<double, 2>>;

/// Interpolates linearly between the rows, constant beyond them; returns 1 without rows.
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
    const double diameter = i < bundle.diameters.size() ? bundle.diameters[i] : 0;  // unused by Wu and Waldron
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
  std::vector<std::size_t> rooted;  // indices of the places that may have roots
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

namespace {

/// Divisions per edge of the lattice of samples in an element, as root zones are thinner than many an element.
constexpr int lattice = 8;

/// Returns the barycentric coordinates of samples with equal weights: lattice (lattice+1)/2 points of a triangle, exact
/// for linear functions.
template <int D>
std::vector<std::array<double, D + 1>> list_samples() {
  std::vector<std::array<double, D + 1>> samples;
  const auto add = [&](const std::array<int, D + 1>& i) {
    std::array<double, D + 1> s;
    for (std::size_t k = 0; k <= D; ++k) s[k] = (i[k] + 1.0 / (D + 1)) / lattice;
    samples.push_back(s);
  };
  for (int i = 0; i < lattice; ++i) {
    for (int j = 0; i + j < lattice; ++j) {
      const int rest = lattice - 1 - i - j;
      if constexpr (D == 2)
        add({i, j, rest});
      else
        for (int k = 0; k <= rest; ++k) add({i, j, k, rest - k});
    }
  }
  return samples;
}

/// A named line of the ground, for the depth of a point below it and the inclination of its nearest part.
template <int D>
class Ground {
 public:
  Ground(const mesh::Mesh<D>& mesh, const input::Roots& roots) : along_(roots), set_(collect(mesh, roots.ground)) {
    along_.depth = 1;
    along_.profile = input::RootProfile::uniform;
    for (std::size_t i = 0; i < horizontal_.size(); ++i) covered_ += horizontal_[i] * share_along(centre_[i][0]);
  }
  double covered() const { return covered_; }

  /// Returns the distance [m], and the horizontal projection per unit area of the nearest ground [-].
  std::pair<double, double> find(const Vec<D>& x) {
    const NearestSides nearest = set_.find_nearest(x, 0, guess_);
    double projection = 0;
    for (const int label : nearest.labels) projection += horizontal_[label] / area_[label];
    projection /= static_cast<double>(nearest.labels.size());
    return {nearest.distance, projection};
  }

 private:
  double share_along(double x) const { return find_root_share(along_, 0, x); }
  SideSet<D> collect(const mesh::Mesh<D>& mesh, const std::string& name) {
    find_depths<D>(mesh, name, {});  // throws if there is no such line
    std::vector<LabelledSide<D>> sides;
    for (const auto& side : mesh.sides.at(name)) {
      std::array<Vec<D>, D> c;
      for (std::size_t i = 0; i < D; ++i) c[i] = mesh.nodes[side[i]];
      const auto edge = [&](std::size_t i, std::size_t d) { return c[i][d] - c[0][d]; };
      if constexpr (D == 2) {
        horizontal_.push_back(std::abs(edge(1, 0)));
        area_.push_back(std::hypot(edge(1, 0), edge(1, 1)));
      } else {
        const auto cross = [&](std::size_t a, std::size_t b) {
          return 0.5 * (edge(1, a) * edge(2, b) - edge(1, b) * edge(2, a));
        };
        horizontal_.push_back(std::abs(cross(0, 2)));
        area_.push_back(std::hypot(cross(0, 1), cross(0, 2), cross(1, 2)));
      }
      sides.push_back(make_labelled_side<D>(c, static_cast<int>(centre_.size())));
      centre_.push_back(sides.back().ball.centre);
    }
    return SideSet<D>(std::move(sides));
  }

  input::Roots along_;  ///< the block with a uniform profile over the depth
  std::vector<double> horizontal_, area_;
  std::vector<Vec<D>> centre_;
  SideSet<D> set_;
  double covered_ = 0;
  std::size_t guess_ = 0;
};

/// Adds ∫ β N dV of element `e` for the unscaled β to `weights`, and returns the sum.
template <int D>
double add_element(const mesh::Mesh<D>& mesh, int e, const input::Roots& roots, Ground<D>& ground,
                   const std::vector<std::array<double, D + 1>>& samples, std::array<double, D + 1>& weights) {
  const auto mix = [&](const std::array<double, D + 1>& shares) {
    Vec<D> x{};
    for (std::size_t k = 0; k <= D; ++k) {
      for (std::size_t d = 0; d < D; ++d) x[d] += shares[k] * mesh.nodes[mesh.elements[e][k]][d];
    }
    return x;
  };
  std::array<double, D + 1> equal;
  equal.fill(1.0 / (D + 1));
  const Vec<D> middle = mix(equal);
  double reach = 0;  // radius of the element about its middle
  for (const int node : mesh.elements[e]) {
    Vec<D> away = mesh.nodes[node];
    for (std::size_t d = 0; d < D; ++d) away[d] -= middle[d];
    reach = std::max(reach, norm(away));
  }
  if (ground.find(middle).first > roots.depth + reach) return 0;
  double sum = 0;
  const double volume = mesh.volumes[e] / static_cast<double>(samples.size());
  for (const auto& shares : samples) {
    const Vec<D> x = mix(shares);
    const auto [depth, projection] = ground.find(x);
    const double part = projection * find_root_share(roots, depth, x[0]) * volume;
    for (std::size_t k = 0; k <= D; ++k) weights[k] += part * shares[k];
    sum += part;
  }
  return sum;
}

template <int D>
void check_roots(const input::Roots& roots, const RootDistribution<D>& distribution, double sum,
                 const ShownUnit& length) {
  if (!(distribution.covered > 0))
    throw Error(ExitCode::wrong_input,
                fmt::format("[[roots]]: the ground '{}' that transpires has no horizontal extent", roots.ground));
  if (!(sum > 0))
    throw Error(ExitCode::wrong_input,
                fmt::format("[[roots]]: no soil with pore water lies within the {} of roots under '{}', so nothing "
                            "can transpire",
                            format_value(roots.depth, length), roots.ground));
}

}  // namespace

template <int D>
RootDistribution<D> find_root_distribution(const input::Case& data, const input::Roots& roots,
                                           const mesh::Mesh<D>& mesh) {
  check_upright(data, "transpiration counts ground on the horizontal and a height");
  Ground<D> ground(mesh, roots);
  RootDistribution<D> r{ground.covered(), {}};
  r.weights.assign(mesh.elements.size(), {});
  const auto samples = list_samples<D>();
  double sum = 0;
  for (int e = 0; e < mesh.element_count(); ++e) {
    const input::Material* soil = find_soil(data, mesh, e);
    if (soil == nullptr || !soil->water.is_wet()) continue;
    sum += add_element<D>(mesh, e, roots, ground, samples, r.weights[e]);
  }
  check_roots<D>(roots, r, sum, data.units().length);
  for (auto& weights : r.weights) {
    for (double& w : weights) w *= r.covered / sum;
  }
  return r;
}

material::Feddes make_uptake_reduction(const input::Roots& roots, const ShownUnit& stress) {
  const auto& s = roots.transpiration->suctions;
  if (!(s[0] <= s[1] && s[1] <= s[2] && s[2] < s[3]))
    throw Error(
        ExitCode::wrong_input,
        fmt::format("[roots.transpiration] under '{}': the four suctions are {:g}, {:g}, {:g} and {}; they "
                    "must increase, only the first two may be equal",
                    roots.ground, s[0] / stress.si, s[1] / stress.si, s[2] / stress.si, format_value(s[3], stress)));
  return {s};
}

input::TimeTable make_transpiration_rate(const input::Transpiration& transpiration) {
  input::Hydraulic rows;  // a container with the same two forms of a series
  rows.condition = input::WaterCondition::rain;
  rows.rate = transpiration.rate;
  rows.series = transpiration.series;
  return rows.values();
}

template <int D>
std::vector<fem::RootSink> make_root_sinks(const input::Case& data, const mesh::Mesh<D>& mesh) {
  std::vector<fem::RootSink> sinks;
  for (const input::Roots& roots : data.roots) {
    if (!roots.transpiration) continue;
    const RootDistribution<D> distribution = find_root_distribution<D>(data, roots, mesh);
    fem::RootSink sink{roots.ground, make_uptake_reduction(roots, data.units().stress),
                       make_transpiration_rate(*roots.transpiration), std::vector<double>(mesh.nodes.size(), 0.0)};
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
      for (std::size_t k = 0; k <= D; ++k) sink.weights[mesh.elements[e][k]] += distribution.weights[e][k];
    }
    sinks.push_back(std::move(sink));
  }
  return sinks;
}

#define TALUS_INSTANTIATE(D)                                                                      \
  template RootDistribution<D> find_root_distribution<D>(const input::Case&, const input::Roots&, \
                                                         const mesh::Mesh<D>&);                   \
  template std::vector<fem::RootSink> make_root_sinks<D>(const input::Case&, const mesh::Mesh<D>&);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

}  // namespace talus::site
