#pragma once

// Who may ask. A port of this machine is open to every program of every user of
// it, and to scripts of all pages that a browser shows, so:
// - the address has a token that nobody can guess, as the first part of every
//   path. It is in no header that browsers send elsewhere (Referrer-Policy),
//   and other users of the machine cannot read it.
// - Host is one of ours. A site that has its own name point at 127.0.0.1 (DNS
//   rebinding) is told apart by the name that the browser puts there.
// - Origin, where a browser says it, is ours: scripts of other sites are
//   refused even if they learned the token.

#include <optional>
#include <string>
#include <vector>

#include "runtime/server/message.h"

namespace plsc::server {

/// 128 bits of the system's randomness as 32 hexadecimal digits. Empty: the
/// system has none.
std::string RandomToken();

class Guard {
 public:
  /// `hosts`: what Host may be but for ":PORT": "127.0.0.1", "localhost".
  /// Empty: anything, where the user asked to be reached from elsewhere.
  Guard(std::string token, std::vector<std::string> hosts, int port);

  /// Nothing if it may come in; then `request.target` is what is behind the
  /// token.
  std::optional<Response> Refuse(Request& request) const;

 private:
  bool IsOurs(const std::string& host) const;

  std::string token_;
  std::vector<std::string> hosts_;
  int port_;
};

}  // namespace plsc::server
