// SPDX-License-Identifier: MIT
#include "study/whole_study.hpp"

#include "study/sampling.hpp"
#include "study/study_table.hpp"

namespace talus::study {

StudyOutcome calculate_study(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
                             const StudyOptions& options) {
  if (base.data.study.mode == input::StudyMode::sample) {
    SamplingResult result = run_sampling(base, overrides, options);
    return {std::move(result.markdown), std::move(result.failure)};
  }
  const StudyPlan plan = plan_study(base, overrides);
  const std::vector<StudyRow> rows = run_study(plan, options);
  return {write_study_markdown(plan, rows, describe_study(plan, rows)), find_failure(rows)};
}

}  // namespace talus::study
