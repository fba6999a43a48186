// SPDX-License-Identifier: MIT
#pragma once
// When and in which order monitored places began to move, and the lines along which fields were taken.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "results/about.hpp"

namespace talus::results {

/// The clock of onset, sections and pictures.
struct Clock {
  std::string stage;                ///< at whose start it is zero
  double start = 0;                 ///< then [s]
  bool resets = false;              ///< displacements are counted from there
  std::vector<double> shown_times;  ///< of sections and pictures [s]; empty: evenly spread
};
template <class V, As<Clock> R>
void describe(V& v, R& r) {
  v.key("stage", r.stage, {"", "stage at whose start the clock is zero"});
  v.key("start", r.start, {"s", "start of that stage"});
  v.key("resets", r.resets, {"", "whether displacements are counted from there"});
  v.key("shown_times", r.shown_times, {"s", "times of sections and pictures"});
}

/// In which order places began to move.
enum class MotionPattern { none, single, together, upwards, downwards, mixed };
template <>
inline constexpr auto words<MotionPattern> =
    std::array{Word{MotionPattern::none, "none"},           Word{MotionPattern::single, "single"},
               Word{MotionPattern::together, "together"},   Word{MotionPattern::upwards, "upwards"},
               Word{MotionPattern::downwards, "downwards"}, Word{MotionPattern::mixed, "mixed"}};

struct MonitorMotion {
  std::string name;
  std::optional<double> onset;         ///< on the clock [s]; nothing: it did not move
  std::optional<double> displacement;  ///< at the end [m]; nothing: it left the grid
};
template <class V, As<MonitorMotion> R>
void describe(V& v, R& r) {
  v.key("name", r.name, {"", "monitored place"});
  v.key("onset", r.onset, {"s", "onset of movement"});
  v.key("displacement", r.displacement, {"m", "displacement at the end"});
}

struct Motion {
  std::string stage;     ///< that the clock starts with
  double start = 0;      ///< [s]
  double threshold = 0;  ///< displacement that counts as movement [m]
  std::vector<MonitorMotion> monitors;
  std::vector<std::string> order;  ///< names of those that moved, first to last
  MotionPattern pattern = MotionPattern::none;
  std::string sentence;
};
template <class V, As<Motion> R>
void describe(V& v, R& r) {
  v.key("stage", r.stage, {"", "stage at whose start the clock is zero"});
  v.key("start", r.start, {"s", "start of that stage"});
  v.key("threshold", r.threshold, {"m", "displacement that counts as movement"});
  v.key("monitors", r.monitors, {"", "monitored places"});
  v.key("order", r.order, {"", "places in the order of their onset"});
  v.key("pattern", r.pattern, {"", "order of movement"});
  v.key("sentence", r.sentence, {"", "the same in words"});
}

/// A line through the soil along which the fields of the frames were taken; its table is sections/NAME.csv.
struct SectionLine {
  std::string name;
  std::array<double, 3> from{}, to{};  ///< [m]
  double width = 0;                    ///< of the band whose points count [m]
};
template <class V, As<SectionLine> R>
void describe(V& v, R& r) {
  v.key("name", r.name, {"", "section"});
  v.key("from", r.from, {"m", "one end"});
  v.key("to", r.to, {"m", "other end"});
  v.key("width", r.width, {"m", "width of the band"});
}

}  // namespace talus::results
