// SPDX-License-Identifier: BSD-3-Clause
// The graph of frames: which pose is relative to which, and which frame moves with which link.
#include "base/findings/rules.hpp"
#include "base/text/quoted.hpp"
#include "sdf/model.hpp"

namespace smurf::sdformat {
namespace {

constexpr int kDeepest = 1000;  // frames that are relative to each other, one after the other

Span relative_place(const Vertex& vertex) {
  if (vertex.pose) {
    for (const std::string_view name : {"relative_to", "frame"}) {
      const Attribute* one = vertex.pose.attribute(name);
      if (one != nullptr && !one->value().empty()) return one->value_span();
    }
  }
  if (const Attribute* one = vertex.element.attribute("attached_to")) return one->value_span();
  if (const View child = vertex.element.child("child"); child && !text_of(child).empty())
    return child.text_span();
  return vertex.element.name_span();
}

}  // namespace

Vertex* Frames::find(const Scope& scope, std::string_view name) {
  const auto known = scope.names.find(name);
  if (known != scope.names.end()) return known->second;
  const std::size_t at = name.find("::");
  if (at != std::string_view::npos) {
    const auto head = scope.names.find(name.substr(0, at));
    if (head != scope.names.end() && head->second->inner != nullptr) {
      if (Vertex* found = find(*head->second->inner, name.substr(at + 2))) return found;
    }
  }
  return scope.is_merged && scope.outer != nullptr ? find(*scope.outer, name) : nullptr;
}

const Pose& Frames::in_scope(Vertex& vertex) {
  if (vertex.state == Vertex::State::done) return vertex.X_S;
  if (vertex.state == Vertex::State::visiting || depth_ > kDeepest) {
    reporter_.refuse(relative_place(vertex),
                     vertex.state == Vertex::State::visiting
                         ? "the pose of " + quoted(vertex.name) + " is relative to itself"
                         : "more than " + std::to_string(kDeepest) +
                               " poses are relative to each other, one after the other",
                     "name another frame");
    vertex.state = Vertex::State::done;
    vertex.X_S = vertex.raw;
    return vertex.X_S;
  }
  vertex.state = Vertex::State::visiting;
  ++depth_;
  std::string_view base = vertex.relative_to;
  const bool is_own_default =
      vertex.kind == Vertex::Kind::joint || vertex.kind == Vertex::Kind::frame;
  if (base.empty() && is_own_default) base = vertex.attached_to;
  Pose X = express(*vertex.scope, base, relative_place(vertex)) * vertex.raw;
  if (vertex.inner != nullptr && !vertex.inner->placement_frame.empty()) {
    Scope& inner = *vertex.inner;
    X = X * inverse(express(inner, inner.placement_frame, inner.placement_place));
  }
  --depth_;
  if (vertex.state == Vertex::State::visiting) {  // otherwise a cycle was found
    vertex.X_S = X;
    vertex.state = Vertex::State::done;
  }
  return vertex.X_S;
}

Pose Frames::in(Vertex& vertex, const Scope& target) {
  Pose X = in_scope(vertex);
  const Scope* at = vertex.scope;
  while (at != &target && at->vertex != nullptr) {
    X = in_scope(*at->vertex) * X;
    at = at->outer;
  }
  if (at == &target || target.vertex == nullptr) return X;
  // A merged element names one of the model around it.
  return inverse(in(*target.vertex, *at)) * X;
}

Pose Frames::in_world(Vertex& vertex) {
  const Scope* top = vertex.scope;
  while (top->outer != nullptr) top = top->outer;
  return in(vertex, *top);
}

std::optional<Pose> Frames::pose_of(Scope& scope, std::string_view name) {
  if (name.empty() || name == "__model__") return Pose{};
  if (name == "world" && scope.is_world) return Pose{};
  Vertex* vertex = find(scope, name);
  if (vertex == nullptr && name.ends_with("::__model__"))
    vertex = find(scope, name.substr(0, name.size() - 11));
  return vertex != nullptr ? std::optional(in(*vertex, scope)) : std::nullopt;
}

Pose Frames::express(Scope& scope, std::string_view name, Span place) {
  const auto pose = pose_of(scope, name);
  if (!pose)
    reporter_.refuse_name(place, "there is no frame " + quoted(name) + " in " + quoted(scope.name),
                          "name a link, a joint, a frame or a model in it");
  return pose.value_or(Pose{});
}

std::optional<Pose> Frames::express_late(Scope& scope, std::string_view name, Span place) {
  auto pose = pose_of(scope, name);
  if (!pose)
    reporter_
        .report(rules::sml9314_ignored_by_sdformat, place,
                "there is no frame " + quoted(name) + " in " + quoted(scope.name) +
                    ", so this has no effect")
        .help("name a link, a joint, a frame or a model in it");
  return pose;
}

void Frames::index_links(std::deque<Link>& links) {
  for (std::size_t i = 0; i < links.size(); ++i)
    links_.emplace(links[i].vertex, static_cast<LinkIndex>(i));
}

std::optional<Body> Frames::canonical(Scope& scope, int depth) {
  if (depth > kDeepest) return std::nullopt;
  if (scope.is_world) return Body{};
  if (!scope.canonical_link.empty()) return body_of(scope, scope.canonical_link, depth + 1);
  for (const Vertex* one : scope.order) {
    if (one->kind == Vertex::Kind::link) return Body{links_.at(one)};
  }
  for (const Vertex* one : scope.order) {
    if (one->inner != nullptr) {
      if (const auto found = canonical(*one->inner, depth + 1)) return found;
    }
  }
  return std::nullopt;
}

std::optional<Body> Frames::body_of(Scope& scope, std::string_view name, int depth) {
  if (depth > kDeepest) return std::nullopt;
  if (name == "world") return Body{};
  if (name.empty() || name == "__model__") return canonical(scope, depth + 1);
  Vertex* vertex = find(scope, name);
  if (vertex == nullptr && name.ends_with("::__model__"))
    vertex = find(scope, name.substr(0, name.size() - 11));
  if (vertex == nullptr) return std::nullopt;
  switch (vertex->kind) {
  case Vertex::Kind::link: return Body{links_.at(vertex)};
  case Vertex::Kind::model: return canonical(*vertex->inner, depth + 1);
  case Vertex::Kind::joint:
    if (vertex->attached_to.empty()) return std::nullopt;
    return body_of(*vertex->scope, vertex->attached_to, depth + 1);
  case Vertex::Kind::frame: break;
  }
  return body_of(*vertex->scope, vertex->attached_to, depth + 1);
}

}  // namespace smurf::sdformat
