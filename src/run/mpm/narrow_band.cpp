// SPDX-License-Identifier: MIT
#include "run/mpm/narrow_band.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "mpm/body/observe.hpp"

namespace talus::run {
namespace {

/// Plastic strain from which on a band counts.
constexpr double sheared = 0.05;
/// Elements up to which it is the mesh that makes it so thin.
constexpr double thin = 1.75;
/// Elements over the softening length up to which a band does not depend on them: half, and a tenth for their scatter.
constexpr double coarse = 0.55;

/// Means over the points of soil that softens.
struct SoftElements {
  std::vector<double> volume, strain, void_ratio;
};

/// 0 of laws that have none.
double find_void_ratio(const material::Law& law, const double* state) {
  return std::visit(
      [&](const auto& l) -> double {
        if constexpr (requires { l.find_void_ratio(state); })
          return l.find_void_ratio(state);
        else
          return 0;
      },
      law);
}

template <int D>
SoftElements gather(const mpm::Body<D>& body) {
  SoftElements e;
  const std::size_t count = body.mesh().elements.size();
  e.volume.assign(count, 0), e.strain.assign(count, 0), e.void_ratio.assign(count, 0);
  for (int id = 0; id < body.points.size(); ++id) {
    if (!mpm::is_present(body, id)) continue;
    const auto p = mpm::view_point(body, id);
    const auto& law = body.laws[static_cast<std::size_t>(p.material)];
    if (!material::get_traits(law).softens) continue;
    const auto element = static_cast<std::size_t>(body.points.element[static_cast<std::size_t>(id)]);
    e.volume[element] += p.volume;
    e.strain[element] += p.volume * p.plastic_strain;
    e.void_ratio[element] += p.volume * find_void_ratio(law, p.state.data());
  }
  for (std::size_t i = 0; i < count; ++i)
    if (e.volume[i] > 0) e.strain[i] /= e.volume[i], e.void_ratio[i] /= e.volume[i];
  return e;
}

template <int D>
std::vector<std::vector<int>> list_elements_at_nodes(const mesh::Mesh<D>& mesh) {
  std::vector<std::vector<int>> at(mesh.nodes.size());
  for (int e = 0; e < mesh.element_count(); ++e)
    for (const int node : mesh.elements[static_cast<std::size_t>(e)]) at[static_cast<std::size_t>(node)].push_back(e);
  return at;
}

/// The elements that share a node with element `e`, itself too.
template <int D>
void list_around(const mesh::Mesh<D>& mesh, const std::vector<std::vector<int>>& at_nodes, std::size_t e,
                 std::vector<int>& around) {
  around.clear();
  for (const int node : mesh.elements[e])
    around.insert(around.end(), at_nodes[static_cast<std::size_t>(node)].begin(),
                  at_nodes[static_cast<std::size_t>(node)].end());
  std::sort(around.begin(), around.end());
  around.erase(std::unique(around.begin(), around.end()), around.end());
}

}  // namespace

// In a straight band of n > 1 rows of elements the share of the band in the soil that shares a node with an element of
// it is 1 - 2/(3n) in the mean, and 1/3 in one row.
template <int D>
std::optional<SoftBand> find_soft_band(const mpm::Body<D>& body) {
  const SoftElements e = gather(body);
  const auto peak = std::max_element(e.strain.begin(), e.strain.end());
  if (peak == e.strain.end() || !(*peak > sheared)) return std::nullopt;
  const auto at_nodes = list_elements_at_nodes(body.mesh());
  double band = 0, part = 0, size = 0, inside = 0, beside = 0, outside = 0;
  std::vector<int> around;
  for (std::size_t i = 0; i < e.volume.size(); ++i) {
    if (!(e.strain[i] > 0.5 * *peak)) continue;
    list_around(body.mesh(), at_nodes, i, around);
    double all = 0, like = 0;
    for (const int number : around) {
      const auto other = static_cast<std::size_t>(number);
      all += e.volume[other];
      const bool belongs = e.strain[other] > 0.5 * e.strain[i];
      like += belongs ? e.volume[other] : 0;
      beside += belongs ? 0 : e.volume[other];
      outside += belongs ? 0 : e.volume[other] * e.void_ratio[other];
    }
    band += e.volume[i];
    part += e.volume[i] * like / all;
    size += e.volume[i] * std::pow((D == 2 ? 2 : 6) * body.mesh().volumes[i], 1.0 / D);
    inside += e.volume[i] * e.void_ratio[i];
  }
  if (!(beside > 0) || inside / band <= outside / beside) return std::nullopt;  // as a whole, or compacted
  return SoftBand{2 / (3 * (1 - part / band)), size / band};
}

template <int D>
StageHooks<D> watch_bands(const mpm::Body<D>& body, StageHooks<D> hooks) {
  if (std::none_of(body.laws.begin(), body.laws.end(),
                   [](const material::Law& law) { return material::get_traits(law).softens; }))
    return hooks;
  hooks.output = [record = std::move(hooks.output)](Pause<D>& now, StageState& state) {
    record(now, state);
    const auto band = find_soft_band(now.whole());
    if (!band) return;
    state.soft_band = state.soft_band > 0 ? std::min(state.soft_band, band->thickness) : band->thickness;
    state.soft_size = std::max(state.soft_size, band->size);
  };
  return hooks;
}

template <int D>
std::optional<std::string> describe_narrow_band(const mpm::Body<D>& body, const StageState& state,
                                                std::optional<double> length) {
  const bool depends = length ? state.soft_size > coarse * *length : state.soft_band <= thin;
  if (state.soft_band == 0 || !depends) return std::nullopt;
  std::vector<std::string> soils;
  for (std::size_t m = 0; m < body.laws.size(); ++m)
    if (material::get_traits(body.laws[m]).softens) soils.push_back("'" + body.material_names[m] + "'");
  return fmt::format(
      "soil that softens ({}) sheared in a band of {:.2g} elements of {:.2g} m: when it moves, and how deep, depend on "
      "their size. {}",
      fmt::join(soils, ", "), std::max(1.0, state.soft_band), state.soft_size,
      length ? fmt::format("mesh.softening_length = {:g} m must be at least twice that", *length)
             : "Give mesh.softening_length, at least twice that");
}

#define TALUS_INSTANTIATE(D)                                                                          \
  template std::optional<SoftBand> find_soft_band<D>(const mpm::Body<D>&);                            \
  template StageHooks<D> watch_bands<D>(const mpm::Body<D>&, StageHooks<D>);                          \
  template std::optional<std::string> describe_narrow_band<D>(const mpm::Body<D>&, const StageState&, \
                                                              std::optional<double>);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

}  // namespace talus::run
