#pragma once

// A development with its history as text for people: which rules are active,
// each rewriting, what each symbol did; and where one symbol came from.

#include <string>

#include "runtime/history/history_view.h"

namespace plsc {

/// All three parts, a line a rule, a rewriting and a symbol.
std::string HistoryText(const HistoryView& view);

/// Where a symbol was written, with the line, a caret and the rule and
/// iteration that inserted it; then the same of each symbol that it was
/// inserted for, up to the axiom.
std::string AncestryText(const HistoryView& view, InsertionId id);

/// "rule 2 (C, if inclined = True)".
std::string RuleText(const Genotype& genotype, RuleIndex rule);

}  // namespace plsc
