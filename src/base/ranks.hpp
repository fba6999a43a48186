// SPDX-License-Identifier: MIT
#pragma once
// Processes that calculate one case together, started by mpiexec. The program itself knows no MPI: what sends and
// receives is a module of its own (src/ranks/), which is loaded where a run has more than one rank.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/message.hpp"

namespace talus {

/// An array of items, [item][stride].
struct HaloArray {
  double* data = nullptr;
  int stride = 1;
};

/// Items that other ranks own, brought up to date by theirs.
class Halo {
 public:
  virtual ~Halo() = default;
  /// All arrays at once: none waits for another's messages. Between begin() and end() what goes must stay, and what
  /// comes is not there.
  virtual void begin(std::vector<HaloArray> arrays) = 0;
  virtual void end() = 0;
  void update(std::vector<HaloArray> arrays) {
    begin(std::move(arrays));
    end();
  }
};

/// An item that another rank owns, under the number that it has on all ranks.
struct Guest {
  int item = 0;
  int rank = 0;
};

/// What a rank has sent, and the time that it spent with it.
struct Traffic {
  double bytes = 0;
  double seconds = 0;  ///< waiting for the others too
  int hand_overs = 0;  ///< of work to other ranks, because some had more of it; counted by those who do it
};

/// What goes between rank 0 and the others in pieces, so that no more than one is in memory beside what it is made of.
struct Pieces {
  int count = 0;
  std::function<int(int)> find_rank;  ///< of a piece
  std::function<Bytes(int)> make;
  std::function<void(int, Bytes)> take;
};

/// To be raised with the functions of Ranks, so that a module of another build is refused.
inline constexpr int ranks_interface = 1;

/// All calls but rank() and size() are made by all ranks in the same order.
class Ranks {
 public:
  virtual ~Ranks() = default;
  virtual int rank() const = 0;
  virtual int size() const = 0;
  /// The bytes of each rank: on all ranks, or on rank 0 alone (elsewhere empty).
  virtual std::vector<Bytes> gather(const Bytes& mine, bool to_all) = 0;
  /// Pieces that rank 0 makes, one after the other: take(piece, bytes) gets each on its rank.
  virtual void deal(const Pieces& pieces) = 0;
  /// Pieces that their ranks make: take(piece, bytes) gets all on rank 0, one after the other.
  virtual void collect(const Pieces& pieces) = 0;
  /// to[r] goes to rank r; returns what each has sent here.
  virtual std::vector<Bytes> exchange(const std::vector<Bytes>& to) = 0;
  /// Those of rank 0, on all ranks.
  virtual void broadcast(Bytes& bytes) = 0;
  /// `guests`: the items of an array of `items` that are needed here and belong to others.
  virtual std::unique_ptr<Halo> make_halo(int items, const std::vector<Guest>& guests) = 0;
  virtual Traffic& traffic() = 0;
  /// Those ranks that name the same group, in their order. Its traffic is counted here too.
  virtual std::unique_ptr<Ranks> split(int group) = 0;
  /// Waits for the others. False where not all came in `seconds`.
  virtual bool meet(double seconds) = 0;
  /// Ends all ranks at once.
  [[noreturn]] virtual void abort(int code) = 0;
};

/// The ranks of this process; one of its own where nobody started more.
Ranks& get_ranks();

/// How many processes mpiexec, or srun, has started together with this one: 1 where it is alone.
int count_started();

/// To be called first: finds out whether mpiexec, or srun, started this process beside others, and joins them. Throws
/// Error (wrong_input) where it did and this program was built without MPI.
void join_ranks();
/// Leaves the others; nothing is sent any more.
void leave_ranks();

/// While it lives, get_ranks() are those of one of `groups` groups of consecutive ranks.
class RankGroup {
 public:
  explicit RankGroup(int groups);
  ~RankGroup();
  RankGroup(const RankGroup&) = delete;
  RankGroup& operator=(const RankGroup&) = delete;
  int number() const { return number_; }

 private:
  int number_;
  std::unique_ptr<Ranks> all_;
};

/// What rank 0 has, on all ranks: all that a message can hold.
template <class T>
void broadcast(T& value) {
  Message message;
  if (get_ranks().rank() == 0) Putting{message}(value);
  Bytes bytes = message.take();
  get_ranks().broadcast(bytes);
  message = Message(std::move(bytes));
  Taking{message}(value);
}

/// Runs `work` on rank 0. The others wait until it is done, and throw an Error with the words of what it threw.
void lead_ranks(const std::function<void()>& work);

}  // namespace talus
