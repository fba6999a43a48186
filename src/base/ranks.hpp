// SPDX-License-Identifier: MIT
#pragma once
// Interface to the ranks (MPI processes) that calculate one case together. The program itself does not link MPI:
// communication is in a module (src/ranks/) that is loaded if a run has more than one rank.

#include <functional>
#include <memory>
#include <vector>

#include "base/message.hpp"

namespace talus {

/// An array of items, [item][stride].
struct HaloArray {
  double* data = nullptr;
  int stride = 1;
};

/// Halo exchange: updates copies of items from the ranks that own them.
class Halo {
 public:
  virtual ~Halo() = default;
  /// Starts the exchange of all arrays together. Until end(), data to send must not change and data to receive are not
  /// valid.
  virtual void begin(std::vector<HaloArray> arrays) = 0;
  virtual void end() = 0;
  void update(std::vector<HaloArray> arrays) {
    begin(std::move(arrays));
    end();
  }
};

/// A halo item: its index on this and all ranks, and the rank that owns it.
struct Guest {
  int item = 0;
  int rank = 0;
};

/// Bytes sent by a rank, and the time spent in communication.
struct Traffic {
  double bytes = 0;
  double seconds = 0;  ///< including waiting for other ranks
  int hand_overs = 0;  ///< number of rebalances of work between ranks, counted on the sending rank
};

/// Data sent between rank 0 and the other ranks in pieces, to limit the memory to one piece beside the source.
struct Pieces {
  int count = 0;
  std::function<int(int)> find_rank;  ///< rank of a piece
  std::function<Bytes(int)> make;
  std::function<void(int, Bytes)> take;
};

/// Must be increased when the functions of Ranks change, so that a module of another build is rejected.
inline constexpr int ranks_interface = 1;

/// Collective operations: all calls but rank() and size() must be made by all ranks in the same order.
class Ranks {
 public:
  virtual ~Ranks() = default;
  virtual int rank() const = 0;
  virtual int size() const = 0;
  /// Gathers the bytes of each rank, on all ranks or on rank 0 only (empty elsewhere).
  virtual std::vector<Bytes> gather(const Bytes& mine, bool to_all) = 0;
  /// Scatters pieces from rank 0 one after the other; take(piece, bytes) is called on the rank of each.
  virtual void scatter(const Pieces& pieces) = 0;
  /// Gathers pieces on rank 0 one after the other; take(piece, bytes) is called there for each.
  virtual void collect(const Pieces& pieces) = 0;
  /// Sends to[r] to each rank r; returns the bytes from each rank.
  virtual std::vector<Bytes> exchange(const std::vector<Bytes>& to) = 0;
  /// Copies the bytes of rank 0 to all ranks.
  virtual void broadcast(Bytes& bytes) = 0;
  /// `guests` lists the items of an array of `items` that are needed here and owned by other ranks.
  virtual std::unique_ptr<Halo> make_halo(int items, const std::vector<Guest>& guests) = 0;
  virtual Traffic& traffic() = 0;
  /// Returns a communicator of the ranks with the same `group`, in their order. Its traffic is also counted here.
  virtual std::unique_ptr<Ranks> split(int group) = 0;
  /// Barrier with a time limit; returns false if not all ranks arrived within `seconds`.
  virtual bool meet(double seconds) = 0;
  /// Terminates all ranks at once.
  [[noreturn]] virtual void abort(int code) = 0;
};

/// Returns the ranks of this run; a single rank if mpiexec did not start more.
Ranks& get_ranks();

/// Returns the number of processes that mpiexec or srun started together with this one; 1 for a single process.
int count_started();

/// Initialises MPI if mpiexec or srun started more than one process; must be called first. Throws Error (wrong_input)
/// in that case if this program was built without MPI.
void join_ranks();
/// Finalises MPI; no communication may follow.
void leave_ranks();

/// Restricts get_ranks() to one of `groups` groups of consecutive ranks, for the lifetime of the object.
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

/// Copies a value of rank 0 to all ranks, for all types that a Message supports.
void broadcast(auto& value) {
  Message message;
  if (get_ranks().rank() == 0) Putting{message}(value);
  Bytes bytes = message.take();
  get_ranks().broadcast(bytes);
  message = Message(std::move(bytes));
  Taking{message}(value);
}

/// Runs `work` on rank 0. The other ranks wait for its end; if it throws, they throw an Error with the same message.
void lead_ranks(const std::function<void()>& work);

}  // namespace talus
