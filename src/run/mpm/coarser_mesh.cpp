// SPDX-License-Identifier: MIT
#include "run/mpm/coarser_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/hash.hpp"
#include "base/ranks.hpp"
#include "run/common/head.hpp"
#include "run/common/method_run.hpp"
#include "run/mpm/point_run.hpp"

namespace talus::run {
namespace {

bool has_moved(const results::RunResult& run) {
  if (run.runout && run.runout->moved_volume > 0) return true;
  return run.runouts && std::any_of(run.runouts->begin(), run.runouts->end(),
                                    [](const results::RunoutTrial& r) { return r.runout.moved_volume > 0; });
}

/// Returns the case on elements twice as large, with an analysis reduced to its runouts.
input::Case coarsen(input::Case data) {
  data.mesh = mesh::resize(std::move(data.mesh), 2 * data.mesh.size);
  input::StrengthReduction& reduction = data.strength_reduction;
  reduction.frozen.enabled = false;
  reduction.curve.to =
      reduction.curve.from - reduction.curve.step;  // an empty curve: only the trials of the runouts are left
  reduction.curve.refine = false;
  data.output.frame_interval = 0;
  data.output.cells = data.output.nodes = false;
  data.output.sections.clear();
  return data;
}

/// Adds the runout `there`, on elements of `size`, to `here`. Returns false if the soil moves in the opposite
/// direction on that mesh, which is another slide. A slope that is stable there is a valid result.
bool add(const results::Runout& there, double size, results::Runout& here) {
  if (here.moved_volume <= 0) return true;
  const results::RunoutSide* same = &there;  // of a section that moves to both sides, the side of `here`
  if (there.sides)
    for (const results::RunoutSide& side : *there.sides)
      if (side.direction == here.direction) same = &side;
  if (there.moved_volume > 0 && same->direction != here.direction) return false;
  here.coarser_mesh = {size,
                       same->front_advance,
                       same->toe_distance,
                       same->crest_retreat,
                       there.moved_volume,
                       there.highest_ground,
                       there.deposit_volume};
  if (auto keys = results::RunoutEstimates(here).list_undetermined(); !keys.empty())
    here.undetermined = std::move(keys);
  return true;
}

}  // namespace

template <int D>
std::optional<std::string> compare_with_coarser_mesh(const input::LoadedCase& loaded, const input::Case& data,
                                                     const RunOptions& options, const std::string& input_hash,
                                                     results::RunResult& run) {
  bool is_due =
      data.output.runout_meshes >= 2 && has_moved(run) && data.mesh.file.empty() && data.initial.result.empty();
  broadcast(is_due);  // rank 0 alone may have the runout
  if (!is_due) return std::nullopt;
  RunOptions beside = options.make_nested(options.folder / "coarser_mesh");
  beside.label = "coarser mesh: ";
  const std::string hash = hash_text(input_hash + "coarser mesh");
  const input::Case coarser = coarsen(data);
  if (options.progress)
    options.progress->show(fmt::format("the runout on elements of {}", format_length(run, coarser.mesh.size)));
  results::RunResult found;
  const auto why = attempt(options, false, [&] {
    found = run_points_beside<D>(
        loaded, beside, hash, [&](results::RunResult&) -> const input::Case& { return coarser; },
        [](results::RunResult&) {});
  });
  if (why)
    return fmt::format("front, runout and height have no interval, because the mesh with elements of {} failed: {}",
                       format_length(run, coarser.mesh.size), *why);
  bool agrees = true;
  if (run.runout && found.runout) agrees = add(*found.runout, coarser.mesh.size, *run.runout);
  if (run.runouts && found.runouts)
    for (results::RunoutTrial& here : *run.runouts)
      for (const results::RunoutTrial& there : *found.runouts)
        if (std::abs(there.trial.factor - here.trial.factor) < 1e-9)
          agrees = add(there.runout, coarser.mesh.size, here.runout) && agrees;
  if (agrees) return std::nullopt;
  return fmt::format(
      "on elements of {} the soil runs the other way, so that front, runout and height have no interval: refine "
      "mesh.size",
      format_length(run, coarser.mesh.size));
}

template std::optional<std::string> compare_with_coarser_mesh<2>(const input::LoadedCase&, const input::Case&,
                                                                 const RunOptions&, const std::string&,
                                                                 results::RunResult&);
template std::optional<std::string> compare_with_coarser_mesh<3>(const input::LoadedCase&, const input::Case&,
                                                                 const RunOptions&, const std::string&,
                                                                 results::RunResult&);

}  // namespace talus::run
