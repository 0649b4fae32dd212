// One message in, all answers out; what takes long waits for Idle, in which one
// document is published or one genotype linted at a time. A client that types
// faster than we compile sends several messages before the next Idle, and only
// the last text is looked at. Nothing a client sends ends the server: faults
// become answers or messages, and requests are answered in order, so there is
// nothing to cancel.

#include "runtime/lsp/server.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <variant>

#include "runtime/lsp/advice.h"
#include "runtime/lsp/capabilities.h"
#include "runtime/lsp/diagnostics.h"
#include "runtime/lsp/params.h"
#include "runtime/lsp/requests.h"
#include "runtime/lsp/rpc.h"
#include "runtime/lsp/workspace.h"

namespace plsc::lsp {

namespace {

std::string PublishBody(Json params) {
  return NotificationBody("textDocument/publishDiagnostics", std::move(params));
}

std::string ErrorMessageBody(const std::string& message) {
  constexpr int kErrorMessage = 1;  // LSP's MessageType
  return NotificationBody("window/showMessage",
                          {{"type", kErrorMessage}, {"message", message}});
}

}  // namespace

class Server::Session {
 public:
  explicit Session(std::string version) : version_(std::move(version)) {}

  std::vector<std::string> Handle(std::string_view body) {
    auto parsed = ParseMessage(body);
    if (auto* error = std::get_if<std::string>(&parsed))
      return {std::move(*error)};
    if (const auto* message = std::get_if<Message>(&parsed)) {
      if (message->is_request())
        Answer(*message);
      else
        Take(*message);
    }
    return std::exchange(workspace_.outgoing, {});
  }

  bool has_work() const {
    return phase_ == Phase::kRunning &&
           std::any_of(
               documents().begin(), documents().end(), [&](const auto& entry) {
                 return !entry.second.is_published || WantsAdvice(entry.second);
               });
  }

  std::vector<std::string> Idle() {
    if (phase_ != Phase::kRunning) return {};
    for (auto& [uri, document] : workspace_.documents.all()) {
      if (document.is_published) continue;
      document.is_published = true;
      return {Published(document)};
    }
    for (auto& [uri, document] : workspace_.documents.all()) {
      if (!WantsAdvice(document)) continue;
      GiveMoreAdvice(*document.analysis, &document.advice);
      if (!document.advice.is_whole || document.advice.found.empty()) return {};
      return {Published(document)};
    }
    return {};
  }

  std::optional<int> exit_status() const { return exit_status_; }

 private:
  enum class Phase { kFresh, kRunning, kShutDown };

  const std::map<std::string, Document>& documents() const {
    return workspace_.documents.all();
  }

  bool WantsAdvice(const Document& document) const {
    return workspace_.settings.lint && !document.advice.is_whole;
  }

  static std::string Published(Document& document) {
    return PublishBody(PublishedJson(*document.analysis, document.version,
                                     document.advice.found));
  }

  void Send(std::string body) {
    workspace_.outgoing.push_back(std::move(body));
  }

  void Answer(const Message& message) {
    try {
      Json result = ResultOf(message);
      Send(ResponseBody(message.id, std::move(result)));
    } catch (const Fault& fault) {
      Send(ErrorBody(message.id, fault.code(), fault.what()));
    } catch (const Json::exception& error) {
      // The door of the JSON library: a type that nobody looked at before.
      Send(ErrorBody(message.id, ErrorCode::kInvalidParams, error.what()));
    }
  }

  Json ResultOf(const Message& message) {
    if (message.method == "initialize") return Initialize(message.params);
    if (phase_ == Phase::kFresh)
      throw Fault(ErrorCode::kServerNotInitialized,
                  "expected 'initialize' first");
    if (phase_ == Phase::kShutDown)
      throw Fault(ErrorCode::kInvalidRequest, "expected 'exit' only");
    if (message.method == "shutdown") {
      phase_ = Phase::kShutDown;
      return nullptr;
    }
    const Serve serve = FindRequest(message.method);
    if (serve == nullptr)
      throw Fault(ErrorCode::kMethodNotFound,
                  fmt::format("there is no request '{}'", message.method));
    return serve(workspace_, message.params);
  }

  Json Initialize(const Json& params) {
    if (phase_ != Phase::kFresh)
      throw Fault(ErrorCode::kInvalidRequest, "'initialize' was said before");
    if (!params.is_object())
      throw Fault(ErrorCode::kInvalidParams,
                  "expected params of 'initialize' to be an object");
    workspace_.client = FeaturesOf(params);
    if (const auto options = params.find("initializationOptions");
        options != params.end())
      TakeSettings(*options, &workspace_);
    phase_ = Phase::kRunning;
    return InitializeResult(version_);
  }

  // A notification has no answer; what is wrong with one is shown to the user
  // where it would be lost otherwise.
  void Take(const Message& message) {
    if (message.method == "exit") {
      exit_status_ = phase_ == Phase::kShutDown ? 0 : 1;
      return;
    }
    if (phase_ != Phase::kRunning) return;
    try {
      TakeRunning(message);
    } catch (const Fault& fault) {
      Send(ErrorMessageBody(
          fmt::format("plsc: {}: {}", message.method, fault.what())));
    } catch (const Json::exception& error) {
      Send(ErrorMessageBody(
          fmt::format("plsc: {}: {}", message.method, error.what())));
    }
  }

  void TakeRunning(const Message& message) {
    if (message.method == "textDocument/didOpen") {
      workspace_.documents.Open(message.params);
    } else if (message.method == "textDocument/didChange") {
      workspace_.documents.Change(message.params);
    } else if (message.method == "textDocument/didClose") {
      // What was said of it is taken back: the file is as it is on disk.
      Send(PublishBody({{"uri", workspace_.documents.Close(message.params)},
                        {"diagnostics", Json::array()}}));
    } else if (message.method == "workspace/didChangeConfiguration") {
      const Json& settings = ReadKey(message.params, "settings");
      if (settings.is_object() && settings.contains("plsc") &&
          TakeSettings(settings["plsc"], &workspace_))
        workspace_.RefreshHints();
    }
    // Others ($/cancelRequest, initialized, didSave, ...) ask for nothing:
    // requests are answered in order, so that none is left to cancel.
  }

  std::string version_;
  Phase phase_ = Phase::kFresh;
  Workspace workspace_;
  std::optional<int> exit_status_;
};

std::string BrokenBody(const std::string& why) {
  return ErrorBody(nullptr, ErrorCode::kParseError, why);
}

Server::Server(std::string version)
    : session_(std::make_unique<Session>(std::move(version))) {}
Server::~Server() = default;

std::vector<std::string> Server::Handle(std::string_view body) {
  return session_->Handle(body);
}

bool Server::has_work() const {
  return session_->has_work();
}

std::vector<std::string> Server::Idle() {
  return session_->Idle();
}

std::optional<int> Server::exit_status() const {
  return session_->exit_status();
}

}  // namespace plsc::lsp
