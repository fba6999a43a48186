#pragma once
// Names of what limit equilibrium, finite elements and partial factors yield: lem.spencer, fem.factor.

#include <string>
#include <vector>

#include "input/case/result_names.hpp"

namespace talus::input {

/// Word of a method of slices, as the case file has it: "spencer"; and its name for people: "Spencer".
std::string get_word(SliceMethod method);
const char* get_title(SliceMethod method);
/// Whether it takes polylines; the others take moments about the centre of a circle.
bool suits_polylines(SliceMethod method);

/// Adds lem.METHOD, lem.noncircular.METHOD, lem.surface[NAME].METHOD, lem.yield_acceleration.METHOD,
/// lem.handed[fem.band].METHOD and lem.handed[mpm.slip_line].METHOD, as far as the case yields them.
void add_slice_results(std::vector<ResultName>& names, const Case& data);
/// Adds fem.factor and fem.by_displacement, and the same under fem.associated where ψ = φ.
void add_element_results(std::vector<ResultName>& names, const Case& data);

}  // namespace talus::input
