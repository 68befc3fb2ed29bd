// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/cases.hpp"
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"
#include "readers/circumstances.hpp"

namespace smurf::rules::sml1809_hex_or_suffix_file {
namespace {

constexpr std::string_view kNotPositive =
    "reads a hexadecimal number, and refuses a size that is not positive";

constexpr Fact kFacts[] = {
    {&readers::pybullet, Effect::changes, "reads a hexadecimal number",
     "Bullet UrdfParser.cpp (atof), run", when(cases::kHex)},
    {&readers::pybullet, Effect::changes, "reads the leading digits",
     "Bullet UrdfParser.cpp (atof), run"},
    {&readers::mujoco, Effect::refuses, "refuses more numbers than it expects", kRun,
     when(cases::kTooMany)},
    {&readers::mujoco, Effect::refuses, "refuses fewer numbers than it expects", kRun,
     when(cases::kTooFew)},
    {&readers::mujoco, Effect::refuses, "refuses a moving body without mass", kRun,
     at("mass/@value").when(cases::kHex, cases::kZeroOrLess, kAlone)},
    {&readers::mujoco, Effect::refuses, kNotPositive, kRun,
     at("@size").when(cases::kHex, cases::kZeroOrLess)},
    {&readers::mujoco, Effect::refuses, kNotPositive, kRun,
     at("@radius").when(cases::kHex, cases::kZeroOrLess)},
    {&readers::mujoco, Effect::refuses, kNotPositive, kRun,
     at("@length").when(cases::kHex, cases::kZeroOrLess)},
    {&readers::mujoco, Effect::refuses, "refuses the number", kRun,
     when(cases::kHex, cases::kBroken)},
    {&readers::mujoco, Effect::changes, "reads a hexadecimal number", kRun, when(cases::kHex)},
    {&readers::drake, Effect::crashes, "reads 0, and ends the process at a cylinder of that size",
     kRun, at("cylinder").when(cases::kHex)},
};

}  // namespace

extern constinit const Rule sml1809_hex_or_suffix{
    .id = "SML1809",
    .name = "hex-or-suffix",
    .severity = Severity::error,
    .summary = "A number is hexadecimal or carries a unit or suffix.",
    .why = "urdf-loader reads `0x10` as 0.",
    .remedy = "Write a plain decimal number in SI units.",
    .sources = "urdf-loader 0.13, executed.",
    .facts = kFacts};

}  // namespace smurf::rules::sml1809_hex_or_suffix_file
