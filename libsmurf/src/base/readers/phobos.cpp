// SPDX-License-Identifier: BSD-3-Clause
// Phobos 2, which reads URDF with Python's XML and YAML with PyYAML.
#include "base/readers.hpp"

namespace smurf::readers {
namespace {

using enum Effect;

constexpr ReaderFact kFacts[] = {
    {"SML0010", loses, "logs the error and goes on without the annotations",
     "Phobos smurfrobot.py"},
    {"SML0011", changes, "takes the last value", "PyYAML"},
    {"SML0013", loses, "refuses the file and goes on without the annotations", "PyYAML safe_load"},
    {"SML1002", refuses, "refuses the file", "expat, lxml, run"},
    {"SML1003", refuses, "refuses the file", "expat, lxml, run"},
    {"SML1004", refuses, "refuses the file", "expat, lxml, run"},
    {"SML1005", refuses, "refuses the file", "expat, lxml, run"},
    {"SML1006", refuses, "refuses the file", "expat, lxml, run"},
    {"SML1912", changes, "takes the folder above urdf/ for every package", "Phobos xml.py:89-98"},
    {"SML2003", refuses, "has no robot", "Phobos smurfrobot.py"},
    {"SML2018", refuses, "stops with a KeyError", "Phobos io/smurfrobot.py:166"},
    {"SML3101", refuses, "stops with an error", "Phobos smurfrobot.py"},
    {"SML3104", ignores, "ignores the entry", "Phobos smurfrobot.py"},
    {"SML4004", refuses, "stops with a KeyError", "Phobos smurfrobot.py"},
    {"SML5004", changes, "normalises it, and reads it as x, y, z, w",
     "Phobos representation.py:141-160"},
    {"SML5009", changes, "goes by the extension", "Phobos multiple.py"},
    {"SML5013", refuses, "stops with an assertion", "Phobos multiple.py"},
    {"SML5020", refuses, "stops with a RecursionError", "Phobos multiple.py:28-33"},
    {"SML5029", loses, "reads `entities`, else `smurfa`, else `smurfs`", "Phobos core/multiple.py"},
    {"SML7006", loses, "ignores the section", "Phobos io/smurfrobot.py"},
    {"SML2017", loses, "does not read the file", "Phobos io/smurfrobot.py"},
    {"SML7008", refuses, "raises an exception", "Phobos io/smurfrobot.py:233-243, 376"},
    {"SML7100", takes, "reads scenes and assemblies", "Phobos core/multiple.py"},
    {"SML7103", changes, "reads x, y, z, w", "Phobos utils/transform.py:9-48", "#quaternion"},
    {"SML7103", changes, "reads radians", "Phobos utils/transform.py:9-48"},
    {"SML7107", refuses, "stops with an assertion", "Phobos core/multiple.py"},
};

}  // namespace

extern constinit const Reader phobos{.name = "phobos",
                                     .title = "Phobos 2",
                                     .basis = "a613e31, read",
                                     .like = &urdf,
                                     .facts = kFacts};

}  // namespace smurf::readers
