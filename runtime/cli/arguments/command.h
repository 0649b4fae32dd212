#pragma once

// What the user asked for: one struct a command, filled by arguments.cc, run
// by the function beside it. Only runtime/cli prints, opens files by name and
// reads the clock.

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "runtime/cli/files/io.h"
#include "runtime/exports/export_format.h"

namespace plsc::cli {

enum class OutputFormat : std::uint8_t { kText, kJson };

enum class CheckFormat : std::uint8_t { kText, kJson, kSarif, kGithub };

/// kAuto: when standard error is a terminal and NO_COLOR is not set.
enum class ColorChoice : std::uint8_t { kAuto, kAlways, kNever };

struct CheckCommand {
  std::vector<std::string> files;
  CheckFormat format = CheckFormat::kText;
  bool allow_range = false;
  bool lint = false;
  ColorChoice color = ColorChoice::kAuto;
  int max_errors = 20;  ///< a file, text format only; 0 shows all
};

struct EvaluateCommand {
  bool is_stdin = false;  ///< the only source there is
  std::string scenario;   ///< empty: the paper's
  std::optional<int> jobs;
  bool in_order = false;  ///< answers come in the order of the requests
  bool allow_range = false;
};

struct ExplainCommand {
  std::string code;
  bool list = false;
  OutputFormat format = OutputFormat::kText;
};

struct ExportCommand {
  std::string file;        ///< the store of a run; a genotype file for `to`
  std::string csv_folder;  ///< empty: none
  bool jsonl = false;
  std::optional<ExportFormat> to;         ///< a robot instead of the run
  std::string individual;                 ///< of `to`; as RobotAsked's
  std::vector<std::string> environments;  ///< of `to`; as DevelopCommand's
  std::string scenario;                   ///< of `to`, as RobotAsked's
  bool alone = false;                     ///< of `to`: without floor
  std::string prefix;                     ///< of `to`: before names of parts
  bool allow_range = false;               ///< of `to`
  /// Of --jsonl or --to; empty: standard output. A folder if there are several
  /// environments.
  std::string output;
  bool force = false;  ///< as Output::force
};

struct FixCommand {
  std::vector<std::string> files;
  bool check = false;
  bool diff = false;
  bool allow_range = false;
};

struct FmtCommand {
  std::vector<std::string> files;
  bool check = false;
  bool diff = false;
  bool to_stdout = false;
  bool compact = false;
};

/// Of the evolver's streams of random numbers (runtime/vary/rng.h): those of
/// the child that a run would bear then.
struct StreamChoice {
  std::uint64_t seed = 0;
  std::uint64_t generation = 0;
  std::uint64_t individual = 0;  ///< of the first child; the next has the next
};

enum class Shell : std::uint8_t { kBash, kZsh, kFish };

struct CompletionCommand {
  Shell shell = Shell::kBash;
};

struct CrossCommand {
  std::string first;  ///< whose states, settings and environments stay
  std::string second;
  StreamChoice stream;
  int count = 1;
  std::string experiment;  ///< empty: the paper's
  std::string output;      ///< empty: standard output
  bool force = false;      ///< as Output::force
  OutputFormat format = OutputFormat::kText;
  bool allow_range = false;
};

struct DevelopCommand {
  std::string file;
  std::vector<std::string> environments;  ///< "a=True,b=False" or a name
  OutputFormat format = OutputFormat::kText;
  std::string svg_folder;  ///< empty: none
  bool force = false;      ///< as Output::force
  bool trace = false;
  bool allow_range = false;
};

/// What a module's colour tells.
enum class ColourBy : std::uint8_t { kType, kRule };

struct DiffCommand {
  /// OLD and NEW; what git passes to an external diff with `is_git`.
  std::vector<std::string> files;
  bool is_git = false;
  std::vector<std::string> environments;  ///< as DevelopCommand's
  OutputFormat format = OutputFormat::kText;
  ColorChoice color = ColorChoice::kAuto;
  bool allow_range = false;
};

struct DrawCommand {
  std::string file;        ///< a genotype file, or the store of a run
  std::string individual;  ///< of a run: an id or "best"; else empty
  std::vector<std::string> environments;  ///< as DevelopCommand's
  bool brain = false;
  ColourBy colour = ColourBy::kType;
  std::string output;  ///< an .svg or .png; empty: the terminal
  bool force = false;  ///< as Output::force
  double scale = 2;    ///< pixels of a PNG per px of the SVG
  bool terminal = false;
  bool allow_range = false;
};

struct HashCommand {
  std::vector<std::string> files;
  bool phenotype = false;  ///< of the developed robots, one an environment
  std::vector<std::string> environments;  ///< as DevelopCommand's
  bool allow_range = false;
};

enum class ImportFormat : std::uint8_t { kAuto, kRepr, kLines };

struct ImportCommand {
  std::string file;
  ImportFormat from = ImportFormat::kAuto;
  std::string name;                  ///< of the genotype; empty: the file's
  std::vector<std::string> renames;  ///< "hill=inclined"
  std::string output;                ///< empty: standard output
  bool force = false;                ///< as Output::force
  bool unjoin = false;
  bool allow_range = false;
};

struct LintCommand {
  std::vector<std::string> files;
  OutputFormat format = OutputFormat::kText;
  bool deny = false;
  bool allow_range = false;
};

struct MergeCommand {
  std::string base;
  std::string ours;
  std::string theirs;
  std::string output;               ///< empty: standard output
  bool force = false;               ///< as Output::force
  bool write_ours = false;          ///< instead
  bool is_driver = false;           ///< likewise, as git wants it
  int marker_size = 7;              ///< characters of a conflict marker
  std::string path;                 ///< git's name of the file; empty: `ours`
  std::vector<std::string> labels;  ///< of ours, base, theirs
  bool allow_range = false;
};

struct ManCommand {
  std::vector<std::string> command;  ///< "study", "run"; empty: plsc itself
  std::string all;                   ///< a folder for all pages; empty: none
  bool force = false;                ///< as Output::force
};

struct MutateCommand {
  std::string file;
  StreamChoice stream;
  int count = 1;
  std::string experiment;  ///< empty: the paper's
  std::string output;      ///< empty: standard output
  bool force = false;      ///< as Output::force
  OutputFormat format = OutputFormat::kText;
  bool allow_range = false;
};

/// What some clients say to every server; nothing depends on it.
struct LspCommand {
  bool stdio = true;
  std::string client_process_id;
};

struct RegulateCommand {
  std::string file;
  std::vector<std::string> environments;  ///< as in DevelopCommand
  bool table = false;
  OutputFormat format = OutputFormat::kText;
  bool allow_range = false;
};

struct SimulateCommand {
  std::string file;        ///< a genotype file, or the store of a run
  std::string individual;  ///< of a run: an id or "best"; else empty
  std::string scenario;    ///< empty: the run's, or the paper's
  OutputFormat format = OutputFormat::kText;
  std::string trajectory_folder;  ///< empty: none
  bool descriptors = false;       ///< all of them, text format only
  std::string record;             ///< a file; empty: none
  std::string svg;                ///< likewise
  bool force = false;             ///< as Output::force
};

struct EvolveCommand {
  std::string experiment;  ///< empty: `resume` is not
  std::string output;      ///< likewise
  std::string resume;      ///< the store of a run to go on with
  bool or_resume = false;  ///< goes on if `output` exists
  std::string salvage;     ///< a damaged store to look simulations up in
  bool allow_other_version = false;
  std::optional<std::uint64_t> seed;
  std::optional<int> jobs;
  std::optional<double> hang_limit;  ///< s
  std::string cache;                 ///< a file; empty: none
  std::string json_log;              ///< a file or "-"; empty: none
  bool quiet = false;
  OutputFormat format = OutputFormat::kText;
};

struct ShowCommand {
  std::string run;
  std::string individual;  ///< an id or "best"; empty: the run as a whole
  int lineage = 3;         ///< births back
  bool genotype = false;   ///< its text and nothing else
  bool verify = false;     ///< all of the run
  OutputFormat format = OutputFormat::kText;
};

struct ReplayCommand {
  std::string run;
  std::vector<std::string> individuals;  ///< ids or "best"
  bool all = false;
  std::optional<int> jobs;
  OutputFormat format = OutputFormat::kText;
};

struct RandomCommand {
  std::optional<std::uint64_t> seed;  ///< without `experiment` there is one
  std::optional<int> count;           ///< absent: 1, or the population
  std::string experiment;             ///< a file instead of what follows
  std::string encoding = "plasticoding";
  std::vector<std::string> states{"inclined"};
  int max_groups = 4;
  int max_rules = 2;
  int max_terms = 2;
  std::string output;  ///< empty: standard output
  bool force = false;  ///< as Output::force
};

struct StatsCommand {
  std::vector<std::string> files;
  std::vector<std::string> environments;  ///< as DevelopCommand's
  OutputFormat format = OutputFormat::kText;
  bool allow_range = false;
};

struct TrimCommand {
  std::string file;
  bool write = false;  ///< in place
  std::string output;  ///< empty: standard output, unless `write`
  bool force = false;  ///< as Output::force
  bool check = false;
  std::string scenario;  ///< empty: every environment counts
  OutputFormat format = OutputFormat::kText;
  bool allow_range = false;
};

struct ViewCommand {
  /// Recordings, genotypes, stores of runs; a store is followed by the ids (or
  /// "best") of those of its robots that are meant.
  std::vector<std::string> inputs;
  std::string output;    ///< the page
  bool force = false;    ///< as Output::force
  std::string scenario;  ///< of genotypes; empty: the paper's
  bool explain = false;  ///< the page of development instead, of genotypes
  std::vector<std::string> environments;  ///< of `explain`, as DevelopCommand's
  bool allow_range = false;
};

struct WhyCommand {
  std::string file;        ///< or FILE:LINE:COLUMN, which asks about a symbol
  std::string individual;  ///< of a run: an id or "best"; else empty
  std::string module;      ///< an id to ask about; empty: none
  std::string node;
  std::string edge;
  std::vector<std::string> environments;  ///< as DevelopCommand's
  OutputFormat format = OutputFormat::kText;
  bool allow_range = false;
};

enum class ReportFormat : std::uint8_t { kHtml, kJson };

struct ReportCommand {
  std::vector<std::string> paths;  ///< folders of studies, runs
  std::string output;              ///< empty: standard output, kJson only
  bool force = false;              ///< as Output::force
  std::string measures = "paper";
  ReportFormat format = ReportFormat::kHtml;
  bool verify = false;
  bool quiet = false;
};

enum class TestFormat : std::uint8_t { kText, kJson, kJunit };

struct StudyRunCommand {
  std::string study;
  std::string output;       ///< the study's folder
  std::string only;         ///< "plastic" or "plastic/3"; empty: all
  std::string shard;        ///< "2/8", well formed; empty: all
  std::optional<int> jobs;  ///< of every run
  std::string cache;        ///< a file; empty: none
  bool allow_other_version = false;
  bool quiet = false;
};

struct StudyListCommand {
  std::string study;
  std::string only;   ///< as StudyRunCommand's
  std::string shard;  ///< likewise
  OutputFormat format = OutputFormat::kText;
};

struct StudyStatusCommand {
  std::string folder;
  OutputFormat format = OutputFormat::kText;
};

struct TestCommand {
  std::vector<std::string> paths;
  bool update = false;
  std::optional<int> jobs;
  TestFormat format = TestFormat::kText;
  std::string output;  ///< empty: standard output
  bool force = false;  ///< as Output::force
};

/// What the command line already answered: help, version, or a usage error.
struct Answer {
  Exit exit = Exit::kFine;
  std::string out;
  std::string err;
};

using Command = std::variant<
    Answer, CheckCommand, CompletionCommand, CrossCommand, DevelopCommand,
    DiffCommand, DrawCommand, EvaluateCommand, EvolveCommand, ExplainCommand,
    ExportCommand, FixCommand, FmtCommand, HashCommand, ImportCommand,
    LintCommand, LspCommand, ManCommand, MergeCommand, MutateCommand,
    RandomCommand, RegulateCommand, ReplayCommand, ReportCommand, ShowCommand,
    SimulateCommand, StatsCommand, StudyListCommand, StudyRunCommand,
    StudyStatusCommand, TestCommand, TrimCommand, ViewCommand, WhyCommand>;

/// `arguments` without the program's name.
Command ParseArguments(const std::vector<std::string>& arguments);

/// Of a command line that failed: a word that its writer may have meant as one
/// more value of an option, which takes one each time; how to write that.
/// Empty: there is none.
std::string AdviceOnValues(const std::vector<std::string>& arguments);

Exit Run(const Answer& answer, Io& io);
Exit Run(const CheckCommand& command, Io& io);
Exit Run(const EvaluateCommand& command, Io& io);
Exit Run(const ExplainCommand& command, Io& io);
Exit Run(const ExportCommand& command, Io& io);
Exit Run(const FixCommand& command, Io& io);
Exit Run(const FmtCommand& command, Io& io);
Exit Run(const DevelopCommand& command, Io& io);
Exit Run(const DiffCommand& command, Io& io);
Exit Run(const DrawCommand& command, Io& io);
Exit Run(const LintCommand& command, Io& io);
Exit Run(const MergeCommand& command, Io& io);
Exit Run(const LspCommand& command, Io& io);
Exit Run(const RegulateCommand& command, Io& io);
Exit Run(const ReplayCommand& command, Io& io);
Exit Run(const ReportCommand& command, Io& io);
Exit Run(const ShowCommand& command, Io& io);
Exit Run(const SimulateCommand& command, Io& io);
Exit Run(const StudyListCommand& command, Io& io);
Exit Run(const StudyRunCommand& command, Io& io);
Exit Run(const StudyStatusCommand& command, Io& io);
Exit Run(const EvolveCommand& command, Io& io);
Exit Run(const RandomCommand& command, Io& io);
Exit Run(const ViewCommand& command, Io& io);
Exit Run(const WhyCommand& command, Io& io);
Exit Run(const TestCommand& command, Io& io);
Exit Run(const TrimCommand& command, Io& io);
Exit Run(const StatsCommand& command, Io& io);
Exit Run(const ManCommand& command, Io& io);
Exit Run(const MutateCommand& command, Io& io);
Exit Run(const HashCommand& command, Io& io);
Exit Run(const ImportCommand& command, Io& io);
Exit Run(const CompletionCommand& command, Io& io);
Exit Run(const CrossCommand& command, Io& io);

/// The whole program, as tests call it.
Exit Main(const std::vector<std::string>& arguments, Io& io);

}  // namespace plsc::cli
