// SPDX-License-Identifier: MIT
// Consistent tangents of the laws by dual numbers.
#include "fem/solid/system.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

#include "base/dual.hpp"
#include "material/every_law.hpp"

namespace talus::fem {
namespace {

using material::LinearElastic;
using material::Surroundings;

constexpr double symmetry_tolerance = 1e-9;  ///< of a tangent, relative to its largest entry

template <int NS>
void fill_elastic(const LinearElastic& elastic, double* c) {
  std::fill_n(c, NS * NS, 0.0);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) c[i * NS + j] = elastic.lambda;
    c[i * NS + i] += 2 * elastic.mu;
  }
  for (int i = 3; i < NS; ++i) c[i * NS + i] = elastic.mu;
}

/// Returns true if the matrix is symmetric within rounding.
template <int NS>
bool is_symmetric(const double* c) {
  double largest = 0, difference = 0;
  for (int i = 0; i < NS; ++i)
    for (int j = 0; j < NS; ++j) {
      largest = std::max(largest, std::abs(c[i * NS + j]));
      difference = std::max(difference, std::abs(c[i * NS + j] - c[j * NS + i]));
    }
  return difference <= symmetry_tolerance * largest;
}

template <class L>
bool has_yielded(const material::Response<double>& response) {
  if constexpr (L::traits.stores_always)
    return response.dissipation != 0;
  else
    return response.any_plastic;
}

template <int NS, class L>
PointAnswer update_plain(const L& law, double saturation, const double* d_epsilon, double* sigma, double* state) {
  const Surroundings<double> around{saturation};
  return {has_yielded<L>(law.template update<NS, double>(sigma, d_epsilon, state, true, around)), true};
}

/// Computes the tangent by central differences, for laws without an analytical one.
template <int NS, class L>
void differentiate(const L& law, double saturation, const double* d_epsilon, const double* sigma, const double* state,
                   double* tangent) {
  double size = 1e-6;
  for (int i = 0; i < NS; ++i) size = std::max(size, std::abs(d_epsilon[i]));
  const double step = 1e-5 * size;
  for (int j = 0; j < NS; ++j) {
    std::array<std::array<double, NS>, 2> result;
    for (std::size_t side = 0; side < 2; ++side) {
      std::array<double, NS> d;
      std::array<double, L::state_size> q;
      std::copy_n(d_epsilon, NS, d.begin());
      std::copy_n(sigma, NS, result[side].begin());
      std::copy_n(state, L::state_size, q.begin());
      d[static_cast<std::size_t>(j)] += side == 0 ? step : -step;
      update_plain<NS>(law, saturation, d.data(), result[side].data(), q.data());
    }
    for (int i = 0; i < NS; ++i) {
      const auto k = static_cast<std::size_t>(i);
      tangent[i * NS + j] = (result[0][k] - result[1][k]) / (2 * step);
    }
  }
}

template <int NS, class L>
PointAnswer update_with_tangent(const L& law, double saturation, const double* d_epsilon, double* sigma, double* state,
                                double* tangent) {
  const Surroundings<double> around{saturation};
  if constexpr (requires { law.template update_point<NS>(sigma, d_epsilon, state, around, tangent); }) {
    PointAnswer answer{law.template update_point<NS>(sigma, d_epsilon, state, around, tangent).any_plastic, true};
    answer.symmetric = is_symmetric<NS>(tangent);
    return answer;
  } else if constexpr (L::traits.is_opaque) {
    std::array<double, NS> old_sigma;
    std::array<double, L::state_size> old_state;
    std::copy_n(sigma, NS, old_sigma.begin());
    std::copy_n(state, L::state_size, old_state.begin());
    auto answer = update_plain<NS>(law, saturation, d_epsilon, sigma, state);
    // The response of a library within its yield surface is unknown.
    if constexpr (!L::traits.stores_always)
      if (!answer.yields) {
        fill_elastic<NS>(law.find_elastic(), tangent);
        return answer;
      }
    differentiate<NS>(law, saturation, d_epsilon, old_sigma.data(), old_state.data(), tangent);
    answer.symmetric = is_symmetric<NS>(tangent);
    return answer;
  } else {
    std::array<double, NS> old_sigma;
    std::array<double, L::state_size + 1> old_state;
    std::copy_n(sigma, NS, old_sigma.begin());
    std::copy_n(state, L::state_size, old_state.begin());
    auto answer = update_plain<NS>(law, saturation, d_epsilon, sigma, state);
    if constexpr (!L::traits.changes_stiffness) {
      if (!answer.yields) {
        fill_elastic<NS>(law.find_elastic(), tangent);
        return answer;
      }
    }
    using T = Dual<NS>;
    std::array<T, NS> s, d;
    std::array<T, L::state_size + 1> q;
    for (int i = 0; i < NS; ++i) {
      const auto k = static_cast<std::size_t>(i);
      s[k] = T(old_sigma[k]);
      d[k] = T::variable(d_epsilon[i], i);
    }
    for (std::size_t i = 0; i < L::state_size; ++i) q[i] = T(old_state[i]);
    Surroundings<T> dual_around;
    dual_around.saturation = T(saturation);
    law.template update<NS, T>(s.data(), d.data(), q.data(), true, dual_around);
    for (int i = 0; i < NS; ++i)
      for (int j = 0; j < NS; ++j) tangent[i * NS + j] = s[static_cast<std::size_t>(i)].slope[j];
    answer.symmetric = is_symmetric<NS>(tangent);
    return answer;
  }
}

}  // namespace

template <int NS>
PointAnswer update_point(const material::Law& law, double saturation, const double* d_epsilon, double* sigma,
                         double* state, double* tangent) {
  const auto update = [&](const auto& l) {
    if (tangent) return update_with_tangent<NS>(l, saturation, d_epsilon, sigma, state, tangent);
    return update_plain<NS>(l, saturation, d_epsilon, sigma, state);
  };
  return std::visit(
      [&]<class L>(const L& l) {
        if constexpr (requires { l.make_frozen(0.0); })
          return update(l.make_frozen(state[L::softening_state]));  // a perfectly plastic law does not use this state
        else
          return update(l);
      },
      law);
}

template <int NS>
void find_elastic_stiffness(const material::Law& law, const double* sigma, const double* state, double* stiffness) {
  std::visit([&](const auto& l) { fill_elastic<NS>(l.find_elastic(sigma, state), stiffness); }, law);
}

template PointAnswer update_point<4>(const material::Law&, double, const double*, double*, double*, double*);
template PointAnswer update_point<6>(const material::Law&, double, const double*, double*, double*, double*);
template void find_elastic_stiffness<4>(const material::Law&, const double*, const double*, double*);
template void find_elastic_stiffness<6>(const material::Law&, const double*, const double*, double*);

}  // namespace talus::fem
