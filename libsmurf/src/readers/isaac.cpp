// SPDX-License-Identifier: BSD-3-Clause
// Isaac Sim and Isaac Lab, by their converter from URDF to USD, which was run. It parses URDF with
// ElementTree of Python, and reads numbers with float().
#include "base/findings/cases.hpp"
#include "readers/circumstances.hpp"

namespace smurf::readers::isaac_file {
namespace {

using enum Effect;

constexpr std::string_view kKeeps = "keeps the number";
constexpr std::string_view kDefault = "takes its own default";
constexpr std::string_view kRefusesNumber = "refuses the number, and the file";
constexpr std::string_view kNotXml = "refuses what is no well-formed XML";
constexpr std::string_view kCustom = "keeps it as a custom prim or attribute that nothing uses";

constexpr FamilyFact kFamilies[] = {
    // XML
    {"SML0003", {&isaac, refuses, kNotXml, kRun}},
    {"SML0004", {&isaac, refuses, kNotXml, kRun}},
    {"SML0005", {&isaac, refuses, kNotXml, kRun}},
    {"SML1001", {&isaac, refuses, kNotXml, kRun}},
    {"SML1002", {&isaac, refuses, "refuses a prefix that is not declared", kRun}},
    {"SML1003", {&isaac, refuses, kNotXml, kRun}},
    {"SML1004", {&isaac, refuses, kNotXml, kRun}},
    {"SML1005", {&isaac, takes, "skips the blanks", kRun, when(cases::kBlanks)}},
    {"SML1005", {&isaac, refuses, kNotXml, kRun}},
    {"SML1006", {&isaac, refuses, kNotXml, kRun}},
    {"SML1008", {&isaac, takes, "reads UTF-8, whatever the declaration says", kRun}},
    {"SML1009", {&isaac, changes, "uses the text literally", kRun, at("@name")}},
    {"SML1009", isaac_without_mesh(at("mesh/@filename"))},
    {"SML1009", {&isaac, loses, "leaves the texture out", kRun, at("texture/@filename")}},
    {"SML1009",
     {&isaac, loses, "ignores the element: everything it would expand to is missing", kRun,
      at("xacro:")}},
    {"SML1009",
     {&isaac, refuses, "refuses the text, which is no number and no name of a link", kRun}},
    {"SML1012", {&isaac, takes, "keeps the name", kRun, at("@name")}},
    {"SML1012", {&isaac, refuses, kRefusesNumber, kRun}},
    {"SML1013", {&isaac, takes, "skips the document type", kRun, when(cases::kDeclarations)}},
    {"SML1013", {&isaac, refuses, "refuses an entity that it does not know", kRun}},
    {"SML1014", {&isaac, refuses, kNotXml, kRun}},
    {"SML1015", {&isaac, takes, "skips the instruction", kRun}},
    {"SML1017", {&isaac, refuses, kNotXml, kRun}},
    // Elements and attributes
    {"SML1101", {&isaac, refuses, "refuses a root that is not `robot`", kRun}},
    {"SML1102", {&isaac, refuses, "refuses a robot without a name", kRun}},
    {"SML1108", {&isaac, loses, kCustom, kRun}},
    {"SML1109", {&isaac, changes, "uses the last one", kRun}},
    {"SML1110", isaac_without_mesh()},
    {"SML1111", {&isaac, changes, "uses the last shape", kRun}},
    {"SML1112", {&isaac, takes, "skips other elements", kRun}},
    {"SML1113", {&isaac, changes, kDefault, kRun, at("safety_controller")}},
    {"SML1113", {&isaac, changes, kDefault, kRun, at("axis")}},
    {"SML1113", {&isaac, changes, kDefault, kRun, at("box")}},
    {"SML1113", {&isaac, changes, kDefault, kRun, at("color")}},
    {"SML1113", {&isaac, changes, kDefault, kRun, at("mass")}},
    {"SML1113", {&isaac, refuses, "refuses a material without a name", kRun, at("robot/material")}},
    {"SML1113", {&isaac, changes, "gives it a name of its own", kRun, at("material")}},
    {"SML1113", isaac_without_mesh(at("mesh"))},
    {"SML1113", {&isaac, refuses, "refuses the file", kRun}},
    {"SML1114",
     {&isaac, loses, "ignores the joint, and drops what is behind it", kRun,
      when(cases::kJointTag)}},
    // Trees
    {"SML1115", {&isaac, refuses, "refuses a robot without links", kRun}},
    {"SML1204", {&isaac, loses, "converts what is below the first root only", kRun}},
    {"SML1206", {&isaac, changes, "builds the link below each of its parents", kRun}},
    {"SML1212", {&isaac, changes, "makes no joint, so that the link floats", kRun}},
    {"SML1213", {&isaac, changes, "makes a joint of its own", kRun, when(kInPlanar)}},
    {"SML1213", {&isaac, takes, "makes no joint, so that the link floats", kRun}},
    // Names
    {"SML1301", {&isaac, refuses, "refuses two of one name", kRun}},
    {"SML1305", {&isaac, refuses, "refuses an element without a name", kRun}},
    {"SML1306", {&isaac, takes, "keeps the name with the space", kRun, at("joint/@name")}},
    // Joints
    {"SML1403", {&isaac, changes, "sets no limits", kRun}},
    {"SML1404",
     {&isaac, changes, "writes no such limit; that of the effort is a custom attribute", kRun}},
    {"SML1406", {&isaac, changes, "takes 0 for it", kRun}},
    {"SML1407", {&isaac, changes, "keeps the swapped limits", kRun}},
    {"SML1408", {&isaac, takes, "locks the joint", kRun}},
    {"SML1409", {&isaac, ignores, "writes no limits", kRun}},
    {"SML1414", {&isaac, changes, kKeeps, kRun}},
    {"SML1415", {&isaac, changes, kKeeps, kRun}},
    {"SML1422", {&isaac, takes, "normalises the axis", kRun}},
    {"SML1425", {&isaac, changes, kDefault, kRun}},
    {"SML1426", {&isaac, changes, kKeeps, kRun}},
    {"SML1432", {&isaac, refuses, "refuses a joint that mimics an unknown one", kRun}},
    {"SML1433", {&isaac, changes, "writes the joints that follow each other", kRun}},
    // Inertials
    {"SML1501",
     {&isaac, changes, "writes no mass: the simulator computes it from the collisions", kRun}},
    {"SML1502",
     {&isaac, changes, "writes no masses: the simulator computes them from the collisions", kRun}},
    {"SML1504",
     {&isaac, changes, "writes no mass: the simulator computes it from the collisions", kRun}},
    {"SML1505",
     {&isaac, changes, "writes no inertia: the simulator computes it from the collisions", kRun}},
    {"SML1506", {&isaac, changes, "reads 0", kRun}},
    {"SML1508", {&isaac, changes, "writes 0, in place of which the simulator computes it", kRun}},
    {"SML1509", {&isaac, changes, kKeeps, kRun}},
    {"SML1511", {&isaac, changes, "writes 0, in place of which the simulator computes it", kRun}},
    {"SML1512", {&isaac, changes, kKeeps, kRun}},
    {"SML1513", {&isaac, changes, kKeeps, kRun}},
    {"SML1916",
     {&isaac, changes, "writes no mass: the simulator computes it from the collisions", kRun}},
    // Shapes
    {"SML1601", {&isaac, changes, "keeps a shape without volume", kRun}},
    {"SML1602", isaac_without_mesh()},
    {"SML1605", isaac_without_mesh()},
    {"SML1606", isaac_without_mesh()},
    {"SML1607",
     {&isaac, loses, "where the file is missing, builds the link without the shape", kRun}},
    {"SML1609", isaac_without_mesh()},
    {"SML1627", {&isaac, changes, "keeps a shape without volume", kRun}},
    {"SML1628", {&isaac, changes, "mirrors the mesh", kRun}},
    {"SML1643", isaac_without_mesh()},
    {"SML1644", isaac_without_mesh()},
    {"SML1645", isaac_without_mesh()},
    {"SML1651", isaac_without_mesh(at("mesh"))},
    {"SML1704", {&isaac, refuses, "refuses two materials of one name", kRun}},
    {"SML1707", {&isaac, takes, kKeeps, kRun}},
    // Numbers
    {"SML1802", {&isaac, takes, "skips white space", kRun}},
    {"SML1803",
     {&isaac, refuses, "fails at the principal axes of the inertia", kRun, at("inertia")}},
    {"SML1803",
     {&isaac, changes, "keeps it, and computes with it until nothing has a position", kRun}},
    {"SML1804",
     {&isaac, refuses, "fails at the principal axes of the inertia", kRun, at("inertia")}},
    {"SML1804", {&isaac, changes, "keeps infinity", kRun}},
    {"SML1810",
     {&isaac, refuses, "fails at the principal axes of the inertia", kRun,
      at("inertia").unless(cases::kUnderflow)}},
    {"SML1810", {&isaac, changes, "reads infinity or 0", kRun}},
    {"SML1811", {&isaac, takes, "reads the digits of other scripts", kRun}},
    {"SML18", {&isaac, refuses, kRefusesNumber, kRun}},
};

constexpr Fact kUnread[] = {
    {&isaac, ignores, "does not look at it", kRun, at("robot/@version").unless(kPrefixed)},
    {&isaac, ignores, kCustom, kRun, at("transmission").unless(kPrefixed)},
    {&isaac, ignores, kCustom, kRun, at("gazebo").unless(kPrefixed)},
};

}  // namespace

extern constinit const Reader isaac{
    .name = "isaac",
    .title = "Isaac",
    .basis = "urdf-usd-converter 0.3.4 (wheel), executed: what it writes into the USD. "
             "Isaac Sim itself needs a graphics card and was not run.",
    .like = &urdf,
    .version = "urdf-usd-converter 0.3.4",
    .families = kFamilies,
    .unread = kUnread};

}  // namespace smurf::readers::isaac_file
