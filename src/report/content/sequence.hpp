// SPDX-License-Identifier: MIT
#pragma once
// Frames that belong together, thinned and packed (`Sequence` in web/src/contract/).

#include <cstddef>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "output/files/frames_reader.hpp"
#include "report/pack/pack.hpp"
#include "report/report.hpp"
#include "report/words/numbers.hpp"

namespace talus::report {

// Which frames and points of the results a report shows: a rule that needs no choice and can be said in one sentence.

/// How much one sequence may show.
struct Budget {
  std::size_t frames = 48;
  std::size_t points = 20000;
  std::size_t point_frames = 0;  ///< points times frames
};

/// Points times frames in the whole report, by dimension: each takes about 17 bytes in a plane and 34 in space.
constexpr std::size_t find_most_point_frames(std::size_t dimension) {
  return dimension == 2 ? 450000 : 250000;
}

/// Shares of `total` among sequences that need so much: none gets more than it needs, and what one leaves is shared by
/// the others.
std::vector<std::size_t> share_out(const std::vector<std::size_t>& needs, std::size_t total);

/// Indices of at most `most` of `count` frames, evenly spread, the first and the last always among them (most >= 2).
std::vector<std::size_t> choose_frames(std::size_t count, std::size_t most);

/// Every how many-th point is shown: the smallest stride that keeps both limits.
std::size_t choose_stride(std::size_t points, std::size_t frames, const Budget& budget);

/// The rule as it was applied, for the reader.
std::string describe_thinning(std::size_t frames, std::size_t shown_frames, std::size_t points,
                              std::size_t shown_points, std::size_t stride);

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

// The displacement curve of a run (`Curve` in web/src/contract/).

/// The curve of a finished run, else from what finished trials left in the folder; null when there is none.
nlohmann::json make_curve(const ResultFolder& folder);

// The frames of a run as sequences: its stages, the trials of the curve, each runout.

nlohmann::json pack_sequences(const ResultFolder& folder, Packer& packer);

}  // namespace talus::report
