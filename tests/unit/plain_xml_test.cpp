// SPDX-License-Identifier: BSD-3-Clause
// The scanner of XML against tinyxml2, its judge: what the scanner takes for plain, both read to
// the same tree, byte for byte, with the same diagnostics.
#include <doctest/doctest.h>

#include <iterator>

#include "support/described_xml.hpp"
#include "support/texts.hpp"
#include "syntax/xml_scanner.hpp"

using namespace smurf;
using smurf::test::described_xml;
using smurf::test::Random;

namespace {

constexpr std::string_view kExtensions[] = {".urdf", ".srdf", ".xml",  ".scn",
                                            ".svg",  ".sdf",  ".xacro"};

bool is_plain(const std::string& text) {
  SourceMap sources;
  DiagnosticSink sink;
  const ScannedXml scanned = scan_xml(sources, sources.add("a.urdf", text), {}, sink);
  return scanned.well_formed && scanned.is_plain;
}

/// True when the scanner took the text for plain.
bool compare(const std::string& text) {
  if (!is_plain(text)) return false;
  INFO(text);
  CHECK(described_xml(XmlEngine::scanner_first, text) == described_xml(XmlEngine::tinyxml2, text));
  return true;
}

std::string random_token(Random& random) {
  static constexpr std::string_view kTokens[] = {"<a>",
                                                 "</a>",
                                                 "<a/>",
                                                 "<b c='d'/>",
                                                 "<b c=\"1 2\">",
                                                 "</b>",
                                                 " c='&lt;'",
                                                 " e = 'f'",
                                                 "text",
                                                 " ",
                                                 "\n",
                                                 "\t",
                                                 "\r\n",
                                                 "<!-- x -->",
                                                 "<!---->",
                                                 "<!-",
                                                 "--",
                                                 "<![CDATA[ y ]]>",
                                                 "<?p?>",
                                                 "<?xml version='1.0'?>",
                                                 "<!DOCTYPE a>",
                                                 "&amp;",
                                                 "&#65;",
                                                 "&x;",
                                                 "&",
                                                 "'",
                                                 "\"",
                                                 "<",
                                                 ">",
                                                 "/",
                                                 "=",
                                                 "</a",
                                                 "<a ",
                                                 "\xC3\xA4",
                                                 "\xEF\xBB\xBF",
                                                 "a:b",
                                                 "-",
                                                 ".",
                                                 "1",
                                                 "]]>",
                                                 "/>",
                                                 "?>",
                                                 "-->",
                                                 "<a>t</a>",
                                                 "<a>t<b/>u</a>",
                                                 "<a><b/>t</a>",
                                                 "<a> <!-- c --> t</a>",
                                                 " g='\r\n'",
                                                 "h='\t'"};
  return std::string(kTokens[random.below(std::size(kTokens))]);
}

}  // namespace

TEST_CASE("plain is what has nothing to decode") {
  for (const char* text :
       {"<a/>", "<?xml version='1.0'?>\n<!-- c -->\n<a b='c' d=\"e f\">g<h/>i</a>\n",
        "<a>\r\n  <b c='1'/>\r\n</a>\r\n", "\xEF\xBB\xBF<a/>", "<a> <!-- c --> text </a>",
        "<a><b/>text</a>", "<a b='>'/>", "<a >text</a >", "<\xC3\xA4:b.c-d/>"}) {
    CAPTURE(text);
    CHECK(compare(text));
  }
  for (const char* text :
       {"<a b='&amp;'/>", "<a>&#65;</a>", "<a b='\r\n'/>", "<a>b\r\nc</a>", "<a><![CDATA[b]]></a>",
        "<!DOCTYPE a><a/>", "<?p q?><a/>", "<?xml version='1.0'?><?xml version='1.0'?><a/>", "<a>",
        "<a/><b/>", "a", "<a b=c/>", "<a/>b"}) {
    CAPTURE(text);
    CHECK_FALSE(is_plain(text));
  }
}

TEST_CASE("both read the XML of the fixtures and of the corpus alike") {
  test::compare_files(kExtensions, compare, 0.7);
}

TEST_CASE("both read mutated XML alike") {
  test::compare_made(kExtensions, compare, 0.05, [](const std::string& seed, Random& random) {
    if (random.one_in(2)) {
      const std::string lines = test::some_lines(seed, random);
      return test::mutated("<r>\n" + lines + "</r>\n", random_token, random);
    }
    std::string text;
    for (std::size_t tokens = random.below(8); tokens > 0; --tokens) text += random_token(random);
    return "<r" + std::string(random.one_in(4) ? random_token(random) : ">") + text + "</r>";
  });
}
