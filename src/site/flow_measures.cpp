// SPDX-License-Identifier: MIT
#include "site/flow_measures.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "base/error.hpp"
#include "base/shown_units.hpp"
#include "mesh/locate.hpp"
#include "site/mesh_sides.hpp"
#include "site/weights.hpp"

namespace talus::site {

namespace {

/// Places on the base of a block.
constexpr int block_points = 400;
/// A layer is less permeable than that below it if its vertical conductivity is lower by this factor.
constexpr double tighter = 10;
/// Ground with an upward normal steeper than this is nearly level (20°): the critical gradient γ'/γ_w applies.
constexpr double nearly_level = 0.94;
/// An exit gradient that exceeds that of all neighbouring nodes by this factor depends on the mesh.
constexpr double steep_growth = 1.3;
/// Gradients below this are rounding.
constexpr double least_gradient = 1e-6;
/// Suctions below this, as a fraction of the height of an element of water, are rounding.
constexpr double dry_suction = 1e-6;

template <int D>
std::vector<double> to_list(const Vec<D>& x) {
  return {x.begin(), x.end()};
}

/// Returns the outflow of each node through the boundary of the soil [m³/s]: Σ V v·∇N over its elements. In steady flow
/// it is zero inside the soil, and conserves mass at the boundary.
template <int D>
std::vector<double> sum_outflow(const mesh::Mesh<D>& mesh, const fem::SeepageResult<D>& state) {
  std::vector<double> outflow(mesh.nodes.size(), 0.0);
  for (int e = 0; e < mesh.element_count(); ++e) {
    if (mesh.element_region[e] == mesh::empty_region) continue;
    for (int k = 0; k <= D; ++k) {
      const std::array<double, D> gradient = mesh::find_shape_gradient(mesh, e, k);
      double sum = 0;
      for (std::size_t d = 0; d < D; ++d) sum += gradient[d] * state.velocity[e][d];
      outflow[mesh.elements[e][k]] += mesh.volumes[e] * sum;
    }
  }
  return outflow;
}

}  // namespace

template <int D>
FlowMeasures<D>::FlowMeasures(const Site& site, const mesh::Mesh<D>& mesh, const fem::SeepageModel<D>& model)
    : site_(site), mesh_(mesh), model_(model) {
  std::set<std::string> weightless;
  for (int e = 0; e < mesh.element_count(); ++e)
    if (mesh.element_region[e] != mesh::empty_region && !has_weight(e))
      weightless.insert(mesh.region_names[static_cast<std::size_t>(mesh.element_region[e])]);
  is_weighed_ = weightless.empty();
  if (!is_weighed_)
    notes_.push_back(
        fmt::format("no factor against boiling, uplift and heave: give a unit weight to the material of {}",
                    fmt::join(weightless, ", ")));
  if constexpr (D == 2) {
    find_sections();
    find_layer_bases();
    find_blocks();
  }
}

template <int D>
bool FlowMeasures<D>::has_weight(int element) const {
  const input::Material* soil = find_soil(site_.data(), mesh_, element);
  return soil != nullptr && (soil->slices.unit_weight || soil->grain_density > 0);
}

template <int D>
void FlowMeasures<D>::find_sections() {
  if constexpr (D == 2) {
    if (site_.data().seepage.sections.empty()) return;
    const FlowSections sections(model_);
    for (const input::FlowSection& section : site_.data().seepage.sections) {
      sections_.push_back(sections.find_parts(section.points));
      if (sections_.back().empty())
        fail_input("[[seepage.section]] '{}' crosses no soil with pore water", section.name);
    }
  }
}

template <int D>
void FlowMeasures<D>::find_layer_bases() {
  const auto find_conductivity = [&](int e) {  // vertical; 0: no pore water
    const int region = model_.mesh->element_region[e];
    return region == mesh::empty_region ? 0.0 : model_.soils[static_cast<std::size_t>(region)].conductivity[1];
  };
  for (int e = 0; e < mesh_.element_count(); ++e) {
    if (find_conductivity(e) == 0) continue;
    for (int k = 0; k <= D; ++k) {
      const int above = mesh_.neighbours[e][k];
      if (above < 0 || mesh_.element_region[above] == mesh::empty_region) continue;
      if (find_conductivity(above) * tighter > find_conductivity(e)) continue;
      if (find_outward_normal(mesh_, e, k).first[1] < 0.1) continue;
      LayerBase base{above, {}, {}};
      std::size_t n = 0;
      for (int j = 0; j <= D; ++j)
        if (j != k) base.nodes[n++] = mesh_.elements[e][j];
      for (const int node : base.nodes)
        for (std::size_t d = 0; d < D; ++d) base.middle[d] += mesh_.nodes[node][d] / D;
      bases_.push_back(base);
    }
  }
}

template <int D>
void FlowMeasures<D>::find_blocks() {
  const ShownUnit& length = site_.data().units().length;
  for (const input::HeaveBlock& block : site_.data().seepage.blocks) {
    std::vector<BasePoint>& points = blocks_.emplace_back();
    int guess = 0;
    const double width = (block.x[1] - block.x[0]) / block_points;
    for (int i = 0; i < block_points; ++i) {
      Vec<D> x{};
      x[0] = block.x[0] + (i + 0.5) * width, x[1] = block.level;
      const int element = mesh::find_element<D>(*model_.mesh, x, guess);
      if (element < 0 || model_.mesh->element_region[element] == mesh::empty_region)
        fail_input("[[seepage.heave]] '{}': its base is not in soil with pore water at x = {}, y = {}", block.name,
                   format_coordinate(x[0], length), format_coordinate(x[1], length));
      guess = element;
      points.push_back({element, mesh::to_local(mesh_, element, x), width});
    }
  }
}

template <int D>
std::vector<double> FlowMeasures<D>::find_weights(const fem::SeepageResult<D>& state) const {
  std::vector<double> weights(mesh_.elements.size(), 0.0);
  for (int e = 0; e < mesh_.element_count(); ++e) {
    const input::Material* soil = find_soil(site_.data(), mesh_, e);
    if (soil == nullptr) continue;
    double pressure = 0;
    for (const int node : mesh_.elements[e]) pressure += state.pressure[node] / (D + 1);
    weights[e] = soil->water.is_wet() ? find_unit_weight(site_.data(), *soil, pressure)
                                      : find_unit_weight(site_.data(), *soil, std::numeric_limits<double>::max());
  }
  return weights;
}

template <int D>
double FlowMeasures<D>::find_standing_pressure(const std::vector<Pond>& ponds, double x) const {
  const auto level = site::find_standing_level(ponds, {}, site_.ground(), x);
  return level ? std::max(0.0, site_.water_weight() * (*level - find_level(site_.ground(), x))) : 0.0;
}

template <int D>
void FlowMeasures<D>::add_sections(const fem::SeepageResult<D>& state, results::FlowState& result) const {
  for (std::size_t s = 0; s < sections_.size(); ++s) {
    double sum = 0;
    for (const FlowPart& p : sections_[s])
      for (std::size_t d = 0; d < 2; ++d) sum += state.velocity[p.element][d] * p.normal[d];
    result.sections.push_back({site_.data().seepage.sections[s].name, sum});
  }
}

namespace {

/// A side at which water may leave the soil.
template <int D>
struct OpenSide {
  std::array<int, D> nodes{};
  int element = 0;    ///< with soil, behind the side
  Vec<D> normal{};    ///< out of the soil
  double passes = 0;  ///< A k_n, the flow at a gradient of 1 [m³/s]
};

/// Returns the sides with the element of soil behind each: a line may have an empty element on its other side, whose
/// normal points into the soil.
template <int D>
std::vector<OpenSide<D>> list_open_sides(const fem::SeepageModel<D>& model,
                                         const std::vector<typename mesh::Mesh<D>::Side>& wanted) {
  std::vector<OpenSide<D>> open;
  const mesh::Mesh<D>& mesh = *model.mesh;
  for (const auto& [nodes, elements] : map_sides<D>(mesh, wanted))
    for (const SideElement& s : elements) {
      const int region = mesh.element_region[s.element];
      if (region == mesh::empty_region) continue;
      const auto [normal, area] = find_outward_normal(mesh, s.element, s.opposite);
      const fem::HydraulicSoil<D>& soil = model.soils[static_cast<std::size_t>(region)];
      double across = 2 * soil.cross_conductivity * normal[0] * normal[1];
      for (std::size_t d = 0; d < D; ++d) across += soil.conductivity[d] * normal[d] * normal[d];
      open.push_back({nodes, s.element, normal, area * across});
    }
  return open;
}

/// The gradients at the nodes of one boundary at which water leaves (T13.6).
template <int D>
class ExitFlow {
 public:
  /// `outflow`: of each node [m³/s]; `passes`: that at a gradient of 1, of all boundaries.
  ExitFlow(const std::vector<OpenSide<D>>& sides, const std::vector<double>& outflow,
           const std::map<int, double>& passes)
      : outflow_(outflow), passes_(passes) {
    for (const OpenSide<D>& side : sides)
      for (const int node : side.nodes) around_[node].insert(side.nodes.begin(), side.nodes.end());
  }

  /// Returns the mean over the node and those beside it: the flux of single nodes scatters on irregular meshes. Zero
  /// where water enters.
  double compute_gradient(int node) const {
    if (!(outflow_[node] > 0)) return 0;
    double flow = 0, passes = 0;
    for (const int other : around_.at(node)) flow += outflow_[other], passes += passes_.at(other);
    return flow / passes;
  }
  /// Returns true if the flux of the node exceeds that of all beside it by far.
  bool is_peak(int node) const {
    double beside = 0;
    for (const int other : around_.at(node))
      if (other != node) beside = std::max(beside, outflow_[other] / passes_.at(other));
    return outflow_[node] / passes_.at(node) > steep_growth * beside;
  }

 private:
  const std::vector<double>& outflow_;
  const std::map<int, double>& passes_;
  std::map<int, std::set<int>> around_;
};

/// Selects the exit to report: the largest gradient, or, if that is on nearly level ground, the least factor there.
class WorstExit {
 public:
  void add(const results::ExitGradient& exit) {
    if (!largest_ || exit.gradient > largest_->gradient) largest_ = exit;
    if (exit.factor && (!least_ || *exit.factor < *least_->factor)) least_ = exit;
  }
  std::optional<results::ExitGradient> select() const {
    if (!least_ || (!largest_->factor && least_->gradient < (1 - rounding) * largest_->gradient)) return largest_;
    return least_;
  }

 private:
  static constexpr double rounding = 1e-9;
  std::optional<results::ExitGradient> largest_, least_;
};

}  // namespace

template <int D>
void FlowMeasures<D>::add_exits(const fem::SeepageResult<D>& state, results::FlowState& result) const {
  const std::vector<double> outflow = sum_outflow(*model_.mesh, state);
  std::map<int, double> passes;
  std::vector<std::pair<std::string, std::vector<OpenSide<D>>>> open;
  for (const fem::HydraulicBoundary<D>& boundary : model_.boundaries) {
    // Free drainage has a gradient of 1 by definition.
    if (boundary.kind == fem::HydraulicKind::no_flow || boundary.kind == fem::HydraulicKind::free_drainage) continue;
    open.emplace_back(boundary.name, list_open_sides<D>(model_, boundary.sides));
    for (const OpenSide<D>& side : open.back().second)
      for (const int node : side.nodes) passes[node] += side.passes / D;
  }
  for (const auto& [name, sides] : open) {
    const ExitFlow<D> flow(sides, outflow, passes);
    WorstExit worst;
    for (const OpenSide<D>& side : sides)
      for (const int node : side.nodes) {
        // Water leaves saturated soil only: none above the exit point of a seepage face.
        if (state.pressure[node] > dry_suction * model_.unit_weight * mesh_.altitudes[side.element]) continue;
        const double gradient = flow.compute_gradient(node);
        if (!(gradient > least_gradient)) continue;
        results::ExitGradient exit{name, gradient, to_list<D>(mesh_.nodes[node]), {}, {}, flow.is_peak(node)};
        if (side.normal[1] >= nearly_level && is_weighed_) {
          const input::Material& soil = *find_soil(site_.data(), mesh_, side.element);
          exit.critical = find_saturated_weight(site_.data(), soil) / site_.water_weight() - 1;
          exit.factor = *exit.critical / gradient;
        }
        worst.add(exit);
      }
    if (auto found = worst.select()) result.exits.push_back(std::move(*found));
  }
}

template <int D>
void FlowMeasures<D>::add_uplift(const fem::SeepageResult<D>& state, double time, results::FlowState& result) const {
  if (bases_.empty() || !is_weighed_ || !site_.has_ground()) return;
  const std::vector<Pond> ponds = site_.find_ponds(time);
  std::vector<mesh::LocalPoint<D>> places;
  for (const LayerBase& base : bases_) places.push_back({base.above, mesh::to_local(mesh_, base.above, base.middle)});
  Vec<D> up{};
  up[1] = 1;
  const std::vector<double> weights = mesh::overburden_integral<D>(mesh_, find_weights(state), places, up);
  for (std::size_t i = 0; i < bases_.size(); ++i) {
    const LayerBase& base = bases_[i];
    double pressure = -find_standing_pressure(ponds, base.middle[0]);
    for (const int node : base.nodes) pressure -= state.pressure[node] / D;
    if (!(pressure > 0)) continue;
    const double factor = weights[i] / pressure;
    if (result.uplift && result.uplift->factor <= factor) continue;
    const int region = mesh_.element_region[base.above];
    result.uplift = results::UpliftPlace{mesh_.region_names[static_cast<std::size_t>(region)], to_list<D>(base.middle),
                                         weights[i], pressure, factor};
  }
}

template <int D>
void FlowMeasures<D>::add_heaves(const fem::SeepageResult<D>& state, double time, results::FlowState& result) const {
  if (blocks_.empty() || !is_weighed_ || !site_.has_ground()) return;
  const std::vector<Pond> ponds = site_.find_ponds(time);
  const std::vector<double> unit_weights = find_weights(state);
  const double water = site_.water_weight();
  Vec<D> up{};
  up[1] = 1;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    std::vector<mesh::LocalPoint<D>> places;
    for (const BasePoint& p : blocks_[b]) places.push_back({p.element, p.xi});
    const std::vector<double> weights = mesh::overburden_integral<D>(mesh_, unit_weights, places, up);
    results::Heave heave{site_.data().seepage.blocks[b].name, 0, 0, {}};
    for (std::size_t i = 0; i < places.size(); ++i) {
      const BasePoint& p = blocks_[b][i];
      const Vec<D> x = mesh::to_global(mesh_, p.element, p.xi);
      // Hydrostatic pressure of water that stands at the ground, or on it.
      const double hydrostatic = water * (find_level(site_.ground(), x[0]) - x[1]);
      double pressure = -find_standing_pressure(ponds, x[0]), first = 1;
      for (std::size_t k = 0; k < D; ++k) {
        pressure -= p.xi[k] * state.pressure[mesh_.elements[p.element][k + 1]];
        first -= p.xi[k];
      }
      pressure -= first * state.pressure[mesh_.elements[p.element][0]];
      heave.weight += p.width * (weights[i] - hydrostatic);
      heave.force += p.width * (pressure - hydrostatic);
    }
    if (heave.force > 0) heave.factor = heave.weight / heave.force;
    result.heaves.push_back(std::move(heave));
  }
}

template <int D>
results::FlowState FlowMeasures<D>::measure(const fem::SeepageResult<D>& state, double time) const {
  results::FlowState result;
  result.time = time;
  result.inflow = state.inflow;
  result.outflow = state.outflow;
  add_exits(state, result);
  if constexpr (D == 2) {
    add_sections(state, result);
    add_uplift(state, time, result);
    add_heaves(state, time, result);
  }
  return result;
}

template class FlowMeasures<2>;
template class FlowMeasures<3>;

}  // namespace talus::site
