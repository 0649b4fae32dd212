// How long after a keystroke the language server has told its diagnostics:
// characters typed at random places of files of 5,000 lines, one message in,
// one message out. Reports; asserts nothing.
//
//   lsp_bench [--smoke]

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "compiler/print.h"
#include "runtime/lsp/server.h"
#include "runtime/vary/initialise.h"

namespace plsc {
namespace {

using Json = nlohmann::json;

// Any; the same files and places each time.
constexpr std::uint64_t kSeed = 20200217;
// What the issue asks for.
constexpr std::size_t kLines = 5000;
// A few seconds each.
constexpr int kKeystrokes = 500;
constexpr const char* kUri = "file:///bench.pls";

std::size_t LinesOf(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

Genotype Draw(std::size_t index) {
  Rng rng({kSeed, 0, index, Purpose::kInitialise});
  Genotype genotype = Initialise({}, rng);
  genotype.name = fmt::format("random_{}", index);
  return genotype;
}

// A collection: many genotypes of the paper's kind, one after the other.
std::string ManyGenotypes() {
  std::string text;
  for (std::size_t index = 0; LinesOf(text) < kLines; ++index) {
    std::string printed = Print(Draw(index));
    // `plsc 1` stands once.
    if (index > 0) printed.erase(0, printed.find('\n') + 1);
    text += printed;
  }
  return text;
}

// One genotype with the rules of many.
std::string ManyRules() {
  Genotype large = Draw(0);
  for (std::size_t index = 1; LinesOf(Print(large)) < kLines; ++index) {
    const Genotype more = Draw(index);
    large.rules.insert(large.rules.end(), more.rules.begin(), more.rules.end());
  }
  large.max_rules.reset();
  std::stable_sort(
      large.rules.begin(), large.rules.end(),
      [](const Rule& a, const Rule& b) { return a.head < b.head; });
  return Print(large);
}

std::string Body(const char* method, Json params, int id = 0) {
  Json body = {{"jsonrpc", "2.0"}, {"method", method}};
  body["params"] = std::move(params);
  if (id != 0) body["id"] = id;
  return body.dump();
}

double Milliseconds() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double, std::milli>(now).count();
}

struct Times {
  std::vector<double> diagnostics;  // ms, from a keystroke
  std::vector<double> advice;       // ms, of what follows
};

class Typist {
 public:
  explicit Typist(const std::string& text) : lines_(LinesOf(text)) {
    server_.Handle(Body("initialize", {{"capabilities", Json::object()}}, 1));
    Json document = {{"uri", kUri}, {"languageId", "pls"}, {"version", 1}};
    document["text"] = text;
    server_.Handle(Body("textDocument/didOpen", {{"textDocument", document}}));
    while (server_.has_work()) server_.Idle();
  }

  // A character is typed and, with the next stroke, deleted again: files are
  // broken half of the time.
  Times Type(int strokes) {
    Times times;
    for (int i = 0; i < strokes; i += 2) {
      const auto line =
          std::uniform_int_distribution<std::size_t>(0, lines_ - 1)(random_);
      const char key = static_cast<char>(
          std::uniform_int_distribution<int>('!', '~')(random_));
      Stroke(line, 0, std::string(1, key), &times);
      Stroke(line, 1, "", &times);
    }
    return times;
  }

 private:
  void Stroke(std::size_t line, int removed, const std::string& text,
              Times* times) {
    Json change;
    change["range"]["start"] = {{"line", line}, {"character", 2}};
    change["range"]["end"] = {{"line", line}, {"character", 2 + removed}};
    change["text"] = text;
    const std::string body =
        Body("textDocument/didChange",
             {{"textDocument", {{"uri", kUri}, {"version", ++version_}}},
              {"contentChanges", Json::array({change})}});
    const double begin = Milliseconds();
    server_.Handle(body);
    bytes_ += server_.Idle().front().size();
    const double told = Milliseconds();
    times->diagnostics.push_back(told - begin);
    while (server_.has_work()) server_.Idle();
    times->advice.push_back(Milliseconds() - told);
  }

  lsp::Server server_{"bench"};
  std::size_t lines_;
  std::mt19937 random_{20200217};
  int version_ = 1;
  std::size_t bytes_ = 0;
};

double Quantile(std::vector<double> times, double share) {
  std::sort(times.begin(), times.end());
  const auto last = static_cast<double>(times.size() - 1);
  return times[static_cast<std::size_t>(share * last)];
}

void Row(const char* what, const std::vector<double>& times) {
  fmt::print("  {:<32}{:8.2f}{:8.2f}{:8.2f}\n", what, Quantile(times, 0.5),
             Quantile(times, 0.99), Quantile(times, 1));
}

void Report(const std::string& text, int strokes) {
  std::size_t genotypes = 0;
  for (std::size_t at = text.find("\ngenotype "); at != std::string::npos;
       at = text.find("\ngenotype ", at + 1))
    ++genotypes;
  fmt::print("genotypes: {}, {} lines, {:.0f} KB, {} keystrokes\n", genotypes,
             LinesOf(text), static_cast<double>(text.size()) / 1000, strokes);
  fmt::print("  {:<32}{:>8}{:>8}{:>8}\n", "ms", "p50", "p99", "most");
  const Times times = Typist(text).Type(strokes);
  Row("keystroke to diagnostics", times.diagnostics);
  Row("advice (lint), when idle", times.advice);
}

}  // namespace
}  // namespace plsc

int main(int argc, char** argv) {
  const bool is_smoke = argc > 1 && std::strcmp(argv[1], "--smoke") == 0;
  const int strokes = is_smoke ? 4 : plsc::kKeystrokes;
  plsc::Report(plsc::ManyGenotypes(), strokes);
  plsc::Report(plsc::ManyRules(), strokes);
  return 0;
}
