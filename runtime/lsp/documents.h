#pragma once

// The documents that are open in the editor. The editor's text counts, not the
// file's: the server reads no file.

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "runtime/lsp/advice.h"
#include "runtime/lsp/analysis.h"
#include "runtime/lsp/json.h"

namespace plsc::lsp {

struct Document {
  std::int64_t version = 0;  ///< the client's number; diagnostics carry it
  std::unique_ptr<Analysis> analysis;
  bool is_published = false;  ///< diagnostics of this version were sent
  Advice advice;
};

class Documents {
 public:
  /// params of textDocument/didOpen; opens it anew when it is open.
  Document& Open(const Json& params);
  /// params of textDocument/didChange. All changes are made or, when one cannot
  /// be read, none.
  Document& Change(const Json& params);
  /// The URI of what was closed.
  std::string Close(const Json& params);

  /// Of params.textDocument; a Fault when it is not open.
  Document& At(const Json& params);
  /// nullptr when it is not open.
  Document* Find(const std::string& uri);
  std::map<std::string, Document>& all() { return documents_; }
  const std::map<std::string, Document>& all() const { return documents_; }

 private:
  std::map<std::string, Document> documents_;
};

/// The text after one element of didChange's contentChanges: a range is
/// replaced, or without one everything.
std::string ChangedText(const std::string& text, const Json& change);

}  // namespace plsc::lsp
