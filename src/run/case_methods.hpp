// SPDX-License-Identifier: MIT
#pragma once
// The methods of a case, prepared for their run.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "input/read.hpp"
#include "results/run.hpp"
#include "run/bounds/bounds_run.hpp"
#include "run/common/run_folder.hpp"
#include "run/construction/construction_run.hpp"
#include "run/fem/element_run.hpp"
#include "run/lem/slice_run.hpp"
#include "run/mpm/point_run.hpp"
#include "run/seepage/seepage_run.hpp"
#include "run/timeline/timeline_run.hpp"
#include "site/design_values.hpp"

namespace talus::run {

struct CaseContext {
  const input::LoadedCase& loaded;
  const site::DesignValues design;
  const RunOptions& options;
  const std::string hash;  ///< of the input
};

/// The methods that the case names.
template <int D>
struct CaseMethods {
  std::optional<SliceRun> slices;
  std::optional<ElementRun<D>> elements;
  std::optional<BoundsRun> bounds;
  std::optional<SeepageRun<D>> seepage;
  std::optional<TimelineRun> timeline;
  std::optional<ConstructionRun> construction;  ///< runs the other methods itself
  std::unique_ptr<const input::Case> point_case;
  std::vector<std::string> point_notes;  ///< on the earthquake direction of MPM, and on its coarser mesh
  std::optional<PointRun<D>> points;     ///< nullopt before the time of its release is known
};

/// Returns true if MPM starts from a time of the timeline.
bool is_released(const input::Case& data);

/// Returns the case of MPM: with one direction of an earthquake, and with the initial stress of FEM if required.
template <int D>
std::unique_ptr<const input::Case> make_point_case(const input::Case& data, const RunOptions& options,
                                                   results::RunResult& run, std::vector<std::string>& notes);

/// Prepares MPM on `data`, the design values of the case or those at another time.
template <int D>
void prepare_mpm(const CaseContext& context, const input::Case& data, CaseMethods<D>& methods, results::RunResult& run);

/// Finds all faults of the case before anything is written, and begins its result. MPM that is released later is
/// checked at time 0.
template <int D>
void prepare_methods(const CaseContext& context, CaseMethods<D>& methods, results::RunResult& run);

}  // namespace talus::run
