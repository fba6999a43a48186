// SPDX-License-Identifier: MIT
#pragma once
// At which times of a timeline the factor is found.

#include <optional>
#include <vector>

#include "input/case/case.hpp"

namespace talus::run {

/// Times at which the state of the water is kept [s], without 0: `given` ones, or many: near and between the corners of
/// the [[hydraulic]] series, where most happens.
std::vector<double> list_times(const input::Case& data);

/// Chooses among times by the factors that are known. A factor may be missing: nothing was found there.
class TimeChoice {
 public:
  /// `times` include 0 and increase.
  TimeChoice(std::vector<double> times, double target, double tolerance, int most);

  /// The next numbers of times to be tried, some at a time; empty: the curve is known well enough, or most are tried.
  std::vector<std::size_t> next() const;
  void set(std::size_t number, std::optional<double> factor);

  /// Numbers of the times that were tried, in time.
  std::vector<std::size_t> list_tried() const;
  /// The largest estimate of what a straight line between two tried times is off, over the factor [-].
  double find_distance() const;

 private:
  struct Known {
    bool tried = false;
    std::optional<double> factor;
  };
  /// What straight lines on both sides of a tried time may be off: its distance from the line between its neighbours.
  double find_bend(const std::vector<std::size_t>& tried, std::size_t k) const;

  std::vector<double> times_;
  std::vector<Known> known_;
  double target_, tolerance_;
  std::size_t most_;
};

}  // namespace talus::run
