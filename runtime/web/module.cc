// What the page's JavaScript (plsc.js) calls: a service behind C functions. A
// request and its answer are UTF-8; the service owns the memory of both.

#include <cstddef>
#include <string>

#include "runtime/service/service.h"
#include "runtime/text/version.h"

namespace {

struct Session {
  plsc::Service service{plsc::kVersion};
  std::string request;
  std::string answer;
};

}  // namespace

extern "C" {

Session* plsc_open() {
  return new Session;
}

/// Where to write the next request.
char* plsc_request(Session* session, std::size_t bytes) {
  session->request.resize(bytes);
  return session->request.data();
}

/// Its answer, which stays until the next one.
const char* plsc_answer(Session* session) {
  session->answer = session->service.Answer(session->request);
  return session->answer.data();
}

std::size_t plsc_answer_bytes(const Session* session) {
  return session->answer.size();
}

void plsc_close(Session* session) {
  delete session;
}

}  // extern "C"
