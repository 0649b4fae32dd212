#pragma once

// The top level, which goes on after an error. An item that fails is given up
// as a whole, and parsing resumes at the next line that starts with the
// keyword of an item: no symbol can be such a word, so the rest of a broken
// production never looks like an item. (Resuming at a '}' was tried by others
// and reports the rest of the item again.)
//
// Within a line more is asked for, because a reserved word there may be a
// mistaken name (`sense rule: bool`) that has been reported: the name behind
// the keyword and the mark behind the name.

#include "grammar/builder.h"
#include "grammar/rules.h"

namespace plsc::grammar {

// Rules are spelled as PEGTL spells its own.
// NOLINTBEGIN(readability-identifier-naming)
// clang-format off
template <typename Keyword, typename... Mark>
struct inline_start    : seq<token<Keyword>, token<identifier>, Mark...> {};
struct inline_item     : sor<inline_start<kw_rule, string<'-', '>'>>,
                             inline_start<kw_environment, one<'{'>>,
                             inline_start<kw_alphabet, sor<digit, one<'{'>>>,
                             inline_start<kw_sense, one<':'>>,
                             inline_start<kw_let, one<'='>>,
                             inline_start<kw_test, sor<string<'-', '>'>, in_word, after_word>>> {};
// A word as a whole, so that no keyword is found at its end.
struct skipped         : sor<seq<one<'#'>, star<not_one<'\n'>>>, plus<identifier_other>, not_one<'\n'>> {};
struct rest_of_line    : star<not_at<inline_item>, skipped> {};
struct item_start      : seq<star<one<' ', '\t'>>, item_keyword> {};
struct next_line       : seq<one<'\n'>, not_at<item_start>, rest_of_line> {};
struct skip_to_item    : seq<skipped, rest_of_line, star<next_line>, opt<one<'\n'>>, star<one<' ', '\t'>>> {};
struct recovering_item : sor<try_catch_type<SyntaxFailure, must<item>>, skip_to_item> {};
struct lost_version    : sor<at<item_keyword>, eof, skip_to_item> {};
struct first_item      : sor<try_catch_type<SyntaxFailure, version>, lost_version> {};
struct file            : seq<opt<utf8::bom>, gap, first_item, until<eof, recovering_item>> {};
// clang-format on
// NOLINTEND(readability-identifier-naming)

}  // namespace plsc::grammar
