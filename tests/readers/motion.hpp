// SPDX-License-Identifier: BSD-3-Clause
// What the programs have in common that let robots hang and fall:
//   NAME STEP FILE...
//   file <path>
//   hang <time> <energy>                          the root held; J, more than at the start
//   pose <time> <link> x y z qw qx qy qz          of the hanging robot
//   fall <time> <energy> <height>                 nothing held; m, of the centre of mass
//   end                                           or: refused
#pragma once

#include <array>
#include <cstdio>
#include <cstdlib>
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

/// `move(path, step)` is false when the reader refuses the file.
template <class Move>
int move_robots(int argc, char** argv, Move move) {
  for (int i = 2; i < argc; ++i) {
    std::printf("file\t%s\n", argv[i]);
    std::fflush(stdout);
    std::puts(move(std::string(argv[i]), std::atof(argv[1])) ? "end" : "refused");
    std::fflush(stdout);
  }
  return 0;
}

}  // namespace smurf::tests
