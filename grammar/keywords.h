#pragma once

// The reserved words. A name (of a symbol, state, constant, ...) is any other
// identifier; names and keywords are case-sensitive.

#include <span>
#include <string_view>

namespace plsc {

/// Words that begin an item; also where parsing resumes after an error.
std::span<const std::string_view> ItemKeywords();

bool IsItemKeyword(std::string_view word);
bool IsKeyword(std::string_view word);

/// A letter, digit or '_': what continues an identifier.
constexpr bool IsWordCharacter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
         (c >= '0' && c <= '9') || c == '_';
}

/// [A-Za-z_][A-Za-z0-9_]* and not a keyword.
bool IsName(std::string_view text);

/// As IsName, but keywords are allowed that begin no item, and `test`: no
/// item refers to a genotype by its name.
bool IsGenotypeName(std::string_view text);

}  // namespace plsc
