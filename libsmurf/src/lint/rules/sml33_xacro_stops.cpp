// SPDX-License-Identifier: BSD-3-Clause
// Faults that stop xacro. A rule whose fault the expansion reports has texts only.
#include "base/findings/rules.hpp"

namespace smurf::rules {

extern constinit const Rule sml3301_xacro_unknown_name{
    .id = "SML3301",
    .name = "xacro-unknown-name",
    .severity = Severity::error,
    .summary = "An expression names a property or function that does not exist.",
    .why = "xacro stops, so there is no robot.",
    .remedy = "Define the property before it is used, or correct the name.",
    .sources = "xacro 2.1.1, run.",
    .blocks_building = true};

extern constinit const Rule sml3302_xacro_syntax{
    .id = "SML3302",
    .name = "xacro-syntax",
    .severity = Severity::error,
    .summary = "The text between `${` and `}` is not an expression.",
    .why = "xacro stops, so there is no robot.",
    .remedy = "Correct the expression at the marked place.",
    .sources = "xacro 2.1.1, run.",
    .blocks_building = true};

extern constinit const Rule sml3303_xacro_computation{
    .id = "SML3303",
    .name = "xacro-computation",
    .severity = Severity::error,
    .summary = "An expression cannot be computed: wrong kinds of values, a division by "
               "zero, an absent key.",
    .why = "xacro stops, so there is no robot.",
    .remedy = "Correct the expression or the values that it uses.",
    .sources = "xacro 2.1.1, run.",
    .blocks_building = true};

extern constinit const Rule sml3304_xacro_unsupported{
    .id = "SML3304",
    .name = "xacro-unsupported",
    .severity = Severity::error,
    .summary = "An expression uses a part of Python that is not supported.",
    .why = "Expressions are computed without Python. Unknown parts are reported, "
           "never guessed.",
    .remedy = "Write the expression with the supported parts of the language.",
    .sources = "xacro 2.1.1, run.",
    .blocks_building = true,
    .may_pass_elsewhere = true};

extern constinit const Rule sml3305_xacro_unknown_macro{
    .id = "SML3305",
    .name = "xacro-unknown-macro",
    .severity = Severity::error,
    .summary = "An element calls a macro that does not exist.",
    .why = "xacro stops, so there is no robot.",
    .remedy = "Include the file that defines the macro before the call, or correct the "
              "name.",
    .sources = "xacro 2.1.1, run.",
    .blocks_building = true};

extern constinit const Rule sml3306_xacro_missing_parameter{
    .id = "SML3306",
    .name = "xacro-missing-parameter",
    .severity = Severity::error,
    .summary = "A call of a macro lacks a parameter that has no default.",
    .why = "xacro stops, so there is no robot.",
    .remedy = "Add the parameter to the call, or give it a default in `params`.",
    .sources = "xacro 2.1.1, run.",
    .blocks_building = true};

extern constinit const Rule sml3307_xacro_surplus_parameter{
    .id = "SML3307",
    .name = "xacro-surplus-parameter",
    .severity = Severity::error,
    .summary = "A call of a macro has a parameter that the macro does not have.",
    .why = "xacro stops, so there is no robot.",
    .remedy = "Delete the attribute, or correct its name.",
    .sources = "xacro 2.1.1, run.",
    .blocks_building = true};

extern constinit const Rule sml3308_xacro_block{
    .id = "SML3308",
    .name = "xacro-block",
    .severity = Severity::error,
    .summary = "A block is missing, is left over, or is not defined.",
    .why = "xacro stops, so there is no robot.",
    .remedy = "Give the call one child element for each block parameter, in their "
              "order.",
    .sources = "xacro 2.1.1, run.",
    .blocks_building = true};

extern constinit const Rule sml3309_xacro_unknown_package{
    .id = "SML3309",
    .name = "xacro-unknown-package",
    .severity = Severity::error,
    .summary = "`$(find ...)` names a package that is not found.",
    .why = "xacro stops, so there is no robot.",
    .remedy = "Name its folder with `--package NAME=DIR`, or set ROS_PACKAGE_PATH.",
    .sources = "xacro 2.1.1, run.",
    .blocks_building = true,
    .may_pass_elsewhere = true};

extern constinit const Rule sml3310_xacro_missing_file{
    .id = "SML3310",
    .name = "xacro-missing-file",
    .severity = Severity::error,
    .summary = "An included file or a YAML file cannot be read.",
    .why = "xacro stops, so there is no robot.",
    .remedy = "Correct the path. Relative paths belong to the file that is being "
              "processed.",
    .sources = "xacro 2.1.1, run.",
    .blocks_building = true,
    .may_pass_elsewhere = true};

extern constinit const Rule sml3311_xacro_cyclic_include{
    .id = "SML3311",
    .name = "xacro-cyclic-include",
    .severity = Severity::error,
    .summary = "A file includes itself, directly or through other files.",
    .why = "xacro never terminates on it, or stops at the depth of Python's stack.",
    .remedy = "Delete the include, or make it depend on a condition.",
    .sources = "xacro 2.1.1, run.",
    .blocks_building = true};

extern constinit const Rule sml3312_xacro_limit{.id = "SML3312",
                                                .name = "xacro-limit",
                                                .severity = Severity::error,
                                                .summary = "The expansion exceeds a limit.",
                                                .why = "A few lines can expand to gigabytes.",
                                                .remedy =
                                                    "Write a smaller robot, or raise the limit.",
                                                .sources = "xacro 2.1.1, run.",
                                                .blocks_building = true,
                                                .may_pass_elsewhere = true};

extern constinit const Rule sml3313_xacro_unknown_argument{
    .id = "SML3313",
    .name = "xacro-unknown-argument",
    .severity = Severity::error,
    .summary = "`$(arg ...)` names an argument that has no value.",
    .why = "xacro stops, so there is no robot.",
    .remedy = "Define it with `<xacro:arg>` before it is used, or give it a value: "
              "`name:=value`.",
    .sources = "xacro 2.1.1, run.",
    .blocks_building = true,
    .may_pass_elsewhere = true};

extern constinit const Rule sml3314_xacro_condition{
    .id = "SML3314",
    .name = "xacro-condition",
    .severity = Severity::error,
    .summary = "The condition of `xacro:if` or `xacro:unless` is not a truth value.",
    .why = "xacro stops, so there is no robot. Texts must be `true`, `false` or an "
           "integer; `1.0`, `yes` and an empty text are errors.",
    .remedy = "Write a condition that is `true`, `false` or a comparison.",
    .sources = "xacro 2.1.1, run.",
    .blocks_building = true};

extern constinit const Rule sml3315_xacro_wrong_element{
    .id = "SML3315",
    .name = "xacro-wrong-element",
    .severity = Severity::error,
    .summary = "An element of xacro lacks an attribute, or its attributes contradict "
               "each other.",
    .why = "xacro stops, so there is no robot.",
    .remedy = "Correct the attributes.",
    .sources = "xacro 2.1.1, run.",
    .blocks_building = true};

extern constinit const Rule sml3316_xacro_cycle{
    .id = "SML3316",
    .name = "xacro-cycle",
    .severity = Severity::error,
    .summary = "Properties are defined by each other.",
    .why = "xacro stops, so there is no robot.",
    .remedy = "Compute one of them at its definition, with `lazy_eval=\"false\"`.",
    .sources = "xacro 2.1.1, run.",
    .blocks_building = true};

extern constinit const Rule sml3317_xacro_environment{
    .id = "SML3317",
    .name = "xacro-environment",
    .severity = Severity::error,
    .summary = "`$(env ...)` names a variable of the environment that may not be read, "
               "or is not set.",
    .why = "A robot description of a stranger could print secrets of the environment "
           "into a report.",
    .remedy = "Allow it with `--xacro-env NAME`, or use an argument.",
    .sources = "xacro 2.1.1, run.",
    .blocks_building = true,
    .may_pass_elsewhere = true};

extern constinit const Rule sml3318_xacro_fatal{
    .id = "SML3318",
    .name = "xacro-fatal",
    .severity = Severity::error,
    .summary = "The description stops the expansion with `xacro.fatal()`.",
    .why = "xacro stops, so there is no robot.",
    .remedy = "Change the call or the arguments with which the author of the description stops.",
    .sources = "xacro 2.1.1, run.",
    .blocks_building = true};

extern constinit const Rule sml3319_xacro_undeclared_prefix{
    .id = "SML3319",
    .name = "xacro-undeclared-prefix",
    .severity = Severity::error,
    .summary = "The prefix `xacro` is used, but not declared.",
    .why = "xacro refuses the file.",
    .remedy = "Add `xmlns:xacro=\"http://www.ros.org/wiki/xacro\"` to the root element.",
    .sources = "xacro 2.1.1, run.",
    .blocks_building = true};

}  // namespace smurf::rules
