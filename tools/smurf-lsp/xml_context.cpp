// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lsp/xml_context.hpp"

#include <algorithm>

namespace smurf::lsp {
namespace {

constexpr std::string_view kXmlBlank = " \t\r\n";
constexpr std::string_view kNameEnd = " \t\r\n/>=\"'<";

class Scanner {
 public:
  Scanner(std::string_view text, std::size_t offset) : text_(text.substr(0, offset)) {}

  XmlContext run() {
    while (true) {
      const std::size_t tag = text_.find('<', at_);
      if (tag == text_.npos) return end(XmlContext::Kind::content, text_.size());
      context_.tag = tag;
      at_ = tag;
      if (skip("<!--", "-->") || skip("<![CDATA[", "]]>") || skip("<?", "?>") || skip("<!", ">")) {
        if (at_ == text_.npos) return end(XmlContext::Kind::other, text_.size());
        continue;
      }
      if (!read_tag()) return context_;
    }
  }

 private:
  XmlContext end(XmlContext::Kind kind, std::size_t begin) {
    context_.kind = kind;
    context_.begin = begin;
    return context_;
  }

  /// Skips a construct with this beginning; `at_` is then after it, or npos if it does not end.
  bool skip(std::string_view from, std::string_view to) {
    if (!text_.substr(at_).starts_with(from)) return false;
    const std::size_t found = text_.find(to, at_ + from.size());
    at_ = found == text_.npos ? found : found + to.size();
    return true;
  }

  std::string_view name() {
    const std::size_t begin = at_;
    at_ = std::min(text_.find_first_of(kNameEnd, at_), text_.size());
    return text_.substr(begin, at_ - begin);
  }

  /// False when the cursor is in the tag; then the context is complete.
  bool read_tag() {
    ++at_;
    const bool is_end = text_.substr(at_).starts_with('/');
    if (is_end) ++at_;
    const std::size_t begin = at_;
    context_.element = name();
    if (at_ == text_.size()) {
      end(is_end ? XmlContext::Kind::end_tag : XmlContext::Kind::element, begin);
      return false;
    }
    context_.attributes.clear();
    while (true) {
      at_ = std::min(text_.find_first_not_of(kXmlBlank, at_), text_.size());
      if (at_ == text_.size()) return in_attribute(at_);
      if (text_[at_] == '>') break;
      if (text_[at_] == '<') return close(is_end, true);  // the tag was never closed
      if (!read_attribute()) return false;
    }
    const bool is_closed = text_[at_ - 1] == '/';
    ++at_;
    return close(is_end, is_closed);
  }

  bool close(bool is_end, bool is_closed) {
    if (is_end) {
      const auto found = std::find(context_.open.rbegin(), context_.open.rend(), context_.element);
      if (found != context_.open.rend()) {
        context_.open.erase(found.base() - 1, context_.open.end());
      }
    } else if (!is_closed) {
      context_.open.push_back(context_.element);
    }
    return true;
  }

  bool in_attribute(std::size_t begin) {
    end(XmlContext::Kind::attribute, begin);
    return false;
  }

  bool read_attribute() {
    const std::size_t begin = at_;
    const std::string_view attribute = name();
    if (at_ == text_.size()) return in_attribute(begin);
    if (at_ == begin) {  // not a name: skip it
      ++at_;
      return true;
    }
    context_.attributes.push_back(attribute);
    at_ = std::min(text_.find_first_not_of(kXmlBlank, at_), text_.size());
    if (at_ == text_.size() || text_[at_] != '=') return true;
    at_ = std::min(text_.find_first_not_of(kXmlBlank, at_ + 1), text_.size());
    if (at_ == text_.size() || (text_[at_] != '"' && text_[at_] != '\'')) return true;
    const std::size_t value = at_ + 1;
    const std::size_t close = text_.find(text_[at_], value);
    if (close == text_.npos) {
      context_.attribute = attribute;
      end(XmlContext::Kind::value, value);
      return false;
    }
    at_ = close + 1;
    return true;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  XmlContext context_;
};

}  // namespace

XmlContext xml_context(std::string_view text, std::size_t offset) {
  return Scanner(text, std::min(offset, text.size())).run();
}

std::string without_tag(std::string_view text, std::size_t tag, std::size_t offset,
                        std::span<const std::string_view> unclosed) {
  const std::size_t stop = std::min(text.find_first_of("<>\n", offset), text.size());
  const std::size_t end = stop < text.size() && text[stop] == '>' ? stop + 1 : stop;
  std::string result(text.substr(0, tag));
  for (auto name = unclosed.rbegin(); name != unclosed.rend(); ++name) {
    result.append("</").append(*name).append(">");
  }
  return result.append(text.substr(end));
}

}  // namespace smurf::lsp
