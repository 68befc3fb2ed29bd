// SPDX-License-Identifier: BSD-3-Clause
// What MuJoCo simulates, and neither a URDF nor SMURF says. Each kind is one finding, at the first
// place: models set it for all of their parts.
#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/findings/rules.hpp"
#include "base/text/lists.hpp"
#include "base/text/quoted.hpp"
#include "mjcf/robot.hpp"

namespace smurf::mjcf {
namespace {

/// The value that a setting has in MuJoCo without being written.
std::string_view usual(std::string_view name) {
  return name == "condim" ? "3" : name == "solmix" ? "1" : "0";
}

/// The settings of one kind that some parts have.
class Unsaid {
 public:
  /// `settings`: of one part; reads those that have a meaning there.
  void add(const Settings& settings, const std::vector<std::string_view>& names) {
    bool has_one = false;
    for (const std::string_view name : names) {
      const Attribute* set = settings.find(name);
      if (set == nullptr || set->value() == usual(name)) continue;
      has_one = true;
      if (place_.empty()) place_ = set->value_span();
      if (std::find(names_.begin(), names_.end(), name) == names_.end()) names_.push_back(name);
    }
    if (has_one) ++count_;
  }

  /// "SMURF has no X, so 3 joints lose A and B"; `part`: with its article.
  void report(std::string_view why, std::string_view part, std::string_view parts,
              Reporter& reporter, Severity severity = Severity::warning) const {
    if (names_.empty()) return;
    std::vector<std::string> words;
    for (const std::string_view name : names_)
      words.push_back(name == "friction" ? "torsional and rolling `friction`" : quoted(name));
    const std::string who = count_ == 1
                                ? std::string(part) + " loses "
                                : std::to_string(count_) + " " + std::string(parts) + " lose ";
    Diagnostic& lost = reporter.report(rules::sml9304_lost_in_urdf, place_,
                                       std::string(why) + ", so " + who + enumerated(words));
    lost.help("keep the MJCF for them");
    lost.severity = severity;
  }

 private:
  std::vector<std::string_view> names_;
  Span place_;
  std::size_t count_ = 0;
};

void contacts(const Model& model, Reporter& reporter) {
  Unsaid unsaid;
  for (const Body& body : model.bodies) {
    for (const Geom& geom : body.geoms) {
      if (!touches(geom)) continue;
      std::vector<std::string_view> names{"condim",   "solref", "solimp", "margin",
                                          "priority", "solmix", "gap"};
      const std::array<double, 3> friction = friction_of(geom, reporter);
      const bool only_slides = friction[1] == kUsualFriction[1] && friction[2] == kUsualFriction[2];
      if (!only_slides) names.insert(names.begin(), "friction");
      unsaid.add(geom.settings, names);
    }
  }
  unsaid.report("SMURF has no settings for contacts of MuJoCo", "a shape", "shapes", reporter);
}

/// A free joint is none in a URDF, so nothing can damp it.
void joints(const Model& model, Reporter& reporter) {
  Unsaid soft, free;
  for (const Body& body : model.bodies) {
    for (const Joint& joint : body.joints) {
      if (joint.type == Joint::Type::free) {
        // Those of defaults are hardly meant, and SML9308 says so.
        free.add(Settings(joint.settings.element(), nullptr),
                 {"damping", "frictionloss", "armature"});
        continue;
      }
      std::vector<std::string_view> names;
      if (joint.is_limited) names = {"solreflimit", "solimplimit", "margin"};
      if (joint.friction != 0) names.insert(names.end(), {"solreffriction", "solimpfriction"});
      if (joint.settings.text("actuatorgravcomp") == "true") names.push_back("actuatorgravcomp");
      soft.add(joint.settings, names);
    }
  }
  soft.report("SMURF has no settings of MuJoCo for joints", "a joint", "joints", reporter);
  free.report("a body that floats has no joint in a URDF", "a free joint", "free joints", reporter);
}

void equalities(const Model& model, Reporter& reporter) {
  Unsaid unsaid;
  for (const Reference& one : model.sections) {
    if (one.section != "equality") continue;
    const Attribute* name = one.element.attribute("class");
    const DefaultClass* of_class =
        one.around.file->find_class(name != nullptr ? name->value() : "main");
    unsaid.add(Settings(one.element, of_class), {"solref", "solimp"});
  }
  unsaid.report("SMURF holds joints and links together without giving way", "an equality",
                "equalities", reporter);
}

void sensors(const Model& model, Reporter& reporter) {
  Unsaid unsaid;
  for (const Reference& one : model.sections) {
    if (one.section != "sensor") continue;
    std::vector<std::string_view> names{"noise", "delay", "nsample", "interval"};
    if (one.element.name() != "rangefinder") names.push_back("cutoff");
    unsaid.add(Settings(one.element, nullptr), names);
  }
  unsaid.report("SMURF has no such settings of sensors", "a sensor", "sensors", reporter);
}

void bodies(const Model& model, Reporter& reporter) {
  Unsaid held, moved;
  for (const Body& body : model.bodies) {
    const Settings settings(body.element, nullptr);
    if (body.gravcomp != 0) held.add(settings, {"gravcomp"});
    if (body.is_mocap) moved.add(settings, {"mocap"});
  }
  held.report("a URDF has no force against gravity", "a body", "bodies", reporter);
  moved.report("a URDF has no body that a program moves: it is fixed", "a body", "bodies",
               reporter);
}

/// A value of a free joint is the whole pose of its body, which is at zero without one.
void poses(const Model& model, Reporter& reporter) {
  Unsaid unsaid;
  for (const Body& body : model.bodies) {
    const bool is_free = body.joints.size() == 1 && body.joints.front().type == Joint::Type::free;
    if (is_free && !(body.pose == Pose{}))
      unsaid.add(Settings(body.element, nullptr),
                 {"pos", "quat", "euler", "axisangle", "xyaxes", "zaxis"});
  }
  // Most floating robots begin above the ground: the program that loads one says where.
  unsaid.report("a URDF does not say where a body begins to float", "a body", "bodies", reporter,
                Severity::info);
}

}  // namespace

std::array<double, 3> friction_of(const Geom& geom, Reporter& reporter) {
  std::array<double, 3> friction = kUsualFriction;
  geom.settings.numbers("friction", friction, 1, reporter);
  return friction;
}

void report_unsaid(const Model& model, Reporter& reporter) {
  contacts(model, reporter);
  joints(model, reporter);
  equalities(model, reporter);
  sensors(model, reporter);
  bodies(model, reporter);
  poses(model, reporter);
}

}  // namespace smurf::mjcf
