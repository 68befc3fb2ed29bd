// SPDX-License-Identifier: BSD-3-Clause
// Converts sensors of Gazebo, ros2_control and old URDFs to sensors of MARS. MARS stops loading at
// an unknown type, so sensors without a counterpart get no entry.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "base/numbers/exact_math.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/edits.hpp"
#include "base/text/unique_names.hpp"
#include "convert/gazebo_sensors.hpp"
#include "convert/import.hpp"
#include "link/gazebo_names.hpp"

namespace smurf::import {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

NewValue orientation_value(const std::string& key, const Quaternion& q) {
  return numbers_value(key, {{"w", q.w}, {"x", q.x}, {"y", q.y}, {"z", q.z}});
}

/// A field that is an element with text (SDF) or an attribute (URDF).
std::optional<double> field(xml::View element, std::string_view name) {
  if (!element) return std::nullopt;
  if (const auto number = parse_number(child_text(element, name))) return number;
  return parse_number(attribute_of(element, name));
}

class SensorMaker {
 public:
  explicit SensorMaker(Context& context) : context_(context) {
    for (const urdf::Link& link : context.robot().links) {
      if (link.name) geometry_names_.take(*link.name);
      for (const urdf::Visual& visual : link.visuals) {
        if (visual.name) geometry_names_.take(*visual.name);
      }
      for (const urdf::Collision& collision : link.collisions) {
        if (collision.name) geometry_names_.take(*collision.name);
      }
    }
  }

  std::vector<NewValue> make() {
    for (const xml::View system : extensions_of(context_, "ros2_control")) ros2_control(system);
    add_joint_sensors();
    for (const GazeboSensor& found : gazebo_sensors(context_.robot())) {
      sensor(found.element, found.reference);
    }
    for (const xml::View child : extensions_of(context_, "sensor")) {
      sensor(child, attribute_of(child.child("parent"), "link"));
    }
    rename_contacts();
    return std::move(entries_);
  }

 private:
  void add(const std::string& name, const std::string& comment, std::vector<NewValue> members) {
    NewValue entry = mapping_value({}, {text_value("name", names_.add(name))});
    for (NewValue& member : members) entry.children.push_back(std::move(member));
    entry.comment = comment;
    entries_.push_back(std::move(entry));
  }

  // ros2_control: one sensor per quantity for all joints that provide it.
  struct JointQuantity {
    std::string_view interface;
    const char* name;
    const char* type;
    std::vector<NewValue> joints{};
    std::string link{};
    std::string place{};
  };

  void ros2_control(xml::View system) {
    for (const xml::View child : system) {
      if (child.name() == "joint") joint_states(child);
      if (child.name() == "sensor") ros2_sensor(child);
    }
  }

  /// Phobos stops at sensor types that it does not know.
  bool is_known_to_style(const JointQuantity& quantity) const {
    return context_.options.style != SmurfStyle::phobos || quantity.interface != "effort";
  }

  void joint_states(xml::View element) {
    const urdf::Joint* found = context_.model.find_joint(attribute_of(element, "name"));
    if (found == nullptr || !found->has_one_axis()) return;
    const urdf::Joint& joint = *found;
    for (const xml::View child : element) {
      if (child.name() != "state_interface") continue;
      for (JointQuantity& quantity : quantities_) {
        if (attribute_of(child, "name") != quantity.interface) continue;
        if (!is_known_to_style(quantity)) {
          context_.keep_as_text(child.name_span(), "the effort of the joint `" + *joint.name + "`",
                                "Phobos has no sensor of this kind");
          continue;
        }
        if (quantity.joints.empty()) {
          quantity.link = joint.child.value_or("");
          quantity.place = context_.line_of(child.span());
        }
        quantity.joints.push_back(text_value({}, *joint.name));
      }
    }
  }

  void add_joint_sensors() {
    for (JointQuantity& quantity : quantities_) {
      if (quantity.joints.empty()) continue;
      add(quantity.name, "from ros2_control, " + quantity.place + " and after",
          {text_value("type", quantity.type), text_value("link", quantity.link),
           list_value("id", std::move(quantity.joints))});
    }
  }

  void ros2_sensor(xml::View element) {
    const std::string name(attribute_of(element, "name"));
    const std::string what = "the sensor `" + name + "`";
    std::string frame;
    bool has_force = false;
    bool has_orientation = false;
    for (const xml::View child : element) {
      const std::string_view id = attribute_of(child, "name");
      if (child.name() == "param" && id == "frame_id") frame = text_of(child);
      has_force = has_force || id.starts_with("force.") || id.starts_with("torque.");
      has_orientation = has_orientation || id.starts_with("orientation.") ||
                        id.starts_with("angular_velocity.") || id.starts_with("linear_accel");
    }
    const std::string comment = "from ros2_control, " + context_.line_of(element.span());
    if (!context_.model.link_names.contains(frame)) {
      context_.keep_as_text(element.name_span(), what, "no link `" + frame + "` carries it");
    } else if (has_orientation) {
      add(name, comment, imu(frame));
    } else if (has_force && parent_joint(frame) != nullptr) {
      add(name, comment, force_torque(*parent_joint(frame)));
    } else {
      context_.keep_as_text(element.name_span(), what, "MARS has no sensor of this kind");
    }
  }

  const urdf::Joint* parent_joint(std::string_view link) const {
    const auto index = context_.model.link_names.find(link);
    if (!index || !context_.model.tree.parent_joint[*index]) return nullptr;
    return &context_.model.joint(*context_.model.tree.parent_joint[*index]);
  }

  /// A <sensor> of Gazebo, or of an old URDF.
  void sensor(xml::View element, std::string_view carrier) {
    std::string type(attribute_of(element, "type"));
    if (type.empty()) {
      for (const char* kind : {"camera", "ray"}) {
        if (element.child(kind)) type = kind;
      }
    }
    std::string name(attribute_of(element, "name"));
    if (name.empty()) name = std::string(carrier) + "_" + type;
    std::string problem;
    auto members = members_of(element, type, std::string(carrier), problem);
    if (members.empty()) {
      if (problem.empty()) problem = "MARS has no sensor of the type `" + type + "`";
      context_.keep_as_text(element.name_span(), "the sensor `" + name + "`", problem);
      return;
    }
    if (const auto rate = field(element, "update_rate"); rate && *rate > 0) {
      const double period = std::max(1.0, std::round(1000 / *rate));
      members.insert(members.begin() + 2,
                     number_value("rate", period, "ms; " + format_rounded(*rate) + " Hz"));
    }
    add(name, "from <sensor type=\"" + type + "\">, " + context_.line_of(element.span()),
        std::move(members));
  }

  /// "type" and "link" first. Empty if there is no counterpart; `problem` may contain the reason.
  std::vector<NewValue> members_of(xml::View element, std::string_view type,
                                   const std::string& carrier, std::string& problem) {
    if (type == "force_torque") return force_torque_of(carrier, problem);
    if (!context_.model.link_names.contains(carrier)) {
      problem = "no link `" + carrier + "` carries it";
      return {};
    }
    if (type == "imu") return imu(carrier);
    if (type == "contact") return contact(element, carrier, problem);
    if (type == "camera" || type == "depth" || type == "depth_camera" || type == "rgbd_camera") {
      return camera(element, type, carrier, problem);
    }
    if (type == "ray" || type == "lidar" || type == "gpu_ray" || type == "gpu_lidar") {
      return lidar(element, carrier, problem);
    }
    return {};
  }

  static std::vector<NewValue> imu(const std::string& link) {
    return {text_value("type", "NodeIMU"), text_value("link", link),
            list_value("id", {text_value({}, link)})};
  }

  std::vector<NewValue> force_torque_of(const std::string& carrier, std::string& problem) const {
    if (const auto joint = context_.model.joint_names.find(carrier)) {
      const urdf::Joint& measured = context_.robot().joints[*joint];
      if (measured.child && parent_joint(*measured.child) == &measured) {
        return force_torque(measured);
      }
    }
    problem = "no joint `" + carrier + "` carries it";
    return {};
  }

  /// MARS measures the joint above the link; Phobos stops loading at a key `joint`.
  static std::vector<NewValue> force_torque(const urdf::Joint& joint) {
    return {text_value("type", "Joint6DOF"), text_value("link", *joint.child)};
  }

  std::vector<NewValue> camera(xml::View element, std::string_view type, const std::string& link,
                               std::string& problem) const {
    const xml::View camera = element.child("camera");
    const xml::View image = camera ? camera.child("image") : xml::View();
    const auto width = field(image, "width");
    const auto height = field(image, "height");
    auto fov = field(camera, "horizontal_fov");
    if (!fov) fov = field(image, "hfov");
    if (!width || !height || !fov || *width < 1 || *height < 1 || *fov <= 0 ||
        *fov >= std::numbers::pi) {
      problem = "it does not give its picture's size and field of view";
      return {};
    }
    const auto [sine, cosine] = sine_cosine(*fov / 2);
    const double vertical = 2 * arc_tangent(sine * *height, cosine * *width);
    const Pose pose = sensor_pose(element);
    std::vector<NewValue> members = {
        text_value("type", "CameraSensor"),
        text_value("link", link),
        number_value("width", std::floor(*width)),
        number_value("height", std::floor(*height)),
        number_value("opening_width", *fov * kDegrees, "degrees; " + format_rounded(*fov) + " rad"),
        number_value("opening_height", vertical * kDegrees, "from the picture's proportions")};
    if (type != "camera") members.push_back(boolean_value("depth_image", true));
    // Phobos reads the keys in this order, and reads a position only after an orientation.
    members.push_back(orientation_value("orientation_offset", pose.orientation));
    members.push_back(
        numbers_value("position_offset",
                      {{"x", pose.position[0]}, {"y", pose.position[1]}, {"z", pose.position[2]}}));
    return members;
  }

  struct Fan {
    double samples = 1, lowest = 0, highest = 0;
  };

  static Fan fan(xml::View scan, std::string_view direction) {
    Fan result;
    const xml::View element = scan ? scan.child(direction) : xml::View();
    if (!element) return result;
    result.samples = std::max(1.0, std::floor(field(element, "samples").value_or(1)));
    result.lowest = field(element, "min_angle").value_or(0);
    result.highest = field(element, "max_angle").value_or(0);
    return result;
  }

  /// MARS: `lasers` rays above each other in each of `bands` directions about z; a positive
  /// vertical angle looks down (RotatingRaySensor.cpp, constructor).
  std::vector<NewValue> lidar(xml::View element, const std::string& link, std::string& problem) {
    const xml::View ray = element.child("ray") ? element.child("ray") : element.child("lidar");
    const xml::View scan = ray && ray.child("scan") ? ray.child("scan") : ray;
    const xml::View range = ray ? ray.child("range") : xml::View();
    const Fan across = fan(scan, "horizontal");
    const Fan up = fan(scan, "vertical");
    const double width = across.highest - across.lowest;
    if (!(width > 0)) {
      problem = "it does not give its angles";
      return {};
    }
    const Pose pose = sensor_pose(element);
    if (pose.position != Vector3{0, 0, 0}) {
      context_.keep_as_text(element.name_span(), "the position of the sensor on `" + link + "`",
                            "a RotatingRaySensor is at the origin of its link");
    }
    std::vector<NewValue> members = {
        text_value("type", "RotatingRaySensor"),
        text_value("link", link),
        number_value("bands", across.samples),
        number_value("lasers", up.samples),
        number_value("opening_width", width),
        number_value("opening_height", up.highest - up.lowest),
        number_value("horizontal_offset", (across.highest + across.lowest) / 2),
        number_value("vertical_offset", -(up.highest + up.lowest) / 2, "positive looks down"),
        number_value("horizontal_resolution", width / across.samples)};
    if (const auto least = field(range, "min")) {
      members.push_back(number_value("min_distance", std::max(0.0, *least)));
    }
    if (const auto most = field(range, "max"); most && *most >= 0) {
      members.push_back(number_value("max_distance", *most));
    }
    if (pose.orientation != Quaternion{}) {
      members.push_back(orientation_value("rotation_offset", pose.orientation));
    }
    return members;
  }

  /// The collision that Gazebo's sensor names, or all collisions of the link; for Phobos the link
  /// itself, because Phobos looks for links of these names.
  std::vector<NewValue> contact(xml::View element, const std::string& link, std::string& problem) {
    if (context_.options.style == SmurfStyle::phobos) {
      return {text_value("type", "NodeContact"), text_value("link", link),
              list_value("id", {text_value({}, link)})};
    }
    std::vector<NewValue> collisions = collisions_named_in(element);
    const auto named = child_text(element.child("contact"), "collision");
    if (collisions.empty() && context_.model.collision_names.contains(named)) {
      collisions.push_back(text_value({}, std::string(named)));
    }
    if (collisions.empty()) collisions = collisions_of(link);
    if (collisions.empty()) {
      problem = context_.options.layout == SmurfLayout::in_place
                    ? "its collisions have no names, and the URDF is not changed"
                    : "the link has no collisions";
      return {};
    }
    return {text_value("type", "NodeContact"), text_value("link", link),
            list_value("id", std::move(collisions))};
  }

  /// Those that Gazebo finds by the names in a sensor.
  std::vector<NewValue> collisions_named_in(xml::View sensor) {
    std::vector<NewValue> collisions;
    for (const ContactName& contact : contacts_) {
      if (contact.element.parent().parent().id() != sensor.id()) continue;
      const auto place = find_collision(gazebo_, contact.link, contact.text);
      if (!place) continue;
      const std::string name = name_at(*place);
      if (!name.empty()) collisions.push_back(text_value({}, name));
    }
    return collisions;
  }

  /// Gazebo makes the names of collisions from those in the URDF, so the names in sensors follow
  /// those that are given here.
  void rename_contacts() {
    if (given_names_.empty() || contacts_.empty()) return;
    const GazeboNames renamed =
        gazebo_names(context_.model, [&](std::size_t link, std::size_t collision) {
          const auto given = given_names_.find(static_cast<std::uint32_t>(link));
          if (given != given_names_.end() && !given->second[collision].empty()) {
            return given->second[collision];
          }
          return context_.robot().links[link].collisions[collision].name.value_or({});
        });
    for (const ContactName& contact : contacts_) {
      const auto place = find_collision(gazebo_, contact.link, contact.text);
      if (!place) continue;
      const std::string& name = renamed.collisions[place->link][place->collision];
      if (name == contact.text) continue;
      context_.edits.push_back({contact.element.text_span(), escape_xml(name)});
    }
  }

  /// The name of a collision, which may get it now; "" if it cannot.
  std::string name_at(const CollisionPlace& place) {
    const urdf::Link& link = context_.robot().links[place.link];
    const urdf::Collision& collision = link.collisions[place.collision];
    if (collision.name) return *collision.name;
    if (context_.options.layout == SmurfLayout::in_place || collision.name.written) return {};
    std::vector<std::string>& given = given_names_[static_cast<std::uint32_t>(place.link)];
    given.resize(link.collisions.size());
    std::string& name = given[place.collision];
    if (name.empty()) name = give_name(collision, link.name.value_or({}));
    return name;
  }

  /// Unnamed collisions get a name in the written URDF, if one is written.
  std::vector<NewValue> collisions_of(const std::string& link) {
    const std::uint32_t index = *context_.model.link_names.find(link);
    std::vector<NewValue> names;
    for (std::size_t i = 0; i < context_.robot().links[index].collisions.size(); ++i) {
      const std::string name = name_at({index, i});
      if (!name.empty()) names.push_back(text_value({}, name));
    }
    return names;
  }

  std::string give_name(const urdf::Collision& collision, const std::string& link) {
    const std::string name = geometry_names_.add(link + "_collision");
    Span place = xml::View(context_.robot().document, collision.element).name_span();
    place.begin = place.end;
    context_.edits.push_back({place, " name=\"" + escape_xml(name) + "\""});
    return name;
  }

  Context& context_;
  UniqueNames names_;
  UniqueNames geometry_names_;
  std::map<std::uint32_t, std::vector<std::string>> given_names_;  ///< by link
  GazeboNames gazebo_ = gazebo_names(context_.model);
  std::vector<ContactName> contacts_ = contact_names(context_.model);
  std::vector<NewValue> entries_;
  std::array<JointQuantity, 3> quantities_ = {
      JointQuantity{"position", "joint_positions", "JointPosition"},
      JointQuantity{"velocity", "joint_velocities", "JointVelocity"},
      JointQuantity{"effort", "joint_efforts", "JointTorque"}};
};

}  // namespace

Part sensors(Context& context) {
  std::vector<NewValue> entries = SensorMaker(context).make();
  if (entries.empty()) return std::nullopt;
  return NewFile{"sensors", "sensors; rate is the time between two measurements in ms",
                 list_value("sensors", std::move(entries))};
}

}  // namespace smurf::import
