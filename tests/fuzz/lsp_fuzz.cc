// The language server survives any client. An input that begins with '{' is a
// list of bodies, one a line; with 'C' a stream with headers; any other is a
// document that is asked everything in some places, edited and asked again.

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "compiler/compile.h"
#include "fuzz/require.h"
#include "runtime/lsp/framing.h"
#include "runtime/lsp/server.h"

namespace {

using Json = nlohmann::json;
using plsc::fuzz::Require;
using plsc::lsp::Server;

constexpr const char* kUri = "file:///fuzz.pls";
// Places of a document that are asked about; each costs all features once.
constexpr std::size_t kPlaces = 8;

// What is sent is JSON-RPC: a request, a notification, a result or an error.
void RequireMessages(const std::vector<std::string>& bodies) {
  for (const std::string& body : bodies) {
    const Json json = Json::parse(body, nullptr, false);
    Require(json.is_object(), "what is sent is a JSON object");
    Require(json["jsonrpc"] == "2.0", "what is sent is JSON-RPC 2.0");
    const bool is_answer = json.contains("result") != json.contains("error");
    Require(json.contains("method") != is_answer,
            "what is sent asks, tells or answers");
  }
}

std::string Body(const char* method, Json params, int id) {
  Json body = {{"jsonrpc", "2.0"}, {"method", method}};
  body["params"] = std::move(params);
  if (id > 0) body["id"] = id;
  return body.dump(-1, ' ', false, Json::error_handler_t::replace);
}

void Say(Server& server, const char* method, Json params) {
  RequireMessages(server.Handle(Body(method, std::move(params), 0)));
}

Json Ask(Server& server, const char* method, Json params) {
  const auto bodies = server.Handle(Body(method, std::move(params), 1));
  RequireMessages(bodies);
  for (const std::string& body : bodies)
    if (const Json json = Json::parse(body); !json.contains("method"))
      return json;
  Require(false, "each request is answered");
  return nullptr;
}

void Work(Server& server) {
  // Hostile files may hold a thousand genotypes.
  for (int i = 0; i < 20 && server.has_work(); ++i)
    RequireMessages(server.Idle());
}

void HandleLines(std::string_view text) {
  Server server("fuzz");
  while (!text.empty() && !server.exit_status()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    RequireMessages(server.Handle(text.substr(0, end)));
    text.remove_prefix(std::min(end + 1, text.size()));
    Work(server);
  }
}

void HandleStream(std::string_view text) {
  Server server("fuzz");
  plsc::lsp::FrameReader frames;
  frames.Append(text);
  for (auto frame = frames.Next();
       frame.kind == plsc::lsp::Frame::Kind::kBody && !server.exit_status();
       frame = frames.Next())
    RequireMessages(server.Handle(frame.text));
}

void AskEverythingAt(Server& server, Json params) {
  for (const char* method :
       {"textDocument/hover", "textDocument/definition",
        "textDocument/documentHighlight", "textDocument/references",
        "textDocument/completion", "textDocument/prepareRename",
        "textDocument/signatureHelp"})
    Ask(server, method, params);
  params["newName"] = "fresh_name";
  const Json renamed = Ask(server, "textDocument/rename", params);
  if (renamed.contains("error")) return;
  Require(!renamed["result"]["changes"][kUri].empty(),
          "a rename changes the name that it was asked about");
}

void AskEverything(Server& server, std::size_t lines) {
  const Json document = {{"uri", kUri}};
  Json params = {{"textDocument", document}};
  for (const char* method :
       {"textDocument/documentSymbol", "textDocument/formatting",
        "textDocument/foldingRange", "textDocument/semanticTokens/full"})
    Ask(server, method, params);
  params["range"] = {{"start", {{"line", 0}, {"character", 0}}},
                     {"end", {{"line", lines}, {"character", 0}}}};
  for (const char* method :
       {"textDocument/codeAction", "textDocument/inlayHint",
        "textDocument/rangeFormatting", "textDocument/semanticTokens/range"})
    Ask(server, method, params);
  for (std::size_t i = 0; i < kPlaces; ++i) {
    // Spread over lines and columns without any randomness.
    params["position"] = {{"line", i * lines / kPlaces},
                          {"character", (i * 7) % 31}};
    AskEverythingAt(server, params);
  }
}

void HandleDocument(const std::string& text) {
  Server server("fuzz");
  Ask(server, "initialize", {{"capabilities", Json::object()}});
  Json document = {{"uri", kUri}, {"languageId", "pls"}, {"version", 1}};
  document["text"] = text;
  Say(server, "textDocument/didOpen", {{"textDocument", document}});
  Work(server);
  const auto lines =
      static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  AskEverything(server, lines);
  Json change;
  change["range"] = {{"start", {{"line", lines / 2}, {"character", 3}}},
                     {"end", {{"line", lines / 2 + 1}, {"character", 5}}}};
  change["text"] = text.substr(0, text.size() / 3);
  Say(server, "textDocument/didChange",
      {{"textDocument", {{"uri", kUri}, {"version", 2}}},
       {"contentChanges", Json::array({change})}});
  Work(server);
  AskEverything(server, lines);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  const plsc::Source source = plsc::fuzz::AsSource(data, size);
  const std::string_view text = source.text();
  if (text.starts_with('{'))
    HandleLines(text);
  else if (text.starts_with("Content-"))
    HandleStream(text);
  else
    HandleDocument(std::string(text));
  return 0;
}
