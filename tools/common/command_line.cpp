// SPDX-License-Identifier: BSD-3-Clause
// Cuts the command line into options and values, as getopt_long does, but with our messages.
#include <algorithm>
#include <array>

#include "common/command.hpp"
#include "common/output.hpp"
#include "common/pages.hpp"

namespace smurf::tools {
namespace {

using Words = std::span<const char* const>;

/// `-` alone is an operand: standard input.
bool is_option(std::string_view word) { return word.size() > 1 && word.starts_with('-'); }

std::string_view take_first(Words& words) {
  const std::string_view first = words.front();
  words = words.subspan(1);
  return first;
}

class CommandLine {
 public:
  explicit CommandLine(const Command& command) : command_(command), options_(command.options) {
    for (const Option& option : standard_options()) options_.push_back(option);
    values_.resize(options_.size());
  }

  /// What is wrong, if anything.
  std::optional<std::string> parse(Words words) {
    if (auto wrong = cut(words)) return wrong;
    if (has("help") || has("version")) return std::nullopt;
    if (has("generate")) return set(options_[index_of("generate")], value_of("generate"));
    for (std::size_t i = 0; i < options_.size(); ++i) {
      for (const std::string& value : values_[i]) {
        if (auto wrong = set(options_[i], value)) return wrong;
      }
    }
    return set_operands();
  }

  bool has(std::string_view name) const { return !values_[index_of(name)].empty(); }

  /// Precondition: has(name).
  const std::string& value_of(std::string_view name) const {
    return values_[index_of(name)].back();
  }

 private:
  template <class Is>
  std::size_t index_if(Is is) const {
    const auto found = std::find_if(options_.begin(), options_.end(), is);
    return static_cast<std::size_t>(found - options_.begin());
  }
  std::size_t index_of(std::string_view name) const {
    return index_if([&](const Option& option) { return option.name == name; });
  }

  /// Tells options and their values from what is left.
  std::optional<std::string> cut(Words words) {
    while (!words.empty()) {
      const std::string_view word = take_first(words);
      std::optional<std::string> wrong;
      if (word == "--") {
        left_.emplace_back(word);
        left_.insert(left_.end(), words.begin(), words.end());
        break;
      }
      if (!is_option(word)) {
        left_.emplace_back(word);
      } else if (word.starts_with("--")) {
        wrong = take_long(word, words);
      } else {
        wrong = take_short(word, words);
      }
      if (wrong) return wrong;
    }
    return std::nullopt;
  }

  /// `--name`, `--name=value`.
  std::optional<std::string> take_long(std::string_view word, Words& words) {
    const std::size_t sign = std::min(word.find('='), word.size());
    const std::size_t i = index_of(word.substr(2, sign - 2));
    if (i < options_.size()) {
      return take(i, word.substr(std::min(sign + 1, word.size())), words);
    }
    left_.emplace_back(word);
    return std::nullopt;
  }

  /// `-o`, `-ovalue`, and flags together: `-ab`.
  std::optional<std::string> take_short(std::string_view word, Words& words) {
    for (std::size_t at = 1; at < word.size(); ++at) {
      const std::size_t i =
          index_if([&](const Option& option) { return option.letter == word[at]; });
      if (i == options_.size()) {
        left_.push_back("-" + std::string(word.substr(at)));
        break;
      }
      if (!options_[i].metavar.empty()) return take(i, word.substr(at + 1), words);
      values_[i].emplace_back();
    }
    return std::nullopt;
  }

  /// `value` is the one behind the option in its own word, if any.
  std::optional<std::string> take(std::size_t i, std::string_view value, Words& words) {
    const Option& option = options_[i];
    if (value.empty() && !option.metavar.empty()) {
      const bool is_next = !words.empty() && !(option.may_omit_value && is_option(words.front()));
      if (!is_next && !option.may_omit_value) {
        return "--" + std::string(option.name) + " needs a value: " + std::string(option.metavar);
      }
      if (is_next) value = take_first(words);
    }
    values_[i].emplace_back(value);
    return std::nullopt;
  }

  static std::optional<std::string> set(const Option& option, const std::string& value) {
    const std::string name = "--" + std::string(option.name);
    if (option.metavar.empty() && !value.empty()) return name + " takes no value";
    const bool is_left_out = option.may_omit_value && value.empty();
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

  /// What is left: operands, unknown options and the "--" before which those are sought.
  std::optional<std::string> set_operands() const {
    bool is_option_possible = true;
    for (const std::string& argument : left_) {
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
  std::vector<Option> options_;
  std::vector<std::vector<std::string>> values_;  ///< as written, of each option; "" of a flag
  std::vector<std::string> left_;
};

/// Precondition: `what` is one of the values of --generate.
std::string generate(std::string_view what, const Command& command) {
  struct Generator {
    std::string_view what;
    std::string (*write)(const Command&);
  };
  static constexpr std::array kGenerators{
      Generator{"man", manual_page}, Generator{"bash", bash_completion},
      Generator{"zsh", zsh_completion}, Generator{"fish", fish_completion}};
  const auto* const found =
      std::find_if(kGenerators.begin(), kGenerators.end(),
                   [&](const Generator& generator) { return generator.what == what; });
  return found->write(command);
}

}  // namespace

std::optional<ExitCode> parse_command_line(const Command& command, int argc,
                                           const char* const* argv) {
  CommandLine line(command);
  if (auto wrong = line.parse(Words(argv, static_cast<std::size_t>(argc)).subspan(argc > 0))) {
    complain(command.name, *wrong);
    return kFailed;
  }
  std::string text;
  if (line.has("help")) {
    text = help_text(command);
  } else if (line.has("version")) {
    text = std::string(command.name) + " " + std::string(kVersion) + "\n";
  } else if (line.has("generate")) {
    text = generate(line.value_of("generate"), command);
  } else {
    return std::nullopt;
  }
  return write_output(command.name, "", text) ? kDone : kFailed;
}

}  // namespace smurf::tools
