#include "runtime/text/xml.h"

#include <catch2/catch.hpp>

namespace plsc {
namespace {

TEST_CASE("text is safe in XML", "[xml]") {
  CHECK(EscapeXml("a<b> & \"c\" \x01\n\u00e9") ==
        "a&lt;b&gt; &amp; &quot;c&quot; \u00e9");
}

TEST_CASE("A tree of elements is printed by level", "[xml]") {
  const XmlElement root{
      "a", {{"b", "1"}}, {{"c"}, XmlText("d", "x"), {"e", {}, {{"f"}}}}};
  CHECK(PrintXml(root) ==
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<a b=\"1\">\n"
        "  <c/>\n"
        "  <d>x</d>\n"
        "  <e>\n"
        "    <f/>\n"
        "  </e>\n"
        "</a>\n");
}

TEST_CASE("Any text is safe in a value and in a comment", "[xml]") {
  struct Row {
    const char* why;
    std::string text;
    const char* value;
    const char* comment;
  };
  const Row rows[] = {
      {"marks", "<\"&'>", "&lt;&quot;&amp;'&gt;", "<\"&'>"},
      {"hyphens end comments", "a--b---", "a--b---", "a- -b- - -"},
      {"control characters are not in XML", std::string("a\0b\x1b", 4), "ab",
       "a b "},
      {"letters of any language", "gr\xc3\xbc\xc3\x9f", "gr\xc3\xbc\xc3\x9f",
       "gr\xc3\xbc\xc3\x9f"},
  };
  for (const Row& row : rows) {
    INFO(row.why);
    CHECK(PrintXml({"a", {{"b", row.text}}})
              .ends_with(std::string("<a b=\"") + row.value + "\"/>\n"));
    CHECK(PrintXml(XmlText("a", row.text))
              .ends_with(std::string("<a>") + row.value + "</a>\n"));
    CHECK(
        PrintXml({"a", {}, {XmlComment(row.text)}})
            .ends_with(std::string("  <!-- ") + row.comment + " -->\n</a>\n"));
  }
}

TEST_CASE("Lines of a comment stand below each other", "[xml]") {
  CHECK(PrintXml({"a", {}, {XmlComment("one\ntwo")}})
            .ends_with("  <!-- one\n       two -->\n</a>\n"));
}

}  // namespace
}  // namespace plsc
