// SPDX-License-Identifier: BSD-3-Clause
// Texts with `${...}` and `$(...)`.
#include <algorithm>
#include <cmath>
#include <optional>

#include "base/findings/limits.hpp"
#include "base/findings/rules.hpp"
#include "base/text/quoted.hpp"
#include "xacro/expander.hpp"
#include "xacro/python_text.hpp"

namespace smurf::xacro {
namespace {

/// A part of a text: plain, `${...}`, `$(...)` or `$${`.
struct TextToken {
  enum class Kind : std::uint8_t { text, expression, substitution, escape, fault };
  Kind kind = Kind::text;
  std::size_t begin = 0, end = 0;
};

/// The token at `at`.
TextToken next_token(std::string_view text, std::size_t at) {
  if (text[at] != '$') {
    return {TextToken::Kind::text, at, std::min(text.find('$', at), text.size())};
  }
  std::size_t end = text.find_first_not_of('$', at);
  if (end == std::string_view::npos) end = text.size();
  const std::size_t dollars = end - at;
  const char bracket = end < text.size() ? text[end] : '\0';
  const bool has_bracket = bracket == '{' || bracket == '(';
  if (dollars > 1) {
    return {has_bracket ? TextToken::Kind::escape : TextToken::Kind::fault, at,
            std::min(end + 1, text.size())};
  }
  if (!has_bracket) {
    // "$" is a text at the end, and before anything else.
    return {TextToken::Kind::text, at, std::min(text.find('$', at + 1), text.size())};
  }
  const std::size_t close = text.find(bracket == '{' ? '}' : ')', end);
  if (close == std::string_view::npos) return {TextToken::Kind::fault, at, text.size()};
  return {bracket == '{' ? TextToken::Kind::expression : TextToken::Kind::substitution, at,
          close + 1};
}

/// What may begin a number, as Python reads it, or a truth value.
constexpr std::string_view kOfLiterals = "0123456789+-.iInNtTfF";

/// The bytes of a text behind the first ones; none if they are not written in one place.
std::optional<Span> place_without(const Piece& text, std::uint32_t first) {
  if (!text.is_exact) return std::nullopt;
  return Span{text.origin.source, text.origin.begin + first, text.origin.end};
}

}  // namespace

Piece Expander::part_of(const Piece& whole, std::size_t begin, std::size_t end) {
  Piece piece = whole;
  piece.size = offset(end - begin);
  piece.inputs = 0;
  if (!whole.is_exact) return piece;
  piece.origin.begin = whole.origin.begin + offset(begin);
  piece.origin.end = whole.origin.begin + offset(end);
  piece.use = piece.origin;
  return piece;
}

OriginId Expander::origin(const Piece& piece) { return heap_.add({piece.origin, piece.is_exact}); }

void Expander::place_failure(const Piece& expression, std::size_t skipped) {
  Failure& failure = evaluator_.failure();
  if (failure.rule == nullptr || !failure.span.empty()) return;
  failure.span = expression.origin;
  if (!expression.is_exact || failure.end == 0) return;
  failure.span.begin =
      std::min(expression.origin.end, expression.origin.begin + offset(skipped) + failure.begin);
  failure.span.end =
      std::min(expression.origin.end, expression.origin.begin + offset(skipped) + failure.end);
  if (failure.span.empty()) failure.span = expression.origin;
}

/// Names the values that went into a computation that failed.
void Expander::name_inputs() {
  Failure& failure = evaluator_.failure();
  if (failure.rule != &rules::sml3303_xacro_computation || !failure.labels.empty()) return;
  constexpr std::size_t kMost = 4;
  for (const auto& [name, used] : evaluator_.used()) {
    if (failure.labels.size() >= kMost) return;
    failure.labels.emplace_back(heap_.place(used).span, quoted(name) + " comes from here");
  }
}

Value Expander::evaluate_expression(std::string_view inner, const Piece& place, Table& symbols,
                                    Piece& piece) {
  const Evaluator::Uses outer = evaluator_.begin_uses();
  std::string pasted;
  bool is_exact = true;
  Piece written = part_of(place, 2, 2 + inner.size());
  if (inner.find('$') != std::string_view::npos) {
    std::vector<Piece> pieces;
    const Value text = evaluate_text(inner, written, symbols, &pieces);
    if (text.is_failed()) return text;
    pasted = evaluator_.string_of(text);
    inner = pasted;
    is_exact = false;
    written.is_exact = pieces.size() == 1 && pieces[0].is_exact &&
                       pieces[0].origin.end - pieces[0].origin.begin == pasted.size();
    if (written.is_exact) written = pieces[0];
  }
  const std::string_view code = without_blanks(inner);
  const std::size_t remarks = evaluator_.remarks().size();
  const std::optional<Span> outer_place = evaluator_.code_place();
  const auto skipped = offset(static_cast<std::size_t>(code.data() - inner.data()));
  evaluator_.set_code_place(place_without(written, skipped));
  Value value = evaluator_.evaluate(code, symbols);
  evaluator_.set_code_place(outer_place);
  if (evaluator_.remarks().size() > remarks) {
    Piece exact = place;
    exact.is_exact = place.is_exact && is_exact;
    report_remarks(remarks, code, exact, 2 + skipped);
  }
  if (value.is_failed()) {
    name_inputs();
    Piece exact = place;
    exact.is_exact = place.is_exact && is_exact;
    place_failure(exact, 2 + skipped);
    return value;
  }
  if (value.origin != kComputed) {
    const Place& place_of_value = heap_.place(value.origin);
    piece.origin = place_of_value.span;
    piece.is_exact = place_of_value.is_exact;
  } else {
    piece.is_exact = false;
    constexpr std::size_t kMostInputs = 4;
    piece.first_input = offset(result_.inputs.size());
    for (const auto& [name, used] : evaluator_.used()) {
      if (piece.inputs >= kMostInputs || !settings_.needs_origins) break;
      // The name as it is written, because this copy ends with the expansion.
      const std::string_view all = context_.sources.text(place.origin);
      const std::size_t at = all.find(name);
      if (at == std::string_view::npos) continue;
      ++piece.inputs;
      result_.inputs.push_back({all.substr(at, name.size()), heap_.place(used).span});
    }
  }
  evaluator_.end_uses(outer);
  return value;
}

namespace {

/// The text that the parts of a text make.
struct Joined {
  std::string text;
  std::size_t parts = 0;
  std::size_t filled_parts = 0;  ///< that are not empty
  Piece filled;                  ///< the last of them

  void add(std::string_view shown, Piece piece, std::vector<Piece>* pieces) {
    if (parts++ == 0) text.reserve(shown.size() + 30);  // nearly always enough
    text += shown;
    piece.size = offset(shown.size());
    if (!shown.empty()) {
      ++filled_parts;
      filled = piece;
    }
    if (pieces != nullptr) pieces->push_back(piece);
  }
};

}  // namespace

/// The value of `${...}` or `$(...)`; completes its piece.
Value Expander::evaluate_code(std::string_view written, Table& symbols, Piece& piece) {
  const std::string_view code = written.substr(2, written.size() - 3);
  if (written[1] == '{') return evaluate_expression(code, piece, symbols, piece);
  const Value inner = evaluate_text(code, part_of(piece, 2, written.size() - 1), symbols, nullptr);
  if (inner.is_failed()) return inner;
  const Value value = substitute(evaluator_.string_of(inner));
  place_failure(piece, 0);
  if (value.origin != kComputed && !value.is_failed()) {
    piece.origin = heap_.place(value.origin).span;
    piece.is_exact = heap_.place(value.origin).is_exact;
  } else {
    piece.is_exact = false;
  }
  return value;
}

Value Expander::evaluate_text(std::string_view text, const Piece& place, Table& symbols,
                              std::vector<Piece>* pieces) {
  Joined joined;
  meter_.scan(text.size());
  for (std::size_t at = 0; at < text.size();) {
    evaluator_.step(2);
    const TextToken token = next_token(text, at);
    at = token.end;
    const bool is_only = joined.parts == 0 && at == text.size();
    const bool is_escape = token.kind == TextToken::Kind::escape;
    const std::size_t begin = token.begin + (is_escape ? 1 : 0);
    const std::string_view written = text.substr(begin, at - begin);
    Piece piece = part_of(place, begin, at);
    Value value;
    switch (token.kind) {
    case TextToken::Kind::text:
    case TextToken::Kind::escape:
      if (!is_only) {
        joined.add(written, piece, pieces);
        continue;
      }
      value = heap_.text(std::string(written)).at(is_escape ? kComputed : origin(piece));
      break;
    case TextToken::Kind::fault:
      evaluator_.fail(rules::sml3302_xacro_syntax,
                      written.starts_with("$$") ? "`$$` is only allowed before `{` or `(`"
                                                : "this expression is never closed",
                      written.starts_with("${") ? "add the closing `}`" : "");
      place_failure(piece, 0);
      return Value::failure();
    case TextToken::Kind::expression:
    case TextToken::Kind::substitution: value = evaluate_code(written, symbols, piece); break;
    }
    if (value.is_failed()) return value;
    if (is_only) {
      if (pieces != nullptr) pieces->push_back(piece);
      return value;
    }
    if (value.is_text()) {
      joined.add(*value.text, piece, pieces);
      continue;
    }
    const std::string shown = evaluator_.string_of(value);
    if (evaluator_.has_failed()) {
      place_failure(piece, 0);
      return Value::failure();
    }
    joined.add(shown, piece, pieces);
  }
  return text_of_parts(std::move(joined.text), place,
                       joined.filled_parts == 1 ? &joined.filled : nullptr);
}

/// `filled` is the only part that is not empty; null if there are several.
Value Expander::text_of_parts(std::string text, const Piece& place, const Piece* filled) {
  const Value all = evaluator_.text(std::move(text));
  if (all.is_failed()) {
    place_failure(place, 0);
    return all;
  }
  // If all other parts are empty, the value is the one that is left, and keeps its place:
  // `${prefix}wheel` without a prefix is the literal `wheel`.
  const bool is_one = filled != nullptr && filled->is_exact &&
                      filled->origin.end - filled->origin.begin == filled->size;
  if (is_one) return all.at(origin(*filled));
  Piece whole = place;
  whole.is_exact = false;
  return all.at(origin(whole));
}

Value Expander::evaluate_text(const NodeAttribute& attribute, Table& symbols) {
  const TracedText& text = attribute.text;
  if (text.is_plain || text.value.find('$') == std::string_view::npos) {
    return heap_.text(std::string(text.value)).at(origin(text.whole));
  }
  return evaluate_text(text.value, text.whole, symbols, nullptr);
}

bool Expander::trace(const TracedText& in, Table& symbols, TracedText& out) {
  if (in.is_plain || in.value.find('$') == std::string_view::npos) {
    out = in;
    return true;
  }
  std::vector<Piece>& pieces = traced_;
  pieces.clear();
  Piece place = in.whole;
  place.is_exact = place.is_exact && in.pieces == 0;
  const Value value = evaluate_text(in.value, place, symbols, &pieces);
  if (value.is_failed()) return false;
  std::string_view text;
  if (value.is_text()) {
    text = *value.text;
  } else {
    text = heap_.keep(evaluator_.string_of(value));
    if (evaluator_.has_failed()) {
      place_failure(place, 0);
      return false;
    }
  }
  if (pieces.size() == 1) pieces[0].size = offset(text.size());
  out = {};
  out.value = text;
  out.whole = in.whole;
  out.whole.size = offset(text.size());
  out.whole.is_exact = false;
  std::size_t at = 0;
  for (Piece& piece : pieces) {
    const bool is_same = piece.is_exact && piece.origin.end - piece.origin.begin == piece.size &&
                         context_.sources.text(piece.origin) == text.substr(at, piece.size);
    piece.is_exact = is_same;
    at += piece.size;
  }
  if (pieces.size() == 1) {
    out.whole = pieces[0];
    return true;
  }
  out.first_piece = offset(pieces_.size());
  out.pieces = offset(pieces.size());
  heap_.charge(pieces.size() * sizeof(Piece));
  pieces_.insert(pieces_.end(), pieces.begin(), pieces.end());
  return true;
}

Value Expander::literal(const Value& value) {
  if (!value.is_text()) return value;
  const std::string& text = *value.text;
  meter_.copy(text.size());
  if (text.size() >= 2 && text.front() == '\'' && text.back() == '\'') {
    Place place = heap_.place(value.origin);
    if (place.is_exact) {
      ++place.span.begin;
      --place.span.end;
    }
    const Value inner = heap_.text(text.substr(1, text.size() - 2));
    return inner.at(value.origin == kComputed ? kComputed : heap_.add(place));
  }
  // Most texts are neither numbers nor truth values, which their first character tells.
  const char first = text.empty() ? '\0' : text.front();
  if (first > ' ' && first <= '~' && kOfLiterals.find(first) == std::string_view::npos)
    return value;
  // Python ignores underscores in numbers; here, they are texts.
  if (text.empty() || text.find('_') != std::string::npos) return value;
  if (const auto integer = read_integer(text, heap_)) return integer->at(value.origin);
  if (const auto real = read_float(text)) return Value::of(*real).at(value.origin);
  if (text == "true" || text == "True") return Value::of(true).at(value.origin);
  if (text == "false" || text == "False") return Value::of(false).at(value.origin);
  return value;
}

namespace {

/// Whether both are numbers that differ by rounding only: many robots define `pi` themselves.
bool is_nearly(const Value& a, const Value& b) {
  const auto x = to_real(a), y = to_real(b);
  constexpr double kRounding = 1e-4;
  return x && y && std::abs(*x - *y) < kRounding;
}

}  // namespace

void Expander::set(Table& table, std::string_view name, const Value& value, bool is_unevaluated,
                   Span place) {
  const Table::Entry* hidden = table.root()->own(name);
  if (hidden != nullptr && !is_nearly(hidden->value, literal(value)) && is_first_at(place)) {
    Diagnostic& diagnostic = context_.sink.report(
        rules::sml3401_xacro_hides_function, place,
        quoted(name) + " is a function or a constant of expressions, and is hidden from here on");
    diagnostic.help("give it another name");
  }
  const Value read = literal(value);
  table.set(name, read, is_unevaluated && read.is_text());
}

void Expander::assign(Table& table, std::string_view name, const Value& value) {
  set(table, name, value, true, {});
}

Value Expander::resolve(Table& table, Table::Entry& entry, std::string_view name) {
  if (entry.is_evaluating) {
    std::string chain;
    const auto first = std::find(resolving_.begin(), resolving_.end(), name);
    for (auto at = first; at != resolving_.end(); ++at) chain += quoted(*at) + " -> ";
    return evaluator_.fail(rules::sml3316_xacro_cycle,
                           "the property is defined by itself: " + chain + quoted(name),
                           "compute it at its definition, with `lazy_eval=\"false\"`");
  }
  if (resolving_.size() >= context_.limits.xacro_depth) {
    return evaluator_.fail(rules::sml3312_xacro_limit,
                           "more than " + std::to_string(context_.limits.xacro_depth) +
                               " properties are defined by each other",
                           raise_limit("xacro-depth"));
  }
  entry.is_evaluating = true;
  resolving_.push_back(name);
  const Place place = heap_.place(entry.value.origin);
  Piece piece;
  piece.is_exact = place.is_exact;
  piece.origin = piece.use = place.span;
  Value value = literal(evaluate_text(*entry.value.text, piece, table, nullptr));
  resolving_.pop_back();
  entry.is_evaluating = false;
  if (value.is_failed()) return value;
  if (value.origin == kComputed) value.origin = heap_.add({place.span, false});
  entry.value = value;
  entry.is_unevaluated = false;
  return value;
}

}  // namespace smurf::xacro
