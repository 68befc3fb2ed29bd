// SPDX-License-Identifier: BSD-3-Clause
// Finds the YAML pointer or XPath of a byte span: rules report spans, users and programs also need
// names of places.
#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "base/quoted.hpp"
#include "base/readers.hpp"
#include "base/rules.hpp"
#include "base/uncertain.hpp"
#include "link/mujoco_compiler.hpp"
#include "lint/rigid_bodies.hpp"
#include "smurf/lint.hpp"
#include "smurf/lint_companions.hpp"

namespace smurf {
namespace {

std::string pointer_in(const xml::Document& document, xml::XPaths& paths, Span span) {
  const xml::ElementId id = xml::element_at(document, span.begin);
  if (id == xml::kNoElement) return {};
  std::string path = paths.find(id);
  const xml::View element(document, id);
  for (const xml::Attribute& attribute : element.attributes()) {
    if (span.begin < attribute.span().begin || attribute.span().end < span.end) continue;
    constexpr std::size_t kLongestName = 200;
    return path + "/@" + shortened(attribute.name(), kLongestName);
  }
  return path;
}

void point(Diagnostic& diagnostic, const yaml::Document& document) {
  const yaml::NodeId id = yaml::node_at(document, diagnostic.span.begin);
  if (id == yaml::kNoNode) return;
  if (diagnostic.pointer.empty()) diagnostic.pointer = yaml::pointer(document, id);
  diagnostic.named_pointer = yaml::named_pointer(document, id);
}

void point(Diagnostic& diagnostic, const xml::Document& document, xml::XPaths& paths) {
  if (diagnostic.pointer.empty()) {
    diagnostic.pointer = pointer_in(document, paths, diagnostic.span);
  }
  diagnostic.named_pointer = diagnostic.pointer;
}

/// Findings without a location, by their source: a scene may have thousands of both.
class BySource {
 public:
  explicit BySource(std::span<Diagnostic> diagnostics) {
    for (Diagnostic& diagnostic : diagnostics) {
      if (diagnostic.named_pointer.empty()) found_[diagnostic.span.source].push_back(&diagnostic);
    }
  }

  /// Only once, because models may share a file.
  std::vector<Diagnostic*> take(SourceId source) {
    const auto found = found_.extract(source);
    return found ? std::move(found.mapped()) : std::vector<Diagnostic*>();
  }

 private:
  std::unordered_map<SourceId, std::vector<Diagnostic*>> found_;
};

/// Extends the construct of the findings at such places.
void mark(std::string_view place, std::string_view construct, std::span<Diagnostic* const> found) {
  for (Diagnostic* diagnostic : found) {
    if (diagnostic->pointer.find(place) != std::string::npos) diagnostic->construct += construct;
  }
}

/// The part whose span contains the byte at `place`; null if there is none. The parts are in the
/// order of the file and do not overlap.
template <class Part>
const Part* part_at(const std::vector<Part>& parts, std::uint32_t place) {
  const auto next = std::partition_point(
      parts.begin(), parts.end(), [&](const Part& part) { return part.span.begin <= place; });
  if (next == parts.begin()) return nullptr;
  const Part& part = *std::prev(next);
  return place < part.span.end ? &part : nullptr;
}

/// Whether the link moves only together with the body to which it is fixed, or not at all.
bool is_carried(const LinkedModel& model, std::size_t link) {
  const auto above = model.tree.parent_joint[link];
  return !above || model.joint(*above).type == urdf::JointType::fixed;
}

/// Effects on readers depend on motion and on the type of the joint. So inertials get the construct
/// "#of-world", "#carried", "#carried#still" or, if the link moves by itself,
/// "#alone/inertia/@ixx/"; parts of joints get "#in-fixed/limit/@lower/".
void mark_motion(const LinkedModel& model, std::span<Diagnostic* const> found) {
  std::vector<bool> alone, still;  // by link; computed when they are needed
  for (Diagnostic* diagnostic : found) {
    constexpr std::string_view kJoint = "/robot/joint/";
    constexpr std::string_view kInertial = "/robot/link/inertial/";
    const std::string path = fact_path(*diagnostic);
    if (path.starts_with(kInertial)) {
      const urdf::Link* link = part_at(model.robot->links, diagnostic->span.begin);
      if (link == nullptr) continue;
      // MuJoCo does not use the inertia of the world, but refuses it without positive moments.
      const bool is_refused = diagnostic->rule == &rules::sml1512_not_positive_definite;
      if (link->name.value_or("") == "world" && !is_refused) diagnostic->construct += "#of-world";
      const auto index = static_cast<std::size_t>(link - model.robot->links.data());
      const auto is_alone = [&] {
        if (alone.empty()) alone = alone_in_motion(model);
        return alone[index];
      };
      // sdformat adds the masses of links that are fixed to each other.
      const bool is_added = path == "/robot/link/inertial/mass/@value/#too-large" && !is_alone();
      if (is_added) mark_uncertain(*diagnostic);
      if (is_carried(model, index)) {
        if (still.empty()) still = fixed_to_root(model);
        diagnostic->construct += still[index] ? "#carried#still" : "#carried";
        continue;
      }
      if (is_alone()) {
        const std::size_t end = std::min(path.find('#'), path.size());
        diagnostic->construct += "#alone/" + path.substr(kInertial.size(), end - kInertial.size());
      }
    } else if (path.starts_with(kJoint)) {
      const urdf::Joint* joint = part_at(model.robot->joints, diagnostic->span.begin);
      if (joint == nullptr || joint->type == urdf::JointType::unknown) continue;
      const std::size_t end = std::min(path.find('#'), path.size());
      diagnostic->construct +=
          "#in-" + *joint->type_name + "/" + path.substr(kJoint.size(), end - kJoint.size());
    }
  }
}

/// Joints to links that sdformat drops, names of links that it drops or merges, and numbers that it
/// computes with because it merges links.
class SdformatMarks {
 public:
  explicit SdformatMarks(const LinkedModel& model)
      : model_(model),
        links_(links_of_sdformat(model)),
        count_(links_.size(), 0),
        is_dropped_(links_.size()) {
    for (const auto& top : links_) {
      if (top) ++count_[to_size(*top)];
    }
    for (const LinkIndex link : model.tree.order) {  // not those in a ring, at which it crashes
      const std::size_t i = to_size(link);
      is_dropped_[i] = !links_[i] && model.link(link).name.value_or("") != "world";
    }
  }

  /// Whether sdformat drops every link. Another rule reports that.
  bool is_empty() const {
    return std::none_of(links_.begin(), links_.end(),
                        [](const auto& top) { return top.has_value(); });
  }

  void mark(Diagnostic& diagnostic) {
    const std::string path = fact_path(diagnostic);
    if (path.starts_with("/robot/joint/")) {
      const urdf::Joint* joint = part_at(model_.robot->joints, diagnostic.span.begin);
      if (joint != nullptr) mark_joint(index_in(model_.robot->joints, *joint), path, diagnostic);
    } else if (path.starts_with("/robot/link/")) {
      const urdf::Link* link = part_at(model_.robot->links, diagnostic.span.begin);
      if (link != nullptr) mark_link(index_in(model_.robot->links, *link), path, diagnostic);
    }
  }

 private:
  template <class Part>
  static std::size_t index_in(const std::vector<Part>& parts, const Part& part) {
    return static_cast<std::size_t>(&part - parts.data());
  }

  static void drop(Diagnostic& diagnostic) {
    diagnostic.construct.append(kDroppedBy).append(readers::gazebo.name);
  }

  void mark_joint(std::size_t index, const std::string& path, Diagnostic& diagnostic) const {
    const auto child = model_.tree.joint_child[index];
    if (!child) return;
    const auto above = model_.tree.parent_joint[to_size(*child)];
    if (is_dropped_[to_size(*child)] && above && to_size(*above) == index) drop(diagnostic);
    mark_number(to_size(*child), path, diagnostic);
  }

  void mark_link(std::size_t link, const std::string& path, Diagnostic& diagnostic) {
    const bool is_merged = links_[link] && to_size(*links_[link]) != link;
    const bool is_about_name = diagnostic.rule == &rules::sml1307_reserved_name;
    if (is_about_name && (is_merged || is_dropped_[link])) drop(diagnostic);
    if (path.starts_with("/robot/link/inertial/inertia/")) {
      if (near_zero_.empty()) near_zero_ = near_zero_together(model_);
      if (near_zero_[link]) mark_uncertain(diagnostic);
    }
    mark_number(link, path, diagnostic);
  }

  /// sdformat computes with such a number. Whether it can read the result depends on the other
  /// numbers.
  void mark_number(std::size_t link, const std::string& path, Diagnostic& diagnostic) const {
    if (path.find("/#subnormal") == std::string::npos) return;
    const bool is_moved = path.find("/origin/@xyz/") != std::string::npos ||
                          path.find("/inertia/") != std::string::npos;
    const bool is_rotated = path.find("/origin/@rpy/") != std::string::npos;
    const bool is_joined = links_[link] && count_[to_size(*links_[link])] > 1;
    if (is_rotated || (is_moved && is_joined)) mark_uncertain(diagnostic);
  }

  const LinkedModel& model_;
  std::vector<std::optional<LinkIndex>> links_;
  std::vector<std::size_t> count_;  ///< of links that become one, by the topmost
  std::vector<bool> is_dropped_;
  std::vector<bool> near_zero_;  ///< by link; computed when it is needed
};

void mark_for_sdformat(const LinkedModel& model, std::span<Diagnostic* const> found) {
  SdformatMarks marks(model);
  if (marks.is_empty()) return;
  for (Diagnostic* diagnostic : found) marks.mark(*diagnostic);
}

constexpr std::string_view kDrakeIgnored = "#drake-ignored";

/// Marks findings in links and joints with `drake_ignore="true"`, which Drake skips.
void mark_ignored(const xml::Document& document, std::span<Diagnostic* const> found) {
  std::vector<Span> ignored;  // in the order of the file
  for (const xml::View element : document.view()) {
    const xml::Attribute* mark = element.attribute("drake_ignore");
    if (mark != nullptr && mark->value() == "true") ignored.push_back(element.span());
  }
  if (ignored.empty()) return;
  for (Diagnostic* diagnostic : found) {
    const std::uint32_t begin = diagnostic->span.begin;
    const auto behind =
        std::upper_bound(ignored.begin(), ignored.end(), begin,
                         [](std::uint32_t place, const Span& span) { return place < span.begin; });
    if (behind == ignored.begin() || begin >= std::prev(behind)->end) continue;
    diagnostic->construct += kDrakeIgnored;
  }
}

/// A fault of YAML matters more in the file that lists the others, even if it has no tree.
void locate_in(const std::optional<yaml::Document>& document, SourceId source,
               std::string_view kind, BySource& found) {
  for (Diagnostic* diagnostic : found.take(source)) {
    if (document) point(*diagnostic, *document);
    const std::string_view id = diagnostic->rule->id;
    if (!id.starts_with("SML00") && id != "SML2011") continue;
    if (!diagnostic->construct.empty()) diagnostic->construct += '#';
    diagnostic->construct += kind;
  }
}

std::vector<Diagnostic*> locate_in(const xml::Document& document, BySource& all) {
  xml::XPaths paths(document);
  std::vector<Diagnostic*> found = all.take(document.source);
  for (Diagnostic* diagnostic : found) point(*diagnostic, document, paths);
  return found;
}

void locate_in(const LinkedModel& model, BySource& all) {
  for (const ModelFile& file : model.files) {
    if (file.kind == ModelFile::Kind::urdf) continue;
    locate_in(file.document, file.source,
              file.kind == ModelFile::Kind::main ? "main" : "in-annotations", all);
  }
  if (!model.robot) return;
  const std::vector<Diagnostic*> found = locate_in(model.robot->document, all);
  if (found.empty()) return;
  mark_motion(model, found);
  mark_for_sdformat(model, found);
  if (balances_inertias(model)) mark("/inertia", kBalanced, found);
  if (keeps_visuals(model)) mark("/visual", kVisualsKept, found);
  if (is_told_where_meshes_are(model)) mark("/mesh/@filename", kElsewhere, found);
  mark_ignored(model.robot->document, found);
}

}  // namespace

void locate(const LinkedModel& model, std::span<Diagnostic> diagnostics) {
  BySource found(diagnostics);
  locate_in(model, found);
}

void locate(const Companions& companions, std::span<Diagnostic> diagnostics) {
  BySource found(diagnostics);
  for (const Companion& one : companions.files) {
    if (one.srdf) locate_in(one.srdf->document, found);
    if (one.document) locate_in(one.document, one.source, "in-companion", found);
  }
}

void locate(const LinkedScene& scene, std::span<Diagnostic> diagnostics) {
  BySource found(diagnostics);
  for (const SceneFile& file : scene.scenes) {
    if (file.drawing) {
      locate_in(*file.drawing, found);
    } else {
      locate_in(file.document, file.source, "scene", found);
    }
  }
  for (const DataFile& file : scene.data_files) {
    for (Diagnostic* diagnostic : found.take(file.document.source)) {
      point(*diagnostic, file.document);
    }
  }
  for (const LinkedModel& model : scene.models) locate_in(model, found);
}

}  // namespace smurf
