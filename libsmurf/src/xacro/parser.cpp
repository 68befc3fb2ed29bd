// SPDX-License-Identifier: BSD-3-Clause
// Texts of operators, and each expression parsed once.
#include <algorithm>

#include "base/findings/rules.hpp"
#include "base/text/words.hpp"
#include "xacro/parser.hpp"

namespace smurf::xacro {

std::string_view text_of(Operation operation) {
  constexpr std::string_view kTexts[] = {
      "+", "-", "*", "/", "//", "%", "**", "@",  "<<", ">>", "&",      "|",  "^",
      "-", "+", "~", "<", "<=", ">", ">=", "==", "!=", "in", "not in", "is", "is not"};
  return kTexts[static_cast<std::size_t>(operation)];
}

Expressions::Expressions(Heap& heap) : heap_(heap), known_(ArenaAllocator<Known>(heap.arena())) {}
Expressions::~Expressions() = default;

const Expression& Expressions::parse(std::string_view text) {
  const auto known = known_.find(text);
  if (known != known_.end()) return known->second;
  const auto place = known_.emplace(heap_.keep(text), Expression{}).first;
  Expression& expression = place->second;
  heap_.charge(text.size() * 20);  // trees need about this much
  SyntaxFault fault;
  expression.root = Parser(*this, place->first, fault).run();
  if (expression.root == nullptr) expression.fault = &faults_.emplace_back(std::move(fault));
  return expression;
}

}  // namespace smurf::xacro
