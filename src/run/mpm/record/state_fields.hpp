// SPDX-License-Identifier: MIT
#pragma once
// The quantities that the laws of a body have beside stress, as fields over all its points.

#include <limits>
#include <string>
#include <vector>

#include "mpm/body/observe.hpp"

namespace talus::run {

/// Quantities of all laws, each once, and which values of which law they are.
class StateFields {
 public:
  explicit StateFields(const std::vector<material::Law>& laws);

  const std::vector<material::StateField>& list() const { return fields_; }
  /// Values of a point in the order of the list: NaN for what its soil does not have or what is not set yet, zero for
  /// roots in soil without any.
  template <int D>
  std::vector<double> read(const mpm::Body<D>& body, const mpm::PointView<D>& point) const {
    const auto law = static_cast<std::size_t>(point.material);
    return arrange(body.laws[law], law, point.state.data(), point.wet ? point.saturation : 1.0);
  }

 private:
  std::vector<double> arrange(const material::Law& law, std::size_t number, const double* state,
                              double saturation) const;
  std::vector<material::StateField> fields_;
  std::vector<std::vector<std::size_t>> places_;  ///< [law][its field] → place in the list
};

}  // namespace talus::run
