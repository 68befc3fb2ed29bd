// SPDX-License-Identifier: BSD-3-Clause
#include "base/readers.hpp"
#include "base/rules.hpp"

namespace smurf::rules {
namespace {

constexpr Fact kFacts[] = {
    {&readers::pybullet, Effect::changes, "reads a vector of zeros and warns",
     "Bullet UrdfParser.cpp:49-78, run"},
    {&readers::mujoco, Effect::takes, "skips all white space", kRun},
    {&readers::drake, Effect::takes, "skips all white space", "Drake detail_tinyxml.h:60-73"},
    {&readers::urdfdom, Effect::takes, "skips leading white space", kRun, "#leading"},
};

}  // namespace

extern constinit const Rule sml1808_vector_tab_newline{
    .id = "SML1808",
    .name = "vector-tab-newline",
    .severity = Severity::error,
    .summary = "A tab or a line break separates the numbers of a vector.",
    .remedy = "Separate the numbers by single spaces.",
    .facts = kFacts};

}  // namespace smurf::rules
