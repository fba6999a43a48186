// SPDX-License-Identifier: MIT
#pragma once
// Statistics of a sample.

#include <vector>

#include "results/sampling.hpp"

namespace talus::study {

/// Count, mean, extremes, and deviation and skewness corrected for the size of the sample.
results::SampledValues find_moments(const std::vector<double>& values);

/// Quantile at the probability `p`, linear between neighbours.
double find_quantile(std::vector<double> values, double p);

/// Correlation of two columns (Pearson); 0 if one of them does not vary.
double correlate(const std::vector<double>& a, const std::vector<double>& b);
/// Rank correlation (Spearman); equal values have the mean of their ranks.
double correlate_ranks(const std::vector<double>& a, const std::vector<double>& b);

/// Counts values in classes of equal, round width: class i lies from edges[i] to edges[i+1]. The number of classes is
/// about that of Freedman and Diaconis (1981), at most 60. Empty for an empty sample.
results::HistogramCounts count_classes(const std::vector<double>& values);

/// Count of an event, and the interval of its probability.
results::SampleShare estimate_share(long count, long samples, double confidence);

/// Standard error of the mean of `values` from independent replicates of equal weight: replicate r holds the samples
/// from first[r] to first[r+1]. NaN with fewer than two replicates.
double estimate_error(const std::vector<double>& values, const std::vector<int>& first);

}  // namespace talus::study
