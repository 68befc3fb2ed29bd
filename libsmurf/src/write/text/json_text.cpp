// SPDX-License-Identifier: BSD-3-Clause
#include "write/text/json_text.hpp"

#include <algorithm>

#include "base/numbers/numbers.hpp"
#include "base/text/utf8.hpp"

namespace smurf {
namespace {

/// Marks that change the direction of writing would show a name as another one. YAML readers treat
/// U+2028 and U+2029 as line ends, and some remove U+FEFF.
bool is_escaped(char32_t c) { return utf8::is_control(c) || utf8::is_layout(c) || c == 0xFEFF; }

void append_character(std::string& out, const utf8::CodePoint& point, std::string_view text) {
  switch (point.value) {
  case '"': out += "\\\""; return;
  case '\\': out += "\\\\"; return;
  case '\n': out += "\\n"; return;
  case '\r': out += "\\r"; return;
  case '\t': out += "\\t"; return;
  case 0xFFFD: out += utf8::kReplacement; return;  // an invalid byte
  default: break;
  }
  if (is_escaped(point.value)) {
    utf8::append_escape(out, point.value);
  } else {
    out += text.substr(0, point.size);
  }
}

}  // namespace

void append_json(std::string& out, std::string_view text) {
  out += '"';
  while (!text.empty()) {
    const utf8::CodePoint point = utf8::decode(text);
    append_character(out, point, text);
    text.remove_prefix(point.size);
  }
  out += '"';
}

void append_json(std::string& out, const Vector3& vector) {
  out += '[';
  for (std::size_t i = 0; i < 3; ++i) {
    if (i > 0) out += ", ";
    out += format_number(vector[i]);
  }
  out += ']';
}

void append_json(std::string& out, const Quaternion& unit) {
  out += '{';
  bool is_first = true;
  for (const auto& [name, component] : {std::pair("w", unit.w), std::pair("x", unit.x),
                                        std::pair("y", unit.y), std::pair("z", unit.z)}) {
    append_key(out, name, is_first);
    out += format_number(std::clamp(component, -1.0, 1.0));
    is_first = false;
  }
  out += '}';
}

void append_json(std::string& out, const Value& value) {
  const auto write = [&](const auto& data) {
    using Data = std::decay_t<decltype(data)>;
    if constexpr (std::is_same_v<Data, std::monostate>) {
      out += "null";
    } else if constexpr (std::is_same_v<Data, bool>) {
      out += data ? "true" : "false";
    } else if constexpr (std::is_same_v<Data, std::int64_t>) {
      out += std::to_string(data);
    } else if constexpr (std::is_same_v<Data, double>) {
      out += format_number(data);
    } else if constexpr (std::is_same_v<Data, std::string>) {
      append_json(out, std::string_view(data));
    } else if constexpr (std::is_same_v<Data, Value::List>) {
      out += '[';
      for (std::size_t i = 0; i < data.size(); ++i) {
        if (i > 0) out += ", ";
        append_json(out, data[i]);
      }
      out += ']';
    } else {
      append_json(out, data);
    }
  };
  std::visit(write, value.data);
}

void append_json(std::string& out, const Value::Object& object) {
  out += '{';
  for (std::size_t i = 0; i < object.size(); ++i) {
    append_key(out, object[i].key, i == 0);
    append_json(out, object[i].value);
  }
  out += '}';
}

void append_key(std::string& out, std::string_view name, bool is_first) {
  if (!is_first) out += ", ";
  append_json(out, name);
  out += ": ";
}

}  // namespace smurf
