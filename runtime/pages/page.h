#pragma once

// Pages for a browser, each one file that needs nothing else: no network, no
// server. A page is its data, as JSON, and a program that shows them
// (src/report, src/view, src/explain, src/live), bundled when plsc is built.

#include <string>
#include <string_view>

#include "runtime/pages/page_kind.h"

namespace plsc {

/// Whether this program was built with npm. Without, pages are empty.
bool HasPages();

/// A complete HTML file. `title` may hold any text; `json` is what the page's
/// program finds as the text of the element `data`. A policy in the page keeps
/// browsers from loading anything from elsewhere.
std::string PageHtml(PageKind kind, std::string_view title,
                     std::string_view json);

}  // namespace plsc
