// SPDX-License-Identifier: BSD-3-Clause
// What the YAML reader reports.
#include "base/rules.hpp"

namespace smurf::rules {

constinit const Rule sml0010_yaml_syntax{
    .id = "SML0010",
    .name = "yaml-syntax",
    .severity = Severity::error,
    .summary = "A file is not well-formed YAML.",
    .why = "No reader gets anything out of the file: MARS ends with an uncaught exception, Phobos "
           "logs the error and goes on without the annotations.",
    .remedy = "Correct the line; indentation (spaces only), an unclosed bracket or quote and an "
              "unquoted `: ` inside a value are the usual causes.",
    .sources =
        "smurf_parser SMURFParser.cpp:43-77 (run); Phobos io/smurfrobot.py:197; yaml-cpp 0.7 "
        "and PyYAML 6.0, executed."};

constinit const Rule sml0011_duplicate_key{
    .id = "SML0011",
    .name = "duplicate-key",
    .severity = Severity::error,
    .summary = "A mapping holds the same key twice.",
    .why =
        "MARS takes the first value (configmaps inserts only new keys), Phobos the last (PyYAML): "
        "the same file is two different robots.",
    .remedy = "Delete one of the two, or rename it.",
    .sources = "configmaps ConfigMap.cpp:53 (run); PyYAML 6.0, executed."};

constinit const Rule sml0012_complex_key{.id = "SML0012",
                                         .name = "complex-key",
                                         .severity = Severity::error,
                                         .summary = "A list or a mapping is used as a key.",
                                         .why = "configmaps (MARS) throws an exception on it.",
                                         .remedy = "Use a plain text key.",
                                         .sources = "configmaps ConfigMap.cpp, executed."};

constinit const Rule sml0013_several_documents{
    .id = "SML0013",
    .name = "several-documents",
    .severity = Severity::warning,
    .summary = "A file holds more than one YAML document.",
    .why = "MARS reads the first document and drops the rest silently; PyYAML's safe_load (Phobos) "
           "refuses the file.",
    .remedy = "Keep one document a file.",
    .sources = "configmaps, yaml-cpp 0.7 and PyYAML 6.0, executed."};

constinit const Rule sml0014_nesting_too_deep{
    .id = "SML0014",
    .name = "nesting-too-deep",
    .severity = Severity::error,
    .summary = "Lists, mappings or elements are nested deeper than the limit.",
    .why =
        "yaml-cpp gives up at 250 to 500 levels, tinyxml2 at 99, and urdfdom 3.0.1 overflows its "
        "stack at 50,000; no robot needs it.",
    .remedy = "Flatten the file.",
    .sources = "yaml-cpp 0.7, tinyxml2 9.0 and urdfdom 3.0.1, executed."};

constinit const Rule sml0015_alias_expansion{
    .id = "SML0015",
    .name = "alias-expansion",
    .severity = Severity::error,
    .summary = "Aliases multiply a small file into an enormous value.",
    .why =
        "Readers that copy aliases (configmaps does) run out of memory; this is how a few hundred "
        "bytes stop a server.",
    .remedy = "Write the values out, or use fewer aliases of aliases.",
    .sources = "yaml-cpp 0.7, executed: nine levels of nine aliases are 490 million nodes."};

constinit const Rule sml0016_cyclic_alias{
    .id = "SML0016",
    .name = "cyclic-alias",
    .severity = Severity::error,
    .summary = "An alias stands inside the value it repeats.",
    .why = "The value would contain itself: readers that follow aliases recurse until the stack "
           "overflows.",
    .remedy = "Remove the alias.",
    .sources = "yaml-cpp 0.7, executed."};

}  // namespace smurf::rules
