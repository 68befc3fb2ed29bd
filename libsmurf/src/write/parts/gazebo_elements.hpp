// SPDX-License-Identifier: BSD-3-Clause
// The contents of the <gazebo> elements of a URDF as SDF, with the names and places that
// libsdformat 12 gives them when it converts the URDF (parser_urdf.cc).
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/text/unique_names.hpp"
#include "smurf/linked.hpp"
#include "write/text/xml_text.hpp"

namespace smurf {

/// Whether a child of <gazebo> is converted. It is not if its link or joint does not exist, or if
/// it is a sensor or plug-in without a name, which SDF refuses.
bool is_taken_by_gazebo(const LinkedModel& model, xml::View child);

/// The spring of a joint in `<gazebo>`; the last value applies, as in libsdformat.
struct JointSpring {
  double stiffness = 0;  ///< N m/rad or N/m
  double reference = 0;  ///< rad or m, where it rests
};
/// Whether a child of <gazebo> is a value of such a spring.
bool is_of_spring(const LinkedModel& model, xml::View child);
/// By name of the joint.
std::map<std::string_view, JointSpring> springs_of(const LinkedModel& model);

/// Whether the model says that its links can touch each other.
bool touches_itself(const LinkedModel& model);

/// The plug-ins in a sensor that SDF refuses, because they name no file.
std::vector<xml::View> broken_plugins(xml::View sensor);

class GazeboElements {
 public:
  /// `source` is the text of the URDF.
  GazeboElements(const LinkedModel& model, std::string_view source);

  bool empty() const { return by_reference_.empty(); }
  /// Replaces the text of an element below a child of <gazebo>.
  void set_text(xml::View element, std::string text) {
    texts_[element.id()].push_back({element.text_span(), std::move(text)});
  }
  /// Makes an element belong to another link.
  void move(xml::ElementId element, std::string_view from, const std::string& to);

  /// Leaves out what the elements say about contacts within the model.
  void leave_out_own_contacts() { has_own_contacts_ = false; }

  /// The contents of <model>.
  void add_to_model(XmlText& xml) const;
  /// The elements for the <link> that contains `part`. If `part` is a frame of that link, `frame`
  /// is its name and `X_BL` its pose in the link. `names` are those of the link's sensors.
  void add_to_link(XmlText& xml, std::string_view part, std::string_view frame, const Pose& X_BL,
                   UniqueNames& names) const;
  void add_to_collision(XmlText& xml, std::string_view link) const;
  bool has_contact(std::string_view link) const {
    return has_any(link, {"kp", "kd", "maxVel", "minDepth"});
  }
  bool has_friction(std::string_view link) const { return has_any(link, {"mu1", "mu2", "fdir1"}); }
  /// Inside <surface><contact>, and inside <surface><friction><ode>.
  void add_contact(XmlText& xml, std::string_view link) const;
  void add_friction(XmlText& xml, std::string_view link) const;
  /// Settings other than the material, which is a colour or a material of Gazebo Classic.
  void add_to_visual(XmlText& xml, std::string_view link) const;
  /// Whether the elements contained a material.
  bool has_own_material(std::string_view link) const;
  /// A material of Gazebo Classic, such as "Gazebo/Red"; "" if there is none.
  std::string_view material(std::string_view link) const { return value(link, "material"); }
  bool has_spring(std::string_view joint) const {
    return has_any(joint, {"springReference", "springStiffness"});
  }
  /// Inside <axis><dynamics>, and after <axis>.
  void add_to_dynamics(XmlText& xml, std::string_view joint) const;
  void add_to_joint(XmlText& xml, std::string_view joint, UniqueNames& names) const;

 private:
  /// The settings of one link or joint, or of the model.
  struct Part {
    std::vector<xml::View> elements;
    /// By name of the element. The last one applies, as in libsdformat.
    std::map<std::string_view, std::string_view> values;
    std::vector<xml::View> visuals, collisions;
    bool has_material = false;
  };

  const Part& part_of(std::string_view reference) const;
  const std::vector<xml::View>& of(std::string_view reference) const {
    return part_of(reference).elements;
  }
  std::string_view value(std::string_view reference, std::string_view name) const;
  bool has_any(std::string_view reference, std::initializer_list<std::string_view> names) const;
  void add_children(XmlText& xml, xml::View blob) const;
  void leaf(XmlText& xml, std::string_view reference, std::string_view name,
            std::string_view written_as) const;
  void add_raw(XmlText& xml, xml::View element, std::string_view frame, const Pose& X_BL,
               UniqueNames& names) const;

  const LinkedModel& model_;
  std::string_view source_;
  bool has_own_contacts_ = true;
  std::map<xml::ElementId, std::vector<std::pair<Span, std::string>>> texts_;
  std::map<std::string, Part, std::less<>> by_reference_;  ///< "": the model
};

}  // namespace smurf
