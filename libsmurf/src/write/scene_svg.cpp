// SPDX-License-Identifier: BSD-3-Clause
// A picture of the scene from above and, below it, from the side.
#include <algorithm>
#include <numbers>
#include <optional>

#include "base/files/path.hpp"
#include "write/parts/scene_parts.hpp"
#include "write/svg/svg_view.hpp"

namespace smurf::scene_svg_file {
namespace {

/// With more shapes, a view from the side is unreadable.
constexpr std::size_t kMostFromSide = 5'000;

/// The legend explains only symbols on the sheet.
std::string legend(const SceneExport& scene, bool lacks_meshes, bool lacks_side, bool lacks_names) {
  std::string text;
  double x = 0;
  const auto add = [&](const std::string& glyph, std::string_view words) {
    text += "<g transform=\"translate(" + pixels(x) + " 0)\">" + glyph + "<text x=\"26\">" +
            std::string(words) + "</text></g>\n";
    x += 44 + 6.6 * static_cast<double>(words.size());
  };
  constexpr std::string_view kNames[] = {"x", "y", "z"};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    add("<path d=\"M2 -4h18\" stroke-width=\"3\" stroke=\"" + std::string(kAxisColors[axis]) +
            "\"/>",
        kNames[axis]);
  }
  add("<circle cx=\"12\" cy=\"-4\" r=\"4.5\" fill=\"none\" stroke=\"#444\"/>"
      "<circle cx=\"12\" cy=\"-4\" r=\"1.8\"/>",
      "axis towards you");
  const auto& instances = scene.flat.instances;
  if (std::any_of(instances.begin(), instances.end(), is_fixed_to_world)) {
    add("<rect x=\"5\" y=\"-11\" width=\"14\" height=\"14\" fill=\"none\" stroke=\"#333\"/>",
        "fixed to the world");
  }
  if (std::any_of(instances.begin(), instances.end(), [](const FlatInstance& instance) {
        return instance.anchor.kind == Attachment::Kind::link;
      })) {
    add("<path d=\"M0 -4h22\" stroke=\"#333\" stroke-dasharray=\"5 4\"/>", "fixed to each other");
  }
  if (lacks_meshes) add("", "some meshes are not drawn");
  if (lacks_names) add("", "some names do not fit: point at the axes to read them");
  if (lacks_side) add("", "too many shapes for a view from the side");
  return text;
}

/// The x axis goes right as in the view from above, and z goes up.
Pose world_from_side() { return {{}, from_axis_angle({1, 0, 0}, -std::numbers::pi / 2)}; }

std::string write(const SceneExport& scene) {
  const SvgSelection selection(scene.flat);
  SvgOutlines outlines(scene);
  SvgView above(scene, selection, outlines, {});
  std::optional<SvgView> aside;
  if (above.shapes() <= kMostFromSide && scene.flat.instances.size() <= kMostFromSide) {
    aside.emplace(scene, selection, outlines, world_from_side());
  }
  const std::string title(path::file_name(scene.flat.scene));
  const double height = aside && !aside->extent().is_empty() ? aside->extent().size(1) : 0;
  SvgCanvas canvas(above.extent(), height, title + " from above, metres");
  std::optional<SvgCanvas> below;
  if (aside) below.emplace(canvas, aside->extent(), title + " from the side, metres");
  canvas.open(below ? below->height() : 0);
  above.draw(canvas);
  above.add_pointers(canvas);
  canvas.close_sheet();
  const bool lacks_names = canvas.lacks_names();
  if (below) {
    below->open_below(canvas);
    aside->draw(*below);
    below->close_sheet();
  }
  return (below ? *below : canvas)
      .finish(legend(scene, outlines.lacks_meshes(), !aside, lacks_names));
}

}  // namespace

extern constinit const SceneFormat scene_svg{
    .name = "svg",
    .help = "a picture from above and from the side, with axes and names",
    .write = write,
    .repeats_models = true};

}  // namespace smurf::scene_svg_file
