#pragma once

// How genotypes become robots, as the data of the page `plsc view --explain`
// (runtime/pages/src/explain): the text with its rules, and for each
// environment what holds, each rewriting, what each symbol did, and the parts
// of the robot with the symbols that made them. Numbers count from 1, places in
// the text are bytes.

#include <string>
#include <vector>

#include "runtime/history/history_view.h"

namespace plsc {

struct ExplainedEnvironment {
  std::string name;
  std::string senses;  ///< may be empty
  Environment environment;
  History history;  ///< with a trace
};

struct ExplainedRobot {
  std::string title;
  Source source;
  Genotype genotype;
  SourceMap map;
  std::vector<ExplainedEnvironment> environments;
};

std::string ExplainJson(const std::vector<ExplainedRobot>& robots);

}  // namespace plsc
