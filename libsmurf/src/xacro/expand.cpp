// SPDX-License-Identifier: BSD-3-Clause
// The elements of xacro, in the order of the file.
#include <algorithm>
#include <utility>

#include "base/files/path.hpp"
#include "base/findings/limits.hpp"
#include "base/findings/rules.hpp"
#include "base/text/quoted.hpp"
#include "base/text/utf8.hpp"
#include "base/text/words.hpp"
#include "xacro/counted.hpp"
#include "xacro/expander.hpp"
#include "xacro/python_text.hpp"
#include "xacro/tokens.hpp"

namespace smurf::xacro {
namespace {

constexpr std::string_view kPrefix = "xacro:";

/// What to do about a failure that says no more itself.
/// `macro`: the name of the one around it; "" if there is none.
std::string usual_help(const Rule& rule, const std::string& macro) {
  if (&rule == &rules::sml3302_xacro_syntax) return "correct the expression";
  if (&rule == &rules::sml3304_xacro_unsupported)
    return "write it with the functions that docs/format/xacro.md lists";
  if (&rule == &rules::sml3318_xacro_fatal)
    return "the author of the description stops here; change the call, or the arguments";
  if (&rule == &rules::sml3301_xacro_unknown_name) {
    const std::string define = "define it with `<xacro:property>` before ";
    return macro.empty() ? define + "it is used"
                         : "add it to the `params` of the macro " + quoted(macro) + ", or " +
                               define + "the call";
  }
  return "correct the expression, or the values that it uses";
}

}  // namespace

Expander::Expander(SourceId root, const Settings& settings, Context& context)
    : settings_(settings),
      context_(context),
      meter_(context.limits),
      heap_(meter_),
      expressions_(heap_),
      evaluator_(heap_, expressions_, context.limits, *this) {
  result_.root = root;
  for (const auto& [name, value] : settings.arguments) arguments_[name] = {value, kComputed};
}

template <class Work>
bool Expander::guarded(Span place, const Work& work) {
  try {
    return work();
  } catch (const Exhausted&) {
    evaluator_.fail_exhausted();
    if (evaluator_.failure().span.empty()) evaluator_.failure().span = place;
    return report();
  }
}

Expansion Expander::run() {
  guarded({result_.root, 0, 0}, [&] {
    expand_root();
    return true;
  });
  result_.documents.reserve(files_.size());
  for (auto& [path, file] : files_) {
    if (file->document) result_.documents.push_back(*std::move(file->document));
  }
  return std::move(result_);
}

void Expander::expand_root() {
  functions_ = &tables_.emplace_back(heap_.arena());
  add_functions(*functions_, heap_, tables_);
  const std::string path = context_.sources.path(result_.root);
  File& file = *files_.emplace(path, std::make_unique<File>()).first->second;
  file.source = result_.root;
  file.path = path;
  file_stack_.push_back(file.path);
  result_.included.insert(file.path);
  result_.frames.push_back({});
  frame_ = FrameId{0};
  if (!parse(file)) return;
  Table& symbols = tables_.emplace_back(*functions_);
  MacroTable& macros = macro_tables_.emplace_back();
  if (file.root->name.starts_with(kPrefix)) {
    fail(rules::sml3315_xacro_wrong_element, file.root->name_span,
         "the root element must not be one of xacro", "write `<robot>` around it");
    return;
  }
  Node& root = new_node(NodeKind::element);
  root.name = file.root->name;
  root.name_span = file.root->name_span;
  root.tag_span = file.root->tag_span;
  root.span = file.root->span;
  const bool is_done = evaluate(*file.root, root, {macros, symbols});
  if (const NodeAttribute* target = file.root->attribute("xacro:targetNamespace")) {
    NodeAttribute& xmlns = root.attributes.emplace_back(*target);
    xmlns.name = "xmlns";
  }
  if (!is_done) return;
  check_unused(*file.root, root);
  std::string text;
  write_result(root, pieces_, text, settings_.needs_origins ? &result_.leaves : nullptr);
  result_.source = context_.sources.add(file.path, std::move(text));
  result_.is_complete = !has_failed_;
}

bool Expander::fail(const Rule& rule, Span place, std::string message, std::string help) {
  evaluator_.take_failure();
  evaluator_.fail(rule, std::move(message), std::move(help));
  evaluator_.failure().span = place;
  return report();
}

bool Expander::report() {
  if (has_failed_) return false;
  if (optional_includes_ > 0 && evaluator_.failure().is_missing_file) return false;
  has_failed_ = true;
  Failure failure = evaluator_.take_failure();
  Diagnostic& diagnostic = context_.sink.report(*failure.rule, failure.span, failure.message);
  if (!failure.missing.empty()) failure.help = help_with_path(failure);
  diagnostic.help(failure.help.empty() ? usual_help(*failure.rule, macro_around()) : failure.help);
  for (const auto& [place, text] : failure.labels) diagnostic.label(place, text);
  if (failure.which != nullptr) diagnostic.when(*failure.which);
  if (!failure.argument.empty()) explain_arguments(failure, diagnostic);
  result_.missing_argument = std::move(failure.argument);
  add_frames(diagnostic);
  return false;
}

bool Expander::is_first_at(Span place) {
  const std::uint64_t key = static_cast<std::uint64_t>(place.source) << 32U | place.begin;
  return warned_.insert(key).second;
}

bool Expander::has_room() {
  if (++elements_ <= context_.limits.xacro_elements) return true;
  evaluator_.fail(rules::sml3312_xacro_limit,
                  "the robot has more than " + std::to_string(context_.limits.xacro_elements) +
                      " elements",
                  raise_limit("xacro-elements"));
  return false;
}

Node& Expander::new_node(NodeKind kind) {
  heap_.charge(sizeof(Node));
  evaluator_.step();
  Node& node = nodes_.make<Node>(nodes_);
  node.kind = kind;
  node.frame = frame_;
  return node;
}

/// Comments directly before an element of xacro belong to it, but not those that the element before
/// it expands to.
void Expander::remove_comments(Node& out) {
  auto& nodes = out.children;
  const std::size_t first = kept_.parent == &out ? kept_.count : 0;
  std::size_t at = nodes.size();
  std::size_t kept = at;  // the blanks between the comments are moved to the end
  while (at > first) {
    std::size_t comment = at - 1;
    const Node& before = *nodes[comment];
    meter_.step();
    meter_.scan(before.text.value.size());
    const bool is_blank_text =
        before.kind == NodeKind::text && has_only_blanks(before.text) &&
        std::count(before.text.value.begin(), before.text.value.end(), '\n') <= 1;
    if (is_blank_text) {
      if (comment == first) break;
      --comment;
    }
    if (nodes[comment]->kind != NodeKind::comment) break;
    if (is_blank_text) nodes[--kept] = nodes[at - 1];
    at = comment;
  }
  nodes.erase(nodes.begin() + static_cast<std::ptrdiff_t>(at),
              nodes.begin() + static_cast<std::ptrdiff_t>(kept));
  kept_.is_next = at > 0;
}

void Expander::set_xmlns(Node& out, const Node& from) {
  for (const NodeAttribute& one : from.attributes) {
    if (!one.name.starts_with("xmlns:")) continue;
    if (out.attribute(one.name) == nullptr) out.attributes.push_back(one);
  }
}

const NodeAttribute* Expander::required(const Node& in, std::string_view name) {
  const NodeAttribute* attribute = in.attribute(name);
  if (attribute == nullptr) {
    fail(rules::sml3315_xacro_wrong_element, in.name_span,
         quoted(in.name) + " needs the attribute " + quoted(name),
         "add `" + std::string(name) + "=\"...\"`");
  }
  return attribute;
}

void Expander::warn_of_others(const Node& in, std::initializer_list<std::string_view> known) {
  for (const NodeAttribute& one : in.attributes) {
    const bool is_known = std::find(known.begin(), known.end(), one.name) != known.end();
    if (is_known || one.name.starts_with("xmlns:") || !is_first_at(one.name_span)) continue;
    Diagnostic& diagnostic =
        context_.sink.report(rules::sml3402_xacro_unknown_attribute, one.name_span,
                             quoted(in.name) + " has no attribute " + quoted(one.name));
    const std::vector<std::string_view> names(known);
    const auto near = context_.sink.suggest(one.name, names);
    diagnostic.help(near ? "did you mean " + quoted(*near) + "?" : "delete it");
  }
}

std::optional<bool> Expander::truth_of(const Value& value) {
  if (!value.is_text()) return is_true(value);
  const std::string& text = *value.text;
  if (text == "true" || text == "True") return true;
  if (text == "false" || text == "False") return false;
  const auto integer = read_integer(text, heap_);
  return integer ? std::optional(is_true(*integer)) : std::nullopt;
}

bool Expander::evaluate(const Node& in, Node& out, Scope scope) {
  return evaluate_attributes(in, out, scope.symbols) && evaluate_children(in, out, scope);
}

bool Expander::evaluate_attributes(const Node& in, Node& out, Table& symbols) {
  out.attributes.reserve(in.attributes.size());
  heap_.charge(in.attributes.size() * sizeof(NodeAttribute));
  for (const NodeAttribute& one : in.attributes) {
    if (one.name.starts_with(kPrefix)) continue;
    heap_.charge(one.text.value.size());
    meter_.copy(one.text.value.size());
    NodeAttribute& result = out.attributes.emplace_back(one);
    if (!one.text.is_plain) {
      check_braces(one.text, symbols);
      if (!trace(one.text, symbols, result.text)) return report();
    }
    if (one.name == "xmlns:xacro") out.attributes.pop_back();
  }
  return true;
}

bool Expander::evaluate_text_node(const Node& in, Node& out, Table& symbols) {
  Node& text = new_node(in.kind);
  text.span = in.span;
  text.tag_span = in.tag_span;
  text.name_span = in.name_span;
  if (in.frame != kNoFrame) text.frame = in.frame;
  check_braces(in.text, symbols);
  if (!trace(in.text, symbols, text.text)) return report();
  out.children.push_back(&text);
  return true;
}

bool Expander::evaluate_children(const Node& in, Node& out, Scope scope) {
  // The vectors in the arena are not given back when they grow.
  constexpr std::size_t kBytesOfChild = 4 * sizeof(Node*);
  heap_.charge(in.children.size() * kBytesOfChild);
  evaluator_.step(in.children.size() / 4);
  if (out.children.empty()) out.children.reserve(in.children.size());
  bool evaluates_comments = false;
  for (Node* const child : in.children) {
    switch (child->kind) {
    case NodeKind::element:
      evaluates_comments = false;
      kept_.is_next = false;
      if (!evaluate_element(*child, out, scope)) return false;
      if (kept_.is_next && child != in.children.back()) {
        kept_ = {&out, out.children.size(), false};
      }
      break;
    case NodeKind::text:
      // Blanks between elements stay as they are.
      if (has_only_blanks(child->text)) {
        out.children.push_back(child);
        break;
      }
      heap_.charge(child->text.value.size());
      if (!evaluate_text_node(*child, out, scope.symbols)) return false;
      if (!has_only_blanks(out.children.back()->text)) evaluates_comments = false;
      break;
    case NodeKind::comment:
      // It is written again wherever it is copied to.
      heap_.charge(child->text.value.size());
      meter_.copy(child->text.value.size());
      if (child->text.value.find("xacro:eval-comments") != std::string_view::npos) {
        evaluates_comments =
            child->text.value.find("xacro:eval-comments:off") == std::string_view::npos;
      } else if (evaluates_comments) {
        if (!evaluate_text_node(*child, out, scope.symbols)) return false;
      } else {
        out.children.push_back(child);
      }
      break;
    default:
      heap_.charge(child->text.value.size());
      out.children.push_back(child);
      break;
    }
  }
  return true;
}

bool Expander::copy_element(const Node& in, Node& out, Scope scope) {
  Node& element = new_node(NodeKind::element);
  evaluator_.step(5);
  if (!has_room()) {
    evaluator_.failure().span = in.name_span;
    return report();
  }
  element.name = in.name;
  element.name_span = in.name_span;
  element.tag_span = in.tag_span;
  element.span = in.span;
  if (in.frame != kNoFrame) element.frame = in.frame;
  if (!evaluate(in, element, scope)) return false;
  if (out.name.empty() || out.name == "robot") check_prefix(in, scope.macros);
  check_branches(in, element, scope.symbols);
  if (in.name == "inertia") check_inertia(in, scope.symbols);
  for (const NodeAttribute& one : element.attributes) {
    if (!one.is_number) continue;
    return fail(rules::sml3303_xacro_computation, one.text.whole.use,
                "`xacro:attribute` fails with a value that is no text",
                "put `str()` around the value");
  }
  out.children.push_back(&element);
  return true;
}

bool Expander::evaluate_element(const Node& in, Node& out, Scope scope) {
  return guarded(in.name_span, [&] { return run_element(in, out, scope); });
}

bool Expander::run_element(const Node& in, Node& out, Scope scope) {
  if (!in.name.starts_with(kPrefix)) return copy_element(in, out, scope);
  const std::string_view name = in.name.substr(kPrefix.size());
  evaluator_.step(5);
  if (name == "insert_block") return insert_block(in, out, scope);
  if (name == "include") return include(in, out, scope);
  if (name == "property") return define_property(in, out, scope.symbols);
  if (name == "macro") return define_macro(in, out, scope.macros);
  if (name == "arg") return define_argument(in, out, scope.symbols);
  if (name == "element") return rename_element(in, out, scope);
  if (name == "attribute") return set_attribute(in, out, scope.symbols);
  if (name == "if" || name == "unless") return choose(in, out, scope);
  return call_macro(in, name, out, scope);
}

Table* Expander::target_table(const Node& in, std::string_view scope, Table& symbols) {
  if (scope == "global") return symbols.top();
  if (scope != "parent") return &symbols;
  Table* target = symbols.parent();
  if (!symbols.is_namespace()) {
    while (target != nullptr && target->is_namespace()) target = target->parent();
  }
  if (target == nullptr || target->is_root()) {
    fail(rules::sml3315_xacro_wrong_element, in.attribute("scope")->text.whole.use,
         "there is no scope around this one", "delete `scope=\"parent\"`");
    return nullptr;
  }
  return target;
}

namespace {

/// Characters beyond ASCII that are no letters: punctuation, symbols, arrows, pictures.
bool is_sign(char32_t c) {
  if (c >= 0x80 && c < 0xC0) return c != 0xAA && c != 0xB5 && c != 0xB7 && c != 0xBA;
  return c == 0xD7 || c == 0xF7 || (c >= 0x2000 && c < 0x203F) || (c > 0x2040 && c < 0x2071) ||
         (c >= 0x20A0 && c < 0x20D0) || (c >= 0x2190 && c < 0x2C00) ||
         (c >= 0x3000 && c < 0x3005) || (c >= 0xE000 && c < 0xF900) || c == 0xFEFF ||
         (c >= 0x1F000 && c < 0x20000);
}

bool is_property_name(std::string_view name) {
  if (name.empty() || decimal_digit(utf8::decode(name).value) >= 0) return false;
  const bool has_letters_only = std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           static_cast<unsigned char>(c) >= 0x80;
  });
  const bool is_ascii = utf8::ascii_prefix(name) == name.size();
  for (std::string_view rest = name; has_letters_only && !is_ascii && !rest.empty();) {
    const utf8::CodePoint point = utf8::decode(rest);
    if (is_sign(point.value)) return false;
    rest.remove_prefix(point.size);
  }
  return has_letters_only && !is_keyword(name);
}

}  // namespace

bool Expander::define_property(const Node& in, Node& out, Table& symbols) {
  remove_comments(out);
  const NodeAttribute* name = required(in, "name");
  if (name == nullptr) return false;
  warn_of_others(in, {"name", "value", "default", "remove", "scope", "lazy_eval"});
  const Value read = evaluate_text(*name, symbols);
  if (read.is_failed()) return report();
  const std::string_view key = read.is_text() ? std::string_view(*read.text) : std::string_view();
  if (!is_property_name(key) || key.starts_with("__")) {
    return fail(rules::sml3315_xacro_wrong_element, name->text.whole.use,
                quoted(read.is_text() ? key : name->text.value) +
                    " cannot be the name of a property",
                "write a name of letters, digits and `_` that is no word of Python");
  }
  const auto flag = [&](const NodeAttribute* attribute, bool usual) -> std::optional<bool> {
    if (attribute == nullptr || attribute->text.value.empty()) return usual;
    const Value value = evaluate_text(*attribute, symbols);
    const auto truth = value.is_failed() ? std::nullopt : truth_of(value);
    if (!truth && !value.is_failed()) {
      fail(rules::sml3314_xacro_condition, attribute->text.whole.use,
           quoted(evaluator_.string_of(value)) + " is no truth value", "write `true` or `false`");
    }
    return truth;
  };
  const auto remove = flag(in.attribute("remove"), false);
  if (!remove) return report();
  const NodeAttribute* value = in.attribute("value");
  const NodeAttribute* fallback = in.attribute("default");
  if ((value != nullptr) + (fallback != nullptr) + *remove > 1) {
    return fail(rules::sml3315_xacro_wrong_element, name->text.whole.use,
                "`value`, `default` and `remove` exclude each other", "delete all but one");
  }
  const bool is_known = static_cast<bool>(symbols.find(key));
  if (*remove && is_known) {
    symbols.remove(key);
    return true;
  }
  if (fallback != nullptr) {
    if (is_known) return true;
    value = fallback;
  }
  const NodeAttribute* lazy = in.attribute("lazy_eval");
  auto is_lazy = flag(lazy, true);
  if (!is_lazy) return report();
  const NodeAttribute* scope = in.attribute("scope");
  const std::string_view wanted = scope != nullptr ? scope->text.value : std::string_view();
  if (wanted == "global" || wanted == "parent") is_lazy = false;
  Table* target = target_table(in, wanted, symbols);
  if (target == nullptr) return false;
  if (value != nullptr) check_braces(value->text, symbols);
  if (value == nullptr) {
    Value block;
    block.kind = Kind::block;
    block.block = &in;
    target->set(heap_.keep("**" + std::string(key)), block);
    return true;
  }
  Value result = *is_lazy ? heap_.text(std::string(value->text.value)).at(origin(value->text.whole))
                          : evaluate_text(*value, symbols);
  if (result.is_failed()) return report();
  if (result.origin == kComputed) result.origin = heap_.add({value->text.whole.use, false});
  set(*target, key, result, *is_lazy, name->text.whole.use);
  return true;
}

bool Expander::define_argument(const Node& in, Node& out, Table& symbols) {
  const NodeAttribute* name = required(in, "name");
  const NodeAttribute* value = name != nullptr ? required(in, "default") : nullptr;
  if (value == nullptr) return false;
  warn_of_others(in, {"name", "default"});
  const std::string key(name->text.value);
  if (!arguments_.contains(key)) {
    const Value read = evaluate_text(*value, symbols);
    if (read.is_failed()) return report();
    std::string text = evaluator_.string_of(read);
    if (evaluator_.has_failed()) {
      place_failure(value->text.whole, 0);
      return report();
    }
    const OriginId place =
        read.origin != kComputed ? read.origin : heap_.add({value->text.whole.use, false});
    arguments_[key] = {std::move(text), place};
  }
  remove_comments(out);
  return true;
}

Expansion expand(SourceId root, const Settings& settings, Context& context, std::uint64_t& steps) {
  Expander expander(root, settings, context);
  Expansion expansion = expander.run();
  steps += expander.steps();
  return expansion;
}

Expansion expand(SourceId root, const Settings& settings, Context& context) {
  std::uint64_t steps = 0;
  return expand(root, settings, context, steps);
}

bool is_xacro_file(std::string_view path) {
  return path::to_lower(path::extension(path)) == ".xacro";
}

}  // namespace smurf::xacro
