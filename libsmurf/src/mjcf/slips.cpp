// SPDX-License-Identifier: BSD-3-Clause
// What MuJoCo does as it is written, and the author hardly meant.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "base/findings/rules.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/quoted.hpp"
#include "mjcf/model.hpp"

namespace smurf::mjcf {
namespace {

/// `<joint type="free">` takes the defaults of hinges, `<freejoint>` does not.
void report_held_bases(const Model& model, Reporter& reporter) {
  constexpr std::string_view kHolding[] = {"damping", "frictionloss", "armature", "stiffness"};
  for (const Body& body : model.bodies) {
    for (const Joint& joint : body.joints) {
      if (joint.type != Joint::Type::free) continue;
      const View element = joint.settings.element();
      for (const std::string_view name : kHolding) {
        const Attribute* set = joint.settings.find(name);
        if (set == nullptr || element.attribute(name) != nullptr ||
            joint.settings.number(name, 0, reporter) == 0)
          continue;
        reporter
            .report(rules::sml9308_default_holds_base, element.name_span(),
                    quoted(name) + " of the defaults acts on the free joint of " +
                        quoted(body.name) + ", too")
            .label(set->value_span(), "set here")
            .help("write `<freejoint/>`, which takes no defaults");
        break;
      }
    }
  }
}

constexpr double kTurn = 2 * std::numbers::pi;

/// 1.57 and 3.1416 are such values: parts of a half turn, with two decimals at least.
bool is_part_of_pi(double value) {
  constexpr double kStep = std::numbers::pi / 12;
  const double steps = std::round(std::fabs(value) / kStep);
  return steps >= 1 && std::fabs(std::fabs(value) - steps * kStep) < 0.005;
}

/// 45, 90 and 170 are such values.
bool is_round_degree(double value) {
  return value > 2 * kTurn && value <= 360 && std::fmod(value, 5) == 0;
}

/// Ranges of hinges that look as if they were in the other unit, in most of a file.
void report_units(const Model& model, const ModelFile& file, Reporter& reporter) {
  const bool is_degree = file.compiler().is_degree;
  const Attribute* first = nullptr;
  std::size_t ranges = 0, of_other = 0;
  double largest = 0;
  std::set<const Attribute*> known;
  for (const Body& body : model.bodies) {
    for (const Joint& joint : body.joints) {
      if (joint.file != &file || joint.type != Joint::Type::hinge || !joint.is_limited) continue;
      const Attribute* range = joint.settings.find("range");
      if (range == nullptr || !known.insert(range).second) continue;
      const double unit = is_degree ? kDegree : 1;
      const double low = std::fabs(joint.range[0] / unit), high = std::fabs(joint.range[1] / unit);
      ++ranges;
      largest = std::max({largest, low, high});
      const bool is_of_other = is_degree ? is_part_of_pi(low) || is_part_of_pi(high)
                                         : is_round_degree(low) || is_round_degree(high);
      if (!is_of_other) continue;
      if (first == nullptr) first = range;
      ++of_other;
    }
  }
  // A range of 3 degrees is rare, and one of 3 turns is, too.
  if (first == nullptr || 2 * of_other < ranges || (is_degree && largest > kTurn)) return;
  const bool is_default = !file.compiler().angle_place;
  reporter
      .report(rules::sml9309_angle_unit, first->value_span(),
              "the range " + quoted(first->value()) + " is in " +
                  (is_degree ? "degrees" : "radians") + (is_default ? ", MuJoCo's default" : "") +
                  "; are " + (is_degree ? "radians" : "degrees") + " meant?")
      .help(std::string("write `<compiler angle=\"") + (is_degree ? "radian" : "degree") +
            "\"/>` if all angles of the file are in " + (is_degree ? "radians" : "degrees"));
}

/// The bodies whose shapes have a bit. Two shapes of one body never touch.
class BodiesByBit {
 public:
  void add(std::int64_t bits, const Body& body) {
    for_each_bit(bits, [&](std::size_t bit) {
      Bodies& bodies = bodies_[bit];
      if (bodies.first == nullptr) bodies.first = &body;
      bodies.has_others = bodies.has_others || bodies.first != &body;
    });
  }

  bool have_any(std::int64_t bits, const Body& besides) const {
    bool has_one = false;
    for_each_bit(bits, [&](std::size_t bit) {
      const Bodies& bodies = bodies_[bit];
      const bool is_elsewhere = bodies.first != nullptr && bodies.first != &besides;
      has_one = has_one || bodies.has_others || is_elsewhere;
    });
    return has_one;
  }

 private:
  static constexpr std::size_t kBits = 64;
  struct Bodies {
    const Body* first = nullptr;
    bool has_others = false;
  };

  template <class F>
  static void for_each_bit(std::int64_t bits, const F& visit) {
    for (std::size_t bit = 0; bit < kBits; ++bit) {
      if ((static_cast<std::uint64_t>(bits) >> bit & 1U) != 0) visit(bit);
    }
  }

  std::array<Bodies, kBits> bodies_{};
};

/// Shapes with bits for contacts which no shape of another body has.
void report_hidden_shapes(const Model& model, Reporter& reporter) {
  BodiesByBit contypes, conaffinities;
  std::set<std::string_view> paired;
  for (const Body& body : model.bodies) {
    for (const Geom& geom : body.geoms) {
      contypes.add(geom.contype, body);
      conaffinities.add(geom.conaffinity, body);
    }
  }
  for (const Reference& one : model.sections) {
    if (one.section != "contact" || one.element.name() != "pair") continue;
    for (const std::string_view end : {"geom1", "geom2"}) {
      if (const Attribute* name = one.element.attribute(end)) paired.insert(name->value());
    }
  }
  const auto is_hidden = [&](const Body& body, const Geom& geom) {
    // A floor of another file has the bits that MuJoCo gives without any.
    const bool meets_floor = ((geom.contype | geom.conaffinity) & 1) != 0;
    return touches(geom) && !meets_floor && !conaffinities.have_any(geom.contype, body) &&
           !contypes.have_any(geom.conaffinity, body);
  };
  const Geom* first = nullptr;
  std::size_t count = 0;
  for (const Body& body : model.bodies) {
    for (const Geom& geom : body.geoms) {
      if (!is_hidden(body, geom) || paired.contains(geom.name)) continue;
      if (first == nullptr) first = &geom;
      ++count;
    }
  }
  if (first == nullptr) return;
  reporter
      .report(
          rules::sml9310_contact_bits_without_partner,
          first->settings.place({"contype", "conaffinity"}).origin,
          (count == 1 ? "this shape touches" : "these " + std::to_string(count) + " shapes touch") +
              std::string(" nothing: `contype` ") + std::to_string(first->contype) +
              " and `conaffinity` " + std::to_string(first->conaffinity) +
              " meet no bit of a shape of another body")
      .help("give both shapes a common bit, or write 0 and 0 for a shape that is only seen");
}

/// Shapes that are only seen and weigh, beside shapes that touch and weigh.
void report_doubled_masses(const Model& model, Reporter& reporter) {
  const Geom* first = nullptr;
  std::size_t count = 0;
  double seen = 0, all = 0;
  const auto mass_of = [](const Geom& geom) { return geom.mass ? geom.mass->mass : 0; };
  for (const Body& body : model.bodies) {
    double seen_here = 0, touching = 0;
    for (const Geom& geom : body.geoms) (touches(geom) ? touching : seen_here) += mass_of(geom);
    all += seen_here + touching;
    if (seen_here == 0 || touching == 0) continue;
    seen += seen_here;
    for (const Geom& geom : body.geoms) {
      if (touches(geom) || mass_of(geom) == 0) continue;
      if (first == nullptr) first = &geom;
      ++count;
    }
  }
  // A button or a lens weighs something.
  constexpr double kSmallest = 0.1;
  if (first == nullptr || seen < kSmallest * all) return;
  reporter
      .report(rules::sml9320_visual_shapes_weigh, first->settings.element().name_span(),
              (count == 1 ? std::string("a shape that touches nothing weighs")
                          : std::to_string(count) + " shapes that touch nothing weigh") +
                  " " + format_rounded(seen, 3) + " of the " + format_rounded(all, 3) +
                  " kg, beside the shapes that touch")
      .help("write `mass=\"0\"` for shapes that are only seen, or `<inertial>` for the bodies");
}

}  // namespace

void report_slips(const Model& model, Reporter& reporter) {
  report_held_bases(model, reporter);
  for (const ModelFile& file : model.files) report_units(model, file, reporter);
  report_hidden_shapes(model, reporter);
  report_doubled_masses(model, reporter);
}

}  // namespace smurf::mjcf
