// SPDX-License-Identifier: BSD-3-Clause
// Robots with other shapes for their collision meshes, for the time of a conversion.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "conversion/collision_shapes.hpp"
#include "conversion/collision_texts.hpp"
#include "smurf/conversion.hpp"
#include "write/parts/body_inertia.hpp"

namespace smurf {

/// What replaced collisions are written into.
struct CollisionOutput {
  std::string output_folder;
  std::string current_folder;  ///< absolute
  bool makes_names = false;  ///< the text of the robot is the result: new collisions have new names
  bool names_meshes = true;  ///< by their files
  bool has_capsules = true;  ///< false: only as far as the version of a URDF has them
};

/// Gives loaded models robots with other collision shapes, and their findings, until restore() is
/// called.
class ReplacedCollisions {
 public:
  /// All of it must outlive this object.
  ReplacedCollisions(Session& session, Loaded& loaded, const CollisionRequest& request,
                     CollisionOutput output);
  ~ReplacedCollisions() { restore(); }
  ReplacedCollisions(const ReplacedCollisions&) = delete;
  ReplacedCollisions& operator=(const ReplacedCollisions&) = delete;

  /// Replaces the collisions of all models, and reports what becomes of their meshes. If that is
  /// not possible, returns why; then the models are as before. Call it once.
  Refusal apply(std::span<LinkedModel* const> models);
  /// Gives the models their robots back, and findings their places in those.
  void restore();

  /// Findings about the robots with new shapes, with their places in the robots before. Call it
  /// before restore().
  std::vector<Diagnostic> placed(std::vector<Diagnostic> findings) const;

  /// Also reads the new meshes, which are not written yet.
  const FileReader& files() const { return files_; }
  const KeptMasses& masses() const { return masses_; }
  /// The new meshes, by their paths in the output folder.
  std::vector<TextFile> take_meshes() { return std::move(meshes_); }
  std::vector<ReplacedCollision> take_collisions() { return std::move(replaced_); }

 private:
  struct Job {
    const MeshReference* mesh = nullptr;
    Vector3 scale{1, 1, 1};
    CollisionShapes shapes = CollisionShapes::keep;
    std::optional<double> volume;
    bool names_meshes = true;  ///< by their files
    bool has_capsules = true;
    std::size_t uses = 0;
    NewShapes made;
  };
  struct Use {
    LinkedModel* model = nullptr;
    CollisionPlace place;
    Job* job = nullptr;
  };
  struct Changed {
    LinkedModel* model = nullptr;
    SourceId source{};  ///< of the new text
    std::unique_ptr<CollisionTexts> texts;
    LinkedModel others;  ///< the robot that the model had, and what belongs to it
  };

  void find_uses(LinkedModel& model);
  void find_use(LinkedModel& model, CollisionPlace place, CollisionShapes shapes);
  Refusal make_shapes();
  Refusal change(LinkedModel& model);
  std::optional<LinkedModel> load(const LinkedModel& model, std::string text);
  std::string name_in(const LinkedModel& model, const std::string& file);
  void report();

  Session& session_;
  Loaded& loaded_;
  const CollisionRequest& request_;
  CollisionOutput output_;
  MemoryFiles files_;
  MeshLibrary library_;
  std::map<std::string, Job> jobs_;  ///< by file, scale and shapes
  std::vector<Job*> order_;
  std::vector<Use> uses_;
  std::vector<Changed> changed_;
  KeptMasses masses_;
  std::vector<TextFile> meshes_;
  std::vector<ReplacedCollision> replaced_;
  std::optional<DiagnosticSink> before_;  ///< findings
};

/// Reports what became of the collision meshes; their places are in the text of the robot.
void report_collisions(std::span<const ReplacedCollision> replaced, DiagnosticSink& sink);

/// "has no link that fits `finger_*`" of --collision; "" if each choice fits one.
std::string unknown_links(const CollisionRequest& request,
                          std::span<const LinkedModel* const> models);
/// The choice for a link.
CollisionShapes shapes_for(const CollisionRequest& request, std::string_view link);
/// The choices that fit a link of the model.
std::vector<CollisionChoice> choices_for(const CollisionRequest& request, const LinkedModel& model);

}  // namespace smurf
