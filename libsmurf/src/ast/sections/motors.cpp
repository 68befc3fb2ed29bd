// SPDX-License-Identifier: BSD-3-Clause
// Sources: MARS MotorData.cpp, smurf.cpp:257-270, SimMotor.cpp; envire_types motors; Phobos
// representation.py:2399.
#include "ast/sections.hpp"

namespace smurf::sections {
namespace {

using enum ValueType;

constexpr Key<Motor> kKeys[] = {
    {{.name = "name", .type = text, .doc = "Name of the motor; controllers, sensors, poses and "
                                           "mimicking motors refer to it.",
      .required = true},
     &Motor::name},
    {{.name = "joint", .type = text, .doc = "URDF joint that the motor drives.", .required = true},
     &Motor::joint},
    {{.name = "type", .type = text,
      .doc = "MARS: PID, DC, generic_bldc, generic_dc, direct_torque, direct_effort (or 1, 2, 7); "
             "MARS 2 also DirectEffort, FeedForwardEffort; Phobos 2: position, velocity, force."},
     &Motor::type},
    {{.name = "maxSpeed", .type = number, .doc = "Largest speed; a motor without it never moves.",
      .unit = "rad/s or m/s", .fallback = "0", .minimum = 0},
     &Motor::max_speed},
    {{.name = "maxEffort", .type = number,
      .doc = "Largest torque or force; a motor without it is limp.", .unit = "N m or N",
      .fallback = "0", .minimum = 0},
     &Motor::max_effort},
    {{.name = "maximumVelocity", .type = number, .doc = "Old name of maxSpeed.",
      .unit = "rad/s or m/s", .minimum = 0},
     {}},
    {{.name = "motorMaxForce", .type = number, .doc = "Old name of maxEffort.", .unit = "N m or N",
      .minimum = 0},
     {}},
    {{.name = "maxAcceleration", .type = number, .doc = "Stored by MARS and not used.",
      .fallback = "0"},
     {}},
    {{.name = "p", .type = number, .doc = "Proportional gain of the position controller.",
      .fallback = "0"},
     &Motor::p},
    {{.name = "i", .type = number, .doc = "Integral gain; MARS counts time in milliseconds.",
      .fallback = "0"},
     &Motor::i},
    {{.name = "d", .type = number, .doc = "Differential gain; MARS counts time in milliseconds.",
      .fallback = "0"},
     &Motor::d},
    {{.name = "minValue", .type = number, .doc = "Lowest commanded position.", .unit = "rad or m",
      .fallback = "-3.141592653589793"},
     &Motor::min_value},
    {{.name = "maxValue", .type = number, .doc = "Highest commanded position.", .unit = "rad or m",
      .fallback = "3.141592653589793"},
     &Motor::max_value},
    {{.name = "minPosition", .type = number,
      .doc = "Newer name of minValue; it wins in MARS, MARS 2 does not know it.",
      .unit = "rad or m"},
     &Motor::min_position},
    {{.name = "maxPosition", .type = number,
      .doc = "Newer name of maxValue; it wins in MARS, MARS 2 does not know it.",
      .unit = "rad or m"},
     &Motor::max_position},
    {{.name = "position", .type = number, .doc = "Read by MARS and never applied.",
      .unit = "rad or m"},
     {}},
    {{.name = "mimic_motor", .type = text,
      .doc = "Motor that this one follows (Phobos writes the joint's name)."},
     &Motor::mimic_motor},
    {{.name = "mimic_multiplier", .type = number,
      .doc = "Factor on the leader's position; absent it is 0, not 1.", .fallback = "0"},
     &Motor::mimic_multiplier},
    {{.name = "mimic_offset", .type = number, .doc = "Added to the leader's position.",
      .unit = "rad or m", .fallback = "0"},
     &Motor::mimic_offset},
    {{.name = "filterValue", .type = number, .doc = "Low-pass filter on the velocity.",
      .fallback = "0", .minimum = 0, .maximum = 1},
     {}},
    {{.name = "spring", .type = number,
      .doc = "Makes the effort limit proportional to the position error."},
     {}},
    {{.name = "maxEffortControl", .type = boolean,
      .doc = "Torque motors use the joint motor of the physics engine.", .fallback = "false"},
     {}},
    {{.name = "maxeffort_approximation", .type = text,
      .doc = "Function of the joint position that limits the effort: pipe, polynom2 to polynom5."},
     {}},
    {{.name = "maxeffort_coefficients", .type = number_list,
      .doc = "Coefficients of maxeffort_approximation."},
     {}},
    {{.name = "maxspeed_approximation", .type = text,
      .doc = "Function of the joint position that limits the speed."},
     {}},
    {{.name = "maxspeed_coefficients", .type = number_list,
      .doc = "Coefficients of maxspeed_approximation."},
     {}},
    {{.name = "current_approximation", .type = text,
      .doc = "Function that gives the motor current: polynom2D1, polynom2D2."},
     {}},
    {{.name = "current_coefficients", .type = number_list,
      .doc = "Coefficients of current_approximation."},
     {}},
    {{.name = "noDataPackage", .type = boolean, .doc = "Publish no data of this motor.",
      .fallback = "false"},
     {}},
};

std::vector<const KeySpec*> keys() { return specs_of<Motor>(kKeys); }

void read(yaml::View entry, Span section, Annotations& out, DiagnosticSink& sink) {
  read_into<Motor>(kKeys, "motor", entry, section, out.motors, sink);
}

constexpr std::string_view kAliases[] = {"motor"};

}  // namespace

constinit const SectionSpec motors{.name = "motors",
                                   .aliases = kAliases,
                                   .entry = "motor",
                                   .doc = "Motors and the joints they drive.",
                                   .keys = keys,
                                   .read = read};

}  // namespace smurf::sections
