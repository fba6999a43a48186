// SPDX-License-Identifier: MIT
#pragma once
// The parts of a report's document: title block, tables, timeline, element tests, methods, water states and studies.
// web/src/contract/ describes them.

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "base/json_tree.hpp"
#include "report/folder/result_folder.hpp"
#include "report/pack/pack.hpp"
#include "results/runout.hpp"
#include "results/sampling.hpp"

namespace talus::report {

/// Returns true if all points of MPM left the grid.
bool has_lost_all(const results::RunResult& run);

// Title block, provenance, timing, the stored frames selected on the clock of the case ([output] count_from), and the
// results by name.

/// Returns the indices of the shown frames. `times` [s] are ascending and on the clock of the run. The frames are those
/// nearest to the requested times (the later of two at the same time), or five equally spaced ones from the start of
/// the clock.
std::vector<std::size_t> choose_shown(const std::vector<double>& times, const results::Clock& clock);

/// Returns `ShownResult[]` of web/src/contract/. Runout results are omitted if all soil left the grid, since they are
/// zero.
nlohmann::json list_named_results(const ResultFolder& folder);

// Histories, monitors, sections and ground profiles in a report (`Table`, `Section`, `MonitorPaths` in
// web/src/contract/).

/// Returns `Section[]` of web/src/contract/ from sections/*.csv at the shown times; empty if there are none. A table
/// that cannot be read adds a warning.
nlohmann::json make_sections(const ResultFolder& folder, nlohmann::json& warnings);

/// Returns `MonitorPaths`, the displacement of the monitors from the start of the clock; null if there are none.
nlohmann::json make_paths(const ResultFolder& folder, nlohmann::json& warnings);

/// Returns the tables of the stages, then of the trials with runout. Longer files are thinned to about `most_rows`
/// equally spaced rows with the first and the last, which the title states. A file that cannot be read adds a warning.
nlohmann::json make_tables(const ResultFolder& folder, nlohmann::json& warnings);

inline constexpr std::size_t most_rows = 1000;

// The factor of safety over time in a report (`Timeline` in web/src/contract/).

/// Returns null for a run without a timeline. Fields that cannot be drawn add a warning.
nlohmann::json make_timeline(const ResultFolder& folder, Packer& packer, nlohmann::json& warnings);

// Element tests and calibration of a results folder in its report.

/// Adds a calibration to the document of a report: its warnings, and its answer before that of the element
/// tests. Does nothing if the folder contains no calibration.
void add_calibration(const ResultFolder& folder, nlohmann::json& document);

/// Returns the columns of each test that its diagrams need, `ReportDocument.point_columns` of web/src/contract/. Throws
/// Error (wrong_input) if a table is missing or damaged.
nlohmann::json read_point_columns(const ResultFolder& folder);

/// Returns the sentences of the answer on the element tests.
std::vector<std::string> format_point_tests(const ResultFolder& folder);

/// Returns the assumptions of the element tests as sentences.
std::vector<std::string> list_point_assumptions();

// Arrays of LEM, FEM and limit analysis in a report: trial circles, the fields at failure, the fields of limit
// analysis.

/// Return what the report adds to the results of a method: `Slices`, `ElementsDrawn` and `BoundsDrawn` of
/// web/src/contract/; null without the method, and where there is nothing to draw. Files that cannot be read are
/// omitted with a warning.
nlohmann::json pack_slices(const ResultFolder& folder, Packer& packer, nlohmann::json& warnings);
nlohmann::json pack_finite_elements(const ResultFolder& folder, Packer& packer, nlohmann::json& warnings);
nlohmann::json pack_proven_bounds(const ResultFolder& folder, Packer& packer, nlohmann::json& warnings);
/// Packs mesh and fields of the stages of construction, `StagesDrawn`; null without stages, in 3D and of large meshes.
nlohmann::json pack_stages(const ResultFolder& folder, Packer& packer, nlohmann::json& warnings);
/// Packs the strength reduction in progress, `ReductionSoFar`; returns null without one.
nlohmann::json pack_reduction(const ResultFolder& folder, Packer& packer);

// States of the pore water up to the initial state of the methods (`WaterShown` in web/src/contract/): titles and
// fields.

/// Returns the states of a run in order of time. Without a run, as in a study by LEM alone, it is the water table of
/// the case.
std::vector<results::WaterState> find_water_states(const ResultFolder& folder);

/// Returns a title such as "steady seepage" or "1.5 days before the start".
std::string name_water_state(const results::WaterState& state, bool is_last);

/// Returns a duration such as "3 days", "12 hours" or "40 s".
std::string show_duration(double seconds);

/// Returns `Model.water` without fields.
nlohmann::json list_water_states(const ResultFolder& folder);

/// Packs the mesh of a file of fields as `WaterMesh` of the contract; `name` is the prefix of its arrays. Throws Error
/// (wrong_input) for an invalid node number.
nlohmann::json pack_water_mesh(const results::WaterFields& file, const std::string& name, Packer& packer);
/// Packs the fields of a state; returns null if the file has none, or none that match its mesh.
nlohmann::json pack_water_field(const results::WaterFields& file, const results::WaterState& state,
                                const std::string& name, Packer& packer);

/// Adds the fields of the states and `water_mesh` to the model if the folder contains them. Files that cannot be read
/// are omitted with a warning.
void add_water_fields(const ResultFolder& folder, nlohmann::json& document, Packer& packer);

// A study in a report: table, curves and status of its variants, frames of the variants for comparison, and the
// statistics of samples.

/// Adds the sentences of the answer on the samples, the most important first.
void format_sampling(const results::Sampling& sampling, const ShownUnit& length, std::vector<std::string>& sentences);

/// A variant with stored frames.
struct PictureSource {
  std::string title;
  ResultFolder folder;
};

/// The packed frames of a variant, and its `StudyRow.frames`.
struct Pictures {
  JsonTree sequence, frames;
};

/// Packs the frames of the variants for pictures side by side: displacement, strain, pore water and preconsolidation at
/// the shown times and at some times between them. The list has one entry per source in their order; both members are
/// empty if the source has no clock or no frames. Only the first variants of a large study are included.
std::vector<Pictures> pack_pictures(const std::vector<PictureSource>& sources, Packer& packer);

struct StudyContent {
  ResultFolder first;  ///< first variant with a summary; its model and input represent all variants
  results::Status status = results::Status::unfinished;  ///< finished if all variants are
  std::vector<std::string> sentences, warnings;
  double wall = 0, cpu = 0;         ///< sum over all variants [s]
  JsonTree table;                   ///< `Study` of web/src/contract/
  std::vector<JsonTree> sequences;  ///< frames of the variants
};

/// Reads study.json and the summaries of the variants; missing summaries are skipped.
StudyContent read_study(const ResultFolder& folder, Packer& packer);

}  // namespace talus::report
