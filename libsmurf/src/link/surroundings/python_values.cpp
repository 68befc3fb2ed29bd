// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "link/surroundings/python_calls.hpp"

namespace smurf::python {

const Value* Value::find(std::string_view name) const {
  const auto found = std::find_if(named.begin(), named.end(),
                                  [&](const Keyword& one) { return one.name == name; });
  return found == named.end() ? nullptr : &found->value;
}

const std::string* Value::literal() const {
  const bool is_known =
      is_text() && pieces.size() == 1 && pieces.front().kind == Piece::Kind::literal;
  return is_known ? &pieces.front().text : nullptr;
}

Span Piece::span_at(std::size_t at) const {
  const auto part =
      std::find_if(parts.begin(), parts.end(), [&](const Part& one) { return at < one.end; });
  return part == parts.end() ? span : part->span;
}

Value join_texts(const std::vector<Value>& parts, std::string_view between) {
  Value all;
  all.kind = Value::Kind::text;
  for (const Value& part : parts) {
    if (&part != &parts.front() && !between.empty()) {
      all.pieces.push_back({Piece::Kind::literal, std::string(between), part.span});
    }
    if (all.pieces.empty()) all.span = part.span;
    if (part.is_text()) {
      all.pieces.insert(all.pieces.end(), part.pieces.begin(), part.pieces.end());
    } else {
      all.pieces.push_back({Piece::Kind::unknown, "", part.span});
    }
  }
  // Literals that follow each other are one; the last one is the place.
  std::vector<Piece> joined;
  for (Piece& one : all.pieces) {
    const bool is_next = one.kind == Piece::Kind::literal && !joined.empty() &&
                         joined.back().kind == Piece::Kind::literal;
    if (!is_next) {
      joined.push_back(std::move(one));
      continue;
    }
    Piece& last = joined.back();
    if (last.parts.empty()) last.parts.push_back({last.text.size(), last.span});
    const std::size_t before = last.text.size();
    last.text += one.text;
    if (one.parts.empty()) last.parts.push_back({last.text.size(), one.span});
    for (const Piece::Part& part : one.parts) last.parts.push_back({before + part.end, part.span});
    if (one.text != between) last.span = one.span;
  }
  all.pieces = std::move(joined);
  return all;
}

}  // namespace smurf::python
