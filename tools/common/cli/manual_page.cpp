// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cctype>

#include "common/cli/pages.hpp"

namespace smurf::tools {
namespace {

/// Escapes what roff would interpret.
std::string roff(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
    case '\\': out += "\\e"; break;
    case '-': out += "\\-"; break;
    case '`': out += "\\(aq"; break;
    case '\'': out += "\\(aq"; break;
    default: out += c;
    }
  }
  return out.starts_with('.') ? "\\&" + out : out;
}

std::string bold(std::string_view text) { return "\\fB" + roff(text) + "\\fR"; }
std::string italic(std::string_view text) { return "\\fI" + roff(text) + "\\fR"; }

std::string entry(const Option& option) {
  std::string head;
  if (option.letter != 0) head = bold(std::string("-") + option.letter) + ", ";
  head += bold("--" + std::string(option.name));
  if (option.may_omit_value) {
    head += "[=" + italic(option.metavar) + "]";
  } else if (!option.metavar.empty()) {
    head += " " + italic(option.metavar);
  }
  return ".TP\n" + head + "\n" + roff(option.help) + "\n";
}

std::string options_section(const Command& command) {
  std::string out = ".SH OPTIONS\n";
  const std::vector<Option> options = all_options(command);
  for (const std::string_view group : option_groups(options)) {
    out += ".SS " + roff(group) + "\n";
    for (const Option& option : options) {
      if (option.group == group) out += entry(option);
    }
  }
  return out;
}

}  // namespace

std::string manual_page(const Command& command) {
  std::string name(command.name);
  std::transform(name.begin(), name.end(), name.begin(), [](char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  });
  // No date: the page is the same whenever it is made.
  std::string out = ".TH " + roff(name) + " 1 \"\" \"smurf " + std::string(kVersion) + "\"\n";
  out += ".nh\n.ad l\n";  // names of files and options stay whole
  out += ".SH NAME\n" + roff(command.name) + " \\- " + roff(command.summary) + "\n";
  out += ".SH SYNOPSIS\n" + bold(command.name) + " [" + italic("OPTION") + "]...";
  if (!command.operands.empty()) out += " " + roff(command.operands);
  out += "\n.SH DESCRIPTION\n" + roff(command.summary) + "\n";
  if (!command.details.empty()) out += ".PP\n" + roff(command.details) + "\n";
  if (!command.verbs.empty()) out += ".SH VERBS\n";
  for (const VerbName& verb : command.verbs) {
    out += ".TP\n" + bold(verb.name) + "\n" + roff(verb.does) + "\n";
  }
  out += options_section(command);
  out += ".SH \"EXIT STATUS\"\n";
  std::string with_1(command.exit_with_1);
  with_1.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(with_1.front())));
  out += ".TP\n.B 0\nDone.\n.TP\n.B 1\n" + roff(with_1) + ".\n";
  out += ".TP\n.B 2\nCould not do the job.\n";
  if (!command.examples.empty()) out += ".SH EXAMPLES\n";
  for (const Example& example : command.examples) {
    out += ".PP\n" + roff(example.does) + "\n.PP\n.RS 4\n.nf\n" + roff(example.command) +
           "\n.fi\n.RE\n";
  }
  return out + ".SH \"SEE ALSO\"\n" + roff(kSite) + "\n";
}

namespace {

/// Text in a cell of a table.
std::string cell(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '|' || c == '<') out += '\\';
    if (c == '\n') {
      out += "<br>";
    } else {
      out += c;
    }
  }
  return out;
}

std::string row(const Option& option) {
  std::string names = "`";
  if (option.letter != 0) names += std::string("-") + option.letter + "`, `";
  names.append("--").append(option.name);
  if (option.may_omit_value) {
    names.append("[=").append(option.metavar).append("]");
  } else if (!option.metavar.empty()) {
    names.append(" ").append(option.metavar);
  }
  return "| " + names + "` | " + cell(option.help) + " |\n";
}

}  // namespace

std::string markdown_page(const Command& command) {
  std::string out = "## Examples\n\n| to | run |\n|---|---|\n";
  for (const Example& example : command.examples) {
    std::string_view does = example.does;
    while (does.ends_with(':')) does.remove_suffix(1);
    out += "| " + cell(does) + " | `" + cell(example.command) + "` |\n";
  }
  out += "\n## Options\n\nUsage: `" + std::string(command.name) + " [OPTION]...";
  if (!command.operands.empty()) out.append(" ").append(command.operands);
  out += "`\n\n" + std::string(command.details) + "\n";
  if (!command.verbs.empty()) out += "\n| verb | does |\n|---|---|\n";
  for (const VerbName& verb : command.verbs) {
    out += "| `" + std::string(verb.name) + "` | " + cell(verb.does) + " |\n";
  }
  const std::vector<Option> options = all_options(command);
  for (const std::string_view group : option_groups(options)) {
    out += "\n### " + std::string(group) + "\n\n| option | meaning |\n|---|---|\n";
    for (const Option& option : options) {
      if (option.group == group) out += row(option);
    }
  }
  return out;
}

}  // namespace smurf::tools
