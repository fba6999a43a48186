// SPDX-License-Identifier: MIT
#include "output/files/frames_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <set>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "base/foreign_code.hpp"
#include "output/files/frame.hpp"
#include "output/files/hdf5.hpp"
#include "output/files/results_folder.hpp"

namespace talus::output {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void throw_damaged(const fs::path& path, const std::string& what) {
  fail_input("cannot read '{}': the file is damaged or no file of this program ({})", path.string(), what);
}

/// Body of the child process. It needs no Guard, since the child is a copy of this process, which holds the Guard.
void look_at(const fs::path& path, Depth depth) {
  try {
    const hdf5::Handle file = hdf5::open(path);
    hdf5::look_at_all(file, static_cast<std::size_t>(fs::file_size(path)), depth == Depth::values);
  } catch (const hdf5::Failure& failure) {
    throw_damaged(path, failure.what());
  } catch (const std::bad_alloc&) {  // a damaged size
    throw_damaged(path, "it asks for more memory than there is");
  }
}

/// Returns a limit of processor time [s] that the examination of intact files does not reach. HDF5 loops endlessly in
/// some damaged files.
double find_longest_look(const std::vector<fs::path>& files) {
  double bytes = 0;
  for (const fs::path& path : files) bytes += static_cast<double>(fs::file_size(path));
  return 10 + bytes / 1e6;
}

void look_in_child(const std::vector<fs::path>& files, Depth depth) {
  const double longest = find_longest_look(files);
  do_in_child("the results were examined", [&](Message&) {
    limit_processor_time(longest);
    for (const fs::path& path : files) look_at(path, depth);
  });
}

}  // namespace

void examine(const std::vector<fs::path>& files, Depth depth) {
  std::vector<fs::path> there;
  for (const fs::path& path : files)
    if (fs::is_regular_file(path)) there.push_back(path);
  if (there.empty()) return;
  const hdf5::Guard guard;
  try {
    look_in_child(there, depth);
  } catch (const ChildCrash& first) {
    const auto refuse = [](const fs::path& path, const ChildCrash& crash) {
      throw_damaged(path, fmt::format("HDF5 cannot read it: {}", crash.what()));
    };
    if (there.size() == 1) refuse(there.front(), first);
    for (const fs::path& path : there) {
      try {
        look_in_child({path}, depth);
      } catch (const ChildCrash& crash) {
        refuse(path, crash);
      }
    }
  }
}

namespace {

/// Returns the files of a folder that contain frames.
std::vector<fs::path> list_files(const fs::path& folder) {
  std::vector<fs::path> files{results_file(folder), mesh_file(folder)};
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator(frames_folder(folder), none))
    if (find_frame_number(entry.path())) files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

bool has_single_frames(const Index& index) {
  for (const auto& [number, entry] : index.frames)
    if (!entry.assembled) return true;
  return false;
}

/// Removes the single frames, and their folder if it is then empty.
void remove_single_frames(const fs::path& folder) {
  std::set<int> numbers;  // the last one may be incomplete after a kill
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator(frames_folder(folder), none)) {
    const fs::path& path = entry.path();
    const bool is_part = temporary_name(path.parent_path() / path.stem()) == path;
    if (const auto number = find_frame_number(is_part ? path.stem() : path)) numbers.insert(*number);
  }
  for (const int number : numbers) remove_file(frame_file(folder, number));
  fs::remove(frames_folder(folder), none);
}

/// Assembles the results if any frame is not yet part of them, and removes the single frames.
void finish_folder(const fs::path& folder, const Index& index) {
  if (index.frames.empty()) fail_input("there are no frames of a run in '{}'", folder.string());
  if (has_single_frames(index)) assemble(folder, index);
  try {
    remove_single_frames(folder);
  } catch (const Error&) {  // the remaining files duplicate assembled frames, so readers are not affected
  }
}

/// Removes the frames after `time`, in order; a resumed run writes them again.
void drop_after(const fs::path& folder, double time, Index& index) {
  for (auto it = index.frames.begin(); it != index.frames.end();) {
    if (it->second.time <= time) {
      ++it;
      continue;
    }
    remove_file(frame_file(folder, it->first));
    it = index.frames.erase(it);
  }
  // After a kill during assembly, a frame may be both in the results and in a file of its own.
  bool shorten = false;
  for (const SeriesStep& step : index.points.steps) shorten = shorten || step.time > time;
  if (!shorten) return;
  if (index.frames.empty())
    remove_results(folder);
  else
    assemble(folder, index);
}

}  // namespace

ResultsWriter::ResultsWriter(fs::path folder, int next, int count)
    : folder_(std::move(folder)), next_(next), count_(count) {
  make_folder(frames_folder(folder_));
}

ResultsWriter ResultsWriter::start(const fs::path& folder) {
  for (const fs::path& file : list_files(folder))
    if (fs::exists(file))
      throw Error(ExitCode::folder_exists, "'{}' already holds results ('{}'); nothing was written", folder.string(),
                  file.lexically_relative(folder).string());
  return {folder, 0, 0};
}

ResultsWriter ResultsWriter::resume(const fs::path& folder, double time) {
  examine(list_files(folder), Depth::values);
  Index index = read_index(folder);
  drop_after(folder, time, index);
  return {folder, index.frames.empty() ? 0 : index.frames.rbegin()->first + 1, static_cast<int>(index.frames.size())};
}

void ResultsWriter::write(const Frame& frame) {
  const std::string safe = fmt::format("the {} frames written before are whole", count_);
  make_folder(frames_folder(folder_), safe);
  write_frame(frame_file(folder_, next_), frame, safe);
  ++next_;
  ++count_;
}

void ResultsWriter::finish() {
  finish_folder(folder_, read_index(folder_));
}

int collect(const fs::path& folder) {
  examine(list_files(folder));
  const Index index = read_index(folder);
  finish_folder(folder, index);
  return static_cast<int>(index.frames.size());
}

bool holds_frames(const fs::path& folder) {
  if (fs::exists(results_file(folder))) return true;
  std::error_code none;
  const fs::directory_iterator files(frames_folder(folder), none);
  return std::any_of(begin(files), end(files),
                     [](const auto& file) { return find_frame_number(file.path()).has_value(); });
}

void remove_results(const fs::path& folder) {
  for (const char* name : {"results.vtkhdf", "results.xdmf", "mesh.vtkhdf", "mesh.xdmf"}) remove_file(folder / name);
  remove_single_frames(folder);
}

struct ResultsReader::Content {
  fs::path folder;
  Index index;
  std::vector<int> numbers;
  std::vector<double> times;
  std::vector<long> steps;
  std::vector<std::string> stages;
};

ResultsReader::ResultsReader(const fs::path& folder) : content_(std::make_unique<Content>()) {
  Content& c = *content_;
  c.folder = folder;
  examine(list_files(folder));
  c.index = read_index(folder);
  if (c.index.frames.empty()) fail_input("there are no frames of a run in '{}'", folder.string());
  for (const auto& [number, entry] : c.index.frames) {
    c.numbers.push_back(number);
    c.times.push_back(entry.time);
    c.steps.push_back(entry.step);
    c.stages.push_back(entry.stage);
  }
}

ResultsReader::ResultsReader(ResultsReader&&) noexcept = default;
ResultsReader::~ResultsReader() = default;
int ResultsReader::size() const {
  return static_cast<int>(content_->numbers.size());
}
const std::vector<double>& ResultsReader::times() const {
  return content_->times;
}
const std::vector<long>& ResultsReader::steps() const {
  return content_->steps;
}
const std::vector<std::string>& ResultsReader::stages() const {
  return content_->stages;
}
const std::vector<std::string>& ResultsReader::field_names() const {
  return content_->index.field_names;
}

Frame ResultsReader::read(int index) const {
  if (index < 0 || index >= size())
    fail_input("there is no frame {} in '{}': they are counted from 0 to {}", index, content_->folder.string(),
               size() - 1);
  return read_entry(content_->folder, content_->index, content_->numbers[static_cast<std::size_t>(index)]);
}

int ResultsReader::find_nearest(double time) const {
  std::size_t best = 0;
  for (std::size_t i = 1; i < content_->times.size(); ++i)
    if (std::abs(content_->times[i] - time) <= std::abs(content_->times[best] - time)) best = i;
  return static_cast<int>(best);
}

}  // namespace talus::output
