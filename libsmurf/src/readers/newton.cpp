// SPDX-License-Identifier: BSD-3-Clause
// Newton. Its importer parses URDF with ElementTree of Python, which refuses malformed XML, and
// reads numbers with float(). Its builder checks little: it keeps numbers that make no sense, and
// uses its own defaults where a number is absent.
#include <algorithm>
#include <optional>
#include <vector>

#include "base/findings/cases.hpp"
#include "readers/circumstances.hpp"
#include "readers/rigid_bodies.hpp"

namespace smurf::readers::newton_file {
namespace {

using enum Effect;

constexpr std::string_view kKeeps = "keeps the number";
constexpr std::string_view kIgnores = "does not look at it";
constexpr std::string_view kDefault = "takes its own default";
constexpr std::string_view kRefusesNumber = "refuses the number, and the file";
constexpr std::string_view kRefusesMesh = "refuses the file: it cannot load the mesh";
constexpr std::string_view kNotXml = "refuses what is no well-formed XML";

constexpr FamilyFact kFamilies[] = {
    // XML
    {"SML0003",
     {&newton, takes, "reads the encoding that the declaration names", kRun,
      when(cases::kDeclaration)}},
    {"SML0003", {&newton, refuses, kNotXml, kRun}},
    {"SML0004", {&newton, refuses, kNotXml, kRun}},
    {"SML0005", {&newton, takes, "reads UTF-16", kRun}},
    {"SML1001", {&newton, refuses, kNotXml, kRun}},
    {"SML1002", {&newton, refuses, "refuses a prefix that is not declared", kRun}},
    {"SML1003", {&newton, refuses, kNotXml, kRun}},
    {"SML1004", {&newton, refuses, kNotXml, kRun}},
    {"SML1005", {&newton, refuses, kNotXml, kRun}},
    {"SML1006", {&newton, refuses, kNotXml, kRun}},
    {"SML1008",
     {&newton, refuses, "refuses bytes that are not of the encoding that the declaration names",
      kRun}},
    {"SML1009", {&newton, changes, "uses the text literally", kRun, at("@name")}},
    {"SML1009", {&newton, changes, "uses the text literally", kRun, at("@joint")}},
    {"SML1009", newton_without_mesh(at("mesh/@filename"))},
    {"SML1009", {&newton, loses, "leaves the texture out", kRun, at("texture/@filename")}},
    {"SML1009",
     {&newton, loses, "ignores the element: everything it would expand to is missing", kRun,
      at("xacro:")}},
    {"SML1009",
     {&newton, refuses, "refuses the text, which is no number and no name of a link", kRun}},
    {"SML1012", {&newton, takes, "keeps the name", kRun, at("@name")}},
    {"SML1012", {&newton, refuses, kRefusesNumber, kRun}},
    {"SML1013", {&newton, takes, "skips the document type", kRun, when(cases::kDeclarations)}},
    {"SML1013", {&newton, refuses, "refuses an entity that it does not know", kRun}},
    {"SML1014", {&newton, refuses, kNotXml, kRun}},
    {"SML1015", {&newton, takes, "skips the instruction", kRun}},
    {"SML1017", {&newton, refuses, kNotXml, kRun}},
    // Elements and attributes
    {"SML1101", {&newton, refuses, "finds no link in it", kRun, when(cases::kSdf)}},
    {"SML1101", {&newton, refuses, "finds no link in it", kRun, when(cases::kMjcf)}},
    {"SML1101", {&newton, refuses, "finds no link in it", kRun, when(cases::kWithoutLinks)}},
    {"SML1101", {&newton, takes, "does not look at the name of the root", kRun}},
    {"SML1102", {&newton, takes, "takes a robot without a name", kRun}},
    {"SML1110", {&newton, loses, "builds the link without the shape", kRun}},
    {"SML1111", {&newton, changes, "builds all of the shapes", kRun}},
    {"SML1112", {&newton, takes, "skips other elements", kRun}},
    {"SML1113", {&newton, loses, "builds the link without the shape", kRun, at("mesh")}},
    {"SML1113",
     {&newton, refuses, "finds no link of the name that a joint uses", kRun,
      when(cases::kLinkTag, kMissed)}},
    {"SML1113", {&newton, loses, "leaves out the link", kRun, when(cases::kLinkTag)}},
    {"SML1113", {&newton, loses, "reads no such material", kRun, at("material")}},
    {"SML1113",
     {&newton, loses, "warns, and lets the joint move independently", kRun, at("mimic")}},
    {"SML1113", {&newton, changes, kDefault, kRun}},
    {"SML1114",
     {&newton, refuses, "ignores the joint, and does not find its child at the joints behind it",
      kRun, when(cases::kChainTag)}},
    {"SML1114",
     {&newton, loses, "ignores the joint, and drops its child", kRun, when(cases::kJointTag)}},
    // Trees
    {"SML1201", {&newton, loses, "leaves out what no root reaches", kRun, when(kUnreached)}},
    {"SML1206", {&newton, refuses, "refuses the file: it sorts no links with two parents", kRun}},
    {"SML1212", {&newton, takes, "makes a free joint", kRun}},
    {"SML1213",
     {&newton, changes, "makes a joint that slides along two axes and does not turn", kRun,
      when(kInPlanar)}},
    {"SML1213", {&newton, takes, "makes a free joint", kRun}},
    // Names
    {"SML1301", {&newton, changes, "keeps both joints", kRun, at("joint")}},
    {"SML1301", {&newton, loses, "builds the first link of that name", kRun}},
    {"SML1305", {&newton, takes, "keeps the empty name", kRun, at("joint")}},
    {"SML1305", {&newton, loses, "finds no joint that connects the link, and drops it", kRun}},
    {"SML1306", {&newton, takes, "keeps the name with the space", kRun, at("joint/@name")}},
    // Joints
    {"SML1401", {&newton, loses, "leaves out what no root reaches", kRun, when(kUnreached)}},
    {"SML1403", {&newton, changes, "sets no limits: 1e10 both ways", kRun}},
    {"SML1404", {&newton, changes, "sets the limit to 1e6", kRun}},
    {"SML1406", {&newton, changes, "sets no limit on that side: 1e10", kRun}},
    {"SML1407", {&newton, changes, "keeps the swapped limits", kRun}},
    {"SML1408", {&newton, takes, "locks the joint", kRun}},
    {"SML1409", {&newton, changes, "applies the limits to the continuous joint", kRun}},
    {"SML1414", {&newton, changes, kKeeps, kRun}},
    {"SML1415", {&newton, changes, kKeeps, kRun}},
    {"SML1421", {&newton, changes, "keeps an axis without direction", kRun}},
    {"SML1422", {&newton, takes, "normalises the axis", kRun}},
    {"SML1425", {&newton, changes, "sets damping and friction to 0", kRun}},
    {"SML1426", {&newton, changes, kKeeps, kRun}},
    {"SML1432", {&newton, loses, "warns, and lets the joint move independently", kRun}},
    {"SML1433", {&newton, refuses, "refuses joints that mimic each other", kRun}},
    {"SML1437",
     {&newton, refuses, "refuses a follower or a leader that does not move about or along one axis",
      kRun}},
    // Inertials
    {"SML1501", {&newton, changes, "gives it the mass of its collisions at 1000 kg/m3", kRun}},
    {"SML1502",
     {&newton, changes, "gives the links the masses of their collisions at 1000 kg/m3", kRun}},
    {"SML1504", {&newton, changes, "takes the mass of the collisions at 1000 kg/m3", kRun}},
    {"SML1505", {&newton, changes, "takes the inertia of the collisions at 1000 kg/m3", kRun}},
    {"SML1506", {&newton, changes, "reads 0", kRun}},
    {"SML1508", {&newton, changes, "keeps 0: forces do not move the body", kRun}},
    {"SML1509",
     {&newton, changes, "keeps the number, and sets it to 0 when the model is finished", kRun}},
    {"SML1511", {&newton, changes, "keeps 0: torques do not turn the body", kRun}},
    {"SML1512",
     {&newton, changes, "keeps the moments, and enlarges them when the model is finished", kRun}},
    {"SML1513",
     {&newton, changes, "keeps the moments, and enlarges them when the model is finished", kRun}},
    {"SML1916", {&newton, changes, "gives it the mass of its collisions at 1000 kg/m3", kRun}},
    // Shapes
    {"SML1601", {&newton, changes, "keeps a shape without volume", kRun}},
    {"SML1602",
     {&newton, changes, "reads `height` in place of `length`, or takes 1 m", kRun, at("capsule")}},
    {"SML1602", {&newton, loses, "builds the link without the shape", kRun}},
    {"SML1605", newton_without_mesh()},
    {"SML1606", newton_without_mesh()},
    {"SML1607",
     {&newton, loses, "where the file is missing, builds the link without the shape", kRun}},
    {"SML1609", {&newton, refuses, kRefusesMesh, kRun}},
    {"SML1627", {&newton, changes, "keeps a shape without volume", kRun}},
    {"SML1628", {&newton, changes, "mirrors the mesh", kRun}},
    {"SML1643", {&newton, refuses, kRefusesMesh, kRun}},
    {"SML1644", {&newton, refuses, kRefusesMesh, kRun}},
    {"SML1645", {&newton, refuses, kRefusesMesh, kRun}},
    {"SML1704", {&newton, takes, "uses the last", kRun}},
    {"SML1707",
     {&newton, takes, "brings the opacity between 0 and 1, and keeps the colours", kRun}},
    // Numbers
    {"SML1801", {&newton, refuses, kRefusesNumber, kRun, at("limit")}},
    {"SML1801", {&newton, refuses, kRefusesNumber, kRun, at("mass")}},
    {"SML1801", {&newton, refuses, kRefusesNumber, kRun, at("inertia")}},
    {"SML1801", {&newton, refuses, kRefusesNumber, kRun, at("dynamics")}},
    {"SML1801", {&newton, refuses, kRefusesNumber, kRun, at("mimic")}},
    {"SML1801", {&newton, refuses, kRefusesNumber, kRun, at("axis")}},
    {"SML1801", {&newton, takes, "takes white", kRun, at("@rgba").when(cases::kBlanks)}},
    {"SML1801", {&newton, refuses, kRefusesNumber, kRun, when(cases::kBlanks)}},
    {"SML1801", {&newton, changes, kDefault, kRun, when(cases::kEmpty)}},
    {"SML1802", {&newton, takes, "skips white space", kRun}},
    {"SML1803", {&newton, refuses, kRefusesNumber, kRun, at("mimic")}},
    {"SML1803",
     {&newton, changes, "keeps it, and computes with it until nothing has a position", kRun}},
    {"SML1804", {&newton, refuses, kRefusesNumber, kRun, at("mimic")}},
    {"SML1804", {&newton, changes, "keeps infinity", kRun}},
    {"SML1807",
     {&newton, takes, "uses the first three numbers", kRun, at("axis").when(cases::kTooMany)}},
    {"SML1807",
     {&newton, takes, "uses the first three numbers", kRun, at("box").when(cases::kTooMany)}},
    {"SML1807", {&newton, changes, "leaves the colour at its default", kRun, at("@rgba")}},
    {"SML1810", {&newton, refuses, kRefusesNumber, kRun, at("mimic")}},
    {"SML1810", {&newton, changes, "reads infinity or 0", kRun}},
    {"SML1811", {&newton, refuses, kRefusesNumber, kRun, at("@rgba")}},
    {"SML1811", {&newton, takes, "reads the digits of other scripts", kRun}},
    {"SML18", {&newton, refuses, kRefusesNumber, kRun}},
};

constexpr Fact kUnread[] = {
    {&newton, ignores, kIgnores, kRun, at("robot/@version")},
    {&newton, ignores, kIgnores, kRun, at("calibration")},
    {&newton, ignores, kIgnores, kRun, at("safety_controller")},
    {&newton, ignores, kIgnores, kRun, at("transmission")},
    {&newton, ignores, kIgnores, kRun, at("gazebo")},
};

/// Whether no root reaches the child of a joint: it is part of a ring, or follows one. A joint
/// whose parent and child are one absent link is such a ring.
bool is_unreached(const LinkedModel& model, std::size_t joint, const std::vector<bool>& reached) {
  const std::optional<LinkIndex> child = model.tree.joint_child[joint];
  if (child) return !reached[to_size(*child)];
  const urdf::Joint& one = model.robot->joints[joint];
  return one.parent && one.child && *one.parent == *one.child;
}

bool is_missed(const LinkedModel& model) {
  const std::vector<std::optional<LinkIndex>>& parents = model.tree.joint_parent;
  const std::vector<std::optional<LinkIndex>>& children = model.tree.joint_child;
  return std::find(parents.begin(), parents.end(), std::nullopt) != parents.end() ||
         std::find(children.begin(), children.end(), std::nullopt) != children.end();
}

void see(const LinkedModel& model, std::span<Diagnostic* const> found) {
  std::vector<bool> reached;  // computed when it is needed
  const bool is_link_missed = is_missed(model);
  for (Diagnostic* finding : found) {
    if (is_link_missed) finding->when(kMissed);
    const urdf::Joint* joint = part_at(model.robot->joints, finding->span.begin);
    if (joint == nullptr) continue;
    if (reached.empty()) reached = reached_links(model);
    if (is_unreached(model, index_in(model.robot->joints, *joint), reached)) {
      finding->when(kUnreached);
    }
  }
}

}  // namespace

extern constinit const Reader newton{.name = "newton",
                                     .title = "Newton",
                                     .basis = "1.8.0 (wheel `newton[importers]`), executed: "
                                              "ModelBuilder.add_urdf with its own settings",
                                     .like = &urdf,
                                     .version = "Newton 1.8",
                                     .families = kFamilies,
                                     .unread = kUnread,
                                     .see = see};

}  // namespace smurf::readers::newton_file
