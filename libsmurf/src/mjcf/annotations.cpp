// SPDX-License-Identifier: BSD-3-Clause
// Actuators as motors and keyframes as poses: the parts of a model for which SMURF has a section.
#include <algorithm>
#include <cmath>
#include <set>

#include "base/findings/rules.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/quoted.hpp"
#include "mjcf/robot.hpp"

namespace smurf::mjcf {
namespace {

/// A text in YAML that begins at the value of a key.
std::string yaml_text(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result.push_back('\\');
    result.push_back(static_cast<unsigned char>(c) < ' ' ? ' ' : c);
  }
  return result + "\"";
}

class AnnotationWriter {
 public:
  AnnotationWriter(const Model& model, Reporter& reporter, xacro::Expansion& expansion)
      : model_(model), reporter_(reporter), leaves_(expansion.leaves) {
    for (const Body& body : model.bodies) {
      for (const Joint& joint : body.joints) joints_.emplace(joint.name, &joint);
    }
  }

  std::string run() {
    section("motors", "actuator", [&](const Reference& one) { actuator(one); });
    section("poses", "keyframe", [&](const Reference& one) { keyframe(one); });
    return std::move(text_);
  }

 private:
  template <class F>
  void section(std::string_view name, std::string_view of, const F& write) {
    const std::size_t begin = text_.size();
    text_ += std::string(name) + ":\n";
    const std::size_t empty = text_.size();
    for (const Reference& one : model_.sections) {
      if (one.section == of) write(one);
    }
    if (text_.size() == empty) text_.resize(begin);
  }

  void value(std::string_view text, const Place& place) {
    xacro::Leaf& leaf = leaves_.emplace_back();
    leaf.kind = xacro::Leaf::Kind::value;
    leaf.begin = static_cast<std::uint32_t>(text_.size());
    text_ += text;
    leaf.end = static_cast<std::uint32_t>(text_.size());
    leaf.origin = place.origin;
    leaf.use = leaf.whole = place.use;
    leaf.first_input = kMade;
    leaf.frame = place.frame;
  }
  void line(std::string_view indent, std::string_view key, std::string_view text,
            const Place& place) {
    text_.append(indent).append(key).append(": ");
    value(text, place);
    text_ += "\n";
  }

  void lost(const Reference& one, std::string what) {
    reporter_.report(rules::sml9304_lost_in_urdf, one.element.name_span(), std::move(what))
        .help("keep the MJCF for it");
  }

  void actuator(const Reference& one) {
    const Attribute* name = one.element.attribute("joint");
    if (name == nullptr) name = one.element.attribute("jointinparent");
    if (name == nullptr) return;  // reported with its efforts
    const auto joint = joints_.find(full_name(name->value(), one.around));
    if (joint == joints_.end()) return;
    const ModelFile& file = *one.around.file;
    const Attribute* class_name = one.element.attribute("class");
    const Settings s(one.element,
                     file.find_class(class_name != nullptr ? class_name->value() : "main"));
    const std::string_view kind = one.element.name();
    const bool holds = kind == "position" || kind == "intvelocity";
    if (!holds && kind != "motor" && kind != "velocity") {
      lost(one, "SMURF has no motor like " + quoted(kind) + ", so this one is lost");
      return;
    }
    if (!driven_.insert(joint->first).second) {
      lost(one, "a joint of SMURF has one motor, so this second one is lost");
      return;
    }
    const Place tag{one.element.name_span(), one.element.tag_span(), one.around.frame};
    line("- ", "name", yaml_text(joint->first), tag);
    line("  ", "joint", yaml_text(joint->first), s.place({"joint", "jointinparent"}));
    line("  ", "type", holds ? "PID" : kind == "motor" ? "direct_effort" : "DC", tag);
    if (holds) {
      line("  ", "p", format_number(s.number("kp", 1, reporter_)), s.place({"kp"}));
      line("  ", "i", "0", tag);
      line("  ", "d", format_number(s.number("kv", 0, reporter_)), s.place({"kv"}));
    }
    std::array<double, 2> range{};
    const bool is_limited = s.text("ctrllimited") != "false" &&
                            s.numbers("ctrlrange", range, 2, reporter_) == 2 && range[0] < range[1];
    if (is_limited && holds) {
      line("  ", "minValue", format_number(range[0]), s.place({"ctrlrange"}));
      line("  ", "maxValue", format_number(range[1]), s.place({"ctrlrange"}));
    } else if (is_limited && kind == "velocity") {
      line("  ", "maxSpeed", format_number(std::max(std::fabs(range[0]), std::fabs(range[1]))),
           s.place({"ctrlrange"}));
    }
    if (const auto effort = effort_of(s, reporter_)) {
      line("  ", "maxEffort", format_number(*effort), s.place({"forcerange", "ctrlrange", "gear"}));
    }
  }

  void keyframe(const Reference& one) {
    if (one.around.file != &model_.files.front() || !one.around.prefix.empty()) return;
    const Attribute* values = one.element.attribute("qpos");
    if (values == nullptr) return;
    std::size_t count = 0;
    for (const Body& body : model_.bodies) {
      for (const Joint& joint : body.joints) count += size_of(joint);
    }
    const auto numbers = numbers_of(*values, 0, count, reporter_);
    const Attribute* name = one.element.attribute("name");
    const Place tag{one.element.name_span(), one.element.tag_span()};
    const std::string text =
        name != nullptr ? std::string(name->value()) : "key_" + std::to_string(keys_);
    ++keys_;
    line("- ", "name", yaml_text(text), tag);
    text_ += "  joints:";
    bool is_empty = true;
    std::size_t at = 0;
    for (const Body& body : model_.bodies) {
      for (const Joint& joint : body.joints) {
        const std::size_t size = size_of(joint);
        if (size == 1 && at < numbers.size()) {
          if (is_empty) text_ += "\n";
          is_empty = false;
          line("    ", yaml_text(joint.name), format_number(numbers[at]),
               {values->value_span(), one.element.tag_span()});
        } else if (size > 1 && at < numbers.size()) {
          lost(one, "a pose of SMURF has no values of free and ball joints, so they are lost");
        }
        at += size;
      }
    }
    if (is_empty) text_ += " {}\n";
  }

  static std::size_t size_of(const Joint& joint) {
    return joint.type == Joint::Type::free ? 7 : joint.type == Joint::Type::ball ? 4 : 1;
  }

  const Model& model_;
  Reporter& reporter_;
  std::vector<xacro::Leaf>& leaves_;
  std::map<std::string, const Joint*> joints_;
  std::set<std::string> driven_;
  std::size_t keys_ = 0;
  std::string text_;
};

}  // namespace

std::string write_annotations(const Model& model, Reporter& reporter, xacro::Expansion& expansion) {
  return AnnotationWriter(model, reporter, expansion).run();
}

}  // namespace smurf::mjcf
