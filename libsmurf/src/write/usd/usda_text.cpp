// SPDX-License-Identifier: BSD-3-Clause
#include "write/usd/usda_text.hpp"

#include "base/numbers/floating.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/misread.hpp"
#include "base/text/utf8.hpp"
#include "write/text/long_text.hpp"

namespace smurf {
namespace {

/// A byte as three octal digits, because USD reads any number of digits after an `x`.
void append_octal(std::string& out, char byte) {
  const auto value = static_cast<unsigned char>(byte);
  out += '\\';
  for (const unsigned shift : {6U, 3U, 0U}) out += static_cast<char>('0' + (value >> shift & 7U));
}

}  // namespace

void UsdaText::line(std::string_view text) {
  if (is_full()) return;
  make_room(out_);
  if (!text.empty()) out_.append(4 * depth_, ' ');
  out_ += text;
  out_ += '\n';
}

void UsdaText::open(std::string_view type, std::string_view name,
                    const std::vector<std::string>& schemas, std::string_view references) {
  const std::string prim = "def " + std::string(type) + " \"" + std::string(name) + "\"";
  if (schemas.empty() && references.empty()) {
    line(prim);
  } else {
    line(prim + " (");
    ++depth_;
    std::string names;
    for (const std::string& schema : schemas) {
      names += (names.empty() ? "\"" : ", \"") + schema + "\"";
    }
    if (!names.empty()) line("prepend apiSchemas = [" + names + "]");
    if (!references.empty()) line("references = <" + std::string(references) + ">");
    --depth_;
    line(")");
  }
  line("{");
  ++depth_;
}

void UsdaText::open_class(std::string_view name) {
  line("class \"" + std::string(name) + "\"");
  line("{");
  ++depth_;
}

void UsdaText::close() {
  --depth_;
  line("}");
}

void UsdaText::pose(const Pose& pose, const Vector3& scale) {
  line("double3 xformOp:translate = " + tuple(pose.position));
  line("quatd xformOp:orient = " + tuple(pose.orientation));
  const bool is_scaled = scale != Vector3{1, 1, 1};
  if (is_scaled) line("double3 xformOp:scale = " + tuple(scale));
  line("uniform token[] xformOpOrder = [\"xformOp:translate\", \"xformOp:orient\"" +
       std::string(is_scaled ? ", \"xformOp:scale\"]" : "]"));
}

std::string UsdaText::tuple(std::initializer_list<double> values) {
  std::string text = "(";
  for (const double value : values) text += (text.size() > 1 ? ", " : "") + format_number(value);
  return text + ")";
}

std::string UsdaText::tuple(const std::array<float, 3>& point) {
  std::string text = "(";
  for (const float coordinate : point) {
    text += (text.size() > 1 ? ", " : "") + shortest(coordinate);
  }
  return text + ")";
}

std::string UsdaText::tuple(const Vector3& vector) {
  return tuple({vector[0], vector[1], vector[2]});
}

std::string UsdaText::tuple(const Quaternion& q) { return tuple({q.w, q.x, q.y, q.z}); }

std::string UsdaText::quoted(std::string_view text) {
  const std::string clean = utf8::replace_controls(text);
  std::string out = "\"";
  for (std::size_t at = 0; at < clean.size();) {
    const utf8::CodePoint point = utf8::decode(std::string_view(clean).substr(at));
    const std::string_view character = std::string_view(clean).substr(at, point.size);
    switch (point.value) {
    case '\n': out += "\\n"; break;
    case '\t': out += "\\t"; break;
    case '"':
    case '\\': out += '\\'; [[fallthrough]];
    default:
      if (is_misread(clean, at, point.value)) {
        for (const char byte : character) append_octal(out, byte);
      } else {
        out += character;
      }
    }
    at += point.size;
  }
  return out + "\"";
}

}  // namespace smurf
