#pragma once

// A client of the service as functions: a request as JSON, the answer as JSON.

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace plsc::test {

using OrderedJson = nlohmann::ordered_json;

/// The bytes of an answer of a new Service; fails the test unless they are one
/// line of JSON, and the same when asked again.
std::string AnsweredText(const OrderedJson& request);
OrderedJson Answered(const OrderedJson& request);

/// The text of the answer's member `key`, as it stands in `answer`. Unlike a
/// parsed value it tells every byte.
bool HoldsBytes(const std::string& answer, const std::string& part);

/// The words of a refusal; fails the test if it is none.
std::string WordsOf(const OrderedJson& request);

/// "gecko.pls" and its text, of all genotypes in examples/.
std::vector<std::pair<std::string, std::string>> ExampleTexts();
std::string ExampleText(const std::string& name);

/// Two short seasons, flat and tilted, that answer what examples sense.
std::string ShortScenario();

}  // namespace plsc::test
