// SPDX-License-Identifier: BSD-3-Clause
#include <string_view>

#include "base/findings/readers.hpp"
#include "base/ranges.hpp"
#include "base/text/words.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1123_xacro_without_prefix_file {
namespace {

/// Elements of xacro, and an attribute that only they have.
constexpr struct {
  std::string_view name, attribute;
} kElements[] = {{"include", "filename"}, {"if", "value"},    {"unless", "value"},
                 {"macro", "params"},     {"arg", "default"}, {"property", "value"}};

bool is_of_xacro(xml::View element) {
  return ranges::any_of(kElements, [&](const auto& one) {
    return is_same(element.name(), one.name) && element.attribute(one.attribute) != nullptr;
  });
}

// The recursion is as deep as the file, whose depth is limited.
void search(xml::View element, Findings& findings) {
  for (const xml::View child : element) {
    const std::string_view name = child.name();
    if (is_of_xacro(child)) {
      findings
          .report_habit(child.name_span(),
                        quoted(name) +
                            " is an element of xacro only as `xacro:" + std::string(name) + "`",
                        "such elements")
          .help("write the prefix `xacro:` in front; xacro copies other elements unchanged");
      continue;
    }
    const bool is_foreign = is_one_of(name, {"gazebo", "ros2_control", "transmission"}) ||
                            name.find(':') != std::string_view::npos;
    if (!is_foreign) search(child, findings);
  }
}

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  search(xml::View(model.robot->document, model.robot->document.root), findings);
}

constexpr Fact kFacts[] = {
    {&readers::urdf, Effect::loses, "ignores the element, with what it stands for",
     "xacro 2.1.1 copies it; urdfdom, run"},
};

}  // namespace

extern constinit const Rule sml1123_xacro_without_prefix{
    .id = "SML1123",
    .name = "xacro-without-prefix",
    .severity = Severity::warning,
    .summary = "An element of xacro has no prefix, and is not expanded.",
    .why = "Before ROS Jade, xacro expanded such elements. Now it copies them into the URDF, where "
           "all readers ignore them, and the robot lacks its parts.",
    .remedy = "Write `xacro:include`, `xacro:if`, `xacro:macro`.",
    .sources = "xacro 2.1.1, run.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1123_xacro_without_prefix_file
