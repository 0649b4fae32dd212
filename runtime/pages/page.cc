#include "runtime/pages/page.h"

#include <fmt/format.h>

#include "runtime/pages/bundles.h"
#include "runtime/text/xml.h"

namespace plsc {

namespace {

/// In HTML "</script" ends the data and "<!--" hides that end. In JSON '<'
/// stands in strings alone, where it has this other form.
std::string EscapeJson(std::string_view json) {
  std::string text;
  text.reserve(json.size() + json.size() / 64);
  for (const char c : json) {
    if (c == '<')
      text += "\\u003c";
    else
      text += c;
  }
  return text;
}

// What may be loaded: nothing but what the file itself has. Pictures are data
// of the page, or what it drew. A live page also runs the compiler, as a module
// of its own in a worker, and asks the server that it came from, if any.
std::string PolicyOf(PageKind kind) {
  const bool is_live = kind == PageKind::kLive;
  return fmt::format(
      "default-src 'none'; script-src 'unsafe-inline'{}; "
      "style-src 'unsafe-inline'; img-src data: blob:{}",
      is_live ? " 'wasm-unsafe-eval'" : "",
      is_live ? "; worker-src blob:; connect-src 'self'" : "");
}

}  // namespace

std::string PageHtml(PageKind kind, std::string_view title,
                     std::string_view json) {
  const Bundle bundle = BundleOf(kind);
  return fmt::format(
      R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="generator" content="plsc">
<title>{}</title>
<link rel="icon" href="data:,">
<style>
{}</style>
</head>
<body>
<noscript>This page shows its data with JavaScript, which is switched off.
</noscript>
<script type="application/json" id="data">{}</script>
<script>
{}</script>
</body>
</html>
)",
      PolicyOf(kind), EscapeXml(title), bundle.style, EscapeJson(json),
      bundle.script);
}

}  // namespace plsc
