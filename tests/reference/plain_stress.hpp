// SPDX-License-Identifier: MIT
#pragma once
// The second half of the plain step: strain increments of the elements, stresses of the points, and the nodal averaging
// that prevents locking of linear simplices (2.43–2.45, 2.94–2.95).

#include <Eigen/Dense>
#include <cstddef>
#include <vector>

#include "reference/plain_body.hpp"

namespace talus::reference {

/// An element field averaged to the nodes with weights V_e (2.94), and back (2.95). Elements without points and those
/// of separated soil are excluded and keep their values.
template <int D>
std::vector<double> smooth_over_nodes(const Body<D>& body, const std::vector<double>& field) {
  std::vector<double> sum(body.nodes.size(), 0), volume(body.nodes.size(), 0), smoothed(field.size(), 0);
  for (int e = 0; e < body.mesh.element_count(); ++e) {
    if (!at(body.cells, e).is_active() || at(body.cells, e).apart) continue;
    for (int i = 0; i <= D; ++i) {
      at(sum, node_of(body.mesh, e, i)) += at(field, e) * at(body.mesh.volumes, e);
      at(volume, node_of(body.mesh, e, i)) += at(body.mesh.volumes, e);
    }
  }
  for (int e = 0; e < body.mesh.element_count(); ++e) {
    if (!at(body.cells, e).is_active()) continue;
    if (at(body.cells, e).apart) at(smoothed, e) = at(field, e);
    for (int i = 0; i <= D && !at(body.cells, e).apart; ++i) {
      const int node = node_of(body.mesh, e, i);
      at(smoothed, e) += at(sum, node) / at(volume, node) / (D + 1);
    }
  }
  return smoothed;
}

/// Finds the elements with a point that keeps a gap.
template <class Body, class Settings>
void note_gaps(Body& body, const Settings& settings) {
  for (auto& cell : body.cells) {
    cell.apart = false;
    for (std::size_t p : cell.points)
      if (!settings.frozen && body.points[p].gap > 0) cell.apart = true;
  }
}

/// Distributes a change of the volumetric strain over the in-plane directions. In plane strain these are two: with
/// three, as in the text of 2.5.4, an out-of-plane strain remains, and a third of the change becomes a deviator.
template <int D>
Tensor spread_volumetric(double change, bool over_three = false) {
  if (over_three) return change / 3 * Tensor::Identity();
  Tensor strain = Tensor::Zero();
  strain.topLeftCorner<D, D>().diagonal().setConstant(change / D);
  return strain;
}

/// Correction of the volumetric increments of the elements by smoothing. `average` returns the nodal averages of an
/// element field; excluded elements keep their values. Smoothing::stable averages the elastic part (T4.4): plastic flow
/// follows the shear of its own element, and with the dilation of others a dilatant soil is unstable. The plastic part
/// is that of the last step. A quarter of the difference is applied one step late (T4.5).
template <class Body, class Average>
std::vector<double> find_smoothing_change(Body& body, Smoothing smoothing, std::vector<double> elastic,
                                          Average&& average) {
  const bool stable = smoothing == Smoothing::stable;
  body.plastic_dilation.resize(elastic.size(), 0);
  body.rough.resize(elastic.size(), 0);
  for (std::size_t e = 0; e < elastic.size() && stable; ++e) elastic[e] -= body.plastic_dilation[e];
  const std::vector<double> smoothed = average(elastic);
  std::vector<double> change(elastic.size(), 0);
  for (std::size_t e = 0; e < elastic.size(); ++e) {
    const bool part = body.cells[e].is_active() && !body.cells[e].apart;
    const double rough = part ? elastic[e] - smoothed[e] : 0;
    if (part) change[e] = stable ? 0.25 * (rough - body.rough[e]) - rough : -rough;
    body.rough[e] = stable ? rough : 0;
  }
  return change;
}

/// L and Δε = sym(L)Δt of every active element (2.43); on request with the smoothed volumetric part.
template <int D>
void compute_strain_increments(Body<D>& body, const Settings& settings) {
  std::vector<double> volumetric(body.cells.size(), 0);
  for (int e = 0; e < body.mesh.element_count(); ++e) {
    Cell& cell = at(body.cells, e);
    if (!cell.is_active()) continue;
    const Gradients<D> b = shape_gradients(body.mesh, e);
    for (int i = 0; i <= D; ++i)
      cell.gradient.template topLeftCorner<D, D>() += at(body.nodes, node_of(body.mesh, e, i)).velocity * b.row(i);
    cell.strain_increment = settings.time_step / 2 * (cell.gradient + cell.gradient.transpose());
    at(volumetric, e) = cell.strain_increment.trace();
  }
  if (settings.smoothing == Smoothing::none) return;
  const std::vector<double> change = find_smoothing_change(
      body, settings.smoothing, volumetric, [&](const auto& field) { return smooth_over_nodes(body, field); });
  for (std::size_t e = 0; e < body.cells.size(); ++e)
    body.cells[e].strain_increment += spread_volumetric<D>(change[e], settings.smooths_three);
}

/// R of Hughes and Winget (1980) for the spin W = (L − Lᵀ)Δt/2: orthogonal for any W.
inline Tensor rotation_increment(const Tensor& gradient, double time_step) {
  const Tensor spin = time_step / 2 * (gradient - gradient.transpose());
  return (Tensor::Identity() - spin / 2).inverse() * (Tensor::Identity() + spin / 2);
}

/// Gives the V_p-weighted means of stress, plastic strain and gap to every point of a full element.
template <int D>
void average_state(Body<D>& body, const Cell& cell) {
  const Tensor sigma = average_stress(body, cell);
  double plastic_strain = 0, gap = 0, volume = 0;
  for (std::size_t p : cell.points) {
    plastic_strain += body.points[p].volume * body.points[p].plastic_strain;
    gap += body.points[p].volume * body.points[p].gap;
    volume += body.points[p].volume;
  }
  for (std::size_t p : cell.points) {
    body.points[p].sigma = sigma;
    body.points[p].plastic_strain = plastic_strain / volume;
    body.points[p].gap = gap / volume;
  }
}

/// Updates a point; in moving geometry it keeps the gap of its separation.
template <class Point, class Settings, int D = Point::dimension>
StressUpdate update_moving_stress(const Material& material, const Tensor& sigma, const Tensor& strain_increment,
                                  const Settings& settings, Point& point) {
  if (settings.frozen) return update_stress(material, sigma, strain_increment);
  if constexpr (requires { settings.separates; })
    if (!settings.separates) return update_stress(material, sigma, strain_increment);
  StressUpdate update = update_separating(material, sigma, strain_increment, point.gap, D);
  point.gap += update.opened;
  return update;
}

/// The plastic strain of an update, summed over the directions that move.
template <int D>
double find_dilation(const StressUpdate& update) {
  return update.plastic.topLeftCorner<D, D>().trace();
}

/// Stress (2.44), strain, plastic strain and volume (2.45) of every point, and the plastic dilation of the elements.
/// The points of a full element start from the same mean state and so end in the same state: it is one update, given to
/// all of them.
template <int D>
void update_points(Body<D>& body, const Settings& settings) {
  body.plastic_dilation.assign(body.cells.size(), 0);
  for (std::size_t e = 0; e < body.cells.size(); ++e) {
    const Cell& cell = body.cells[e];
    if (cell.full) average_state(body, cell);
    double dilation = 0, volume = 0;
    const Tensor r = settings.objective ? rotation_increment(cell.gradient, settings.time_step) : Tensor::Identity();
    for (std::size_t p : cell.points) {
      Point<D>& point = body.points[p];
      const Tensor rotated = r * point.sigma * r.transpose();
      const StressUpdate update =
          update_moving_stress(at(body.materials, point.material), rotated, cell.strain_increment, settings, point);
      point.sigma = update.sigma;
      point.plastic_strain += update.plastic_strain;
      point.strain += cell.strain_increment;
      if (!settings.frozen) point.volume *= (1 + cell.strain_increment.trace()) * (1 - update.opened);
      dilation += point.volume * find_dilation<D>(update);
      volume += point.volume;
    }
    if (cell.is_active()) body.plastic_dilation[e] = dilation / volume;
  }
}

}  // namespace talus::reference
