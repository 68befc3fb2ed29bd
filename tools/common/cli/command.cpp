// SPDX-License-Identifier: BSD-3-Clause
// The page of --help and the setters for plain values.
#include "common/cli/command.hpp"

#include <algorithm>
#include <limits>

#include "base/numbers/numbers.hpp"
#include "base/text/did_you_mean.hpp"
#include "base/text/lists.hpp"
#include "render/wrap.hpp"

namespace smurf::tools {
namespace {

constexpr std::size_t kColumns = 80;
constexpr std::size_t kHelpColumn = 30;
constexpr std::size_t kExamplesInHelp = 2;

/// Headings of shared options, in the order of --help.
constexpr std::string_view kSharedGroups[] = {"Output", "Exit code", "Input", "General"};

const Option kStandardOptions[] = {
    {.group = "General", .letter = 'h', .name = "help", .help = "Show this page."},
    {.group = "General", .name = "version", .help = "Show the version."},
    {.name = "generate",
     .metavar = "WHAT",
     .help = "A manual page or a completion script, for packages.",
     .values = {"man", "bash", "zsh", "fish", "markdown"}},
};

/// "  -o, --output FILE"
std::string option_head(const Option& option) {
  std::string head = option.letter != 0 ? std::string("  -") + option.letter + ", " : "      ";
  head.append("--").append(option.name);
  if (option.metavar.empty()) return head;
  if (option.may_omit_value) return head.append("[=").append(option.metavar).append("]");
  return head.append(" ").append(option.metavar);
}

std::string option_entry(const Option& option) {
  std::string head = option_head(option);
  const std::string text = render::wrap(option.help, kHelpColumn, kColumns);
  if (head.size() + 2 > kHelpColumn) return head + "\n" + text;
  return head + text.substr(head.size());
}

std::string options_text(std::span<const Option> options, std::string_view group) {
  std::string out = "\n" + std::string(group) + ":\n";
  for (const Option& option : options) {
    if (option.group == group) out += option_entry(option);
  }
  return out;
}

std::string verbs_text(const Command& command) {
  if (command.verbs.empty()) return {};
  std::string out = "\nVerbs:\n";
  for (const VerbName& verb : command.verbs) {
    constexpr std::size_t kIndent = 14;
    std::string head = "  " + std::string(verb.name);
    head.resize(kIndent, ' ');
    out += head + render::wrap(verb.does, kIndent, kColumns).substr(kIndent);
  }
  return out;
}

}  // namespace

std::span<const Option> standard_options() { return kStandardOptions; }

std::vector<Option> all_options(const Command& command) {
  std::vector<Option> options = command.options;
  for (const Option& option : standard_options()) options.push_back(option);
  std::erase_if(options, [](const Option& option) { return option.group.empty(); });
  return options;
}

std::vector<std::string_view> option_groups(std::span<const Option> options) {
  std::vector<std::string_view> groups;
  for (const Option& option : options) {
    if (std::find(groups.begin(), groups.end(), option.group) == groups.end()) {
      groups.push_back(option.group);
    }
  }
  const auto rank_of = [](std::string_view group) {
    const auto* found = std::find(std::begin(kSharedGroups), std::end(kSharedGroups), group);
    return found == std::end(kSharedGroups) ? 0 : found - std::begin(kSharedGroups) + 1;
  };
  std::stable_sort(groups.begin(), groups.end(),
                   [&](std::string_view a, std::string_view b) { return rank_of(a) < rank_of(b); });
  return groups;
}

std::string help_text(const Command& command) {
  std::string usage = "Usage: " + std::string(command.name) + " [OPTION]...";
  if (!command.operands.empty()) usage.append(" ").append(command.operands);
  std::string out = usage + "\n\n" + render::wrap(command.summary, 0, kColumns);
  if (!command.examples.empty()) out += "\nExamples:\n";
  for (const Example& example :
       std::span(command.examples).first(std::min(kExamplesInHelp, command.examples.size()))) {
    out += render::wrap(example.does, 2, kColumns);
    out.append("      ").append(example.command).append("\n");
  }
  if (!command.details.empty()) out += "\n" + render::wrap(command.details, 0, kColumns);

  out += verbs_text(command);
  const std::vector<Option> options = all_options(command);
  for (const std::string_view group : option_groups(options)) {
    out += options_text(options, group);
  }
  out += "\n" + render::wrap("Exit codes: 0 done, 1 " + std::string(command.exit_with_1) +
                                 ", 2 could not do the job",
                             0, kColumns);
  return out + "More examples:\n  " + std::string(kSite) + "/tools/" + std::string(command.name) +
         "/\n";
}

Setter set_flag(bool& flag) {
  return [&flag](std::string_view) {
    flag = true;
    return std::nullopt;
  };
}

Setter set_text(std::string& text) {
  return [&text](std::string_view value) {
    text = value;
    return std::nullopt;
  };
}

Setter set_number(std::optional<int>& number, int least) {
  return [&number, least](std::string_view value) -> std::optional<std::string> {
    const std::optional<std::int64_t> parsed = parse_integer(value);
    if (!parsed || *parsed < least || *parsed > std::numeric_limits<int>::max()) {
      return "'" + std::string(value) + "' is not a whole number of at least " +
             std::to_string(least);
    }
    number = static_cast<int>(*parsed);
    return std::nullopt;
  };
}

std::vector<std::string_view> split_items(std::string_view list) {
  std::vector<std::string_view> items;
  while (true) {
    const std::size_t comma = std::min(list.find(','), list.size());
    std::string_view item = list.substr(0, comma);
    while (item.starts_with(' ')) item.remove_prefix(1);
    while (item.ends_with(' ')) item.remove_suffix(1);
    if (!item.empty()) items.push_back(item);
    if (comma == list.size()) return items;
    list.remove_prefix(comma + 1);
  }
}

std::string none_of(std::string_view value, std::span<const std::string_view> known) {
  return "'" + std::string(value) + "' is not one of " + listed(known) + did_you_mean(value, known);
}

}  // namespace smurf::tools
