// SPDX-License-Identifier: MIT
#pragma once
// Statistics of a sample.

#include <vector>

#include "results/sampling.hpp"

namespace talus::study {

/// Count, mean, extremes, and deviation and skewness corrected for the size of the sample.
results::SampledValues find_moments(const std::vector<double>& values);

/// The value below which a share `p` of the sample lies, linear between neighbours.
double find_quantile(std::vector<double> values, double p);

/// The correlation of two columns (Pearson); 0 where one of them does not vary.
double correlate(const std::vector<double>& a, const std::vector<double>& b);
/// Of their ranks (Spearman); equal values share the mean of their ranks.
double correlate_ranks(const std::vector<double>& a, const std::vector<double>& b);

/// Counts in classes of equal, round width: class i lies from edges[i] to edges[i+1]. About as many classes as Freedman
/// and Diaconis (1981) advise, 60 at most. Empty for an empty sample.
results::HistogramCounts count_classes(const std::vector<double>& values);

/// A count of an event, and the interval of its probability.
results::SampleShare estimate_share(long count, long samples, double confidence);

/// Standard error of the mean of `values` where they come in replicates of equal standing, each drawn for itself:
/// replicate r holds the samples from first[r] to first[r+1]. Nothing is said (NaN) with fewer than two.
double estimate_error(const std::vector<double>& values, const std::vector<int>& first);

}  // namespace talus::study
