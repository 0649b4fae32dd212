#pragma once

// Workers without processes, for tests that look at who gets which answer.

#include <deque>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "runtime/workers/workers.h"

namespace plsc::test {

/// Works in this process, when asked to wait, the newest request first.
class Here : public Workers {
 public:
  explicit Here(Work work) : work_(std::move(work)) {}

  void Submit(int ticket, std::string request) override {
    waiting_.emplace_back(ticket, std::move(request));
    ++submitted;
  }
  void CancelWaiting() override { waiting_.clear(); }
  std::vector<Reply> Wait(int) override {
    if (waiting_.empty()) return {};
    const auto [ticket, request] = waiting_.back();
    waiting_.pop_back();
    if (is_deadly) return {{ticket, std::nullopt, "signal 11"}};
    return {{ticket, work_(request), ""}};
  }
  int workers() const override { return 1; }
  int busy() const override { return 0; }
  int outstanding() const override { return static_cast<int>(waiting_.size()); }
  const std::optional<std::string>& failure() const override {
    return failure_;
  }

  int submitted = 0;
  bool is_deadly = false;
  void Fail() { failure_ = "no worker can be started"; }

 private:
  Work work_;
  std::deque<std::pair<int, std::string>> waiting_;
  std::optional<std::string> failure_;
};

}  // namespace plsc::test
