// SPDX-License-Identifier: BSD-3-Clause
// Sources: launch frontend and conditions, launch_ros node.py, rmw validate_node_name.c and
// validate_namespace.c; launch and launch_ros were run.
#include "link/surroundings/launch_mistakes.hpp"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/files/path.hpp"
#include "base/text/quoted.hpp"
#include "base/text/suggest.hpp"
#include "base/text/words.hpp"
#include "link/surroundings/launch_grammar.hpp"
#include "link/surroundings/launch_words.hpp"

namespace smurf::launch {
namespace {

using Kind = LaunchMistake::Kind;

std::vector<std::string_view> words_in(std::string_view list) {
  std::vector<std::string_view> words;
  for (std::size_t at = 0;;) {
    const std::string_view one = next_word(list, at);
    if (one.empty()) return words;
    words.push_back(one.substr(0, one.find(':')));
  }
}

std::string_view old_word(std::string_view place, std::string_view word) {
  for (const OldWord& one : old_words()) {
    if (one.place == place && one.word == word) return one.now;
  }
  return {};
}

bool is_name(std::string_view text) {
  return !text.empty() && std::isdigit(static_cast<unsigned char>(text.front())) == 0 &&
         std::all_of(text.begin(), text.end(), [](char c) {
           return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
         });
}

std::string lower(std::string_view text) { return path::to_lower(text); }

class ElementMistakes {
 public:
  ElementMistakes(const Element& root, const Texts& texts, LaunchFile& file)
      : texts_(texts), file_(file) {
    gather(root);
    for (const std::string_view one : set_) names_.push_back(one);
  }

  void run(const Element& root) {
    actions_in(root, "*");
    check_packages(file_);
  }

 private:
  bool is_yaml() const { return file_.form == LaunchFile::Form::yaml; }
  std::string shown(const Element& element) const {
    return is_yaml() ? quoted(element.name) : quoted("<" + element.name + ">");
  }

  LaunchMistake& report(Kind kind, Span span, std::string message, std::string help) {
    return file_.mistakes.emplace_back(
        LaunchMistake{kind, span, std::move(message), std::move(help)});
  }

  /// All names that are set anywhere. As deep as the file, whose depth is limited.
  void gather(const Element& element) {
    for (const Element& child : element.children) {
      if (child.name == "arg" || child.name == "let") {
        if (const Attribute* name = child.attribute("name")) set_.insert(name->value);
      }
      gather(child);
    }
  }

  void actions_in(const Element& element, std::string_view allowed) {
    for (const Element& child : element.children) action(element, child, allowed);
  }

  void action(const Element& parent, const Element& element, std::string_view allowed) {
    const std::string_view place = parent.name == "launch" ? std::string_view() : parent.name;
    const bool is_nested = has_word(allowed, element.name);
    if (!is_nested && !has_word(allowed, "*")) {
      std::string_view now = old_word(place, element.name);
      std::string help(now);
      const auto known = words_in(allowed);
      if (const auto near = only_nearest(element.name, known); help.empty() && near)
        help = "did you mean " + quoted(*near) + "?";
      report(Kind::word, element.span, shown(parent) + " has no " + shown(element),
             help.empty() ? "delete it" : help);
      return;
    }
    const Action* row = find_action(is_nested ? place : std::string_view(), element.name);
    if (row == nullptr) return unknown(element);
    attributes(element, *row);
    const bool has_actions = has_word(row->children, "*");
    if (element.name == "group" || has_actions || !element.children.empty())
      actions_in(element, row->children);
    if (element.name == "arg" || element.name == "let") {
      if (const Attribute* name = element.attribute("name"); name != nullptr && !is_nested)
        done_.insert(name->value);
    }
    // An included file may set arguments, too.
    if (element.name == "include") has_included_ = true;
  }

  /// Other packages add elements of their own, so only a misspelling is known to be one.
  void unknown(const Element& element) {
    const std::string_view now = old_word("", element.name);
    std::vector<std::string_view> known;
    for (const Action& one : actions()) {
      if (one.name.find('/') == std::string_view::npos) known.push_back(one.name);
    }
    const auto near = near_.of(element.name, known);
    const auto same = std::find_if(known.begin(), known.end(), [&](std::string_view one) {
      return lower(one) == lower(element.name);
    });
    const std::string_view right = same != known.end() ? *same : near ? *near : std::string_view();
    if (now.empty() && right.empty()) return;
    LaunchMistake& found =
        report(Kind::word, element.span, "launch has no element " + shown(element),
               !now.empty() ? std::string(now) : "did you mean " + quoted(right) + "?");
    if (now.empty() && is_yaml()) found.replacement = right;
  }

  void attributes(const Element& element, const Action& row) {
    const std::string_view place = row.name;
    const std::size_t before = file_.mistakes.size();
    for (const Attribute& one : element.attributes) {
      if (!is_yaml() && one.name.ends_with("-sep")) continue;
      std::string_view type;
      if (!has_word(row.attributes, one.name, &type)) {
        const std::string_view now = old_word(place, one.name);
        const auto known = words_in(row.attributes);
        const auto near = only_nearest(one.name, known);
        LaunchMistake& found =
            report(Kind::word, one.name_span, shown(element) + " has no " + quoted(one.name),
                   !now.empty() ? std::string(now)
                   : near       ? "did you mean " + quoted(*near) + "?"
                                : std::string("delete it"));
        if (now.empty() && near) found.replacement = *near;
        continue;
      }
      value(element, one, type);
    }
    for (const std::string_view one : words_in(row.required)) {
      if (element.attribute(one) != nullptr) continue;
      // A misspelt one was reported as such.
      const bool is_told =
          std::any_of(file_.mistakes.begin() + static_cast<std::ptrdiff_t>(before),
                      file_.mistakes.end(), [&](const LaunchMistake& told) {
                        return told.kind == Kind::word && holds(element, told.span);
                      });
      if (!is_told)
        report(Kind::word, element.span, shown(element) + " needs " + quoted(one), "add it");
    }
    if (element.attribute("if") != nullptr && element.attribute("unless") != nullptr) {
      report(Kind::word, element.attribute("unless")->name_span,
             "`if` and `unless` cannot stand together", "delete one of them");
    }
    check_forms(element, row);
  }

  static bool holds(const Element& element, Span span) {
    return std::any_of(element.attributes.begin(), element.attributes.end(),
                       [&](const Attribute& one) { return one.name_span.begin == span.begin; });
  }

  /// What a parameter, a node and a condition hold.
  void check_forms(const Element& element, const Action& row) {
    if (row.name.ends_with("/param")) parameter(element);
    for (const std::string_view name : {"if", "unless"}) {
      if (const Attribute* one = element.attribute(name)) check_condition(text_of(*one), file_);
    }
    if (element.name != "node" && element.name != "node_container") return;
    if (const Attribute* name = element.attribute("name")) check_node_name(text_of(*name), file_);
    if (const Attribute* name = element.attribute("namespace"))
      check_namespace(text_of(*name), file_);
  }

  LaunchText text_of(const Attribute& one) const {
    return texts_.of(substituted(one.value, one.span));
  }

  void parameter(const Element& element) {
    const Attribute* name = element.attribute("name");
    const Attribute* from = element.attribute("from");
    const Attribute* type = element.attribute("type");
    if (name == nullptr && from == nullptr) {
      report(Kind::word, element.span, shown(element) + " needs `name` or `from`", "add it");
    } else if (name != nullptr && from != nullptr) {
      report(Kind::word, from->name_span, "`name` and `from` cannot stand together",
             "delete one of them");
    } else if (name != nullptr && element.attribute("value") == nullptr &&
               element.children.empty()) {
      report(Kind::word, element.span, shown(element) + " needs `value`", "add it");
    }
    if (type == nullptr) return;
    if (!is_one_of(type->value, {"bool", "int", "float", "str", "list_of_bool", "list_of_int",
                                 "list_of_float", "list_of_str"})) {
      report(Kind::type, type->span, "launch has no type " + quoted(type->value),
             "write `bool`, `int`, `float` or `str`");
    }
  }

  void value(const Element& element, const Attribute& one, std::string_view type) {
    if (is_yaml()) {
      const bool fits = one.type == Attribute::Type::text || type == "any" ||
                        (type == "truth" && one.type == Attribute::Type::truth) ||
                        (type == "real" && one.type == Attribute::Type::real) ||
                        (type == "count" && one.type == Attribute::Type::count);
      if (!fits) {
        LaunchMistake& found =
            report(Kind::type, one.span,
                   shown(element) + " needs " +
                       (type == "real"    ? "a number with a point"
                        : type == "count" ? "a whole number"
                                          : "a text") +
                       " as " + quoted(one.name) + ", and " + quoted(one.value) + " is none",
                   type == "real" ? "write " + quoted(one.value + ".0") : "write it in quotes");
        if (one.type == Attribute::Type::count && type == "real") {
          found.replacement = one.value + ".0";
        } else if (!one.value.empty() && type.empty()) {
          found.replacement = "'" + one.value + "'";
        }
        return;
      }
    }
    const bool is_plain = is_one_of(one.name, {"type", "description"}) ||
                          (is_one_of(element.name, {"arg", "choice"}) && one.name == "name");
    if (!is_plain) substitutions_in(one);
  }

  void substitutions_in(const Attribute& one) {
    const Substitutions read = read_substitutions(one.value);
    // With entities, the text is shorter than its place.
    const bool is_exact = one.span.end - one.span.begin == one.value.size();
    const auto place = [&](std::size_t begin, std::size_t end) {
      if (!is_exact) return one.span;
      return Span{one.span.source, static_cast<std::uint32_t>(one.span.begin + begin),
                  static_cast<std::uint32_t>(one.span.begin + end)};
    };
    if (read.fault) {
      report(Kind::substitution, place(read.fault->begin, read.fault->end), read.fault->message,
             read.fault->help.empty() ? "correct it" : read.fault->help);
      return;
    }
    for (const WrittenSubstitution& used : read.all) {
      substitution(used, place(used.begin, used.end));
      const Span first = place(used.first_begin, used.first_begin + used.first.size());
      if (used.name == "find-exec" && used.first.find('$') == std::string_view::npos)
        check_program(used.first, first, file_);
      const bool is_read = used.name == "var" && used.values == 1;
      if (!is_read || !is_name(used.first) || done_.contains(used.first)) continue;
      const bool is_below = set_.contains(used.first);
      if (has_included_ && is_below) continue;
      check_argument(used.first, first, names_, is_below, near_, file_);
      if (has_included_ && !file_.mistakes.empty()) file_.mistakes.back().is_doubtful = true;
    }
  }

  void substitution(const WrittenSubstitution& used, Span span) {
    const auto rows = substitutions();
    const auto row = std::find_if(rows.begin(), rows.end(),
                                  [&](const Substitution& one) { return one.name == used.name; });
    if (row != rows.end()) {
      if (used.values >= row->least && used.values <= row->most) return;
      const bool is_eval = used.name == "eval" || used.name == "command";
      report(Kind::substitution, span,
             quoted("$(" + std::string(used.name) + ")") + " has " + std::to_string(used.values) +
                 " values, and needs " + std::to_string(row->least) +
                 (row->most > row->least ? " or more" : ""),
             is_eval ? "write quotes around the whole value" : "give it as many values");
      return;
    }
    const std::string_view now = old_word("$", used.name);
    std::vector<std::string_view> known;
    for (const Substitution& one : rows) known.push_back(one.name);
    const auto near = near_.of(used.name, known);
    const auto same = std::find(known.begin(), known.end(), lower(used.name));
    const std::string_view right = same != known.end() ? *same : near ? *near : std::string_view();
    if (now.empty() && set_.contains(used.name) && used.values == 0) {
      report(Kind::substitution, span, "launch has no substitution " + quoted(used.name),
             "write " + quoted("$(var " + std::string(used.name) + ")"));
      return;
    }
    if (now.empty() && right.empty()) return;
    LaunchMistake& found =
        report(Kind::substitution, span, "launch has no substitution " + quoted(used.name),
               !now.empty() ? std::string(now) : "did you mean " + quoted(right) + "?");
    if (used.name.size() == span.end - span.begin && now.empty()) found.replacement = right;
  }

  const Texts& texts_;
  LaunchFile& file_;
  std::set<std::string_view> set_, done_;
  std::vector<std::string_view> names_;
  NearNames near_;
  bool has_included_ = false;
};

}  // namespace

void find_mistakes(const Element& root, const Texts& texts, LaunchFile& file) {
  ElementMistakes(root, texts, file).run(root);
}

void check_condition(const LaunchText& value, LaunchFile& file) {
  if (!value.is_known || !value.package.empty()) return;
  const std::string text = lower(trimmed(value.text));
  if (is_one_of(text, {"true", "false", "1", "0"})) return;
  file.mistakes.push_back(
      {Kind::value, value.span,
       "a condition must be true, false, 1 or 0, and " + quoted(value.text) + " is none",
       is_one_of(text, {"yes", "on", "y"})   ? "write `true`"
       : is_one_of(text, {"no", "off", "n"}) ? "write `false`"
                                             : "write `true` or `false`, or compare it",
       "", value.by_default});
}

void check_node_name(const LaunchText& name, LaunchFile& file) {
  if (!name.is_known || !name.package.empty() || is_name(name.text)) return;
  file.mistakes.push_back({Kind::value, name.span, "no node can have the name " + quoted(name.text),
                           name.text.find('/') != std::string::npos
                               ? "write what stands before the last slash as the namespace"
                               : "write letters, digits and underscores, no digit first",
                           "", name.by_default});
}

void check_namespace(const LaunchText& name, LaunchFile& file) {
  if (!name.is_known || !name.package.empty()) return;
  std::string_view rest = name.text;
  if (rest.starts_with('/')) rest.remove_prefix(1);
  if (rest.ends_with('/')) rest.remove_suffix(1);
  if (rest.empty()) return;
  while (!rest.empty()) {
    const std::string_view part = rest.substr(0, rest.find('/'));
    if (!is_name(part)) {
      file.mistakes.push_back({Kind::value, name.span,
                               "no node can have the namespace " + quoted(name.text),
                               "write names of letters, digits and underscores, no digit first, "
                               "and one slash between them",
                               "", name.by_default});
      return;
    }
    if (part.size() == rest.size()) return;
    rest.remove_prefix(part.size() + 1);
  }
}

void check_packages(LaunchFile& file) {
  std::set<std::uint32_t> told;
  const auto look_at = [&](const LaunchText& text) {
    const std::size_t slash = text.package.find('/');
    if (slash == std::string::npos || !told.insert(text.package_span.begin).second) return;
    file.mistakes.push_back(
        {Kind::value, text.package_span, "no package can have the name " + quoted(text.package),
         "write " + quoted(text.package.substr(0, slash)) + ", and the folder behind it"});
  };
  for (const LaunchDescription& one : file.descriptions) {
    if (one.file) look_at(one.file->text);
  }
  for (const LaunchPath& one : file.paths) look_at(one.text);
}

void check_program(std::string_view name, Span span, LaunchFile& file) {
  constexpr std::string_view kPrograms[] = {"xacro"};
  std::string help;
  if (name == "xacro.py") {
    help = "write `xacro`";
  } else if (near_name(name, kPrograms)) {
    help = "did you mean `xacro`?";
  } else if (is_one_of(name, {"urdf", "xacro.urdf", "urdf.xacro"})) {
    help = "write `xacro`";
  } else {
    return;
  }
  file.mistakes.push_back({Kind::program, span, "there is no program " + quoted(name), help,
                           name == "xacro.py" || help.starts_with("did") ? "xacro" : ""});
}

void check_argument(std::string_view name, Span span, std::span<const std::string_view> known,
                    bool is_below, NearNames& near_names, LaunchFile& file) {
  LaunchMistake found{Kind::unset, span,
                      is_below ? "the argument " + quoted(name) + " is read above its declaration"
                               : "nothing declares or sets the argument " + quoted(name),
                      is_below ? "declare it further up" : "declare it, with a default"};
  const auto near = is_below ? std::nullopt : near_names.of(name, known);
  if (near) {
    found.help = "did you mean " + quoted(*near) + "?";
    if (span.end - span.begin == name.size()) found.replacement = *near;
  }
  // A file that includes this one may set it.
  found.is_doubtful = !near && !is_below;
  file.mistakes.push_back(std::move(found));
}

}  // namespace smurf::launch
