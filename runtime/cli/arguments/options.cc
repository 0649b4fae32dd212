#include "runtime/cli/arguments/options.h"

#include <CLI/CLI.hpp>

namespace plsc::cli {

Option Option::Required() const {
  return Option(option_->required());
}

Option Option::ValueName(const char* name) const {
  return Option(option_->option_text(name));
}

Option Option::Range(int least, int most) const {
  return Option(option_->check(CLI::Range(least, most)));
}

Option Option::Range(double least, double most) const {
  return Option(option_->check(CLI::Range(least, most)));
}

Option Option::NotNegative() const {
  return Option(option_->check(CLI::NonNegativeNumber));
}

Option Option::OneOf(const std::vector<std::string>& words) const {
  return Option(option_->check(CLI::IsMember(words)));
}

Option Option::Check(std::string (*problem)(const std::string& value)) const {
  return Option(option_->check(problem));
}

Option Option::SplitAt(char mark) const {
  return Option(option_->delimiter(mark));
}

Option Option::Count(int least, int most) const {
  return Option(option_->expected(least, most));
}

Option Option::Excludes(Option other) const {
  return Option(option_->excludes(other.option_));
}

Option Option::Needs(Option other) const {
  return Option(option_->needs(other.option_));
}

void Options::Group(const char* name, const char* summary, const char* footer) {
  const auto groups = app_->get_subcommands(
      [&](const CLI::App* below) { return below->get_name() == name; });
  if (!groups.empty()) {
    app_ = groups.front();
    return;
  }
  app_ = app_->add_subcommand(name, summary);
  app_->require_subcommand(1);
  app_->footer(footer);
}

void Options::Command(const char* name, const char* summary) {
  app_ = app_->add_subcommand(name, summary);
}

void Options::Footer(const char* text) {
  app_->footer(text);
}

Option Options::Add(const char* names, std::string& value,
                    const std::string& help) {
  return Option(app_->add_option(names, value, help));
}

Option Options::Add(const char* names, std::vector<std::string>& values,
                    const std::string& help) {
  return Option(app_->add_option(names, values, help));
}

Option Options::Add(const char* names, int& value, const std::string& help) {
  return Option(app_->add_option(names, value, help));
}

Option Options::Add(const char* names, std::optional<int>& value,
                    const std::string& help) {
  return Option(app_->add_option(names, value, help));
}

Option Options::Add(const char* names, std::uint64_t& value,
                    const std::string& help) {
  return Option(app_->add_option(names, value, help));
}

Option Options::Add(const char* names, std::optional<std::uint64_t>& value,
                    const std::string& help) {
  return Option(app_->add_option(names, value, help));
}

Option Options::Add(const char* names, double& value, const std::string& help) {
  return Option(app_->add_option(names, value, help));
}

Option Options::Add(const char* names, std::optional<double>& value,
                    const std::string& help) {
  return Option(app_->add_option(names, value, help));
}

Option Options::Add(const char* names,
                    const std::function<void(const std::string&)>& take,
                    const std::string& help) {
  return Option(app_->add_option_function<std::string>(names, take, help));
}

Option Options::Flag(const char* names, bool& value, const std::string& help) {
  return Option(app_->add_flag(names, value, help));
}

Option Options::AddChoice(const char* names, std::function<void(int)> take,
                          const std::string& help,
                          const std::map<std::string, int>& words,
                          const std::string& value_name) {
  // Its own description has the numbers behind the words.
  CLI::CheckedTransformer numbers(words);
  numbers.description("");
  return Option(app_->add_option_function<int>(
                        names,
                        [take = std::move(take)](int number) { take(number); },
                        help)
                    ->transform(numbers)
                    ->type_name(value_name)
                    ->option_text(value_name));
}

}  // namespace plsc::cli
