// SPDX-License-Identifier: MIT
#include "run/releases.hpp"

#include <fmt/format.h>

#include "base/hash.hpp"
#include "base/user_file.hpp"
#include "results/governing.hpp"
#include "run/common/method_run.hpp"
#include "run/mpm/coarser_mesh.hpp"

namespace talus::run {

template <int D>
void Releases<D>::prepare(results::RunResult& run) {
  beside_ = methods_.timeline->list_releases();
  if (beside_.empty()) return;
  released_ = std::make_unique<const ReleaseCase>(std::move(beside_.front()));
  beside_.erase(beside_.begin());
  prepare_mpm(context_, released_->data, methods_, run);
  methods_.points->open();
}

template <int D>
void Releases<D>::run_beside() {
  for (ReleaseCase& other : beside_) run_one(other);
}

template <int D>
void Releases<D>::run_one(ReleaseCase& other) {
  const RunOptions options = context_.options.make_nested(join_name(context_.options.folder, other.summary.folder));
  const std::string hash = hash_text(fmt::format("{}{:a}", context_.hash, other.summary.time));
  std::vector<std::string> notes;
  std::unique_ptr<const input::Case> data;
  const auto make_case = [&](results::RunResult& run) -> const input::Case& {
    data = make_point_case<D>(other.data, options, run, notes);
    return *data;
  };
  const auto complete = [&](results::RunResult& run) {
    if (auto coarser = compare_with_coarser_mesh<D>(context_.loaded, *data, options, hash, run))
      notes.push_back(std::move(*coarser));
    run.warnings.insert(run.warnings.end(), notes.begin(), notes.end());
  };
  other.summary.error = attempt(options, false, [&] {
    results::take_motion(run_points_beside<D>(context_.loaded, options, hash, make_case, complete), other.summary);
  });
  results_beside_.push_back(other.summary);
}

template <int D>
void Releases<D>::add_results(const results::RunResult& run, bool is_complete) {
  if (released_) {
    results::Release out = released_->summary;
    results::take_motion(run, out);
    if (!is_complete) out.error = run.error;
    methods_.timeline->add_release(std::move(out));
  }
  for (const results::Release& other : results_beside_) methods_.timeline->add_release(other);
}

template class Releases<2>;
template class Releases<3>;

}  // namespace talus::run
