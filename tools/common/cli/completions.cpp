// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "common/cli/pages.hpp"

namespace smurf::tools {
namespace {

std::string joined(const std::vector<std::string_view>& words) {
  std::string out;
  for (const std::string_view word : words) out.append(out.empty() ? "" : " ").append(word);
  return out;
}

/// The known values of an option.
std::vector<std::string_view> words_of(const Option& option) {
  return option.values.empty() && option.suggestions != nullptr ? option.suggestions()
                                                                : option.values;
}

/// All words, including those with a level: "SML3101=error".
std::string whole_words_of(const Option& option) {
  if (option.levels.empty()) return joined(words_of(option));
  std::string out;
  for (const std::string_view word : words_of(option)) {
    for (const std::string_view level : option.levels) {
      out.append(out.empty() ? "" : " ").append(word).append("=").append(level);
    }
  }
  return out;
}

/// bash splits "ID=LEVEL" into three words, so the level is completed after the word before the ID.
std::string bash_levels(const Command& command) {
  std::string cases;
  for (const Option& option : all_options(command)) {
    if (option.levels.empty()) continue;
    cases += "    --" + std::string(option.name) + ")\n      COMPREPLY=($(compgen -W \"" +
             joined(option.levels) + "\" -- \"${word#=}\"))\n      return ;;\n";
  }
  if (cases.empty()) return {};
  return "  local option=\n"
         "  if [[ $word == \"=\" ]]; then option=${COMP_WORDS[COMP_CWORD-2]}; fi\n"
         "  if [[ $before == \"=\" && COMP_CWORD -gt 2 ]]; then "
         "option=${COMP_WORDS[COMP_CWORD-3]}; fi\n"
         "  case $option in\n" +
         cases + "  esac\n";
}

bool takes_file(const Option& option) {
  return option.metavar.find("FILE") != std::string_view::npos ||
         option.metavar.find("PATH") != std::string_view::npos ||
         option.metavar.find("DIR") != std::string_view::npos;
}

/// Text between single quotes.
std::string quoted(std::string_view text, std::string_view apostrophe) {
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'') {
      out += apostrophe;
    } else {
      out += c;
    }
  }
  return out + "'";
}

/// The first sentence, with the characters escaped that zsh interprets.
std::string gist(std::string_view help, bool escape_brackets) {
  const std::size_t end = std::min(help.find(". "), help.size());
  std::string out;
  for (const char c : help.substr(0, end)) {
    if (escape_brackets && (c == '[' || c == ']' || c == ':')) out += '\\';
    out += c;
  }
  if (out.ends_with('.')) out.pop_back();
  return out;
}

std::string function_name(const Command& command) {
  std::string name = "_";
  for (const char c : command.name) name += c == '-' ? '_' : c;
  return name;
}

/// The names of the verbs.
std::string names_of_verbs(const Command& command) {
  std::vector<std::string_view> names;
  for (const VerbName& verb : command.verbs) names.push_back(verb.name);
  return joined(names);
}

/// Behind a verb, bash asks the completion of the program that the verb runs.
std::string bash_verbs(const Command& command) {
  if (command.verbs.empty()) return {};
  std::string cases;
  for (const VerbName& verb : command.verbs) {
    cases.append("      ").append(verb.name).append(") tool=").append(verb.tool).append(" ;;\n");
  }
  return "  if ((COMP_CWORD > 1)); then\n"
         "    local tool=\n"
         "    case ${COMP_WORDS[1]} in\n" +
         cases +
         "    esac\n"
         "    if [[ -z $tool ]]; then return; fi\n"
         "    COMP_WORDS=(\"$tool\" \"${COMP_WORDS[@]:2}\")\n"
         "    COMP_CWORD=$((COMP_CWORD - 1))\n"
         "    declare -F \"_${tool//-/_}\" >/dev/null || _completion_loader \"$tool\" 2>/dev/null\n"
         "    if declare -F \"_${tool//-/_}\" >/dev/null; then \"_${tool//-/_}\"; else compopt -o "
         "default; fi\n"
         "    return\n"
         "  fi\n"
         "  if [[ $word != -* ]]; then\n"
         "    COMPREPLY=($(compgen -W \"" +
         names_of_verbs(command) +
         "\" -- \"$word\"))\n"
         "    return\n"
         "  fi\n";
}

/// Behind a verb, zsh asks the completion of the program that the verb runs.
std::string zsh_verbs(const Command& command) {
  std::string out = "  '1:verb:((";
  for (const VerbName& verb : command.verbs) {
    out.append(&verb == command.verbs.data() ? "" : " ").append(verb.name).append("\\:\"");
    out += gist(verb.does, true) + "\"";
  }
  out += "))' '*:: :->behind'\nif [[ $state == behind ]]; then\n  case $words[1] in\n";
  for (const VerbName& verb : command.verbs) {
    out.append("    ").append(verb.name).append(") words[1]=").append(verb.tool).append(" ;;\n");
  }
  return out + "  esac\n  _normal\nfi\n";
}

std::string fish_verbs(const Command& command) {
  std::string out;
  for (const VerbName& verb : command.verbs) {
    out += "complete -c " + std::string(command.name) + " -n __fish_use_subcommand -f -a " +
           std::string(verb.name) + " -d " + quoted(gist(verb.does, false), "\\'") + "\n";
    out += "complete -c " + std::string(command.name) + " -n '__fish_seen_subcommand_from " +
           std::string(verb.name) + "' -a '(complete -C \"" + std::string(verb.tool) +
           " \"(commandline -ct))'\n";
  }
  return out;
}

}  // namespace

std::string bash_completion(const Command& command) {
  std::string cases;
  std::string names;
  for (const Option& option : all_options(command)) {
    const std::string name = "--" + std::string(option.name);
    names.append(names.empty() ? "" : " ").append(name);
    if (option.metavar.empty() || option.may_omit_value) continue;
    cases += "    " + name;
    if (option.letter != 0) cases += std::string("|-") + option.letter;
    cases += ")\n";
    if (!words_of(option).empty()) {
      cases +=
          "      COMPREPLY=($(compgen -W \"" + joined(words_of(option)) + "\" -- \"$word\"))\n";
    } else if (takes_file(option)) {
      cases += "      compopt -o default\n";
    }
    cases += "      return ;;\n";
  }
  const std::string function = function_name(command);
  return "# bash completion of " + std::string(command.name) + "\n" + function +
         "() {\n"
         "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]}\n"
         "  COMPREPLY=()\n" +
         bash_verbs(command) + bash_levels(command) +
         "  if [[ $before == \"=\" ]]; then before=${COMP_WORDS[COMP_CWORD-2]}; fi\n"
         "  if [[ $word == \"=\" ]]; then before=${COMP_WORDS[COMP_CWORD-1]}; word=; fi\n"
         "  case $before in\n" +
         cases +
         "  esac\n"
         "  if [[ $word == -* ]]; then\n"
         "    COMPREPLY=($(compgen -W \"" +
         names +
         "\" -- \"$word\"))\n"
         "  else\n"
         "    compopt -o default\n"
         "  fi\n"
         "}\ncomplete -F " +
         function + " " + std::string(command.name) + "\n";
}

std::string zsh_completion(const Command& command) {
  std::string out = "#compdef " + std::string(command.name) + "\n_arguments \\\n";
  for (const Option& option : all_options(command)) {
    const std::string name = "--" + std::string(option.name);
    const std::string help = "[" + gist(option.help, true) + "]";
    std::string value;
    if (!option.metavar.empty()) {
      value = std::string(option.may_omit_value ? "::" : ":") + gist(option.metavar, true) + ":";
      if (!words_of(option).empty()) {
        value += "(" + whole_words_of(option) + ")";
      } else if (takes_file(option)) {
        value += "_files";
      }
    }
    const std::string equals = option.metavar.empty() ? "" : option.may_omit_value ? "=-" : "=";
    if (option.letter != 0) {
      const std::string letter = std::string("-") + option.letter;
      out += "  '(" + letter + " " + name + ")'{" + letter + "," + name + equals + "}" +
             quoted(help + value, "'\\''") + " \\\n";
    } else {
      out += "  " + quoted("*" + name + equals + help + value, "'\\''") + " \\\n";
    }
  }
  return out + (command.verbs.empty() ? "  '*:path:_files'\n" : zsh_verbs(command));
}

std::string fish_completion(const Command& command) {
  std::string out = fish_verbs(command);
  for (const Option& option : all_options(command)) {
    out += "complete -c " + std::string(command.name);
    if (option.letter != 0) out += std::string(" -s ") + option.letter;
    out.append(" -l ").append(option.name);
    if (!option.metavar.empty() && !option.may_omit_value) {
      out += takes_file(option) && words_of(option).empty() ? " -r -F" : " -x";
    }
    if (!words_of(option).empty()) out += " -a " + quoted(whole_words_of(option), "\\'");
    out += " -d " + quoted(gist(option.help, false), "\\'") + "\n";
  }
  return out;
}

}  // namespace smurf::tools
