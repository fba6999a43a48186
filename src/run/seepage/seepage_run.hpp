// SPDX-License-Identifier: MIT
#pragma once
// The flow of water alone in a run: computed or read from an interrupted run, and stored in the folder.

#include <memory>
#include <optional>
#include <string>

#include "fem/seepage/seepage.hpp"
#include "mesh/mesh.hpp"
#include "results/flow.hpp"
#include "results/run.hpp"
#include "run/common/method_run.hpp"
#include "site/flow_measures.hpp"
#include "site/site.hpp"

namespace talus::run {

template <int D>
class SeepageRun : public MethodRun<results::FlowFile> {
 public:
  /// `site`: of the case or its design values. `alone`: the case has no other method.
  SeepageRun(const site::Site& site, bool alone, const RunOptions& options, std::string input_hash);

  /// Prepares the mesh and the model; writes nothing. Throws Error (wrong_input) if seepage is the only method,
  /// otherwise the reason is part of the result.
  void prepare();
  /// Solves the flow and stores its measures. Throws as prepare(), and Error (unstable) without a solution.
  void calculate();
  void write_result(results::RunResult& run) const;
  /// Removes the file that only a resumed run needs.
  void forget() const;
  bool has_states() const { return !file_.summary.states.empty(); }

 private:
  void add_state(const fem::SeepageResult<D>& state, results::WaterFlow flow, double time);
  void follow();
  void restore();
  void keep() const;
  void add_warnings_of_state();

  const site::Site site_;  ///< with closed sides
  mesh::Mesh<D> mesh_, wet_mesh_;
  fem::SeepageModel<D> model_;
  std::optional<site::FlowMeasures<D>> measures_;
  bool is_known_ = false;  ///< of an interrupted run
};

}  // namespace talus::run
