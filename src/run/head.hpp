// SPDX-License-Identifier: MIT
#pragma once
// The head of the results of every run: title block, program, machine, units, input.

#include "input/read.hpp"
#include "results/run.hpp"

namespace talus::run {

/// The title block of the report.
results::Project make_project(const input::Case& data);

/// Program, build, machine and input: where a number comes from.
results::Provenance make_provenance(const input::LoadedCase& loaded, const std::string& input_hash, int threads);

/// The units of display.
results::DisplayUnits make_display_units(const input::Output& output);

/// Title, project, provenance, units, outlines and input.
results::RunResult begin_result(const input::LoadedCase& loaded, const std::string& input_hash, int threads);

/// A length in sentences, in the unit of the case: "1.22 m", "4 ft".
std::string format_length(const results::RunResult& run, double metres, int digits = 3);

}  // namespace talus::run
