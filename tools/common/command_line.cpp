// SPDX-License-Identifier: BSD-3-Clause
// CLI11 splits the command line into options and values; names, values and messages are ours. Only
// this file includes the library, because it is slow to compile.
#include <CLI/CLI.hpp>

#include <map>

#include "common/command.hpp"
#include "common/output.hpp"
#include "common/pages.hpp"

namespace smurf::tools {
namespace {

/// The value that CLI11 reports for a flag, and for an option without its optional value.
constexpr std::string_view kNoValue = "true";

class CommandLine {
 public:
  CommandLine(const Command& command, std::vector<std::string> arguments)
      : command_(command), arguments_(std::move(arguments)) {
    app_.set_help_flag();
    app_.allow_extras();
    for (const Option& option : command.options) add_if_written(option);
    for (const Option& option : standard_options()) add_if_written(option);
  }

  /// Returns an error message, or nullopt.
  std::optional<std::string> parse() {
    try {
      app_.parse(std::vector<std::string>(arguments_.rbegin(), arguments_.rend()));
    } catch (const CLI::ParseError& error) {
      return explain(error);
    }
    if (has("help") || has("version")) return std::nullopt;
    if (has("generate")) return set(options_[index_of("generate")], value_of("generate"));
    for (std::size_t i = 0; i < options_.size(); ++i) {
      for (const std::string& value : cli_options_[i]->results()) {
        if (options_[i].help_page != nullptr && value == "help") {
          page_ = options_[i].help_page();
          return std::nullopt;
        }
        if (auto wrong = set(options_[i], value)) return wrong;
      }
    }
    return set_operands();
  }

  bool has(std::string_view name) const {
    const std::size_t index = index_of(name);
    return index < options_.size() && cli_options_[index]->count() > 0;
  }

  /// The page that a value "help" asked for, or "".
  const std::string& page() const { return page_; }

  /// Precondition: has(name).
  std::string value_of(std::string_view name) const {
    return cli_options_[index_of(name)]->results().back();
  }

 private:
  std::size_t index_of(std::string_view name) const {
    const auto found = std::find_if(options_.begin(), options_.end(),
                                    [&](const Option& option) { return option.name == name; });
    return static_cast<std::size_t>(found - options_.begin());
  }

  /// Setting up all options in CLI11 takes as long as checking a small model, so only those that
  /// an argument may mean are set up.
  void add_if_written(const Option& option) {
    const std::string name = "--" + std::string(option.name);
    const bool is_written =
        std::any_of(arguments_.begin(), arguments_.end(), [&](const std::string& argument) {
          return argument.starts_with(name) || (option.letter != 0 && argument.starts_with('-') &&
                                                argument.find(option.letter) != std::string::npos);
        });
    if (!is_written) return;
    options_.push_back(option);
    cli_options_.push_back(add(option));
  }

  CLI::Option* add(const Option& option) {
    std::string names = "--" + std::string(option.name);
    if (option.letter != 0) names += std::string(",-") + option.letter;
    CLI::Option* added =
        option.metavar.empty() ? app_.add_flag(names) : app_.add_option(names)->expected(1);
    if (option.may_omit_value) added->expected(0, 1);
    // CLI11 splits values that look like "[a,b]" unless extra arguments are refused.
    return added->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)->allow_extra_args(false);
  }

  static std::optional<std::string> set(const Option& option, const std::string& written) {
    const std::string name = "--" + std::string(option.name);
    const bool is_left_out = option.may_omit_value && (written == kNoValue || written.empty());
    if (option.metavar.empty() && written != kNoValue) return name + " takes no value";
    const std::string value = option.metavar.empty() || is_left_out ? "" : written;
    const auto& allowed = option.values;
    if (!allowed.empty() && !is_left_out &&
        std::find(allowed.begin(), allowed.end(), value) == allowed.end()) {
      return name + ": " + none_of(value, allowed);
    }
    if (!option.set) return std::nullopt;
    auto wrong = option.set(value);
    if (wrong) *wrong = name + ": " + *wrong;
    return wrong;
  }

  /// The arguments that CLI11 has not used: operands, unknown options, and a "--" that ends
  /// options.
  std::optional<std::string> set_operands() const {
    bool is_option_possible = true;
    for (const std::string& argument : app_.remaining()) {
      if (is_option_possible && argument == "--") {
        is_option_possible = false;
      } else if (is_option_possible && argument.size() > 1 && argument.starts_with('-')) {
        return unknown(argument);
      } else if (!command_.set_operand) {
        return "unexpected argument '" + argument + "'";
      } else if (auto wrong = command_.set_operand(argument)) {
        return wrong;
      }
    }
    return std::nullopt;
  }

  /// The message of a missing value starts with the option's name; nothing else can happen here.
  std::string explain(const CLI::ParseError& error) const {
    const std::string message = error.what();
    const std::string name = message.substr(0, message.find(':'));
    for (const Option& option : options_) {
      if (name == "--" + std::string(option.name)) {
        return name + " needs a value: " + std::string(option.metavar);
      }
    }
    return message;
  }

  std::string unknown(const std::string& argument) const {
    const std::string name = argument.substr(0, argument.find('='));
    std::vector<std::string> names;
    for (const Option& option : all_options(command_)) {
      names.push_back("--" + std::string(option.name));
    }
    const std::vector<std::string_view> known(names.begin(), names.end());
    const std::string hint = did_you_mean(name, known);
    return "unknown option '" + name + "'" + (hint.empty() ? " (see --help)" : hint);
  }

  const Command& command_;
  const std::vector<std::string> arguments_;
  CLI::App app_;
  std::vector<Option> options_;  ///< that the command line may contain
  std::vector<CLI::Option*> cli_options_;
  std::string page_;
};

}  // namespace

std::optional<ExitCode> parse_command_line(const Command& command, int argc,
                                           const char* const* argv) {
  CommandLine line(command, std::vector<std::string>(argv + std::min(argc, 1), argv + argc));
  if (auto wrong = line.parse()) {
    complain(command.name, *wrong);
    return kFailed;
  }
  using Generator = std::string (*)(const Command&);
  static const std::map<std::string_view, Generator> kGenerators = {{"man", manual_page},
                                                                    {"bash", bash_completion},
                                                                    {"zsh", zsh_completion},
                                                                    {"fish", fish_completion},
                                                                    {"markdown", markdown_page}};
  std::string text;
  if (line.has("help")) {
    text = help_text(command);
  } else if (line.has("version")) {
    text = std::string(command.name) + " " + std::string(kVersion) + "\n";
  } else if (line.has("generate")) {
    text = kGenerators.at(line.value_of("generate"))(command);
  } else if (!line.page().empty()) {
    text = line.page();
  } else {
    return std::nullopt;
  }
  return write_output(command.name, "", text) ? kDone : kFailed;
}

}  // namespace smurf::tools
