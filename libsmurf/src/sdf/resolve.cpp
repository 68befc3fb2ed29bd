// SPDX-License-Identifier: BSD-3-Clause
// Poses, ends of joints and axes, once all names are known.
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "base/files/path.hpp"
#include "base/findings/rules.hpp"
#include "base/numbers/exact_math.hpp"
#include "base/text/quoted.hpp"
#include "sdf/model.hpp"

namespace smurf::sdformat {
namespace {

constexpr double kTwoPi = 2 * 3.14159265358979323846;

constexpr std::pair<std::string_view, Joint::Type> kTypes[] = {
    {"fixed", Joint::Type::fixed},
    {"revolute", Joint::Type::revolute},
    {"continuous", Joint::Type::continuous},
    {"prismatic", Joint::Type::prismatic},
    {"ball", Joint::Type::ball},
    {"universal", Joint::Type::universal},
    {"revolute2", Joint::Type::revolute2},
    {"screw", Joint::Type::screw},
    {"gearbox", Joint::Type::gearbox}};

class Resolver {
 public:
  Resolver(Model& model, Reporter& reporter)
      : model_(model), reporter_(reporter), frames_(reporter) {
    frames_.index_links(model.links);
  }

  void run() {
    Scope& top = model_.scopes.front();
    if (!top.is_world && !top.placement_frame.empty())
      model_.X_W =
          model_.X_W * inverse(frames_.express(top, top.placement_frame, top.placement_place));
    for (Vertex& vertex : model_.vertices) frames_.in_scope(vertex);
    for (Scope& scope : model_.scopes) {
      if (!scope.canonical_link.empty() && !frames_.body_of(scope, scope.canonical_link)) {
        reporter_.refuse_name(scope.element.attribute("canonical_link")->value_span(),
                              "there is no link " + quoted(scope.canonical_link), "name a link");
      }
    }
    for (const Vertex& vertex : model_.vertices) check_attached(vertex);
    for (Link& link : model_.links) link.X_W = model_.X_W * frames_.in_world(*link.vertex);
    for (Joint& joint : model_.joints) resolve(joint);
  }

 private:
  void check_attached(const Vertex& vertex) {
    if (vertex.kind != Vertex::Kind::frame || vertex.attached_to.empty()) return;
    if (frames_.body_of(*vertex.scope, vertex.attached_to) ||
        (vertex.scope->is_static && Frames::find(*vertex.scope, vertex.attached_to)))
      return;
    reporter_.refuse_name(vertex.element.attribute("attached_to")->value_span(),
                          "there is no frame " + quoted(vertex.attached_to) + " to which " +
                              quoted(vertex.name) + " could be attached",
                          "name a link, a joint, a frame or a model beside it");
  }

  std::optional<Body> end(const Joint& joint, std::string_view which, const std::string& name) {
    const View element = joint.vertex->element.child(which);
    const Span place =
        element && !name.empty() ? element.text_span() : joint.vertex->element.name_span();
    auto body = frames_.body_of(*joint.vertex->scope, name);
    if (body && (name.empty() || name == "__model__" || (which == "child" && !body->link)))
      body.reset();
    if (!body) {
      reporter_.refuse_name(place,
                            which == "child" && name == "world"
                                ? "the world cannot be the child of a joint"
                                : "there is no " + std::string(which) + " " + quoted(name) +
                                      " of " + quoted(joint.vertex->name),
                            which == "child" && name == "world"
                                ? "exchange parent and child"
                                : "name a link or a frame of the model");
    }
    return body;
  }

  void resolve(Joint& joint) {
    const View element = joint.vertex->element;
    const std::string type = path::to_lower(attribute_of(element, "type"));
    const auto* row = std::find_if(std::begin(kTypes), std::end(kTypes),
                                   [&](const auto& one) { return one.first == type; });
    if (row != std::end(kTypes)) {
      joint.type = row->second;
    } else if (!type.empty()) {
      std::vector<std::string_view> names;
      for (const auto& one : kTypes) names.push_back(one.first);
      const auto near = reporter_.context().sink.suggest(type, names);
      reporter_.refuse(element.attribute("type")->value_span(),
                       quoted(type) + " is no type of a joint",
                       near ? "did you mean " + quoted(*near) + "?"
                            : "write `revolute`, `prismatic`, `fixed` or another known type");
    }
    const auto parent = end(joint, "parent", joint.parent_name);
    const auto child = end(joint, "child", joint.child_name);
    joint.X_W = model_.X_W * frames_.in_world(*joint.vertex);
    if (!parent || !child) {
      joint.type = Joint::Type::gearbox;  // holds nothing; the mistake has been reported
      is_broken_.insert(&joint);
      joint.child = joint.parent = {};
      return;
    }
    joint.parent = *parent;
    joint.child = *child;
    if (*parent == *child) {
      reporter_.refuse(element.child("child").text_span(),
                       "parent and child of " + quoted(joint.vertex->name) + " are one link",
                       "name two links");
      return;
    }
    // The frame of a child may be any, so the one of its link decides.
    joint.is_at_child = joint.is_at_child && Frames::find(*joint.vertex->scope, joint.child_name) ==
                                                 model_.links[*joint.child.link].vertex;
    axis(joint, "axis", joint.axes[0]);
    axis(joint, "axis2", joint.axes[1]);
    if (joint.type == Joint::Type::screw) pitch(joint);
  }

  /// A screw of 1.10 moves by `screw_thread_pitch` metres a turn; `thread_pitch` is minus the
  /// radians for each metre.
  static void pitch(Joint& joint) {
    const View element = joint.vertex->element;
    if (element.child("screw_thread_pitch")) {
      joint.travel = number_in(element, "screw_thread_pitch", 1) / kTwoPi;
    } else {
      const double turns = number_in(element, "thread_pitch", 1);
      joint.travel = turns != 0 ? -1 / turns : 0;
    }
  }

  void axis(Joint& joint, std::string_view name, Axis& axis) {
    const View element = joint.vertex->element.child(name);
    axis.element = element;
    if (!element) return;
    const View limit = element.child("limit");
    axis.lower = number_in(limit, "lower", -kUnlimited);
    axis.upper = number_in(limit, "upper", kUnlimited);
    const auto bound = [&](std::string_view of) {
      const double value = number_in(limit, of, -1);
      return value < 0 || !(value < kUnlimited) ? kUnlimited : value;
    };
    axis.effort = bound("effort");
    axis.velocity = bound("velocity");
    const View dynamics = element.child("dynamics");
    axis.damping = number_in(dynamics, "damping", 0);
    axis.friction = number_in(dynamics, "friction", 0);
    direction(joint, element, axis);
  }

  void direction(const Joint& joint, View element, Axis& axis) {
    const View xyz = element.child("xyz");
    const int version = joint.vertex->scope->file->version;
    const bool is_in_model =
        version <= 4 || (version <= 6 && truth_in(element, "use_parent_model_frame", false));
    if (!xyz && is_in_model) {
      reporter_.refuse(element.name_span(), "an axis in the frame of the model needs `<xyz>`",
                       "write a direction such as `0 0 1`");
      return;
    }
    Vector3 v = vector_in(element, "xyz", {0, 0, 1});
    const double length = hypotenuse(v[0], v[1], v[2]);
    constexpr double kLeast = 1e-6;  // libsdformat compares the length with zero by this tolerance
    if (!(length > kLeast)) {
      reporter_.refuse(text_of(xyz).empty() ? xyz.name_span() : xyz.text_span(),
                       "the axis of " + quoted(joint.vertex->name) + " has no direction",
                       "write a direction such as `0 0 1`");
      return;
    }
    for (double& one : v) one /= length;
    const Attribute* written = xyz ? xyz.attribute("expressed_in") : nullptr;
    std::string_view frame = attribute_of(xyz, "expressed_in");  // "": that of the joint
    if (is_in_model) frame = "__model__";
    if (!frame.empty()) {
      const Span place = written != nullptr ? written->value_span() : Span{};
      Scope& scope = *joint.vertex->scope;
      if (const auto X_SF = frames_.express_late(scope, frame, place)) {
        const Pose X_JF = inverse(frames_.in_scope(*joint.vertex)) * *X_SF;
        v = rotate(X_JF.orientation, v);
      }
    }
    axis.xyz = v;
  }

  Model& model_;
  Reporter& reporter_;
  Frames frames_;
  std::set<const Joint*> is_broken_;
};

class Arranger {
 public:
  Arranger(Model& model, Reporter& reporter) : model_(model), reporter_(reporter) {}

  void run() {
    holder_.assign(model_.links.size(), nullptr);
    for (LinkIndex i = 0; i < model_.links.size(); ++i) above_.push_back(i);
    for (Joint& joint : model_.joints) {
      if (!joint.child.link || joint.parent == joint.child) continue;
      if (joint.type == Joint::Type::gearbox) {
        lost(joint, "a URDF has no gearbox, so this joint is lost",
             "let one joint mimic the other");
        continue;
      }
      Joint*& holder = holder_[*joint.child.link];
      if (holder != nullptr || closes_loop(joint)) {
        joint.closes_loop = joint.parent.link && is_one_of_gazebo(joint);
        if (joint.closes_loop) continue;
        lost(joint, "a URDF is a tree, and " + quoted(joint.name) + " closes a loop, so it is lost",
             "keep the SDF for simulators that need it");
        continue;
      }
      holder = &joint;
      joint.is_in_tree = true;
      if (joint.parent.link) above_[*joint.child.link] = *joint.parent.link;
    }
  }

 private:
  /// The link at the top of a tree. Paths are shortened, so that a long chain takes no longer.
  LinkIndex top_of(LinkIndex at) {
    while (above_[at] != at) at = above_[at] = above_[above_[at]];
    return at;
  }

  /// The child has no holder, so it is at the top of its own tree.
  bool closes_loop(const Joint& joint) {
    return joint.parent.link && top_of(*joint.parent.link) == *joint.child.link;
  }

  static bool is_one_of_gazebo(const Joint& joint) {
    return joint.type == Joint::Type::fixed || joint.type == Joint::Type::revolute ||
           joint.type == Joint::Type::continuous || joint.type == Joint::Type::ball;
  }

  void lost(const Joint& joint, std::string message, std::string help) {
    reporter_
        .report(rules::sml9304_lost_in_urdf, joint.vertex->element.name_span(), std::move(message))
        .help(std::move(help));
  }

  Model& model_;
  Reporter& reporter_;
  std::vector<Joint*> holder_;
  std::vector<LinkIndex> above_;
};

}  // namespace

void resolve(Model& model, Reporter& reporter) { Resolver(model, reporter).run(); }

void arrange(Model& model, Reporter& reporter) { Arranger(model, reporter).run(); }

}  // namespace smurf::sdformat
