// SPDX-License-Identifier: MIT
#pragma once
// [output] and [project]: results to store, and the title block of a report.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "input/language/forms.hpp"
#include "input/language/spec.hpp"

namespace talus::input {

// [project]: the title block of a report.

/// Contents of the title block beside the title.
struct Project {
  std::string name, client, author, checked_by, revision, notes;
};

void describe(Visitor& v, Project& p);

struct Monitor {
  std::string name;
  std::array<double, 3> at{};  ///< initial position; the nearest material point is followed [m]
  // Measured in the stages of construction; empty: not measured.
  TimeTable settlement{};  ///< downwards [m]
  TimeTable lateral{};     ///< along x [m]
  TimeTable pressure{};    ///< pore pressure, compression positive [Pa]
};

/// A section line along which fields of the stored frames are extracted.
struct SectionLine {
  std::string name;
  std::array<double, 3> from{}, to{};  ///< [m]
  std::optional<double> width;         ///< width of the band of contributing points [m]; not given: element size
};

struct Output {
  double frame_interval = 0;                 ///< simulated time between stored frames [s]; 0: only at the end of stages
  double history_interval = 0;               ///< simulated time between history rows [s]; 0: 200 rows per stage
  double checkpoint_interval = 60;           ///< wall time between checkpoints [s]
  bool cells = false;                        ///< store element fields as well
  bool nodes = false;                        ///< store nodal fields as well
  std::string count_from;                    ///< stage at whose start the time of onset, sections and pictures is zero
  double onset_ratio = 0.01;                 ///< displacement over the relief of the ground that defines onset [-]; or
  std::optional<double> onset_displacement;  ///< as a length [m]
  int runout_meshes = 2;                     ///< 1, or 2: also on a mesh of twice the element size
  std::vector<double> shown_times;           ///< times of sections and pictures in the report [s]; empty: evenly spaced
  std::vector<Monitor> monitors;
  std::vector<SectionLine> sections;
  std::string length_unit = "m", displacement_unit = "mm", stress_unit = "kPa";
};

void describe(Visitor& v, Monitor& m);

void describe(Visitor& v, SectionLine& s);

void describe(Visitor& v, Output& o);

}  // namespace talus::input
