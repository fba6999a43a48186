// SPDX-License-Identifier: MIT
#pragma once
// Measures of a flow of water: discharges through lines, exit gradients, and the safety against uplift and heave
// (docs/theory/13-seepage.md, T13.6).

#include <string>
#include <vector>

#include "fem/seepage/seepage.hpp"
#include "mesh/mesh.hpp"
#include "results/flow.hpp"
#include "site/flow_section.hpp"
#include "site/site.hpp"

namespace talus::site {

/// Computes the measures of one case, on one mesh, for many states.
template <int D>
class FlowMeasures {
 public:
  /// `mesh`: of all soils; `model`: of the seepage on the same mesh, with dry soils empty. All must outlive this
  /// object. Throws Error (wrong_input) with one sentence for each section and block that does not lie in the soil.
  FlowMeasures(const Site& site, const mesh::Mesh<D>& mesh, const fem::SeepageModel<D>& model);

  /// `time`: of the state, for the ponds [s].
  results::FlowState measure(const fem::SeepageResult<D>& state, double time) const;

  /// Returns sentences on factors that cannot be computed.
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  /// A side at the base of a less permeable layer.
  struct LayerBase {
    int above = 0;  ///< element
    std::array<int, D> nodes{};
    Vec<D> middle{};
  };
  /// A place on the base of a block, with its part of the width [m].
  struct BasePoint {
    int element = 0;
    std::array<double, D> xi{};
    double width = 0;
  };

  void find_sections();
  void find_layer_bases();
  void find_blocks();
  bool has_weight(int element) const;

  void add_sections(const fem::SeepageResult<D>& state, results::FlowState& result) const;
  void add_exits(const fem::SeepageResult<D>& state, results::FlowState& result) const;
  void add_uplift(const fem::SeepageResult<D>& state, double time, results::FlowState& result) const;
  void add_heaves(const fem::SeepageResult<D>& state, double time, results::FlowState& result) const;
  /// Returns the unit weights of the elements [N/m³].
  std::vector<double> find_weights(const fem::SeepageResult<D>& state) const;
  double find_standing_pressure(const std::vector<Pond>& ponds, double x) const;

  const Site& site_;
  const mesh::Mesh<D>& mesh_;
  const fem::SeepageModel<D>& model_;
  std::vector<std::vector<FlowPart>> sections_;
  std::vector<LayerBase> bases_;
  std::vector<std::vector<BasePoint>> blocks_;
  bool is_weighed_ = true;  ///< every soil has a weight
  std::vector<std::string> notes_;
};

}  // namespace talus::site
