// SPDX-License-Identifier: BSD-3-Clause
// Code that the JSON-based reports share.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "base/text/utf8.hpp"
#include "smurf/diagnostic.hpp"
#include "smurf/source.hpp"

namespace smurf::render {

using Json = nlohmann::ordered_json;

/// Appends a printed value, whose lines after the first are indented by `indent` more columns. The
/// library escapes C0 only, so DEL and C1, which occur only in strings, are escaped here.
inline void append_escaped(std::string& out, const std::string& text, std::size_t indent) {
  std::size_t copied = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '\n') {
      out.append(text, copied, at + 1 - copied).append(indent, ' ');
      copied = at + 1;
    } else if (text[at] == '\x7F' || text[at] == '\xC2') {
      const utf8::CodePoint point = utf8::decode(std::string_view(text).substr(at));
      if (!utf8::is_control(point.value)) continue;
      out.append(text, copied, at - copied);
      utf8::append_escape(out, point.value);
      copied = at + point.size;
    }
  }
  out.append(text, copied);
}

/// Prints a value. Invalid UTF-8, which a path or a scalar may contain, becomes U+FFFD.
inline void append(std::string& out, const Json& json, std::size_t indent) {
  append_escaped(out, json.dump(2, ' ', false, Json::error_handler_t::replace), indent);
}

/// Prints a value in one line, which ends with a line end.
inline std::string dump_line(const Json& json) {
  std::string out;
  append_escaped(out, json.dump(-1, ' ', false, Json::error_handler_t::replace), 0);
  return out += '\n';
}

inline std::string dump(const Json& json) {
  std::string out;
  append(out, json, 0);
  return out += '\n';
}

/// Writes a report with a long list element by element, because a tree of all elements needs four
/// times the memory of their text. `report` has an empty list under `key`, nested in `depth` lists
/// and objects; `to_json` converts an item.
template <class Items, class ToJson>
std::string dump_with_list(const Json& report, std::string_view key, std::size_t depth,
                           const Items& items, ToJson to_json) {
  const std::string frame = dump(report);
  // Finds the key: strings do not contain line ends, and no other equal key has the same depth.
  const std::string line = "\n" + std::string(2 * depth, ' ') + "\"" + std::string(key) + "\": [";
  const std::size_t begin = key.empty() ? 1 : frame.find(line) + line.size();
  std::string out = frame.substr(0, begin);
  bool is_first = true;
  for (const auto& item : items) {
    out.append(is_first ? "\n" : ",\n").append(2 * depth + 2, ' ');
    append(out, to_json(item), 2 * depth + 2);
    is_first = false;
  }
  if (!is_first) out.append("\n").append(2 * depth, ' ');
  return out.append(frame, begin);
}

inline Json text(std::string_view view) { return std::string(view); }

/// Lines and columns of a span; 1:1 to 1:1 if there is no text.
struct Region {
  Position begin;
  Position end;
};
inline Region region_of(Span span, const SourceMap& sources) {
  if (static_cast<std::size_t>(span.source) >= sources.size()) return {};
  const auto size = static_cast<std::uint32_t>(sources.text(span.source).size());
  const std::uint32_t begin = std::min(span.begin, size);
  return {sources.position(span.source, begin),
          sources.position(span.source, std::clamp(span.end, begin, size))};
}

/// "" for a place without a file.
inline std::string path_of(Span span, const SourceMap& sources) {
  const bool is_known = static_cast<std::size_t>(span.source) < sources.size();
  return is_known ? sources.path(span.source) : std::string();
}

}  // namespace smurf::render
