#pragma once

// Ranks without MPI: what is sent goes to a function that plays the others and
// may put messages into the inbox.

#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "runtime/workers/mpi_link.h"
#include "runtime/workers/mpi_message.h"

namespace plsc::test {

class FakeLink : public RankLink {
 public:
  using Play = std::function<void(FakeLink& link, int rank, RankWords words)>;

  FakeLink(int rank, int size, Play play)
      : rank_(rank), size_(size), play_(std::move(play)) {}

  void Say(int from, RankWord word, int number = 0, std::string text = "") {
    inbox_.push_back({from, Encode({word, number, std::move(text)})});
  }

  int rank() const override { return rank_; }
  int size() const override { return size_; }
  void Send(int rank, std::string text) override {
    play_(*this, rank, Decode(text));
  }
  std::optional<Message> Receive() override {
    if (inbox_.empty()) return std::nullopt;
    Message message = std::move(inbox_.front());
    inbox_.pop_front();
    return message;
  }
  bool is_sending() const override { return false; }

 private:
  int rank_;
  int size_;
  Play play_;
  std::deque<Message> inbox_;
};

}  // namespace plsc::test
