// SPDX-License-Identifier: MIT
#pragma once
// The state at the end of the stages of a run, kept in its folder, and how another case starts from it.

#include <filesystem>
#include <string>
#include <vector>

#include "base/json_tree.hpp"
#include "input/case/case.hpp"
#include "mpm/body/body.hpp"
#include "output/files/archive.hpp"
#include "results/run.hpp"

namespace talus::run {

/// The file in a folder of results.
inline constexpr const char* end_state_file = "end_state.h5";

/// The end of the stages of a result, as the start of another case: [initial] result.
class EndState {
 public:
  /// Throws Error (wrong_input) when the file is not there, is damaged, or was written by a build with another lane
  /// width.
  explicit EndState(const input::Initial& initial);

  /// Echo of the case that ended so; its geometry and mesh are those that the points are on.
  const JsonTree& input() const { return input_; }
  /// Hash of the mesh's points and all that they carry.
  const std::string& hash() const { return archive_.text("state_hash"); }
  /// Where a run started from, for its summary.
  results::Origin tell() const;
  /// Whether [geometry] or [mesh] of the case with this echo say something else than those of the result.
  bool is_on_another_mesh(const JsonTree& echo) const;
  int points_per_element() const;

  /// The model of each point's material.
  std::vector<input::MaterialModel> list_models() const;
  /// Whether the roots of the result are those that `data` describes.
  bool has_roots_of(const input::Case& data) const;

  template <int D>
  mesh::Mesh<D> get_mesh() const;

  /// Moves the soil of `body`, filled on the mesh of this state, to where it ended: its stress, pore water, motion and
  /// strain are those of the result (state variables: see adopt_state()); time is 0, displacements count from here,
  /// nothing was lost. Water keeps its pressure where its material stores it differently now. The work done before
  /// stays in the body, as rest is judged by it. Throws Error (wrong_input) when one has pore water and the other has
  /// none, or no point is left.
  template <int D>
  void take_over(mpm::Body<D>& body) const;

  /// Materials of `body` that hold another mass of water at some pressure than the soil of the result did.
  template <int D>
  std::vector<std::string> list_refilled(const mpm::Body<D>& body) const;

 private:
  std::string result_;
  output::ArchiveReader archive_;
  JsonTree input_;
};

/// Writes the end of the stages of the case with this echo into `folder`. `mesh_input` is the echo of the case that the
/// mesh was made for: another one where the case itself started from a result. `roots`: write_root_input().
template <int D>
void save_end_state(const std::filesystem::path& folder, const JsonTree& echo, const JsonTree& mesh_input,
                    const std::string& input_hash, const mpm::Body<D>& body, const std::string& roots = {});

}  // namespace talus::run
