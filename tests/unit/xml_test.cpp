// SPDX-License-Identifier: BSD-3-Clause
// Every XML construct with its byte span, and every syntax error with its place.
#include <doctest/doctest.h>

#include "support/repeat.hpp"
#include "unit/parsed.hpp"

using namespace smurf;
using smurf::test::check_errors;
using smurf::test::ErrorCase;
using smurf::test::join;
using smurf::test::Lines;
using smurf::test::ParsedXml;
using smurf::test::repeat;
using smurf::test::visible;

namespace {

struct TreeCase {
  std::string title;
  std::string text;
  Lines lines;
};

void check(const std::vector<TreeCase>& cases) {
  for (const TreeCase& one : cases) {
    CAPTURE(one.title);
    const ParsedXml parsed(one.text);
    CHECK(join(parsed.briefs()) == "");
    REQUIRE(parsed.document);
    CHECK(join(parsed.lines()) == join(one.lines));
  }
}

void check(const std::vector<ErrorCase>& cases) { check_errors<ParsedXml>(cases); }

}  // namespace

TEST_CASE("xml: spans") {
  check(std::vector<TreeCase>{
      {"elements and attributes",
       "<r a=\"1\">\n <b  x = 'y z'/><c></c >\n</r>\n",
       {"/r [r] tag [<r a=\"1\">] whole [<r a=\"1\">\\n <b  x = 'y z'/><c></c >\\n</r>]",
        "  @a [a] [1] in [a=\"1\"]", "/r/b [b] tag [<b  x = 'y z'/>] whole [<b  x = 'y z'/>]",
        "  @x [x] [y z] in [x = 'y z']", "/r/c [c] tag [<c>] whole [<c></c >]"}},
      {"line ends and tabs in a tag",
       "<r\n\ta='1'\r\n b='2'\n/>",
       {"/r [r] tag [<r\\n\\ta='1'\\r\\n b='2'\\n/>] whole [<r\\n\\ta='1'\\r\\n b='2'\\n/>]",
        "  @a [a] [1] in [a='1']", "  @b [b] [2] in [b='2']"}},
      {"entities are decoded",
       "<r a='&lt;&amp;&#65;&#x20AC;&quot;&apos;&gt;'>x&amp;y</r>",
       {"/r [r] tag [<r a='&lt;&amp;&#65;&#x20AC;&quot;&apos;&gt;'>] whole "
        "[<r a='&lt;&amp;&#65;&#x20AC;&quot;&apos;&gt;'>x&amp;y</r>] text [x&amp;y] = x&y",
        "  @a [a] [&lt;&amp;&#65;&#x20AC;&quot;&apos;&gt;] in "
        "[a='&lt;&amp;&#65;&#x20AC;&quot;&apos;&gt;'] = <&A\xE2\x82\xAC\"'>"}},
      {"text, CDATA and comments",
       "<r><a> x <b/> y</a><c><![CDATA[<i> & ]]></c><d><!-- <e/> -->z</d></r>",
       {"/r [r] tag [<r>] whole [<r><a> x <b/> y</a><c><![CDATA[<i> & ]]></c><d><!-- <e/> -->z</d></r>]",
        "/r/a [a] tag [<a>] whole [<a> x <b/> y</a>] text [x] =  x ",
        "/r/a/b [b] tag [<b/>] whole [<b/>]",
        "/r/c [c] tag [<c>] whole [<c><![CDATA[<i> & ]]></c>] text [<i> &] = <i> & ",
        "/r/d [d] tag [<d>] whole [<d><!-- <e/> -->z</d>] text [z]"}},
      {"brackets inside of values and comments",
       "<r a='>' b=\"'/>\"><!-- </r> --></r>",
       {"/r [r] tag [<r a='>' b=\"'/>\">] whole [<r a='>' b=\"'/>\"><!-- </r> --></r>]",
        "  @a [a] [>] in [a='>']", "  @b [b] ['/>] in [b=\"'/>\"]"}},
      {"elements of one name inside each other",
       "<a><a><a/></a><a/></a>",
       {"/a [a] tag [<a>] whole [<a><a><a/></a><a/></a>]",
        "/a/a[1] [a] tag [<a>] whole [<a><a/></a>]", "/a/a[1]/a [a] tag [<a/>] whole [<a/>]",
        "/a/a[2] [a] tag [<a/>] whole [<a/>]"}},
      {"declaration, document type, instruction, comments around the root",
       "<?xml version=\"1.0\"?>\n<?x y?>\n<!DOCTYPE r><!-- c -->\n<r/>\n<!-- d -->\n",
       {"/r [r] tag [<r/>] whole [<r/>]"}},
      {"byte order mark",
       "\xEF\xBB\xBF<?xml version='1.0'?><r b='\xC3\xA4'/>",
       {"/r [r] tag [<r b='\xC3\xA4'/>] whole [<r b='\xC3\xA4'/>]",
        "  @b [b] [\xC3\xA4] in [b='\xC3\xA4']"}},
      {"names that are not ASCII",
       "<r\xC3\xB6:x xmlns:r\xC3\xB6='u'/>",
       {"/r\xC3\xB6:x [r\xC3\xB6:x] tag [<r\xC3\xB6:x xmlns:r\xC3\xB6='u'/>] whole "
        "[<r\xC3\xB6:x xmlns:r\xC3\xB6='u'/>]",
        "  @xmlns:r\xC3\xB6 [xmlns:r\xC3\xB6] [u] in [xmlns:r\xC3\xB6='u']"}},
  });
}

TEST_CASE("xml: comments are kept") {
  const std::string text = "<!-- a --><r><!----><b/><!-- c\n--></r>";
  const ParsedXml parsed(text);
  REQUIRE(parsed.document);
  Lines comments;
  for (const Span span : parsed.document->comments)
    comments.emplace_back(visible(parsed.sources.text(span)));
  CHECK(join(comments) == join({"<!-- a -->", "<!---->", "<!-- c\\n-->"}));
}

TEST_CASE("xml: paths and places") {
  const std::string text =
      "<robot name='x'><link name='a'/><link name=\"it's\"><visual/><visual/></link>"
      "<joint name='j'><limit/></joint><link name='a'/><link/></robot>";
  const ParsedXml parsed(text);
  REQUIRE(parsed.document);
  struct Place {
    std::string at;
    std::string path;
  };
  const Place places[] = {{"<robot", "/robot"},
                          {"<link name='a'", "/robot/link[@name='a'][1]"},
                          {"'a'/><link/>", "/robot/link[@name='a'][2]"},
                          {"<link name=\"it's", "/robot/link[2]"},
                          {"visual/></", "/robot/link[2]/visual[2]"},
                          {"limit", "/robot/joint[@name='j']/limit"},
                          {"<link/>", "/robot/link[4]"},
                          {"</robot>", "/robot"}};
  for (const Place& place : places) {
    CAPTURE(place.at);
    const auto offset = static_cast<std::uint32_t>(text.find(place.at));
    CHECK(xml::xpath(*parsed.document, xml::element_at(*parsed.document, offset)) == place.path);
  }
  CHECK(xml::element_at(*parsed.document, static_cast<std::uint32_t>(text.size())) ==
        xml::kNoElement);
  CHECK(!parsed.root().child("sensor"));
  CHECK(parsed.root().child("joint").child("limit"));
  CHECK(!parsed.root().child("x").child("y"));
  CHECK(parsed.root().attribute("name")->value() == "x");
  CHECK(parsed.root().attribute("nam") == nullptr);
}

TEST_CASE("xml: broken structure is reported at its cause") {
  check(std::vector<ErrorCase>{
      {"", {"SML1010 1:1 []"}},
      {" \n", {"SML1010 1:1 []"}},
      {"version https://git-lfs.github.com/spec/v1\noid x\n", {"SML1010 1:1 []"}},
      {"<!-- only -->", {"SML1001 1:1 []"}},
      {"plain", {"SML1001 1:1 [plain]"}},
      {"<r>", {"SML1001 1:4 []"}},
      {"<r>\n<a>\n</r>", {"SML1001 3:3 [r]"}},
      {"<r></r></r>", {"SML1001 1:8 [</r>]"}, true},
      {"<r></R>", {"SML1001 1:6 [R]"}},
      {"<r><a</r>", {"SML1001 1:6 [<]"}},
      {"<r a=/>", {"SML1001 1:4 [a]"}},
      {"<r a=1'/>", {"SML1001 1:4 [a]"}},
      {"<r a=b/c>", {"SML1001 1:4 [a]"}},
      {"<r a=\xE2\x80\x9C"
       "6\xE2\x80\x9D/>",
       {"SML1001 1:4 [a]"}},
      {"<r a=1", {"SML1001 1:4 [a]"}},
      {"<r a/>", {"SML1001 1:4 [a]"}},
      {"<r a='1/>", {"SML1001 1:6 [']"}},
      {"<r a='1<\n'/>", {"SML1001 1:6 [']"}},
      {"<r a='1><b c=''/>", {"SML1001 1:6 [']"}},
      {"<r a='1' a='2'/>", {"SML1007 1:10 [a]"}},
      {"<r/><link/>", {"SML1006 1:6 [link]"}},
      {"<r/><s>", {"SML1006 1:6 [s]", "SML1001 1:8 []"}},
      {"<r/> text", {"SML1001 1:6 [text]"}},
      {"text <r/>", {"SML1001 1:1 [text ]"}},
      {"<r/><![CDATA[x]]>", {"SML1001 1:5 [<![CDATA[x]]>]"}},
      {"<r", {"SML1001 1:2 [r]"}},
      {"<", {"SML1001 1:1 [<]"}},
      {"<r><!-- </r>", {"SML1001 1:4 [<!--]"}},
      {"<r><![CDATA[ </r>", {"SML1001 1:4 [<!]"}},
      {"<r><?x </r>", {"SML1001 1:4 [<?]"}},
      {"<r>< a/></r>", {"SML1001 1:4 [<]"}},
      {"<r></r", {"SML1001 1:4 [</r]"}},
      {"<r></>", {"SML1001 1:6 []"}},
      {"<!DOCTYPE r", {"SML1001 1:1 [<!DOCTYPE]"}},
      {"<!DOCTYPE r [<!ENTITY e 'x'>", {"SML1001 1:1 [<!DOCTYPE]"}},
      {"<?a >?><r/>", {"SML1001 1:5 [>]"}},
      {"<?xml version?><r/>", {"SML1001 1:7 [v]"}},
      {"<?xml version='1.0\"?><r/>", {"SML1001 1:15 [']"}},
      {"<?xml version='1.0'encoding='UTF-8'?><r/>", {"SML1001 1:20 [e]"}},
      {"<?xml version='1.0' encoding]='UTF-8'?><r/>", {"SML1001 1:29 []]"}},
      {"<?xml version = '1.0' ='UTF-8'?><r/>", {"SML1001 1:23 [=]"}},
      {std::string("<r\0/>", 6), {"SML0004 1:3 [" + std::string(1, '\0') + "]"}},
      {"\xFE\xFF<r/>", {"SML0005 1:1 []"}},
  });
}

TEST_CASE("xml: what lenient readers accept is reported, and the tree is kept") {
  check(std::vector<ErrorCase>{
      {"<r/><s/><t/>", {"SML1006 1:6 [s]"}, true},
      {"<r a='\xFF'/>", {"SML0003 1:7 [\xFF]"}, true},
      {std::string("<r/>\n\0\0 ", 8), {"SML0004 2:1 [" + std::string(1, '\0') + "]"}, true},
      {"<r a='x & y'/>", {"SML1003 1:9 [&]"}, true},
      {"<r>a&b</r>", {"SML1003 1:5 [&]"}, true},
      {"<r a='1'b='2'c='3'/>", {"SML1014 1:9 [b]", "SML1014 1:14 [c]"}, true},
      {"<r><?x y?></r>", {"SML1015 1:4 [<?x y?>]"}, true},
      {"<!-- a --><?xml version='1.0'?><r/>", {"SML1015 1:11 [<?xml version='1.0'?>]"}, true},
      {"<r a=1 b=2/>", {"SML1016 1:6 [1]", "SML1016 1:10 [2]"}, true},
      {"<r a= x>t</r>", {"SML1016 1:7 [x]"}, true},
      {"<r a='<1<&amp;2'/>", {"SML1017 1:7 [<]", "SML1017 1:9 [<]"}, true},
      {"<r a='&#;&#x;&#xZ;&#0;&#xD800;&#9;'/>",
       {"SML1003 1:7 [&]", "SML1003 1:10 [&]", "SML1003 1:14 [&]", "SML1003 1:19 [&]",
        "SML1003 1:23 [&]"},
       true},
      {"<r a='&foo;'/>", {"SML1013 1:7 [&foo;]"}, true},
      {"<r><!-- a -- b --></r>", {"SML1004 1:11 [--]"}, true},
      {"<r><!-- a ---></r>", {"SML1004 1:11 [--]"}, true},
      {" \n<?xml version='1.0'?><r/>", {"SML1005 1:1 [ \\n]"}, true},
      {"<r><x:y/><x:z/></r>", {"SML1002 1:5 [x]"}, true},
      {"<r x:y='1'/>", {"SML1002 1:4 [x]"}, true},
      {"<r><xi:include/></r>", {"SML1013 1:5 [xi:include]"}, true},
      {"<r a='\x7F'/>", {}, true},
      {"<?xml version='1.0' encoding='UTF-16'?><r/>", {"SML1008 1:31 [UTF-16]"}, true},
      {"<?xml version='1.0' encoding='latin1'?><r/>", {}, true},
      {"<?xml version='1.0' encoding='latin1'?><r a='\xC3\xBC'/>", {"SML1008 1:31 [latin1]"}, true},
      {"<r xmlns:x='u'><x:y/></r>", {}, true},
      {"<r><a xmlns:x='u'/><x:y/></r>", {"SML1002 1:21 [x]"}, true},
      {"<r><a xmlns:x='u'><b xmlns:x='v'/><x:y/></a></r>", {}, true},
      {"<r xml:space='preserve'><xacro:a/></r>", {}, true},
      {"<!DOCTYPE r [<!ENTITY e 'x'>]><r/>", {"SML1013 1:1 [<!DOCTYPE]"}, true},
  });
}

TEST_CASE("xml: depth and attributes are limited") {
  const Limits limits;
  check(std::vector<ErrorCase>{
      {repeat("<a>", limits.xml_depth) + repeat("</a>", limits.xml_depth), {}, true},
      {repeat("<a>", limits.xml_depth + 1), {"SML0014 1:272 [a]"}},
  });
  std::string many;
  for (std::uint32_t i = 0; i < limits.xml_attributes; ++i)
    many += " a" + std::to_string(i) + "=''";
  check(std::vector<ErrorCase>{{"<r" + many + "/>", {}, true},
                               {"<r" + many + " b=''/>", {"SML0002 1:2 [r]"}}});
}
