#pragma once

// Messages between the ranks of an MPI job, texts both ways. Nothing here
// waits: MPI's own waiting keeps a core busy, and both ends have workers to
// attend to.

#include <memory>
#include <optional>
#include <string>

namespace plsc {

class RankLink {
 public:
  struct Message {
    int rank = 0;  ///< of the sender
    std::string text;
  };

  RankLink() = default;
  virtual ~RankLink() = default;  ///< when all that was sent has been received
  RankLink(const RankLink&) = delete;
  RankLink& operator=(const RankLink&) = delete;

  virtual int rank() const = 0;
  virtual int size() const = 0;
  /// Messages between two ranks arrive in the order in which they were sent.
  virtual void Send(int rank, std::string text) = 0;
  /// One that has arrived, if any. Also brings on what is being sent, so call
  /// it again and again.
  virtual std::optional<Message> Receive() = 0;
  /// Whether something is not on its way yet.
  virtual bool is_sending() const = 0;
};

/// Joins the job, once in a process. Nothing if plsc was built without MPI.
std::unique_ptr<RankLink> ConnectRanks();

}  // namespace plsc
