#pragma once

// What a compilation may be asked to let pass.

namespace plsc {

struct CompileOptions {
  /// Arguments outside their declared range become warnings (P2004).
  bool allow_out_of_range = false;
};

}  // namespace plsc
