// SPDX-License-Identifier: BSD-3-Clause
// Macros: their parameters, and their calls.
#include <algorithm>

#include "base/findings/limits.hpp"
#include "base/findings/rules.hpp"
#include "base/text/quoted.hpp"
#include "base/text/suggest.hpp"
#include "xacro/expander.hpp"
#include "xacro/python_text.hpp"

namespace smurf::xacro {

const MacroTable::Entry* MacroTable::own(std::string_view name) const {
  const auto found = entries_.find(name);
  return found == entries_.end() ? nullptr : &found->second;
}

const MacroTable::Entry* MacroTable::find(std::string_view name) const {
  for (const MacroTable* at = this; at != nullptr; at = at->parent_) {
    if (const Entry* entry = at->own(name)) return entry;
  }
  return nullptr;
}

void MacroTable::append_names(std::vector<std::string_view>& names) const {
  for (const MacroTable* at = this; at != nullptr; at = at->parent_) {
    for (const auto& [name, entry] : at->entries_) {
      if (entry.macro != nullptr) names.push_back(name);
    }
  }
}

namespace {

bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/// Finds the end of a default as the regular expression of xacro does: one `${...}`, one `$(...)`,
/// or a run of texts in quotes and of other characters. A blank or the end follows. Quotes end at
/// the nearest quote from which the rest matches, so `'''` is one text.
class DefaultEnd {
 public:
  explicit DefaultEnd(std::string_view text) : text_(text), failed_(text.size() + 1, false) {}

  std::size_t find(std::size_t at) {
    for (const auto& [open, close] : {std::pair{"${", '}'}, std::pair{"$(", ')'}}) {
      if (!text_.substr(at).starts_with(open)) continue;
      for (std::size_t end = text_.find(close, at + 2); end != std::string_view::npos;
           end = text_.find(close, end + 1)) {
        if (is_end(end + 1)) return end + 1;
      }
    }
    const std::size_t end = run(at);
    if (end != std::string_view::npos) return end;
    return is_end(at) ? at : std::string_view::npos;
  }

 private:
  static constexpr int kMostSteps = 2'000;  // parts of a default; real ones have two

  bool is_end(std::size_t at) const { return at >= text_.size() || is_space(text_[at]); }

  /// The end of a run with at least one part; npos if there is none.
  std::size_t run(std::size_t at) {
    if (at >= text_.size() || failed_[at] || is_space(text_[at])) return std::string_view::npos;
    if (++steps_ > kMostSteps) return std::string_view::npos;
    const char c = text_[at];
    if (c == '\'' || c == '"') {
      for (std::size_t close = text_.find(c, at + 1); close != std::string_view::npos;
           close = text_.find(c, close + 1)) {
        if (steps_ > kMostSteps) return std::string_view::npos;
        const std::size_t end = run_or_end(close + 1);
        if (end != std::string_view::npos) return end;
      }
    } else {
      const std::size_t stop = std::min(text_.find_first_of(" \t\n\r\f\v'\"", at), text_.size());
      const std::size_t end = run_or_end(stop);
      if (end != std::string_view::npos) return end;
    }
    failed_[at] = true;
    return std::string_view::npos;
  }
  std::size_t run_or_end(std::size_t at) {
    const std::size_t end = run(at);
    return end != std::string_view::npos ? end : is_end(at) ? at : std::string_view::npos;
  }

  std::string_view text_;
  std::vector<bool> failed_;
  int steps_ = 0;
};

/// A parameter as it is written, and where the next one begins.
struct Written {
  Macro::Parameter parameter;
  std::size_t value_begin = 0;
  std::size_t next = 0;
};

/// "name:=default", "name=default", "name:=^|default".
bool read_with_default(std::string_view text, std::size_t at, Written& written) {
  std::size_t end = at;
  while (end < text.size() && !is_space(text[end]) && text[end] != ':' && text[end] != '=') ++end;
  if (end == at) return false;
  written.parameter.name = text.substr(at, end - at);
  while (end < text.size() && is_space(text[end])) ++end;
  if (end < text.size() && text[end] == ':') ++end;
  if (end >= text.size() || text[end] != '=') return false;
  ++end;
  while (end < text.size() && is_space(text[end])) ++end;
  if (end < text.size() && text[end] == '^') {
    written.parameter.forwards = true;
    end += text.substr(end).starts_with("^|") ? 2 : 1;
  }
  const std::size_t stop = DefaultEnd(text).find(end);
  if (stop == std::string_view::npos) return false;
  if (stop > end) written.parameter.value = text.substr(end, stop - end);
  written.value_begin = end;
  written.next = stop;
  return true;
}

}  // namespace

void Expander::read_parameters(Macro& macro, const NodeAttribute& params) {
  const std::string_view text = params.text.value;
  std::size_t at = 0;
  for (;;) {
    while (at < text.size() && is_space(text[at])) ++at;
    if (at >= text.size()) return;
    Written written;
    if (!read_with_default(text, at, written)) {
      std::size_t end = at;
      while (end < text.size() && !is_space(text[end])) ++end;
      written = {};
      written.parameter.name = text.substr(at, end - at);
      written.next = end;
    } else if (written.parameter.value) {
      const Piece piece = part_of(params.text.whole, written.value_begin, written.next);
      written.parameter.place = piece.origin;
      written.parameter.is_exact = piece.is_exact;
    }
    macro.parameters.push_back(written.parameter);
    at = written.next;
  }
}

bool Expander::define_macro(const Node& in, Node& out, MacroTable& macros) {
  remove_comments(out);
  const NodeAttribute* name = required(in, "name");
  if (name == nullptr) return false;
  warn_of_others(in, {"name", "params"});
  std::string_view written = name->text.value;
  if (written == "call") {
    return fail(rules::sml3315_xacro_wrong_element, name->text.whole.use,
                "a macro must not be called `call`", "give it another name");
  }
  if (written.find('.') != std::string_view::npos) {
    return fail(rules::sml3315_xacro_wrong_element, name->text.whole.use,
                "the name of a macro must not contain `.`", "give it another name");
  }
  if (written.starts_with("xacro:")) written.remove_prefix(6);
  // A new one, because a macro may define itself again while it is called.
  heap_.charge(sizeof(Macro));
  Macro* macro = &macros_.emplace_back();
  macro->name = written;
  macro->body = &in;
  if (const NodeAttribute* params = in.attribute("params")) {
    read_parameters(*macro, *params);
    check_parameters(*macro, *params);
  }
  macros.set(written, {macro, nullptr});
  return true;
}

Expander::Resolved Expander::resolve_macro(std::string_view name, Scope scope) {
  const MacroTable::Entry* entry = scope.macros.find(name);
  if (entry != nullptr) return {&scope.macros, &scope.symbols, entry->macro};
  MacroTable* macros = &scope.macros;
  Table* symbols = &scope.symbols;
  std::string_view rest = name;
  for (std::size_t dot = rest.find('.'); dot != std::string_view::npos; dot = rest.find('.')) {
    const std::string_view space = rest.substr(0, dot);
    rest.remove_prefix(dot + 1);
    const MacroTable::Entry* inner = macros->find(space);
    const Table::Found names = symbols->find(space);
    if (inner == nullptr || inner->name_space == nullptr || !names ||
        names.entry->value.kind != Kind::name_space) {
      return {};
    }
    macros = inner->name_space;
    symbols = names.entry->value.table;
  }
  entry = rest.size() == name.size() ? nullptr : macros->find(rest);
  return entry != nullptr ? Resolved{macros, symbols, entry->macro} : Resolved{};
}

bool Expander::fail_unknown_macro(const Node& in, std::string_view name, Scope scope) {
  std::vector<std::string_view> known;
  scope.macros.append_names(known);
  for (const std::string_view one : {"property", "macro", "include", "arg", "if", "unless",
                                     "insert_block", "element", "attribute", "call"}) {
    known.push_back(one);
  }
  std::sort(known.begin(), known.end());
  known.erase(std::unique(known.begin(), known.end()), known.end());
  std::uint64_t comparisons = 1'000'000;
  const auto near = only_nearest(name, known, comparisons);
  return fail(rules::sml3305_xacro_unknown_macro, in.name_span, "there is no macro " + quoted(name),
              near ? "did you mean " + quoted("xacro:" + std::string(*near)) + "?"
                   : "include the file that defines it before this call");
}

bool Expander::call_by_name(const Node& in, Node& out, Scope scope) {
  const NodeAttribute* macro = required(in, "macro");
  if (macro == nullptr) return false;
  const Value value = evaluate_text(*macro, scope.symbols);
  if (value.is_failed()) return report();
  const std::string_view name = heap_.keep(evaluator_.string_of(value));
  if (evaluator_.has_failed()) return report();
  if (name.empty()) {
    return fail(rules::sml3315_xacro_wrong_element, macro->text.whole.use,
                "the name of the macro is empty", "name a macro");
  }
  Node& call = nodes_.make<Node>(in);
  std::erase_if(call.attributes, [](const NodeAttribute& one) { return one.name == "macro"; });
  return call_macro(call, name, out, scope);
}

bool Expander::call_macro(const Node& in, std::string_view name, Node& out, Scope scope) {
  if (name == "call") return call_by_name(in, out, scope);
  const Resolved resolved = resolve_macro(name, scope);
  if (resolved.macro == nullptr) return fail_unknown_macro(in, name, scope);
  if (depth_ >= context_.limits.xacro_depth) {
    const Frame& around = result_.frames[static_cast<std::size_t>(frame_)];
    const bool is_own = around.definition == resolved.macro->body->tag_span;
    const std::string depth = std::to_string(context_.limits.xacro_depth);
    return fail(rules::sml3312_xacro_limit, in.name_span,
                is_own ? quoted(name) + " calls itself more than " + depth + " times"
                       : "more than " + depth + " macros call each other",
                (is_own ? "put the call into an `<xacro:if>` that ends it, or " : std::string()) +
                    raise_limit("xacro-depth"));
  }
  constexpr std::uint64_t kStepsOfCall = 50;
  evaluator_.step(kStepsOfCall + resolved.macro->parameters.size());
  // The table has a slot of about as many bytes for each parameter.
  constexpr std::size_t kBytesOfParameter = 160;
  constexpr std::size_t kBytesOfFrame = 2 * sizeof(Frame) + 100;  // with its parameters as a text
  heap_.charge(sizeof(Table) + sizeof(MacroTable) + kBytesOfFrame +
               resolved.macro->parameters.size() * kBytesOfParameter);
  ++depth_;
  const FrameId outer = frame_;
  const bool is_done = run_macro(in, resolved, out, scope);
  frame_ = outer;
  --depth_;
  return is_done;
}

bool Expander::pass_parameters(const Node& in, const Macro& macro, Table& inner, Scope scope,
                               std::vector<const Macro::Parameter*>& left, std::string& shown) {
  constexpr std::size_t kMostShown = 80;  // characters
  for (const NodeAttribute& attribute : in.attributes) {
    evaluator_.step(left.size() / 4);
    const auto found = std::find_if(left.begin(), left.end(), [&](const Macro::Parameter* one) {
      return one->name == attribute.name;
    });
    if (found == left.end()) {
      std::vector<std::string_view> known;
      for (const Macro::Parameter* one : left) known.push_back(one->name);
      const auto near = only_nearest(attribute.name, known);
      return fail(rules::sml3307_xacro_surplus_parameter, attribute.name_span,
                  "the macro " + quoted(macro.name) + " has no parameter " + quoted(attribute.name),
                  near ? "did you mean " + quoted(*near) + "?" : "delete it");
    }
    left.erase(found);
    check_braces(attribute.text, scope.symbols);
    Value value = evaluate_text(attribute, scope.symbols);
    if (value.is_failed()) return report();
    if (value.origin == kComputed) value.origin = heap_.add({attribute.text.whole.use, false});
    value = literal(value);
    inner.set(attribute.name, value);
    if (functions_->own(attribute.name) != nullptr)
      set(inner, attribute.name, value, false, attribute.name_span);
    if (shown.size() < kMostShown) {
      NoText problem{meter_, {}, kMostShown};
      const std::string made = value.is_text() ? std::string() : text_of(value, problem);
      const std::string_view text = value.is_text() ? std::string_view(*value.text) : made;
      if (!shown.empty()) shown += " ";
      shown.append(attribute.name).append("=").append(text.substr(0, kMostShown));
    }
  }
  return true;
}

bool Expander::pass_blocks(const Node& in, const Macro& macro, Table& inner, Scope scope,
                           std::vector<const Macro::Parameter*>& left) {
  Node& blocks = new_node(NodeKind::element);
  if (!evaluate_children(in, blocks, scope)) return false;
  auto next = blocks.children.begin();
  const auto skip_texts = [&] {
    while (next != blocks.children.end() && (*next)->kind != NodeKind::element) ++next;
    return next != blocks.children.end();
  };
  for (auto one = left.begin(); one != left.end();) {
    const Macro::Parameter& parameter = **one;
    if (!parameter.name.starts_with('*')) {
      ++one;
      continue;
    }
    if (!skip_texts()) {
      return fail(rules::sml3308_xacro_block, in.name_span,
                  "the macro " + quoted(macro.name) + " needs a child element for its block " +
                      quoted(parameter.name),
                  "add a child element to the call");
    }
    Value block;
    block.kind = Kind::block;
    block.block = *next++;
    inner.set(parameter.name, block);
    one = left.erase(one);
  }
  if (!skip_texts()) return true;
  return fail(rules::sml3308_xacro_block, (*next)->name_span,
              "the macro " + quoted(macro.name) + " has no block for " + quoted((*next)->name),
              "delete the element, or add `*NAME` to the parameters of the macro");
}

bool Expander::pass_defaults(const Node& in, const Macro& macro, Table& inner, Scope scope,
                             std::vector<const Macro::Parameter*>& left) {
  std::string missing;
  for (const Macro::Parameter* parameter : left) {
    Value value = Value::failure();
    if (parameter->name.starts_with('*') || !parameter->has_default()) {
      missing += (missing.empty() ? "" : ", ") + quoted(parameter->name);
      continue;
    }
    const Table::Found forwarded =
        parameter->forwards ? scope.symbols.find(parameter->name) : Table::Found{};
    if (forwarded) {
      value = forwarded.entry->is_unevaluated
                  ? resolve(*forwarded.table, *forwarded.entry, parameter->name)
                  : forwarded.entry->value;
    } else if (parameter->value) {
      Piece place;
      place.is_exact = parameter->is_exact;
      place.origin = place.use = parameter->place;
      value = evaluate_text(*parameter->value, place, scope.symbols, nullptr);
      if (!value.is_failed() && value.origin == kComputed)
        value.origin = heap_.add({parameter->place, false});
    } else {
      return fail(rules::sml3306_xacro_missing_parameter, in.name_span,
                  "the caller has no property " + quoted(parameter->name) + " for the macro " +
                      quoted(macro.name),
                  "define it, or add the parameter to the call");
    }
    if (value.is_failed()) return report();
    inner.set(parameter->name, literal(value));
  }
  if (missing.empty()) return true;
  return fail(rules::sml3306_xacro_missing_parameter, in.name_span,
              "the call of " + quoted(macro.name) + " lacks " + missing, "add it to the call");
}

bool Expander::run_macro(const Node& in, const Resolved& resolved, Node& out, Scope scope) {
  const Macro& macro = *resolved.macro;
  Table& inner = tables_.emplace_back(*resolved.symbols);
  MacroTable& inner_macros = macro_tables_.emplace_back(resolved.macros);
  std::vector<const Macro::Parameter*> left;
  left.reserve(macro.parameters.size());
  for (const Macro::Parameter& one : macro.parameters) left.push_back(&one);
  std::string shown;
  if (!pass_parameters(in, macro, inner, scope, left, shown)) return false;
  if (!pass_blocks(in, macro, inner, scope, left)) return false;
  if (!pass_defaults(in, macro, inner, scope, left)) return false;
  Frame frame;
  frame.kind = Frame::Kind::macro;
  frame.parent = frame_;
  frame.call = in.tag_span;
  frame.definition = macro.body->tag_span;
  frame.name = macro.name;
  frame.parameters = std::move(shown);
  result_.frames.push_back(std::move(frame));
  frame_ = FrameId{static_cast<std::uint32_t>(result_.frames.size() - 1)};
  Node& body = new_node(NodeKind::element);
  if (!evaluate(*macro.body, body, {inner_macros, inner})) return false;
  remove_comments(out);
  set_xmlns(out, body);
  out.children.insert(out.children.end(), body.children.begin(), body.children.end());
  return true;
}

std::string Expander::macro_around() const {
  if (frame_ == kNoFrame) return {};
  const Frame& frame = result_.frame(frame_);
  return frame.kind == Frame::Kind::macro ? frame.name : std::string();
}

}  // namespace smurf::xacro
