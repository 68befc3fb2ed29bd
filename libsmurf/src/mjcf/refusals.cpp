// SPDX-License-Identifier: BSD-3-Clause
// Values that MuJoCo refuses when it compiles the model, outside of bodies, joints and shapes.
#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/text/quoted.hpp"
#include "mjcf/model.hpp"

namespace smurf::mjcf {
namespace {

struct Limit {
  std::string_view section, limited, range;
};
constexpr Limit kLimits[] = {
    {"actuator", "ctrllimited", "ctrlrange"},
    {"actuator", "forcelimited", "forcerange"},
    {"actuator", "actlimited", "actrange"},
    {"tendon", "limited", "range"},
    {"tendon", "actuatorfrclimited", "actuatorfrcrange"},
    {"joint", "actuatorfrclimited", "actuatorfrcrange"},
};

class Refusals {
 public:
  Refusals(const ModelFile& file, Reporter& reporter) : file_(file), reporter_(reporter) {}

  /// `x` is limited, by itself or by a class, and has no range.
  void check_limits(std::string_view section, const Settings& s) {
    for (const Limit& one : kLimits) {
      if (one.section != section) continue;
      // `inheritrange` takes the range of the joint.
      if (one.range != "forcerange" && s.number("inheritrange", 0, reporter_) > 0) continue;
      const Attribute* limited = s.find(one.limited);
      const Attribute* written = s.find(one.range);
      std::array<double, 2> range{};
      s.numbers(one.range, range, 2, reporter_);
      const std::string_view state = limited != nullptr ? limited->value() : "auto";
      if (state == "true" && !(range[0] < range[1])) {
        reporter_.refuse(written != nullptr ? written->value_span() : s.element().name_span(),
                         quoted(one.limited) + " is true, and " + quoted(one.range) +
                             (written != nullptr ? " does not rise" : " is not set"),
                         "write the smaller and the larger bound in " + quoted(one.range));
      }
      if (state == "auto" && written != nullptr && !file_.compiler().autolimits &&
          (range[0] != 0 || range[1] != 0)) {
        reporter_.refuse(written->name_span(),
                         quoted(one.range) + " is set without " + quoted(one.limited) +
                             ", and `autolimits` is off",
                         "write `" + std::string(one.limited) + "=\"true\"`");
      }
    }
  }

  void check_condim(const Settings& s) {
    const Attribute* written = s.find("condim");
    if (written == nullptr) return;
    const double condim = s.number("condim", 3, reporter_);
    if (condim == 1 || condim == 3 || condim == 4 || condim == 6) return;
    reporter_.refuse(written->value_span(), "`condim` is 1, 3, 4 or 6",
                     "write 3 for friction in the plane of the contact");
  }

  void check_camera(const Settings& s) {
    const Attribute* written = s.find("fovy");
    if (written == nullptr || s.number("fovy", 45, reporter_) < 180) return;
    reporter_.refuse(written->value_span(), "`fovy` is not below 180 degrees",
                     "write the vertical angle of the image");
  }

  void check_site(const Settings& s) {
    const Attribute* written = s.find("size");
    if (written == nullptr) return;
    const std::string_view type = s.text("type");
    const std::size_t needed = type == "box" || type == "ellipsoid"      ? 3
                               : type == "capsule" || type == "cylinder" ? 2
                                                                         : 1;
    std::array<double, 3> size{1, 1, 1};
    s.numbers("size", size, 1, reporter_);
    const bool is_positive =
        std::all_of(size.begin(), size.begin() + static_cast<std::ptrdiff_t>(needed),
                    [](double one) { return !(one <= 0); });  // NaN is allowed
    if (!is_positive)
      reporter_.refuse(written->value_span(), "a size of the site is not positive",
                       "write half of each length");
  }

  /// Names that are twice in a section, among elements of one kind.
  void check_names(std::string_view section) {
    std::map<std::pair<std::string_view, std::string_view>, Span> known;
    file_.each_in(section, [&](View one) {
      const bool is_file = section == "asset" && one.name() != "material";
      const Attribute* written = one.attribute("name");
      const std::string_view name = is_file              ? texture_name(one)
                                    : written != nullptr ? std::string_view(written->value())
                                                         : std::string_view();
      if (name.empty()) return;
      const Span place = written != nullptr ? written->value_span() : one.name_span();
      const auto [first, is_new] = known.emplace(std::pair{one.name(), name}, place);
      if (is_new) return;
      reporter_
          .refuse(place,
                  "there is another " + std::string(one.name()) + " with the name " + quoted(name),
                  "rename one of the two")
          .label(first->second, "the other one");
    });
  }

  /// An asset that a shape or a site names; MuJoCo refuses `hfield` of other shapes, too.
  void check_asset_of(const Settings& s, std::string_view kind) {
    const Attribute* name = s.find(kind);
    const bool needs_one = kind == "hfield" && s.text("type") == kind;
    if (name == nullptr || name->value().empty()) {
      if (needs_one)
        reporter_.refuse(s.element().name_span(), "this shape needs an `hfield`",
                         "write the name of an hfield of `<asset>`");
      return;
    }
    bool is_known = false;
    file_.each_in("asset", [&](View one) {
      if (one.name() != kind) return;
      is_known = is_known || texture_name(one) == name->value();
    });
    if (!is_known)
      reporter_.refuse_name(name->value_span(),
                            "there is no " + std::string(kind) + " " + quoted(name->value()),
                            "add it to `<asset>`");
  }

  void check_assets() {
    std::set<std::string_view> textures;
    const auto name_of = [](View one) {
      const Attribute* name = one.attribute("name");
      return name != nullptr ? std::string_view(name->value()) : std::string_view();
    };
    file_.each_in("asset", [&](View one) {
      if (one.name() == "texture") textures.insert(texture_name(one));
    });
    file_.each_in("asset", [&](View one) {
      const std::string_view kind = one.name();
      const bool has_file = one.attribute("file") != nullptr;
      const bool is_material = kind == "material";
      if (!is_material && kind != "texture" && kind != "mesh" && kind != "hfield") return;
      const Settings s(one, file_.class_of(one, nullptr));
      const bool is_sky = kind == "texture" && s.text("type") == "skybox";
      if (name_of(one).empty() && !is_sky && (is_material || !has_file)) {
        reporter_.refuse(one.name_span(), "this " + std::string(kind) + " has no name",
                         is_material ? "write `name`" : "write `name`, or a `file`");
        return;
      }
      if (kind == "mesh" && !has_file && one.attribute("vertex") == nullptr &&
          one.attribute("builtin") == nullptr && one.begin() == one.end()) {
        reporter_.refuse(one.name_span(), "this mesh has no triangles", "write `file`");
      }
      if (kind == "texture") check_builtin(s);
      if (const Attribute* texture = is_material ? s.find("texture") : nullptr)
        check_texture(*texture, textures);
    });
  }

 private:
  /// The name, or that of the file.
  static std::string_view texture_name(View one) {
    if (const Attribute* name = one.attribute("name")) return name->value();
    const Attribute* file = one.attribute("file");
    if (file == nullptr) return {};
    std::string_view stem = file->value();
    stem = stem.substr(stem.find_last_of("/\\") + 1);
    return stem.substr(0, stem.rfind('.'));
  }

  void check_builtin(const Settings& s) {
    const std::string_view builtin = s.text("builtin");
    if (builtin.empty() || builtin == "none") return;
    for (const std::string_view side : {"width", "height"}) {
      // Of a cube, the height is six times the width.
      if (side == "height" && s.text("type") != "2d") continue;
      if (s.number(side, 0, reporter_) > 0) continue;
      const Attribute* written = s.find(side);
      reporter_.refuse(written != nullptr ? written->value_span() : s.element().name_span(),
                       "the " + std::string(side) + " of a built-in texture is not positive",
                       "write the number of pixels");
    }
  }

  void check_texture(const Attribute& texture, const std::set<std::string_view>& known) {
    if (texture.value().empty() || known.contains(texture.value())) return;
    const std::vector<std::string_view> names(known.begin(), known.end());
    Diagnostic& found = reporter_.refuse_name(texture.value_span(),
                                              "there is no texture " + quoted(texture.value()),
                                              "write the name of a texture of `<asset>`");
    if (const auto near = reporter_.context().sink.suggest(texture.value(), names))
      found.help("did you mean " + quoted(*near) + "?");
  }

  const ModelFile& file_;
  Reporter& reporter_;
};

}  // namespace

void check_refusals(const Model& model, Reporter& reporter) {
  const ModelFile& main = model.files.front();
  Refusals refusals(main, reporter);
  refusals.check_assets();
  for (const std::string_view section : {"asset", "custom", "contact"})
    refusals.check_names(section);
  for (const Reference& one : model.sections) {
    if (one.around.file != &main || !one.around.prefix.empty()) continue;
    const Settings settings(one.element, main.class_of(one.element, nullptr));
    refusals.check_limits(one.section, settings);
  }
  for (const Body& body : model.bodies) {
    for (const Joint& joint : body.joints) {
      if (joint.file == &main) refusals.check_limits("joint", joint.settings);
    }
    for (const Geom& geom : body.geoms) {
      if (geom.file != &main) continue;
      refusals.check_condim(geom.settings);
      refusals.check_asset_of(geom.settings, "hfield");
    }
  }
  for (const Site& site : model.sites) refusals.check_site(Settings(site.element, nullptr));
  for (const Camera& camera : model.cameras) refusals.check_camera(camera.settings);
}

}  // namespace smurf::mjcf
