#include "runtime/cli/offspring.h"

#include <fmt/format.h>

#include <ostream>
#include <string_view>
#include <utility>

#include "compiler/print.h"

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
    nlohmann::ordered_json line = child.what;
    line["genotype"] = child.program.genotype.name;
    line["text"] = Print(child.program);
    lines += line.dump() + '\n';
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

bool DeliverChildren(std::vector<OneChild> children, const std::string& output,
                     OutputFormat format, Io& io) {
  if (children.size() > 1)
    for (std::size_t i = 0; i < children.size(); ++i)
      children[i].program.genotype.name += fmt::format("_{}", i + 1);
  const std::string text =
      format == OutputFormat::kJson ? AsLines(children) : AsOneFile(children);
  if (output.empty()) {
    io.out << text;
  } else if (const auto failure = WriteFile(output, text)) {
    io.err << fmt::format("error: cannot write '{}': {}\n", output, *failure);
    return false;
  }
  if (format == OutputFormat::kJson) return true;
  for (const OneChild& child : children)
    io.err << fmt::format("{}: {}\n", child.program.genotype.name, child.told);
  return true;
}

}  // namespace plsc::cli
