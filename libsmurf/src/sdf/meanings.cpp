// SPDX-License-Identifier: BSD-3-Clause
// Each row was run: tests/readers/sdf_refusals_test.py.
#include "sdf/meanings.hpp"

#include <span>
#include <string>
#include <string_view>

#include "base/files/path.hpp"
#include "base/ranges.hpp"
#include "base/sdf_words.hpp"
#include "base/text/lists.hpp"
#include "base/text/quoted.hpp"

namespace smurf::sdformat {
namespace {

constexpr std::string_view kAtmospheres[] = {"adiabatic"};
constexpr std::string_view kOrientations[] = {"ENU"};
// libsdformat 12 knows the first one only.
constexpr std::string_view kSurfaces[] = {"EARTH_WGS84", "MOON_SCS", "CUSTOM_SURFACE"};

struct WordRow {
  std::string_view element;
  std::string_view part;  ///< an attribute, or a child
  bool is_attribute;
  std::span<const std::string_view> words;
  std::string_view what;  ///< "type of light"
  /// Only in a sensor of these types.
  std::span<const std::string_view> sensors = {};
  bool ignores_case = false;
};
constexpr std::string_view kForceTorque[] = {"force_torque"};
constexpr WordRow kWordRows[] = {
    {"light", "type", true, sdf::kLights, "type of light"},
    {"particle_emitter", "type", true, sdf::kEmitters, "type of emitter"},
    {"shader", "type", true, sdf::kShaders, "type of shader"},
    {"atmosphere", "type", true, kAtmospheres, "type of atmosphere"},
    {"spherical_coordinates", "surface_model", false, kSurfaces, "surface model"},
    {"spherical_coordinates", "world_frame_orientation", false, kOrientations,
     "orientation of the world"},
    {"image", "format", false, sdf::kPixels, "format of pixels", sdf::kCameras},
    {"noise", "type", false, sdf::kNoise, "type of noise", sdf::kCameras, true},
    {"noise", "type", true, sdf::kNoise, "type of noise", kForceTorque, true},
    {"force_torque", "frame", false, sdf::kWrenchFrames, "frame", kForceTorque},
    {"force_torque", "measure_direction", false, sdf::kWrenchDirections, "direction", kForceTorque},
};

View sensor_around(View element) {
  View at = element;
  while (at && at.name() != "sensor") at = at.parent();
  return at;
}

void check_word(View element, const WordRow& row, Reporter& reporter) {
  const Attribute* attribute = row.is_attribute ? element.attribute(row.part) : nullptr;
  const View child = row.is_attribute ? View() : element.child(row.part);
  if (attribute == nullptr && !child) return;
  const std::string_view text = attribute != nullptr ? attribute->value() : text_of(child);
  if (text.empty()) return;  // what must be there has been reported
  const std::string word = row.ignores_case ? path::to_lower(text) : std::string(text);
  if (ranges::contains(row.words, word)) return;
  if (!row.sensors.empty()) {
    const View sensor = sensor_around(element);
    if (!sensor || !ranges::contains(row.sensors, attribute_of(sensor, "type"))) return;
  }
  const auto near = reporter.context().sink.suggest(text, row.words);
  reporter.refuse(attribute != nullptr ? attribute->value_span() : child.text_span(),
                  quoted(text) + " is no " + std::string(row.what),
                  near ? "did you mean " + quoted(*near) + "?" : "write " + choices(row.words));
}

void need(View element, std::string_view child, Reporter& reporter) {
  if (!text_in(element, child).empty()) return;
  reporter.refuse(element.name_span(),
                  quoted(element.name()) + " needs `<" + std::string(child) + ">`", "write it");
}

}  // namespace

void check_meaning(View element, const Grammar& known, Reporter& reporter) {
  const std::string_view name = known.name;
  const bool is_of_material = known.name == "script" || known.name == "shader";
  if (is_of_material && element.parent().parent() && element.parent().parent().name() == "road")
    return;  // whose material it reads, and builds nothing of
  for (const WordRow& row : kWordRows) {
    const bool is_there =
        row.element == name && (row.is_attribute ? known.attribute(row.part) != nullptr
                                                 : known.child(row.part) != nullptr);
    if (is_there) check_word(element, row, reporter);
  }
  if (name == "script" && element.parent().name() == "material") {
    need(element, "uri", reporter);
    need(element, "name", reporter);
  } else if (name == "submesh") {
    need(element, "name", reporter);
  } else if (name == "shader" && attribute_of(element, "type").starts_with("normal_map")) {
    need(element, "normal_map", reporter);
  } else if (name == "include") {
    const View own = element.child("name");
    if (own && text_of(own).empty())
      reporter.refuse(own.name_span(), "`name` of an include is empty", "write a name, or none");
  }
}

}  // namespace smurf::sdformat
