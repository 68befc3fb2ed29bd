// SPDX-License-Identifier: BSD-3-Clause
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "base/findings/readers.hpp"
#include "base/ranges.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1120_word_of_other_dialect_file {
namespace {

constexpr Circumstance kOfBullet{"of Bullet", &readers::pybullet};
constexpr Circumstance kOfDrake{"of Drake", &readers::drake};
constexpr Circumstance kOfNobody{"of no reader of URDF"};

/// An element that sets something for the reader of one dialect, or for none.
struct Word {
  std::string_view parent, name;
  const Circumstance* owner = nullptr;
  std::string_view help;
};

constexpr std::string_view kForGazebo = "for Gazebo, write it in a `gazebo` element";
constexpr Word kWords[] = {
    {"link", "contact", &kOfBullet,
     "for Gazebo, write `mu1` and `mu2` in a `gazebo` element; for MuJoCo, set friction in an MJCF"},
    {"link", "gravity", &kOfNobody, kForGazebo},
    {"link", "kinematic", &kOfNobody, kForGazebo},
    {"link", "selfCollide", &kOfNobody, kForGazebo},
    {"link", "velocity_decay", &kOfNobody, kForGazebo},
    {"link", "audio_source", &kOfBullet, kForGazebo},
    {"collision", "mask", &kOfNobody, "set it in the simulator"},
    {"collision", "group", &kOfNobody, "set it in the simulator"},
    {"collision", "max_contacts", &kOfNobody, "write `maxContacts` in a `gazebo` element"},
    {"collision", "contact_coefficients", &kOfNobody, "write `mu1` and `kp` in a `gazebo` element"},
    {"collision", "drake_compliance", &kOfDrake,
     "write `drake:proximity_properties` for today's Drake"},
    {"joint", "actuator", &kOfNobody, "write a `transmission` or `ros2_control`"},
    {"joint", "motor", &kOfNobody, "write a `transmission` or `ros2_control`"},
    {"joint", "hardwareInterface", &kOfNobody, "write it in a `transmission`"},
    {"robot", "actuator", &kOfNobody, "write a `transmission` or `ros2_control`"},
};

class Check {
 public:
  Check(const LinkedModel& model, Findings& findings) : model_(model), findings_(findings) {}

  void run() {
    const urdf::Robot& robot = *model_.robot;
    for (const xml::ElementId id : robot.extensions) see("robot", xml::View(robot.document, id));
    for (const urdf::Link& link : robot.links) {
      see_children("link", link.element);
      for (const urdf::Collision& collision : link.collisions) {
        see_children("collision", collision.element);
      }
    }
    for (const urdf::Joint& joint : robot.joints) see_children("joint", joint.element);
  }

 private:
  void see_children(std::string_view parent, xml::ElementId id) {
    for (const xml::View child : xml::View(model_.robot->document, id)) see(parent, child);
  }
  void see(std::string_view parent, xml::View element) {
    const auto word = ranges::find_if(kWords, [&](const Word& one) {
      return one.parent == parent && one.name == element.name();
    });
    if (word == std::end(kWords)) return;
    const std::string_view format = word->owner == &kOfBullet  ? "Bullet"
                                    : word->owner == &kOfDrake ? "Drake"
                                                               : "another format";
    findings_
        .report_habit(element.name_span(),
                      quoted(element.name()) + " in a `" + std::string(parent) + "` is a word of " +
                          std::string(format),
                      "such elements", static_cast<std::size_t>(word - std::begin(kWords)))
        .when(*word->owner)
        .help(std::string(word->help));
  }

  const LinkedModel& model_;
  Findings& findings_;
};

void check(const LinkedModel& model, Findings& findings) {
  if (model.robot) Check(model, findings).run();
}

constexpr std::string_view kIgnores = "ignores the element, and uses its own default";

constexpr Fact kFacts[] = {
    {&readers::pybullet, Effect::takes, "reads it", kRun, when(kOfBullet)},
    {&readers::pybullet, Effect::loses, kIgnores, kRun},
    {&readers::gazebo, Effect::loses, kIgnores, kRun},
    {&readers::dart, Effect::loses, kIgnores, kRun},
    {&readers::mujoco, Effect::loses, kIgnores, kRun},
    {&readers::drake, Effect::takes, "read it in earlier versions", "Drake, read", when(kOfDrake)},
    {&readers::drake, Effect::loses, kIgnores, "Drake detail_urdf_parser.cc"},
};

}  // namespace

extern constinit const Rule sml1120_word_of_other_dialect{
    .id = "SML1120",
    .name = "word-of-other-dialect",
    .severity = Severity::warning,
    .summary = "An element sets something that a target does not read from a URDF.",
    .why = "Friction, gravity or masks then have no effect.",
    .remedy = "Write the setting where the target reads it, or delete it.",
    .sources = "bullet3 issue 2917, fairo issue 1332.",
    .check_model = check,
    .needs_target = true,
    .facts = kFacts};

}  // namespace smurf::rules::sml1120_word_of_other_dialect_file
