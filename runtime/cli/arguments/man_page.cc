#include "runtime/cli/arguments/man_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace plsc::cli {

namespace {

// A line of text: no escape, no request, and '-' as it is typed.
std::string Roff(std::string_view text) {
  std::string line;
  if (text.starts_with('.') || text.starts_with('\'')) line = "\\&";
  for (const char c : text) {
    if (c == '\\')
      line += "\\e";
    else if (c == '-')
      line += "\\-";
    else if (c == '`' || c == '\'' || c == '^' || c == '~')
      line += c == '`'    ? "\\(ga"
              : c == '\'' ? "\\(aq"
              : c == '^'  ? "\\(ha"
                          : "\\(ti";
    else
      line += c;
  }
  return line;
}

std::string Bold(std::string_view text) {
  return "\\fB" + Roff(text) + "\\fR";
}

std::string Italic(std::string_view text) {
  return "\\fI" + Roff(text) + "\\fR";
}

std::string FullName(const CommandDescription& command) {
  return command.name.empty() ? "plsc" : "plsc " + command.name;
}

std::string NamesText(const OptionDescription& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.names) names.push_back(Bold(name));
  std::string text = fmt::format("{}", fmt::join(names, ", "));
  if (!option.value.empty())
    text += (text.empty() ? "" : " ") + Italic(option.value);
  return text;
}

std::string Synopsis(const CommandDescription& command) {
  std::string text = Bold(FullName(command)) + " [" + Italic("options") + "]";
  if (!command.commands.empty()) text += " " + Italic("COMMAND") + " ...";
  for (const OptionDescription& positional : command.positionals) {
    std::string one = Italic(positional.value);
    if (positional.is_repeated) one += " ...";
    text += ' ' + (positional.is_required ? one : "[" + one + "]");
  }
  return text + '\n';
}

// Prose as paragraphs; lines behind two blanks as they are.
std::string Prose(const std::string& text) {
  std::string roff;
  bool is_example = false;
  bool begins_paragraph = false;  // the section begins the first
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string line = text.substr(at, end - at);
    at = end + 1;
    const bool was_example = is_example;
    if (!line.empty()) is_example = line.starts_with("  ");
    if (was_example && !is_example) roff += ".EE\n.RE\n";
    if (line.empty()) {
      begins_paragraph = true;
      continue;
    }
    if (is_example && !was_example)
      roff += ".PP\n.RS\n.EX\n";
    else if (begins_paragraph)
      roff += is_example ? "\n" : ".PP\n";
    begins_paragraph = false;
    roff += Roff(is_example ? line.substr(2) : line) + '\n';
  }
  return is_example ? roff + ".EE\n.RE\n" : roff;
}

std::string Tagged(const std::vector<OptionDescription>& options) {
  std::string roff;
  for (const OptionDescription& option : options) {
    roff += ".TP\n" + NamesText(option) + '\n' + Roff(option.help);
    if (option.is_required && !option.names.empty()) roff += " (required)";
    roff += '\n';
  }
  return roff;
}

std::string CommandList(const CommandDescription& command) {
  std::string roff;
  for (const CommandDescription& below : command.commands)
    roff += ".TP\n" + Bold(below.name) + '\n' + Roff(below.summary) + '\n';
  return roff;
}

// The pages above and below.
std::string SeeAlso(const CommandDescription& command) {
  std::vector<std::string> pages;
  if (!command.name.empty()) pages.push_back(Bold("plsc") + "(1)");
  for (const CommandDescription& below : command.commands)
    pages.push_back(Bold(PageName(below)) + "(1)");
  return fmt::format("{}\n", fmt::join(pages, ",\n"));
}

// A summary of several lines is one in the index of pages.
std::string OneLine(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  if (text.ends_with('.')) text.pop_back();
  return text;
}

}  // namespace

std::string PageName(const CommandDescription& command) {
  std::string name = "plsc";
  if (!command.name.empty()) name += '-' + command.name;
  std::replace(name.begin(), name.end(), ' ', '-');
  return name;
}

std::string ManPage(const CommandDescription& command,
                    std::string_view version) {
  std::string title = PageName(command);
  std::transform(title.begin(), title.end(), title.begin(), [](char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  });
  std::string page = fmt::format(
      ".\\\" Made by `plsc man`; change the help of the command instead.\n"
      ".TH {} 1 \"\" \"plsc {}\" \"plsc\"\n"
      ".SH NAME\n{} \\- {}\n"
      ".SH SYNOPSIS\n{}",
      title, version, PageName(command), Roff(OneLine(command.summary)),
      Synopsis(command));
  if (!command.footer.empty())
    page += ".SH DESCRIPTION\n" + Prose(command.footer);
  if (!command.commands.empty())
    page += ".SH COMMANDS\n" + CommandList(command);
  if (!command.positionals.empty())
    page += ".SH ARGUMENTS\n" + Tagged(command.positionals);
  if (!command.options.empty())
    page += ".SH OPTIONS\n" + Tagged(command.options);
  page +=
      ".SH EXIT STATUS\n0 fine, 1 the input is wrong, 2 the usage is "
      "wrong,\n130 interrupted.\n";
  return page + ".SH SEE ALSO\n" + SeeAlso(command);
}

}  // namespace plsc::cli
