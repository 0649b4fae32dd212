#include "runtime/compare/difference_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>

#include "compiler/changes/merge_parts.h"

namespace plsc {

namespace {

// Unchanged symbols shown before and after a changed one, as diff -u's lines.
constexpr std::size_t kContext = 2;
// Environments of one kind that are named; the rest is counted.
constexpr std::size_t kNamedEnvironments = 4;

std::string Painted(char mark, std::string_view line,
                    const DifferenceStyle& style) {
  std::string text = fmt::format("{} {}", mark, line);
  if (!style.in_color || mark == ' ') return text;
  const int color = mark == '+' ? 32 : mark == '-' ? 31 : 33;
  return fmt::format("\x1b[{}m{}\x1b[0m", color, text);
}

char MarkOf(ItemChangeKind kind) {
  switch (kind) {
    case ItemChangeKind::kAdded:
      return '+';
    case ItemChangeKind::kRemoved:
      return '-';
    case ItemChangeKind::kMoved:
      return '>';
    case ItemChangeKind::kChanged:
      break;
  }
  return '~';
}

std::string Where(const ItemChange& change) {
  if (change.old_line == 0) return fmt::format("line {}", change.new_line);
  if (change.new_line == 0) return fmt::format("was line {}", change.old_line);
  if (change.old_line == change.new_line)
    return fmt::format("line {}", change.new_line);
  return fmt::format("line {}, was {}", change.new_line, change.old_line);
}

bool IsChanged(const PartChange& part) {
  return part.before != part.after;
}

std::string PartLine(const PartChange& part, const DifferenceStyle& style) {
  if (!part.before) return Painted('+', PartText(*part.after), style);
  if (!part.after) return Painted('-', PartText(*part.before), style);
  if (!IsChanged(part)) return Painted(' ', PartText(*part.after), style);
  return Painted('~', PartChangeText(*part.before, *part.after), style);
}

std::string PartLines(const std::vector<PartChange>& parts,
                      const DifferenceStyle& style) {
  std::vector<bool> is_shown(parts.size(), false);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!IsChanged(parts[i])) continue;
    const std::size_t end = std::min(parts.size(), i + kContext + 1);
    for (std::size_t j = i - std::min(i, kContext); j < end; ++j)
      is_shown[j] = true;
  }
  if (std::find(is_shown.begin(), is_shown.end(), true) == is_shown.end())
    return "";
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (is_shown[i])
      text += "    " + PartLine(parts[i], style) + '\n';
    else if (i == 0 || is_shown[i - 1])
      text += "      ...\n";
  }
  return text;
}

// "rule C -> if hot = True then {" without its brace.
std::string Head(const std::string& content) {
  const std::size_t end = content.find_last_not_of(" {");
  return content.substr(0, end + 1);
}

std::string HeadLines(const ItemChange& change, const DifferenceStyle& style) {
  if (change.kind == ItemChangeKind::kMoved)
    return "    " + Painted(' ', Head(change.after), style) + '\n';
  std::string text;
  if (!change.before.empty() && change.before != change.after)
    text += "    " + Painted('-', Head(change.before), style) + '\n';
  if (!change.after.empty() && change.before != change.after)
    text += "    " + Painted('+', Head(change.after), style) + '\n';
  return text;
}

std::string DifferenceLine(const Difference& difference,
                           const DifferenceStyle& style) {
  switch (difference.kind) {
    case DifferenceKind::kAdded:
      return Painted('+', difference.what, style);
    case DifferenceKind::kMissing:
      return Painted('-', difference.what, style);
    case DifferenceKind::kMoved:
    case DifferenceKind::kChanged:
      break;
  }
  const char mark = difference.kind == DifferenceKind::kMoved ? '>' : '~';
  return Painted(mark,
                 fmt::format("{}: {} -> {}", difference.what,
                             difference.expected, difference.found),
                 style);
}

std::string NameOf(const SharedEnvironment& where) {
  if (where.names.empty()) return where.text;
  const std::string names = fmt::format("{}", fmt::join(where.names, ", "));
  return where.is_any ? names : fmt::format("{} ({})", names, where.text);
}

std::string NamesOf(const DifferenceGroup& group) {
  std::string text;
  for (std::size_t i = 0; i < std::min(group.size(), kNamedEnvironments); ++i)
    text += (i > 0 ? "; " : "") + NameOf(group[i]->where);
  if (group.size() > kNamedEnvironments)
    text += fmt::format("; and {} more", group.size() - kNamedEnvironments);
  return text;
}

}  // namespace

std::string PartChangeText(const PartContent& before,
                           const PartContent& after) {
  if (before.name != after.name || before.values.size() != after.values.size())
    return PartText(before) + " -> " + PartText(after);
  PartContent marked = after;
  for (std::size_t i = 0; i < after.values.size(); ++i)
    if (before.values[i] != after.values[i])
      marked.values[i] = before.values[i] + " -> " + after.values[i];
  return PartText(marked);
}

std::string ItemChangesText(const std::vector<ItemChange>& changes,
                            const DifferenceStyle& style) {
  std::string text;
  for (const ItemChange& change : changes) {
    text += Painted(MarkOf(change.kind),
                    fmt::format("{} ({})", change.name, Where(change)), style) +
            '\n';
    text += HeadLines(change, style);
    text += PartLines(change.parts, style);
  }
  return text;
}

std::string RobotDifferencesText(
    const std::string& genotype,
    const std::vector<EnvironmentDifference>& environments,
    const DifferenceStyle& style) {
  std::string text;
  for (const DifferenceGroup& group : GroupAlike(environments)) {
    text += fmt::format("{} in {}:", genotype, NamesOf(group));
    if (group.front()->differences.empty()) {
      text += " the same\n";
      continue;
    }
    text += '\n';
    for (const Difference& difference : group.front()->differences)
      text += "    " + DifferenceLine(difference, style) + '\n';
  }
  return text;
}

}  // namespace plsc
