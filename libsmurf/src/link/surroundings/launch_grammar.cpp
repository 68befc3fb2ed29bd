// SPDX-License-Identifier: BSD-3-Clause
#include "link/surroundings/launch_grammar.hpp"

#include <cctype>

#include "base/text/quoted.hpp"

namespace smurf::launch {
namespace {

class Grammar {
 public:
  explicit Grammar(std::string_view text) : text_(text) {}

  Substitutions run() {
    fragments('\0');
    return std::move(found_);
  }

 private:
  static constexpr int kDeepest = 40;

  bool is_at(std::string_view what) const { return text_.substr(at_, what.size()) == what; }
  bool begins_substitution() const { return is_at("$(") && !is_escaped(); }
  bool is_escaped() const { return at_ > 0 && text_[at_ - 1] == '\\'; }

  bool fail(std::size_t begin, std::size_t end, std::string message, std::string help) {
    if (!found_.fault) {
      found_.fault = SubstitutionFault{begin, std::min(end, text_.size()), std::move(message),
                                       std::move(help)};
    }
    return false;
  }

  /// Texts and substitutions up to `quote`, which ends them; up to the end for '\0'.
  bool fragments(char quote) {
    while (at_ < text_.size()) {
      if (begins_substitution()) {
        if (!substitution(quote)) return false;
      } else if (quote != '\0' && text_[at_] == quote && !is_escaped()) {
        ++at_;
        return true;
      } else {
        ++at_;
      }
    }
    return quote == '\0';
  }

  /// `$(name value ...)`; in quotes, values have no quotes of that kind.
  bool substitution(char quote) {
    const std::size_t begin = at_;
    if (++depth_ > kDeepest) return fail(begin, begin + 2, "too many substitutions are nested", "");
    at_ += 2;
    WrittenSubstitution one;
    one.begin = at_;
    while (at_ < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[at_])) != 0 ||
                                  (at_ > one.begin && (text_[at_] == '_' || text_[at_] == '-')))) {
      ++at_;
    }
    one.end = at_;
    one.name = text_.substr(one.begin, at_ - one.begin);
    if (one.name.empty() || std::isdigit(static_cast<unsigned char>(one.name.front())) != 0) {
      return fail(begin, at_ + 1, "no name of a substitution stands behind `$(`",
                  is_at(" ") ? "delete the blank" : "write a name there, or `\\$(` for the text");
    }
    while (is_at(" ")) {
      ++at_;
      const std::size_t value_begin = at_;
      if (!value(quote)) return false;
      if (++one.values == 1) {
        one.first = text_.substr(value_begin, at_ - value_begin);
        one.first_begin = value_begin;
      }
    }
    if (!is_at(")")) {
      return at_ == text_.size()
                 ? fail(begin, begin + 2, "this substitution does not end", "write `)`")
                 : fail(at_, at_ + 1,
                        quoted(text_.substr(at_, 1)) + " cannot stand here in " +
                            quoted("$(" + std::string(one.name) + " ...)"),
                        "write quotes around a value with such a character");
    }
    ++at_;
    --depth_;
    found_.all.push_back(one);
    return true;
  }

  bool value(char outer) {
    const std::size_t begin = at_;
    if (outer == '\0' && (is_at("'") || is_at("\""))) {
      const char quote = text_[at_++];
      return fragments(quote) || fail(begin, begin + 1, "this quote in a substitution does not end",
                                      "write " + quoted(std::string(1, quote)) + " at its end");
    }
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (begins_substitution()) {
        if (!substitution(outer)) return false;
        continue;
      }
      const bool is_mark = c == '(' || c == ')' || c == '\'' || c == '"';
      const bool is_open_quote = (c == '\'' && outer == '"') || (c == '"' && outer == '\'');
      if (c == ' ' || (is_mark && !is_escaped() && !is_open_quote)) break;
      ++at_;
    }
    if (at_ > begin) return true;
    return fail(begin, begin + 1, "a blank too many stands in this substitution",
                "write one blank between values, and none before `)`");
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int depth_ = 0;
  Substitutions found_;
};

}  // namespace

Substitutions read_substitutions(std::string_view text) {
  return text.find("$(") == std::string_view::npos ? Substitutions() : Grammar(text).run();
}

}  // namespace smurf::launch
