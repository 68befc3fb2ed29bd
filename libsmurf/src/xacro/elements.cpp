// SPDX-License-Identifier: BSD-3-Clause
// Elements of xacro that change or insert others: blocks, names, attributes, conditions.
#include <algorithm>

#include "base/findings/limits.hpp"
#include "base/findings/rules.hpp"
#include "base/text/quoted.hpp"
#include "xacro/expander.hpp"

namespace smurf::xacro {

bool Expander::insert_block(const Node& in, Node& out, Scope scope) {
  const NodeAttribute* name = required(in, "name");
  if (name == nullptr) return false;
  warn_of_others(in, {"name"});
  const std::string many = "**" + std::string(name->text.value);
  Table::Found found = scope.symbols.find(many);
  const bool has_content_only = static_cast<bool>(found);
  if (!found) found = scope.symbols.find(std::string_view(many).substr(1));
  if (!found || found.entry->value.kind != Kind::block) {
    return fail(rules::sml3308_xacro_block, name->text.whole.use,
                "there is no block " + quoted(name->text.value),
                "add `*" + std::string(name->text.value) + "` to the parameters of the macro");
  }
  const Node& block = *found.entry->value.block;
  if (depth_ >= context_.limits.xacro_depth) {
    return fail(rules::sml3312_xacro_limit, in.name_span, "blocks and macros are nested too deeply",
                raise_limit("xacro-depth"));
  }
  ++depth_;
  bool is_done = false;
  if (has_content_only) {
    Node& holder = new_node(NodeKind::element);
    is_done = evaluate(block, holder, scope);
    out.children.insert(out.children.end(), holder.children.begin(), holder.children.end());
  } else {
    is_done = copy_element(block, out, scope);
  }
  --depth_;
  return is_done;
}

bool Expander::rename_element(const Node& in, Node& out, Scope scope) {
  const NodeAttribute* name = required(in, "xacro:name");
  if (name == nullptr) return false;
  const Value value = evaluate_text(*name, scope.symbols);
  if (value.is_failed()) return report();
  if (!value.is_text() || value.text->empty()) {
    return fail(rules::sml3315_xacro_wrong_element, name->text.whole.use,
                "the name of the element is empty, or is no text", "write a name");
  }
  Node& renamed = nodes_.make<Node>(in);
  renamed.name = *value.text;
  std::erase_if(renamed.attributes,
                [](const NodeAttribute& one) { return one.name == "xacro:name"; });
  return evaluate_element(renamed, out, scope);
}

bool Expander::set_attribute(const Node& in, Node& out, Table& symbols) {
  const NodeAttribute* name = required(in, "name");
  const NodeAttribute* value = name != nullptr ? required(in, "value") : nullptr;
  if (value == nullptr) return false;
  const Value key = evaluate_text(*name, symbols);
  if (key.is_failed()) return report();
  const Value read = evaluate_text(*value, symbols);
  if (read.is_failed()) return report();
  if (!key.is_text() || key.text->empty()) {
    return fail(rules::sml3315_xacro_wrong_element, name->text.whole.use,
                "the name of the attribute is empty, or is no text", "write a name");
  }
  if (out.name.empty() && is_first_at(in.tag_span)) {
    Diagnostic& diagnostic =
        context_.sink.report(rules::sml3403_xacro_lost_attribute, in.tag_span,
                             "the attribute " + quoted(*key.text) + " is lost");
    diagnostic.note("the parent of `xacro:attribute` is no element of the robot");
    diagnostic.help("put it directly into the element that gets the attribute");
    add_frames(diagnostic);
    return true;
  }
  NodeAttribute attribute;
  attribute.name = *key.text;
  attribute.name_span = in.name_span;
  attribute.span = in.tag_span;
  attribute.is_number = !read.is_text();
  if (!trace(value->text, symbols, attribute.text)) return report();
  const auto old =
      std::find_if(out.attributes.begin(), out.attributes.end(),
                   [&](const NodeAttribute& one) { return one.name == attribute.name; });
  if (old != out.attributes.end()) {
    *old = attribute;
  } else {
    out.attributes.push_back(attribute);
  }
  return true;
}

bool Expander::choose(const Node& in, Node& out, Scope scope) {
  remove_comments(out);
  const NodeAttribute* condition = required(in, "value");
  if (condition == nullptr) return false;
  warn_of_others(in, {"value"});
  const Value value = evaluate_text(*condition, scope.symbols);
  if (value.is_failed()) return report();
  const auto truth = truth_of(value);
  if (!truth) {
    const std::string shown = evaluator_.string_of(value);
    return fail(rules::sml3314_xacro_condition, condition->text.whole.use,
                "the condition is " + (shown.empty() ? "an empty text" : quoted(shown)) +
                    ", which is no truth value",
                "write a comparison, or use `true` or `false`");
  }
  if (*truth == in.name.ends_with("unless")) return true;
  Node& holder = new_node(NodeKind::element);
  // xacro evaluates the attributes again; this matters only if they call functions.
  const bool has_call = condition->text.value.find('(') != std::string_view::npos;
  if ((has_call || in.attributes.size() > 1) && !evaluate_attributes(in, holder, scope.symbols)) {
    return false;
  }
  if (!evaluate_children(in, holder, scope)) return false;
  out.children.insert(out.children.end(), holder.children.begin(), holder.children.end());
  return true;
}

}  // namespace smurf::xacro
