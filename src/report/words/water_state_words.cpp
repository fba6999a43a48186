// SPDX-License-Identifier: MIT
#include "report/words/water_state_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"
#include "report/content/water_states.hpp"
#include "report/words/numbers.hpp"

namespace talus::report {

using results::WaterFlow;

namespace {

/// Flow below this share of all is the solver's rounding.
constexpr double no_flow = 1e-6;

/// The ground that no block names.
constexpr const char* unnamed = "other surfaces";

std::string name_side(const std::string& name) {
  return name == unnamed ? "the ground without a name" : "'" + name + "'";
}

class StateWords {
 public:
  StateWords(const ResultFolder& folder, const results::WaterState& state)
      : folder_(folder),
        state_(state),
        length_(read_units(folder.run).length),
        rate_(read_units(folder.run).flow(get_dimension(folder.run))) {}

  std::vector<std::string> collect() {
    if (state_.flow == WaterFlow::steady || state_.flow == WaterFlow::transient) {
      format_flow();
      format_closed_sides();
    }
    format_ponds();
    return std::move(sentences_);
  }

 private:
  std::string place(const std::vector<double>& x) const {
    std::vector<double> shown;
    for (const double v : x) shown.push_back(std::round(1e3 * v / length_.si) / 1e3);
    return format_point(shown) + " " + length_.name;
  }

  /// "; up to (45.1, 10.8) m" where the side is wet above the standing water.
  std::string find_exit(const std::string& name) const {
    for (const results::SeepageExit& e : state_.exits)
      if (e.name == name) return ", up to the exit point " + place(e.highest);
    return "";
  }

  std::vector<std::string> list_sides(double results::Discharge::*flow, bool with_exit) const {
    const double all = std::max(state_.inflow, state_.outflow);
    std::vector<std::string> sides;
    for (const results::Discharge& d : state_.discharges)
      if (d.*flow > no_flow * all)
        sides.push_back(fmt::format("{} through {}{}", show_per_thickness(d.*flow, rate_), name_side(d.name),
                                    with_exit ? find_exit(d.name) : ""));
    return sides;
  }

  void format_flow() {
    const auto in = list_sides(&results::Discharge::inflow, false),
               out = list_sides(&results::Discharge::outflow, true);
    const char* when =
        state_.flow == WaterFlow::steady ? "In the steady seepage" : "At the end of the transient seepage";
    sentences_.push_back(fmt::format("{} water enters with {}, and leaves with {}.", when,
                                     in.empty() ? "nothing" : join_words(in),
                                     out.empty() ? "nothing" : join_words(out)));
  }

  /// The base and the outer sides are closed unless a block opens them.
  void format_closed_sides() {
    std::vector<std::string> sides{"bottom", "left", "right"};
    if (get_dimension(folder_.run) == 3) sides.insert(sides.end(), {"front", "back"});
    std::erase_if(sides, [&](const std::string& side) {
      return std::any_of(
          folder_.data.hydraulics.begin(), folder_.data.hydraulics.end(),
          [&](const input::Hydraulic& h) { return h.on == side && h.condition != input::WaterCondition::no_flow; });
    });
    for (std::string& side : sides) side = fmt::format("'{}'", side);
    if (!sides.empty()) sentences_.push_back(fmt::format("No water passes {}.", join_words(sides)));
  }

  void format_ponds() {
    std::vector<std::string> levels;
    for (const results::StandingWater& pond : state_.ponds)
      for (const double level : {pond.level_from, pond.level_to})
        if (const std::string text = show_coordinate(level, length_);
            std::find(levels.begin(), levels.end(), text) == levels.end())
          levels.push_back(text);
    if (!levels.empty())
      sentences_.push_back(fmt::format("{} stands on the ground up to y = {}.",
                                       state_.flow == WaterFlow::lowered ? "After drawdown water" : "Water",
                                       join_words(levels)));
  }

  const ResultFolder& folder_;
  const results::WaterState& state_;
  ShownUnit length_;
  ShownUnit rate_;
  std::vector<std::string> sentences_;
};

}  // namespace

std::vector<std::string> describe_water_state(const ResultFolder& folder) {
  const std::vector<results::WaterState> states = find_water_states(folder);
  return states.empty() ? std::vector<std::string>{} : StateWords(folder, states.back()).collect();
}

}  // namespace talus::report
