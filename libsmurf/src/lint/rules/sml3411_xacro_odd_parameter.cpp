// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml3411_xacro_odd_parameter_file {

extern constinit const Rule sml3411_xacro_odd_parameter{
    .id = "SML3411",
    .name = "xacro-odd-parameter",
    .severity = Severity::warning,
    .summary = "A macro has a parameter that no call can set, or a default that is not "
               "what it seems.",
    .why = "`xyz:=0 0 0` declares two parameters called `0`, `a, b` one called `a,`, "
           "`a:=` has no default, and the quotes of `a:=\"b\"` are a part of the "
           "value.",
    .remedy = "Write `xyz:='0 0 0'`, `a b`, `a:=''` and `a:='b'`.",
    .sources = "xacro 2.1.1, run."};

}  // namespace smurf::rules::sml3411_xacro_odd_parameter_file
