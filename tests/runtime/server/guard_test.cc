#include "runtime/server/guard.h"

#include <catch2/catch.hpp>
#include <set>

namespace plsc::server {
namespace {

Request Asked(std::string target, std::string host, std::string origin = "") {
  Request request;
  request.method = "GET";
  request.target = std::move(target);
  request.host = std::move(host);
  request.origin = std::move(origin);
  return request;
}

TEST_CASE("who knows the token comes in, by a name of the server", "[guard]") {
  const Guard guard("t0ken", {"127.0.0.1", "localhost"}, 8000);
  const auto [host, origin] =
      GENERATE(std::pair("127.0.0.1:8000", ""), std::pair("localhost:8000", ""),
               std::pair("LocalHost:8000", "http://localhost:8000"),
               std::pair("127.0.0.1:8000", "http://127.0.0.1:8000"));
  Request request = Asked("/t0ken/ask", host, origin);
  CHECK_FALSE(guard.Refuse(request));
  CHECK(request.target == "ask");
  Request root = Asked("/t0ken/", host, origin);
  CHECK_FALSE(guard.Refuse(root));
  CHECK(root.target.empty());
}

TEST_CASE("nobody else does", "[guard]") {
  const Guard guard("t0ken", {"127.0.0.1", "localhost"}, 8000);
  Request request = GENERATE(
      // Without the token, with half of it, or in another place.
      Asked("/", "localhost:8000"), Asked("/ask", "localhost:8000"),
      Asked("/t0ke/ask", "localhost:8000"),
      Asked("/t0kenx/ask", "localhost:8000"), Asked("/t0ken", "localhost:8000"),
      Asked("t0ken/", "localhost:8000"), Asked("", "localhost:8000"),
      Asked("//t0ken/", "localhost:8000"), Asked("/x/t0ken/", "localhost:8000"),
      Asked("http://localhost:8000/t0ken/", "localhost:8000"),
      // By a name that somebody else had point here (DNS rebinding).
      Asked("/t0ken/", "evil.example:8000"), Asked("/t0ken/", "evil.example"),
      Asked("/t0ken/", "localhost.evil.example:8000"),
      Asked("/t0ken/", "localhost:8001"), Asked("/t0ken/", "localhost"),
      Asked("/t0ken/", ""),
      // By a page of another site, or of none.
      Asked("/t0ken/ask", "localhost:8000", "http://evil.example"),
      Asked("/t0ken/ask", "localhost:8000", "https://localhost:8000"),
      Asked("/t0ken/ask", "localhost:8000", "http://127.0.0.1:8000"),
      Asked("/t0ken/ask", "localhost:8000", "http://localhost:80"),
      Asked("/t0ken/ask", "localhost:8000", "null"));
  CAPTURE(request.target, request.host, request.origin);
  const auto refusal = guard.Refuse(request);
  REQUIRE(refusal);
  CHECK(refusal->status == 403);
  CHECK(refusal->body.find("t0ken") == std::string::npos);
}

TEST_CASE(
    "a server that is reached from elsewhere still wants token and origin",
    "[guard]") {
  const Guard guard("t0ken", {}, 8000);
  Request fine = Asked("/t0ken/", "robot.lab:8000", "http://robot.lab:8000");
  CHECK_FALSE(guard.Refuse(fine));
  Request without = Asked("/", "robot.lab:8000");
  CHECK(guard.Refuse(without));
  Request other = Asked("/t0ken/", "robot.lab:8000", "http://evil.example");
  CHECK(guard.Refuse(other));
}

TEST_CASE("the port of http is left out by browsers", "[guard]") {
  const Guard guard("t", {"localhost"}, 80);
  Request request = Asked("/t/", "localhost", "http://localhost");
  CHECK_FALSE(guard.Refuse(request));
}

TEST_CASE("tokens are 128 bits, and never the same", "[guard]") {
  std::set<std::string> tokens;
  for (int i = 0; i < 100; ++i) {
    const std::string token = RandomToken();
    CHECK(token.size() == 32);
    CHECK(token.find_first_not_of("0123456789abcdef") == std::string::npos);
    tokens.insert(token);
  }
  CHECK(tokens.size() == 100);
}

}  // namespace
}  // namespace plsc::server
