// SPDX-License-Identifier: MIT
#pragma once
// The model of a case for FEM: mesh, supports, laws, water and loads, and the layers that are too thin for their
// elements.

#include <memory>
#include <string>
#include <vector>

#include "fem/solid/solid.hpp"
#include "site/seepage_results.hpp"
#include "site/site.hpp"

namespace talus::run {

template <int D>
struct SolidOfCase {
  std::shared_ptr<const mesh::Mesh<D>> mesh;  ///< referenced by the model
  fem::SolidModel<D> model;                   ///< with the given dilatancy angles
  site::WaterResult water;                    ///< origin of the pore pressures
  std::vector<std::string> notes;             ///< sentences on what FEM does not take from the case
};

/// Makes mesh, supports, weights, water and loads of a case. Pore pressures of steady seepage are computed on the same
/// mesh. `share`: factor on the element size. Throws Error (wrong_input) for a material or a boundary that FEM at
/// small strain does not support, and what mesh::generate() and find_initial_water() throw.
template <int D>
SolidOfCase<D> make_solid(const site::Site& site, double share = 1);

/// The same on an existing mesh.
template <int D>
SolidOfCase<D> make_solid_on(const site::Site& site, std::shared_ptr<const mesh::Mesh<D>> mesh);

/// Replaces the laws of the case by those of the trials of a strength reduction: with ψ = φ, else with the strength of
/// [fem] davis, if that is asked for.
template <int D>
void set_trial_laws(const site::Site& site, SolidOfCase<D>& solid, bool associated);

/// Returns β, by which c and tan φ of soil with ψ < φ are multiplied before its flow is taken as associated: Davis
/// (1968) for `rule` a, Tschuchnigg, Schweiger and Sloan (2015), Comput. Geotech. 70, 169 and 178, for b and c.
/// Angles [rad] are those of the case, `factor` is that of the trial.
double compute_davis_share(input::DavisRule rule, double friction_angle, double dilatancy_angle, double factor);

/// Returns the soil of the trials: that of the case in a progressive failure, else that without softening.
input::Material find_trial_soil(const input::Case& data, const input::Material& soil);

/// Returns true if a soil of the section softens in the trials.
bool softens_in_trials(const input::Case& data);

/// Throws Error (wrong_input) for materials and boundaries that make_solid() does not support, without a mesh.
void check_solid(const site::Site& site);

/// Returns the mesh plan of make_solid(): that of the case with the element size times `share`, and the algorithm, of
/// [fem].
mesh::Plan make_fem_plan(const site::Site& site, double share = 1);

/// Returns the mean shear strain of each quadratic element.
template <int D>
std::vector<double> compute_element_strains(const fem::QuadraticMesh<D>& mesh, const fem::SolidState<D>& motion);

/// Returns γ_c of (T19.11), the least strain of elements that are part of the mechanism.
double compute_band_strain(std::vector<double> strains);

/// Least number of rows of elements over the thickness of a layer. With fewer rows, two meshes do not show the error
/// of the factor.
inline constexpr double fewest_element_rows = 4;
/// Largest relative error of the factor with fewer rows: a weak seam under a toe was 2.7 to 4.5 % too high with one
/// row and 2.0 to 3.8 % with two, by the ends of the interval of limit analysis [-].
inline constexpr double thin_layer_error = 0.05;

/// Lists the regions of the section with fewer rows that are part of the mechanism: the strain of one of their
/// elements is at least γ_c of (T19.11). `motion`: ReductionResult::mechanism. `is_adapted`: the rows are those of
/// elements of the mechanism, as others are larger.
std::vector<std::string> list_thin_layers(const mesh::Mesh<2>& mesh, const fem::QuadraticMesh<2>& quadratic,
                                          const fem::SolidState<2>& motion, bool is_adapted = false);

}  // namespace talus::run
