#pragma once

// The top level, which goes on after an error. An item that fails is given up
// as a whole, and parsing resumes at the next line that starts with the
// keyword of an item: no symbol can be such a word, so the rest of a broken
// production never looks like an item. (Resuming at a '}' was tried by others
// and reports the rest of the item again.)

#include "grammar/builder.h"
#include "grammar/rules.h"

namespace plsc::grammar {

// Rules are spelled as PEGTL spells its own.
// NOLINTBEGIN(readability-identifier-naming)
// clang-format off
struct line            : sor<one<'\n'>, seq<plus<not_one<'\n'>>, opt<one<'\n'>>>> {};
struct item_start      : seq<star<one<' ', '\t'>>, item_keyword> {};
struct skip_to_item    : seq<line, star<not_at<item_start>, line>, star<one<' ', '\t'>>> {};
struct recovering_item : sor<try_catch_type<SyntaxFailure, must<item>>, skip_to_item> {};
struct lost_version    : sor<at<item_keyword>, eof, skip_to_item> {};
struct first_item      : sor<try_catch_type<SyntaxFailure, version>, lost_version> {};
struct file            : seq<opt<utf8::bom>, gap, first_item, until<eof, recovering_item>> {};
// clang-format on
// NOLINTEND(readability-identifier-naming)

}  // namespace plsc::grammar
