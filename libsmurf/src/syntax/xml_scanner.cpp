// SPDX-License-Identifier: BSD-3-Clause
// Builds the tree in one pass, without recursion. Errors that break the structure end the scan. It
// goes on after errors that lenient readers accept (bare '&', an undeclared prefix).
#include "syntax/xml_scanner.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "base/findings/cases.hpp"
#include "base/findings/limits.hpp"
#include "base/findings/rules.hpp"
#include "base/text/quoted.hpp"
#include "base/text/words.hpp"
#include "syntax/text_check.hpp"
#include "syntax/xml_builder.hpp"
#include "syntax/xml_bytes.hpp"
#include "syntax/xml_lenient.hpp"
#include "syntax/xml_prefixes.hpp"
#include "syntax/xml_prolog.hpp"
#include "syntax/xml_references.hpp"

namespace smurf {
namespace {

using xml::Attribute;
using xml::Element;

class XmlScanner {
 public:
  XmlScanner(std::string_view text, SourceId id, const Limits& limits, DiagnosticSink& sink)
      : text_(text),
        id_(id),
        limits_(limits),
        sink_(sink),
        tree_(text, id),
        prefixes_(text, sink) {}

  std::optional<xml::Document> run() {
    at_ = byte_order_mark_size(text_);
    check_xml_prolog(text_, id_, sink_);
    while (well_formed_ && at_ < size()) {
      if (text_[at_] == '<') {
        markup();
      } else {
        character_data();
      }
    }
    if (well_formed_) finish();
    if (!well_formed_) return std::nullopt;
    return tree_.take();
  }

 private:
  std::uint32_t size() const { return static_cast<std::uint32_t>(text_.size()); }
  Span span(std::uint32_t begin, std::uint32_t end) const { return {id_, begin, end}; }
  std::string_view slice(Span s) const { return text_.substr(s.begin, s.end - s.begin); }
  std::string quoted(Span s) const { return smurf::quoted(slice(s)); }
  bool looking_at(std::string_view word) const { return text_.substr(at_).starts_with(word); }
  void skip_space() {
    std::uint32_t at = at_;
    while (at < size() && is(text_[at], blank)) ++at;
    at_ = at;
  }

  Diagnostic& malformed(Span place, std::string message,
                        const Circumstance& fault = cases::kFault) {
    well_formed_ = false;
    return report_malformed(place, std::move(message), fault, sink_);
  }
  bool is_behind() const { return tree_.depth() == 0 && !tree_.elements().empty(); }

  void too_much(const Rule& rule, Span place, std::string message, std::string_view limit) {
    well_formed_ = false;
    sink_.report(rule, place, std::move(message)).help(raise_limit(limit));
  }

  /// Counts one more element or attribute.
  bool has_room(Span name) {
    if (tree_.elements().size() + tree_.attributes().size() < limits_.xml_elements) return true;
    too_much(rules::sml0002_file_too_large, name,
             "the file contains more than " + std::to_string(limits_.xml_elements) +
                 " elements and attributes",
             "xml-elements");
    return false;
  }

  void markup() {
    const char next = at_ + 1 < size() ? text_[at_ + 1] : '\0';
    if (next == '/') return end_tag();
    if (next == '?') return instruction();
    if (next != '!') return start_tag();
    if (looking_at("<!--")) return comment();
    if (looking_at("<![CDATA[")) return character_section();
    looking_at("<!DOCTYPE") ? doctype() : declaration();
  }

  void skip_section(std::string_view end, std::string_view message, const Circumstance& fault) {
    const std::size_t found = text_.find(end, at_ + 2);
    if (found == std::string_view::npos) {
      malformed(span(at_, at_ + 2), std::string(message), fault);
      return;
    }
    at_ = static_cast<std::uint32_t>(found + end.size());
  }

  void character_section() {
    const std::uint32_t begin = at_;
    skip_section("]]>", "this CDATA section is never closed", cases::kFault);
    if (!well_formed_) return;
    if (tree_.depth() == 0) {
      outside_of_root(span(begin, at_));
    } else {
      tree_.add_character_section(span(begin + 9, at_ - 3));
    }
  }

  void comment() {
    const std::uint32_t begin = at_;
    is_prolog_ = false;
    const std::size_t found = text_.find("-->", begin + 4);
    if (found == std::string_view::npos) {
      malformed(span(begin, begin + 4), "this comment is never closed",
                is_behind() ? cases::kCommentBehind : cases::kFault);
      return;
    }
    at_ = static_cast<std::uint32_t>(found + 3);
    tree_.add_comment(span(begin, at_));
    const std::string_view body = text_.substr(begin + 4, found - begin - 4);
    std::size_t dashes = body.find("--");
    if (dashes == std::string_view::npos && body.ends_with('-')) dashes = body.size() - 1;
    if (dashes == std::string_view::npos) return;
    const auto place = static_cast<std::uint32_t>(begin + 4 + dashes);
    sink_
        .report(rules::sml1004_xml_comment_dashes, span(place, place + 2),
                "a comment contains `--`, which XML forbids")
        .help("write `- -` or another dash");
  }

  void doctype() {
    const Span place = span(at_, at_ + 9);
    if (!tree_.elements().empty()) {
      malformed(place, "a document type must come before the root element");
      return;
    }
    is_prolog_ = false;
    const std::optional<std::uint32_t> end = read_doctype(text_, place, sink_);
    well_formed_ = end.has_value();
    at_ = end.value_or(at_);
  }

  /// `<!ELEMENT ...>`, or a comment that begins with one dash: readers skip it.
  void declaration() {
    const std::uint32_t begin = at_;
    const std::size_t close = text_.find('>', begin);
    if (close == std::string_view::npos) return start_tag();
    is_prolog_ = false;
    at_ = static_cast<std::uint32_t>(close + 1);
    if (tree_.depth() > 0) tree_.add_declaration();
    report_malformed(span(begin, begin + 2), "`<!` does not begin a comment here",
                     cases::kDeclaration, sink_);
  }

  void instruction() {
    const std::uint32_t begin = at_;
    const bool is_declaration = looking_at("<?xml ");
    skip_section("?>", "this processing instruction is never closed", cases::kInstruction);
    if (well_formed_ && is_prolog_ && is_declaration && has_declaration_) {
      report_second_declaration(span(begin, at_), sink_);
    }
    has_declaration_ = has_declaration_ || is_declaration;
    if (!well_formed_) return;
    const auto close = static_cast<std::uint32_t>(text_.find('>', begin));
    if (close + 1 < at_) {
      malformed(
          span(close, close + 1),
          "urdfdom (TinyXML) reads this `>` as the end of the processing instruction, and finds no "
          "robot after it")
          .help("delete the instruction, or this character");
      return;
    }
    if (const auto place = find_unsound(text_.substr(begin, at_ - begin))) {
      const auto wrong = static_cast<std::uint32_t>(begin + *place);
      const Span at = span(wrong, wrong + 1);
      if (is_prolog_ && report_unquoted(text_.substr(begin, at_ - begin), at, sink_)) return;
      malformed(at, "this is not an attribute of the XML declaration", cases::kInstructionAttribute)
          .help("write `<?xml version=\"1.0\" encoding=\"UTF-8\"?>`");
      return;
    }
    if (is_prolog_) return check_xml_version(span(begin, at_), text_, sink_);
    report_late_instruction(span(begin, at_), text_.substr(begin), sink_);
  }

  void end_tag() {
    const std::uint32_t begin = at_;
    at_ += 2;
    const Span name = scan_name();
    skip_space();
    if (at_ >= size() || text_[at_] != '>') {
      const bool has_attribute = at_ < size() && !name.empty() && is(text_[at_], name_start);
      malformed(span(begin, std::max(at_, begin + 2)), "this end tag is not closed by `>`",
                has_attribute ? cases::kEndTagAttribute : cases::kFault);
      return;
    }
    ++at_;
    if (tree_.depth() == 0) return end_tag_outside(span(begin, at_), name);
    const Element& element = tree_.innermost();
    if (slice(name) != element.name()) {
      Diagnostic& diagnostic =
          malformed(name, "the end tag " + quoted(name) + " does not close the open element " +
                              quoted(element.name_span()));
      suspect_end(slice(name), diagnostic);
      return;
    }
    close_element();
  }

  /// After the root, all URDF readers stop at an end tag with a name; tinyxml2 refuses `</>`.
  void end_tag_outside(Span tag, Span name) {
    const bool is_end = !tree_.elements().empty() && !name.empty();
    malformed(tag, "the end tag " + quoted(name) + " closes nothing",
              is_end ? cases::kEndTagBehind : cases::kFault);
    well_formed_ = is_end;
    if (is_end) at_ = size();
  }

  /// `written` is the end tag that stands there; "": the file ends.
  void suspect_end(std::string_view written, Diagnostic& diagnostic) const {
    explain_open(tree_.innermost().name_span(), tree_.innermost().name(), written, diagnostic);
    if (const Element* inner = tree_.suspect()) {
      diagnostic.label(inner->name_span(), "is the end tag missing before this?");
    }
  }

  void close_element() {
    tree_.close(at_);
    prefixes_.leave();
  }

  Span scan_name() {
    std::uint32_t at = at_;
    std::uint8_t classes = 0;
    if (at < size() && is(text_[at], name_start)) {
      for (; at < size() && is(text_[at], name_char); ++at) {
        classes |= kClasses[static_cast<unsigned char>(text_[at])];
      }
    }
    has_prefix_ = has_prefix_ || (classes & colon) != 0;
    return span(std::exchange(at_, at), at);
  }

  void start_tag() {
    const std::uint32_t begin = at_++;
    is_prolog_ = false;
    has_prefix_ = false;
    Element element;
    element.span = span(begin, begin);
    const Span name = scan_name();
    element.name_begin = text_.data() + name.begin;
    element.name_size = name.end - name.begin;
    if (name.empty()) {
      const bool is_blank = at_ < size() && is(text_[at_], blank);
      well_formed_ = false;
      report_no_element(span(begin, begin + 1), text_.substr(begin),
                        is_blank ? cases::kBlankTag : cases::kNoTag, sink_);
      return;
    }
    if (is_behind() && !tree_.end_root()) {
      well_formed_ = report_second_root(element.name_span(), element.name(),
                                        tree_.elements().front().name_span(), sink_);
      if (!well_formed_) return;
    }
    if (tree_.depth() >= limits_.xml_depth) {
      too_much(rules::sml0014_nesting_too_deep, element.name_span(),
               "elements are nested deeper than " + std::to_string(limits_.xml_depth) + " levels",
               "xml-depth");
      return;
    }
    if (!has_room(element.name_span())) return;
    element.first_attribute = static_cast<std::uint32_t>(tree_.attributes().size());
    prefixes_.enter();
    bool is_closed = false;
    if (!attributes(element, is_closed)) return;
    element.tag_end = at_;
    element.span = element.tag_span();
    tree_.open(element);
    if (has_prefix_) check_prefixes(element);
    if (is_closed) close_element();
  }

  bool attributes(const Element& element, bool& is_closed) {
    while (true) {
      const std::uint32_t before = at_;
      skip_space();
      if (at_ >= size()) {
        malformed(element.name_span(),
                  "the start tag of " + quoted(element.name_span()) + " is never closed by `>`");
        return false;
      }
      if (text_[at_] == '>') {
        ++at_;
        return true;
      }
      if (looking_at("/>")) {
        at_ += 2;
        is_closed = true;
        return true;
      }
      const std::uint32_t begin = at_;
      if (!attribute(element)) return false;
      if (begin != before) continue;
      const Span name = tree_.attributes().back().name_span();
      report_missing_blank(name, slice(name), sink_);
    }
  }

  bool attribute(const Element& element) {
    const Span name = scan_name();
    if (name.empty()) {
      malformed(span(at_, at_ + 1),
                "this character is not allowed in the start tag of " + quoted(element.name_span()),
                looking_at("\f") || looking_at("\v") ? cases::kControl : cases::kFault);
      return false;
    }
    skip_space();
    if (at_ >= size() || text_[at_] != '=') {
      malformed(name, "the attribute " + quoted(name) + " has no value");
      return false;
    }
    ++at_;
    skip_space();
    is_coded_ = false;
    if (at_ >= size() || (text_[at_] != '"' && text_[at_] != '\'')) {
      return attribute_without_quotes(element, name);
    }
    const char quote = text_[at_++];
    const std::uint32_t begin = at_;
    skip_to(quote, '<');
    if (at_ < size() && text_[at_] == '<') skip_less_than(begin, quote);
    if (at_ >= size() || text_[at_] == '<') {
      malformed(span(begin - 1, begin),
                "the value of the attribute " + quoted(name) + " is never closed");
      return false;
    }
    const Span value = span(begin, at_);
    ++at_;
    return add_attribute(element, Attribute(text_, name, value));
  }

  bool attribute_without_quotes(const Element& element, Span name) {
    const std::uint32_t begin = at_;
    const auto end = end_of_bare_value(text_, begin);
    if (!end) {
      const bool is_typographic =
          begin < size() && static_cast<unsigned char>(text_[begin]) >= 0x80;
      malformed(name, "the value of the attribute " + quoted(name) + " has no quotes",
                is_typographic ? cases::kTypographicQuotes : cases::kFault);
      return false;
    }
    at_ = static_cast<std::uint32_t>(*end);
    report_missing_quotes(span(begin, at_), slice(name), sink_);
    return add_attribute(element, Attribute(text_, name, span(begin, at_)));
  }

  void skip_less_than(std::uint32_t begin, char quote) {
    const auto end = end_of_value_with_less_than(text_, begin, quote);
    while (end && at_ < *end) {
      if (text_[at_] == '<') report_less_than(span(at_, at_ + 1), sink_);
      if (text_[at_] != '<' && is(text_[at_], special)) {
        special_byte();
      } else {
        ++at_;
      }
    }
  }

  bool add_attribute(const Element& element, const Attribute& attribute) {
    const std::size_t count = tree_.attributes().size() - element.first_attribute;
    if (!has_room(attribute.name_span())) return false;
    if (count >= limits_.xml_attributes) {
      too_much(rules::sml0002_file_too_large, element.name_span(),
               "the element " + quoted(element.name_span()) + " has more than " +
                   std::to_string(limits_.xml_attributes) + " attributes",
               "xml-attributes");
      return false;
    }
    for (std::size_t i = element.first_attribute; i < tree_.attributes().size(); ++i) {
      if (!is_same(tree_.attributes()[i].name(), attribute.name())) continue;
      well_formed_ = false;
      Diagnostic& diagnostic =
          sink_.report(rules::sml1007_xml_duplicate_attribute, attribute.name_span(),
                       "the attribute " + quoted(attribute.name_span()) + " is written twice");
      diagnostic.label(tree_.attributes()[i].name_span(), "first written here");
      return false;
    }
    if (attribute.name().starts_with("xmlns:")) prefixes_.declare(attribute.name().substr(6));
    if (is_coded_) {
      tree_.add_coded_attribute(attribute);
    } else {
      tree_.add_attribute(attribute);
    }
    return true;
  }

  void check_prefixes(const Element& element) {
    prefixes_.check(element.name_span());
    for (std::size_t i = element.first_attribute; i < tree_.attributes().size(); ++i) {
      prefixes_.check(tree_.attributes()[i].name_span());
    }
    if (element.name() != "xi:include") return;
    sink_.report(rules::sml1013_dtd_or_xinclude, element.name_span(),
                 "URDF readers do not follow `xi:include`");
  }

  /// Skips to the end of a value or text: one of both bytes, or the end of the file.
  void skip_to(char a, char b) {
    while (true) {
      std::uint32_t at = at_;
      while (at < size() && !is(text_[at], special)) ++at;
      at_ = at;
      if (at_ >= size() || text_[at_] == a || text_[at_] == b) return;
      special_byte();
    }
  }

  void special_byte() {
    if (text_[at_] == '&') {
      is_coded_ = true;
      reference();
    } else {
      is_coded_ = is_coded_ || text_[at_] == '\r';
      ++at_;
    }
  }

  void reference() {
    const std::uint32_t begin = at_;
    const XmlReference reference = read_reference(text_.substr(begin));
    at_ += static_cast<std::uint32_t>(reference.size);
    if (reference.kind == XmlReference::Kind::none) {
      report_bare_ampersand(span(begin, begin + 1), text_.substr(begin), sink_);
    } else if (reference.kind == XmlReference::Kind::unknown_entity) {
      report_unknown_entity(span(begin, at_), slice(span(begin, at_)), sink_);
    }
  }

  void outside_of_root(Span text) {
    const bool is_before = tree_.elements().empty();
    malformed(text, is_before ? "text before the root element" : "text after the root element",
              is_before && has_declaration_ ? cases::kTextBehindDeclaration : cases::kFault);
  }

  void character_data() {
    const std::uint32_t begin = at_;
    skip_space();
    const std::uint32_t visible = at_;
    skip_to('<', '<');
    if (visible == at_) return;
    if (tree_.depth() == 0) {
      outside_of_root(span(visible, at_));
    } else {
      tree_.add_text(span(begin, at_));
    }
  }

  void finish() {
    if (tree_.depth() > 0) {
      const Element& element = tree_.innermost();
      Diagnostic& diagnostic = malformed(span(size(), size()), "the file ends inside the element " +
                                                                   quoted(element.name_span()));
      suspect_end("", diagnostic);
    } else if (tree_.elements().empty()) {
      malformed(span(0, 0), "the file contains no XML element");
    }
  }

  std::string_view text_;
  SourceId id_;
  const Limits& limits_;
  DiagnosticSink& sink_;
  XmlBuilder tree_;
  bool well_formed_ = true;
  bool is_coded_ = false;    ///< the value contains '&' or a carriage return
  bool has_prefix_ = false;  ///< a name in the start tag has a prefix
  std::uint32_t at_ = 0;
  bool is_prolog_ = true;  ///< only processing instructions so far
  bool has_declaration_ = false;
  XmlPrefixes prefixes_;
};

}  // namespace

std::optional<xml::Document> scan_xml(const SourceMap& sources, SourceId id, const Limits& limits,
                                      DiagnosticSink& sink) {
  return XmlScanner(without_padding(sources.text(id)), id, limits, sink).run();
}

}  // namespace smurf
