#include "tests/runtime/lsp/editor.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <utility>

#include "runtime/lsp/params.h"

namespace plsc::lsp {

Marked::Marked(const std::string& with_mark) : text(with_mark) {
  const std::size_t at = std::min(text.find('@'), text.size());
  offset = static_cast<std::uint32_t>(at);
  if (at < text.size()) text.erase(at, 1);
}

Editor::Editor(Json capabilities, Json options) {
  Json params;
  params["capabilities"] = std::move(capabilities);
  params["initializationOptions"] = std::move(options);
  Result("initialize", std::move(params));
}

void Editor::Receive(const std::vector<std::string>& bodies) {
  for (const std::string& body : bodies) received_.push_back(Json::parse(body));
}

void Editor::Notify(const std::string& method, Json params) {
  Json body = {{"jsonrpc", "2.0"}, {"method", method}};
  body["params"] = std::move(params);
  Receive(server_.Handle(body.dump()));
}

Json Editor::Ask(const std::string& method, Json params) {
  Json body = {{"jsonrpc", "2.0"}, {"id", ++last_id_}, {"method", method}};
  body["params"] = std::move(params);
  Json answer;
  for (const std::string& text : server_.Handle(body.dump())) {
    Json one = Json::parse(text);
    if (!one.contains("method") && one["id"] == last_id_)
      answer = std::move(one);
    else
      received_.push_back(std::move(one));
  }
  REQUIRE(answer.is_object());
  CHECK(answer["jsonrpc"] == "2.0");
  CHECK(answer.contains("result") != answer.contains("error"));
  return answer;
}

Json Editor::Result(const std::string& method, Json params) {
  const Json answer = Ask(method, std::move(params));
  INFO(answer.dump());
  REQUIRE(answer.contains("result"));
  return answer["result"];
}

void Editor::Open(const std::string& text) {
  text_ = text;
  Json document = {{"uri", kTestUri}, {"languageId", "pls"}, {"version", 1}};
  document["text"] = text;
  Notify("textDocument/didOpen", {{"textDocument", document}});
}

Json Editor::Diagnostics() {
  while (server_.has_work()) Receive(server_.Idle());
  const auto last = std::find_if(
      received_.rbegin(), received_.rend(), [](const Json& message) {
        return message["method"] == "textDocument/publishDiagnostics";
      });
  REQUIRE(last != received_.rend());
  return (*last)["params"]["diagnostics"];
}

Json Editor::Here() const {
  return {{"textDocument", {{"uri", kTestUri}}}};
}

Json Editor::HereAt(std::uint32_t offset) const {
  Json params = Here();
  params["position"] = PlaceJson(LineTable(text_).PlaceAt(offset));
  return params;
}

Json Editor::Whole() const {
  Json params = Here();
  params["range"] = RangeJson(
      LineTable(text_).RangeOf({0, static_cast<std::uint32_t>(text_.size())}));
  return params;
}

std::string Edited(const std::string& text, const Json& edits) {
  const LineTable lines(text);
  std::string edited = text;
  // From the back, so that places stay right.
  std::vector<Json> sorted(edits.begin(), edits.end());
  std::sort(sorted.begin(), sorted.end(), [&](const Json& a, const Json& b) {
    return lines.OffsetAt(ReadPlace(a["range"], "start")) >
           lines.OffsetAt(ReadPlace(b["range"], "start"));
  });
  for (const Json& edit : sorted) {
    const PlaceRange range = ReadRange(edit, "range");
    const std::uint32_t begin = lines.OffsetAt(range.start);
    edited.replace(begin, lines.OffsetAt(range.end) - begin,
                   edit["newText"].get<std::string>());
  }
  return edited;
}

}  // namespace plsc::lsp
