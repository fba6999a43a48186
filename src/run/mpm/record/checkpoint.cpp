// SPDX-License-Identifier: MIT
#include "run/mpm/record/checkpoint.hpp"

#include <fmt/format.h>

#include <sstream>

#include "base/error.hpp"

namespace talus::run {

std::unique_ptr<output::ArchiveReader> open_checkpoint(const std::filesystem::path& path,
                                                       const std::string& input_hash) {
  if (!std::filesystem::exists(path)) return nullptr;
  auto archive = std::make_unique<output::ArchiveReader>(path);
  if (archive->text("input_hash") != input_hash) {
    throw Error(ExitCode::wrong_input,
                fmt::format("'{}' belongs to another case: the input has changed since it was written; resume with the "
                            "same input, or start anew with --overwrite",
                            path.string()));
  }
  return archive;
}

int get_leg(const output::ArchiveReader& checkpoint) {
  return checkpoint.integers("leg").front();
}

void put_stage(output::ArchiveWriter& archive, const StageState& s) {
  const std::vector<double> reals{s.start_time,    s.dt,         s.gravity_share, s.calm_since, s.next_output,
                                  s.largest_speed, s.wave_speed, s.soft_band,     s.soft_size};
  archive.put("stage/reals", reals);
  const std::vector<std::int64_t> integers{s.started ? 1 : 0, s.steps};
  archive.put("stage/integers", integers);
  std::vector<double> setbacks;
  std::string texts;  // two lines per text
  for (const results::Retry& b : s.setbacks) {
    setbacks.insert(setbacks.end(), {b.time, b.back_to, b.courant});
    texts += b.smoothing + "\n" + b.reason + "\n";
  }
  archive.put("stage/setbacks", setbacks);
  archive.put("stage/setback_texts", texts);
}

StageState get_stage(const output::ArchiveReader& archive) {
  const auto& r = archive.reals("stage/reals");
  const auto& i = archive.long_integers("stage/integers");
  StageState state{i[0] != 0, r[0], i[1], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8], {}};
  if (!archive.has("stage/setbacks")) return state;
  const auto& setbacks = archive.reals("stage/setbacks");
  std::istringstream texts(archive.text("stage/setback_texts"));
  for (std::size_t k = 0; k + 3 <= setbacks.size(); k += 3) {
    results::Retry b{setbacks[k], setbacks[k + 1], setbacks[k + 2], {}, {}};
    std::getline(texts, b.smoothing);
    std::getline(texts, b.reason);
    state.setbacks.push_back(std::move(b));
  }
  return state;
}

}  // namespace talus::run
