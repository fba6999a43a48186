// SPDX-License-Identifier: MIT
#pragma once
// Strength reduction by finite elements in a run: calculated or taken from an interrupted run, and kept in the folder.

#include <array>
#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include "fem/solid/solid.hpp"
#include "input/case/case.hpp"
#include "results/elements.hpp"
#include "results/run.hpp"
#include "run/fem/solid_of_case.hpp"
#include "run/run_folder.hpp"

namespace talus::run {

// The results of finite elements.

/// Least and greatest ψ of the soils with a strength [rad].
std::array<double, 2> find_dilatancy(const input::Case& data, bool associated);

/// √(⅔ e:e) of a strain with γ as shear components.
double find_shear_strain(const std::array<double, 6>& e);

results::ElementTrial make_trial_result(const fem::ReductionTrial& trial);

/// The search on one mesh of that mean size [m].
template <int D>
results::ElementMeshFactor make_mesh_factor_result(const fem::ReductionResult<D>& found, double size);

/// Factors of two meshes whose sizes differ by a rounding are this far apart [-].
inline constexpr double known_scatter = 0.006;

/// What the error of the fine mesh is at least, over the factor, whatever the difference of two meshes [-].
struct LeastMeshError {
  double below = known_scatter;  ///< the limit may be lower by this
  double above = 0;              ///< and higher by this; displacement elements with ψ = φ are never too weak
};

/// The interval (T19.11) of the factor that a mesh and one of about twice its size extrapolate to. Nothing where a mesh
/// has no trial that failed by flow.
std::optional<results::ElementInterval> find_mesh_interval(const results::ElementMeshFactor& coarse,
                                                           const results::ElementMeshFactor& fine,
                                                           const LeastMeshError& least = {});

template <int D>
results::ElementMesh make_mesh_result(const fem::QuadraticMesh<D>& mesh);

/// Displacement and shear strain at the nodes, and which elements yield.
template <int D>
results::ElementFields make_fields_result(const fem::QuadraticMesh<D>& mesh, const fem::SolidState<D>& state,
                                          results::Flow flow);

template <int D>
class ElementRun {
 public:
  /// `data`: what is calculated. `alone`: the case has no other method.
  ElementRun(const input::Case& data, bool alone, const RunOptions& options, std::string input_hash);

  /// Mesh and model; nothing is written. Throws Error (interrupted); where finite elements answer alone, what
  /// make_solid() throws, else the reason stands in the result.
  void prepare();
  /// The strength reductions, each kept in the folder when it is done. Throws Error (interrupted); where finite
  /// elements answer alone, Error (wrong_input) when there is no equilibrium at any factor or an element is inverted,
  /// else the reason stands in the result.
  void calculate();
  void write_result(results::RunResult& run) const;
  /// As of SliceRun.
  const results::WaterFields* water_fields() const { return water_.fields ? &*water_.fields : nullptr; }

 private:
  struct Model {
    SolidOfCase<D> solid;
    fem::QuadraticMesh<D> mesh;
  };

  /// Runs `part`. If the case has other methods as well, its exception becomes a part of the result.
  template <class Part>
  void attempt(Part part);
  void begin();
  void reduce(results::Flow flow);
  std::unique_ptr<Model> make_model(double share) const;
  /// Tries the other direction of an earthquake at the smallest factor without equilibrium of the first, and searches
  /// there where it fails. Afterwards model, `data_` and `found` are of the direction that governs.
  results::EarthquakeSide compare_directions(results::Flow flow, const std::string& words,
                                             fem::ReductionResult<D>& found);
  fem::ReductionResult<D> search(const Model& model, const std::string& words) const;
  bool has_two_meshes() const { return data_.fem.meshes > 1 && data_.mesh.file.empty(); }
  /// What the mesh does to the factor at least: more where thin layers take part, of which `run` warns.
  LeastMeshError find_least_error(const fem::ReductionResult<D>& found, results::ElementRun& run) const;
  void extrapolate(const std::string& words, const fem::ReductionResult<D>& found, results::ElementRun& run) const;
  void keep() const;
  void show(const std::string& what) const;

  input::Case data_;
  const RunOptions& options_;
  std::string hash_;
  bool alone_;
  bool tries_both_directions_;
  std::unique_ptr<Model> model_;
  ground::WaterResult water_;
  results::ElementFile file_;
  bool is_told_ = false;  ///< the file holds something to tell
  std::chrono::duration<double> spent_{0};
};

}  // namespace talus::run
