// SPDX-License-Identifier: BSD-3-Clause
// Random trees, written in random styles, are read back as they were, and every span holds its
// value.
#include <doctest/doctest.h>

#include "unit/parsed.hpp"
#include "unit/random.hpp"

using namespace smurf;
using smurf::test::join;
using smurf::test::ParsedYaml;
using smurf::test::Random;

namespace {

struct Tree {
  yaml::Kind kind = yaml::Kind::null;
  std::string text;
  yaml::Style style = yaml::Style::plain;  ///< as it was written
  std::vector<std::string> keys;           ///< of a mapping
  std::vector<Tree> children;
};

class Maker {
 public:
  explicit Maker(Random& random) : random_(random) {}

  Tree tree(int depth) {
    Tree tree;
    const std::size_t choice = random_.below(depth > 0 ? 6 : 3);
    if (choice == 0) return tree;
    if (choice < 3) {
      tree.kind = yaml::Kind::scalar;
      tree.text = text();
      return tree;
    }
    tree.kind = choice < 5 ? yaml::Kind::mapping : yaml::Kind::sequence;
    const std::size_t count = random_.below(5);
    for (std::size_t i = 0; i < count; ++i) {
      // A unique number makes keys different.
      if (tree.kind == yaml::Kind::mapping) tree.keys.push_back(text() + std::to_string(i));
      tree.children.push_back(this->tree(depth - 1));
    }
    return tree;
  }

 private:
  std::string text() {
    static constexpr std::string_view kPieces[] = {"a",
                                                   "b",
                                                   "joint",
                                                   "7",
                                                   "1.5",
                                                   "_",
                                                   "-",
                                                   ".",
                                                   " ",
                                                   " ",
                                                   "\xC3\xA4",
                                                   "\xE2\x82\xAC",
                                                   "\xF0\x9F\xA4\x96",
                                                   "'",
                                                   "\"",
                                                   "\\",
                                                   "\n",
                                                   "\t",
                                                   ":",
                                                   ": ",
                                                   "#",
                                                   " #",
                                                   ",",
                                                   "[",
                                                   "]",
                                                   "{",
                                                   "}",
                                                   "&",
                                                   "*",
                                                   "!",
                                                   "|",
                                                   ">",
                                                   "%",
                                                   "@",
                                                   "`",
                                                   "?",
                                                   "~",
                                                   "null",
                                                   "true",
                                                   "\n\n",
                                                   "- ",
                                                   "/"};
    const bool is_plain = !random_.one_in(3);
    std::string all;
    for (std::size_t size = random_.below(7) + (is_plain ? 1 : 0); size > 0; --size) {
      all += kPieces[random_.below(is_plain ? 13 : std::size(kPieces))];
    }
    return all;
  }

  Random& random_;
};

class Writer {
 public:
  explicit Writer(Random& random) : random_(random) {}

  std::string write(Tree& tree) {
    if (random_.one_in(8)) out_ += "\xEF\xBB\xBF";
    if (random_.one_in(4)) out_ += "# top\n";
    if (is_block(tree)) {
      collection(tree, random_.below(3));
    } else {
      if (tree.kind == yaml::Kind::null)
        out_ += "~";
      else
        inline_value(tree, false, 1);
      out_ += "\n";
    }
    if (random_.one_in(4)) replace_line_ends();
    return out_;
  }

 private:
  bool is_block(const Tree& tree) { return !tree.children.empty() && !random_.one_in(4); }

  void replace_line_ends() {
    std::string crlf;
    for (const char c : out_) {
      if (c == '\n') crlf += '\r';
      crlf += c;
    }
    out_ = crlf;
  }

  void properties() {
    if (random_.one_in(12)) out_ += " &x" + std::to_string(random_.below(9));
  }

  void noise(std::size_t indent) {
    if (random_.one_in(12)) out_ += "\n";
    if (random_.one_in(12)) out_ += std::string(indent, ' ') + "# note: [ ' \"\n";
  }

  void collection(Tree& tree, std::size_t indent) {
    for (std::size_t i = 0; i < tree.children.size(); ++i) {
      noise(indent);
      out_ += std::string(indent, ' ');
      if (tree.kind == yaml::Kind::sequence) {
        out_ += '-';
      } else {
        key(tree.keys[i]);
        out_ += ':';
      }
      value(tree.children[i], indent);
    }
  }

  void value(Tree& tree, std::size_t indent) {
    if (is_block(tree)) {
      properties();
      end_line();
      return collection(tree, indent + 1 + random_.below(3));
    }
    if (tree.kind == yaml::Kind::null) {
      static constexpr std::string_view kNulls[] = {"", " ~", " null", " Null", " NULL"};
      out_ += kNulls[random_.below(5)];
      return end_line();
    }
    if (tree.kind == yaml::Kind::scalar && is_literal(tree.text) && random_.one_in(2)) {
      return literal(tree, indent + 1 + random_.below(3));
    }
    // After `- &x`, yaml-cpp requires further lines to be deeper than the anchor; YAML does not.
    if (out_.back() == ':') properties();
    out_ += ' ';
    inline_value(tree, false, indent + 1);
    end_line();
  }

  void end_line() { out_ += random_.one_in(6) ? " # end\n" : "\n"; }

  static bool is_literal(const std::string& text) {
    if (text.empty() || text.find_first_not_of(" \n\t") != 0) return false;
    if (text.ends_with("\n\n")) return false;
    return text.find(" \n") == text.npos && text.find("\t\n") == text.npos && text.back() != ' ' &&
           text.back() != '\t';
  }

  void literal(Tree& tree, std::size_t indent) {
    tree.style = yaml::Style::block;
    out_ += tree.text.ends_with('\n') ? " |\n" : " |-\n";
    std::string line;
    for (const char c : tree.text + (tree.text.ends_with('\n') ? "" : "\n")) {
      if (c != '\n') {
        line += c;
        continue;
      }
      if (!line.empty()) out_ += std::string(indent, ' ') + line;
      out_ += '\n';
      line.clear();
    }
  }

  /// A value without block style: a scalar, or a collection in brackets.
  void inline_value(Tree& tree, bool in_flow, std::size_t indent) {
    if (tree.kind == yaml::Kind::null) {
      out_ += random_.one_in(2) ? "~" : "null";
    } else if (tree.kind == yaml::Kind::scalar) {
      scalar(tree.text, &tree.style, in_flow, indent);
    } else {
      flow(tree, indent);
    }
  }

  void gap(std::size_t indent) {
    if (random_.one_in(5)) out_ += ' ';
    if (random_.one_in(10))
      out_ += (random_.one_in(2) ? " # ] }\n" : "\n") + std::string(indent, ' ');
  }

  void flow(Tree& tree, std::size_t indent) {
    const bool is_mapping = tree.kind == yaml::Kind::mapping;
    out_ += is_mapping ? '{' : '[';
    for (std::size_t i = 0; i < tree.children.size(); ++i) {
      if (i > 0) out_ += ',';
      gap(indent);
      if (is_mapping) {
        key(tree.keys[i]);
        out_ += ": ";
      }
      inline_value(tree.children[i], true, indent);
      gap(indent);
    }
    out_ += is_mapping ? '}' : ']';
  }

  void key(const std::string& text) { scalar(text, nullptr, true, 0); }

  /// Keys stay on one line; `style` is null for them.
  void scalar(const std::string& text, yaml::Style* style, bool in_flow, std::size_t indent) {
    const bool may_fold = style != nullptr;
    yaml::Style unused{};
    yaml::Style& used = style != nullptr ? *style : unused;
    if (is_plain(text) && !random_.one_in(4)) {
      used = yaml::Style::plain;
      out_ += may_fold && !in_flow ? folded(text, indent) : text;
    } else if (text.find_first_of("\n\t") == text.npos && random_.one_in(2)) {
      used = yaml::Style::single_quoted;
      out_ += '\'';
      for (const char c : may_fold ? folded(text, indent) : text) {
        out_ += c;
        if (c == '\'') out_ += c;
      }
      out_ += '\'';
    } else {
      used = yaml::Style::double_quoted;
      out_ += '"' + escaped(text) + '"';
    }
  }

  static bool is_plain(const std::string& text) {
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c & '\x80') != 0; };
    return !text.empty() && is_letter(text.front()) && text.back() != ' ' &&
           text.find_first_of("'\"\\\n\t:#,[]{}&*!|>%@`?~/") == text.npos &&
           text.find("null") == text.npos;
  }

  /// One space between two letters may become a line end.
  std::string folded(const std::string& text, std::size_t indent) {
    std::string all;
    for (std::size_t i = 0; i < text.size(); ++i) {
      const bool is_single = text[i] == ' ' && i > 0 && i + 1 < text.size() && text[i - 1] != ' ' &&
                             text[i + 1] != ' ' && text[i + 1] != '-' && text[i + 1] != '#';
      if (is_single && random_.one_in(3)) {
        all += "\n" + std::string(indent, ' ');
      } else {
        all += text[i];
      }
    }
    return all;
  }

  std::string escaped(const std::string& text) {
    std::string all;
    for (const char c : text) {
      if (c == '"' || c == '\\')
        all += std::string("\\") + c;
      else if (c == '\n')
        all += "\\n";
      else if (c == '\t')
        all += random_.one_in(2) ? "\\t" : "\\x09";
      else if (c == 'a' && random_.one_in(4))
        all += "\\u0061";
      else
        all += c;
    }
    return all;
  }

  Random& random_;
  std::string out_;
};

/// Empty if the tree equals the written one, otherwise the difference.
std::string difference(const ParsedYaml& parsed, yaml::View view, const Tree& tree) {
  const std::string where = yaml::pointer(view.document(), view.id()) + ": ";
  if (view.kind() != tree.kind) return where + "kind";
  if (tree.kind == yaml::Kind::scalar) {
    if (view.text() != tree.text) return where + "text " + test::visible(view.text());
    if (view.style() != tree.style) return where + "style";
    const std::string slice(parsed.sources.text(view.span()));
    const ParsedYaml again(slice + "\n");
    if (!again.document || again.root().text() != tree.text) return where + "span [" + slice + "]";
    if (slice.empty() || slice.front() == ' ' || slice.back() == '\n') return where + "span's ends";
  }
  if (view.size() != tree.children.size()) return where + "size";
  std::size_t i = 0;
  for (const yaml::View child : view) {
    if (tree.kind == yaml::Kind::mapping) {
      if (child.key() != tree.keys[i]) return where + "key " + test::visible(child.key());
      const ParsedYaml again(std::string(parsed.sources.text(child.key_span())) + "\n");
      if (!again.document || again.root().text() != tree.keys[i]) return where + "key's span";
    }
    const bool is_inside =
        view.span().begin <= child.span().begin && child.span().end <= view.span().end;
    if (!is_inside) return where + "a child outside of its parent";
    if (std::string found = difference(parsed, child, tree.children[i]); !found.empty()) {
      return found;
    }
    ++i;
  }
  return {};
}

}  // namespace

TEST_CASE("yaml: random trees are read as they were written") {
  MESSAGE("seed " << test::seed());
  Random random;
  for (int i = 0; i < 3000; ++i) {
    Tree tree = Maker(random).tree(4);
    const std::string text = Writer(random).write(tree);
    const ParsedYaml parsed(text);
    const std::string found = !parsed.document || parsed.document->root == yaml::kNoNode
                                  ? "no tree"
                                  : difference(parsed, parsed.root(), tree);
    if (found.empty() && parsed.sink.diagnostics().empty()) continue;
    CAPTURE(i);
    CAPTURE(test::visible(text));
    CHECK(found == "");
    CHECK(join(parsed.briefs()) == "");
    if (!found.empty()) break;
  }
}
