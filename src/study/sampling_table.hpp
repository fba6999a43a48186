#pragma once
// What sampling says: for the report, as text for the terminal, and every sample as CSV.

#include <string>

#include "study/sampling.hpp"

namespace talus::study {

/// The block "sampling" of study.json.
results::Sampling describe_sampling(const input::Sampling& asked, const SampleSet& set);

/// study.md of it.
std::string write_sampling_markdown(const std::string& title, const results::Sampling& sampling);

/// One row per sample: its number, the values in the units of their keys, and what came of it.
std::string write_samples(const SampleSet& set);

}  // namespace talus::study
