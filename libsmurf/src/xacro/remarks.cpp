// SPDX-License-Identifier: BSD-3-Clause
// What can be expanded, and is not what it seems.
#include <algorithm>
#include <array>

#include "base/findings/rules.hpp"
#include "base/text/quoted.hpp"
#include "base/text/words.hpp"
#include "xacro/expander.hpp"
#include "xacro/python_text.hpp"

namespace smurf::xacro {
namespace {

bool is_truth_word(std::string_view text) {
  return text == "true" || text == "True" || text == "false" || text == "False";
}

bool is_latin_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// Whether code outside of quotes has `True` or `False`: `a == 'true' or a == True` holds.
bool mentions_truth(std::string_view code) {
  char quote = '\0';
  for (std::size_t i = 0; i < code.size(); ++i) {
    const char c = code[i];
    if (quote != '\0') {
      if (c == quote) quote = '\0';
    } else if (c == '\'' || c == '"') {
      quote = c;
    } else if (code.substr(i).starts_with("True") || code.substr(i).starts_with("False")) {
      return true;
    }
  }
  return false;
}

/// Whether characters to remove are meant as a word, as `_link`; `[]` and `0.` are not.
bool is_word(std::string_view text) {
  return text.size() > 2 && std::count_if(text.begin(), text.end(), is_latin_letter) > 1;
}

/// The names in an expression; false if it has parts whose value is not that of names and numbers.
bool collect_names(const Syntax& syntax, std::vector<std::string_view>& names) {
  if (syntax.kind == SyntaxKind::name) names.push_back(syntax.text);
  for (const Syntax* part : syntax.parts) {
    if (part != nullptr && !collect_names(*part, names)) return false;
  }
  return syntax.kind != SyntaxKind::comprehension && syntax.kind != SyntaxKind::lambda &&
         syntax.kind != SyntaxKind::assign;
}

/// The names that a condition compares with texts or numbers: `mode == 'mock'`, also with `or`.
bool is_choice(const Syntax& syntax, std::vector<std::string_view>& names) {
  if (syntax.kind == SyntaxKind::logical_or) {
    return std::all_of(syntax.parts.begin(), syntax.parts.end(),
                       [&](const Syntax* part) { return is_choice(*part, names); });
  }
  if (syntax.kind != SyntaxKind::compare || syntax.parts.size() != 2) return false;
  if (syntax.operations[0] != Operation::equal) return false;
  const Syntax& left = *syntax.parts[0];
  const Syntax& right = *syntax.parts[1];
  if (left.kind != SyntaxKind::name || right.kind != SyntaxKind::constant) return false;
  names.push_back(left.text);
  return true;
}

}  // namespace

std::string_view code_of(std::string_view text) {
  if (!text.starts_with("${") || text.find('}') != text.size() - 1) return {};
  return without_blanks(text.substr(2, text.size() - 3));
}

void Evaluator::remark_on(const Syntax& comparison, std::size_t index, const Value& left,
                          const Value& right) {
  const Operation operation = comparison.operations[index];
  if (operation != Operation::equal && operation != Operation::not_equal) return;
  const bool is_right = right.is_text();
  const Value& text = is_right ? right : left;
  const Value& truth = is_right ? left : right;
  const Syntax& word = *comparison.parts[index + (is_right ? 1 : 0)];
  const Syntax& other = *comparison.parts[index + (is_right ? 0 : 1)];
  if (truth.kind != Kind::boolean || !text.is_text() || !is_truth_word(*text.text)) return;
  if (word.kind != SyntaxKind::constant || other.kind == SyntaxKind::constant) return;
  const std::string literal = (*text.text)[0] == 't' || (*text.text)[0] == 'T' ? "True" : "False";
  const std::string subject =
      other.kind == SyntaxKind::name ? quoted(other.text) : std::string("the value");
  remarks_.push_back(
      {&rules::sml3406_xacro_truth_as_text,
       subject + " is a truth value, which never equals the text '" + *text.text + "'",
       "write `" + literal + "` without quotes", comparison.begin, comparison.end, word.begin,
       word.end, literal});
}

void Evaluator::remark_on_call(const Syntax& call) {
  const Syntax& function = *call.parts[0];
  if (function.kind != SyntaxKind::attribute || call.parts.size() != 2) return;
  const std::string_view name = function.text;
  if (name != "strip" && name != "lstrip" && name != "rstrip") return;
  const Syntax& word = *call.parts[1];
  if (word.kind != SyntaxKind::constant || !word.value.is_text() || !is_word(*word.value.text)) {
    return;
  }
  const std::string better = name == "lstrip" ? "removeprefix" : "removesuffix";
  Remark remark{&rules::sml3407_xacro_stripped_characters,
                quoted(std::string(name) + "()") + " removes all of the characters '" +
                    *word.value.text + "', not the word",
                "write " + quoted(better + "()"), call.begin, call.end};
  if (name != "strip") {
    remark.fix_begin = function.end - static_cast<std::uint32_t>(name.size());
    remark.fix_end = function.end;
    remark.replacement = better;
  }
  remarks_.push_back(std::move(remark));
}

void Expander::report_remarks(std::size_t first, std::string_view code, const Piece& expression,
                              std::size_t skipped) {
  std::vector<Remark>& remarks = evaluator_.remarks();
  const bool is_careful = mentions_truth(code);
  for (std::size_t i = first; i < remarks.size(); ++i) {
    const Remark& one = remarks[i];
    const auto place_of = [&](std::uint32_t begin, std::uint32_t end) {
      Span span = expression.origin;
      if (!expression.is_exact) return span;
      const std::uint32_t start = span.begin + offset(skipped);
      return Span{span.source, start + begin, std::min(span.end, start + end)};
    };
    const Span span = place_of(one.begin, one.end);
    if (is_careful && one.rule == &rules::sml3406_xacro_truth_as_text) continue;
    if (!is_first_at(span)) continue;
    Diagnostic& diagnostic = context_.sink.report(*one.rule, span, one.message);
    diagnostic.help(one.help);
    if (expression.is_exact && !one.replacement.empty()) {
      diagnostic.fixes.push_back(
          {Applicability::unsafe, {{place_of(one.fix_begin, one.fix_end), one.replacement}}});
    }
    add_frames(diagnostic);
  }
  remarks.resize(first);
}

/// Reports `{name}` and `{2*pi}`, whose names are known.
void Expander::check_braces(const TracedText& text, Table& symbols) {
  if (text.is_plain) return;
  const std::string_view written = text.value;
  for (std::size_t open = written.find('{'); open != std::string_view::npos;
       open = written.find('{', open + 1)) {
    const std::size_t close = written.find('}', open);
    if (close == std::string_view::npos) return;
    if (open > 0 && written[open - 1] == '$') continue;
    const std::string_view code = without_blanks(written.substr(open + 1, close - open - 1));
    if (code.empty() || code.size() > 200) continue;
    const Expression& expression = expressions_.parse(code);
    std::vector<std::string_view> names;
    if (expression.root == nullptr || !collect_names(*expression.root, names) || names.empty()) {
      continue;
    }
    const bool is_name = expression.root->kind == SyntaxKind::name;
    const auto is_known = [&](std::string_view name) {
      const Table::Found found = symbols.find(name);
      return found && (!is_name || !found.table->is_root()) &&
             found.entry->value.kind != Kind::block;
    };
    if (!std::all_of(names.begin(), names.end(), is_known)) continue;
    const Piece place = part_of(text.whole, open, close + 1);
    if (!is_first_at(place.origin)) continue;
    Diagnostic& diagnostic = context_.sink.report(rules::sml3408_xacro_missing_dollar, place.origin,
                                                  quoted(written.substr(open, close + 1 - open)) +
                                                      " is a text, and not evaluated");
    diagnostic.help("write " + quoted("$" + std::string(written.substr(open, close + 1 - open))));
    if (place.is_exact) {
      Span before = place.origin;
      before.end = before.begin;
      diagnostic.fixes.push_back({Applicability::unsafe, {{before, "$"}}});
    }
    add_frames(diagnostic);
  }
}

/// Reports an element whose branches are for other values than the actual one.
void Expander::check_branches(const Node& in, const Node& out, Table& symbols) {
  for (const Node* child : out.children) {
    const bool is_content = child->kind == NodeKind::element ||
                            (child->kind == NodeKind::text && !has_only_blanks(child->text));
    if (is_content) return;
  }
  std::vector<std::string_view> common;
  std::size_t branches = 0;
  for (const Node* child : in.children) {
    if (child->kind != NodeKind::element) continue;
    const NodeAttribute* value = child->attribute("value");
    if (child->name != "xacro:if" || value == nullptr) return;
    const std::string_view code = code_of(value->text.value);
    const Expression* condition = code.empty() ? nullptr : &expressions_.parse(code);
    std::vector<std::string_view> names;
    if (condition == nullptr || condition->root == nullptr || !is_choice(*condition->root, names)) {
      return;
    }
    if (branches++ == 0) common = names;
    std::erase_if(common, [&](std::string_view name) {
      return std::find(names.begin(), names.end(), name) == names.end();
    });
  }
  if (branches < 2 || common.empty() || !is_first_at(in.name_span)) return;
  const Table::Found found = symbols.find(common[0]);
  if (!found || found.entry->is_unevaluated) return;
  const Value& value = found.entry->value;
  NoText problem{meter_, {}};
  const std::string shown = value.is_text() ? "'" + *value.text + "'" : text_of(value, problem);
  Diagnostic& diagnostic = context_.sink.report(
      rules::sml3410_xacro_no_branch, in.name_span,
      "none of the " + std::to_string(branches) + " conditions in " + quoted(in.name) +
          " holds, because " + quoted(common[0]) + " is `" + shown + "`");
  if (value.origin != kComputed) {
    diagnostic.label(heap_.place(value.origin).span, "the value comes from here");
  }
  diagnostic.help("correct the value, or add a branch for it");
  add_frames(diagnostic);
}

/// Reports parameters that no call can set, and defaults that are not what they seem.
void Expander::check_parameters(const Macro& macro, const NodeAttribute& params) {
  const std::string_view text = params.text.value;
  const auto is_odd = [](std::string_view name) {
    while (name.starts_with('*')) name.remove_prefix(1);
    return name.empty() || is_digit(name[0]) ||
           name.find_first_of("\"'$(){}[],;/+") != std::string_view::npos;
  };
  for (const Macro::Parameter& one : macro.parameters) {
    const auto begin = static_cast<std::size_t>(one.name.data() - text.data());
    std::string message, help;
    std::size_t size = one.name.size();
    if (is_odd(one.name)) {
      message = "this declares a parameter called " + quoted(one.name);
      const bool is_list = one.name.ends_with(',');
      help = is_list ? "separate parameters by blanks, without commas"
                     : "put a default with blanks between single quotes: `name:='0 0 0'`";
    } else if (one.value && one.value->size() > 1 && one.value->front() == '"' &&
               one.value->back() == '"') {
      message = "the double quotes are a part of the default of " + quoted(one.name);
      help = "write single quotes";
    } else if (!one.has_default() && text.substr(begin + size).starts_with(":=")) {
      message = "the parameter " + quoted(one.name) + " has no default";
      help = "write `" + std::string(one.name) + ":=''` for an empty text, or delete `:=`";
      size += 2;
    } else {
      continue;
    }
    const Span place = part_of(params.text.whole, begin, begin + size).origin;
    if (!is_first_at(place)) continue;
    context_.sink.report(rules::sml3411_xacro_odd_parameter, place, message).help(help);
  }
}

/// Reports an element, a child of the robot, that old versions of xacro took for a call.
void Expander::check_prefix(const Node& in, const MacroTable& macros) {
  constexpr std::array<std::string_view, 26> kOfRobots = {
      "actuator", "axis",         "box",      "camera",       "collision", "color",    "cylinder",
      "dynamics", "gazebo",       "geometry", "imu",          "inertia",   "inertial", "joint",
      "limit",    "link",         "mass",     "material",     "mesh",      "mimic",    "origin",
      "plugin",   "ros2_control", "sensor",   "transmission", "visual"};
  if (in.attributes.empty()) return;
  if (std::find(kOfRobots.begin(), kOfRobots.end(), in.name) != kOfRobots.end()) return;
  const MacroTable::Entry* entry = macros.find(in.name);
  if (entry == nullptr || entry->macro == nullptr) return;
  const std::vector<Macro::Parameter>& parameters = entry->macro->parameters;
  for (const NodeAttribute& one : in.attributes) {
    const bool is_parameter =
        std::any_of(parameters.begin(), parameters.end(),
                    [&](const Macro::Parameter& other) { return other.name == one.name; });
    if (!is_parameter) return;
  }
  if (!is_first_at(in.name_span)) return;
  Diagnostic& diagnostic =
      context_.sink.report(rules::sml3412_xacro_call_without_prefix, in.name_span,
                           quoted(in.name) + " is a macro, and this element does not call it");
  diagnostic.label(entry->macro->body->tag_span, "the macro");
  diagnostic.help("write " + quoted("<xacro:" + std::string(in.name) + " ...>"));
  add_frames(diagnostic);
}

}  // namespace smurf::xacro
