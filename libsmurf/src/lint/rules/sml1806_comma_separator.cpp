// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/cases.hpp"
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml1806_comma_separator_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::pybullet, Effect::changes, "reads the leading digits",
     "Bullet UrdfParser.cpp (atof), run", when(cases::kEnoughWords)},
    {&readers::pybullet, Effect::refuses, "refuses an axis that is not a vector", kRun, at("axis")},
    {&readers::pybullet, Effect::changes, "reads a vector of zeros and warns",
     "Bullet UrdfParser.cpp:49-78, run"},
};

}  // namespace

extern constinit const Rule sml1806_comma_separator{
    .id = "SML1806",
    .name = "comma-separator",
    .severity = Severity::error,
    .summary = "Commas separate the numbers of a vector.",
    .why = "yourdfpy accepts commas in some attributes.",
    .remedy = "Separate the numbers by single spaces.",
    .facts = kFacts};

}  // namespace smurf::rules::sml1806_comma_separator_file
