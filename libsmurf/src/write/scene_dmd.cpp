// SPDX-License-Identifier: BSD-3-Clause
// Drake model directives. Rotations are an angle and an axis, because Drake does not read
// quaternions (common/schema/rotation.h).
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"
#include "base/numbers/exact_math.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/counted.hpp"
#include "write/losses/scene_losses.hpp"
#include "write/parts/scene_parts.hpp"
#include "write/text/json_text.hpp"

namespace smurf::scene_dmd_file {
namespace {

/// A flow scalar that YAML and Drake read as this text.
std::string quoted(std::string_view text) {
  std::string quoted;
  append_json(quoted, text);
  return quoted;
}

std::string list(const Vector3& v) {
  return "[" + format_number(v[0]) + ", " + format_number(v[1]) + ", " + format_number(v[2]) + "]";
}

std::string rotation(const Quaternion& q) {
  const double sine = hypotenuse(q.x, q.y, q.z);
  if (sine == 0) return "!Identity {}";
  const double degrees = 2 * arc_tangent(sine, q.w) * 180 / std::numbers::pi;
  return "!AngleAxis {angle_deg: " + format_number(degrees) +
         ", axis: " + list({q.x / sine, q.y / sine, q.z / sine}) + "}";
}

class DirectivesWriter {
 public:
  explicit DirectivesWriter(const SceneExport& scene)
      : scene_(scene),
        losses_(scene, SceneColumn::dmd, "Drake directives"),
        names_(safe_names(scene.flat)) {}

  std::string run() {
    for (std::size_t i = 0; i < scene_.flat.instances.size(); ++i) {
      if (is_written(i)) add_model(i);
    }
    // A weld names two models, which must already be added.
    for (std::size_t i = 0; i < scene_.flat.instances.size(); ++i) {
      if (is_written_[i]) add_weld(i);
    }
    for (std::size_t i = 0; i < scene_.flat.instances.size(); ++i) {
      if (is_written_[i]) add_filters(i);
    }
    const std::string_view start = "# The package `scene` is the folder of this file: "
                                   "parser.package_map().Add(\"scene\", \"FOLDER\")\n";
    out_.insert(0, std::string(start) + (out_.empty() ? "directives: []\n" : "directives:\n"));
    losses_.table();
    losses_.files_in_archives();
    return std::move(out_);
  }

 private:
  const FlatInstance& flat(std::size_t i) const { return scene_.flat.instances[i]; }
  const LinkedModel* robot_of(std::size_t i) const { return smurf::robot_of(scene_.scene, i); }
  std::string root_name(std::size_t i) const { return root_link_name(*robot_of(i)); }

  /// In Drake, a link called `world` is the world itself (detail_urdf_parser.cc:203, 518), which
  /// cannot be placed.
  bool is_world(std::size_t i) const { return root_name(i) == "world"; }

  bool is_written(std::size_t i) {
    if (!flat(i).X_WE) return false;
    const LinkedModel* model = robot_of(i);
    if (model == nullptr) {
      losses_.entity(i, "directives add model files only");
    } else if (model->link_names.contains("world") &&
               (!is_world(i) || *flat(i).X_WE != Pose{} ||
                flat(i).anchor.kind != Attachment::Kind::world)) {
      losses_.entity(
          i, "Drake treats its link `world` as the world, which cannot be moved or free; give the "
             "link another name");
    } else {
      is_written_[i] = true;
    }
    return is_written_[i];
  }

  void add_pose(const Pose& pose, std::string_view indent) {
    out_ += std::string(indent) + "translation: " + list(pose.position) + "\n" +
            std::string(indent) + "rotation: " + rotation(pose.orientation) + "\n";
  }

  void add_model(std::size_t i) {
    out_ += "- add_model:\n    name: " + quoted(names_[i]) +
            "\n    file: " + quoted("package://scene/" + scene_.flat.models[*flat(i).model].urdf) +
            "\n";
    add_joint_positions(i);
    if (flat(i).anchor.kind != Attachment::Kind::none) return;
    out_ += "    default_free_body_pose:\n      " + quoted(root_name(i)) + ":\n";
    add_pose(*flat(i).X_WE, "        ");
  }

  void add_joint_positions(std::size_t i) {
    auto positions = flat(i).joint_positions;
    // Drake does not compute the default position of a follower from that of its leader.
    const LinkedModel& model = *robot_of(i);
    const JointPositions& given = scene_.joint_positions(i);
    for (const urdf::Joint& joint : model.robot->joints) {
      if (!joint.mimic || !joint.name) continue;
      const double position = start_position(model, joint, given);
      const bool is_known = std::any_of(positions.begin(), positions.end(), [&](const auto& known) {
        return known.first == *joint.name;
      });
      if (position != 0 && !is_known) positions.emplace_back(*joint.name, position);
    }
    if (positions.empty()) return;
    out_ += "    default_joint_positions:\n";
    for (const auto& [joint, position] : positions) {
      out_ += "      " + quoted(joint) + ": [" + format_number(position) + "]\n";
    }
  }

  void add_weld(std::size_t i) {
    const FlatAttachment& anchor = flat(i).anchor;
    if (anchor.kind == Attachment::Kind::none || is_world(i)) return;
    for (const std::string& link : {anchor.link, root_name(i)}) {
      if (is_nameable(link)) continue;
      return losses_.anchor(i, "in Drake directives, `::` in the name of the link `" + link +
                                   "` ends the name of a model");
    }
    std::string parent = "world";
    Pose X_PC = *flat(i).X_WE;
    if (anchor.kind == Attachment::Kind::link) {
      const std::size_t other = anchor.index;
      const std::optional<Pose> X_LE = pose_on_anchor(scene_, i, frames_);
      if (!X_LE || !is_written_[other]) {
        return losses_.anchor(i, "`" + flat(other).path + "` is not a model with links");
      }
      if (anchor.link != "world") parent = names_[other] + "::" + anchor.link;
      X_PC = *X_LE;
    }
    out_ += "- add_weld:\n    parent: " + quoted(parent) +
            "\n    child: " + quoted(names_[i] + "::" + root_name(i)) + "\n    X_PC:\n";
    add_pose(X_PC, "      ");
  }

  /// For Drake, what stands before the last `::` of a name is the name of a model.
  static bool is_nameable(std::string_view link) {
    return link.find("::") == std::string_view::npos;
  }

  void report_unnamed(const LinkedModel& model, const std::string& what) {
    if (!reported_.insert(&model).second) return;
    scene_.losses.report(rules::sml8211_lost_part, {model.robot->document.source, 0, 0},
                         what + " of `" + model.path +
                             "` can touch in the Drake directives, in which `::` in the name of a "
                             "link ends the name of a model");
  }

  /// A group for each link that must not touch others, or one that ignores itself.
  void add_filters(std::size_t i) {
    const LinkedModel& model = *robot_of(i);
    const auto link = [&](std::size_t at) {
      return quoted(names_[i] + "::" + link_name(model, at));
    };
    const auto group = [&](std::size_t at) {
      return names_[i] + "_contacts_of_" + link_name(model, at);
    };
    const auto add = [&](const std::string& name, const std::string& members,
                         const std::string& ignored) {
      out_ += "- add_collision_filter_group:\n    name: " + quoted(name) + "\n    members: [" +
              members + "]\n    ignored_collision_filter_groups: [" + ignored + "]\n";
    };
    if (scene_.contacts.choice == SelfCollision::none) {
      std::string members;
      std::size_t lost = 0;
      for (const LinkIndex one : model.tree.order) {
        if (!is_nameable(link_name(model, to_size(one)))) {
          ++lost;
          continue;
        }
        members += (members.empty() ? "" : ", ") + link(to_size(one));
      }
      if (lost > 0) report_unnamed(model, counted(lost, "link"));
      const std::string name = names_[i] + "_contacts";
      return add(name, members, quoted(name));
    }
    const auto pairs = scene_.contacts.left_out.find(&model);
    if (pairs == scene_.contacts.left_out.end()) return;
    std::map<std::size_t, std::string> ignored;  // by link; Drake needs one direction only
    std::size_t lost = 0;
    for (const auto& [a, b] : pairs->second) {
      if (!is_nameable(link_name(model, a)) || !is_nameable(link_name(model, b))) {
        ++lost;
        continue;
      }
      std::string& names = ignored[a];
      names += (names.empty() ? "" : ", ") + quoted(group(b));
      ignored.try_emplace(b);
    }
    for (const auto& [at, names] : ignored) add(group(at), link(at), names);
    if (lost > 0) report_unnamed(model, counted(lost, "pair") + " of links");
  }

  const SceneExport& scene_;
  SceneLosses losses_;
  std::vector<std::string> names_;
  std::vector<bool> is_written_ = std::vector<bool>(scene_.flat.instances.size());
  LinkFrames frames_;
  std::set<const LinkedModel*> reported_;
  std::string out_;
};

}  // namespace

extern constinit const SceneFormat scene_dmd{
    .name = "dmd",
    .help = "Drake model directives",
    .write = [](const SceneExport& scene) { return DirectivesWriter(scene).run(); },
    .remark = "Drake finds the models with parser.package_map().Add(\"scene\", \"FOLDER\")",
    .reader = &readers::drake,
    .has_reference_form = true,
    .has_expanded_form = false,
    .has_contacts = true,
    .has_link_pairs = true,
    .usual_contacts = SelfCollision::srdf,
    .has_collisions = true,
    .fixes_world_roots = true};

}  // namespace smurf::scene_dmd_file
