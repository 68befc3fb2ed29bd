// SPDX-License-Identifier: BSD-3-Clause
// getopt_long() splits the command line into options, values and operands; values are checked and
// messages are written here.
#include <getopt.h>

#include <algorithm>
#include <map>

#include "base/files/system.hpp"
#include "base/text/did_you_mean.hpp"
#include "common/cli/command.hpp"
#include "common/cli/pages.hpp"
#include "common/cli/process.hpp"
#include "common/files/output.hpp"

namespace smurf::tools {
namespace {

class CommandLine {
 public:
  explicit CommandLine(const Command& command) : command_(command), options_(command.options) {
    const auto standard = standard_options();
    options_.insert(options_.end(), standard.begin(), standard.end());
    values_.resize(options_.size());
  }

  /// Returns an error message, or nullopt.
  std::optional<std::string> parse(const std::vector<std::string>& given) {
    if (auto wrong = split(given)) return wrong;
    if (has("help") || has("version")) return std::nullopt;
    if (has("generate")) return set(options_[index_of("generate")], value_of("generate"));
    for (std::size_t i = 0; i < options_.size(); ++i) {
      for (const std::string& value : values_[i]) {
        if (options_[i].help_page != nullptr && value == "help") {
          page_ = options_[i].help_page();
          return std::nullopt;
        }
        if (auto wrong = set(options_[i], value)) return wrong;
      }
    }
    for (const std::string& operand : operands_) {
      if (!command_.set_operand) return "unexpected argument '" + operand + "'";
      if (auto wrong = command_.set_operand(sys::from_user(operand))) return wrong;
    }
    return std::nullopt;
  }

  bool has(std::string_view name) const { return !values_[index_of(name)].empty(); }

  /// The page to print for a value "help", or "".
  const std::string& page() const { return page_; }

  /// Precondition: has(name).
  const std::string& value_of(std::string_view name) const {
    return values_[index_of(name)].back();
  }

 private:
  /// The codes that getopt_long() returns for long options; smaller ones are letters.
  static constexpr int kFirstLong = 256;
  static constexpr int kOperand = 1;

  static std::string long_name(const Option& option) { return "--" + std::string(option.name); }

  static int value_kind(const Option& option) {
    if (option.metavar.empty()) return no_argument;
    return option.may_omit_value ? optional_argument : required_argument;
  }

  std::size_t index_of(std::string_view name) const {
    const auto found = std::find_if(options_.begin(), options_.end(),
                                    [&](const Option& option) { return option.name == name; });
    return static_cast<std::size_t>(found - options_.begin());
  }

  /// Precondition: the code of an option of the table.
  std::size_t index_of(int code) const {
    if (code >= kFirstLong) return to_size(code - kFirstLong);
    const auto found = std::find_if(options_.begin(), options_.end(),
                                    [&](const Option& option) { return option.letter == code; });
    return static_cast<std::size_t>(found - options_.begin());
  }

  /// Sets values_ and operands_.
  std::optional<std::string> split(const std::vector<std::string>& given) {
    // "-": operands keep their position; ":": report a missing value as our own message.
    std::string letters = "-:";
    std::vector<std::string> names(options_.size());
    std::vector<option> table;
    for (std::size_t i = 0; i < options_.size(); ++i) {
      const int kind = value_kind(options_[i]);
      names[i] = options_[i].name;
      table.push_back({names[i].c_str(), kind, nullptr, kFirstLong + static_cast<int>(i)});
      if (options_[i].letter == 0) continue;
      letters += options_[i].letter;
      if (kind == required_argument) letters += ':';
    }
    table.push_back({});
    std::vector<std::string> copies = given;  // getopt_long() may write into them
    std::vector<char*> arguments;
    for (std::string& copy : copies) arguments.push_back(copy.data());
    arguments.push_back(nullptr);
    const int argc = static_cast<int>(given.size());
    opterr = 0;
    optind = 0;  // a process may parse several command lines
    for (int at = 1;; at = optind) {
      optarg = nullptr;
      const int code = getopt_long(argc, arguments.data(), letters.c_str(), table.data(), nullptr);
      if (code == -1 && optind == at && at < argc && given[to_size(at)] == "-") {
        operands_.emplace_back("-");  // where the C library of WebAssembly stops
        ++optind;
      } else if (code == -1) {
        break;
      } else if (code == kOperand) {
        operands_.emplace_back(optarg);
      } else {
        const bool is_next = optarg != nullptr && optarg == arguments[to_size(at) + 1];
        if (auto wrong = take(code, copies[to_size(at)], is_next)) return wrong;
      }
    }
    operands_.insert(operands_.end(), given.begin() + std::min(optind, argc), given.end());
    return std::nullopt;
  }

  static std::size_t to_size(int index) { return static_cast<std::size_t>(index); }

  /// Stores the option of an argument, or returns an error message. `is_next`: its value is the
  /// next argument.
  std::optional<std::string> take(int code, const std::string& argument, bool is_next) {
    if (code == '?' && optopt >= kFirstLong) {
      return long_name(options_[index_of(optopt)]) + " takes no value";
    }
    if (code == '?') return unknown(argument);
    if (code == ':') return missing_value(options_[index_of(optopt)]);
    const std::size_t index = index_of(code);
    const Option& option = options_[index];
    // getopt_long() also accepts the beginning of a name, which may mean another option in a later
    // version.
    if (code >= kFirstLong && argument.substr(0, argument.find('=')) != long_name(option)) {
      return unknown(argument);
    }
    const std::string_view value = optarg != nullptr ? optarg : "";
    if (is_next && is_like_option(value)) return missing_value(option);
    values_[index].emplace_back(value);
    return std::nullopt;
  }

  /// "-" is a file and "-1" a number.
  static bool is_like_option(std::string_view value) {
    return value.size() > 1 && value[0] == '-' && (value[1] < '0' || value[1] > '9');
  }

  static std::string missing_value(const Option& option) {
    return long_name(option) + " needs a value: " + std::string(option.metavar);
  }

  static std::optional<std::string> set(const Option& option, std::string_view value) {
    const bool is_left_out = option.metavar.empty() || (option.may_omit_value && value.empty());
    const auto& allowed = option.values;
    if (!allowed.empty() && !is_left_out &&
        std::find(allowed.begin(), allowed.end(), value) == allowed.end()) {
      const bool is_hinted = option.hint && did_you_mean(value, allowed).empty();
      return long_name(option) + ": " + none_of(value, allowed) +
             (is_hinted ? option.hint(value) : "");
    }
    if (!option.set) return std::nullopt;
    auto wrong = is_path(option) ? option.set(sys::from_user(value)) : option.set(value);
    if (wrong) *wrong = long_name(option) + ": " + *wrong;
    return wrong;
  }

  /// Whether the value of an option is a path.
  static bool is_path(const Option& option) {
    return option.metavar == "FILE" || option.metavar == "DIR" || option.metavar == "PATH";
  }

  std::string unknown(const std::string& argument) const {
    const std::string name = argument.substr(0, argument.find('='));
    std::vector<std::string> names;
    for (const Option& option : all_options(command_)) names.push_back(long_name(option));
    const std::vector<std::string_view> known(names.begin(), names.end());
    const std::string hint = did_you_mean(name, known);
    return "unknown option '" + name + "'" + (hint.empty() ? " (see --help)" : hint);
  }

  const Command& command_;
  std::vector<Option> options_;
  std::vector<std::vector<std::string>> values_;  ///< by option, as written
  std::vector<std::string> operands_;
  std::string page_;
};

}  // namespace

std::optional<ExitCode> parse_command_line(const Command& command, int argc,
                                           const char* const* argv) {
  CommandLine line(command);
  if (auto wrong = line.parse(arguments_of(argc, argv))) {
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
