#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "runtime/cli/live/live_file.h"
#include "runtime/cli/live/subject.h"
#include "runtime/text/json_dump.h"

namespace plsc::cli {

namespace {

using Value = nlohmann::ordered_json;

Value StateJson(const FileState& state) {
  Value json;
  json["text"] = state.text ? Value(*state.text) : Value(nullptr);
  json["version"] = state.version;
  if (!state.text) json["reason"] = state.reason;
  return json;
}

class FileSubject : public Subject {
 public:
  FileSubject(const std::string& path, const std::string& scenario)
      : file_(path) {
    if (!scenario.empty()) scenario_.emplace(scenario);
  }

  MaybeFailure Check() const {
    for (const LiveFile* one : {&file_, scenario_ ? &*scenario_ : nullptr})
      if (one != nullptr && !one->state().text)
        return Failure("cannot read '" + one->path() +
                       "': " + one->state().reason);
    return std::nullopt;
  }

  std::string Title() const override {
    return std::filesystem::path(file_.path()).filename().string();
  }

  std::string PageData() const override {
    Value json;
    json["robot"] = file_.state().text.value_or("");
    json["name"] = Title();
    json["scenario"] = scenario_ ? scenario_->state().text.value_or("") : "";
    json["server"] = {{"file", file_.state().version}};
    json["follow"] = "file";
    return DumpJson(json);
  }

  std::vector<Event> Standing() const override {
    std::vector<Event> events{{"file", DumpJson(StateJson(file_.state()))}};
    if (scenario_)
      events.emplace_back("scenario", DumpJson(StateJson(scenario_->state())));
    return events;
  }

  std::vector<Event> Look() override {
    std::vector<Event> events;
    if (file_.Look())
      events.emplace_back("file", DumpJson(StateJson(file_.state())));
    if (scenario_ && scenario_->Look())
      events.emplace_back("scenario", DumpJson(StateJson(scenario_->state())));
    return events;
  }

  server::Response Answer(const server::Request& request) override {
    if (request.target != "save")
      return server::Refusal(404, "there is no such thing here");
    if (request.method != "POST")
      return server::Refusal(405, "to save is to POST");
    const Value json = Value::parse(request.body, nullptr, false);
    const auto text_of = [&](const char* key) {
      return json.is_object() && json.contains(key) && json[key].is_string()
                 ? std::optional(json[key].get<std::string>())
                 : std::nullopt;
    };
    const auto text = text_of("text");
    const auto version = text_of("version");
    if (!text || !version)
      return server::Refusal(
          400, "to save takes an object of two texts, text and version");
    return Save(*text, *version);
  }

 private:
  server::Response Save(const std::string& text, const std::string& version) {
    Value json;
    server::Response response;
    const LiveFile::Saved saved = file_.Save(text, version);
    json["ok"] = !saved.is_conflict && !saved.failure;
    if (saved.failure) {
      response.status = 500;
      json["error"] = saved.failure->text;
    } else if (saved.is_conflict) {
      json["error"] = "the file was changed by another program meanwhile";
      json["conflict"] = StateJson(file_.state());
    } else {
      json["version"] = file_.state().version;
    }
    response.body = DumpJson(json);
    return response;
  }

  LiveFile file_;
  std::optional<LiveFile> scenario_;
};

}  // namespace

Expected<std::unique_ptr<Subject>, Failure> JoinFile(
    const std::string& path, const std::string& scenario) {
  auto subject = std::make_unique<FileSubject>(path, scenario);
  if (auto failure = subject->Check()) return *failure;
  return std::unique_ptr<Subject>(std::move(subject));
}

}  // namespace plsc::cli
