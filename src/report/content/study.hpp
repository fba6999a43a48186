// SPDX-License-Identifier: MIT
#pragma once
// A study as the report shows it: its table, the curves of its variants, and how they ended.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "base/json_tree.hpp"
#include "report/pack/pack.hpp"
#include "report/report.hpp"
#include "results/sampling.hpp"

namespace talus::report {

// A study with sampled numbers in a report: distributions, probability of failure, sensitivities, runout.

/// `Sampling` of web/src/contract/.
nlohmann::json make_sampling(const results::Sampling& sampling);

/// The answer of a sampling in words, the most important sentence first.
void format_sampling(const results::Sampling& sampling, std::vector<std::string>& sentences);

// Frames of the variants of a study, packed so that they can be put side by side.

/// A variant with frames.
struct PictureSource {
  std::string title;
  ResultFolder folder;
};

/// A sequence, and what `StudyRow.frames` says of it.
struct Pictures {
  JsonTree sequence, frames;
};

/// One entry for each source, in their order; both parts empty where a source has no clock or no frames. Displacement,
/// strain, pore water and preconsolidation at the times that are shown and at some more between them; of many variants
/// only the first are shown.
std::vector<Pictures> pack_pictures(const std::vector<PictureSource>& sources, Packer& packer);

struct StudyContent {
  ResultFolder first;  ///< of the first variant that has a summary: its model and input stand for all
  std::string status;  ///< finished when all variants are
  std::vector<std::string> sentences, warnings;
  double wall = 0, cpu = 0;         ///< of all variants [s]
  JsonTree table;                   ///< `Study` of web/src/contract/
  std::vector<JsonTree> sequences;  ///< frames of the variants, for pictures side by side
};

/// Reads study.json and the summaries of the variants; those that are not there are left out.
StudyContent read_study(const ResultFolder& folder, Packer& packer);

}  // namespace talus::report
