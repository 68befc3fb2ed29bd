// SPDX-License-Identifier: BSD-3-Clause
// What all parts of the reader have in common: how libsdformat reads numbers, words and poses.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/numbers/sdf_values.hpp"
#include "imports/imports.hpp"
#include "imports/mass.hpp"
#include "imports/traced_xml.hpp"
#include "smurf/pose.hpp"
#include "smurf/xml.hpp"
#include "syntax/xml_values.hpp"

namespace smurf::sdformat {

using imports::Context;
using imports::Imported;
using imports::MassProperties;
using imports::Place;
using imports::Reporter;
using imports::TracedXml;
using imports::words_of;
using xml::Attribute;
using xml::View;

/// From here on, a limit is none.
inline constexpr double kUnlimited = 1e16;

/// The text of an element, trimmed; "" without one.
std::string_view text_of(View element);
/// The text of the first child of a name, trimmed.
std::string_view text_in(View element, std::string_view child);

/// The value of the first child of a name; `usual` if it is not there or cannot be read, which was
/// reported when the file was checked.
double number_in(View element, std::string_view child, double usual);
bool truth_in(View element, std::string_view child, bool usual);
Vector3 vector_in(View element, std::string_view child, const Vector3& usual);

/// Red, green, blue and alpha, which may be missing; none if libsdformat cannot read it.
std::optional<std::array<double, 4>> colour_in(std::string_view text);

/// The pose that a `<pose>` gives; none if libsdformat cannot read it. An absent or empty one is
/// the identity.
std::optional<Pose> pose_in(View pose);
/// The same of a text, which no attribute says more about: six numbers.
bool is_plain_pose(std::string_view text);

/// The text of an element, or its tag if it has none.
Place place_of(View element, xacro::FrameId frame);
/// That of the first child of a name, or the tag of the element itself.
Place place_in(View element, std::string_view child, xacro::FrameId frame);
Place tag_of(View element, xacro::FrameId frame);

}  // namespace smurf::sdformat
