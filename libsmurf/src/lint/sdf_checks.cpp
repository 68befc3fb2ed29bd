// SPDX-License-Identifier: BSD-3-Clause
// Sources: sdformat 12.3.0 src/parser.cc:1300-1890 (attributes and values), and the functions Load
// of Sensor.cc, Camera.cc, ForceTorque.cc, Light.cc, ParticleEmitter.cc, Material.cc and Joint.cc.
#include "lint/sdf_checks.hpp"

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>

#include "base/files/path.hpp"
#include "base/findings/uncertain.hpp"
#include "base/ranges.hpp"
#include "base/sdf_sensor_types.hpp"
#include "base/sdf_words.hpp"
#include "base/text/lists.hpp"
#include "base/text/quoted.hpp"
#include "base/text/suggest.hpp"
#include "base/text/words.hpp"
#include "readers/sdf_values.hpp"

namespace smurf::sdf {
namespace {

/// "`a`, `b` or another of the 30 that SDF has".
template <class Words>
std::string some_of(const Words& known) {
  constexpr std::size_t kMostShown = 9;
  const std::size_t count = std::size(known);
  const std::span<const std::string_view> all(known);
  if (count <= kMostShown) return enumerated(all_quoted(all), " or ");
  return listed(all_quoted(all.first(kMostShown))) + " or another of the " + std::to_string(count) +
         " that SDF has";
}

class Checker {
 public:
  explicit Checker(const Report& report) : report_(report) {}

  void element(xml::View element, std::string_view kind) {
    const Element* row = find(kind);
    if (row == nullptr || !attributes(element, row->attributes)) return;
    children(element, *row);
    meaning(element, kind);
  }

  // The recursion is as deep as the file, whose depth is limited.
  void children(xml::View parent, const Element& row) {
    if (row.children.empty() && row.kind == "plugin") return;  // copied as it is
    for (const xml::View child : parent) {
      if (child.name() == "include") {
        check_include(child, report_);
        continue;
      }
      const std::optional<Part> part = find_part(row.children, child.name());
      if (part) this->child(child, *part);
    }
  }

 private:
  void child(xml::View child, const Part& part) {
    if (part.value != '\0' && !is_readable(part, child.text(), child)) {
      report_unreadable(place_of(child), part.name, trimmed_text(child.text()).empty(),
                        wanted(part), report_);
      return;
    }
    if (!part.kind.empty()) element(child, part.kind);
  }

  bool attributes(xml::View element, std::string_view list) {
    bool is_good = true;
    std::size_t at = 0;
    while (const std::optional<Part> part = next_part(list, at)) {
      const xml::Attribute* attribute = element.attribute(part->name);
      if (attribute == nullptr) {
        if (!part->is_required) continue;
        report_(element.name_span(), quoted(element.name()) + " has no " + quoted(part->name))
            .help("add the attribute " + quoted(part->name));
        is_good = false;
      } else if (!is_readable(*part, attribute->value(), element)) {
        report_unreadable(place_of(element, part->name), part->name, attribute->value().empty(),
                          wanted(*part), report_);
        is_good = false;
      }
    }
    return is_good;
  }

  /// Reports a word other than those that sdformat knows.
  template <class Words>
  void word(Span place, std::string_view word, const Words& known, std::string_view what) {
    if (ranges::contains(known, word)) return;
    Diagnostic& unknown =
        report_(place, "Gazebo does not know the " + std::string(what) + " " + quoted(word));
    const auto meant = nearest(word, known);
    unknown.help(meant ? "did you mean " + quoted(*meant) + "?" : "write " + some_of(known));
  }
  template <class Words>
  void text(xml::View parent, std::string_view name, const Words& known, std::string_view what) {
    const xml::View child = parent.child(name);
    const std::string_view text = child ? trimmed_text(child.text()) : std::string_view();
    if (!text.empty()) word(place_of(child), text, known, what);  // an empty one is the default
  }

  void meaning(xml::View element, std::string_view kind) {
    const std::string_view type = value_of(element, "type");
    if (kind == "sensor") {
      check_reserved(element, report_);
      word(place_of(element, "type"), type, kSdfSensorTypesOf12, "type of sensor");
      sensor(element, type);
    } else if (kind == "light") {
      check_reserved(element, report_);
      word(place_of(element, "type"), type, kLights, "type of light");
    } else if (kind == "particle_emitter") {
      check_reserved(element, report_);
      word(place_of(element, "type"), type, kEmitters, "type of emitter");
    } else if (kind == "visual" || kind == "collision") {
      check_reserved(element, report_);
    } else if (kind == "joint") {
      joint(element, type);
    } else if (kind == "script") {
      script(element);
    } else if (kind == "shader") {
      word(place_of(element, "type"), type, kShaders, "type of shader");
    }
  }

  void sensor(xml::View sensor, std::string_view type) {
    if (type == "force_torque") {
      const xml::View own = sensor.child("force_torque");
      if (!own) return;
      text(own, "frame", kWrenchFrames, "frame");
      text(own, "measure_direction", kWrenchDirections, "direction");
    }
    const xml::View camera = sensor.child("camera");
    if (!camera || !ranges::contains(kCameras, type)) return;
    if (const xml::View image = camera.child("image")) {
      text(image, "format", kPixels, "format of pixels");
    }
    const xml::View noise = camera.child("noise");
    const xml::View kind = noise ? noise.child("type") : xml::View();
    if (kind) {
      const std::string lower = path::to_lower(trimmed_text(kind.text()));
      word(place_of(kind), lower, kNoise, "type of noise");
    }
  }

  void joint(xml::View joint, std::string_view type) {
    const std::string lower = path::to_lower(type);
    word(place_of(joint, "type"), lower, kJoints, "type of joint");
    for (const char* end : {"parent", "child"}) {
      if (joint.child(end)) continue;
      report_(joint.name_span(), "`joint` has no " + quoted(end))
          .help("add the element " + quoted(end));
    }
    for (const char* name : {"axis", "axis2"}) {
      const xml::View axis = joint.child(name);
      const xml::View xyz = axis ? axis.child("xyz") : xml::View();
      const auto vector = xyz ? read_vector(xyz.text()) : std::nullopt;
      if (vector && *vector == std::array<double, 3>{}) {
        report_(place_of(xyz), "the axis has no direction").help("write another axis than 0 0 0");
      }
    }
  }

  void script(xml::View script) {
    for (const char* part : {"uri", "name"}) {
      const xml::View child = script.child(part);
      if (child) continue;  // an empty one is reported as a value
      report_(script.name_span(), "`script` has no " + quoted(part))
          .help("add the element " + quoted(part));
    }
  }

  const Report& report_;
};

}  // namespace

Diagnostic& report_unreadable(Span place, std::string_view name, bool is_empty,
                              std::string_view wanted, const Report& report) {
  Diagnostic& found =
      report(place, quoted(name) + (is_empty ? " is empty" : " cannot be read by Gazebo"));
  found.help("write " + std::string(wanted));
  return found;
}

void check_element(xml::View element, std::string_view kind, const Report& report) {
  Checker(report).element(element, kind);
}

void check_children(xml::View element, std::string_view kind, const Report& report) {
  if (const Element* row = find(kind)) Checker(report).children(element, *row);
}

void check_include(xml::View include, const Report& report) {
  const xml::View uri = include.child("uri");
  if (!uri) {
    report(include.name_span(), "`include` has no `uri`").help("add the element `uri`");
  } else if (uri.text().empty()) {
    report(uri.name_span(), "`uri` is empty").when(kEmptyInclude);
  } else {
    report(place_of(uri), "Gazebo needs the model " + quoted(trimmed(uri.text())))
        .when(kUncertain)
        .help(
            "keep the model in a folder that the environment variable GZ_SIM_RESOURCE_PATH names");
  }
}

void check_reserved(xml::View element, const Report& report) {
  const std::string_view name = value_of(element, "name");
  const bool is_reserved =
      name == "world" || (name.size() >= 4 && name.starts_with("__") && name.ends_with("__"));
  if (!is_reserved) return;
  report(place_of(element, "name"), "sdformat (Gazebo) reserves the name " + quoted(name))
      .help("choose another name");
}

Span place_of(xml::View element) {
  const Span place = element.text_span();
  return place.empty() ? element.name_span() : place;
}

Span place_of(xml::View element, std::string_view attribute) {
  const xml::Attribute* found = element.attribute(attribute);
  const bool is_marked = found != nullptr && !found->value_span().empty();
  return is_marked ? found->value_span() : element.name_span();
}

std::string_view value_of(xml::View element, std::string_view attribute) {
  const xml::Attribute* found = element.attribute(attribute);
  return found == nullptr ? std::string_view() : trimmed_text(found->value());
}

std::string_view text_of(xml::View element, std::string_view child) {
  const xml::View found = element.child(child);
  return found ? trimmed_text(found.text()) : std::string_view();
}

}  // namespace smurf::sdf
