#pragma once

// What all pictures share, so that a module looks alike in each of them.

#include <cstddef>
#include <string>
#include <string_view>

#include "sim/body.h"

namespace plsc {

/// The authors' colours, a little lighter so that black text can be read.
std::string_view ModuleColour(ModuleType type);

/// For text and attributes of XML; control characters are left out, which XML
/// cannot hold.
std::string EscapeXml(std::string_view text);

/// Characters of UTF-8, each about as wide as another.
std::size_t LettersOf(std::string_view text);
/// At most so many characters, the last three of a longer text are "...".
std::string Shortened(std::string_view text, std::size_t letters);

/// A fill and the text that can be read on it.
struct InkOn {
  std::string_view fill;
  std::string_view ink;
};
/// For things that are numbered from 0: Okabe and Ito's colours, which the
/// colour-blind tell apart, without black; then again, so also say the number.
InkOn NumberColour(std::size_t number);

}  // namespace plsc
