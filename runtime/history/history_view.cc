#include "runtime/history/history_view.h"

#include <fmt/format.h>

#include "grammar/shown_line.h"

namespace plsc {

Span SpanOf(const HistoryView& view, const Occurrence& occurrence) {
  if (occurrence.rule == kNoRule) return view.map.axiom;
  return view.map.rules[occurrence.rule].symbols[occurrence.position];
}

std::string PlaceText(const Source& source, Span span) {
  const Position at = source.PositionOf(span.begin);
  return fmt::format("{}:{}:{}", Escaped(source.name()), at.line, at.column);
}

}  // namespace plsc
