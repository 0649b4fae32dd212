#include "runtime/lsp/documents.h"

#include <fmt/format.h>

#include <utility>

#include "runtime/lsp/params.h"
#include "runtime/lsp/rpc.h"

namespace plsc::lsp {

namespace {

std::int64_t VersionOf(const Json& document) {
  const auto version = document.find("version");
  if (version == document.end() || !version->is_number_integer()) return 0;
  return version->get<std::int64_t>();
}

Document Analyzed(const std::string& uri, std::string text,
                  std::int64_t version) {
  Document document;
  document.version = version;
  document.analysis = std::make_unique<Analysis>(uri, std::move(text));
  return document;
}

}  // namespace

std::string ChangedText(const std::string& text, const Json& change) {
  const std::string& replacement = ReadString(change, "text");
  if (!change.contains("range")) return replacement;
  const PlaceRange range = ReadRange(change, "range");
  const LineTable lines(text);
  std::uint32_t begin = lines.OffsetAt(range.start);
  std::uint32_t end = lines.OffsetAt(range.end);
  if (begin > end) std::swap(begin, end);
  std::string changed;
  changed.reserve(text.size() - (end - begin) + replacement.size());
  changed.append(text, 0, begin);
  changed += replacement;
  changed.append(text, end, std::string::npos);
  return changed;
}

Document& Documents::Open(const Json& params) {
  const Json& item = ReadKey(params, "textDocument");
  const std::string& uri = ReadString(item, "uri");
  const std::string& text = ReadString(item, "text");
  return documents_[uri] = Analyzed(uri, text, VersionOf(item));
}

Document& Documents::Change(const Json& params) {
  Document& document = At(params);
  const Json& changes = ReadKey(params, "contentChanges");
  if (!changes.is_array())
    throw Fault(ErrorCode::kInvalidParams,
                "expected 'contentChanges' to be an array");
  std::string text(document.analysis->text());
  for (const Json& change : changes) text = ChangedText(text, change);
  const std::string uri = document.analysis->uri();
  document = Analyzed(uri, std::move(text), VersionOf(params["textDocument"]));
  return document;
}

std::string Documents::Close(const Json& params) {
  std::string uri = At(params).analysis->uri();
  documents_.erase(uri);
  return uri;
}

Document& Documents::At(const Json& params) {
  const std::string& uri = ReadUri(params);
  Document* document = Find(uri);
  if (document == nullptr)
    throw Fault(ErrorCode::kInvalidParams,
                fmt::format("no document '{}' is open", uri));
  return *document;
}

Document* Documents::Find(const std::string& uri) {
  const auto found = documents_.find(uri);
  return found == documents_.end() ? nullptr : &found->second;
}

}  // namespace plsc::lsp
