// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/cases.hpp"
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml1805_decimal_comma_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::pybullet, Effect::changes, "reads the digits before the comma",
     "Bullet UrdfParser.cpp (atof), run"},
    {&readers::drake, Effect::crashes, "reads 0, and ends the process at a cylinder of that size",
     kRun, at("cylinder")},
};

}  // namespace

extern constinit const Rule sml1805_decimal_comma{.id = "SML1805",
                                                  .name = "decimal-comma",
                                                  .severity = Severity::error,
                                                  .summary =
                                                      "A number is written with a decimal comma.",
                                                  .why = "urdf-loader silently reads `1,5` as 1.",
                                                  .remedy = "Write a point.",
                                                  .sources = "urdf-loader 0.13, executed.",
                                                  .facts = kFacts};

}  // namespace smurf::rules::sml1805_decimal_comma_file
