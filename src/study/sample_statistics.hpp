#pragma once
// What a sample says about the distribution that it was drawn from.

#include <array>
#include <vector>

namespace talus::study {

struct Moments {
  long count = 0;
  double mean = 0, deviation = 0, skewness = 0;  ///< the last two corrected for the size of the sample
  double smallest = 0, largest = 0;
};
Moments find_moments(const std::vector<double>& values);

/// The value below which a share `p` of the sample lies, linear between neighbours.
double find_quantile(std::vector<double> values, double p);

/// The correlation of two columns (Pearson); 0 where one of them does not vary.
double correlate(const std::vector<double>& a, const std::vector<double>& b);
/// Of their ranks (Spearman); equal values share the mean of their ranks.
double correlate_ranks(const std::vector<double>& a, const std::vector<double>& b);

/// Counts in classes of equal, round width: class i lies from edges[i] to edges[i+1].
struct Histogram {
  std::vector<double> edges;
  std::vector<long> counts;
};
/// About as many classes as Freedman and Diaconis (1981) advise, 60 at most. Empty for an empty sample.
Histogram count_classes(const std::vector<double>& values);

/// How often something was seen, and between which limits its probability lies.
struct Share {
  long count = 0, samples = 0;
  double probability = 0;
  std::array<double, 2> interval{0, 1};
};
Share estimate_share(long count, long samples, double confidence);

/// Standard error of the mean of `values` where they come in replicates of equal standing, each drawn for itself:
/// replicate r holds the samples from first[r] to first[r+1]. Nothing is said (NaN) with fewer than two.
double estimate_error(const std::vector<double>& values, const std::vector<int>& first);

}  // namespace talus::study
