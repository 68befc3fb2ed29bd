// SPDX-License-Identifier: BSD-3-Clause
// A text kept in blocks changes as a string does.
#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <string>

#include "smurf-lsp/edited_text.hpp"

namespace smurf::lsp {
namespace {

class Simple {
 public:
  Simple(std::string text, Encoding encoding) : text_(std::move(text)), encoding_(encoding) {}

  void apply(const Json& change) {
    const Json& range = at(change, {"range"});
    if (!range.is_object()) {
      text_ = text_at(change, {"text"});
      return;
    }
    const std::size_t begin = offset_in(text_, at(range, {"start"}), encoding_);
    const std::size_t end = offset_in(text_, at(range, {"end"}), encoding_);
    text_.replace(begin, std::max(begin, end) - begin, text_at(change, {"text"}));
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  Encoding encoding_;
};

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}

  std::size_t below(std::size_t most) { return engine_() % most; }
  std::string text(std::size_t most) {
    static const std::string kParts[] = {
        "a",    "\n",   "\r\n", "\r", "\xC3\xA9", "\xE2\x82\xAC", "\xF0\x9F\x98\x80",
        "line", "\n\n", " "};
    std::string text;
    const bool has_lines = below(3) > 0;
    for (std::size_t i = below(most); i > 0; --i) {
      const std::string& part = kParts[below(std::size(kParts))];
      if (has_lines || part.find('\n') == part.npos) text += part;
    }
    return text;
  }
  Json position(std::size_t size) {
    return {{"line", below(4) == 0 ? below(size + 2) : below(6)}, {"character", below(size + 9)}};
  }
  Json change(std::size_t size) {
    if (below(40) == 0) return {{"text", text(9000)}};
    const Json start = position(size);
    const Json end = below(3) == 0 ? position(size) : start;
    const std::size_t most = below(9) == 0 ? 20000 : 12;
    return {{"range", {{"start", start}, {"end", end}}}, {"text", text(most)}};
  }

 private:
  std::mt19937 engine_;
};

TEST_CASE("blocks change as a string does") {
  for (unsigned seed = 0; seed < 60; ++seed) {
    Random random(seed);
    for (const Encoding encoding : {Encoding::utf8, Encoding::utf16, Encoding::utf32}) {
      const std::string text = random.text(9000);
      EditedText edited(text, encoding);
      Simple simple(text, encoding);
      for (int i = 0; i < 30; ++i) {
        const Json change = random.change(std::min<std::size_t>(simple.text().size(), 30000));
        edited.apply(change);
        simple.apply(change);
        REQUIRE_MESSAGE(edited.text() == simple.text(), dump(change));
      }
    }
  }
}

}  // namespace
}  // namespace smurf::lsp
