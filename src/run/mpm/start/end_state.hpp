// SPDX-License-Identifier: MIT
#pragma once
// The state at the end of the stages of a run, stored in its folder, from which another case can start.

#include <filesystem>
#include <string>
#include <vector>

#include "base/json_tree.hpp"
#include "input/case/case.hpp"
#include "mpm/state/body.hpp"
#include "output/files/archive.hpp"
#include "results/run.hpp"

namespace talus::run {

/// The end state of a result as the initial state of another case: [initial] result.
class EndState {
 public:
  /// Throws Error (wrong_input) if the file does not exist, is damaged, or was written by a build with another lane
  /// width.
  explicit EndState(const input::Initial& initial);

  /// Echo of the case of the result; its geometry and mesh are those of the points.
  const JsonTree& input() const { return input_; }
  /// Hash of the mesh, the points and all their variables.
  const std::string& hash() const { return archive_.text("state_hash"); }
  /// Returns the origin of a run, for its summary.
  results::Origin tell() const;
  /// Returns true if [geometry] or [mesh] of the case with this echo differ from those of the result.
  bool is_on_another_mesh(const JsonTree& echo) const;
  int points_per_element() const;

  /// Model of the material of each point.
  std::vector<input::MaterialModel> list_models() const;
  /// Returns true if the roots of the result are those that `data` describes.
  bool has_roots_of(const input::Case& data) const;

  template <int D>
  mesh::Mesh<D> get_mesh() const;

  /// Moves the soil of `body`, filled on the mesh of this state, to its final position: stress, pore water, motion and
  /// strain are those of the result (state variables: see adopt_state()). Time is 0, displacements start from zero,
  /// and there are no losses. Water keeps its pressure if its material now stores it differently. The work done before
  /// remains in the body, as the rest criterion uses it. Throws Error (wrong_input) if only one of the two has pore
  /// water, or if no point is left.
  template <int D>
  void take_over(mpm::Body<D>& body) const;

  /// Lists the materials of `body` that store a different mass of water at some pressure than the soil of the result.
  template <int D>
  std::vector<std::string> list_refilled(const mpm::Body<D>& body) const;

 private:
  std::string result_;
  output::ArchiveReader archive_;
  JsonTree input_;
};

/// Writes the end of the stages of the case with this echo into `folder`. `mesh_input` is the echo of the case for
/// which the mesh was generated, which is another one if the case itself started from a result. `roots`: see
/// write_root_input().
template <int D>
void save_end_state(const std::filesystem::path& folder, const JsonTree& echo, const JsonTree& mesh_input,
                    const std::string& input_hash, const mpm::Body<D>& body, const std::string& roots = {});

}  // namespace talus::run
