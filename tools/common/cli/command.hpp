// SPDX-License-Identifier: BSD-3-Clause
// A command line as data: the parser, --help, manual pages and shell completions use it.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace smurf::tools {

inline constexpr std::string_view kVersion = SMURF_VERSION;
inline constexpr std::string_view kSite = SMURF_SITE;

/// The exit code of a tool; it does not depend on the output format.
using ExitCode = int;
inline constexpr ExitCode kDone = 0;      ///< nothing at or above the threshold
inline constexpr ExitCode kFindings = 1;  ///< findings at or above it, or a result refused for them
inline constexpr ExitCode kFailed = 2;    ///< could not do the job

/// Sets a value as written ("" for a flag, or an omitted value); returns an error message: "'x' is
/// not a number".
using Setter = std::function<std::optional<std::string>(std::string_view value)>;

struct Option {
  std::string_view group{};    ///< heading in --help; "": not shown there
  char letter = 0;             ///< 'o' for -o; 0: none
  std::string_view name{};     ///< "output" for --output
  std::string_view metavar{};  ///< "FILE"; "": a flag
  bool may_omit_value = false;
  std::string_view help{};
  std::vector<std::string_view> values{};                 ///< allowed values; empty: any
  std::string (*hint)(std::string_view value) = nullptr;  ///< about another value
  std::vector<std::string_view> (*suggestions)() =
      nullptr;  ///< suggested values for completions, if any value is allowed
  std::vector<std::string_view> levels{};  ///< for completions of ID=LEVEL: the values after "="
  std::string (*help_page)() = nullptr;    ///< the text that the value "help" prints
  Setter set{};
};

struct Example {
  std::string_view command;
  std::string_view does;
};

/// The first word of a command line that runs another program.
struct VerbName {
  std::string_view name;  ///< "check"
  std::string_view tool;  ///< "smurf-lint"
  std::string_view does;
};

struct Command {
  std::string_view name{};      ///< "smurf-lint"
  std::string_view summary{};   ///< one sentence
  std::string_view operands{};  ///< "[PATH]..."; "": there are none
  std::string_view details{};   ///< description of the operands, and details
  std::vector<Option> options{};
  Setter set_operand{};
  std::vector<VerbName> verbs{};    ///< for completions
  std::vector<Example> examples{};  ///< the two most useful ones first: --help shows two
  std::string_view exit_with_1 = "findings at or above the threshold";
};

/// The options of the command and those of all tools, as --help shows them.
std::vector<Option> all_options(const Command& command);
/// The headings in the order of --help: those of the tool, then those of shared options.
std::vector<std::string_view> option_groups(std::span<const Option> options);
/// --help, --version, and the options for building packages.
std::span<const Option> standard_options();

/// The page of --help, at most 80 columns wide.
std::string help_text(const Command& command);

/// Calls the setters. Returns the exit code if the run ends here: after --help and --version, and
/// after a mistake, which is reported on standard error in one line.
std::optional<ExitCode> parse_command_line(const Command& command, int argc,
                                           const char* const* argv);

/// Setters for plain values. The variables must outlive the command.
Setter set_flag(bool& flag);
Setter set_text(std::string& text);
/// A whole number of at least `least`.
Setter set_number(std::optional<int>& number, int least);

/// Sets `variable` to `value` if the option's word is `word`. Option::values gets the words.
template <class Enum>
Setter choose(Enum& variable, std::vector<std::pair<std::string_view, Enum>> words) {
  return [&variable, words = std::move(words)](std::string_view value) {
    for (const auto& [word, meaning] : words) {
      if (word == value) variable = meaning;
    }
    return std::optional<std::string>{};
  };
}

/// The items of "a, b,c"; empty ones are dropped.
std::vector<std::string_view> split_items(std::string_view list);

/// "'x' is not one of a, b, c; did you mean 'a'?"
std::string none_of(std::string_view value, std::span<const std::string_view> known);

}  // namespace smurf::tools
