// SPDX-License-Identifier: BSD-3-Clause
// Sources: sdformat 12.3.0, sdf/1.9/*.sdf; is_translated(): src/parser_urdf.cc:1240-1546.
#include "readers/sdf_language.hpp"

#include <algorithm>

#include "base/ranges.hpp"
#include "base/text/suggest.hpp"
#include "base/text/words.hpp"

namespace smurf::sdf {
namespace {

constexpr Element kElements[] = {
    {"model", "!name:s",
     "static:b self_collide:b allow_auto_disable:b frame@frame pose:p@pose link@link joint@joint "
     "plugin@plugin gripper@gripper include@include model@model enable_wind:b"},
    {"frame", "!name:s", "pose:p@pose"},
    {"pose", "degrees:b", ""},
    {"link", "!name:s",
     "gravity:b enable_wind:b self_collide:b kinematic:b must_be_base_link:b "
     "velocity_decay@velocity_decay pose:p@pose inertial@inertial collision@collision "
     "visual@visual sensor@sensor projector@projector audio_source@audio_source battery@battery "
     "light@light particle_emitter@particle_emitter"},
    {"velocity_decay", "", "linear:d angular:d"},
    {"inertial", "", "mass:d pose:p@pose inertia@inertia"},
    {"inertia", "", "!ixx:d !ixy:d !ixz:d !iyy:d !iyz:d !izz:d"},
    {"collision", "!name:s",
     "laser_retro:d max_contacts:i pose:p@pose geometry@geometry surface@surface"},
    {"geometry", "",
     "box@box capsule@cylinder cylinder@cylinder ellipsoid@ellipsoid heightmap@heightmap "
     "image@heights mesh@mesh plane@plane polyline@polyline sphere@sphere"},
    {"box", "", "!size:3"},
    {"cylinder", "", "!radius:d !length:d"},
    {"ellipsoid", "", "!radii:3"},
    {"heightmap", "",
     "!uri:s size:3 pos:3 texture@texture blend@blend use_terrain_paging:b sampling:u"},
    {"texture", "", "!size:d !diffuse:s !normal:s"},
    {"blend", "", "!min_height:d !fade_dist:d"},
    {"heights", "", "!uri:s !scale:d !threshold:i !height:d !granularity:i"},
    {"mesh", "", "!uri:s submesh@submesh scale:3"},
    {"submesh", "", "!name:s center:b"},
    {"plane", "", "!normal:3 !size:2"},
    {"polyline", "", "!point:2 !height:d"},
    {"sphere", "", "!radius:d"},
    {"surface", "",
     "bounce@bounce friction@friction contact@surface-contact soft_contact@soft_contact"},
    {"bounce", "", "restitution_coefficient:d[0,1] threshold:d"},
    {"friction", "", "torsional@torsional ode@friction-ode bullet@friction-bullet"},
    {"torsional", "",
     "coefficient:d[0,] use_patch_radius:b patch_radius:d[0,] surface_radius:d[0,] "
     "ode@torsional-ode"},
    {"torsional-ode", "", "slip:d"},
    {"friction-ode", "", "mu:d[0,] mu2:d[0,] fdir1:3 slip1:d slip2:d"},
    {"friction-bullet", "", "friction:d[0,] friction2:d[0,] fdir1:3 rolling_friction:d"},
    {"surface-contact", "",
     "collide_without_contact:b collide_without_contact_bitmask:u collide_bitmask:u "
     "category_bitmask:u poissons_ratio:d elastic_modulus:d ode@contact-ode bullet@contact-bullet"},
    {"contact-ode", "", "soft_cfm:d soft_erp:d kp:d kd:d max_vel:d min_depth:d"},
    {"contact-bullet", "",
     "soft_cfm:d soft_erp:d kp:d kd:d !split_impulse:b !split_impulse_penetration_threshold:d"},
    {"soft_contact", "", "dart@dart"},
    {"dart", "", "!bone_attachment:d !stiffness:d !damping:d !flesh_mass_fraction:d"},
    {"visual", "!name:s",
     "cast_shadows:b laser_retro:d transparency:d visibility_flags:u meta@meta pose:p@pose "
     "material@material geometry@geometry plugin@plugin"},
    {"meta", "", "layer:i"},
    {"material", "",
     "script@script shader@shader render_order:f lighting:b ambient:c diffuse:c specular:c "
     "emissive:c double_sided:b pbr@pbr"},
    {"script", "", "!uri:s !name:s"},
    {"shader", "!type:s", ""},
    {"pbr", "", "metal@workflow specular@workflow"},
    {"workflow", "", "light_map:s@light_map"},
    {"light_map", "uv_set:u", ""},
    {"plugin", "!name:s !filename:s", ""},
    {"sensor", "!name:s !type:s",
     "always_on:b update_rate:d visualize:b topic enable_metrics:b frame_id pose:p@pose "
     "plugin@plugin air_pressure@air_pressure air_speed altimeter@altimeter camera@camera contact@sensor-contact "
     "force_torque@force_torque gps@navsat imu@imu lidar@ray logical_camera@logical_camera "
     "magnetometer@noisy-vector navsat@navsat ray@ray rfid rfidtag sonar@sonar transceiver@transceiver"},
    {"air_pressure", "", "reference_altitude:d pressure@noisy"},
    {"noisy", "", "noise@noise"},
    {"noise", "!type:s",
     "mean:d stddev:d[0,] bias_mean:d bias_stddev:d[0,] dynamic_bias_stddev:d[0,] "
     "dynamic_bias_correlation_time:d precision:d"},
    {"altimeter", "", "vertical_position@noisy vertical_velocity@noisy"},
    {"camera", "",
     "camera_info_topic !horizontal_fov:d[0.1,6.283186] image@picture clip@clip save@save depth_camera@depth_camera "
     "noise@image-noise distortion@distortion lens@lens visibility_mask:u optical_frame_id "
     "pose:p@pose triggered trigger_topic segmentation_type box_type"},
    {"picture", "", "!width:i !height:i format anti_aliasing"},
    {"clip", "", "!near:d[0,] !far:d[0.1,]"},
    {"save", "!enabled:b", "!path:s"},
    {"depth_camera", "", "!output:s clip@depth-clip"},
    {"depth-clip", "", "near:d[0,] far:d[0.1,]"},
    {"image-noise", "", "!type:s mean:d stddev:d"},
    {"distortion", "", "k1:d k2:d k3:d p1:d p2:d center:2"},
    {"lens", "",
     "!type:s !scale_to_hfov:b custom_function@custom_function cutoff_angle:d[0,3.141592653] "
     "env_texture_size:i[4,2048] intrinsics@intrinsics projection"},
    {"custom_function", "", "c1:d c2:d c3:d f:d !fun:s"},
    {"intrinsics", "", "!fx:d !fy:d !cx:d !cy:d !s:d"},
    {"sensor-contact", "", "!collision:s !topic:s"},
    {"force_torque", "", "frame measure_direction force@noisy-vector torque@noisy-vector"},
    {"noisy-vector", "", "x@noisy y@noisy z@noisy"},
    {"navsat", "", "position_sensing@noisy-plane velocity_sensing@noisy-plane"},
    {"noisy-plane", "", "horizontal@noisy vertical@noisy"},
    {"imu", "",
     "orientation_reference_frame@orientation_reference_frame angular_velocity@noisy-vector "
     "linear_acceleration@noisy-vector enable_orientation:b"},
    {"orientation_reference_frame", "", "!localization:s custom_rpy:3 grav_dir_x:3"},
    {"ray", "", "scan@scan range@range noise@image-noise visibility_mask"},
    {"scan", "", "horizontal@horizontal vertical@vertical"},
    {"horizontal", "", "!samples:u !resolution:d !min_angle:d !max_angle:d"},
    {"vertical", "", "!samples:u resolution:d !min_angle:d !max_angle:d"},
    {"range", "", "!min:d !max:d resolution:d"},
    {"logical_camera", "", "!near:d !far:d !aspect_ratio:d !horizontal_fov:d"},
    {"sonar", "", "geometry !min:d !max:d radius:d"},
    {"transceiver", "",
     "essid frequency:d min_frequency:d max_frequency:d !gain:d !power:d sensitivity:d"},
    {"projector", "!name:s", "!texture:s fov:d near_clip:d far_clip:d pose:p@pose plugin@plugin"},
    {"audio_source", "", "!uri:s pitch:d gain:d contact@audio-contact loop:b pose:p@pose"},
    {"audio-contact", "", "!collision:s"},
    {"battery", "!name:s", "!voltage:d"},
    {"light", "!name:s !type:s",
     "cast_shadows:b intensity:d pose:p@pose diffuse:c specular:c attenuation@attenuation "
     "!direction:3 spot@spot"},
    {"attenuation", "", "!range:d linear:d constant:d quadratic:d"},
    {"spot", "", "!inner_angle:d !outer_angle:d !falloff:d"},
    {"particle_emitter", "!name:s !type:s",
     "emitting:b duration:d size:3 particle_size:3 lifetime:d rate:d[0,] min_velocity:d[0,] "
     "max_velocity:d[0,] scale_rate:d[0,] color_start:c color_end:c particle_scatter_ratio:f "
     "pose:p@pose material@material"},
    {"joint", "!name:s !type:s",
     "!parent:s !child:s gearbox_ratio:d thread_pitch:d axis@axis axis2@axis physics@physics "
     "pose:p@pose sensor@sensor"},
    {"axis", "", "!xyz:3 dynamics@dynamics limit@limit"},
    {"dynamics", "", "damping:d friction:d !spring_reference:d !spring_stiffness:d"},
    {"limit", "", "!lower:d !upper:d effort:d velocity:d stiffness:d dissipation:d"},
    {"physics", "", "simbody@simbody ode@joint-ode provide_feedback:b"},
    {"simbody", "", "must_be_loop_joint:b"},
    {"joint-ode", "",
     "cfm_damping:b implicit_spring_damper:b fudge_factor:d cfm:d erp:d bounce:d max_force:d "
     "velocity:d limit@soft-stop suspension@soft-stop"},
    {"soft-stop", "", "!cfm:d !erp:d"},
    {"gripper", "!name:s", "grasp_check@grasp_check gripper_link:s !palm_link:s"},
    {"grasp_check", "", "detach_steps:i attach_steps:i min_contact_count:u"},
    {"include", "merge:b", "!uri:s pose:p@pose plugin@plugin static:b"},
};

constexpr std::string_view kTranslated[] = {"material",
                                            "collision",
                                            "visual",
                                            "static",
                                            "turnGravityOff",
                                            "dampingFactor",
                                            "maxVel",
                                            "minDepth",
                                            "mu1",
                                            "mu2",
                                            "fdir1",
                                            "kp",
                                            "kd",
                                            "selfCollide",
                                            "maxContacts",
                                            "laserRetro",
                                            "springReference",
                                            "springStiffness",
                                            "stopCfm",
                                            "stopErp",
                                            "fudgeFactor",
                                            "provideFeedback",
                                            "canonicalBody",
                                            "cfmDamping",
                                            "implicitSpringDamper",
                                            "disableFixedJointLumping",
                                            "preserveFixedJoint"};

/// What stands before `mark`, with which `rest` then begins behind it.
std::string_view take_until(std::string_view& rest, char mark) {
  const std::size_t end = std::min(rest.find(mark), rest.size());
  const std::string_view text = rest.substr(0, end);
  rest.remove_prefix(std::min(end + 1, rest.size()));
  return text;
}

Part read_part(std::string_view word) {
  Part part;
  part.is_required = word.starts_with('!');
  if (part.is_required) word.remove_prefix(1);
  std::string_view head = take_until(word, '@');
  part.kind = word;
  part.name = take_until(head, ':');
  if (head.empty()) return part;
  part.value = head.front();
  if (head.size() > 1) part.range = head.substr(2, head.size() - 3);
  return part;
}

}  // namespace

const Element* find(std::string_view kind) {
  const auto found = ranges::find(kElements, kind, &Element::kind);
  return found == std::end(kElements) ? nullptr : found;
}

std::optional<Part> next_part(std::string_view list, std::size_t& at) {
  const std::string_view word = next_word(list, at);
  return word.empty() ? std::nullopt : std::optional<Part>(read_part(word));
}

std::optional<Part> find_part(std::string_view list, std::string_view name) {
  std::size_t at = 0;
  while (const std::optional<Part> part = next_part(list, at)) {
    if (part->name == name) return part;
  }
  return std::nullopt;
}

std::optional<std::string_view> meant_translated(std::string_view name) {
  return nearest(name, kTranslated);
}

bool is_translated(std::string_view name) { return ranges::contains(kTranslated, name); }

}  // namespace smurf::sdf
