// SPDX-License-Identifier: BSD-3-Clause
// Functions of geometry whose results are the same on every system. Those of the C libraries differ
// in the last digit, so every written pose would differ.
#pragma once

namespace smurf {

struct SineCosine {
  double sine;
  double cosine;
};

/// Nearly always correctly rounded, since computed with twice the digits of a double.
SineCosine sine_cosine(double radians);
/// As std::atan2.
double arc_tangent(double y, double x);
/// As std::hypot.
double hypotenuse(double x, double y);
double hypotenuse(double x, double y, double z);

}  // namespace smurf
