# SPDX-License-Identifier: BSD-3-Clause
"""Poses as pairs of a position and a quaternion w, x, y, z."""
import math


def multiply(a, b):
    w, x, y, z = a
    v, i, j, k = b
    return [w * v - x * i - y * j - z * k, w * i + x * v + y * k - z * j,
            w * j - x * k + y * v + z * i, w * k + x * j - y * i + z * v]


def conjugate(q):
    return [q[0], -q[1], -q[2], -q[3]]


def rotate(q, v):
    return multiply(multiply(q, [0, *v]), conjugate(q))[1:]


def compose(a, b):
    (p, q), (r, s) = a, b
    return [x + y for x, y in zip(p, rotate(q, r))], multiply(q, s)


def inverse(a):
    p, q = a
    return rotate(conjugate(q), [-c for c in p]), conjugate(q)


def from_rpy(roll, pitch, yaw):
    (cr, sr), (cp, sp), (cy, sy) = ((math.cos(a / 2), math.sin(a / 2)) for a in (roll, pitch, yaw))
    return multiply(multiply([cy, 0, 0, sy], [cp, 0, sp, 0]), [cr, sr, 0, 0])


def apart(a, b):
    """The distance between two poses in metres or the angle in radians, whichever is larger."""
    same = sum(x * y for x, y in zip(a[1], b[1]))
    gap = math.sqrt(sum((x * math.copysign(1, same) - y) ** 2 for x, y in zip(a[1], b[1])))
    return max(math.dist(a[0], b[0]), 2 * gap)


def columns(q):
    return [rotate(q, axis) for axis in ([1, 0, 0], [0, 1, 0], [0, 0, 1])]


def turned(q, tensor):
    """R I R^T of a 3x3 tensor, a list of rows."""
    c = columns(q)  # R[i][j] is c[j][i]
    return [[sum(c[k][i] * tensor[k][m] * c[m][j] for k in range(3) for m in range(3))
             for j in range(3)] for i in range(3)]
