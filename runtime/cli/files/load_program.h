#pragma once

// Reading a genotype file for a command: the same errors whichever command
// asked.

#include <optional>
#include <string>
#include <vector>

#include "compiler/compile.h"
#include "runtime/cli/files/io.h"

namespace plsc::cli {

/// "zoo.pls#gecko": a genotype of a file. Without '#', or where a file has
/// the whole text as its name, the file.
struct GenotypePath {
  std::string file;
  std::string genotype;  ///< empty: the only one of the file
};
GenotypePath SplitGenotypePath(const std::string& path);

/// Reads and compiles what a GenotypePath says; prints what is wrong (and
/// warnings) to io.err.
std::optional<Program> LoadProgram(const std::string& path, bool allow_range,
                                   Io& io);

struct LoadedProgram {
  Source source;
  MappedProgram mapped;
};

/// The same, with the text and where in it each part was written. A place in
/// the text, `at`, chooses the genotype too.
std::optional<LoadedProgram> LoadWithMap(
    const std::string& path, bool allow_range, Io& io,
    const std::optional<Position>& at = std::nullopt);

/// A file and those of its genotypes that are meant: the one behind '#', or
/// all.
struct LoadedFile {
  Source source;
  std::vector<MappedProgram> all;
  std::vector<std::size_t> chosen;  ///< indices into `all`, at least one
};
/// Prints what is wrong, and warnings, to io.err.
std::optional<LoadedFile> LoadFile(const std::string& path, bool allow_range,
                                   Io& io);

/// "zoo.pls#gecko", or the file where it holds one genotype.
std::string PathOf(const LoadedFile& file, std::size_t genotype);

/// Says that development would outgrow its limit in that environment.
void ReportGrowth(const LoadedProgram& loaded, const NamedEnvironment& named,
                  Io& io);

/// The environments that a command line means: each `text` is a name that the
/// file declares, or "state=value,...". Without any: all that the file
/// declares, or the only one when nothing is sensed. Prints what is wrong.
std::optional<std::vector<NamedEnvironment>> ChooseEnvironments(
    const Program& program, const std::vector<std::string>& texts, Io& io);

}  // namespace plsc::cli
