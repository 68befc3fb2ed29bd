// SPDX-License-Identifier: BSD-3-Clause
#include "write/xml_text.hpp"

#include <algorithm>

#include "base/edits.hpp"
#include "base/numbers.hpp"
#include "write/long_text.hpp"

namespace smurf {

void XmlText::indent() {
  make_room(out_);
  // Bodies of MuJoCo lie in each other: a long chain would be mostly blanks.
  constexpr std::size_t kDeepest = 50;
  out_.append(2 * std::min(open_.size(), kDeepest), ' ');
}

void XmlText::start(std::string_view name, std::span<const Attribute> attributes) {
  indent();
  out_ += '<';
  out_ += name;
  for (const auto& [key, value] : attributes) {
    out_ += ' ';
    out_ += key;
    out_ += "=\"" + escape_xml(value) + "\"";
  }
}

void XmlText::open(std::string_view name, Attributes attributes) {
  start(name, {attributes.begin(), attributes.size()});
  out_ += ">\n";
  open_.emplace_back(name);
}

void XmlText::close() {
  const std::string name = std::move(open_.back());
  open_.pop_back();
  indent();
  out_ += "</" + name + ">\n";
}

void XmlText::empty(std::string_view name, Attributes attributes) {
  start(name, {attributes.begin(), attributes.size()});
  out_ += "/>\n";
}

void XmlText::empty(std::string_view name, const std::vector<Attribute>& attributes) {
  start(name, attributes);
  out_ += "/>\n";
}

void XmlText::leaf(std::string_view name, std::string_view text, Attributes attributes) {
  start(name, {attributes.begin(), attributes.size()});
  out_ += ">" + escape_xml(text) + "</" + std::string(name) + ">\n";
}

void XmlText::leaf(std::string_view name, double value) { leaf(name, format_number(value)); }

std::string XmlText::finish() {
  while (!open_.empty()) close();
  return std::move(out_);
}

std::string join_numbers(std::initializer_list<double> values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : " ") + format_number(value);
  return text;
}

std::string join_numbers(const Vector3& vector) {
  return join_numbers({vector[0], vector[1], vector[2]});
}

}  // namespace smurf
