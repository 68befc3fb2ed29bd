// SPDX-License-Identifier: BSD-3-Clause
// Formulas of inertias that are nearly those of a solid box, cylinder or sphere. Formulas are
// compared by their values for several sets of numbers, so their notation does not matter.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/findings/rules.hpp"
#include "base/text/quoted.hpp"
#include "xacro/expander.hpp"
#include "xacro/python_text.hpp"

namespace smurf::xacro {
namespace {

constexpr std::size_t kSamples = 3;
constexpr std::size_t kMostNames = 8;
constexpr std::array<std::string_view, 3> kMoments = {"ixx", "iyy", "izz"};

/// The values of a formula, or of a name, for all samples.
using Samples = std::array<double, kSamples>;

/// The numbers of a name, without a relation to those of others.
Samples samples_of(std::size_t name) {
  Samples values{};
  for (std::size_t i = 0; i < kSamples; ++i) {
    const double x = 0.37 + 1.618034 * static_cast<double>(name + 1) +
                     2.414214 * static_cast<double>((name + 2) * (i + 1));
    values[i] = 0.5 + std::fmod(x * x, 3.0);
  }
  return values;
}

bool is_near(double value, double expected) {
  return std::fabs(value - expected) <= 1e-9 * std::fabs(value);
}

template <class Formula>
bool is_everywhere(const Samples& values, const Formula& formula) {
  for (std::size_t i = 0; i < kSamples; ++i) {
    if (!is_near(values[i], formula(i))) return false;
  }
  return true;
}

/// A side, a radius or a length: a name, or the half or the double of one.
struct Length {
  std::size_t name = 0;
  double factor = 1;
  Samples squares{};  ///< of its values
  bool is_same(const Length& other) const { return name == other.name && factor == other.factor; }
};

/// m/12 (a^2 + b^2).
struct BoxMoment {
  std::size_t mass = 0;
  std::size_t a = 0, b = 0;  ///< indices of lengths
};

class Formulas {
 public:
  Formulas(const std::array<Samples, 3>& moments, std::size_t names) : moments_(moments) {
    for (std::size_t i = 0; i < names; ++i) {
      masses_.push_back(samples_of(i));
      for (const double factor : {1.0, 0.5, 2.0}) {
        Length length{i, factor, masses_.back()};
        for (double& value : length.squares) value = value * factor * (value * factor);
        lengths_.push_back(length);
      }
    }
  }

  /// Why they are wrong; none if they are right, or of another body.
  std::optional<std::string> fault() const {
    for (std::size_t mass = 0; mass < masses_.size(); ++mass) {
      if (auto found = fault_of_box(mass)) return found;
      if (auto found = fault_of_round(mass)) return found;
    }
    return std::nullopt;
  }

 private:
  std::optional<std::string> fault_of_box(std::size_t mass) const {
    std::array<BoxMoment, 3> moments;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto found = box_moment(mass, moments_[i]);
      if (!found) return std::nullopt;
      moments[i] = *found;
    }
    const auto pair_of = [](std::size_t a, std::size_t b) {
      return std::pair(std::min(a, b), std::max(a, b));
    };
    const auto sides = [&](std::size_t i) { return pair_of(moments[i].a, moments[i].b); };
    // Of two moments that share a side, the third has the other sides.
    for (const std::size_t shared : {moments[0].a, moments[0].b}) {
      const std::size_t q = other_side(moments[0], shared);
      for (const std::size_t again : {moments[1].a, moments[1].b}) {
        if (again != shared) continue;
        const std::size_t p = other_side(moments[1], again);
        if (sides(2) == pair_of(p, q)) return std::nullopt;
      }
    }
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = i + 1; j < 3; ++j) {
        if (sides(i) == sides(j)) {
          return quoted(kMoments[i]) + " and " + quoted(kMoments[j]) +
                 " are the same moment of a box";
        }
      }
    }
    return "these are not the moments of one box";
  }

  static std::size_t other_side(const BoxMoment& moment, std::size_t side) {
    return moment.a == side ? moment.b : moment.a;
  }

  std::optional<BoxMoment> box_moment(std::size_t mass, const Samples& moment) const {
    for (std::size_t a = 0; a < lengths_.size(); ++a) {
      for (std::size_t b = a; b < lengths_.size(); ++b) {
        const bool is_one = is_everywhere(moment, [&](std::size_t i) {
          return masses_[mass][i] / 12 * (square(a, i) + square(b, i));
        });
        if (is_one) return BoxMoment{mass, a, b};
      }
    }
    return std::nullopt;
  }

  double square(std::size_t length, std::size_t sample) const {
    return lengths_[length].squares[sample];
  }

  /// A cylinder has two moments m/12 (3 r^2 + h^2), a sphere three of 2/5 m r^2.
  std::optional<std::string> fault_of_round(std::size_t mass) const {
    for (std::size_t r = 0; r < lengths_.size(); ++r) {
      const auto spheres =
          matches([&](std::size_t i) { return 2.0 / 5 * masses_[mass][i] * square(r, i); });
      if (count(spheres) == 2) return wrong(spheres, "sphere");
      const auto axes = matches([&](std::size_t i) { return masses_[mass][i] / 2 * square(r, i); });
      for (std::size_t h = 0; h < lengths_.size(); ++h) {
        if (lengths_[h].name == lengths_[r].name) continue;
        const auto sides = matches([&](std::size_t i) {
          return masses_[mass][i] / 12 * (3 * square(r, i) + square(h, i));
        });
        if (count(sides) == 2 && count(axes) == 0) return wrong(sides, "cylinder");
        if (count(sides) == 1 && count(axes) == 1) {
          return wrong({sides[0] || axes[0], sides[1] || axes[1], sides[2] || axes[2]}, "cylinder");
        }
      }
    }
    return std::nullopt;
  }

  using Matches = std::array<bool, 3>;

  template <class Formula>
  Matches matches(const Formula& formula) const {
    // Nearly all formulas differ for the first sample.
    const double first = formula(0);
    Matches all{};
    for (std::size_t i = 0; i < all.size(); ++i) {
      all[i] = is_near(moments_[i][0], first) && is_everywhere(moments_[i], formula);
    }
    return all;
  }
  static std::size_t count(const Matches& all) {
    return static_cast<std::size_t>(std::count(all.begin(), all.end(), true));
  }
  static std::string wrong(const Matches& right, std::string_view body) {
    const auto odd =
        static_cast<std::size_t>(std::find(right.begin(), right.end(), false) - right.begin());
    return quoted(kMoments[odd]) + " is not that of the " + std::string(body) +
           " to which the other two belong";
  }

  const std::array<Samples, 3>& moments_;
  std::vector<Samples> masses_;
  std::vector<Length> lengths_;
};

/// The names of numbers in a formula of sums, products and powers; false for other parts.
bool collect_numbers(const Syntax& syntax, std::vector<std::string_view>& names) {
  switch (syntax.kind) {
  case SyntaxKind::constant: return syntax.value.is_number();
  case SyntaxKind::name:
    if (std::find(names.begin(), names.end(), syntax.text) == names.end()) {
      names.push_back(syntax.text);
    }
    return names.size() <= kMostNames;
  case SyntaxKind::unary:
  case SyntaxKind::binary:
    return std::all_of(syntax.parts.begin(), syntax.parts.end(),
                       [&](const Syntax* part) { return collect_numbers(*part, names); });
  case SyntaxKind::call: {
    const bool is_power = syntax.parts.size() == 3 && syntax.parts[0]->kind == SyntaxKind::name &&
                          syntax.parts[0]->text == "pow";
    return is_power && collect_numbers(*syntax.parts[1], names) &&
           collect_numbers(*syntax.parts[2], names);
  }
  default: return false;
  }
}

}  // namespace

void Expander::check_inertia(const Node& in, Table& symbols) {
  if (!is_first_at(in.span)) return;
  std::array<std::string_view, 3> codes;
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < 3; ++i) {
    const NodeAttribute* moment = in.attribute(kMoments[i]);
    codes[i] = moment != nullptr ? code_of(moment->text.value) : std::string_view();
    const Syntax* syntax = codes[i].empty() ? nullptr : expressions_.parse(codes[i]).root;
    if (syntax == nullptr || !collect_numbers(*syntax, names)) return;
  }
  std::erase_if(names, [&](std::string_view name) { return functions_->own(name) != nullptr; });
  const auto is_number = [&](std::string_view name) {
    return static_cast<bool>(symbols.find(name));
  };
  if (names.size() < 2 || !std::all_of(names.begin(), names.end(), is_number)) return;
  std::array<Samples, 3> moments{};
  const std::size_t remarks = evaluator_.remarks().size();
  const Evaluator::Uses uses = evaluator_.begin_uses();
  bool is_known = true;
  for (std::size_t sample = 0; sample < kSamples && is_known; ++sample) {
    Table table(*functions_);
    for (std::size_t i = 0; i < names.size(); ++i) {
      table.set(names[i], Value::of(samples_of(i)[sample]));
    }
    for (std::size_t i = 0; i < 3 && is_known; ++i) {
      const auto value = to_real(evaluator_.evaluate(codes[i], table));
      is_known = value.has_value() && std::isfinite(*value);
      if (is_known) moments[i][sample] = *value;
    }
  }
  evaluator_.take_failure();
  evaluator_.remarks().resize(remarks);
  evaluator_.end_uses(uses);
  if (!is_known) return;
  const auto fault = Formulas(moments, names.size()).fault();
  if (!fault) return;
  Diagnostic& diagnostic =
      context_.sink.report(rules::sml3409_xacro_wrong_inertia, in.tag_span, *fault);
  diagnostic.help("correct the formula");
  add_frames(diagnostic);
}

}  // namespace smurf::xacro
