// SPDX-License-Identifier: MIT
#pragma once
// Where a number comes from: title block, program, machine, units of display, seconds.

#include <optional>
#include <string>
#include <vector>

#include "results/about.hpp"

namespace talus::results {

/// The title block of a report.
struct Project {
  std::string title, project, client, author, checked_by, revision, notes;
};
template <class V, As<Project> R>
void describe(V& v, R& r) {
  v.key("title", r.title, {"", "title of the case"});
  v.key("project", r.project, {"", "project"});
  v.key("client", r.client, {"", "client"});
  v.key("author", r.author, {"", "author"});
  v.key("checked_by", r.checked_by, {"", "checked by"});
  v.key("revision", r.revision, {"", "revision"});
  v.key("notes", r.notes, {"", "notes"});
}

/// Program, build, machine and input.
struct Provenance {
  std::string program, version, commit, compiler, build_type, architecture, level, machine, started, case_file,
      input_hash;
  int lane_width = 0, threads = 0;
  std::string device;  ///< that took the points through their steps; empty: the processor did
};
template <class V, As<Provenance> R>
void describe(V& v, R& r) {
  v.key("program", r.program, {"", "program"});
  v.key("version", r.version, {"", "version"});
  v.key("commit", r.commit, {"", "commit"});
  v.key("compiler", r.compiler, {"", "compiler"});
  v.key("build_type", r.build_type, {"", "kind of build"});
  v.key("architecture", r.architecture, {"", "instruction set, as the compiler was told it"});
  v.key("level", r.level, {"", "level of the instruction set: equal bits of packages where it is equal"});
  v.key("lane_width", r.lane_width, {"", "doubles in a pack"});
  v.key("machine", r.machine, {"", "machine"});
  v.key("threads", r.threads, {"", "threads"});
  v.key("device", r.device, {"", "the device that took the points through their steps; empty: the processor did"});
  v.key("started", r.started, {"", "when the run began, UTC"});
  v.key("case_file", r.case_file, {"", "case file"});
  v.key("input_hash", r.input_hash, {"", "hash of what the results depend on"});
}

/// The units that reports show lengths, displacements and stresses in.
struct DisplayUnits {
  std::string length = "m", displacement = "mm", stress = "kPa";
};
template <class V, As<DisplayUnits> R>
void describe(V& v, R& r) {
  v.key("length", r.length, {"", "unit of lengths"});
  v.key("displacement", r.displacement, {"", "unit of displacements"});
  v.key("stress", r.stress, {"", "unit of stresses"});
}

/// How a run went.
enum class Status { unfinished, finished, interrupted, unstable, failed };
template <>
inline constexpr auto words<Status> = std::array{
    Word{Status::unfinished, "unfinished"}, Word{Status::finished, "finished"},
    Word{Status::interrupted, "interrupted"}, Word{Status::unstable, "unstable"}, Word{Status::failed, "failed"}};

/// Seconds of a part of the calculation, of all threads.
struct TimedPart {
  std::string name, title;
  double seconds = 0;
};
template <class V, As<TimedPart> R>
void describe(V& v, R& r) {
  v.key("name", r.name, {"", "part"});
  v.key("title", r.title, {"", "what it does"});
  v.key("seconds", r.seconds, {"s", "seconds of all threads"});
}

/// Seconds of the parts of the step.
struct StepSeconds {
  double solve_momentum = 0, remap_momentum = 0, smooth_strain = 0, advance_points = 0, relocate = 0;
};
template <class V, As<StepSeconds> R>
void describe(V& v, R& r) {
  v.key("solve_momentum", r.solve_momentum, {"s", "momentum balance at the nodes"});
  v.key("remap_momentum", r.remap_momentum, {"s", "remapping of the momentum"});
  v.key("smooth_strain", r.smooth_strain, {"s", "smoothing of the strain"});
  v.key("advance_points", r.advance_points, {"s", "material points: motion, strain, stress"});
  v.key("relocate", r.relocate, {"s", "points that changed their element"});
}

struct Timing {
  double wall = 0;            ///< [s]
  std::optional<double> cpu;  ///< of all threads [s]
  std::optional<StepSeconds> stage_steps;
  std::optional<std::vector<TimedPart>> parts;
};
template <class V, As<Timing> R>
void describe(V& v, R& r) {
  v.key("wall", r.wall, {"s", "wall time"});
  v.maybe("cpu", r.cpu, {"s", "processor time"});
  v.maybe("stage_steps", r.stage_steps, {"", "seconds of the stages by part of the step"});
  v.maybe("parts", r.parts, {"", "seconds by part"});
}

}  // namespace talus::results
