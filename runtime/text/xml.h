#pragma once

// XML for other programs to read: a tree of elements, and its text, two blanks
// a level. Writes only; names of elements and attributes are ours, values may
// be any text.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace plsc {

/// For text and attributes of XML; control characters are left out, which XML
/// cannot hold.
std::string EscapeXml(std::string_view text);

/// How XML writes a character of its own; empty for all others.
std::string_view XmlEntity(char c);

struct XmlElement {
  std::string name;
  std::vector<std::pair<std::string, std::string>> attributes = {};
  std::vector<XmlElement> children = {};
  std::string text = {};  ///< only where there are no children
};

/// An element that is printed as a comment; each line of it on its own line.
XmlElement XmlComment(std::string text);
/// "<name>text</name>".
XmlElement XmlText(std::string name, std::string text);

/// The file of that root, with XML's first line.
std::string PrintXml(const XmlElement& root);

}  // namespace plsc
