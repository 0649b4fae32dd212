#pragma once

// What clients send, read with suspicion: every function throws a Fault
// (invalid params) that names the key when something is missing or of another
// type.

#include <string>

#include "runtime/lsp/json.h"
#include "runtime/lsp/line_table.h"

namespace plsc::lsp {

const Json& ReadKey(const Json& object, const char* key);
const std::string& ReadString(const Json& object, const char* key);
/// {line, character}; numbers that no line has count as the largest.
Place ReadPlace(const Json& object, const char* key);
PlaceRange ReadRange(const Json& object, const char* key);
/// params.textDocument.uri
const std::string& ReadUri(const Json& params);

/// The string under `key`, or empty.
std::string OptionalString(const Json& object, const char* key);
/// Whether all keys lead to `true`, one in the other.
bool IsTrue(const Json& object, std::initializer_list<const char*> keys);

Json PlaceJson(Place place);
Json RangeJson(const PlaceRange& range);
/// {range, newText}
Json TextEditJson(const LineTable& lines, Span span,
                  const std::string& replacement);
/// A WorkspaceEdit that changes one document.
Json WorkspaceEditJson(const std::string& uri, Json edits);
/// {kind: markdown, value}
Json MarkdownJson(std::string text);

}  // namespace plsc::lsp
