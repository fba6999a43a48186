// SPDX-License-Identifier: MIT
#include "run/mpm/reduction/side_by_side.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "base/file_name.hpp"
#include "base/parallel.hpp"
#include "base/ranks.hpp"
#include "base/user_file.hpp"
#include "results/json.hpp"

namespace talus::run {
namespace {

namespace fs = std::filesystem;

/// The files of a folder, by their paths in it.
void put_files(Message& message, const fs::path& folder) {
  std::vector<fs::path> files;
  if (!folder.empty() && fs::exists(folder))
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      if (entry.is_regular_file()) files.push_back(entry.path());
  message.put(files.size());
  for (const fs::path& file : files) {
    message.put_text(fs::relative(file, folder).string());
    message.put_text(read_user_file(file, largest_file::any));
  }
}
void get_files(Message& message, const fs::path& folder) {
  for (auto left = message.get<std::size_t>(); left > 0; --left) {
    const fs::path file = join_path(folder, message.get_text());
    make_folder(file.parent_path());
    write_atomically(file, message.get_text());
  }
}

/// What one group has of its trials: outcomes and files of those that ended, and why there are no more.
struct GroupWork {
  int done = 0;
  Failure failure{ExitCode::success, ""};
  Message outcomes, files;
};

GroupWork run_group(int first, int stride, int count, const std::function<results::TrialOutcome(int)>& work,
                    const std::function<fs::path(int)>& folder) {
  GroupWork mine;
  const bool leads = get_ranks().rank() == 0;
  try {
    for (int i = first; i < count; i += stride) {
      const results::TrialOutcome outcome = work(i);
      if (!leads) continue;
      mine.outcomes.put_text(results::to_json(outcome).dump());
      put_files(mine.files, folder ? folder(i) : fs::path());
      ++mine.done;
    }
  } catch (...) {
    mine.failure = explain_failure(std::current_exception());
  }
  return mine;
}

}  // namespace

int count_parallel_trials(int points, int threads) {
  constexpr int points_worth_threads = 200000;
  return points < points_worth_threads ? std::max(threads, get_ranks().size()) : 1;
}

std::vector<results::TrialOutcome> run_side_by_side(int count, int side_by_side,
                                                    const std::function<results::TrialOutcome(int)>& work,
                                                    const std::function<fs::path(int)>& folder) {
  std::vector<results::TrialOutcome> found(static_cast<std::size_t>(count));
  Ranks& ranks = get_ranks();
  const int groups = std::min({count, side_by_side, ranks.size()});
  if (groups <= 1 || ranks.size() == 1) {
    parallel_tasks(count, ranks.size() == 1 ? side_by_side : 1,
                   [&](int i) { found[static_cast<std::size_t>(i)] = work(i); });
    return found;
  }
  GroupWork mine;
  bool leads = false;
  {
    const RankGroup group(groups);
    leads = get_ranks().rank() == 0;
    mine = run_group(group.number(), groups, count, work, folder);
  }
  Message result;
  result.put(mine.done);
  result.put(leads);
  result.put(mine.failure.code);
  result.put_text(mine.failure.sentence);
  result.put(mine.outcomes.bytes().data(), mine.outcomes.bytes().size());
  std::vector<Bytes> all = ranks.gather(result.bytes(), true), files = ranks.gather(mine.files.bytes(), false);
  int number = 0;
  Failure first{ExitCode::success, ""};
  for (std::size_t r = 0; r < all.size(); ++r) {
    Message message(std::move(all[r]));
    const int done = message.get<int>();
    const bool of_leader = message.get<bool>();
    const Failure failure{message.get<ExitCode>(), message.get_text()};
    if (first.code == ExitCode::success) first = failure;
    if (!of_leader) continue;
    Message of_group = files.empty() ? Message() : Message(std::move(files[r]));
    for (int i = number; i < number + done * groups; i += groups) {
      found[static_cast<std::size_t>(i)] =
          results::from_json<results::TrialOutcome>(nlohmann::json::parse(message.get_text()), "a trial's outcome");
      if (ranks.rank() == 0 && r > 0 && folder) get_files(of_group, folder(i));
    }
    ++number;
  }
  if (first.code != ExitCode::success) throw Error(first.code, first.sentence);  // files of those that ended are kept
  return found;
}

}  // namespace talus::run
