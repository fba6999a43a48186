// SPDX-License-Identifier: MIT
#include "report/content/sampling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "report/words/numbers.hpp"
#include "results/json.hpp"

namespace talus::report {

using nlohmann::json;

namespace {

/// "2.4 %", "0.031 %", "0".
std::string show_share(double share) {
  return share == 0 ? "0" : show_number(100 * share, 2) + " %";
}

}  // namespace

json make_sampling(const results::Sampling& sampling) {
  return results::to_json(sampling);
}

void format_sampling(const results::Sampling& sampling, std::vector<std::string>& sentences) {
  if (const auto& failure = sampling.failure)
    sentences.push_back(
        fmt::format("The probability of failure is {}, between {} and {} with {:g} % confidence{}.",
                    show_share(failure->share.probability), show_share(failure->share.lower),
                    show_share(failure->share.upper), 100 * failure->confidence,
                    failure->index ? fmt::format("; the reliability index is {:.2f}", *failure->index) : ""));
  if (const auto& factor = sampling.factor)
    sentences.push_back(fmt::format(
        "The factor of safety of {} samples has the mean {:.3f} and the standard deviation {:.3f}; {:.3f} is the "
        "smallest, {:.3f} the largest.",
        factor->count, keep_finite(factor->mean), keep_finite(factor->deviation), keep_finite(factor->smallest),
        keep_finite(factor->largest)));
  if (sampling.runout)
    for (const results::Exceedance& e : sampling.runout->exceedance)
      sentences.push_back(fmt::format("The soil comes farther than {} m with a probability of {} ({} to {}).",
                                      show_number(e.distance), show_share(e.share.probability),
                                      show_share(e.share.lower), show_share(e.share.upper)));
  if (const auto& t = sampling.failure_time; t && t->count > 0)
    sentences.push_back(fmt::format("The {} samples that fail do so after {} to {} days, {} in the mean.", t->count,
                                    show_number(t->smallest), show_number(t->largest), show_number(t->mean)));
  if (sampling.tornado && !sampling.tornado->empty()) {
    std::string name = sampling.tornado->front().name;
    std::replace(name.begin(), name.end(), '_', ' ');
    sentences.push_back(fmt::format("The factor depends most on the {}.", name));
  }
  sentences.push_back(fmt::format("{} samples by {}{}{}, seed {}; {} s.", sampling.samples,
                                  sampling.plan == results::SampleDraw::random ? "random drawing" : "Latin hypercube",
                                  sampling.method_title.empty() ? "" : ", ", sampling.method_title, sampling.seed,
                                  show_number(sampling.seconds)));
}

}  // namespace talus::report
