// SPDX-License-Identifier: BSD-3-Clause
#include "smurf2urdf/verify.hpp"

#include "base/numbers.hpp"
#include "smurf/load.hpp"
#include "syntax/tinyxml2_referee.hpp"

namespace smurf::tools {

namespace {

/// A URDF read on its own.
struct Plain {
  SourceMap sources;
  MemoryFiles files;
  DiagnosticSink sink;
  LinkedModel model;

  explicit Plain(std::string_view urdf) {
    files.add("plain.urdf", std::string(urdf));
    LoadContext context{sources, files, sink, {}, {}};
    model = load_model("plain.urdf", context);
  }

  /// If options change mimics, all joints are compared as independent joints.
  void forget_mimics() {
    if (!model.robot) return;
    for (urdf::Joint& joint : model.robot->joints) joint.mimic.reset();
  }
};

}  // namespace

Verification verify(const LinkedModel& model, const SourceMap& sources, const std::string& urdf,
                    const UrdfExport& options, bool may_ask_urdfdom) {
  Verification verification;
  Plain plain(urdf);
  LinkedModel& result = plain.model;
  if (!result.robot) {
    verification.problem = "the result cannot be read again; this is a defect of this tool";
    return verification;
  }
  verification.links = result.robot->links.size();
  verification.joints = result.robot->joints.size();
  verification.tinyxml2_accepts =
      read_by_tinyxml2(result.robot->document, plain.sources, plain.sink);
  if (!verification.tinyxml2_accepts) {
    verification.problem = "tinyxml2: " + plain.sink.diagnostics().back().message;
    return verification;
  }
  verification.strict_fault = why_strict_readers_refuse(result, urdf);
  if (options.apply.mimic) {
    Plain source(sources.text(model.robot->document.source));
    source.model.annotations.materials = model.annotations.materials;
    source.forget_mimics();
    plain.forget_mimics();
    verification.proof = compare_models(source.model, result, proof_scope(options));
  } else {
    verification.proof = compare_models(model, result, proof_scope(options));
  }
  if (!verification.proof.holds()) {
    verification.problem = "the exported robot differs: " + verification.proof.difference;
  }
  // urdfdom before 5.1 refuses every version but 1.0.
  const bool is_known = options.version.empty() || options.version == "1.0";
  if (!may_ask_urdfdom || !is_known) return verification;
  verification.urdfdom = ask_urdfdom(urdf);
  if (verification.urdfdom.was_asked && !verification.urdfdom.accepts) {
    const std::string& words = verification.urdfdom.messages;
    verification.problem = "urdfdom refuses the result: " + words.substr(0, words.find('\n'));
  }
  return verification;
}

std::string describe(const Verification& verification) {
  const Proof& proof = verification.proof;
  const auto line = [](std::string_view what, double figure, std::string_view unit) {
    return std::string(what) + format_rounded(figure) + std::string(unit) + "\n";
  };
  std::string text = "compared " + std::to_string(proof.links) + " links at " +
                     std::to_string(proof.joint_positions) + " joint positions\n";
  text += line("  largest distance of a link  ", proof.position, " m");
  text += line("  largest angle of a link     ", proof.angle, " rad");
  text += line("  total mass                  ", proof.mass, " relative");
  text += line("  centre of mass              ", proof.center_of_mass, " m");
  text += line("  inertia                     ", proof.inertia, " relative");
  text += line("  joint limits                ", proof.limits, " relative");
  const auto verdict = [](bool accepts) { return accepts ? "accepts\n" : "refuses\n"; };
  text += std::string("  tinyxml2                    ") + verdict(verification.tinyxml2_accepts);
  text += "  urdfdom                     ";
  if (!verification.urdfdom.was_asked) return text + "not asked\n";
  return text + verdict(verification.urdfdom.accepts);
}

}  // namespace smurf::tools
