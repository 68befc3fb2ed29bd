// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/cases.hpp"
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml1101_root_not_robot_file {
namespace {

constexpr std::string_view kRefuses = "refuses a root other than `robot`";
constexpr std::string_view kEvidence = "urdfdom model.cpp:106, run";

constexpr Fact kFacts[] = {
    {&readers::urdf, Effect::refuses, kRefuses, kEvidence, when(cases::kForeign)},
    {&readers::urdfdom, Effect::refuses, kRefuses, kEvidence, when(cases::kMjcf)},
    {&readers::ros, Effect::refuses, kRefuses, kEvidence, when(cases::kSdf)},
    {&readers::dart, Effect::refuses, kRefuses, kEvidence, when(cases::kSdf)},
    {&readers::mujoco, Effect::refuses, kRefuses, kRun, when(cases::kSdf)},
    {&readers::mujoco, Effect::takes, "compares the name without case", "MuJoCo xml.cc:293, run",
     when(cases::kCased)},
};

}  // namespace

extern constinit const Rule sml1101_root_not_robot{
    .id = "SML1101",
    .name = "root-not-robot",
    .severity = Severity::error,
    .summary = "The root element of a URDF is not `robot`.",
    .why = "Names of elements are case-sensitive.",
    .remedy = "Name the root element `robot`, or check whether this is the right file.",
    .facts = kFacts};

}  // namespace smurf::rules::sml1101_root_not_robot_file
