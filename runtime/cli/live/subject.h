#pragma once

// What a live page is joined with: a genotype's file, a run, a study. Tells the
// page how it stands when the page opens, what changed since, and answers what
// only it can answer.

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "grammar/expected.h"
#include "grammar/failure.h"
#include "runtime/server/message.h"

namespace plsc::cli {

/// A name and one line of JSON.
using Event = std::pair<std::string, std::string>;

class Subject {
 public:
  Subject() = default;
  virtual ~Subject() = default;
  Subject(const Subject&) = delete;
  Subject& operator=(const Subject&) = delete;

  /// What the browser's tab is called.
  virtual std::string Title() const = 0;
  /// The page's data, an object (docs/live.md).
  virtual std::string PageData() const = 0;
  /// How it stands now, for who begins to listen.
  virtual std::vector<Event> Standing() const = 0;
  /// What happened since it was last asked.
  virtual std::vector<Event> Look() = 0;
  /// Of requests that are no questions to the service: 404 for what it does not
  /// know.
  virtual server::Response Answer(const server::Request& request) = 0;
};

/// A genotype's file, and the scenario of its lives (empty: the paper's).
Expected<std::unique_ptr<Subject>, Failure> JoinFile(
    const std::string& path, const std::string& scenario);
/// A run's store.
Expected<std::unique_ptr<Subject>, Failure> JoinRun(const std::string& path);
/// A study's folder.
Expected<std::unique_ptr<Subject>, Failure> JoinStudy(
    const std::string& folder);

}  // namespace plsc::cli
