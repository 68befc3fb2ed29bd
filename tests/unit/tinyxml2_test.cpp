// SPDX-License-Identifier: BSD-3-Clause
// Compares our XML reader with tinyxml2: both read a text that we accept to the same tree, byte for
// byte. tinyxml2 refuses such a text only where TinyXML alone is lenient.
#include <doctest/doctest.h>

#include <iterator>

#include "support/described_xml.hpp"
#include "support/texts.hpp"

using namespace smurf;
using smurf::test::described_xml;
using smurf::test::Random;
using smurf::test::XmlReader;

namespace {

constexpr std::string_view kExtensions[] = {".urdf", ".srdf", ".xml",  ".scn",
                                            ".svg",  ".sdf",  ".xacro"};

/// Whether we report a late processing instruction, or a value without quotes.
bool is_for_tinyxml_alone(const std::string& described) {
  return described.find("SML1015 ") != std::string::npos ||
         described.find("SML1016 ") != std::string::npos;
}

/// Whether we accepted the text as XML.
bool compare(const std::string& text) {
  const std::string ours = described_xml(XmlReader::ours, text);
  if (ours.ends_with("refused")) return false;
  INFO(text);
  const std::string theirs = described_xml(XmlReader::tinyxml2, text);
  if (is_for_tinyxml_alone(ours)) {
    CHECK(theirs.ends_with("refused"));
  } else {
    CHECK(ours == theirs);
  }
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

TEST_CASE("both read every construct alike") {
  for (const char* text : {"<a/>",
                           "<?xml version='1.0'?>\n<!-- c -->\n<a b='c' d=\"e f\">g<h/>i</a>\n",
                           "<a>\r\n  <b c='1'/>\r\n</a>\r\n",
                           "\xEF\xBB\xBF<a/>",
                           "<a> <!-- c --> text </a>",
                           "<a><b/>text</a>",
                           "<a b='>'/>",
                           "<a >text</a >",
                           "<\xC3\xA4:b.c-d/>",
                           "<a b='&amp;&lt;&gt;&quot;&apos;'/>",
                           "<a>&#65;&#x41;&#x20ac;&#x1F600;&#0000000000065;</a>",
                           "<a b='\r\n\n\r\r \n\n'/>",
                           "<a>\r\nb\r\nc\r</a>",
                           "<a><![CDATA[&amp;\r\n]]></a>",
                           "<a><![CDATA[ ]]>b</a>",
                           "<a>b<![CDATA[c]]></a>",
                           "<a><![CDATA[]]>b</a>",
                           "<!DOCTYPE a><a/>",
                           "<!DOCTYPE a [<!ENTITY b 'c'> <!ENTITY d 'e'>]><a/>",
                           "<?p q?><a/>",
                           "<?xml version='1.0'?><?xml version='1.0'?><a/>"}) {
    CAPTURE(text);
    CHECK(compare(text));
  }
  for (const char* text :
       {"<a b=c/>", "<a/><?p?>", "<a/><b/>", "<a/><b c='d'>e</b><f/>", "<a b=c d = e>f</a>",
        "<a><?p?></a>", "<!-- a --><?xml version='1.0'?><a/>"}) {
    CAPTURE(text);
    CHECK(compare(text));
  }
  // tinyxml2 garbles values with a wrong reference; those are not compared.
  for (const char* text : {"<a b='&lt;&c;'/>", "<a>&lt; & c</a>", "<a b='c&#0;d'/>",
                           "<a b='&#xD800;'/>", "<a b='&#99999999999;'/>", "<a b='&#;&#x;&;&'/>"}) {
    CAPTURE(text);
    CHECK(compare(text));
  }
  for (const char* text :
       {"<a>", "<a/></>", "<a/><b>", "<a/><link/>", "a", "<a/>b",
        "<!DOCTYPE a [<!ENTITY b '<c/><d/>'>]><a/>", "<!DOCTYPE a [<!-- > --> <b/>]><a/>",
        "<!DOCTYPE a [<!b>] <c>]><a/>", "<a><!DOCTYPE b>c</a>", "<a/><!DOCTYPE a>"}) {
    CAPTURE(text);
    CHECK_FALSE(compare(text));
  }
}

TEST_CASE("both read the XML of the fixtures and of the corpus alike") {
  test::compare_files(kExtensions, compare, 0.8);
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
