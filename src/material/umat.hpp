// SPDX-License-Identifier: MIT
#pragma once
// The calls of a compiled UMAT: its arguments, between pages of memory that it cannot touch, and what it answers.

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace talus::material {

/// What a UMAT is asked. Components are xx yy zz xy (yz zx), four or six; stresses [Pa].
struct UmatQuestion {
  std::span<const double> stress, strain, increment;
  std::span<const double> states;
  double saturation = 1, time = 0, dt = 0;
  int point = -1;
};

/// What it answers, as asked.
struct UmatAnswer {
  std::string trouble;  ///< why the rest holds nothing: "it crashed (Segmentation fault) …"; empty when it returned
  std::array<double, 6> stress{};
  std::span<const double> states;  ///< valid until the next question
  double step_ratio = 1;           ///< PNEWDT
  double dissipation = 0;          ///< what it added to SPD
};

class Umat {
 public:
  /// `function` is the subroutine; `name` is what messages call it, `material` its CMNAME.
  Umat(void* function, std::string name, const std::string& material, const std::vector<double>& constants,
       std::size_t states);
  ~Umat();
  Umat(const Umat&) = delete;
  Umat& operator=(const Umat&) = delete;

  /// One call at a time in the process: a UMAT may keep data between calls and share it, also between libraries. After
  /// a call that never returned all answers are that.
  UmatAnswer ask(const UmatQuestion& question);

 private:
  struct Arguments;
  std::unique_ptr<Arguments> arguments_;
  std::string name_;
  bool is_lost_ = false;
};

}  // namespace talus::material
