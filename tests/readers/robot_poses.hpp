// SPDX-License-Identifier: BSD-3-Clause
// What the programs have in common that load URDFs with a reader and print where the links stand:
//   NAME FILE...
//   file <path>
//   pose  <link> x y z qw qx qy qz     all joints at zero
//   moved <link> x y z qw qx qy qz     each joint at the position that its name stands for
//   end                                or: refused
#pragma once

#include <cstdio>
#include <string>

namespace smurf::tests {

/// Small, within most limits, and different from joint to joint. urdf_poses.mjs computes the same.
inline double position_of_joint(const std::string& name) {
  unsigned sum = 0;
  for (const char c : name) sum += static_cast<unsigned char>(c);
  return 0.05 * (sum % 8U) + 0.1;
}

inline void print_pose(const char* what, const std::string& name, const double (&xyz)[3],
                       const double (&wxyz)[4]) {
  std::printf("%s\t%s\t%.17g\t%.17g\t%.17g\t%.17g\t%.17g\t%.17g\t%.17g\n", what, name.c_str(),
              xyz[0], xyz[1], xyz[2], wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
}

/// `print_robot(path)` returns false if the reader refuses the file. If the reader crashes, the
/// remaining files are not printed; the caller detects this by the missing end.
template <class Print>
int print_robots(int argc, char** argv, Print print_robot) {
  for (int i = 1; i < argc; ++i) {
    std::printf("file\t%s\n", argv[i]);
    std::fflush(stdout);
    std::puts(print_robot(std::string(argv[i])) ? "end" : "refused");
    std::fflush(stdout);
  }
  return 0;
}

}  // namespace smurf::tests
