#pragma once
// The clock of a case ([output] count_from) and the stored frames that are shown by it.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "output/files/frames_reader.hpp"

namespace talus::report {

struct Clock {
  std::string stage;
  double start = 0;                 ///< in the time of the run [s]
  bool resets = false;              ///< displacements are zero there
  std::vector<double> shown_times;  ///< on the clock [s]; empty: none are asked for
};

/// From summary.json; nothing when the run did not come to the stage.
std::optional<Clock> read_clock(const nlohmann::json& summary);

/// Which of the ascending `times` [s] of the run are shown: those nearest to the times that are asked for (of two at
/// one time the later one), or five evenly spread from the start of the clock on.
std::vector<std::size_t> choose_shown(const std::vector<double>& times, const Clock& clock);

}  // namespace talus::report
