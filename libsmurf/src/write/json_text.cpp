// SPDX-License-Identifier: BSD-3-Clause
#include "write/json_text.hpp"

#include <algorithm>

#include "base/numbers.hpp"

namespace smurf {
namespace {

void append_character(std::string& out, char c) {
  switch (c) {
  case '"': out += "\\\""; return;
  case '\\': out += "\\\\"; return;
  case '\n': out += "\\n"; return;
  case '\r': out += "\\r"; return;
  case '\t': out += "\\t"; return;
  default: break;
  }
  const auto byte = static_cast<unsigned char>(c);
  if (byte >= 0x20 && byte != 0x7f) {
    out += c;
    return;
  }
  constexpr std::string_view kDigits = "0123456789abcdef";
  out += "\\u00";
  out += kDigits[byte >> 4U];
  out += kDigits[byte & 0xfU];
}

}  // namespace

void append_json(std::string& out, std::string_view text) {
  out += '"';
  for (const char c : text) append_character(out, c);
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
