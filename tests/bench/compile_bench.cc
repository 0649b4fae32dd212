// How fast text becomes IR and IR becomes text on one core: random genotypes
// of 152 symbols (4.5 KB of canonical text, as an evolver writes them), and one
// valid file just below the limit of 16 MiB with the memory that it takes.
// Reports; asserts nothing.
//
//   compile_bench [--smoke]

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

#include "compiler/compile.h"
#include "compiler/print.h"
#include "grammar/parse.h"
#include "runtime/vary/initialise.h"

namespace plsc {
namespace {

// Any; the same genotypes each time.
constexpr std::uint64_t kSeed = 20200217;
// What the issue calls a genotype: two rules for each of five modules, each
// of three groups of five symbols, and C in front of the rules of C.
constexpr std::size_t kSymbols = 152;
// Enough that they do not fit the second level cache together.
constexpr std::size_t kGenotypes = 400;
// Of the file near the limit (16 MiB, grammar/screen.h).
constexpr std::size_t kLargeBytes = (std::size_t{16} << 20) - 4096;
// What a prototype of the parser with lazy positions did, text to tree.
constexpr const char* kPrototype = "27,000 to 53,000";

std::size_t SymbolCount(const Genotype& genotype) {
  std::size_t count = 0;
  for (const Rule& rule : genotype.rules) count += rule.production.size();
  return count;
}

// The `index`th random genotype that has kSymbols.
Genotype Draw(std::size_t* index) {
  while (true) {
    Rng rng({kSeed, 0, (*index)++, Purpose::kInitialise});
    Genotype genotype = Initialise({}, rng);
    genotype.name = fmt::format("random_{}", *index);
    if (SymbolCount(genotype) == kSymbols) return genotype;
  }
}

std::vector<Genotype> DrawAll(std::size_t count) {
  std::vector<Genotype> genotypes;
  std::size_t index = 0;
  while (genotypes.size() < count) genotypes.push_back(Draw(&index));
  return genotypes;
}

// One genotype that has the rules of many, so that its text has `bytes`.
std::string LargeText(std::size_t bytes) {
  std::size_t index = 0;
  Genotype large = Draw(&index);
  std::size_t printed = Print(large).size();
  while (printed < bytes) {
    const Genotype more = Draw(&index);
    // Its header is counted too, which errs on the safe side of the limit.
    printed += Print(more).size();
    large.rules.insert(large.rules.end(), more.rules.begin(), more.rules.end());
  }
  large.max_rules.reset();
  std::stable_sort(
      large.rules.begin(), large.rules.end(),
      [](const Rule& a, const Rule& b) { return a.head < b.head; });
  return Print(large);
}

// CPU time of this thread: wall time on a shared machine says little.
double CpuSeconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) +
         1e-9 * static_cast<double>(now.tv_nsec);
}

struct Load {
  std::size_t genotypes = 0;
  std::size_t bytes = 0;
};

// `work` does all genotypes once and returns something that depends on them.
void Time(const char* name, const Load& load, double seconds,
          const std::function<std::size_t()>& work) {
  std::size_t sum = work();  // warm up
  // The best round: others ran beside us in the rest.
  double best = 1e9;
  const double begin = CpuSeconds();
  for (double now = begin; now - begin <= seconds;) {
    sum += work();
    const double end = CpuSeconds();
    best = std::min(best, end - now);
    now = end;
  }
  const auto count = static_cast<double>(load.genotypes);
  fmt::print("{:<24} {:>9.0f} genotypes/s {:>7.1f} MB/s {:>7.2f} us  ({})\n",
             name, count / best, 1e-6 * static_cast<double>(load.bytes) / best,
             1e6 * best / count, sum > 0 ? "ok" : "?");
}

void TimeGenotypes(std::size_t count, double seconds) {
  const std::vector<Genotype> genotypes = DrawAll(count);
  std::vector<Source> sources;
  Load load{count, 0};
  for (const Genotype& genotype : genotypes) {
    sources.emplace_back("random", Print(genotype));
    load.bytes += sources.back().text().size();
  }
  fmt::print("{} genotypes of {} symbols, {} bytes each\n", count, kSymbols,
             load.bytes / count);
  Time("source (lines)", load, seconds / 4, [&] {
    std::size_t sum = 0;
    for (const Source& source : sources)
      sum += static_cast<std::size_t>(
          Source(source.name(), std::string(source.text())).line_count());
    return sum;
  });
  Time("parse (text to tree)", load, seconds, [&] {
    std::size_t sum = 0;
    for (const Source& source : sources)
      sum += Parse(source).file.symbols.size();
    return sum;
  });
  Time("compile (text to IR)", load, seconds, [&] {
    std::size_t sum = 0;
    for (const Source& source : sources)
      sum += Compile(source)->genotype.rules.size();
    return sum;
  });
  Time("print (IR to text)", load, seconds, [&] {
    std::size_t sum = 0;
    for (const Genotype& genotype : genotypes) sum += Print(genotype).size();
    return sum;
  });
  fmt::print("{:<24} {:>9} genotypes/s\n", "prototype, parse alone",
             kPrototype);
}

// Runs `work` in a process of its own; returns its peak memory in MB, so that
// it is of that work alone.
double PeakMegabytes(const std::function<void()>& work) {
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0) {
    work();
    std::fflush(stdout);
    _exit(0);
  }
  rusage usage{};
  int status = 0;
  if (child < 0 || wait4(child, &status, 0, &usage) != child || status != 0) {
    fmt::print("the process failed\n");
    return 0;
  }
  return static_cast<double>(usage.ru_maxrss) * 1024e-6;  // KiB
}

std::string ReadAll(std::FILE* file) {
  std::rewind(file);
  std::string text(kLargeBytes + 4096, '\0');
  text.resize(std::fread(text.data(), 1, text.size(), file));
  return text;
}

// Before all else: a child's memory starts with what its parent has.
void MeasureLargeFile(std::size_t bytes) {
  std::FILE* const file = std::tmpfile();
  if (file == nullptr) {
    fmt::print("no temporary file\n");
    return;
  }
  PeakMegabytes([&] {
    const std::string text = LargeText(bytes);
    std::fwrite(text.data(), 1, text.size(), file);
    std::fflush(file);
  });
  const double peak = PeakMegabytes([&] {
    const double begin = CpuSeconds();
    const Source source("large", ReadAll(file));
    const Result<Program> program = Compile(source);
    const double seconds = CpuSeconds() - begin;
    fmt::print("one file of {:.1f} MB, {} rules: {}, {:.2f} s, ",
               1e-6 * static_cast<double>(source.text().size()),
               program ? program->genotype.rules.size() : 0,
               program ? "valid" : program.diagnostics()[0].message, seconds);
  });
  fmt::print("peak {:.0f} MB\n", peak);
  std::fclose(file);
}

}  // namespace
}  // namespace plsc

int main(int argc, char** argv) {
  const bool smoke = argc > 1 && std::strcmp(argv[1], "--smoke") == 0;
  plsc::MeasureLargeFile(smoke ? std::size_t{1} << 20 : plsc::kLargeBytes);
  plsc::TimeGenotypes(smoke ? 4 : plsc::kGenotypes, smoke ? 0 : 2);
  return 0;
}
