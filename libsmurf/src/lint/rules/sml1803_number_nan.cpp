// SPDX-License-Identifier: BSD-3-Clause
#include "base/readers.hpp"
#include "base/rules.hpp"

namespace smurf::rules::sml1803_number_nan_file {
namespace {

constexpr std::string_view kCarried = "#carried";  // see locate()

constexpr Fact kFacts[] = {
    {&readers::pybullet, Effect::changes, "computes with it until nothing has a position",
     "Bullet UrdfParser.cpp (atof), run"},
    {&readers::drake, Effect::refuses, "refuses the number", "Drake detail_tinyxml.h:60-73"},
    {&readers::mujoco, Effect::refuses, "refuses more numbers than it expects", kRun, "#too-many"},
    {&readers::mujoco, Effect::refuses, "refuses fewer numbers than it expects", kRun, "#too-few"},
    {&readers::mujoco, Effect::refuses, "cannot read such a word as a scale", kRun, "#long-word"},
    {&readers::mujoco, Effect::changes, "computes with it where the body does not move by itself",
     kRun, kCarried},
    {&readers::mujoco, Effect::refuses, "refuses a moving body of such an inertia", kRun,
     "/inertial/origin/@rpy/"},
    {&readers::mujoco, Effect::refuses, "refuses a moving body of such a mass", kRun, "/mass/"},
    {&readers::mujoco, Effect::refuses, "refuses a moving body without inertia", kRun,
     "#alone/inertia/"},
    {&readers::mujoco, Effect::refuses, "refuses the size", kRun, "/sphere/"},
    {&readers::mujoco, Effect::refuses, "refuses the size", kRun, "/cylinder/"},
    {&readers::mujoco, Effect::refuses, "refuses the size", kRun, "/box/"},
    {&readers::mujoco, Effect::changes, "reads it, and computes with it", kRun},
    {&readers::phobos, Effect::takes, "keeps the number", kRun},
};

constexpr std::string_view kFormer[] = {"nan"};

}  // namespace

extern constinit const Rule sml1803_number_nan{
    .id = "SML1803",
    .name = "number-nan",
    .severity = Severity::error,
    .summary = "A number is `nan`.",
    .why = "urdf-loader computes with it until nothing in the simulation has a position.",
    .remedy = "Write the number that was meant; look at the exporter that wrote it.",
    .sources = "urdf-loader 0.13, executed.",
    .facts = kFacts,
    .former = kFormer};

}  // namespace smurf::rules::sml1803_number_nan_file
