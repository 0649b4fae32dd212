#include "runtime/cli/commands/offspring.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <ostream>
#include <string_view>
#include <utility>

#include "compiler/print.h"
#include "runtime/text/json_dump.h"

namespace plsc::cli {

namespace {

std::string AsOneFile(const std::vector<OneChild>& children) {
  std::vector<std::string> texts;
  texts.reserve(children.size());
  for (const OneChild& child : children) texts.push_back(Print(child.program));
  return JoinGenotypes(texts);
}

std::string AsLines(const std::vector<OneChild>& children) {
  std::string lines;
  for (const OneChild& child : children) {
    auto line = nlohmann::ordered_json::parse(child.what);
    line["genotype"] = child.program.genotype.name;
    line["text"] = Print(child.program);
    lines += DumpJson(line) + '\n';
  }
  return lines;
}

}  // namespace

std::string JoinGenotypes(const std::vector<std::string>& texts) {
  constexpr std::string_view kVersionLine = "plsc 1\n";
  std::string joined;
  for (const std::string& text : texts)
    joined += joined.empty() ? text : text.substr(kVersionLine.size());
  return joined;
}

OutputKind ChildrenKind(OutputFormat format) {
  return format == OutputFormat::kJson ? OutputKind::kChildren
                                       : OutputKind::kGenotype;
}

bool DeliverChildren(std::vector<OneChild> children, const Output& output,
                     Io& io) {
  const bool is_json = output.kind == OutputKind::kChildren;
  if (children.size() > 1)
    for (std::size_t i = 0; i < children.size(); ++i)
      children[i].program.genotype.name += fmt::format("_{}", i + 1);
  if (!WriteOutput(output, is_json ? AsLines(children) : AsOneFile(children),
                   io))
    return false;
  if (is_json) return true;
  for (const OneChild& child : children)
    io.err << fmt::format("{}: {}\n", child.program.genotype.name, child.told);
  return true;
}

}  // namespace plsc::cli
