// SPDX-License-Identifier: BSD-3-Clause
// The tree of bodies in the order of MuJoCo, with frames composed, copies made and models attached.
#include <algorithm>
#include <functional>
#include <map>

#include "base/files/path.hpp"
#include "base/findings/rules.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/quoted.hpp"
#include "base/text/words.hpp"
#include "mjcf/meshes.hpp"
#include "mjcf/model.hpp"

namespace smurf::mjcf {
namespace {

class Builder {
 public:
  Builder(Reporter& reporter, Model& model)
      : reporter_(reporter), model_(model), meshes_(reporter) {}

  bool run(SourceId root) {
    ModelFile& file = model_.files.emplace_back(root, reporter_);
    if (!file.read()) return false;
    const Attribute* name = file.root().attribute("model");
    model_.name = name != nullptr ? name->value() : "MuJoCo Model";
    Body& world = model_.bodies.emplace_back();
    world.name = "world";
    world.has_name = true;
    world.element = file.root();
    world.file = &file;
    names_["body"].emplace("world", Span{});
    Surroundings around;
    around.file = &file;
    add_sections(around);
    file.each(file.root(), [&](View one) {
      if (one.name() == "worldbody") content(one, 0, Pose{}, around, 1);
    });
    return true;
  }

 private:
  xacro::FrameId add_frame(xacro::Frame::Kind kind, xacro::FrameId parent, Span call,
                           std::string name) {
    xacro::Frame frame;
    frame.kind = kind;
    frame.parent = parent;
    frame.call = call;
    frame.name = std::move(name);
    model_.frames.push_back(std::move(frame));
    return xacro::FrameId{static_cast<std::uint32_t>(model_.frames.size() - 1)};
  }

  void add_sections(const Surroundings& around) {
    const ModelFile& file = *around.file;
    file.each(file.root(), [&](View section) {
      if (section.name() == "worldbody" || section.name() == "default" ||
          section.name() == "asset" || section.name() == "compiler")
        return;
      const bool is_named =
          around.prefix.empty() && around.file == &model_.files.front() && !has_sections_ &&
          is_one_of(section.name(), {"actuator", "sensor", "tendon", "keyframe", "equality"});
      file.each(section, [&](View one) {
        model_.sections.push_back({section.name(), one, around});
        if (is_named) name_of(one, around, section.name());
      });
    });
    has_sections_ = true;
  }

  std::string name_of(View element, const Surroundings& around, std::string_view kind) {
    const Attribute* name = element.attribute("name");
    if (name == nullptr || name->value().empty()) return {};
    std::string full = around.prefix + std::string(name->value()) + around.suffix;
    const auto [known, is_new] = names_[kind].emplace(full, name->value_span());
    if (!is_new) {
      Diagnostic& found = reporter_.refuse(name->value_span(),
                                           "there is another " + std::string(kind) +
                                               " with the name " + quoted(full),
                                           "rename one of the two");
      if (!known->second.empty() && known->second != name->value_span())
        found.label(known->second, "the other one");
    }
    return full;
  }

  const DefaultClass* childclass_of(View element, const Surroundings& around) {
    const Attribute* written = element.attribute("childclass");
    if (written == nullptr) return around.childclass;
    return around.file->named_class(*written);
  }

  /// A body of MuJoCo needs ten times the memory of a part of a URDF.
  std::uint64_t most_parts() const { return reporter_.context().limits.urdf_parts / 10; }

  bool has_room(View element) {
    if (++parts_ <= most_parts()) return true;
    if (!is_full_) {
      reporter_.exceed(element.name_span(),
                       "the model has more than " + std::to_string(most_parts()) + " parts",
                       "urdf-parts");
    }
    is_full_ = true;
    return false;
  }

  /// The elements that an element becomes, with all copies; attached models count as one.
  static double parts_of(View element, const ModelFile& file) {
    double parts = 1;
    file.each(element, [&](View one) { parts += parts_of(one, file); });
    const Attribute* count = element.name() == "replicate" ? element.attribute("count") : nullptr;
    const auto number = count != nullptr ? parse_number(count->value()) : std::nullopt;
    return number && *number > 1 ? parts * *number : parts;
  }

  void content(View element, std::uint32_t index, const Pose& X, const Surroundings& around,
               std::size_t depth) {
    if (depth > 1000) return;
    const ModelFile& file = *around.file;
    file.each(element, [&](View child) {
      if (is_full_ || !has_room(child)) return;
      const std::string_view kind = child.name();
      if (kind == "body") {
        body(child, index, X, around, depth);
      } else if (kind == "joint" || kind == "freejoint") {
        joint(child, index, X, around);
      } else if (kind == "geom") {
        geom(child, index, X, around);
      } else if (kind == "inertial") {
        if (index == 0) {
          reporter_.refuse(child.name_span(), "the world has no mass", "delete it");
        } else {
          model_.bodies[index].inertial = child;
        }
      } else if (kind == "light") {
        name_of(child, around, "light");
      } else if (kind == "frame") {
        name_of(child, around, "frame");
        frame(child, index, X, around, depth);
      } else if (kind == "replicate") {
        replicate(child, index, X, around, depth);
      } else if (kind == "attach") {
        attach(child, index, X, around, depth);
      } else if (kind == "site") {
        Site& site = model_.sites.emplace_back();
        site.name = name_of(child, around, "site");
        site.body = index;
        site.pose = X * pose_of(Settings(child, around.file->class_of(child, around.childclass)),
                                file.compiler(), reporter_);
        site.element = child;
        site.frame = around.frame;
      } else if (kind == "camera") {
        Camera& camera = model_.cameras.emplace_back();
        camera.name = name_of(child, around, "camera");
        camera.body = index;
        camera.settings = Settings(child, around.file->class_of(child, around.childclass));
        camera.pose = X * pose_of(camera.settings, file.compiler(), reporter_);
      } else if (kind == "flexcomp") {
        flex(child, index, X, around);
      }
    });
  }

  void body(View element, std::uint32_t parent, const Pose& X, const Surroundings& around,
            std::size_t depth) {
    const auto index = static_cast<std::uint32_t>(model_.bodies.size());
    Body& body = model_.bodies.emplace_back();
    body.element = element;
    body.file = around.file;
    body.frame = around.frame;
    body.parent = parent;
    body.name = name_of(element, around, "body");
    body.has_name = !body.name.empty();
    const Settings settings(element, nullptr);
    body.pose = X * pose_of(settings, around.file->compiler(), reporter_);
    if (const Attribute* mocap = element.attribute("mocap"))
      body.is_mocap = truth_of(*mocap, reporter_).value_or(false);
    body.gravcomp = settings.number("gravcomp", 0, reporter_);
    Surroundings inner = around;
    inner.childclass = childclass_of(element, around);
    const InertiaFromGeom from_geom = around.file->compiler().inertiafromgeom;
    inner.weighs_geoms = from_geom == InertiaFromGeom::yes;
    if (from_geom == InertiaFromGeom::automatic) {
      inner.weighs_geoms = true;
      around.file->each(element, [&](View one) {
        if (one.name() == "inertial") inner.weighs_geoms = false;
      });
    }
    content(element, index, Pose{}, inner, depth + 1);
    check_joints(model_.bodies[index]);
  }

  void check_joints(const Body& body) {
    if (body.is_mocap && (!body.joints.empty() || body.parent != 0)) {
      reporter_.refuse(body.element.name_span(),
                       "a mocap body is a child of the world without joints",
                       "delete `mocap`, or the joints");
    }
    std::size_t freedoms = 0;
    bool has_ball = false;
    for (const Joint& one : body.joints) {
      const Span place = one.settings.element().name_span();
      const bool is_free = one.type == Joint::Type::free;
      if (is_free && body.parent != 0)
        reporter_.refuse(place, "only a child of the world has a free joint",
                         "move the body into `<worldbody>`, or give it another joint");
      if (has_ball && (one.type == Joint::Type::hinge || one.type == Joint::Type::ball))
        reporter_.refuse(place, "a joint that turns follows a ball joint of the same body",
                         "delete one of the two");
      has_ball = has_ball || one.type == Joint::Type::ball;
      freedoms += is_free ? 6 : one.type == Joint::Type::ball ? 3 : 1;
      if (freedoms > 6)
        reporter_.refuse(place, "the joints of a body have more than six degrees of freedom",
                         "delete some of them");
    }
  }

  void flex(View element, std::uint32_t index, const Pose& X, const Surroundings& around) {
    reporter_
        .report(rules::sml9304_lost_in_urdf, element.name_span(),
                "a URDF has no soft bodies, so the points of this one are not held together")
        .help("keep the MJCF for it");
    for (Body& point : points_of_flex(element, X, around, reporter_)) {
      if (!has_room(element)) return;
      point.parent = index;
      model_.bodies.push_back(std::move(point));
    }
  }

  void joint(View element, std::uint32_t index, const Pose& X, const Surroundings& around) {
    if (index == 0) {
      reporter_.refuse(element.name_span(), "the world has no joints", "put it into a `<body>`");
      return;
    }
    Joint joint = read_joint(element, around, reporter_);
    joint.name = name_of(element, around, "joint");
    const Vector3 moved = rotate(X.orientation, joint.position);
    for (std::size_t i = 0; i < 3; ++i) joint.position[i] = X.position[i] + moved[i];
    joint.axis = rotate(X.orientation, joint.axis);
    model_.bodies[index].joints.push_back(std::move(joint));
  }

  void geom(View element, std::uint32_t index, const Pose& X, const Surroundings& around) {
    auto geom = read_geom(element, around, meshes_, index == 0, reporter_);
    if (!geom) return;
    geom->name = name_of(element, around, "geom");
    geom->pose = X * geom->pose;
    geom->mesh_pose = X * geom->mesh_pose;
    if (geom->mass) geom->mass = geom->mass->in(X);
    model_.bodies[index].geoms.push_back(*std::move(geom));
  }

  void replicate(View element, std::uint32_t index, const Pose& X, const Surroundings& around,
                 std::size_t depth) {
    const Settings settings(element, nullptr);
    const Attribute* count_attribute = element.attribute("count");
    if (count_attribute == nullptr) {
      reporter_.refuse(element.name_span(), "`replicate` needs a `count`",
                       "write the number of copies");
      return;
    }
    const double written = settings.number("count", 1, reporter_);
    if (!(written >= 1)) {
      reporter_.refuse(count_attribute->value_span(), "there are no copies",
                       "write a count of at least 1");
      return;
    }
    // Before anything is copied: three lines can mean a billion copies.
    if (parts_of(element, *around.file) > static_cast<double>(most_parts())) {
      reporter_.exceed(count_attribute->value_span(),
                       "the copies have more than " + std::to_string(most_parts()) + " parts",
                       "urdf-parts");
      is_full_ = true;
      return;
    }
    const auto count = static_cast<std::size_t>(written);
    const std::string separator(settings.text("sep"));
    const std::size_t digits = std::to_string(count - 1).size();
    Vector3 offset{};
    settings.numbers("offset", offset, 3, reporter_);
    // MuJoCo ignores `pos` and `quat` here.
    Pose step{offset, element.attribute("quat") == nullptr
                          ? pose_of(settings, around.file->compiler(), reporter_).orientation
                          : Quaternion{}};
    Pose at = X;
    for (std::size_t i = 0; i < count && !is_full_; ++i) {
      std::string number = std::to_string(i);
      number.insert(0, digits - number.size(), '0');
      Surroundings inner = around;
      inner.childclass = childclass_of(element, around);
      inner.suffix = separator + number + around.suffix;
      inner.frame = add_frame(xacro::Frame::Kind::include, around.frame, element.tag_span(),
                              "copy " + number);
      content(element, index, at, inner, depth + 1);
      at = at * step;
    }
  }

  /// A body or a frame of a name in the trees of a file; before the place, if one is given.
  static View find_in(const ModelFile& file, std::string_view kind, std::string_view name) {
    View wanted;
    const std::function<void(View)> search = [&](View at) {
      file.each(at, [&](View one) {
        if (wanted) return;
        const Attribute* own = one.attribute("name");
        if (one.name() == kind && own != nullptr && own->value() == name) {
          wanted = one;
        } else {
          search(one);
        }
      });
    };
    file.each(file.root(), [&](View one) {
      if (one.name() == "worldbody") search(one);
    });
    return wanted;
  }

  void attach(View element, std::uint32_t index, const Pose& X, const Surroundings& around,
              std::size_t depth) {
    const Attribute* model_name = element.attribute("model");
    const Attribute* part = element.attribute("body");
    const std::string_view kind = part != nullptr ? "body" : "frame";
    if (part == nullptr) part = element.attribute("frame");
    if (model_name == nullptr && part == nullptr) {
      reporter_.refuse(element.name_span(), "`attach` needs a `model`, a `body` or a `frame`",
                       "write the name of a `<model>` in `<asset>`");
      return;
    }
    const ModelFile* file = model_name != nullptr ? attached(*model_name, around) : around.file;
    if (file == nullptr) return;
    const std::uint64_t most = reporter_.context().limits.include_depth;
    if (depth > most) {
      reporter_.exceed(element.name_span(),
                       "models are attached in more than " + std::to_string(most) + " levels",
                       "include-depth");
      return;
    }
    View wanted;
    if (part != nullptr) {
      wanted = find_in(*file, kind, part->value());
      const bool is_behind = wanted && model_name == nullptr &&
                             wanted.span().source == element.span().source &&
                             wanted.span().end > element.span().begin;
      if (!wanted || is_behind) {
        reporter_.refuse_name(part->value_span(),
                              "there is no " + std::string(kind) + " " + quoted(part->value()) +
                                  (model_name != nullptr ? " in " + quoted(model_name->value())
                                                         : " before this place"),
                              "write the name of one that is there");
        return;
      }
    }
    const Attribute* prefix = element.attribute("prefix");
    Surroundings inner;
    inner.file = file;
    inner.prefix =
        around.prefix + std::string(prefix != nullptr ? prefix->value() : std::string_view());
    inner.suffix = around.suffix;
    inner.weighs_geoms = around.weighs_geoms;
    inner.frame =
        add_frame(xacro::Frame::Kind::include, around.frame, element.tag_span(),
                  part != nullptr ? std::string(part->value())
                                  : reporter_.context().sources.path(file->root().span().source));
    if (!wanted) {
      file->each(file->root(), [&](View one) {
        if (one.name() == "worldbody") content(one, index, X, inner, depth + 1);
      });
    } else if (kind == "body") {
      body(wanted, index, X, inner, depth + 1);
    } else {
      frame(wanted, index, X, inner, depth);
    }
    add_sections(inner);
  }

  void frame(View element, std::uint32_t index, const Pose& X, const Surroundings& around,
             std::size_t depth) {
    Surroundings inner = around;
    inner.childclass = childclass_of(element, around);
    const Pose own = pose_of(Settings(element, nullptr), around.file->compiler(), reporter_);
    content(element, index, X * own, inner, depth + 1);
  }

  const ModelFile* attached(const Attribute& name, const Surroundings& around) {
    const Attribute* path_attribute = nullptr;
    bool is_known = false;
    around.file->each_in("asset", [&](View one) {
      const Attribute* own = one.attribute("name");
      if (one.name() != "model") return;
      const Attribute* file = one.attribute("file");
      const std::string_view usual =
          file != nullptr ? path::stem(file->value()) : std::string_view();
      if ((own != nullptr ? own->value() : usual) != name.value()) return;
      path_attribute = file;
      is_known = true;
    });
    if (!is_known || path_attribute == nullptr) {
      reporter_.refuse_name(name.value_span(), "there is no model " + quoted(name.value()),
                            "add `<model>` to `<asset>`");
      return nullptr;
    }
    const std::string path = path::join(around.file->folder(), path_attribute->value());
    const auto [known, is_new] = attached_.emplace(path, nullptr);
    if (!is_new) {
      if (known->second == nullptr)
        reporter_.refuse(path_attribute->value_span(), quoted(path) + " attaches itself",
                         "attach another model");
      return known->second;
    }
    Context& context = reporter_.context();
    FileContent content = context.files.read(path, context.limits.file_bytes);
    if (content.status != ReadStatus::ok) {
      reporter_.refuse(path_attribute->value_span(),
                       "cannot read " + quoted(path) + ": " + content.reason,
                       "correct the path, which begins at the folder of the main file");
      return nullptr;
    }
    ModelFile& file =
        model_.files.emplace_back(context.sources.add(path, std::move(content.text)), reporter_);
    if (!file.read()) return nullptr;
    return known->second = &file;
  }

  Reporter& reporter_;
  Model& model_;
  Meshes meshes_;
  std::map<std::string_view, std::map<std::string, Span>> names_;
  std::map<std::string, const ModelFile*> attached_;
  std::uint64_t parts_ = 0;
  bool is_full_ = false;
  bool has_sections_ = false;
};

}  // namespace

bool build(SourceId root, Reporter& reporter, Model& model) {
  return Builder(reporter, model).run(root);
}

}  // namespace smurf::mjcf
