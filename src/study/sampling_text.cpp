// study.md and samples.csv of sampling.

#include <fmt/format.h>

#include <cmath>

#include "output/files/history.hpp"
#include "output/plots/gnuplot.hpp"
#include "study/sampling_table.hpp"

namespace talus::study {
namespace {

using nlohmann::json;

std::string show_probability(double p) {
  return p == 0 ? "0" : p < 1e-3 ? fmt::format("{:.2e}", p) : fmt::format("{:.4g}", p);
}

std::string show_index(const json& index) {
  return index.is_number() ? fmt::format("{:.3f}", index.get<double>()) : "–";
}

}  // namespace

std::string write_sampling_markdown(const std::string& title, const json& b) {
  std::string text = fmt::format(
      "# {}\n\n{} samples ({}, seed {}), {}: {:.1f} s.\n\n| number | distribution |\n|---|---|\n",
      title.empty() ? "Study" : title, b["samples"].get<int>(), b["plan"] == "random" ? "random" : "Latin hypercube",
      b["seed"].get<std::uint64_t>(), b["method_title"].get<std::string>(), b["seconds"].get<double>());
  for (const json& n : b["numbers"])
    text += fmt::format("| {} | {} |\n", n["key"].get<std::string>(), n["text"].get<std::string>());
  for (const json& c : b["correlations"])
    text += fmt::format("\nCorrelation of {} and {}: {:g} asked, {:.3f} sampled.\n", c["keys"][0].get<std::string>(),
                        c["keys"][1].get<std::string>(), c["asked"].get<double>(), c["sampled"].get<double>());
  if (const json& f = b["factor"]; f.is_object()) {
    const json& p = b["failure"];
    text += fmt::format(
        "\nFactor of safety: mean {:.3f}, deviation {:.3f}, skewness {:.2f}, {:.3f} to {:.3f}.\n\n"
        "Probability of failure P(F < 1) = {} ({} of {} samples), between {} and {} with {:g} % "
        "confidence; reliability index β = {}.\n",
        f["mean"].get<double>(), f["deviation"].get<double>(), f["skewness"].get<double>(), f["smallest"].get<double>(),
        f["largest"].get<double>(), show_probability(p["probability"]), p["count"].get<long>(),
        p["samples"].get<long>(), show_probability(p["lower"]), show_probability(p["upper"]),
        100 * p["confidence"].get<double>(), show_index(p["index"]));
  }
  if (const json& f = b["first_order"]; f.is_object())
    text += fmt::format(
        "\nFirst order at the means: F = {:.3f}, deviation {:.4f}, β = {:.3f} (normal), {:.3f} "
        "(lognormal).\n",
        f["mean_factor"].get<double>(), f["deviation"].get<double>(), f["index_normal"].get<double>(),
        f["index_lognormal"].get<double>());
  if (const json& d = b["design_point"]; d.is_object()) {
    text += fmt::format("\nMost probable failure (Hasofer and Lind): β = {:.3f}, probability {}, at",
                        d["index"].get<double>(), show_probability(d["probability"]));
    for (const json& v : d["values"])
      text += fmt::format("{} {} = {:.4g}{}", &v == &d["values"][0] ? "" : ",", v["name"].get<std::string>(),
                          v["value"].get<double>(), v["unit"] == "" ? "" : " " + v["unit"].get<std::string>());
    text += ".\n";
  }
  if (const json& t = b["tornado"]; t.is_array()) {
    text +=
        "\n| number | at one deviation less | F | at one deviation more | F | rank correlation |\n"
        "|---|--:|--:|--:|--:|--:|\n";
    for (const json& bar : t) {
      std::string rank = "–";
      for (const json& r : b["ranks"])
        if (r["key"] == bar["key"] && r["coefficient"].is_number())
          rank = fmt::format("{:.3f}", r["coefficient"].get<double>());
      text += fmt::format("| {} | {:.4g} {} | {:.3f} | {:.4g} {} | {:.3f} | {} |\n", bar["name"].get<std::string>(),
                          bar["low_value"].get<double>(), bar["unit"].get<std::string>(),
                          bar["low_factor"].get<double>(), bar["high_value"].get<double>(),
                          bar["unit"].get<std::string>(), bar["high_factor"].get<double>(), rank);
    }
  }
  if (const json& r = b["runout"]; r.is_object()) {
    text += fmt::format(
        "\nRunout beyond the toe: mean {:.3g} m, deviation {:.3g} m, {:.3g} to {:.3g} m.\n\n"
        "| farther than | probability | from | to |\n|--:|--:|--:|--:|\n",
        r["mean"].get<double>(), r["deviation"].get<double>(), r["smallest"].get<double>(), r["largest"].get<double>());
    for (const json& e : r["exceedance"])
      text +=
          fmt::format("| {:.3g} m | {} | {} | {} |\n", e["distance"].get<double>(), show_probability(e["probability"]),
                      show_probability(e["lower"]), show_probability(e["upper"]));
  }
  std::string notes;
  for (const json& note : b["notes"]) notes += "- " + note.get<std::string>() + "\n";
  return text + (notes.empty() ? "" : "\n" + notes);
}

std::string write_samples(const SampleSet& set) {
  std::string text = "sample";
  for (const SampledNumber& n : set.sampled.numbers) text += "," + output::make_label(n.key, n.unit);
  if (!set.factor.empty()) text += ",factor of safety";
  if (!set.runout.empty()) text += ",runout beyond the toe [m]";
  text += '\n';
  const auto write = [](double x) { return std::isfinite(x) ? output::to_shortest(x) : std::string(); };
  for (std::size_t i = 0; i < set.size(); ++i) {
    text += std::to_string(i + 1);
    for (const auto& column : set.values) text += "," + write(column[i]);
    if (!set.factor.empty()) text += "," + write(set.factor[i]);
    if (!set.runout.empty()) text += "," + write(set.runout[i]);
    text += '\n';
  }
  return text;
}

}  // namespace talus::study
