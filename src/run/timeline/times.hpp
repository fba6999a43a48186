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
///
/// Between two tried times the curve is taken as the straight line between their factors, bent as the guide is: the
/// least factor of the surfaces that are known already, at every time.
class TimeChoice {
 public:
  /// `times` include 0 and increase.
  TimeChoice(std::vector<double> times, double target, double tolerance, int most);

  /// The next numbers of times to be tried, some at a time; empty: the curve is known well enough, or most are tried.
  std::vector<std::size_t> next() const;
  void set(std::size_t number, std::optional<double> factor);
  /// What the known surfaces give at each of the times; nothing where all are refused.
  void set_guide(std::vector<std::optional<double>> factors);

  /// Numbers of the times that were tried, in time.
  std::vector<std::size_t> list_tried() const;
  /// The largest estimate of what a straight line between two tried times is off at a time, over the factor [-].
  double find_distance() const;

 private:
  struct Known {
    bool tried = false;
    std::optional<double> factor;
  };
  /// Between two neighbours that were tried: where the guide is furthest from a straight line, and how far.
  struct Bend {
    double distance = 0;  ///< over the factor; below zero: under the line
    std::size_t at = 0;
  };
  std::optional<double> line_at(std::size_t from, std::size_t to, std::size_t i) const;
  std::optional<double> estimate(std::size_t from, std::size_t to, std::size_t i) const;
  Bend find_bend(std::size_t from, std::size_t to) const;
  std::size_t find_passage(std::size_t from, std::size_t to) const;
  std::optional<std::size_t> find_least_estimate(const std::vector<std::size_t>& tried) const;

  std::vector<double> times_;
  std::vector<Known> known_;
  std::vector<std::optional<double>> guide_;
  double target_, tolerance_;
  std::size_t most_;
};

}  // namespace talus::run
