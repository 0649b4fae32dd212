// Asks about how a robot came about and what it looks like.

#include <nlohmann/json.hpp>

#include "runtime/develop/trace.h"
#include "runtime/history/explained_robot.h"
#include "runtime/pictures/drawn_robot.h"
#include "runtime/service/asks.h"
#include "runtime/service/refusal.h"
#include "runtime/service/subject.h"

namespace plsc::service {

namespace {

[[noreturn]] void RefuseHistory(const NamedEnvironment& named) {
  throw Refusal("in " + named.name +
                ", the history of development has too many symbols to be kept");
}

struct Shown {
  Subject subject;
  std::vector<NamedEnvironment> environments;
};

Shown ShownOf(const Request& request) {
  Shown shown{SubjectOf(request), {}};
  RefuseBodiless(shown.subject.genotype(), "show");
  shown.environments = EnvironmentsOf(request, shown.subject);
  RefuseGrowth(shown.subject, shown.environments);
  return shown;
}

}  // namespace

Answer Explain(const Request& request) {
  const auto [subject, environments] = ShownOf(request);
  const auto explained = ExplainRobot(subject.genotype().name, subject.source,
                                      subject.mapped, environments);
  if (!explained) {
    const NotExplained& why = explained.error();
    if (why.why == NotExplained::Why::kGrown) RefuseHistory(why.environment);
    throw Refusal(TooManyToShow(subject.genotype().name));
  }
  Answer answer;
  answer.AddWritten("explained", ExplainJson({*explained}));
  return answer;
}

Answer Draw(const Request& request) {
  const auto [subject, environments] = ShownOf(request);
  DrawnRobot drawn;
  for (const NamedEnvironment& named : environments) {
    const auto history =
        DevelopWithHistory(subject.genotype(), named.environment);
    if (!history) RefuseHistory(named);
    drawn.Add(named, *history, subject.genotype().states);
  }
  const std::string& title = subject.genotype().name;
  Answer answer;
  answer.Add("body", BodiesSvg(title, drawn.bodies));
  answer.Add("rules",
             BodiesByRuleSvg(title, drawn.bodies,
                             RuleTexts(subject.source, subject.mapped)));
  answer.Add("brain", BrainsSvg(title, drawn.brains));
  return answer;
}

}  // namespace plsc::service
