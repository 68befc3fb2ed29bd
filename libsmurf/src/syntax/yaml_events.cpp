// SPDX-License-Identifier: BSD-3-Clause
#include "syntax/yaml_events.hpp"

#include "base/findings/cases.hpp"
#include "base/findings/rules.hpp"
#include "syntax/yaml_spans.hpp"

namespace smurf {

using Collection = YamlBuilder::Collection;

void YamlEvents::OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) {
  // An absent value has the mark of the next token; only a written null has a place.
  const std::uint32_t begin = skip_properties(text_, offset(mark));
  const std::uint32_t size = written_null(begin);
  if (size > 0) return builder_.add_null(builder_.span(begin, begin + size), anchor);
  const std::uint32_t at = absent_place(offset(mark));
  check_absent(offset(mark));
  check_colon();
  builder_.add_null(builder_.span(at, at), anchor);
}

void YamlEvents::OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) {
  const std::uint32_t begin = offset(mark);
  std::uint32_t end = begin + 1;
  while (end < text_.size() &&
         std::string_view(" \t\r\n,[]{}").find(text_[end]) == std::string_view::npos) {
    ++end;
  }
  builder_.add_alias(builder_.span(begin, end), anchor);
}

void YamlEvents::OnScalar(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                          const std::string& value) {
  const ScalarExtent extent = scalar_extent(text_, offset(mark), value);
  Span span = builder_.span(extent.begin, extent.end);
  if (span.empty()) span.begin = span.end = absent_place(offset(mark));  // there is only a tag
  if (!extent.closed) {
    sink_
        .report(rules::sml0010_yaml_syntax, builder_.span(extent.begin, extent.begin + 1),
                "this quote is never closed")
        .when(cases::kQuote);
  }
  const std::string_view bytes = text_.substr(extent.begin, extent.end - extent.begin);
  const std::string_view inner = extent.style == yaml::Style::plain || bytes.size() < 2
                                     ? bytes
                                     : bytes.substr(1, bytes.size() - 2);
  builder_.add_scalar(span, extent.style, inner == value ? inner : builder_.keep(value), anchor);
}

std::uint32_t YamlEvents::absent_place(std::uint32_t mark) const {
  if (builder_.collections().empty() || builder_.expects_key()) return mark;
  const Collection& innermost = builder_.collections().back();
  const std::uint32_t before = innermost.has_key ? innermost.key_span.end : innermost.end;
  const std::uint32_t sign = skip_blank(text_, before);
  const bool is_sign = sign < text_.size() && text_[sign] == (innermost.has_key ? ':' : '-');
  return is_sign ? sign + 1 : innermost.has_key ? before : mark;
}

bool YamlEvents::is_in_flow() const {
  const auto& collections = builder_.collections();
  return std::any_of(collections.begin(), collections.end(),
                     [](const Collection& one) { return one.is_flow; });
}

std::uint32_t YamlEvents::written_null(std::uint32_t begin) const {
  for (const std::string_view word : {"~", "null", "Null", "NULL"}) {
    if (!text_.substr(begin).starts_with(word)) continue;
    const std::size_t end = begin + word.size();
    const std::size_t next = std::min(text_.find_first_not_of(" \t", end), text_.size());
    const char sign = next < text_.size() ? text_[next] : '\n';
    const auto size = static_cast<std::uint32_t>(word.size());
    if (sign == ':') return builder_.expects_key() ? size : 0;
    // Otherwise, the text continues, as in `null hypothesis: 1` below an absent value.
    const bool is_comment = sign == '#' && next > end;
    const bool is_closed = std::string_view(",]}").find(sign) != std::string_view::npos;
    if (sign == '\n' || sign == '\r' || is_comment || (is_closed && is_in_flow())) return size;
  }
  return 0;
}

void YamlEvents::check_absent(std::uint32_t at_offset) {
  if (builder_.collections().empty()) return;
  const Collection& innermost = builder_.collections().back();
  if (!innermost.is_flow || innermost.has_key) return;
  if (at_offset >= text_.size() || text_[at_offset] != ',') return;
  sink_.report(rules::sml0010_yaml_syntax, builder_.span(at_offset, at_offset + 1),
               "there is no entry before this comma");
}

/// At the end of a mapping, yaml-cpp reads a line that fits nowhere as a key without value.
void YamlEvents::check_colon() {
  const auto& collections = builder_.collections();
  if (collections.empty() || is_in_flow() || !collections.back().has_key) return;
  const Span key = collections.back().key_span;
  const std::uint32_t sign = skip_blank(text_, key.end);
  if (key.empty() || (sign < text_.size() && text_[sign] == ':')) return;
  const std::size_t before =
      key.begin == 0 ? std::string_view::npos : text_.find_last_not_of(" \t", key.begin - 1);
  if (before != std::string_view::npos && text_[before] == '?') return;  // `? key` needs no colon
  sink_
      .report(rules::sml0010_yaml_syntax, {key.source, key.begin, key.begin + 1},
              "this line does not fit the lines above it: without a `:`, it is not a key")
      .when(cases::kLine);
}

void YamlEvents::open(yaml::Kind kind, const YAML::Mark& mark, YAML::anchor_t anchor,
                      YAML::EmitterStyle::value style) {
  builder_.open(kind, skip_properties(text_, offset(mark)), style == YAML::EmitterStyle::Flow,
                anchor);
}

void YamlEvents::close() {
  const Collection& innermost = builder_.collections().back();
  if (!innermost.is_flow) return builder_.close();
  builder_.close(flow_end(text_, std::max(innermost.end, builder_.begin(innermost) + 1)));
}

}  // namespace smurf
