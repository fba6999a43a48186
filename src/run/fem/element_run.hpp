// SPDX-License-Identifier: MIT
#pragma once
// Strength reduction by FEM in a run: computed or read from an interrupted run, and stored in the folder.

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "fem/solid/solid.hpp"
#include "input/case/case.hpp"
#include "results/elements.hpp"
#include "results/present.hpp"
#include "results/run.hpp"
#include "run/common/method_run.hpp"
#include "run/fem/solid_of_case.hpp"

namespace talus::run {

/// Smallest and largest ψ of the soils with a strength [rad].
std::array<double, 2> find_dilatancy(const input::Case& data, bool associated);

/// √(⅔ e:e) of a strain with γ as shear components.
double find_shear_strain(const std::array<double, 6>& e);

results::ElementTrial make_trial_result(const fem::ReductionTrial& trial);

/// Result of the search on one mesh of that mean size [m].
template <int D>
results::ElementMeshFactor make_mesh_factor_result(const fem::ReductionResult<D>& found, double size);

/// Safety factor of the grid convergence index for two grids (Roache 1994): error of the fine mesh over the
/// extrapolated difference. It covers the limit for orders of convergence of at least 0.42.
inline constexpr double mesh_safety = 3;
/// Element size of the coarser of two meshes over that of [fem]; the coarser one takes a sixth of the time.
inline constexpr double coarse_ratio = 2;
/// Meshes with a smaller ratio of mean sizes count as one mesh, because the section is too small for elements of twice
/// the size [-].
inline constexpr double least_ratio = 1.25;
/// Scatter of the factor between meshes of practically equal size [-].
inline constexpr double known_scatter = 0.006;

/// Least error of the fine mesh, over the factor, regardless of the difference between two meshes [-].
struct LeastMeshError {
  double below = known_scatter;  ///< the limit may be lower by this
  double above = 0;  ///< the limit may be higher by this; displacement elements with ψ = φ never underestimate it
};

/// Returns the interval (T19.12) of the factor extrapolated from a mesh and one of about twice its element size;
/// nullopt if a mesh has no trial that failed by flow.
std::optional<results::ElementInterval> find_mesh_interval(const results::ElementMeshFactor& coarse,
                                                           const results::ElementMeshFactor& fine,
                                                           const LeastMeshError& least = {});

template <int D>
results::ElementMesh make_mesh_result(const fem::QuadraticMesh<D>& mesh);

/// Displacement and shear strain at the nodes, and the yielding elements.
template <int D>
results::ElementFields make_fields_result(const fem::QuadraticMesh<D>& mesh, const fem::SolidState<D>& state,
                                          results::Flow flow);

/// Returns true if a soil of the case has ψ < φ.
bool has_less_dilatancy(const input::Case& data);

fem::ReductionOptions make_options(const input::FiniteElements& settings, int threads);

template <int D>
class ElementRun : public MethodRun<results::ElementFile> {
 public:
  /// `site`: of the case or its design values. `alone`: the case has no other method.
  ElementRun(const site::Site& site, bool alone, const RunOptions& options, std::string input_hash);

  /// Lets bars and walls begin with these deformations, in place of the prestress of anchors and struts.
  void start_supports(std::vector<fem::KnownSpring> known) { known_springs_ = std::move(known); }
  /// Prepares mesh and model; writes nothing. Throws Error (interrupted); if FEM is the only method, what make_solid()
  /// throws, otherwise the reason is part of the result.
  void prepare();
  /// Runs the strength reductions and stores each when it is finished. Throws Error (interrupted); if FEM is the only
  /// method, Error (wrong_input) when no factor has equilibrium or an element is inverted, otherwise the reason is
  /// part of the result.
  void calculate();
  void write_result(results::RunResult& run) const;

 private:
  struct Model {
    SolidOfCase<D> solid;
    fem::QuadraticMesh<D> mesh;
  };

  /// Runs `part`; without an error the model remains.
  void attempt_part(const std::function<void()>& part);
  void begin();
  void reduce(results::Flow flow);
  std::unique_ptr<Model> make_model(double share) const;
  /// Tries the other direction of an earthquake at the smallest factor without equilibrium of the first, and searches
  /// there if it fails. Afterwards model, `site_` and `found` are those of the governing direction.
  results::EarthquakeSide compare_directions(results::Flow flow, const std::string& words,
                                             fem::ReductionResult<D>& found);
  fem::ReductionResult<D> search(const Model& model, const std::string& words);
  fem::ReductionResult<D> search(const Model& model, const std::string& words, const fem::ReductionOptions& options);
  /// Returns the model on another mesh, with the supports of start_supports().
  std::unique_ptr<Model> make_model_on(SolidOfCase<D> solid) const;
  /// Refines the mesh where the soil shears and searches again until the interval is narrow or the mesh is as large as
  /// permitted. `model_` and `found` become those of the finest mesh.
  void adapt(const std::string& words, fem::ReductionResult<D>& found, results::ElementRun& run);
  /// Returns why the mesh of the case is not adapted; nullptr if it is.
  const char* find_obstacle() const;
  /// Describes the mesh of `model_` in the result.
  void describe_mesh();
  /// Adds a trial to `present_` and stores it with the state of the trial.
  void keep_present(const Model& model, const fem::ReductionTrial& trial, const fem::SolidState<D>& state);
  /// Returns false if the factor has no limit for elements of size zero too.
  bool has_two_meshes() const {
    return data().fem.meshes > 1 && data().mesh.file.empty() && (!softens_in_trials(data()) || data().softening_length);
  }
  /// Returns the least mesh error of the factor, which is larger if thin layers are part of the mechanism; adds a
  /// warning of them to `run`.
  LeastMeshError find_least_error(const fem::ReductionResult<D>& found, results::ElementRun& run) const;
  /// Adds a warning if the factor on a mesh depends on its elements because soil softens.
  void add_softening_warning(const Model& model, const fem::ReductionResult<D>& found, results::ElementRun& run) const;
  void extrapolate(const std::string& words, const fem::ReductionResult<D>& found, results::ElementRun& run);
  void keep() const;

  const input::Case& data() const { return site_.data(); }

  site::Site site_;  ///< with one direction of an earthquake once that is decided
  bool tries_both_directions_;
  std::unique_ptr<Model> model_;
  bool adapts_ = false;   ///< [fem] adapt, and nothing prevents it
  bool is_told_ = false;  ///< the file has results
  std::vector<fem::KnownSpring> known_springs_;
  results::PresentReduction present_;
  PresentClock clock_;
};

}  // namespace talus::run
