// SPDX-License-Identifier: BSD-3-Clause
// Parses the text of a pattern into a tree, and compiles the tree to code.
#include <algorithm>
#include <memory>
#include <optional>

#include "base/text/quoted.hpp"
#include "base/text/utf8.hpp"
#include "schema/pattern.hpp"

namespace smurf {
namespace {

/// Limit for counted repeats, because each of them repeats code.
constexpr std::size_t kMostCode = 10'000;
constexpr std::uint32_t kMostRepeats = 1'000'000;
constexpr std::uint32_t kEndless = kMostRepeats + 1;
constexpr char32_t kNothing = U'\0';  // stands for the end; YAML has no such character

struct Fault {
  std::string reason;
};

struct Node {
  enum class Kind : std::uint8_t { code, sequence, choice, repeat, look };
  Kind kind = Kind::sequence;
  Pattern::Instruction code{};
  std::vector<Node> parts{};
  std::uint32_t least = 1, most = 1;  ///< of a repeat
  bool is_ahead = true, is_negated = false;
};

bool is_digit(char32_t c) { return c >= '0' && c <= '9'; }

int digit_of(char32_t c) {
  if (is_digit(c)) return static_cast<int>(c - '0');
  if (c >= 'a' && c <= 'f') return static_cast<int>(c - 'a' + 10);
  return c >= 'A' && c <= 'F' ? static_cast<int>(c - 'A' + 10) : -1;
}

void add_range(char32_t first, char32_t last, Pattern::Set& set) {
  for (char32_t c = first; c <= last && c < set.ascii.size(); ++c) set.ascii.set(c);
  if (last >= set.ascii.size()) {
    set.ranges.emplace_back(std::max<char32_t>(first, static_cast<char32_t>(set.ascii.size())),
                            last);
  }
}

/// `\d`, `\s` and `\w`; false for any other letter.
bool add_class(char32_t letter, Pattern::Set& set) {
  constexpr std::pair<char32_t, char32_t> kBlanks[] = {
      {0x09, 0x0D},     {' ', ' '},       {0xA0, 0xA0},     {0x1680, 0x1680}, {0x2000, 0x200A},
      {0x2028, 0x2029}, {0x202F, 0x202F}, {0x205F, 0x205F}, {0x3000, 0x3000}, {0xFEFF, 0xFEFF}};
  switch (letter) {
  case 'w':
    add_range('A', 'Z', set);
    add_range('a', 'z', set);
    add_range('_', '_', set);
    [[fallthrough]];
  case 'd': add_range('0', '9', set); return true;
  case 's':
    for (const auto& [first, last] : kBlanks) add_range(first, last, set);
    return true;
  default: return false;
  }
}

/// All characters outside of the set, as ranges, so that it can be part of another set.
void add_rest(const Pattern::Set& set, Pattern::Set& to) {
  std::vector<std::pair<char32_t, char32_t>> taken = set.ranges;
  for (char32_t c = 0; c < set.ascii.size(); ++c) {
    if (set.ascii[c]) taken.emplace_back(c, c);
  }
  std::sort(taken.begin(), taken.end());
  char32_t next = 0;
  for (const auto& [first, last] : taken) {
    if (first > next) add_range(next, first - 1, to);
    next = last + 1;
  }
  add_range(next, 0x10FFFF, to);
}

/// The grammar of ECMA-262, as lenient about `{`, `}` and `]` as browsers are.
class Parser {
 public:
  Parser(std::string_view text, std::vector<Pattern::Set>& sets) : sets_(sets) {
    while (!text.empty()) {
      const utf8::CodePoint next = utf8::decode(text);
      text_.push_back(next.value);
      text.remove_prefix(next.size);
    }
  }

  Node run() {
    Node all = choice();
    if (at_ < text_.size()) throw Fault{"there is no group that this `)` closes"};
    return all;
  }

 private:
  char32_t peek(std::size_t ahead = 0) const {
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : kNothing;
  }

  bool take(std::u32string_view wanted) {
    if (std::u32string_view(text_).substr(at_, wanted.size()) != wanted) return false;
    at_ += wanted.size();
    return true;
  }

  Node choice() {
    Node all{.kind = Node::Kind::choice};
    do {
      all.parts.push_back(sequence());
    } while (take(U"|"));
    return all;
  }

  Node sequence() {
    Node all;
    while (at_ < text_.size() && peek() != '|' && peek() != ')') all.parts.push_back(term());
    return all;
  }

  Node term() {
    if (take(U"^")) return code(Pattern::Op::begin);
    if (take(U"$")) return code(Pattern::Op::end);
    if (take(U"\\b")) return code(Pattern::Op::word_edge);
    if (take(U"\\B")) return code(Pattern::Op::word_edge, true);
    return repeated(atom());
  }

  static Node code(Pattern::Op op, bool is_negated = false) {
    return {.kind = Node::Kind::code, .code = {.op = op, .is_negated = is_negated}};
  }

  Node atom() {
    if (take(U"(")) return group();
    Pattern::Set set;
    if (take(U"[")) {
      read_set(set);
    } else if (take(U".")) {
      for (const char32_t c : {U'\n', U'\r', U'\u2028', U'\u2029'}) add_range(c, c, set);
      set.is_negated = true;
    } else if (take(U"\\")) {
      if (const auto one = escaped(set)) add_range(*one, *one, set);
    } else if (peek() == '*' || peek() == '+' || peek() == '?' || counts()) {
      throw Fault{"there is nothing to repeat"};
    } else {
      add_range(peek(), peek(), set);
      ++at_;
    }
    sets_.push_back(std::move(set));
    const auto index = static_cast<std::uint32_t>(sets_.size() - 1);
    return {.kind = Node::Kind::code, .code = {.op = Pattern::Op::character, .a = index}};
  }

  Node group() {
    Node look{.kind = Node::Kind::look};
    bool is_look = true;
    if (take(U"?<=")) {
      look.is_ahead = false;
    } else if (take(U"?<!")) {
      look.is_ahead = false;
      look.is_negated = true;
    } else if (take(U"?!")) {
      look.is_negated = true;
    } else if (!take(U"?=")) {
      is_look = false;
      if (!take(U"?:")) skip_name();
    }
    Node inner = choice();
    if (!take(U")")) throw Fault{"a group is not closed"};
    if (!is_look) return inner;
    look.parts.push_back(std::move(inner));
    return look;
  }

  void skip_name() {
    if (!take(U"?")) return;
    const std::size_t end = text_.find(U'>', at_);
    if (peek() != '<' || end == std::u32string::npos) throw Fault{"there is no such kind of group"};
    at_ = end + 1;
  }

  /// Whether `{2}`, `{2,}` or `{2,3}` follows; another brace is an ordinary character.
  bool counts() const {
    if (peek() != '{' || !is_digit(peek(1))) return false;
    std::size_t i = 1;
    while (is_digit(peek(i))) ++i;
    if (peek(i) == ',') ++i;
    while (is_digit(peek(i))) ++i;
    return peek(i) == '}';
  }

  Node repeated(Node one) {
    Node repeat{.kind = Node::Kind::repeat};
    if (take(U"*")) {
      repeat.least = 0;
      repeat.most = kEndless;
    } else if (take(U"+")) {
      repeat.most = kEndless;
    } else if (take(U"?")) {
      repeat.least = 0;
    } else if (counts()) {
      ++at_;
      repeat.most = repeat.least = number();
      if (take(U",")) repeat.most = is_digit(peek()) ? number() : kEndless;
      ++at_;
      if (repeat.most < repeat.least) throw Fault{"the bounds of a repeat are swapped"};
    } else {
      return one;
    }
    take(U"?");  // greedy and lazy repeats match the same texts
    repeat.parts.push_back(std::move(one));
    return repeat;
  }

  std::uint32_t number() {
    std::uint32_t value = 0;
    for (; is_digit(peek()); ++at_) {
      value = std::min(10 * value + static_cast<std::uint32_t>(peek() - '0'), kMostRepeats);
    }
    return value;
  }

  void read_set(Pattern::Set& set) {
    set.is_negated = take(U"^");
    while (!take(U"]")) {
      if (at_ >= text_.size()) throw Fault{"a `[` is not closed"};
      if (peek() == U'[' && peek(1) == U':' && text_.find(U":]", at_) != std::u32string::npos) {
        throw Fault{"classes such as `[:alpha:]` are not part of ECMA-262"};
      }
      const auto first = member(set);
      const bool is_range = peek() == '-' && peek(1) != ']' && at_ + 1 < text_.size();
      if (!is_range) {
        if (first) add_range(*first, *first, set);
        continue;
      }
      ++at_;
      const auto last = member(set);
      if (first && last && *last < *first)
        throw Fault{"the ends of a range of characters are "
                    "swapped"};
      if (first && last) {
        add_range(*first, *last, set);
        continue;
      }
      for (const auto& end : {first, last}) {  // in `\w-x`, the dash is not a range
        if (end) add_range(*end, *end, set);
      }
      add_range('-', '-', set);
    }
  }

  /// One character; none for a class, which is added to the set.
  std::optional<char32_t> member(Pattern::Set& set) {
    if (take(U"\\b")) return U'\b';
    if (take(U"\\")) return escaped(set);
    ++at_;
    return text_[at_ - 1];
  }

  /// Behind a backslash.
  std::optional<char32_t> escaped(Pattern::Set& set) {
    if (at_ >= text_.size()) throw Fault{"it ends with a backslash"};
    const char32_t letter = text_[at_++];
    if (add_class(letter, set)) return std::nullopt;
    Pattern::Set opposite;
    if (letter < 0x80 && add_class(letter | 0x20U, opposite) && letter < 'a') {
      add_rest(opposite, set);
      return std::nullopt;
    }
    switch (letter) {
    case 't': return U'\t';
    case 'n': return U'\n';
    case 'v': return U'\v';
    case 'f': return U'\f';
    case 'r': return U'\r';
    case '0':
      if (!is_digit(peek())) return U'\0';
      break;
    case 'x': return hexadecimal(2);
    case 'u': return unicode();
    case 'c':
      if ((peek() | 0x20U) >= 'a' && (peek() | 0x20U) <= 'z') return text_[at_++] % 32;
      break;
    default: break;
    }
    if (is_digit(letter) || letter == 'k') throw Fault{"back-references are not supported"};
    if ((letter | 0x20U) >= 'a' && (letter | 0x20U) <= 'z' && letter < 0x80) {
      std::string shown;
      utf8::append(shown, letter);
      throw Fault{"`\\" + shown + "` is not supported"};
    }
    return letter;
  }

  char32_t hexadecimal(std::size_t digits) {
    char32_t value = 0;
    for (std::size_t i = 0; i < digits; ++i, ++at_) {
      if (digit_of(peek()) < 0) throw Fault{"a hexadecimal digit is missing"};
      value = 16 * value + static_cast<char32_t>(digit_of(peek()));
    }
    return value;
  }

  char32_t unicode() {
    if (take(U"{")) {
      std::size_t digits = 0;
      while (digit_of(peek(digits)) >= 0) ++digits;
      if (digits == 0 || digits > 6) throw Fault{"`\\u{...}` holds one to six digits"};
      const char32_t value = hexadecimal(digits);
      if (!take(U"}") || value > 0x10FFFF) throw Fault{"there is no such character"};
      return value;
    }
    const char32_t high = hexadecimal(4);
    const bool is_pair = high >= 0xD800 && high < 0xDC00 && take(U"\\u");
    return is_pair ? 0x10000 + ((high - 0xD800) << 10U) + (hexadecimal(4) & 0x3FFU) : high;
  }

  std::u32string text_;
  std::size_t at_ = 0;
  std::vector<Pattern::Set>& sets_;
};

}  // namespace

/// Writes the code of a tree.
class PatternCompiler {
 public:
  static Pattern compile(std::string_view text) {
    Pattern pattern;
    const Node tree = Parser(text, pattern.sets_).run();
    PatternCompiler compiler(pattern);
    pattern.code_ = compiler.code_of(tree, false);
    return pattern;
  }

 private:
  using Op = Pattern::Op;

  explicit PatternCompiler(Pattern& pattern) : pattern_(pattern) {}

  Pattern::Code code_of(const Node& tree, bool is_backward) {
    Pattern::Code code;
    add(tree, is_backward, code);
    code.push_back({});
    return code;
  }

  void add(const Node& node, bool is_backward, Pattern::Code& code) {
    if (++steps_ > kMostCode) throw Fault{"its repeats make it too large"};
    switch (node.kind) {
    case Node::Kind::code: code.push_back(node.code); return;
    case Node::Kind::choice: add_choice(node, is_backward, code); return;
    case Node::Kind::repeat: add_repeat(node, is_backward, code); return;
    case Node::Kind::look: add_look(node, code); return;
    case Node::Kind::sequence: break;
    }
    const std::size_t count = node.parts.size();
    for (std::size_t i = 0; i < count; ++i) {
      add(node.parts[is_backward ? count - 1 - i : i], is_backward, code);
    }
  }

  static std::uint32_t end_of(const Pattern::Code& code) {
    return static_cast<std::uint32_t>(code.size());
  }

  void add_choice(const Node& node, bool is_backward, Pattern::Code& code) {
    std::vector<std::size_t> jumps;
    for (std::size_t i = 0; i + 1 < node.parts.size(); ++i) {
      const std::size_t split = code.size();
      code.push_back({.op = Op::split, .a = end_of(code) + 1});
      add(node.parts[i], is_backward, code);
      jumps.push_back(code.size());
      code.push_back({.op = Op::jump});
      code[split].b = end_of(code);
    }
    add(node.parts.back(), is_backward, code);
    for (const std::size_t jump : jumps) code[jump].a = end_of(code);
  }

  void add_repeat(const Node& node, bool is_backward, Pattern::Code& code) {
    const Node& one = node.parts.front();
    for (std::uint32_t i = 0; i < node.least; ++i) add(one, is_backward, code);
    if (node.most == kEndless) {
      const std::size_t split = code.size();
      code.push_back({.op = Op::split, .a = end_of(code) + 1});
      add(one, is_backward, code);
      code.push_back({.op = Op::jump, .a = static_cast<std::uint32_t>(split)});
      code[split].b = end_of(code);
      return;
    }
    std::vector<std::size_t> splits;
    for (std::uint32_t i = node.least; i < node.most; ++i) {
      splits.push_back(code.size());
      code.push_back({.op = Op::split, .a = end_of(code) + 1});
      add(one, is_backward, code);
    }
    for (const std::size_t split : splits) code[split].b = end_of(code);
  }

  void add_look(const Node& node, Pattern::Code& code) {
    Pattern::Look look{code_of(node.parts.front(), node.is_ahead), node.is_ahead};
    pattern_.looks_.push_back(std::move(look));
    const auto index = static_cast<std::uint32_t>(pattern_.looks_.size() - 1);
    code.push_back({.op = Op::look, .is_negated = node.is_negated, .a = index});
  }

  Pattern& pattern_;
  std::size_t steps_ = 0;
};

std::variant<Pattern, Pattern::Fault> Pattern::compile(std::string_view text) {
  try {
    return PatternCompiler::compile(text);
  } catch (const smurf::Fault& fault) {
    return fault.reason;
  }
}

}  // namespace smurf
