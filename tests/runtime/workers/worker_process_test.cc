#include "runtime/workers/worker_process.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/socket.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <string>

#include "runtime/workers/worker_frame.h"

namespace plsc {

namespace {

std::string Ask(const WorkerProcess& worker, const std::string& request) {
  const std::string frame = Frame(request);
  REQUIRE(send(worker.socket, frame.data(), frame.size(), 0) ==
          static_cast<ssize_t>(frame.size()));
  FrameReader reader;
  while (true) {
    if (auto answer = reader.Take()) return *answer;
    char buffer[100];
    const ssize_t count = recv(worker.socket, buffer, sizeof buffer, 0);
    REQUIRE(count > 0);
    reader.Append({buffer, static_cast<std::size_t>(count)});
  }
}

std::string OpenDescriptors(const std::string&) {
  std::string open;
  for (int i = 0; i < 100; ++i)
    if (fcntl(i, F_GETFD) != -1) open += std::to_string(i) + " ";
  return open;
}

}  // namespace

TEST_CASE("A worker answers until it is ended", "[worker_process]") {
  const auto worker =
      StartWorker([](const std::string& text) { return text + "!"; });
  REQUIRE(worker);
  CHECK(Ask(*worker, "one") == "one!");
  CHECK(Ask(*worker, "two") == "two!");
  CHECK(EndWorker(*worker) == "signal 9");
  CHECK(kill(worker->pid, 0) == -1);
}

TEST_CASE("A worker keeps no file of its owner open", "[worker_process]") {
  const int file = open("/dev/null", O_RDONLY);
  const auto first = StartWorker(OpenDescriptors);
  const auto second = StartWorker(OpenDescriptors);
  REQUIRE(first);
  REQUIRE(second);
  CHECK(Ask(*first, "") == "0 1 2 3 ");
  CHECK(Ask(*second, "") == "0 1 2 3 ");
  EndWorker(*first);
  EndWorker(*second);
  close(file);
}

TEST_CASE("A worker ends by itself when its owner closes the socket",
          "[worker_process]") {
  const auto worker = StartWorker([](const std::string& text) { return text; });
  REQUIRE(worker);
  shutdown(worker->socket, SHUT_WR);
  char byte = 0;
  CHECK(recv(worker->socket, &byte, 1, 0) == 0);
  CHECK(EndWorker(*worker) == "exit status 0");
}

TEST_CASE("A worker does not guess at what is no request", "[worker_process]") {
  const auto worker = StartWorker([](const std::string& text) { return text; });
  REQUIRE(worker);
  const std::string garbage(100, 'x');
  REQUIRE(send(worker->socket, garbage.data(), garbage.size(), 0) == 100);
  char byte = 0;
  CHECK(recv(worker->socket, &byte, 1, 0) <= 0);
  CHECK(EndWorker(*worker) == "exit status 1");
}

TEST_CASE("Handlers of crashes stay with the owner", "[worker_process]") {
  const auto before = signal(SIGSEGV, [](int) { _exit(7); });
  const auto worker = StartWorker([](const std::string& text) {
    raise(SIGSEGV);
    return text;
  });
  signal(SIGSEGV, before);
  REQUIRE(worker);
  const std::string frame = Frame("");
  REQUIRE(send(worker->socket, frame.data(), frame.size(), 0) > 0);
  char byte = 0;
  CHECK(recv(worker->socket, &byte, 1, 0) == 0);
  CHECK(EndWorker(*worker) == "signal 11");
}

}  // namespace plsc
