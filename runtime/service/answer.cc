#include "runtime/service/answer.h"

#include <nlohmann/json.hpp>

#include "runtime/text/json_dump.h"

namespace plsc::service {

std::string Quoted(std::string_view text) {
  return DumpJson(nlohmann::ordered_json(text));
}

void Answer::AddMembers(std::string_view members) {
  if (members.empty()) return;
  if (!members_.empty()) members_ += ',';
  members_ += members;
}

void Answer::AddWritten(std::string_view key, std::string_view json) {
  AddMembers(Quoted(key) + ":");
  members_ += json;
}

void Answer::Add(std::string_view key, const nlohmann::ordered_json& value) {
  AddWritten(key, DumpJson(value));
}

}  // namespace plsc::service
