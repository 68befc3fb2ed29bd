// SPDX-License-Identifier: BSD-3-Clause
#include "imports/traced_xml.hpp"

#include "base/numbers/numbers.hpp"
#include "imports/imports.hpp"

namespace smurf::imports {

using xacro::Leaf;

Leaf& TracedXml::leaf(Leaf::Kind kind, std::size_t begin, const Place& place, bool is_made) {
  Leaf& leaf = leaves_.emplace_back();
  leaf.kind = kind;
  leaf.begin = static_cast<std::uint32_t>(begin);
  leaf.end = static_cast<std::uint32_t>(text_.size());
  leaf.frame = place.frame;
  leaf.origin = place.origin;
  leaf.use = place.use;
  leaf.whole = place.use;
  const bool is_in_made = !open_.empty() && open_.back().is_made;
  if (is_made || is_in_made) leaf.first_input = kMade;
  return leaf;
}

void TracedXml::end_tag_head() {
  if (open_.empty()) return;
  if (open_.back().has_text) {
    open_.back().has_text = false;
    text_ += "\n";
  }
  if (!open_.back().is_empty) return;
  open_.back().is_empty = false;
  text_ += ">\n";
}

void TracedXml::open(std::string_view name, const Place& place, bool is_made) {
  is_full_ = is_full_ || text_.size() > most_;
  if (is_full_) return;
  end_tag_head();
  const bool is_in_made = !open_.empty() && open_.back().is_made;
  text_.append(2 * open_.size(), ' ');
  open_.push_back({std::string(name), place, is_made || is_in_made});
  const std::size_t begin = text_.size();
  text_ += "<";
  text_ += name;
  leaf(Leaf::Kind::tag, begin, place);
}

void TracedXml::attribute(std::string_view name, std::string_view value, const Place& place,
                          bool is_made) {
  if (is_full_) return;
  text_ += " ";
  const std::size_t name_begin = text_.size();
  text_ += name;
  leaf(Leaf::Kind::attribute, name_begin, place, is_made);
  text_ += "=\"";
  const std::size_t begin = text_.size();
  escaped(value);
  Leaf& made = leaf(Leaf::Kind::value, begin, place, is_made);
  made.is_exact = place.is_exact && text_.size() - begin == value.size() &&
                  place.origin.end - place.origin.begin == value.size();
  text_ += "\"";
}

void TracedXml::escaped(std::string_view value) {
  for (const char c : value) {
    switch (c) {
    case '&': text_ += "&amp;"; break;
    case '<': text_ += "&lt;"; break;
    case '>': text_ += "&gt;"; break;
    case '"': text_ += "&quot;"; break;
    case '\n': text_ += "&#10;"; break;
    case '\r': text_ += "&#13;"; break;
    case '\t': text_ += "&#9;"; break;
    default: text_.push_back(c);
    }
  }
}

void TracedXml::text(std::string_view value, const Place& place) {
  if (is_full_) return;
  Open& element = open_.back();
  element.is_empty = false;
  element.has_text = true;
  text_ += ">";
  const std::size_t begin = text_.size();
  escaped(value);
  Leaf& made = leaf(Leaf::Kind::text, begin, place);
  made.is_exact = place.is_exact && text_.size() - begin == value.size() &&
                  place.origin.end - place.origin.begin == value.size();
}

void TracedXml::number(std::string_view name, double value, const Place& place, bool is_made) {
  attribute(name, format_number(value), place, is_made);
}

void TracedXml::close() {
  if (is_full_) return;
  const Open last = open_.back();
  if (last.is_empty) {
    text_ += "/>\n";
    open_.pop_back();
    return;
  }
  if (!last.has_text) text_.append(2 * (open_.size() - 1), ' ');
  const std::size_t begin = text_.size();
  text_ += "</" + last.name + ">";
  leaf(Leaf::Kind::end_tag, begin, last.place);
  text_ += "\n";
  open_.pop_back();
}

}  // namespace smurf::imports
