// SPDX-License-Identifier: MIT
#include "studio/run_progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "base/error.hpp"
#include "output/files/frame.hpp"
#include "output/files/frames_reader.hpp"
#include "studio/process.hpp"

namespace talus::studio {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::size_t most_points = 4000;  ///< of a frame in the page

/// Returns the frame that was written last in the folder of a run or of one of its trials.
fs::path find_newest_frame(const fs::path& results, fs::file_time_type& written) {
  fs::path newest;
  written = fs::file_time_type::min();
  const auto look = [&](const fs::path& folder) {
    std::error_code failure;
    for (const auto& entry : fs::directory_iterator(folder / "frames", failure)) {
      std::error_code fault;
      const fs::path& file = entry.path();
      if (file.extension() != ".h5" || !entry.is_regular_file(fault) || entry.is_symlink(fault)) continue;
      const fs::file_time_type time = entry.last_write_time(fault);
      if (fault || time < written || (time == written && file < newest)) continue;
      written = time;
      newest = file;
    }
  };
  look(results);
  std::error_code failure;
  for (const auto& trial : fs::directory_iterator(results / "trials", failure))
    if (trial.is_directory(failure) && !trial.is_symlink(failure)) look(trial.path());
  return newest;
}

/// Millimetres are enough for a picture.
double round_length(double metres) {
  constexpr double parts = 1000;
  return std::round(metres * parts) / parts;
}

json write_frame(const output::Frame& frame) {
  constexpr std::size_t dimensions = 3;
  const std::size_t count = frame.positions.size() / dimensions, step = count / most_points + 1;
  const output::Field* moved = output::find(frame.point_fields, "displacement");
  json x = json::array(), y = json::array(), displacement = json::array();
  for (std::size_t i = 0; i < count; i += step) {
    x.push_back(round_length(frame.positions[dimensions * i]));
    y.push_back(round_length(frame.positions[dimensions * i + 1]));
    if (moved == nullptr || moved->components != static_cast<int>(dimensions)) continue;
    const double* u = &moved->values[dimensions * i];
    displacement.push_back(round_length(std::hypot(u[0], u[1], u[2])));
  }
  return {{"time", frame.time}, {"stage", frame.stage}, {"count", count},
          {"x", std::move(x)},  {"y", std::move(y)},    {"displacement", std::move(displacement)}};
}

}  // namespace

json read_progress(const std::string& line) {
  if (!line.starts_with('{')) return {};
  json values = json::parse(line, nullptr, false);
  if (!values.is_object() || !values.contains("line")) return {};
  const auto number = [](const json& object, const char* key) {
    const auto found = object.find(key);
    return found != object.end() && found->is_number() ? found->get<double>() : 0;
  };
  if (number(values, "duration") > 0)
    values["fraction"] = std::clamp(number(values, "time") / number(values, "duration"), 0.0, 1.0);
  if (const auto found = values.find("values"); found != values.end() && number(*found, "total") > 0)
    values["fraction"] = std::clamp(number(*found, "done") / number(*found, "total"), 0.0, 1.0);
  return values;
}

std::string find_last_sentence(const fs::path& log) {
  constexpr std::streamoff most = 8192;
  constexpr std::size_t longest = 1000;
  const std::vector<std::string> lines = split_lines(read_tail(log, most));
  for (std::size_t i = lines.size(); i-- > 0;)
    if (!lines[i].empty() && read_progress(lines[i]).is_null()) return lines[i].substr(0, longest);
  return "";
}

json find_last_progress(const fs::path& log) {
  constexpr std::streamoff most = 65536;  // a line may have a slip surface
  const std::vector<std::string> lines = split_lines(read_tail(log, most));
  for (std::size_t i = lines.size(); i-- > 0;)
    if (json progress = read_progress(lines[i]); !progress.is_null()) return progress;
  return {};
}

void add_event(std::string& piece, const char* event, const json& data) {
  piece += fmt::format("event: {}\ndata: {}\n\n", event, data.dump(-1, ' ', false, json::error_handler_t::replace));
}

void RunFollower::add_news(std::string& piece) {
  add_lines(piece);
  const auto now = std::chrono::steady_clock::now();
  if (now < next_look_) return;
  constexpr std::chrono::seconds interval{1};
  next_look_ = now + interval;
  try {
    add_frame(piece);
  } catch (const Error&) {
    return;  // a frame that is removed or damaged; a later one follows
  }
}

void RunFollower::add_lines(std::string& piece) {
  constexpr std::streamoff most = 4'000'000;
  const std::string text = rest_ + read_news(log_, most, at_);
  const std::size_t end = text.rfind('\n');
  rest_ = end == std::string::npos ? text : text.substr(end + 1);
  if (end == std::string::npos) return;
  json last;
  for (const std::string& line : split_lines(text.substr(0, end))) {
    json progress = read_progress(line);
    if (progress.is_null()) continue;
    const auto values = progress.find("values");
    if (values != progress.end() &&
        (values->contains("factor") || values->contains("lower") || values->contains("upper")))
      add_event(piece, "value", *values);
    last = std::move(progress);
  }
  if (!last.is_null()) add_event(piece, "progress", last);
}

void RunFollower::add_frame(std::string& piece) {
  fs::file_time_type written;
  const fs::path newest = find_newest_frame(results_, written);
  if (newest.empty() || (newest == frame_ && written == frame_written_)) return;
  frame_ = newest;
  frame_written_ = written;
  output::examine({newest}, output::Depth::values);
  add_event(piece, "frame", write_frame(output::read_frame(newest)));
}

}  // namespace talus::studio
