// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/cases.hpp"
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"
#include "readers/circumstances.hpp"

namespace smurf::rules::sml1114_tag_case_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::drake, Effect::loses, "ignores the joint, and lets its child float", kRun,
     when(cases::kJointTag)},
    {&readers::drake, Effect::refuses, "misses the material that visuals name", kRun,
     when(cases::kSharedMaterialTag)},
    {&readers::drake, Effect::refuses, "misses the link of the joint", kRun, at("joint/parent")},
    {&readers::drake, Effect::refuses, "misses the link of the joint", kRun, at("joint/child")},
    {&readers::urdf, Effect::refuses,
     "ignores the element, and then misses the link that joints name", "urdfdom, MuJoCo, run",
     when(cases::kLinkTag)},
    {&readers::urdf, Effect::refuses, "ignores the joint, and then finds several roots",
     "urdfdom, run", when(cases::kJointTag)},
    {&readers::urdf, Effect::loses, "ignores the element, with all its contents",
     "urdfdom, MuJoCo, run"},
    {&readers::mujoco, Effect::refuses,
     "ignores the element, and refuses a moving body without mass or collision", kRun,
     when(kMasslessBody)},
    {&readers::mujoco, Effect::changes, "ignores the joint, and welds its child to the world", kRun,
     when(cases::kJointTag)},
};

}  // namespace

extern constinit const Rule sml1114_tag_case{
    .id = "SML1114",
    .name = "tag-case",
    .severity = Severity::error,
    .summary = "An element name differs from a URDF element only in case.",
    .why = "Names are case-sensitive in every reader but urdf-loader.",
    .remedy = "Write it in lower case.",
    .sources = "urdf-loader 0.13, executed.",
    .facts = kFacts};

}  // namespace smurf::rules::sml1114_tag_case_file
