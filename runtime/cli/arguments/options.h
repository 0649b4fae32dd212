#pragma once

// How a command declares what it takes: the door to CLI11. Its templates cost
// seconds in every source that sees them, so only options.cc, arguments.cc and
// description.cc do; commands are declared through this.

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's
class App;
class Option;
}  // namespace CLI

namespace plsc::cli {

/// An option or positional that was added, and what else is to be said of it.
class Option {
 public:
  explicit Option(CLI::Option* option) : option_(option) {}

  Option Required() const;
  /// What help has for its value, as "FILE".
  Option ValueName(const char* name) const;
  Option Range(int least, int most) const;
  Option Range(double least, double most) const;
  Option NotNegative() const;
  Option OneOf(const std::vector<std::string>& words) const;
  /// `problem` is empty of a value that is fine.
  Option Check(std::string (*problem)(const std::string& value)) const;
  /// One word may hold several values.
  Option SplitAt(char mark) const;
  Option Count(int least, int most) const;
  Option Excludes(Option other) const;
  Option Needs(Option other) const;

 private:
  CLI::Option* option_;
};

/// Of one command, which is to be named first. What is added fills a value when
/// the command line is parsed, and leaves it as it is where nothing is typed.
class Options {
 public:
  /// For a command below `parent`.
  explicit Options(CLI::App& parent) : app_(&parent) {}

  /// The command of that name has commands of its own, of which this is one.
  void Group(const char* name, const char* summary, const char* footer);
  /// What is this one called?
  void Command(const char* name, const char* summary);
  /// Prose and examples behind the options.
  void Footer(const char* text);

  /// `names` are "FILE" of a positional, or "-o,--output".
  Option Add(const char* names, std::string& value, const std::string& help);
  Option Add(const char* names, std::vector<std::string>& values,
             const std::string& help);
  Option Add(const char* names, int& value, const std::string& help);
  Option Add(const char* names, std::optional<int>& value,
             const std::string& help);
  Option Add(const char* names, std::uint64_t& value, const std::string& help);
  Option Add(const char* names, std::optional<std::uint64_t>& value,
             const std::string& help);
  Option Add(const char* names, double& value, const std::string& help);
  Option Add(const char* names, std::optional<double>& value,
             const std::string& help);
  Option Add(const char* names,
             const std::function<void(const std::string&)>& take,
             const std::string& help);
  Option Flag(const char* names, bool& value, const std::string& help);

  /// One of some words, in the order in which help has them.
  template <typename Enum>
  requires std::is_enum_v<Enum> Option
  Choice(const char* names, Enum& value, const std::string& help,
         std::initializer_list<std::pair<const char*, Enum>> words) {
    return AddChoice<Enum>(
        names, [&value](int number) { value = static_cast<Enum>(number); },
        help, words);
  }

  /// Likewise, of a value that stays nothing where nothing is typed.
  template <typename Enum>
  Option Choice(const char* names, std::optional<Enum>& value,
                const std::string& help,
                std::initializer_list<std::pair<const char*, Enum>> words) {
    return AddChoice<Enum>(
        names, [&value](int number) { value = static_cast<Enum>(number); },
        help, words);
  }

  const CLI::App& app() const { return *app_; }

 private:
  template <typename Enum>
  Option AddChoice(const char* names, std::function<void(int)> take,
                   const std::string& help,
                   std::initializer_list<std::pair<const char*, Enum>> words) {
    std::string value_name;
    std::map<std::string, int> numbers;
    for (const auto& [word, meant] : words) {
      value_name += (value_name.empty() ? "" : "|") + std::string(word);
      numbers.emplace(word, static_cast<int>(meant));
    }
    return AddChoice(names, std::move(take), help, numbers, value_name);
  }
  Option AddChoice(const char* names, std::function<void(int)> take,
                   const std::string& help,
                   const std::map<std::string, int>& words,
                   const std::string& value_name);

  CLI::App* app_;
};

}  // namespace plsc::cli
