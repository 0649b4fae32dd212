#pragma once

// Bodies and brains as JSON are names of keys for the most part, and would be
// two thirds of a store. Each of the phrases that they repeat is stored as one
// character that JSON of robots does not have; plain SQL (the view `robot`)
// puts the phrases back.

#include <string>
#include <string_view>

namespace plsc {

/// `json` as BodyJson and BrainJson (runtime/develop/phenotype_json.h) write
/// it; without the characters that phrases have.
std::string Pack(std::string_view json);
/// The reverse of Pack; of any other text, a text.
std::string Unpack(std::string_view packed);

/// An SQL expression that does what Unpack does to the expression `packed`.
std::string UnpackSql(const std::string& packed);

}  // namespace plsc
