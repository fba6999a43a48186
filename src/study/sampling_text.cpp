// SPDX-License-Identifier: MIT
// study.md and samples.csv of sampling.

#include <fmt/format.h>

#include <cmath>

#include "output/files/history.hpp"
#include "output/plots/gnuplot.hpp"
#include "study/sampling.hpp"

namespace talus::study {
namespace {

std::string show_probability(double p) {
  return p == 0 ? "0" : p < 1e-3 ? fmt::format("{:.2e}", p) : fmt::format("{:.4g}", p);
}

std::string show_index(const std::optional<double>& index) {
  return index ? fmt::format("{:.3f}", *index) : "–";
}

std::string show_rank(const std::optional<std::vector<results::RankCorrelation>>& ranks, const std::string& key) {
  if (ranks)
    for (const results::RankCorrelation& r : *ranks)
      if (r.key == key && r.coefficient) return fmt::format("{:.3f}", *r.coefficient);
  return "–";
}

}  // namespace

std::string write_sampling_markdown(const std::string& title, const results::Sampling& sampling) {
  std::string text =
      fmt::format("# {}\n\n{} samples ({}, seed {}), {}: {:.1f} s.\n\n| number | distribution |\n|---|---|\n",
                  title.empty() ? "Study" : title, sampling.samples,
                  sampling.plan == results::SampleDraw::random ? "random" : "Latin hypercube", sampling.seed,
                  sampling.method_title, sampling.seconds);
  for (const results::UncertainNumber& n : sampling.numbers) text += fmt::format("| {} | {} |\n", n.key, n.text);
  for (const results::SampledCorrelation& c : sampling.correlations)
    text += fmt::format("\nCorrelation of {} and {}: {:g} asked, {:.3f} sampled.\n", c.keys[0], c.keys[1], c.asked,
                        c.sampled);
  if (const auto& f = sampling.factor; f && sampling.failure) {
    const results::FailureProbability& p = *sampling.failure;
    text += fmt::format(
        "\nFactor of safety: mean {:.3f}, deviation {:.3f}, skewness {:.2f}, {:.3f} to {:.3f}.\n\n"
        "Probability of failure P(F < 1) = {} ({} of {} samples), between {} and {} with {:g} % "
        "confidence; reliability index β = {}.\n",
        f->mean, f->deviation, f->skewness, f->smallest, f->largest, show_probability(p.share.probability),
        p.share.count, p.share.samples, show_probability(p.share.lower), show_probability(p.share.upper),
        100 * p.confidence, show_index(p.index));
  }
  if (const auto& f = sampling.first_order)
    text += fmt::format(
        "\nFirst order at the means: F = {:.3f}, deviation {:.4f}, β = {:.3f} (normal), {:.3f} "
        "(lognormal).\n",
        f->mean_factor, f->deviation, f->index_normal, f->index_lognormal);
  if (const auto& d = sampling.design_point) {
    text += fmt::format("\nMost probable failure (Hasofer and Lind): β = {:.3f}, probability {}, at", d->index,
                        show_probability(d->probability));
    for (const results::DesignPointValue& v : d->values)
      text += fmt::format("{} {} = {:.4g}{}", &v == d->values.data() ? "" : ",", v.name, v.value,
                          v.unit.empty() ? "" : " " + v.unit);
    text += ".\n";
  }
  if (sampling.tornado) {
    text +=
        "\n| number | at one deviation less | F | at one deviation more | F | rank correlation |\n"
        "|---|--:|--:|--:|--:|--:|\n";
    for (const results::TornadoBar& bar : *sampling.tornado)
      text +=
          fmt::format("| {} | {:.4g} {} | {:.3f} | {:.4g} {} | {:.3f} | {} |\n", bar.name, bar.low_value, bar.unit,
                      bar.low_factor, bar.high_value, bar.unit, bar.high_factor, show_rank(sampling.ranks, bar.key));
  }
  if (const auto& r = sampling.runout) {
    text += fmt::format(
        "\nRunout beyond the toe: mean {:.3g} m, deviation {:.3g} m, {:.3g} to {:.3g} m.\n\n"
        "| farther than | probability | from | to |\n|--:|--:|--:|--:|\n",
        r->values.mean, r->values.deviation, r->values.smallest, r->values.largest);
    for (const results::Exceedance& e : r->exceedance)
      text += fmt::format("| {:.3g} m | {} | {} | {} |\n", e.distance, show_probability(e.share.probability),
                          show_probability(e.share.lower), show_probability(e.share.upper));
  }
  if (const auto& t = sampling.failure_time; t && t->count > 0)
    text += fmt::format("\nTime of failure of the {} samples that fail: mean {:.3g} days, {:.3g} to {:.3g} days.\n",
                        t->count, t->mean, t->smallest, t->largest);
  std::string notes;
  for (const std::string& note : sampling.notes) notes += "- " + note + "\n";
  return text + (notes.empty() ? "" : "\n" + notes);
}

std::string write_samples(const SampleSet& set) {
  std::string text = "sample";
  for (const results::UncertainNumber& n : set.summary.numbers)
    text += "," + output::quote_field(output::make_label(n.key, n.unit));
  if (!set.factor.empty()) text += ",factor of safety";
  if (!set.runout.empty()) text += ",runout beyond the toe [m]";
  if (!set.failure_time.empty()) text += ",time of failure [s]";
  text += '\n';
  const auto write = [](double x) { return std::isfinite(x) ? output::to_shortest(x) : std::string(); };
  for (std::size_t i = 0; i < set.size(); ++i) {
    text += std::to_string(i + 1);
    for (const auto& column : set.values) text += "," + write(column[i]);
    if (!set.factor.empty()) text += "," + write(set.factor[i]);
    if (!set.runout.empty()) text += "," + write(set.runout[i]);
    if (!set.failure_time.empty()) text += "," + write(set.failure_time[i]);
    text += '\n';
  }
  return text;
}

}  // namespace talus::study
