#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>

#include "grammar/codes.h"
#include "grammar/suggest.h"
#include "runtime/cli/arguments/texts.h"
#include "runtime/cli/explanations/explanations.h"

namespace plsc::cli {

namespace {

std::string Indented(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    result += fmt::format("    {}\n", text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return result;
}

std::string Text(const Explanation& explanation) {
  return fmt::format("{}: {}\n\n{}\nWrong:\n\n{}\nMended:\n\n{}",
                     NumberOf(explanation.code), MeaningOf(explanation.code),
                     explanation.text, Indented(explanation.wrong),
                     Indented(explanation.mended));
}

std::string ExplanationJson(const Explanation& explanation) {
  nlohmann::ordered_json json;
  json["code"] = NumberOf(explanation.code);
  json["meaning"] = MeaningOf(explanation.code);
  json["explanation"] = explanation.text;
  json["wrong"] = explanation.wrong;
  json["mended"] = explanation.mended;
  return json.dump() + "\n";
}

Exit List(OutputFormat format, Io& io) {
  for (const Explanation& explanation : Explanations()) {
    if (format == OutputFormat::kJson)
      io.out << ExplanationJson(explanation);
    else
      io.out << fmt::format("{}  {}\n", NumberOf(explanation.code),
                            MeaningOf(explanation.code));
  }
  return Exit::kFine;
}

// "p2001" and "error[P2001]" are what people type and paste.
std::string NumberIn(const std::string& written) {
  const std::size_t open = written.find('[');
  std::string code =
      open == std::string::npos ? written : written.substr(open + 1, 5);
  if (!code.empty() && code[0] >= 'a' && code[0] <= 'z')
    code[0] = static_cast<char>(code[0] - 'a' + 'A');
  return code;
}

}  // namespace

Exit Run(const ExplainCommand& command, Io& io) {
  if (command.list) return List(command.format, io);
  if (command.code.empty()) {
    io.err << "plsc: expected a code, as in 'plsc explain P2001', or --list\n";
    return Exit::kBadUsage;
  }
  const std::string number = NumberIn(command.code);
  const std::optional<Code> code = FindCode(number);
  const Explanation* explanation = code ? FindExplanation(*code) : nullptr;
  if (explanation == nullptr) {
    std::vector<std::string_view> known;
    for (const CodeInfo& info : DiagnosticCodes()) known.push_back(info.number);
    const auto near = Suggest(number, known);
    io.err << fmt::format("plsc: there is no code '{}'{}\n", command.code,
                          near ? "; did you mean '" + *near + "'?" : "")
           << "see 'plsc explain --list'\n";
    return Exit::kBadUsage;
  }
  io.out << (command.format == OutputFormat::kJson
                 ? ExplanationJson(*explanation)
                 : Text(*explanation));
  return Exit::kFine;
}

}  // namespace plsc::cli
