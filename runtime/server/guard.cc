#include "runtime/server/guard.h"

#include <sys/random.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <string_view>

namespace plsc::server {

namespace {

/// In a time that does not tell how many characters are right.
bool IsSame(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  unsigned difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    difference |= static_cast<unsigned char>(a[i]) ^
                  static_cast<unsigned>(static_cast<unsigned char>(b[i]));
  return difference == 0;
}

std::string Lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) {
    return static_cast<char>(std::tolower(c));
  });
  return text;
}

constexpr const char* kWhatToOpen =
    "open the address that plsc live printed, with its token";

}  // namespace

std::string RandomToken() {
  std::array<unsigned char, 16> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) !=
      static_cast<ssize_t>(bytes.size()))
    return "";
  std::string token;
  for (const unsigned byte : bytes) {
    token += "0123456789abcdef"[byte >> 4U];
    token += "0123456789abcdef"[byte & 15U];
  }
  return token;
}

Guard::Guard(std::string token, std::vector<std::string> hosts, int port)
    : token_(std::move(token)), hosts_(std::move(hosts)), port_(port) {}

bool Guard::IsOurs(const std::string& host) const {
  const std::string name = Lower(host);
  const std::string port = ":" + std::to_string(port_);
  return std::any_of(hosts_.begin(), hosts_.end(), [&](const std::string& one) {
    // Browsers leave the port out where it is that of http.
    return name == one + port || (port_ == 80 && name == one);
  });
}

std::optional<Response> Guard::Refuse(Request& request) const {
  if (!hosts_.empty() && !IsOurs(request.host))
    return Refusal(403, "this is no name of this server");
  // A page that was not loaded from a server is of the origin "null".
  if (!request.origin.empty() &&
      Lower(request.origin) != "http://" + Lower(request.host))
    return Refusal(403, "other sites may not ask this server");
  const std::string_view target = request.target;
  const std::size_t end = target.find('/', 1);
  const bool is_root = target.starts_with('/') && end != std::string::npos;
  if (!is_root || !IsSame(target.substr(1, end - 1), token_))
    return Refusal(403, kWhatToOpen);
  request.target = target.substr(end + 1);
  return std::nullopt;
}

}  // namespace plsc::server
