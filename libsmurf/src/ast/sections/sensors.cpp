// SPDX-License-Identifier: BSD-3-Clause
// Sources: MARS smurf.cpp:151-332, SensorManager.cpp, CameraSensor.cpp:480-570, RaySensor.cpp,
// RotatingRaySensor.cpp, ScanningSonar.cpp:318-395, HapticField.cpp; Phobos
// sensor_representations.py.
#include "ast/sections.hpp"

namespace smurf::sections::sensors_file {
namespace {

using enum ValueType;

Naming measured(yaml::View entry) {
  const yaml::View type = entry.find("type");
  return {type && type.is_scalar() ? measured_by(type.text()) : NameKinds()};
}

constexpr Key<Sensor> kKeys[] = {
    {{.name = "name",
      .type = text,
      .doc = "Name of the sensor; controllers refer to it.",
      .required = true,
      .names = defines(NameKind::sensor)},
     &Sensor::name},
    {{.name = "type",
      .type = text,
      .doc = "Type of the sensor: JointPosition, NodeIMU, CameraSensor, RotatingRaySensor, ... "
             "MARS stops loading at a type that it does not know.",
      .required = true},
     &Sensor::type},
    {{.name = "link",
      .type = text,
      .doc = "Link that carries the sensor; MARS 2 needs it for all types.",
      .names = {NameKind::link}},
     &Sensor::link},
    {{.name = "joint", .type = text, .doc = "Measured joint.", .names = {NameKind::joint}},
     &Sensor::joint},
    {{.name = "id",
      .type = name_list,
      .doc = "Names of the measured objects: joints for Joint* types, motors for Motor* types, "
             "collisions for NodeContact*, links for other Node* types.",
      .names_in = measured},
     &Sensor::id},
    {{.name = "links", .type = name_list, .doc = "Measured links.", .names = {NameKind::link}},
     &Sensor::links},
    {{.name = "joints", .type = name_list, .doc = "Measured joints.", .names = {NameKind::joint}},
     &Sensor::joints},
    {{.name = "motors",
      .type = name_list,
      .doc = "Measured motors; the section `motors` must come first in MARS.",
      .names = {NameKind::motor}},
     &Sensor::motors},
    {{.name = "collisions",
      .type = name_list,
      .doc = "Measured collisions.",
      .names = {NameKind::collision}},
     &Sensor::collisions},
    {{.name = "rate",
      .type = number,
      .doc = "Time between two measurements, in whole milliseconds of simulation time; Phobos and "
             "Gazebo read a frequency in Hz.",
      .unit = "ms",
      .minimum = 0},
     &Sensor::rate},
};

constexpr KeySpec kCameraKeys[] = {
    {.name = "width",
     .type = integer,
     .doc = "Cameras: pixels in a row (640). RaySensor: number of rays (1).",
     .minimum = 1},
    {.name = "height", .type = integer, .doc = "Cameras: number of rows (480).", .minimum = 1},
    {.name = "opening_width",
     .type = number,
     .doc = "Horizontal field of view: degrees (90) for cameras, radians for ray sensors.",
     .unit = "deg or rad",
     .positive = true},
    {.name = "opening_height",
     .type = number,
     .doc = "Vertical field of view: degrees for cameras, radians for ray sensors; a negative "
            "value means in proportion to the width.",
     .unit = "deg or rad"},
    {.name = "opening_angle",
     .type = number,
     .doc = "Newer name of a camera's opening_width.",
     .unit = "deg",
     .positive = true},
    {.name = "opening_angle2",
     .type = number,
     .doc = "Newer name of a camera's opening_height.",
     .unit = "deg"},
    {.name = "frame_offset",
     .type = integer,
     .doc = "A camera renders every n-th frame.",
     .fallback = "1"},
    {.name = "show_cam",
     .type = boolean,
     .doc = "Show the picture on the screen; MARS crashes on a ScanningSonar with it.",
     .fallback = "false"},
    {.name = "hud_idx",
     .type = integer,
     .doc = "Place of the picture on the screen.",
     .fallback = "0"},
    {.name = "hud_size",
     .type = vector2,
     .doc = "Size of the picture on the screen.",
     .unit = "pixel"},
    {.name = "hud_width",
     .type = number,
     .doc = "Width of the picture on the screen.",
     .unit = "pixel",
     .fallback = "320",
     .minimum = 0},
    {.name = "hud_height",
     .type = number,
     .doc = "Height of the picture on the screen.",
     .unit = "pixel",
     .minimum = 0},
    {.name = "enabled", .type = boolean, .doc = "The camera is on.", .fallback = "true"},
    {.name = "depth_image", .type = boolean, .doc = "Depth instead of colour, written by Phobos."},
    {.name = "range",
     .type = number,
     .doc = "Largest distance in a depth image.",
     .unit = "m",
     .minimum = 0},
    {.name = "distortion_factor", .type = number, .doc = "Distortion of the lens."},
    {.name = "position_offset",
     .type = vector3,
     .doc =
         "Position in the frame of the link. MARS reads it of cameras; smurfs-flatten also writes "
         "it of NodePosition and NodeVelocity into MJCF.",
     .unit = "m",
     .fallback = R"({"x": 0, "y": 0, "z": 0})"},
    {.name = "orientation_offset",
     .type = orientation,
     .doc = "Orientation in the frame of the link: a quaternion, or roll, pitch, yaw in degrees. "
            "MARS reads it of cameras; smurfs-flatten also writes it of NodeRotation into MJCF."},
    {.name = "reference",
     .type = text,
     .doc =
         "NodePosition, NodeRotation, NodeVelocity, NodeAngularVelocity: link in whose frame the "
         "other one is measured; without it, in the world. smurfs-flatten writes it into MJCF.",
     .read_by = "nobody",
     .names = {NameKind::link}},
    {.name = "reference_position",
     .type = vector3,
     .doc = "Position of that frame in the frame of the link `reference`.",
     .unit = "m",
     .fallback = R"({"x": 0, "y": 0, "z": 0})",
     .read_by = "nobody"},
    {.name = "reference_orientation",
     .type = orientation,
     .doc = "Orientation of that frame: a quaternion, or roll, pitch, yaw in degrees.",
     .read_by = "nobody"},
};

constexpr KeySpec kRayKeys[] = {
    {.name = "max_distance",
     .type = number,
     .doc = "Length of the rays.",
     .unit = "m",
     .fallback = "100",
     .positive = true},
    {.name = "min_distance",
     .type = number,
     .doc = "Smallest measured distance.",
     .unit = "m",
     .fallback = "0.01",
     .minimum = 0},
    {.name = "draw_rays", .type = boolean, .doc = "Show the rays.", .fallback = "true"},
    {.name = "bands",
     .type = integer,
     .doc = "RotatingRaySensor: directions about the vertical axis that are measured at once.",
     .fallback = "16",
     .minimum = 1},
    {.name = "lasers",
     .type = integer,
     .doc = "RotatingRaySensor: rays above each other in every direction.",
     .fallback = "32",
     .minimum = 1},
    {.name = "horizontal_offset",
     .type = number,
     .doc = "Start angle about the vertical axis.",
     .unit = "rad",
     .fallback = "0"},
    {.name = "vertical_offset",
     .type = number,
     .doc = "Angle of the middle band.",
     .unit = "rad",
     .fallback = "0.18622663118779495"},
    {.name = "horizontal_resolution",
     .type = number,
     .doc = "Angle between two measurements.",
     .unit = "rad",
     .fallback = "0.017453292519943295",
     .positive = true},
    {.name = "cloud_offset",
     .type = number,
     .doc = "RotatingRaySensor: angle by which each scan starts later.",
     .unit = "rad",
     .fallback = "0"},
    {.name = "rotation_offset",
     .type = orientation,
     .doc = "RotatingRaySensor: orientation, a quaternion or roll, pitch, yaw in degrees."},
    {.name = "stepX", .type = number, .doc = "HapticField: distance of the columns.", .unit = "m"},
    {.name = "stepY", .type = number, .doc = "HapticField: distance of the rows.", .unit = "m"},
    {.name = "cols", .type = integer, .doc = "HapticField: number of columns.", .minimum = 0},
    {.name = "rows", .type = integer, .doc = "HapticField: number of rows.", .minimum = 0},
    {.name = "drawRays", .type = boolean, .doc = "HapticField: show the rays."},
    {.name = "maxDistance",
     .type = number,
     .doc = "Reach of a HapticField, MultiLevelLaserRangeFinder or ScanningSonar.",
     .unit = "m",
     .positive = true},
    {.name = "numRaysVertical",
     .type = integer,
     .doc = "MultiLevelLaserRangeFinder: rays above "
            "each other.",
     .minimum = 1},
    {.name = "numRaysHorizontal",
     .type = integer,
     .doc = "MultiLevelLaserRangeFinder: rays beside "
            "each other.",
     .minimum = 1},
    {.name = "rttResolutionX",
     .type = integer,
     .doc = "MultiLevelLaserRangeFinder: width of the "
            "depth image.",
     .unit = "pixel",
     .minimum = 1},
    {.name = "rttResolutionY",
     .type = integer,
     .doc = "MultiLevelLaserRangeFinder: height of the "
            "depth image.",
     .unit = "pixel",
     .minimum = 1},
    {.name = "verticalOpeningAngle",
     .type = number,
     .doc = "MultiLevelLaserRangeFinder: vertical field of view.",
     .unit = "rad",
     .positive = true},
    {.name = "horizontalOpeningAngle",
     .type = number,
     .doc = "MultiLevelLaserRangeFinder: horizontal field of view.",
     .unit = "rad",
     .positive = true},
    {.name = "only_ray", .type = boolean, .doc = "ScanningSonar: one ray only."},
    {.name = "resolution",
     .type = number,
     .doc = "ScanningSonar: resolution.",
     .fallback = "0.1",
     .positive = true},
    {.name = "gain", .type = number, .doc = "ScanningSonar: gain.", .fallback = "1"},
    {.name = "internal_width",
     .type = integer,
     .doc = "ScanningSonar: width of the depth image.",
     .unit = "pixel",
     .fallback = "64",
     .minimum = 1},
    {.name = "internal_height",
     .type = integer,
     .doc = "ScanningSonar: height of the depth image.",
     .unit = "pixel",
     .fallback = "512",
     .minimum = 1},
    {.name = "position",
     .type = vector3,
     .doc = "ScanningSonar: position of the housing.",
     .unit = "m"},
    {.name = "extension",
     .type = vector3,
     .doc = "ScanningSonar: size of the housing.",
     .unit = "m"},
    {.name = "orientation",
     .type = orientation,
     .doc = "ScanningSonar: a quaternion, or roll, pitch, yaw in degrees."},
    {.name = "taskInstanceName",
     .type = text,
     .doc = "Rock task of the sensor (rock-cpp/smurf).",
     .read_by = "MARS with envire"},
};

std::vector<const KeySpec*> keys(KeyFilter takes) {
  return specs_of<Sensor>(kKeys, {kCameraKeys, kRayKeys}, takes);
}

void read(yaml::View entry, Span section, Annotations& out, DiagnosticSink& sink) {
  read_into<Sensor>(kKeys, {kCameraKeys, kRayKeys}, "sensor", entry, section, out.sensors, sink);
}

constexpr std::string_view kAliases[] = {"sensor"};

}  // namespace

constinit const SectionSpec sensors{
    .name = "sensors",
    .aliases = kAliases,
    .entry = "sensor",
    .doc = "Sensors and what they measure.",
    .read_by =
        "MARS 1, Phobos 2; MARS 2 and MARS with envire read the types CameraSensor, RaySensor, RotatingRaySensor and Joint6DOF only",
    .filtered_keys = keys,
    .read = read,
    .list = list_of<&Annotations::sensors>()};

}  // namespace smurf::sections::sensors_file

namespace smurf::sections {

NameKinds measured_by(std::string_view type) {
  const auto holds = [&](std::string_view word) {
    return type.find(word) != std::string_view::npos;
  };
  // The order of MARS, smurf.cpp:288-330.
  if (holds("Joint") && !holds("6DOF")) return NameKind::joint;
  if (holds("Node")) return holds("Contact") ? NameKinds(NameKind::collision) : kNodeKinds;
  return holds("Motor") ? NameKinds(NameKind::motor) : NameKinds();
}

}  // namespace smurf::sections
