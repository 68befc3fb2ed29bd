// SPDX-License-Identifier: BSD-3-Clause
#include "write/text/json_printer.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "base/numbers/numbers.hpp"
#include "write/text/json_text.hpp"

namespace smurf {
namespace {

/// A long text reserves its memory at once: growing it step by step needs twice the memory, and
/// unused memory costs nothing.
constexpr std::size_t kLong = 1U << 20U;
constexpr std::uint64_t kMostRoom = 1U << 28U;

}  // namespace

void JsonPrinter::break_line(std::size_t depth) {
  out_ += '\n';
  out_.append(2 * depth, ' ');
}

void JsonPrinter::begin_value() {
  if (out_.size() > kLong && out_.capacity() < 4 * kLong) {
    out_.reserve(static_cast<std::size_t>(std::clamp<std::uint64_t>(most_, 4 * kLong, kMostRoom)));
  }
  if (std::exchange(has_key_, false) || open_.empty()) return;
  Open& around = open_.back();
  if (!std::exchange(around.is_empty, false)) out_ += around.layout == Layout::line ? ", " : ",";
  if (around.layout == Layout::block) break_line(open_.size());
}

void JsonPrinter::begin(char bracket, Layout layout) {
  if (!is_full()) {
    begin_value();
    out_ += bracket;
  }
  open_.push_back({bracket == '{' ? '}' : ']', layout});
}

void JsonPrinter::end() {
  assert(!open_.empty());
  const Open ended = open_.back();
  open_.pop_back();
  if (is_full()) return;
  if (ended.layout == Layout::block && !ended.is_empty) break_line(open_.size());
  out_ += ended.end;
}

void JsonPrinter::key(std::string_view name) {
  if (is_full()) return;
  begin_value();
  append_json(out_, name);
  out_ += ": ";
  has_key_ = true;
}

void JsonPrinter::member(std::string_view name, std::string_view value) {
  key(name);
  text(value);
}

void JsonPrinter::member(std::string_view name, std::initializer_list<double> values) {
  key(name);
  numbers({values.begin(), values.size()});
}

void JsonPrinter::text(std::string_view value) {
  if (is_full()) return;
  begin_value();
  append_json(out_, value);
}

void JsonPrinter::number(double value) {
  if (is_full()) return;
  begin_value();
  out_ += std::isfinite(value) ? format_number(value) : "null";
}

void JsonPrinter::integer(std::int64_t value) {
  if (is_full()) return;
  begin_value();
  out_ += std::to_string(value);
}

void JsonPrinter::boolean(bool value) {
  if (is_full()) return;
  begin_value();
  out_ += value ? "true" : "false";
}

void JsonPrinter::null() {
  if (is_full()) return;
  begin_value();
  out_ += "null";
}

void JsonPrinter::numbers(std::span<const double> values) {
  begin_list();
  for (const double value : values) number(value);
  end();
}

void JsonPrinter::vector(const Vector3& value) { numbers(value); }

void JsonPrinter::pose(const Pose& value) {
  begin_object();
  key("position");
  vector(value.position);
  key("orientation");
  begin_object();
  const Quaternion& q = value.orientation;
  for (const auto& [name, component] :
       {std::pair("w", q.w), std::pair("x", q.x), std::pair("y", q.y), std::pair("z", q.z)}) {
    key(name);
    number(std::clamp(component, -1.0, 1.0));
  }
  end();
  end();
}

void JsonPrinter::place(Span span, const SourceMap& sources) {
  // A scene made from a single model has an entity that is not in any file.
  const bool is_known = static_cast<std::size_t>(span.source) < sources.size();
  const Position position = is_known ? sources.position(span.source, span.begin) : Position{};
  begin_object();
  key("file");
  text(is_known ? sources.path(span.source) : std::string());
  key("line");
  integer(position.line);
  key("column");
  integer(position.column);
  end();
}

std::optional<std::string> JsonPrinter::take() {
  assert(open_.empty());
  if (is_full()) return std::nullopt;
  return std::move(out_) + "\n";
}

}  // namespace smurf
