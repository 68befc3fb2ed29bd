// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml1119_stray_text_file {

extern constinit const Rule sml1119_stray_text{
    .id = "SML1119",
    .name = "stray-text",
    .severity = Severity::warning,
    .summary = "There is text between the elements of a URDF.",
    .why =
        "URDF stores everything in attributes, so readers silently skip the text: a value written there is lost, and a marker of a merge conflict goes unnoticed.",
    .remedy = "Delete the text, make it a comment, or move it into an attribute.",
    .sources = "urdfdom, sdformat, MuJoCo and Bullet, which ask for elements only.",
    .about = About::format};

}  // namespace smurf::rules::sml1119_stray_text_file
