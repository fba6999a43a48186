// SPDX-License-Identifier: MIT
#pragma once
// Selection of the times of a timeline at which the factor is searched.

#include <optional>
#include <vector>

#include "input/case/case.hpp"

namespace talus::run {

/// Times at which the state of the water is stored [s], without 0: the given ones, or many near and between the
/// corners of the [[hydraulic]] series, where most changes occur.
std::vector<double> list_times(const input::Case& data);

/// Selects times from the known factors. A factor may be missing if no surface was found.
///
/// Between two tried times the curve is estimated by a straight line between their factors, plus the curvature of the
/// guide: the least factor of the known surfaces at every time.
class TimeChoice {
 public:
  /// `times` include 0 and increase.
  TimeChoice(std::vector<double> times, double target, double tolerance, int most);

  /// Returns the indices of the next times to try, several at once; empty if the curve is known well enough, or the
  /// largest number of times was tried.
  std::vector<std::size_t> next() const;
  void set(std::size_t number, std::optional<double> factor);
  /// Sets the guide: the factor of the known surfaces at each time; nullopt where all are rejected.
  void set_guide(std::vector<std::optional<double>> factors);

  /// Indices of the tried times, in order of time.
  std::vector<std::size_t> list_tried() const;
  /// Largest estimated deviation from the straight line between two tried times, over the factor [-].
  double find_distance() const;

 private:
  struct Known {
    bool tried = false;
    std::optional<double> factor;
  };
  /// Largest deviation of the guide from the straight line between two adjacent tried times, and its time.
  struct Bend {
    double distance = 0;  ///< over the factor; negative: below the line
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
