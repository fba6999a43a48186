#pragma once
// A whole case by all the methods that [analysis] names: the one entry behind `talus run` and `talus study`.

#include "analysis/run_case.hpp"

namespace talus::methods {

/// Slices and finite elements first, then material points, then what they have in common. Writes summary.json,
/// lem.json, fem.json and all that analysis::run_case() writes; returns the summary. With options.resume parts that are
/// done are kept. Throws what make_section(), lem::search(), run_fem() and analysis::run_case() throw; where slices or
/// finite elements find no answer beside another method, the reason stands in the summary and the run goes on.
nlohmann::json run_case(const input::LoadedCase& loaded, const analysis::RunOptions& options);

/// Throws Error (wrong_input) when the case cannot be taken by the methods that it names, without calculating: what
/// `talus check` says beside the faults of the file.
void check_methods(const input::Case& data);

}  // namespace talus::methods
