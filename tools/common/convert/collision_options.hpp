// SPDX-License-Identifier: BSD-3-Clause
// The option --collision, and what is told and written for it.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/cli/command.hpp"
#include "common/convert/converter.hpp"
#include "common/files/output.hpp"
#include "smurf/conversion.hpp"

namespace smurf::tools {

/// --collision; `request` must live as long as the option.
Option collision_option(CollisionRequest& request);

/// Lets the request divide meshes and tell about it, and write new meshes beside the output:
/// arm.xml has arm_collisions/. All must outlive the request.
void complete(CollisionRequest& request, std::string_view tool, const ConverterOptions& options);

/// "collisions: 12 meshes become 57 convex parts in arm_collisions".
std::vector<std::string> remarks_on(std::span<const ReplacedCollision> replaced,
                                    std::size_t new_meshes, const std::string& folder);

/// The files of a result, in a folder.
std::vector<OutputFile> output_files(const std::string& folder, std::span<const TextFile> files);

}  // namespace smurf::tools
