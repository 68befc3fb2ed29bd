// SPDX-License-Identifier: BSD-3-Clause
// What the programs have in common that let a robot hang, fall and drop:
//   NAME STEP FILE [GROUND]                       GROUND: height of a plane to drop on; m
//   hang <time> <energy>                          the root held; J, more than at the start
//   pose <time> <link> x y z qw qx qy qz          of the hanging robot
//   fall <time> <energy> <height>                 nothing held; m, of the centre of mass
//   ground <height>                               where the load check puts it
//   contact <time>                                the first of the drop
//   drop <time> <energy> <height>                 as for the fall; the most energy until then
//   end                                           or: refused <why>
#pragma once

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>

namespace smurf::tests {

inline constexpr double kGravity = 9.81;
inline constexpr std::array kTimes = {0.1, 0.25, 0.5, 1.0};  // s

inline void print_hang(double time, double energy) {
  std::printf("hang\t%g\t%.17g\n", time, energy);
}
inline void print_fall(double time, double energy, double height) {
  std::printf("fall\t%g\t%.17g\t%.17g\n", time, energy, height);
}
inline void print_drop(double time, double energy, double height) {
  std::printf("drop\t%g\t%.17g\t%.17g\n", time, energy, height);
}
inline void print_contact(double time) { std::printf("contact\t%.17g\n", time); }
inline void print_link(double time, const std::string& name, const double (&xyz)[3],
                       const double (&wxyz)[4]) {
  std::printf("pose\t%g\t%s\t%.17g\t%.17g\t%.17g\t%.17g\t%.17g\t%.17g\t%.17g\n", time, name.c_str(),
              xyz[0], xyz[1], xyz[2], wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
}

/// Steps until each of kTimes and prints what the motion is then.
template <class Step, class Print>
void run(double step, Step take_step, Print print) {
  long done = 0;
  for (const double time : kTimes) {
    for (const long until = static_cast<long>(time / step + 0.5); done < until; ++done) take_step();
    print(time);
  }
}

/// The motion of a drop, measured after every step: `touches()`, `energy()`, and `height()` of the
/// centre of mass.
template <class Step, class Touches, class Energy, class Height>
void run_drop(double step, Step take_step, Touches touches, Energy energy, Height height) {
  const double start = energy();
  const double top = height();
  double most = 0;
  long steps = 0;
  bool has_touched = false;
  run(
      step,
      [&] {
        take_step();
        ++steps;
        most = std::max(most, energy() - start);
        if (has_touched || !touches()) return;
        has_touched = true;
        print_contact(static_cast<double>(steps) * step);
      },
      [&](double time) { print_drop(time, most, height() - top); });
}

/// `move(path, step, ground)` returns the reason why the reader refuses the file, or nothing.
template <class Move>
int move_robot(int argc, char** argv, Move move) {
  if (argc != 3 && argc != 4) return 2;
  std::optional<double> ground;
  if (argc == 4) ground = std::atof(argv[3]);
  const std::string refusal = move(std::string(argv[2]), std::atof(argv[1]), ground);
  std::printf("%s%s\n", refusal.empty() ? "end" : "refused\t", refusal.c_str());
  return 0;
}

}  // namespace smurf::tests
