#pragma once

// What a symbol did in late development, in one sentence for people.

#include <string>

#include "runtime/history/history_view.h"

namespace plsc {

/// "mounted as module 4 at the front of module 2", "not expressed (IV): slot
/// taken by module 3, command kept". The history has a trace.
std::string EventText(const HistoryView& view, StringIndex index);

}  // namespace plsc
