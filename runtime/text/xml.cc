#include "runtime/text/xml.h"

namespace plsc {

std::string_view XmlEntity(char c) {
  switch (c) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    default:
      return "";
  }
}

std::string EscapeXml(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (const std::string_view entity = XmlEntity(c); !entity.empty())
      escaped += entity;
    else if (static_cast<unsigned char>(c) >= ' ')
      escaped += c;
  }
  return escaped;
}

namespace {

// No name of an element, so that it can mark comments.
constexpr const char* kCommentMark = "!";

/// What a comment may hold: no two hyphens in a row, none at its end.
std::string CommentText(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '-' && !safe.empty() && safe.back() == '-') safe += ' ';
    const bool is_control = static_cast<unsigned char>(c) < ' ' && c != '\n';
    safe += is_control ? ' ' : c;
  }
  return safe;
}

void PrintComment(const XmlElement& comment, const std::string& indent,
                  std::string& text) {
  text += indent + "<!-- ";
  for (const char c : CommentText(comment.text)) {
    text += c;
    if (c == '\n') text += indent + "     ";
  }
  text += " -->\n";
}

void Print(const XmlElement& element, std::size_t level, std::string& text) {
  const std::string indent(2 * level, ' ');
  if (element.name == kCommentMark) {
    PrintComment(element, indent, text);
    return;
  }
  text += indent + "<" + element.name;
  for (const auto& [name, value] : element.attributes)
    text += " " + name + "=\"" + EscapeXml(value) + "\"";
  if (element.children.empty() && element.text.empty()) {
    text += "/>\n";
    return;
  }
  text += ">";
  if (element.children.empty()) {
    text += EscapeXml(element.text);
  } else {
    text += "\n";
    for (const XmlElement& child : element.children)
      Print(child, level + 1, text);
    text += indent;
  }
  text += "</" + element.name + ">\n";
}

}  // namespace

XmlElement XmlComment(std::string text) {
  return {kCommentMark, {}, {}, std::move(text)};
}

XmlElement XmlText(std::string name, std::string text) {
  return {std::move(name), {}, {}, std::move(text)};
}

std::string PrintXml(const XmlElement& root) {
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  Print(root, 0, text);
  return text;
}

}  // namespace plsc
