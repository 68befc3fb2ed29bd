// SPDX-License-Identifier: BSD-3-Clause
#include "write/text/xml_text.hpp"

#include <algorithm>

#include "base/numbers/numbers.hpp"
#include "base/text/edits.hpp"
#include "write/text/long_text.hpp"

namespace smurf {

void XmlText::indent(std::size_t depth) {
  make_room(out_);
  // Bodies in MuJoCo are nested, so a long chain would consist mostly of spaces.
  constexpr std::size_t kDeepest = 50;
  out_.append(2 * std::min(depth, kDeepest), ' ');
}

void XmlText::start(std::string_view name, std::span<const Attribute> attributes,
                    std::size_t depth) {
  indent(depth);
  out_ += '<';
  out_ += name;
  for (const auto& [key, value] : attributes) {
    out_ += ' ';
    out_ += key;
    out_ += "=\"" + escape_xml(value) + "\"";
  }
}

void XmlText::open(std::string_view name, Attributes attributes) {
  open_.emplace_back(name);
  if (is_full()) return;
  start(name, {attributes.begin(), attributes.size()}, open_.size() - 1);
  out_ += ">\n";
}

void XmlText::close() {
  const std::string name = std::move(open_.back());
  open_.pop_back();
  if (is_full()) return;
  indent(open_.size());
  out_ += "</" + name + ">\n";
}

void XmlText::empty(std::string_view name, Attributes attributes) {
  if (is_full()) return;
  start(name, {attributes.begin(), attributes.size()}, open_.size());
  out_ += "/>\n";
}

void XmlText::empty(std::string_view name, const std::vector<Attribute>& attributes) {
  if (is_full()) return;
  start(name, attributes, open_.size());
  out_ += "/>\n";
}

void XmlText::leaf(std::string_view name, std::string_view text, Attributes attributes) {
  if (is_full()) return;
  start(name, {attributes.begin(), attributes.size()}, open_.size());
  out_ += ">" + escape_xml(text) + "</" + std::string(name) + ">\n";
}

void XmlText::leaf(std::string_view name, double value) { leaf(name, format_number(value)); }

void XmlText::comment(std::string text) {
  if (is_full()) return;
  for (std::size_t at = text.find("--"); at != text.npos; at = text.find("--", at)) {
    text.erase(at, 1);
  }
  indent(open_.size());
  out_ += "<!-- " + escape_xml(text) + " -->\n";
}

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
