#include "runtime/recording/view_json.h"

#include <nlohmann/json.hpp>

#include "runtime/recording/ground_json.h"
#include "runtime/recording/recording_json.h"

namespace plsc {

namespace {

std::string Quoted(const std::string& text) {
  // Names of files may be any bytes; pages hold Unicode.
  return nlohmann::json(text).dump(-1, ' ', false,
                                   nlohmann::json::error_handler_t::replace);
}

// Put together as text: recordings are megabytes, and are written already.
std::string LifeJson(const ViewedLife& life) {
  std::string json = "{\"source\":" + Quoted(life.source) +
                     ",\"remark\":" + Quoted(life.remark) + ",\"grounds\":[";
  for (std::size_t i = 0; i < life.recording.seasons.size(); ++i)
    json += (i > 0 ? "," : "") + GroundJson(life.recording.seasons[i]);
  json += "],\"recording\":" + RecordingJson(life.recording);
  json.back() = '}';  // instead of the newline
  return json;
}

}  // namespace

std::string ViewJson(const std::vector<ViewedLife>& lives) {
  std::string json = "{\"plsc_view\":1,\"lives\":[";
  for (std::size_t i = 0; i < lives.size(); ++i)
    json += (i > 0 ? "," : "") + LifeJson(lives[i]);
  return json + "]}";
}

}  // namespace plsc
