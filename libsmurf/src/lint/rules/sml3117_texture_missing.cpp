// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml3117_texture_missing_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for (const TextureReference& texture : model.annotation_textures) {
    if (texture.exists) continue;
    Diagnostic& diagnostic = findings.report(
        texture.span, (texture.is_denied ? "the texture lies outside of the project: "
                                         : "texture file not found: ") +
                          quoted(texture.filename));
    if (texture.is_denied) diagnostic.help("read it with `--allow-outside`");
    if (texture.path != texture.filename) {
      diagnostic.caret = "resolved to " + quoted(texture.path);
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::loses, "draws the material without it",
     "MARS MaterialData.cpp:112-115"},
};

}  // namespace

extern constinit const Rule sml3117_texture_missing{
    .id = "SML3117",
    .name = "texture-missing",
    .severity = Severity::warning,
    .summary = "The annotation of a material names an image that does not exist.",
    .remedy = "Correct the path; it starts at the folder of the .smurf.",
    .check_model = check,
    .facts = kFacts,
    .about = About::robot};

}  // namespace smurf::rules::sml3117_texture_missing_file
