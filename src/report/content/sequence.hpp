// SPDX-License-Identifier: MIT
#pragma once
// Frames of a run as sequences (`Sequence` in web/src/contract/), thinned and packed; and the displacement curve.
// Frames and points are selected by a fixed rule, which the report states.

#include <cstddef>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "output/files/frames_reader.hpp"
#include "report/folder/numbers.hpp"
#include "report/folder/result_folder.hpp"
#include "report/pack/pack.hpp"

namespace talus::report {

/// Limits on the size of one sequence.
struct Budget {
  std::size_t frames = 48;
  std::size_t points = 20000;
  std::size_t point_frames = 0;  ///< limit on points × frames
};

/// Returns the limit on points × frames of the whole report: one takes about 17 bytes in 2D and 34 bytes in 3D.
constexpr std::size_t find_most_point_frames(std::size_t dimension) {
  return dimension == 2 ? 450000 : 250000;
}

/// Divides `total` among sequences with the given needs: none receives more than it needs, and the remainder is divided
/// among the others.
std::vector<std::size_t> share_out(const std::vector<std::size_t>& needs, std::size_t total);

/// Returns the indices of at most `most` of `count` frames, equally spaced, with the first and the last (most >= 2).
std::vector<std::size_t> choose_frames(std::size_t count, std::size_t most);

/// Returns the smallest stride of point numbers that satisfies the limits on points and on points × frames.
std::size_t choose_stride(std::size_t points, std::size_t frames, const Budget& budget);

/// Returns the sentence of the report on the selection that was applied.
std::string describe_thinning(std::size_t frames, std::size_t shown_frames, std::size_t points,
                              std::size_t shown_points, std::size_t stride);

/// A stored frame and its caption.
struct SequenceFrame {
  std::shared_ptr<const output::ResultsReader> reader;
  int index = 0;
  std::optional<double> factor;  ///< strength reduction factor
  std::string label;
  bool starts_count = false;  ///< displacements are reset here, after the frame was written
};

/// Kind of a sequence. Its axis is the strength reduction factor for the curve, otherwise time.
enum class SequenceKind { stages, curve, runout, variant };

struct SequencePlan {
  SequenceKind kind = SequenceKind::stages;
  std::string id;  ///< letters, digits, '_' and '.'
  std::string title;
  std::vector<SequenceFrame> frames;
  std::vector<std::string> fields{};  ///< names of the stored fields to pack; empty: all
};

/// Reads and packs the frames within `budget`. A point that left the grid has no values in later frames. `plan` must
/// have at least one frame.
nlohmann::json pack_sequence(const SequencePlan& plan, std::size_t dimension, const ShownUnits& units,
                             const Budget& budget, Packer& packer);

/// Packs the sequences of a run: its stages, the trials of the curve, and each runout.
nlohmann::json pack_sequences(const ResultFolder& folder, Packer& packer);

}  // namespace talus::report
