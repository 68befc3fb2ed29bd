// SPDX-License-Identifier: BSD-3-Clause
// What xacro accepts, and authors rarely mean. The expansion reports it.
#include "base/findings/rules.hpp"

namespace smurf::rules {

extern constinit const Rule sml3401_xacro_hides_function{
    .id = "SML3401",
    .name = "xacro-hides-function",
    .severity = Severity::warning,
    .summary = "A property or parameter hides a function or a constant of expressions.",
    .why = "All later expressions see the property: `pi`, `e` and `range` are no "
           "longer what they were.",
    .remedy = "Give the property another name.",
    .sources = "xacro 2.1.1, run."};

extern constinit const Rule sml3402_xacro_unknown_attribute{
    .id = "SML3402",
    .name = "xacro-unknown-attribute",
    .severity = Severity::warning,
    .summary = "An element of xacro has an attribute that xacro ignores.",
    .why = "A misspelt `value` makes an empty block instead of a property.",
    .remedy = "Correct the name of the attribute, or delete it.",
    .sources = "xacro 2.1.1, run."};

extern constinit const Rule sml3403_xacro_lost_attribute{
    .id = "SML3403",
    .name = "xacro-lost-attribute",
    .severity = Severity::error,
    .summary = "`xacro:attribute` sets an attribute of an element that is not in the "
               "result.",
    .why = "Inside of `xacro:if`, a macro or an included file, the attribute is lost "
           "without a message.",
    .remedy = "Put `xacro:attribute` directly into the element that gets the attribute.",
    .sources = "xacro 2.1.1, run."};

extern constinit const Rule sml3404_xacro_no_match{
    .id = "SML3404",
    .name = "xacro-no-match",
    .severity = Severity::warning,
    .summary = "An include with `*`, `?` or `[` matches no file.",
    .why = "Nothing is included.",
    .remedy = "Correct the pattern.",
    .sources = "xacro 2.1.1, run."};

extern constinit const Rule sml3405_xacro_message{
    .id = "SML3405",
    .name = "xacro-message",
    .severity = Severity::warning,
    .summary = "The description reports a warning or an error with `xacro.warning()` or "
               "`xacro.error()`.",
    .why = "The author of the description wants to tell something.",
    .remedy = "Change the call or the arguments that the author of the description warns of.",
    .sources = "xacro 2.1.1, run."};

extern constinit const Rule sml3406_xacro_truth_as_text{
    .id = "SML3406",
    .name = "xacro-truth-as-text",
    .severity = Severity::warning,
    .summary = "A truth value is compared with a text such as 'true', which is never "
               "equal.",
    .why = "A property or argument with the value `true` is a truth value, so `a == "
           "'true'` is false whatever its value is.",
    .remedy = "Write `a` or `a == True` instead of `a == 'true'`, and `not a` instead of "
              "`a == 'false'`.",
    .sources = "xacro 2.1.1, run; ros/xacro issue 145."};

extern constinit const Rule sml3407_xacro_stripped_characters{
    .id = "SML3407",
    .name = "xacro-stripped-characters",
    .severity = Severity::warning,
    .summary = "`strip()`, `lstrip()` or `rstrip()` is called with a word, and removes its "
               "characters.",
    .why = "`'tool_link'.rstrip('_link')` is `'too'`: characters are removed from the "
           "end as long as they occur in the word, in any order.",
    .remedy = "Write `removesuffix()` or `removeprefix()`.",
    .sources = "xacro 2.1.1, run."};

extern constinit const Rule sml3408_xacro_missing_dollar{
    .id = "SML3408",
    .name = "xacro-missing-dollar",
    .severity = Severity::warning,
    .summary = "Braces around a known name have no `$` before them.",
    .why = "Without the `$`, `{...}` is a text like any other, and reaches the reader "
           "of the robot.",
    .remedy = "Write `${...}`.",
    .sources = "xacro 2.1.1, run."};

extern constinit const Rule sml3409_xacro_wrong_inertia{
    .id = "SML3409",
    .name = "xacro-wrong-inertia",
    .severity = Severity::warning,
    .summary = "The formulas of an inertia are nearly those of a box, a cylinder or a "
               "sphere.",
    .why = "A formula that was copied wrongly makes every link of the macro rotate "
           "wrongly, without a message.",
    .remedy = "Correct the formula. With mass m, a box has m/12 (y² + z²), m/12 "
              "(x² + z²) and m/12 (x² + y²); a cylinder along z m/12 "
              "(3 r² + h²) twice and m/2 r²; a sphere 2/5 m r².",
    .sources = "Formulas of solid bodies."};

extern constinit const Rule sml3410_xacro_no_branch{
    .id = "SML3410",
    .name = "xacro-no-branch",
    .severity = Severity::warning,
    .summary = "An element has a branch for each of several values, and none for the "
               "actual one.",
    .why = "No condition holds, so the element is empty.",
    .remedy = "Correct the value, or add `<xacro:unless>` for all other values.",
    .sources = "xacro 2.1.1, run."};

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

extern constinit const Rule sml3412_xacro_call_without_prefix{
    .id = "SML3412",
    .name = "xacro-call-without-prefix",
    .severity = Severity::warning,
    .summary = "An element has the name and the parameters of a macro, and no prefix.",
    .why = "Old versions of xacro called the macro; today, the element is copied, and "
           "readers of the robot ignore it.",
    .remedy = "Write `<xacro:NAME .../>`.",
    .sources = "xacro 2.1.1, run; xacro 1.11 accepted it."};

extern constinit const Rule sml3413_xacro_unused_name{
    .id = "SML3413",
    .name = "xacro-unused-name",
    .severity = Severity::info,
    .summary = "The file of a robot defines a macro, parameter, property or argument that nothing "
               "uses.",
    .why = "A name that is not used may be misspelt where it should be used. Names in files that "
           "other files include are not reported, because other robots may use them.",
    .remedy = "Delete the name, or use it.",
    .sources = "xacro 2.1.1, run."};

}  // namespace smurf::rules
