// SPDX-License-Identifier: MIT
#pragma once
// Frames that belong together, thinned and packed (`Sequence` in web/src/contract/).

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "output/files/frames_reader.hpp"
#include "report/content/thinning.hpp"
#include "report/pack/pack.hpp"
#include "report/words/numbers.hpp"

namespace talus::report {

/// A frame of the results and what is written under it.
struct SequenceFrame {
  std::shared_ptr<const output::ResultsReader> reader;
  int index = 0;
  std::optional<double> factor;  ///< strength reduction factor
  std::string label;
  bool starts_count = false;  ///< displacements are zero here, whatever the frame, written before that, says
};

/// What frames belong together for. Along the trials of the curve runs the factor, elsewhere time.
enum class SequenceKind { stages, curve, runout, variant };

struct SequencePlan {
  SequenceKind kind = SequenceKind::stages;
  std::string id;  ///< letters, digits, '_' and '.'
  std::string title;
  std::vector<SequenceFrame> frames;
  std::vector<std::string> fields{};  ///< names of the stored fields that are packed; empty: all
};

/// Reads the frames that `budget` allows and packs them. A point that a frame lacks (it left the grid) has no value
/// there. `plan` has at least one frame.
nlohmann::json pack_sequence(const SequencePlan& plan, std::size_t dimension, const ShownUnits& units,
                             const Budget& budget, Packer& packer);

}  // namespace talus::report
