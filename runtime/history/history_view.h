#pragma once

// A development and the text that it comes from, as the writers of this folder
// look at it. Symbols, rules, modules, nodes are numbered from 1 for people
// and scripts, as the phenotype's ids are.

#include <string>

#include "compiler/source_map.h"
#include "grammar/source.h"
#include "runtime/develop/trace.h"

namespace plsc {

/// Refers to its parts, which must outlive it.
struct HistoryView {
  const Source& source;
  const Genotype& genotype;
  const SourceMap& map;
  const Environment& environment;
  const History& history;

  /// The insertion of symbol `index` of the final string.
  const Insertion& At(StringIndex index) const {
    return history.derivation[history.derivation.string()[index]];
  }
};

/// Where the occurrence is written; of the axiom, its item's name, or nothing
/// (an empty span) when the file leaves it out.
Span SpanOf(const HistoryView& view, const Occurrence& occurrence);

/// "file:12:5" of the span's begin.
std::string PlaceText(const Source& source, Span span);

}  // namespace plsc
