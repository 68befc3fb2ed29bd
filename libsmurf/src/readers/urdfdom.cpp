// SPDX-License-Identifier: BSD-3-Clause
// urdfdom: the URDF parser of ROS, Gazebo, DART and both versions of MARS.
#include <algorithm>
#include <string_view>

#include "base/findings/file_cases.hpp"
#include "base/findings/rules.hpp"
#include "readers/circumstances.hpp"

namespace smurf::readers::urdfdom_file {
namespace {

using enum Effect;

constexpr FamilyFact kFamilies[] = {
    {"SML18",
     {&urdfdom, refuses, "refuses the number, and with it the file", "urdfdom utils.h:73-88, run",
      at("joint")}},
    {"SML18", urdfdom_drops_shapes(at("link"))},
    {"SML18",
     {&urdfdom, loses, "drops the material with a message", "urdfdom link.cpp:86-94, run",
      at("material")}},
};

constexpr Fact kUnread[] = {
    {&urdfdom, ignores, "does not read the axis of such a joint", kRun,
     at("joint/axis").when(kInFixed)},
    {&urdfdom, ignores, "does not read the axis of such a joint", kRun,
     at("joint/axis").when(kInFloating)},
};

/// How many bytes TinyXML takes for the character that begins with `byte`.
std::size_t size_for_tinyxml(char byte) {
  const auto value = static_cast<unsigned char>(byte);
  if (value < 0xC2 || value > 0xF4) return 1;
  return value < 0xE0 ? 2 : value < 0xF0 ? 3 : 4;
}

/// Whether TinyXML takes what ends a text for a part of its last character.
bool loses_end(std::string_view text) {
  std::size_t at = 0;
  while (at < text.size()) at += size_for_tinyxml(text[at]);
  return at > text.size();
}

/// TinyXML takes a text for UTF-8 only if a byte order mark or a declaration says so.
bool loses_quote(const xml::Document& document) {
  const xml::Element& root = document.elements.front();
  // The names of elements point into the text of the file.
  const std::string_view text(root.name_begin - root.name_span().begin, root.span.end);
  if (!text.starts_with("\xEF\xBB\xBF") && !text.starts_with("<?xml")) return false;
  return std::any_of(document.attributes.begin(), document.attributes.end(),
                     [](const xml::Attribute& one) { return loses_end(one.value()); }) ||
         std::any_of(document.texts.begin(), document.texts.end(), [&](const xml::Text& one) {
           return loses_end(
               text.substr(one.span.begin, text.find('<', one.span.end) - one.span.begin));
         });
}

void see(const LinkedModel& model, std::span<Diagnostic* const> found) {
  for (Diagnostic* finding : found) {
    if (finding->rule == &rules::sml0003_invalid_utf8 &&
        !finding->cases.contains(cases::kOtherEncoding) && loses_quote(model.robot->document)) {
      finding->when(cases::kLosesQuote);
    }
  }
}

}  // namespace

extern constinit const Reader urdfdom{.name = "urdfdom",
                                      .title = "urdfdom",
                                      .basis = "3.0.1 (Debian 12), 4.0.1 and 6.0.0, executed",
                                      .like = &urdf,
                                      .version = "urdfdom 3.0.1",
                                      .families = kFamilies,
                                      .is_target = false,
                                      .unread = kUnread,
                                      .number = {3, 0, 1},
                                      .see = see};

}  // namespace smurf::readers::urdfdom_file
