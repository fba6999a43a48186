// SPDX-License-Identifier: MIT
#pragma once
// The picture of a case before its calculation, also of a case with faults.

#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "input/sketch.hpp"
#include "output/plots/case_picture.hpp"

namespace talus::run {

/// A message of `talus check`. `diagnostic` may have no place in the file.
struct CaseMessage {
  bool is_error = false;
  Diagnostic diagnostic;
};

/// Collects what is known of the section and of its loads, conditions and searches before the calculation. Elements are
/// counted on a mesh if that takes a moment and there are no errors, and estimated otherwise. Parts that could not be
/// read are left out. Throws Error (wrong_input) for a case without a plane section.
output::CasePicture make_case_picture(const input::Sketch& sketch, const std::vector<CaseMessage>& messages);

/// The same without messages and mesh; std::nullopt for a case without a plane section. Needs no mesh generator.
std::optional<output::CasePicture> make_section_picture(const input::Sketch& sketch, bool is_faulty);

/// Returns the picture of a plane case without faults, without messages and mesh; std::nullopt for other cases.
std::optional<output::CasePicture> make_input_picture(const input::Case& data);

/// Returns the ground of a section from left to right; empty if it is not unique, as with gaps and overhangs.
std::vector<results::Point> find_sketched_ground(const input::Sketch& sketch);

/// Returns the side of the box or the named line on which conditions act [m]; empty if there is none of that name.
std::vector<results::Point> find_side_line(const input::Case& data, const std::string& name);

/// Returns the place in the section of a message [m]: that of the key where it is reported (a corner, a polygon, a
/// boundary, a load), or the point that its sentence names; std::nullopt if it has none.
std::optional<results::Point> find_message_place(const input::Sketch& sketch, const std::vector<results::Point>& ground,
                                                 const Diagnostic& message);

}  // namespace talus::run
