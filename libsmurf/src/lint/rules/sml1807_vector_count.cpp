// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/cases.hpp"
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml1807_vector_count_file {
namespace {

constexpr Fact kFacts[] = {
    urdfdom_drops_shapes(at("@scale")),
    {&readers::urdfdom, Effect::changes, "reads a colour of three numbers as black",
     "urdfdom color.h:88, run", at("@rgba")},
    {&readers::phobos, Effect::refuses, "stops with an exception", "Phobos a613e31, run",
     at("@scale")},
    {&readers::pybullet, Effect::changes, "uses one number for all axes", kRun, at("@scale")},
    {&readers::pybullet, Effect::takes, "ignores the fourth number", kRun,
     at("axis").when(cases::kTooMany)},
    {&readers::pybullet, Effect::refuses, "refuses an axis that is not a vector",
     "Bullet UrdfParser.cpp, run", at("axis")},
    {&readers::pybullet, Effect::changes, "cuts the vector, or reads zeros and warns",
     "Bullet UrdfParser.cpp:49-78, run"},
    {&readers::drake, Effect::changes, "uses one number for all axes", kRun,
     at("@scale").when(cases::kEnoughRead)},
    {&readers::drake, Effect::refuses, "refuses the file", kRun},
};

}  // namespace

extern constinit const Rule sml1807_vector_count{
    .id = "SML1807",
    .name = "vector-count",
    .severity = Severity::error,
    .summary = "An attribute has too few or too many values.",
    .why = "When `scale` has only one number, urdf-loader ignores it, and yourdfpy uses it for all "
           "axes.",
    .remedy = "Write as many numbers as the attribute needs: one factor for each axis in a "
              "scale; red, green, blue and alpha, each from 0 to 1, in a colour.",
    .sources = "urdf-loader 0.13, executed.",
    .facts = kFacts};

}  // namespace smurf::rules::sml1807_vector_count_file
