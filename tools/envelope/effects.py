# SPDX-License-Identifier: MIT
"""What a designed set of runs says: intervals of a fraction, main effects of the choices, and statements that exclude each other."""
import collections
import dataclasses
import math

import numpy as np

LEVEL = 0.9  # of all intervals
BINS = 3  # of equal frequency, for numbers
RESAMPLES = 400
SMALLEST = 12  # samples below which no effect is computed


def sum_binomial(k, n, p):
    """P(X <= k) of the binomial distribution."""
    if p <= 0 or k >= n:
        return 1.0
    if p >= 1:
        return 0.0
    logs = [math.lgamma(n + 1) - math.lgamma(i + 1) - math.lgamma(n - i + 1) + i * math.log(p) + (n - i) * math.log1p(-p) for i in range(k + 1)]
    return min(1.0, math.fsum(map(math.exp, logs)))


def bisect(is_below, low=0.0, high=1.0):
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if is_below(middle) else (low, middle)
    return 0.5 * (low + high)


def compute_clopper_pearson(k, n, level=LEVEL):
    """Exact central interval of the probability of an event that came k times in n independent trials."""
    tail = 0.5 * (1 - level)
    low = 0.0 if k == 0 else bisect(lambda p: 1 - sum_binomial(k - 1, n, p) < tail)
    high = 1.0 if k == n else bisect(lambda p: sum_binomial(k, n, p) > tail)
    return low, high


def compute_omega_squared(values, groups, count):
    """Fraction of the variance that the groups 0 … count - 1 explain in the population, ω² = (SS_b - (a - 1) MS_w)/(SS_t + MS_w); 0 where negative.
    `values` and `groups` may have leading axes: a row for each resample."""
    values, groups = np.atleast_2d(values), np.atleast_2d(groups)
    rows, n = values.shape
    keys = (groups + count * np.arange(rows)[:, None]).ravel()
    sizes = np.bincount(keys, minlength=rows * count).reshape(rows, count)
    sums = np.bincount(keys, weights=values.ravel(), minlength=rows * count).reshape(rows, count)
    mean = values.mean(axis=1, keepdims=True)
    total = ((values - mean) ** 2).sum(axis=1)
    between = (sizes * (sums / np.maximum(sizes, 1) - mean) ** 2).sum(axis=1)
    present = (sizes > 0).sum(axis=1)
    with np.errstate(divide="ignore", invalid="ignore"):
        within = (total - between) / (n - present)
        share = (between - (present - 1) * within) / (total + within)
    return np.where(np.isfinite(share), np.maximum(share, 0), 0)


def group_values(column):
    """(index of the group of each value, names of the groups): levels as they are, numbers in bins of equal frequency."""
    if isinstance(column[0], str):
        names = list(dict.fromkeys(sorted(column)))
        return np.array([names.index(v) for v in column]), names
    column = np.array(column, float)
    edges = np.quantile(column, np.arange(1, BINS) / BINS)
    ends = [column.min(), *edges, column.max()]
    return np.searchsorted(edges, column, side="right"), [f"{a:.3g} to {b:.3g}" for a, b in zip(ends, ends[1:])]


@dataclasses.dataclass
class Effect:
    """Main effect of a choice on a quantity: fraction of its variance with a bootstrap interval, and the mean of each group."""
    factor: str
    share: float
    low: float
    high: float
    means: dict
    where: str  # the level of another factor in which the choice acts; empty: everywhere

    @property
    def is_clear(self):
        return self.low > 0


def compute_effect(factor, column, values, where="", rng=None):
    groups, names = group_values(column)
    values = np.asarray(values, float)
    share = float(compute_omega_squared(values, groups, len(names))[0])
    rng = rng or np.random.default_rng(0)
    chosen = rng.integers(0, len(values), (RESAMPLES, len(values)))
    # A resample repeats values, which adds about (a - 1)/n of the variance; the interval is moved by this bias.
    drawn = compute_omega_squared(values[chosen], groups[chosen], len(names))
    bias = (len(names) - 1) / len(values) * (1 - share)
    low, high = np.maximum(np.quantile(drawn, [0.5 - LEVEL / 2, 0.5 + LEVEL / 2]) - bias, 0)
    means = {name: float(values[groups == i].mean()) for i, name in enumerate(names) if (groups == i).any()}
    return Effect(factor, share, float(min(low, share)), float(max(high, share)), means, where)


def compute_effects(design, values, acts):
    """Effects of all choices on a quantity, largest first. `design`: the choices of each sample; `values`: the quantity, NaN where it is not
    defined; `acts`: factor to (other factor, level) where alone it acts."""
    effects = []
    rng = np.random.default_rng(0)
    for factor in design[0]:
        other, level = acts.get(factor, (None, None))
        used = [i for i, choice in enumerate(design) if np.isfinite(values[i]) and (other is None or choice[other] == level)]
        if len(used) < SMALLEST or np.ptp([values[i] for i in used]) == 0:
            continue
        column = [design[i][factor] for i in used]
        if len(set(column)) > 1:
            effects.append(compute_effect(factor, column, [values[i] for i in used], f"{other} = {level}" if other else "", rng))
    return sorted(effects, key=lambda e: -e.share)


def compute_overlap_tail(n, first, second, both):
    """P(X <= both) when two independent statements hold in `first` and `second` of n samples (hypergeometric)."""
    def log_choose(a, b):
        return math.lgamma(a + 1) - math.lgamma(b + 1) - math.lgamma(a - b + 1)
    lowest = max(0, first + second - n)
    return min(1.0, math.fsum(math.exp(log_choose(first, i) + log_choose(n - first, second - i) - log_choose(n, second))
                              for i in range(lowest, both + 1)))


@dataclasses.dataclass
class Pair:
    """Two statements: in how many of n samples each and both hold, against the number if they were independent."""
    names: tuple
    counts: tuple
    both: int
    expected: float
    tail: float  # probability of so few or fewer by chance


def list_conflicts(held, limit=0.05):
    """Pairs of statements that hold together less often than by chance, the most unlikely first. `held`: {statement: list of booleans}."""
    names, pairs = list(held), []
    for i, a in enumerate(names):
        for b in names[i + 1:]:
            first, second = np.array(held[a], bool), np.array(held[b], bool)
            n, counts, both = len(first), (int(first.sum()), int(second.sum())), int((first & second).sum())
            if 0 < min(counts) and max(counts) < n:
                tail = compute_overlap_tail(n, *counts, both)
                if tail < limit:
                    pairs.append(Pair((a, b), counts, both, counts[0] * counts[1] / n, tail))
    return sorted(pairs, key=lambda p: (p.both > 0, p.tail))


def list_failing_sets(held):
    """(statements that fail, number of samples in which exactly these fail), fewest statements first."""
    n = len(next(iter(held.values())))
    sets = collections.Counter(tuple(name for name in held if not held[name][i]) for i in range(n))
    return sorted(sets.items(), key=lambda item: (len(item[0]), -item[1], item[0]))


def find_central(candidates, values, targets):
    """Of the samples `candidates` the one with the smallest sum of ((value - printed)/tolerance)², and that sum. `targets`: {quantity: (printed,
    tolerance)}; `values`: one {quantity: value} for each sample."""
    def distance(i):
        return sum(((values[i][name] - printed) / tolerance) ** 2 for name, (printed, tolerance) in targets.items())
    best = min(candidates, key=distance, default=None)
    return None if best is None else (best, distance(best))
