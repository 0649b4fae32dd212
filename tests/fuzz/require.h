#pragma once

// What all fuzz targets share: how a broken promise stops the fuzzer, and the
// promises that every diagnostic keeps. A target is one function,
// LLVMFuzzerTestOneInput; libFuzzer calls it with inputs that it makes up
// (.ci/fuzz), replay_main.cc with the files of tests/fuzz/corpus.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "grammar/diagnostic.h"
#include "grammar/source.h"

namespace plsc::fuzz {

/// Aborts with `what`, which is a sentence that should have been true. assert()
/// would do, but must not depend on how the fuzzer is built.
void Require(bool holds, const char* what);

/// The input as a text called "fuzz".
Source AsSource(const std::uint8_t* data, std::size_t size);

/// Codes that users may see, places inside the text, and a rendering of the
/// first few.
void RequireSound(const std::vector<Diagnostic>& diagnostics,
                  const Source& source);

}  // namespace plsc::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size);
