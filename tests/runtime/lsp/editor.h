#pragma once

// An editor for tests: a Server and one document, whose text may have one '@'
// where the cursor is.

#include <optional>
#include <string>
#include <vector>

#include "runtime/lsp/analysis.h"
#include "runtime/lsp/json.h"
#include "runtime/lsp/server.h"

namespace plsc::lsp {

inline constexpr const char* kTestUri = "file:///robot.pls";

/// A text without its '@', and where that was; the end when there is none.
struct Marked {
  explicit Marked(const std::string& with_mark);

  std::string text;
  std::uint32_t offset = 0;
};

class Editor {
 public:
  /// Says initialize with these capabilities, options and opens nothing.
  explicit Editor(Json capabilities = Json::object(),
                  Json options = Json::object());

  void Open(const std::string& text);
  void Notify(const std::string& method, Json params);
  /// The whole answer: with `result` or `error`.
  Json Ask(const std::string& method, Json params);
  /// The result; fails the test when there is an error.
  Json Result(const std::string& method, Json params);
  /// Works until nothing is left to do; the last published diagnostics.
  Json Diagnostics();

  /// {textDocument}, and with the cursor's position.
  Json Here() const;
  Json HereAt(std::uint32_t offset) const;
  /// {textDocument, range} of all the text.
  Json Whole() const;

  Server& server() { return server_; }
  /// What came that answers no request.
  const std::vector<Json>& received() const { return received_; }

 private:
  void Receive(const std::vector<std::string>& bodies);

  Server server_{"test"};
  int last_id_ = 0;
  std::string text_;
  std::vector<Json> received_;
};

/// The document after TextEdits, as an editor makes them.
std::string Edited(const std::string& text, const Json& edits);

/// gecko of docs/language.md, shorter: states, constants, two rules of C, one
/// of B, two environments, a test.
inline constexpr const char* kGecko = R"(plsc 1

genotype gecko
alphabet plasticoding 1
sense inclined: bool
sense warmth: real in -40..60
sense ground: { dry, wet }
let mild = 12.5
let half = 0.5

rule C -> if inclined = False then {
  C
  add_left
  A1(half, 1.6, 6.4, 2.3)
}
rule C -> if inclined = True or warmth > mild and ground != wet then {
  C
  add_front
  B
}
rule B -> { add_right T(half) }

environment flat { inclined = False, warmth = 20, ground = dry }
environment tilted { inclined = True, warmth = mild, ground = wet }

test start in flat after 0 -> { C }
)";

}  // namespace plsc::lsp
