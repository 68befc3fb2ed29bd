// SPDX-License-Identifier: BSD-3-Clause
#include "convert/xml_edits.hpp"

#include "base/numbers/numbers.hpp"
#include "base/text/edits.hpp"

namespace smurf {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t'; }

/// Line ends with indentation become line ends.
std::string outdented(std::string_view text, std::string_view indentation) {
  const std::string line_start = "\n" + std::string(indentation);
  std::string result;
  for (std::size_t at = text.find(line_start); at != std::string_view::npos;
       at = text.find(line_start)) {
    result.append(text.substr(0, at)).append("\n");
    text.remove_prefix(at + line_start.size());
  }
  result.append(text);
  std::erase(result, '\r');
  return result;
}

}  // namespace

std::string new_element(std::string_view name, const Attributes& attributes) {
  std::string text = "<" + std::string(name);
  for (const auto& [key, value] : attributes) {
    text += " " + std::string(key) + "=\"" + escape_xml(value) + "\"";
  }
  return text + "/>";
}

std::string numbers_text(const Vector3& vector) {
  return format_number(vector[0]) + " " + format_number(vector[1]) + " " + format_number(vector[2]);
}

Attributes origin_attributes(const Pose& pose) {
  return {{"xyz", numbers_text(pose.position)}, {"rpy", numbers_text(to_rpy(pose.orientation))}};
}

XmlEdits::XmlEdits(const xml::Document& document, std::string_view text)
    : document_(document), text_(text) {
  const std::size_t line = text_.find('\n');
  const bool is_dos = line != std::string_view::npos && line > 0 && text_[line - 1] == '\r';
  line_end_ = is_dos ? "\r\n" : "\n";
}

void XmlEdits::set_attribute(xml::View element, std::string_view name, std::string_view value) {
  if (const xml::Attribute* attribute = element.attribute(name)) {
    if (attribute->value() != value) replace(attribute->value_span(), escape_xml(value));
    return;
  }
  Span place = element.name_span();
  if (!element.attributes().empty()) place = element.attributes().back().span();
  place.begin = place.end;
  replace(place, " " + std::string(name) + "=\"" + escape_xml(value) + "\"");
}

void XmlEdits::set_number(xml::View element, std::string_view name, double value) {
  const xml::Attribute* attribute = element.attribute(name);
  if (attribute != nullptr && parse_number(attribute->value()) == value) return;
  set_attribute(element, name, format_number(value));
}

void XmlEdits::add_child(xml::View element, std::string_view child) {
  const auto [known, is_new] = children_.emplace(element.id(), child);
  if (!is_new) known->second.append("\n").append(child);
}

void XmlEdits::remove(Span span) {
  std::uint32_t begin = span.begin;
  while (begin > 0 && is_space(text_[begin - 1])) --begin;
  std::uint32_t end = span.end;
  while (end < text_.size() && is_space(text_[end])) ++end;
  const bool is_alone = (begin == 0 || text_[begin - 1] == '\n') &&
                        (end == text_.size() || text_[end] == '\n' || text_[end] == '\r');
  if (!is_alone) {
    replace(span, "");
    return;
  }
  if (end < text_.size() && text_[end] == '\r') ++end;
  if (end < text_.size() && text_[end] == '\n') ++end;
  replace({span.source, begin, end}, "");
}

void XmlEdits::remove(const xml::Attribute& attribute) {
  Span span = attribute.span();
  while (std::string_view(" \t\r\n").find(text_[span.begin - 1]) != std::string_view::npos) {
    --span.begin;
  }
  replace(span, "");
}

Edit XmlEdits::origin_edit(xml::View element, const urdf::Origin& origin, const Pose& pose) const {
  const std::string text = new_element("origin", origin_attributes(pose));
  if (origin.element != xml::kNoElement) return {view(origin.element).span(), text};
  Edit edit{element.tag_span(), text};
  edit.span.begin = edit.span.end;
  if (element.begin() == element.end()) return edit;
  // On a separate line, if the other children are.
  const std::uint32_t first_child = (*element.begin()).span().begin;
  const std::string_view blanks = text_.substr(edit.span.end, first_child - edit.span.end);
  if (blanks.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    edit.text = std::string(blanks) + text;
  }
  return edit;
}

std::string XmlEdits::copy(xml::View element, std::vector<Edit> changes) const {
  const Span span = element.span();
  for (Edit& change : changes) {
    change.span.begin -= span.begin;
    change.span.end -= span.begin;
  }
  return outdented(apply_edits(text_.substr(span.begin, span.end - span.begin), changes),
                   indentation(span));
}

std::string_view XmlEdits::indentation(Span span) const {
  constexpr std::size_t kLongestLine = 1000;  // one line may contain the whole file
  std::size_t begin = span.begin;
  while (begin > 0 && text_[begin - 1] != '\n') {
    if (span.begin - --begin > kLongestLine) return {};
  }
  // Limits the indentation, which is repeated for each line of a moved text.
  constexpr std::size_t kDeepest = 40;
  std::size_t end = begin;
  while (end < span.begin && end - begin < kDeepest && is_space(text_[end])) ++end;
  return text_.substr(begin, end - begin);
}

std::string XmlEdits::indented(std::string_view text, std::string_view indentation) const {
  std::string result;
  for (std::size_t end = text.find('\n'); end != std::string_view::npos; end = text.find('\n')) {
    result.append(text.substr(0, end)).append(line_end_);
    text.remove_prefix(end + 1);
    if (!text.starts_with('\n')) result.append(indentation);
  }
  return result.append(text);
}

void XmlEdits::replace_element(xml::View element, std::string_view text) {
  replace(element.span(), indented(text, indentation(element.span())));
}

void XmlEdits::close(xml::View element, std::string_view children, std::vector<Edit>& edits) const {
  const std::string outer(indentation(element.span()));
  std::string inner = outer + "  ";
  for (const xml::View child : element) inner = indentation(child.span());
  std::string text = std::string(line_end_) + inner + indented(children, inner);
  const Span tag = element.tag_span();
  if (tag.end == element.span().end) {  // <a/>
    Span slash{tag.source, tag.end - 2, tag.end};
    while (is_space(text_[slash.begin - 1])) --slash.begin;
    edits.push_back({slash, ">" + text + std::string(line_end_) + outer + "</" +
                                std::string(element.name()) + ">"});
    return;
  }
  Span place = tag;
  for (const xml::View child : element) place = child.span();
  place.begin = place.end;
  const bool ends_on_this_line = text_.substr(place.end).starts_with("</");
  if (ends_on_this_line) text += std::string(line_end_) + outer;
  edits.push_back({place, text});
}

std::string XmlEdits::apply() const {
  std::vector<Edit> edits = edits_;
  for (const auto& [element, children] : children_) close(view(element), children, edits);
  return apply_edits(text_, edits);
}

}  // namespace smurf
