// SPDX-License-Identifier: MIT
#include "base/ranks.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <utility>

#include "base/aligned.hpp"
#include "base/error.hpp"
#include "base/foreign_code.hpp"

namespace talus {
namespace {

/// A single process.
class OneRank : public Ranks {
 public:
  int rank() const override { return 0; }
  int size() const override { return 1; }
  std::vector<Bytes> gather(const Bytes& mine, bool) override { return {mine}; }
  void scatter(const Pieces& pieces) override { exchange(pieces); }
  void collect(const Pieces& pieces) override { exchange(pieces); }
  std::vector<Bytes> exchange(const std::vector<Bytes>& to) override { return to; }
  void broadcast(Bytes&) override {}
  std::unique_ptr<Halo> make_halo(int, const std::vector<Guest>&) override {
    struct None : Halo {
      void begin(std::vector<HaloArray>) override {}
      void end() override {}
    };
    return std::make_unique<None>();
  }
  Traffic& traffic() override { return none_; }
  std::unique_ptr<Ranks> split(int) override { return std::make_unique<OneRank>(); }
  bool meet(double) override { return true; }
  [[noreturn]] void abort(int code) override { std::_Exit(code); }

 private:
  static void exchange(const Pieces& pieces) {
    for (int i = 0; i < pieces.count; ++i) pieces.take(i, pieces.make(i));
  }

  Traffic none_;
};

std::unique_ptr<Ranks>& current() {
  static std::unique_ptr<Ranks> ranks = std::make_unique<OneRank>();
  return ranks;
}

}  // namespace

Ranks& get_ranks() {
  return *current();
}

int count_started() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_SIZE", "SLURM_STEP_NUM_TASKS"})
    if (const char* text = std::getenv(name)) return std::atoi(text);
  return 1;
}

void join_ranks() {
  const int count = count_started();
  if (count <= 1) return;
  avoid_huge_pages();
  std::string why;
  // Plugins that MPI loads need its symbols, so the module is loaded with global symbols.
  void* maker = load_module("libtalus_ranks.so", "talus_make_ranks", true, why);
  if (maker == nullptr)
    fail_input(
        "this run was started on {} ranks, and this program was built without MPI: build it with -DTALUS_MPI=ON, or "
        "start it alone ({})",
        count, why);
  current().reset(reinterpret_cast<Ranks* (*)(int)>(maker)(ranks_interface));
  if (!current()) fail_input("libtalus_ranks.so is of another build than the program");
}

RankGroup::RankGroup(int groups) : number_(get_ranks().rank() * groups / get_ranks().size()) {
  all_ = std::exchange(current(), get_ranks().split(number_));
}
RankGroup::~RankGroup() {
  current() = std::move(all_);
}

void lead_ranks(const std::function<void()>& work) {
  Ranks& ranks = get_ranks();
  if (ranks.size() == 1) return work();
  Message outcome;
  if (ranks.rank() == 0) {
    Failure failure{ExitCode::success, ""};
    try {
      work();
    } catch (...) {
      failure = explain_failure(std::current_exception());
    }
    outcome.put(failure.code);
    outcome.put_list(std::vector<char>(failure.sentence.begin(), failure.sentence.end()));
  }
  Bytes bytes = outcome.bytes();
  ranks.broadcast(bytes);
  Message result(std::move(bytes));
  const auto code = result.get<ExitCode>();
  const std::vector<char> sentence = result.get_list<char>();
  if (code != ExitCode::success) throw Error(code, std::string(sentence.begin(), sentence.end()));
}

void leave_ranks() {
  current() = std::make_unique<OneRank>();
}

}  // namespace talus
