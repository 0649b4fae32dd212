#include "runtime/workers/mpi_link.h"

#include <mpi.h>

#include <cassert>
#include <limits>
#include <list>
#include <utility>

namespace plsc {

namespace {

// All messages are alike for MPI; what they mean is in them.
constexpr int kTag = 1;

// Errors of MPI end the job (its default), so no result is looked at: the
// store on rank 0 is good at any moment.
class MpiLink : public RankLink {
 public:
  MpiLink() {
    MPI_Init(nullptr, nullptr);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
  }
  ~MpiLink() override {
    for (Sending& one : sending_) MPI_Wait(&one.request, MPI_STATUS_IGNORE);
    MPI_Finalize();
  }

  int rank() const override { return rank_; }
  int size() const override { return size_; }
  bool is_sending() const override { return !sending_.empty(); }

  void Send(int rank, std::string text) override {
    assert(text.size() <= std::numeric_limits<int>::max());
    Sending& one = sending_.emplace_back();
    one.text = std::move(text);
    MPI_Isend(one.text.data(), static_cast<int>(one.text.size()), MPI_BYTE,
              rank, kTag, MPI_COMM_WORLD, &one.request);
    Forget();
  }

  std::optional<Message> Receive() override {
    Forget();
    int is_there = 0;
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, kTag, MPI_COMM_WORLD, &is_there, &status);
    if (is_there == 0) return std::nullopt;
    int size = 0;
    MPI_Get_count(&status, MPI_BYTE, &size);
    Message message;
    message.rank = status.MPI_SOURCE;
    message.text.resize(static_cast<std::size_t>(size));
    // Waits for the rest of a long one; what we send goes on meanwhile, so two
    // that send each other long ones do not wait for each other.
    MPI_Recv(message.text.data(), size, MPI_BYTE, message.rank, kTag,
             MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    return message;
  }

 private:
  struct Sending {
    std::string text;  // MPI reads it where it lies
    MPI_Request request = MPI_REQUEST_NULL;
  };

  void Forget() {
    sending_.remove_if([](Sending& one) {
      int is_done = 0;
      MPI_Test(&one.request, &is_done, MPI_STATUS_IGNORE);
      return is_done != 0;
    });
  }

  int rank_ = 0;
  int size_ = 1;
  std::list<Sending> sending_;
};

}  // namespace

std::unique_ptr<RankLink> ConnectRanks() {
  return std::make_unique<MpiLink>();
}

}  // namespace plsc
