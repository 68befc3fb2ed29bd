// SPDX-License-Identifier: BSD-3-Clause
// The ellipsoid of uniform density that has the mass and the inertia of a link. It shows at a glance whether an inertia
// has the size and the direction of the link.
import { Matrix4 } from "three";

const kRotations = 30; // five are enough for double precision

/** One Jacobi rotation, which makes the element at row p and column q of the symmetric matrix zero. */
function rotate(matrix, axes, p, q) {
  const angle = 0.5 * Math.atan2(2 * matrix[p][q], matrix[q][q] - matrix[p][p]);
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  for (const row of [...matrix, ...axes])
    [row[p], row[q]] = [c * row[p] - s * row[q], s * row[p] + c * row[q]];
  for (let at = 0; at < 3; at++)
    [matrix[p][at], matrix[q][at]] = [
      c * matrix[p][at] - s * matrix[q][at],
      s * matrix[p][at] + c * matrix[q][at],
    ];
}

/** {moments: [a, b, c], axes: rows of the matrix with the principal axes as columns}. */
export function principalAxes([xx, xy, xz, yy, yz, zz]) {
  const matrix = [
    [xx, xy, xz],
    [xy, yy, yz],
    [xz, yz, zz],
  ];
  const axes = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ];
  for (let step = 0; step < kRotations; step++) {
    const [p, q] = [
      [0, 1],
      [0, 2],
      [1, 2],
    ][step % 3];
    if (matrix[p][q] !== 0) rotate(matrix, axes, p, q);
  }
  return { moments: [0, 1, 2].map((at) => matrix[at][at]), axes };
}

/**
 * Makes an ellipsoid of the unit sphere, in the frame of the inertia. Null when no body has such moments; one moment may
 * be the sum of the others, as that of a thin plate.
 */
export function ellipsoidOf(mass, inertia) {
  const { moments, axes } = principalAxes(inertia);
  const sum = moments[0] + moments[1] + moments[2];
  const squares = moments.map((moment) => (2.5 / mass) * (sum - 2 * moment));
  if (!(mass > 0 && sum > 0) || squares.some((square) => square < (-1e-6 * sum) / mass)) return null;
  const thinnest = 1e-3 * Math.sqrt(Math.max(...squares));
  const [a, b, c] = squares.map((square) => Math.max(Math.sqrt(Math.max(square, 0)), thinnest));
  const [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = axes;
  return new Matrix4().set(
    ...[xx * a, xy * b, xz * c, 0],
    ...[yx * a, yy * b, yz * c, 0],
    ...[zx * a, zy * b, zz * c, 0],
    ...[0, 0, 0, 1],
  );
}
