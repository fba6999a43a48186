#pragma once
// What sampling says: as JSON for the report, as text for the terminal, and every sample as CSV.

#include <nlohmann/json.hpp>
#include <string>

#include "study/sampling.hpp"

namespace talus::study {

/// The block "sampling" of study.json.
nlohmann::json describe_sampling(const input::Sampling& asked, const SampleSet& set);

/// study.md of such a block.
std::string write_sampling_markdown(const std::string& title, const nlohmann::json& block);

/// One row per sample: its number, the values in the units of their keys, and what came of it.
std::string write_samples(const SampleSet& set);

}  // namespace talus::study
