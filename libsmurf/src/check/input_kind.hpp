// SPDX-License-Identifier: BSD-3-Clause
// What files are, by their names.
#pragma once

#include <cstdint>
#include <string_view>

namespace smurf {

/// A resource is a mesh or an image that models refer to. A drawing (.svg) is a scene when a user
/// names it; most are none.
enum class InputKind : std::uint8_t { model, scene, drawing, urdf, annotation, resource, other };

/// By the extension.
InputKind input_kind(std::string_view path);

}  // namespace smurf
