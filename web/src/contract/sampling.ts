// SPDX-License-Identifier: MIT
/** The part of the data contract that a study with sampled numbers has. */

export interface Sampling {
  samples: number;
  seed: number;
  /** "latin_hypercube", "random". */
  plan: string;
  /** Hypercubes that were drawn for themselves. */
  replicates: number;
  /** "lem", "fem", "mpm". */
  method: string;
  /** "Spencer on 214 surfaces". */
  method_title: string;
  seconds: number;
  numbers: SampledNumber[];
  correlations: { keys: string[]; asked: number; sampled: number | null }[];
  factor: SampledValues | null;
  failure: FailureProbability | null;
  /** From the slopes of the factor at the means. */
  first_order: {
    mean_factor: number | null;
    deviation: number | null;
    index_normal: number | null;
    index_lognormal: number | null;
  } | null;
  /** The most probable values at failure, after Hasofer and Lind. */
  design_point: {
    index: number | null;
    probability: number | null;
    converged: boolean;
    iterations: number;
    /** The factor there. */
    factor: number | null;
    values: { key: string; name: string; unit: string; value: number | null; importance: number | null }[];
  } | null;
  /** From mean and deviation of the sampled factors. */
  fits: { normal: FittedLaw; lognormal: FittedLaw } | null;
  /** Longest first; one number one deviation below and above its mean, the others at theirs. */
  tornado: {
    key: string;
    name: string;
    unit: string;
    low_value: number | null;
    high_value: number | null;
    low_factor: number | null;
    high_factor: number | null;
  }[] | null;
  /** Spearman's coefficients with the factor. */
  ranks: RankCorrelation[] | null;
  /** 0: every sample was searched for itself. */
  surfaces: number;
  /** Quick factors against searches: by how much they lie above, relative. */
  check: { samples: number; largest: number | null; mean: number | null } | null;
  runout: Runout | null;
  /** Of the samples that fail within a timeline [days]. */
  failure_time: SampledValues | null;
  notes: string[];
  samples_file: string;
}

export interface FittedLaw {
  index: number | null;
  probability: number | null;
}

export interface SampledNumber {
  key: string;
  name: string;
  unit: string;
  distribution: string;
  /** "lognormal, mean 18 kPa, deviation 3.6 kPa". */
  text: string;
  /** In `unit`; null where it is not known. */
  mean: number | null;
  deviation: number | null;
  /** Null: no limit. */
  lowest: number | null;
  highest: number | null;
  sampled: { mean: number | null; deviation: number | null; smallest: number | null; largest: number | null };
}

export interface RankCorrelation {
  key: string;
  name: string;
  coefficient: number | null;
}

export interface SampledValues {
  count: number;
  /** Samples without a value. */
  none: number;
  mean: number | null;
  deviation: number | null;
  /** Coefficient of variation. */
  variation: number | null;
  skewness: number | null;
  smallest: number | null;
  largest: number | null;
  quantiles: { share: number; value: number | null }[];
  histogram: { edges: number[]; counts: number[] };
}

export interface FailureProbability {
  limit: number;
  count: number;
  samples: number;
  probability: number;
  lower: number;
  upper: number;
  /** Of the interval. */
  confidence: number;
  /** β; null where it is infinite. */
  index: number | null;
  index_lower: number | null;
  index_upper: number | null;
  standard_error: number | null;
  /** What the interval is. */
  interval: string;
  /** [samples, probability, lower, upper]. */
  growth: number[][];
  /** If every factor were off by the largest difference of the check. */
  with_largest_difference?: number | null;
}

/** How probable it is that the soil comes farther than a distance. */
export interface Runout extends SampledValues {
  name: string;
  unit: string;
  /** [distance, probability, lower, upper]. */
  curve: number[][];
  exceedance: { distance: number; count: number; samples: number; probability: number; lower: number; upper: number }[];
  ranks: RankCorrelation[];
}
