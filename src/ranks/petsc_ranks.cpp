// SPDX-License-Identifier: MIT
// Ranks by MPI, and their halo exchanges by PETSc's star forests (PetscSF): the module libtalus_ranks.so.

#include <petscsf.h>
#include <petscsys.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <stdexcept>
#include <thread>

#include "base/ranks.hpp"

namespace talus {
namespace {

void check(PetscErrorCode code, const char* what) {
  if (code != 0) throw std::runtime_error(std::string("PETSc could not ") + what);
}

/// Adds the bytes sent, and the seconds of its own lifetime, to the traffic.
class Watch {
 public:
  Watch(Traffic& traffic, double bytes) : traffic_(traffic) { traffic.bytes += bytes; }
  ~Watch() { traffic_.seconds += std::chrono::duration<double>(Clock::now() - start_).count(); }
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

 private:
  using Clock = std::chrono::steady_clock;
  Traffic& traffic_;
  const Clock::time_point start_ = Clock::now();
};

class PetscHalo : public Halo {
 public:
  PetscHalo(MPI_Comm ranks, int items, const std::vector<Guest>& guests, Traffic& traffic)
      : traffic_(traffic), guests_(static_cast<double>(guests.size())) {
    check(PetscSFCreate(ranks, &forest_), "make a star forest");
    std::vector<PetscInt> leaves;
    std::vector<PetscSFNode> roots;
    for (const Guest& g : guests) {
      leaves.push_back(g.item);
      roots.push_back({g.rank, g.item});
    }
    check(PetscSFSetGraph(forest_, items, static_cast<PetscInt>(leaves.size()), leaves.data(), PETSC_COPY_VALUES,
                          roots.data(), PETSC_COPY_VALUES),
          "set a star forest's graph");
    check(PetscSFSetUp(forest_), "set a star forest up");
  }
  ~PetscHalo() override {
    for (auto& [stride, type] : types_) MPI_Type_free(&type);
    PetscSFDestroy(&forest_);
  }
  PetscHalo(const PetscHalo&) = delete;
  PetscHalo& operator=(const PetscHalo&) = delete;

  void begin(std::vector<HaloArray> arrays) override {
    under_way_ = std::move(arrays);
    double columns = 0;
    for (const HaloArray& a : under_way_) columns += a.stride;
    const Watch watch(traffic_, guests_ * columns * sizeof(double));  // over all ranks, as much is received as is sent
    // Roots and leaves are in one array and have no item in common.
    for (const auto& [data, stride] : under_way_)
      check(PetscSFBcastBegin(forest_, find_type(stride), data, data, MPI_REPLACE), "begin an exchange");
  }
  void end() override {
    const Watch watch(traffic_, 0);
    for (const auto& [data, stride] : under_way_)
      check(PetscSFBcastEnd(forest_, find_type(stride), data, data, MPI_REPLACE), "end an exchange");
  }

 private:
  MPI_Datatype find_type(int stride) {
    MPI_Datatype& type = types_[stride];
    if (type == MPI_Datatype()) {
      MPI_Type_contiguous(stride, MPI_DOUBLE, &type);
      MPI_Type_commit(&type);
    }
    return type;
  }

  Traffic& traffic_;
  double guests_;
  PetscSF forest_ = nullptr;
  std::map<int, MPI_Datatype> types_;
  std::vector<HaloArray> under_way_;
};

class PetscRanks : public Ranks {
 public:
  PetscRanks(MPI_Comm ranks, std::shared_ptr<Traffic> traffic) : ranks_(ranks), traffic_(std::move(traffic)) {
    MPI_Comm_rank(ranks_, &rank_);
    MPI_Comm_size(ranks_, &size_);
  }
  PetscRanks(const PetscRanks&) = delete;
  PetscRanks& operator=(const PetscRanks&) = delete;

  int rank() const override { return rank_; }
  int size() const override { return size_; }

  /// Short lists, which most are, take one message with their lengths; very long ones are sent rank by rank, because
  /// MPI counts in integers.
  std::vector<Bytes> gather(const Bytes& mine, bool to_all) override {
    const Watch watch(*traffic_, static_cast<double>(mine.size()));
    Envelope own{static_cast<std::int64_t>(mine.size()), {}};
    const bool receives = to_all || rank_ == 0;
    if (own.count <= Envelope::room) std::copy(mine.begin(), mine.end(), own.bytes.begin());
    std::vector<Envelope> envelopes(static_cast<std::size_t>(size_));
    MPI_Allgather(&own, sizeof(Envelope), MPI_BYTE, envelopes.data(), sizeof(Envelope), MPI_BYTE, ranks_);
    std::int64_t longest = 0, sum = 0;
    for (const Envelope& e : envelopes) {
      longest = std::max(longest, e.count);
      sum += e.count;
    }
    if (longest <= Envelope::room) {
      std::vector<Bytes> parts;
      for (const Envelope& e : envelopes) parts.emplace_back(e.bytes.begin(), e.bytes.begin() + e.count);
      return receives ? parts : std::vector<Bytes>();
    }
    return sum <= piece ? gather_at_once(mine, envelopes, to_all) : gather_in_turn(mine, envelopes, to_all);
  }

  void scatter(const Pieces& pieces) override {
    for (int i = 0; i < pieces.count; ++i) exchange(pieces, i, 0, pieces.find_rank(i));
  }
  void collect(const Pieces& pieces) override {
    for (int i = 0; i < pieces.count; ++i) exchange(pieces, i, pieces.find_rank(i), 0);
  }

  std::vector<Bytes> exchange(const std::vector<Bytes>& to) override {
    const std::size_t n = to.size();
    std::vector<int> sends(n), send_starts(n, 0), receives(n), receive_starts(n, 0);
    Bytes out;
    for (std::size_t r = 0; r < n; ++r) {
      sends[r] = static_cast<int>(to[r].size());
      send_starts[r] = static_cast<int>(out.size());
      out.insert(out.end(), to[r].begin(), to[r].end());
    }
    const Watch watch(*traffic_, static_cast<double>(out.size()));
    MPI_Alltoall(sends.data(), 1, MPI_INT, receives.data(), 1, MPI_INT, ranks_);
    for (std::size_t r = 1; r < n; ++r) receive_starts[r] = receive_starts[r - 1] + receives[r - 1];
    Bytes in(static_cast<std::size_t>(receive_starts.back() + receives.back()));
    MPI_Alltoallv(out.data(), sends.data(), send_starts.data(), MPI_BYTE, in.data(), receives.data(),
                  receive_starts.data(), MPI_BYTE, ranks_);
    return cut(in, receives);
  }

  void broadcast(Bytes& bytes) override {
    auto count = static_cast<std::int64_t>(bytes.size());
    MPI_Bcast(&count, 1, MPI_INT64_T, 0, ranks_);
    bytes.resize(static_cast<std::size_t>(count));
    send_pieces(bytes, 0);
  }

  std::unique_ptr<Halo> make_halo(int items, const std::vector<Guest>& guests) override {
    return std::make_unique<PetscHalo>(ranks_, items, guests, *traffic_);
  }
  Traffic& traffic() override { return *traffic_; }
  std::unique_ptr<Ranks> split(int group) override;

  bool meet(double seconds) override {
    MPI_Request request;
    MPI_Ibarrier(ranks_, &request);
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
    for (int done = 0; done == 0;) {
      MPI_Test(&request, &done, MPI_STATUS_IGNORE);
      if (done != 0) return true;
      if (std::chrono::steady_clock::now() > end) return false;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return true;
  }
  [[noreturn]] void abort(int code) override {
    MPI_Abort(MPI_COMM_WORLD, code);
    std::abort();
  }

 private:
  static std::vector<Bytes> cut(const Bytes& all, const std::vector<int>& counts) {
    std::vector<Bytes> parts;
    auto at = all.begin();
    for (const int count : counts) {
      parts.emplace_back(at, at + count);
      at += count;
    }
    return parts;
  }

  struct Envelope {
    static constexpr int room = 504;
    std::int64_t count;
    std::array<std::byte, room> bytes;
  };
  static constexpr std::int64_t piece = std::int64_t{1} << 28;  ///< largest message [bytes]

  std::vector<Bytes> gather_at_once(const Bytes& mine, const std::vector<Envelope>& envelopes, bool to_all) {
    std::vector<int> counts, starts{0};
    for (const Envelope& e : envelopes) {
      counts.push_back(static_cast<int>(e.count));
      starts.push_back(starts.back() + counts.back());
    }
    const bool receives = to_all || rank_ == 0;
    const auto count = static_cast<int>(mine.size());
    Bytes all(receives ? static_cast<std::size_t>(starts.back()) : 0);
    if (to_all)
      MPI_Allgatherv(mine.data(), count, MPI_BYTE, all.data(), counts.data(), starts.data(), MPI_BYTE, ranks_);
    else
      MPI_Gatherv(mine.data(), count, MPI_BYTE, all.data(), counts.data(), starts.data(), MPI_BYTE, 0, ranks_);
    return receives ? cut(all, counts) : std::vector<Bytes>();
  }

  std::vector<Bytes> gather_in_turn(const Bytes& mine, const std::vector<Envelope>& envelopes, bool to_all) {
    std::vector<Bytes> parts;
    for (int r = 0; r < size_; ++r) {
      Bytes part = r == rank_ ? mine : Bytes();
      if (to_all) part.resize(static_cast<std::size_t>(envelopes[static_cast<std::size_t>(r)].count));
      if (to_all)
        send_pieces(part, r);
      else if (r > 0 && rank_ == r)
        send(part, 0);
      else if (r > 0 && rank_ == 0)
        part = receive(r);
      if (to_all || rank_ == 0) parts.push_back(std::move(part));
    }
    return parts;
  }

  void exchange(const Pieces& pieces, int i, int from, int to) {
    if (rank_ != from && rank_ != to) return;
    Bytes bytes = rank_ == from ? pieces.make(i) : Bytes();
    if (from != to) {
      const Watch watch(*traffic_, static_cast<double>(bytes.size()));
      if (rank_ == from) return send(bytes, to);
      bytes = receive(from);
    }
    pieces.take(i, std::move(bytes));
  }

  /// Sends `bytes` of any length to one rank.
  void send(const Bytes& bytes, int rank) {
    const auto count = static_cast<std::int64_t>(bytes.size());
    MPI_Send(&count, 1, MPI_INT64_T, rank, 0, ranks_);
    visit_pieces(bytes, [&](const std::byte* data, int n) { MPI_Send(data, n, MPI_BYTE, rank, 0, ranks_); });
  }
  Bytes receive(int rank) {
    std::int64_t count = 0;
    MPI_Recv(&count, 1, MPI_INT64_T, rank, 0, ranks_, MPI_STATUS_IGNORE);
    Bytes bytes(static_cast<std::size_t>(count));
    visit_pieces(bytes,
                 [&](std::byte* data, int n) { MPI_Recv(data, n, MPI_BYTE, rank, 0, ranks_, MPI_STATUS_IGNORE); });
    return bytes;
  }

  template <class SomeBytes, class Visit>
  static void visit_pieces(SomeBytes& bytes, Visit&& visit) {
    for (std::size_t at = 0; at < bytes.size(); at += piece)
      visit(bytes.data() + at, static_cast<int>(std::min<std::size_t>(piece, bytes.size() - at)));
  }
  /// Broadcasts `bytes` of any length from rank `root`.
  void send_pieces(Bytes& bytes, int root) {
    visit_pieces(bytes, [&](std::byte* data, int count) { MPI_Bcast(data, count, MPI_BYTE, root, ranks_); });
  }

  MPI_Comm ranks_;
  int rank_ = 0, size_ = 1;
  std::shared_ptr<Traffic> traffic_;
};

/// All ranks of the process group. MPI and PETSc are initialised and finalised with this object.
class AllRanks : public PetscRanks {
 public:
  AllRanks() : PetscRanks(start(), std::make_shared<Traffic>()) {}
  ~AllRanks() override { PetscFinalize(); }
  AllRanks(const AllRanks&) = delete;
  AllRanks& operator=(const AllRanks&) = delete;

 private:
  static MPI_Comm start() {
    // The program handles signals itself: Ctrl-C saves a checkpoint.
    check(PetscInitializeNoArguments(), "start");
    check(PetscPopSignalHandler(), "leave signals alone");
    return PETSC_COMM_WORLD;
  }
};

class SomeRanks : public PetscRanks {
 public:
  SomeRanks(MPI_Comm ranks, std::shared_ptr<Traffic> traffic) : PetscRanks(ranks, std::move(traffic)), own_(ranks) {}
  ~SomeRanks() override { MPI_Comm_free(&own_); }
  SomeRanks(const SomeRanks&) = delete;
  SomeRanks& operator=(const SomeRanks&) = delete;

 private:
  MPI_Comm own_;
};

std::unique_ptr<Ranks> PetscRanks::split(int group) {
  MPI_Comm some;
  MPI_Comm_split(ranks_, group, rank_, &some);
  return std::make_unique<SomeRanks>(some, traffic_);
}

}  // namespace
}  // namespace talus

/// Returns nullptr if the program was built with another version of the interface.
extern "C" talus::Ranks* talus_make_ranks(int interface) {
  return interface == talus::ranks_interface ? new talus::AllRanks : nullptr;
}
