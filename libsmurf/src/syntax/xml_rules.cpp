// SPDX-License-Identifier: BSD-3-Clause
// What the XML reader reports.
#include "base/rules.hpp"

namespace smurf::rules {

constinit const Rule sml1001_xml_malformed{
    .id = "SML1001",
    .name = "xml-malformed",
    .severity = Severity::error,
    .summary = "A URDF is not well-formed XML.",
    .why = "Every reader refuses such a file, most of them without a line number; TinyXML 1 inside "
           "urdfdom 3 accepts some defects, so a file that works in ROS 1 fails in browsers, lxml "
           "and MuJoCo.",
    .remedy = "Close the element, the quote or the bracket that the message names.",
    .sources = "urdfdom 3.0.1, sdformat 12.3, MuJoCo 3.14 and urdf-loader 0.13, executed; urdfdom "
               "model.cpp:98-101."};

constinit const Rule sml1002_xml_undeclared_prefix{
    .id = "SML1002",
    .name = "xml-undeclared-prefix",
    .severity = Severity::error,
    .summary = "An element or attribute uses a namespace prefix that is not declared.",
    .why =
        "urdfdom and tinyxml2 do not look; expat, lxml and every browser (urdf-loader) refuse the "
        "whole file.",
    .remedy = "Declare the prefix on the robot element with xmlns:prefix, or remove the element.",
    .sources = "urdf-loader 0.13 and urdfdom 3.0.1, executed."};

constinit const Rule sml1003_xml_bare_ampersand{
    .id = "SML1003",
    .name = "xml-bare-ampersand",
    .severity = Severity::error,
    .summary = "An `&` begins no character reference.",
    .why = "urdfdom, sdformat, MuJoCo and Bullet accept it; browsers (urdf-loader) and lxml refuse "
           "the file.",
    .remedy = "Write `&amp;`.",
    .sources = "urdf-loader 0.13 and urdfdom 3.0.1, executed."};

constinit const Rule sml1004_xml_comment_dashes{
    .id = "SML1004",
    .name = "xml-comment-dashes",
    .severity = Severity::error,
    .summary = "A comment holds `--`.",
    .why = "XML forbids it: browsers (urdf-loader) and lxml refuse the file, urdfdom and tinyxml2 "
           "read on.",
    .remedy = "Write `- -` or another dash.",
    .sources = "urdf-loader 0.13 and urdfdom 3.0.1, executed; XML 1.0 section 2.5."};

constinit const Rule sml1005_xml_junk_before_prolog{
    .id = "SML1005",
    .name = "xml-junk-before-prolog",
    .severity = Severity::error,
    .summary = "Something stands before the XML declaration.",
    .why = "The declaration must be the first bytes of the file: browsers (urdf-loader), expat and "
           "yourdfpy refuse it otherwise.",
    .remedy = "Delete what stands before `<?xml`.",
    .sources = "urdf-loader 0.13, executed; XML 1.0 section 2.8."};

constinit const Rule sml1006_xml_several_roots{
    .id = "SML1006",
    .name = "xml-several-roots",
    .severity = Severity::error,
    .summary = "A file holds a second root element.",
    .why = "urdfdom 3 silently takes the first, every other reader refuses the file.",
    .remedy = "Keep one robot a file.",
    .sources = "urdfdom 3.0.1, MuJoCo 3.14 and urdf-loader 0.13, executed."};

constinit const Rule sml1007_xml_duplicate_attribute{
    .id = "SML1007",
    .name = "xml-duplicate-attribute",
    .severity = Severity::error,
    .summary = "An element has the same attribute twice.",
    .why = "Every reader refuses the file; urdfdom says only \"Error parsing Element.\".",
    .remedy = "Delete one of the two.",
    .sources = "urdfdom 3.0.1, sdformat 12.3, MuJoCo 3.14, executed."};

constinit const Rule sml1008_xml_encoding{
    .id = "SML1008",
    .name = "xml-encoding",
    .severity = Severity::error,
    .summary = "The XML declaration names another encoding than that of the file.",
    .why =
        "expat, lxml and browsers (urdf-loader) refuse UTF-8 that calls itself UTF-16. Text that "
        "calls itself ISO-8859-1 is decoded so by urdfdom and left alone by tinyxml2 (sdformat, "
        "MuJoCo, Bullet): names beyond ASCII differ from reader to reader.",
    .remedy = "Declare UTF-8, or leave the encoding out.",
    .sources = "urdfdom 3.0.1, MuJoCo 3.14 and urdf-loader 0.13, executed; XML 1.0 section 4.3.3."};

constinit const Rule sml1010_lfs_pointer{
    .id = "SML1010",
    .name = "lfs-pointer",
    .severity = Severity::error,
    .summary = "A file is empty, or a Git LFS pointer instead of its content.",
    .why = "Readers say \"document empty\" and nothing of the cause.",
    .remedy = "Run `git lfs pull`, or restore the file.",
    .sources = "urdfdom 3.0.1, executed: 31 of 941 public files were such."};

constinit const Rule sml1013_dtd_or_xinclude{
    .id = "SML1013",
    .name = "dtd-or-xinclude",
    .severity = Severity::warning,
    .summary = "A URDF uses a document type with declarations, an own entity or XInclude.",
    .why =
        "TinyXML and tinyxml2 do not expand them, lxml may: the same file is two robots. Declarations in "
        "the document type are worse: urdfdom 3.0.1 (TinyXML) then finds no robot at all.",
    .remedy = "Write the text out.",
    .sources =
        "urdfdom 3.0.1 and tinyxml2 9.0, executed (tinyxml2 issue 1082: unknown entities corrupt the "
        "text)."};

}  // namespace smurf::rules
