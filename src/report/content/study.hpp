// SPDX-License-Identifier: MIT
#pragma once
// A study as the report shows it: its table, the curves of its variants, and how they ended.

#include <string>
#include <vector>

#include "base/json_tree.hpp"
#include "report/folder.hpp"
#include "report/pack/pack.hpp"

namespace talus::report {

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
