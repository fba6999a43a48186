#pragma once
// A whole case by all the methods that [analysis] names: the one entry behind `talus run` and `talus study`.

#include "run/mpm/run_points.hpp"

namespace talus::run {

/// Slices and finite elements first, then material points, then what they have in common. Writes summary.json,
/// lem.json, fem.json and all that run_points() writes; returns the summary. With options.resume parts that are
/// done are kept. Throws what make_section(), lem::search(), run_fem() and run_points() throw; where slices or
/// finite elements find no answer beside another method, the reason stands in the summary and the run goes on.
nlohmann::json run_case(const input::LoadedCase& loaded, const RunOptions& options);

/// Throws Error (wrong_input) when the case cannot be taken by the methods that it names, without calculating: what
/// `talus check` says beside the faults of the file.
void check_methods(const input::Case& data);

}  // namespace talus::run
