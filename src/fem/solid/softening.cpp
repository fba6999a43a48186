// SPDX-License-Identifier: MIT
// Equilibrium of soil that softens, and the nonlocal average of its plastic strain (theory 23).
#include "fem/solid/softening.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "material/every_law.hpp"
#include "mesh/near_elements.hpp"

namespace talus::fem {
namespace {

/// Cut-off of the weight r exp(-r²), in nonlocal lengths, as in MPM.
constexpr double farthest = 2;

/// Calls work(law) if the law softens.
void visit_softening(const material::Law& law, auto&& work) {
  std::visit(
      [&]<class L>(const L& l) {
        if constexpr (requires { L::softening_state; }) work(l);
      },
      law);
}

bool softens(const material::Law& law) {
  bool answer = false;
  visit_softening(law, [&](const auto&) { answer = true; });
  return answer;
}

}  // namespace

template <int D>
SolidSoftening<D>::SolidSoftening(const SolidSystem<D>& system, const SolidOptions& options)
    : system_(system), most_(options.most_softenings), tolerance_(options.softening_tolerance) {}

template <int D>
void SolidSoftening<D>::find_neighbours() {
  const mesh::Mesh<D>& mesh = *system_.model.mesh;
  const double length = system_.model.softening_length;
  std::vector<int> place(mesh.elements.size(), -1);  // in the quadratic mesh
  for (std::size_t k = 0; k < system_.mesh.elements.size(); ++k)
    place[static_cast<std::size_t>(system_.mesh.linear_element[k])] = static_cast<int>(k);
  const mesh::NearElements<D> near(mesh, farthest * length);
  start_.push_back(0);
  for (const int e : system_.mesh.linear_element) {
    near.visit(e, [&](int other, double distance) {
      const double r = distance / length;
      if (other == e || place[static_cast<std::size_t>(other)] < 0) return;
      neighbour_.push_back(place[static_cast<std::size_t>(other)]);
      weight_.push_back(r * std::exp(-r * r));
    });
    start_.push_back(neighbour_.size());
  }
}

/// Returns the average (T23.1) of the plastic strain around an element.
template <int D>
double SolidSoftening<D>::average(std::size_t k) const {
  double strain = 0, volume = 0;
  for (std::size_t i = start_[k]; i < start_[k + 1]; ++i) {
    const auto other = static_cast<std::size_t>(neighbour_[i]);
    strain += weight_[i] * volume_[other] * strain_[other];
    volume += weight_[i] * volume_[other];
  }
  return volume > 0 ? strain / volume : strain_[k];
}

template <int D>
typename SolidSoftening<D>::Fall SolidSoftening<D>::lower_strengths(const SolidAssembly<D>& assembly,
                                                                    SolidState<D>& state) {
  constexpr std::size_t points = Quadratic<D>::points;
  const std::size_t count = system_.mesh.elements.size(), size = static_cast<std::size_t>(assembly.state_size());
  const auto& weights = system_.mesh.weights;
  const bool is_nonlocal = system_.model.softening_length > 0;
  if (is_nonlocal && start_.empty()) find_neighbours();
  strain_.assign(count, 0);
  volume_.assign(count, 0);
  for (std::size_t k = 0; k < count; ++k) {
    if (!softens(assembly.get_law(k))) continue;
    for (std::size_t p = k * points; p < (k + 1) * points; ++p) {
      strain_[k] += weights[p] * state.state[p * size];
      volume_[k] += weights[p];
    }
    strain_[k] /= volume_[k];
  }
  Fall fall;
  double volume = 0;
  for (std::size_t k = 0; k < count; ++k)
    visit_softening(assembly.get_law(k), [&]<class L>(const L& law) {
      const double nonlocal = is_nonlocal ? average(k) : 0;
      for (std::size_t p = k * points; p < (k + 1) * points; ++p) {
        double& strain = state.state[p * size + L::softening_state];
        const double before = law.range().find_share(strain);
        strain = std::max(strain, is_nonlocal ? nonlocal : state.state[p * size]);
        const double lost = law.range().find_share(strain) - before;
        fall.largest = std::max(fall.largest, lost);
        fall.mean += weights[p] * lost;
        volume += weights[p];
      }
    });
  if (volume > 0) fall.mean /= volume;
  return fall;
}

template <int D>
SofteningOutcome SolidSoftening<D>::solve(SolidNewton<D>& newton, const SolidAssembly<D>& assembly,
                                          const SolidState<D>& start, const std::vector<double>& target,
                                          SolidState<D>& end) {
  SofteningOutcome out{newton.solve(assembly, start, target, end)};
  double last = 0;  // mean fall before
  while (out.converged) {
    const Fall fall = lower_strengths(assembly, end);
    // The falls still to come if they continue to decay at the same ratio, as in (T19.7).
    const double ratio = last > 0 ? fall.mean / last : 0,
                 rest = ratio < 1 ? fall.largest * std::max(1.0, ratio / (1 - ratio)) : 1;
    if (rest <= tolerance_) break;
    if (out.softenings == most_) {
      out.converged = false;
      break;
    }
    last = fall.mean;
    const SolidState<D> from = std::move(end);
    const int iterations = out.iterations;
    static_cast<NewtonOutcome&>(out) = newton.solve(assembly, from, target, end);
    out.iterations += iterations;
    ++out.softenings;
  }
  return out;
}

template class SolidSoftening<2>;
template class SolidSoftening<3>;

}  // namespace talus::fem
