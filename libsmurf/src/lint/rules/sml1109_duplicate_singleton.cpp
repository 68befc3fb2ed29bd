// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml1109_duplicate_singleton_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::phobos, Effect::changes, "uses one of them", kRun, at("joint/axis")},
    {&readers::phobos, Effect::changes, "uses one of them", kRun, at("joint/parent")},
    {&readers::phobos, Effect::changes, "uses one of them", kRun, at("joint/child")},
    {&readers::phobos, Effect::changes, "uses one of them", kRun, at("joint/mimic")},
    {&readers::phobos, Effect::changes, "uses one of them", kRun, at("inertial/mass")},
    {&readers::phobos, Effect::refuses, "stops with an assertion", kRun},
    {&readers::urdf, Effect::changes, "uses the first one", "urdfdom, Bullet, run"},
    {&readers::mujoco, Effect::refuses, "refuses a repeated element", kRun},
};

}  // namespace

extern constinit const Rule sml1109_duplicate_singleton{
    .id = "SML1109",
    .name = "duplicate-singleton",
    .severity = Severity::error,
    .summary = "An element that may occur only once is repeated.",
    .why = "urdf-loader uses the last origin.",
    .remedy = "Keep one of them.",
    .sources = "urdf-loader 0.13, executed.",
    .facts = kFacts};

}  // namespace smurf::rules::sml1109_duplicate_singleton_file
