// SPDX-License-Identifier: BSD-3-Clause
#include "base/readers.hpp"
#include "base/rules.hpp"

namespace smurf::rules {
namespace {

constexpr Fact kFacts[] = {
    {&readers::urdfdom, Effect::changes, "reads a colour of three numbers as black",
     "urdfdom color.h:88, run", "/@rgba/"},
    {&readers::pybullet, Effect::refuses, "refuses an axis that is no vector",
     "Bullet UrdfParser.cpp, run", "/axis/"},
    {&readers::pybullet, Effect::changes, "cuts the vector, or reads zeros and warns",
     "Bullet UrdfParser.cpp:49-78, run"},
};

}  // namespace

extern constinit const Rule sml1807_vector_count{
    .id = "SML1807",
    .name = "vector-count",
    .severity = Severity::error,
    .summary = "An attribute contains the wrong number of numbers.",
    .remedy = "Write as many numbers as the attribute takes.",
    .facts = kFacts};

}  // namespace smurf::rules
