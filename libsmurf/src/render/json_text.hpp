// SPDX-License-Identifier: BSD-3-Clause
// What the reports made of JSON have in common.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "base/utf8.hpp"
#include "smurf/diagnostic.hpp"
#include "smurf/source.hpp"

namespace smurf::render {

using Json = nlohmann::ordered_json;

/// Invalid UTF-8, which a path or a scalar may hold, becomes U+FFFD. The library escapes C0 only:
/// DEL and C1, which can stand in strings alone, are escaped here.
inline std::string dump(const Json& json) {
  const std::string text = json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  std::string out;
  std::size_t copied = 0;
  for (std::size_t at = 0; (at = text.find_first_of("\x7F\xC2", at)) != std::string::npos;) {
    const utf8::CodePoint point = utf8::decode(std::string_view(text).substr(at));
    if (utf8::is_control(point.value)) {
      out.append(text, copied, at - copied);
      utf8::append_escape(out, point.value);
      copied = at + point.size;
    }
    at += point.size;
  }
  return out.empty() ? text : out.append(text, copied);
}

inline Json text(std::string_view view) { return std::string(view); }

/// Lines and columns of a span; 1:1 to 1:1 where there is no text.
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

/// "" for a place in no file.
inline std::string path_of(Span span, const SourceMap& sources) {
  const bool is_known = static_cast<std::size_t>(span.source) < sources.size();
  return is_known ? sources.path(span.source) : std::string();
}

}  // namespace smurf::render
