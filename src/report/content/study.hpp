// SPDX-License-Identifier: MIT
#pragma once
// A study in a report: table, curves and status of its variants, frames of the variants for comparison, and the
// statistics of samples.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "base/json_tree.hpp"
#include "report/folder/result_folder.hpp"
#include "report/pack/pack.hpp"
#include "results/sampling.hpp"

namespace talus::report {

/// Adds the sentences of the answer on the samples, the most important first.
void format_sampling(const results::Sampling& sampling, const ShownUnit& length, std::vector<std::string>& sentences);

/// A variant with stored frames.
struct PictureSource {
  std::string title;
  ResultFolder folder;
};

/// The packed frames of a variant, and its `StudyRow.frames`.
struct Pictures {
  JsonTree sequence, frames;
};

/// Packs the frames of the variants for pictures side by side: displacement, strain, pore water and preconsolidation at
/// the shown times and at some times between them. The list has one entry per source in their order; both members are
/// empty if the source has no clock or no frames. Only the first variants of a large study are included.
std::vector<Pictures> pack_pictures(const std::vector<PictureSource>& sources, Packer& packer);

struct StudyContent {
  ResultFolder first;  ///< first variant with a summary; its model and input represent all variants
  results::Status status = results::Status::unfinished;  ///< finished if all variants are
  std::vector<std::string> sentences, warnings;
  double wall = 0, cpu = 0;         ///< sum over all variants [s]
  JsonTree table;                   ///< `Study` of web/src/contract/
  std::vector<JsonTree> sequences;  ///< frames of the variants
};

/// Reads study.json and the summaries of the variants; missing summaries are skipped.
StudyContent read_study(const ResultFolder& folder, Packer& packer);

}  // namespace talus::report
