# SPDX-License-Identifier: GPL-3.0-or-later
"""Film of a small wave of any direction in a rolling contact, by linearization.

The wave A exp(i (kx (X - u T) + ky Y)) of a surface that moves at u adds
p(X) exp(i (kx (X - u T) + ky Y)) to the pressure of the smooth contact and h
likewise to its film.  With q = rho H, eps = rho H^3/(eta lambda), and d/dX + i kx
for the derivative of such a product:

    h = -A + H0 exp(-i kx X) + int exp(-i kx (X - X')) K(X - X') p(X') dX'
    K = K0(|ky| |X|)/pi, or -ln|X|/pi where ky = 0 (only then H0 is not 0)
    (d/dX + i kx) f - ky^2 eps p - dq/dX - i kx (1 - u) q = 0
    f = eps (dp/dX + i kx p) + eps P' ((ln(rho/eta))' p + 3 h/H),
    q = rho' H p + rho h

p = 0 at the inlet and at the film's end: to first order the end moves without a
change of the pressure there.  Where ky = 0 the wave carries no load.

Finite volumes of second order on the nodes of the smooth contact, with the
backward difference of three points for dq/dX, and Gauss' elimination.  Nothing
is shared with the solver but the smooth film and pressure.  Roelands' viscosity,
Dowson and Higginson's density.
"""
import cmath
import functools
import math

P0, Z = 198e6, 0.68


@functools.lru_cache(maxsize=None)
def integral_k0(z):
    """From 0 to z >= 0: pi/2 - int exp(-z cosh u)/cosh u du, trapezoidal."""
    step = 0.05
    rest = sum(math.exp(-z * math.cosh(step * j)) / math.cosh(step * j)
               for j in range(1, 240)) + math.exp(-z) / 2
    return math.pi / 2 - step * rest


def solved(A, b):
    """Gauss' elimination with pivots; A and b are overwritten."""
    n = len(b)
    for k in range(n):
        pivot = max(range(k, n), key=lambda i: abs(A[i][k]))
        A[k], A[pivot], b[k], b[pivot] = A[pivot], A[k], b[pivot], b[k]
        row, rest = A[k][k + 1:], 1 / A[k][k]
        for i in range(k + 1, n):
            f = A[i][k] * rest
            if f:
                A[i][k + 1:] = [x - f * y
                                for x, y in zip(A[i][k + 1:], row)]
                b[i] -= f * b[k]
    for k in reversed(range(n)):
        b[k] = (b[k] - sum(x * y for x, y in zip(A[k][k + 1:], b[k + 1:]))) \
            / A[k][k]
    return b


class Smooth:
    """A smooth rolling contact: X, P and H on equal meshes, p_h in Pa."""

    def __init__(self, M, L, alpha, X, P, H):
        self.slowness = 3 * math.pi**2 / (8 * M * M)  # lambda
        self.alphabar = L * math.sqrt(M / (2 * math.pi))
        self.ph = self.alphabar / alpha
        self.X, self.P, self.H = X, P, H
        self.end = max(i for i, p in enumerate(P) if p > 0) + 1
        self.middle = min(range(len(X)), key=lambda i: abs(X[i]))

    def nodes(self, stride):
        """Every stride-th node of the contact, wider meshes before X = -1.7."""
        at = list(range(self.middle, self.end + 1, stride))
        i, step = self.middle - stride, float(stride)
        while i > 0:
            at.insert(0, i)
            if self.X[i] < -1.7:
                step = min(1.1 * step, 8 * stride)
            i -= round(step)
        return [0] + at

    def laws(self, i):
        """rho, rho', eps and the slope of ln(rho/eta)."""
        p, x = self.P[i] * self.ph * 1e-9, self.P[i] * self.ph / P0
        rho = (0.59 + 1.34 * p) / (0.59 + p)
        slope = 0.34 * 0.59 * self.ph * 1e-9 / (0.59 + p)**2
        eta = math.exp(self.alphabar * P0 / self.ph / Z * ((1 + x)**Z - 1))
        return (rho, slope, rho / eta * self.H[i]**3 / self.slowness,
                slope / rho - self.alphabar * (1 + x)**(Z - 1))


def kernel(c, at, kx, ky):
    """Of the cells around the nodes, constant pressure in each."""
    D = (c.X[-1] - c.X[0]) / (len(c.X) - 1)
    edge = [2 * at[0]] + [i + j for i, j in zip(at, at[1:])] + [2 * at[-1]]

    @functools.lru_cache(maxsize=None)
    def integral(half_meshes):
        d = abs(half_meshes) * D / 2
        if ky:
            value = integral_k0(ky * d) / (math.pi * ky)
        else:
            value = -(d * math.log(d) - d) / math.pi if d else 0
        return math.copysign(value, half_meshes)

    turn = [cmath.exp(-1j * kx * c.X[i]) for i in at]
    return [[(integral(2 * i - a) - integral(2 * i - b)) * t / s
             for a, b, s in zip(edge, edge[1:], turn)]
            for i, t in zip(at, turn)]


def weighted(rows_and_weights):
    """Sum of rows."""
    weights = [w for _, w in rows_and_weights]
    return [sum(w * x for w, x in zip(weights, column))
            for column in zip(*[row for row, _ in rows_and_weights])]


def film_of_wave(c, kx, ky, u, stride):
    """|h|/A at X = 0."""
    at = c.nodes(stride)
    n = len(at)
    X, P, H = ([v[i] for i in at] for v in (c.X, c.P, c.H))
    law = [c.laws(i) for i in at]
    K = kernel(c, at, kx, ky)
    # Unknowns: p at the nodes, H0; the last column is the part of A.
    film = [row + [cmath.exp(-1j * kx * x) if not ky else 0, -1]
            for row, x in zip(K, X)]
    q = []
    for i, (rho, slope, _, _) in enumerate(law):
        row = [rho * x for x in film[i]]
        row[i] += slope * H[i]
        q.append(row)
    flux = []
    for i in range(n - 1):
        D, a, b = X[i + 1] - X[i], law[i], law[i + 1]
        change = math.log(b[2] / a[2])
        eps = (b[2] - a[2]) / change if abs(change) > 1e-6 else a[2]
        drive = eps * (P[i + 1] - P[i]) / D
        row = weighted([(film[i], 1.5 * drive / H[i]),
                        (film[i + 1], 1.5 * drive / H[i + 1])])
        row[i] += eps * (-1 / D + 0.5j * kx) + drive * a[3] / 2
        row[i + 1] += eps * (1 / D + 0.5j * kx) + drive * b[3] / 2
        flux.append(row)
    A, right = [], []
    for i in range(n):
        row = [0j] * (n + 2)
        if 0 < i < n - 1:
            w, D = (X[i + 1] - X[i - 1]) / 2, X[i] - X[i - 1]
            parts = [(flux[i], 1 / w + 0.5j * kx),
                     (flux[i - 1], -1 / w + 0.5j * kx)]
            if i == 1:
                wedge = [(q[1], 1 / D), (q[0], -1 / D)]
            else:
                wide = X[i] - X[i - 2]
                one, two = -wide / (D * (wide - D)), D / (wide * (wide - D))
                wedge = [(q[i], -one - two), (q[i - 1], one), (q[i - 2], two)]
            row = weighted(parts + [(r, -x) for r, x in wedge] +
                           [(q[i], -1j * kx * (1 - u))])
            row[i] -= ky * ky * law[i][2]
        else:
            row[i] = 1
        right.append(-row.pop())
        A.append(row)
    closing = [0j] * (n + 1)
    if ky:
        closing[n] = 1
    else:
        ends = [X[0]] + [(a + b) / 2 for a, b in zip(X, X[1:])] + [X[-1]]
        for j in range(n):
            closing[j] = (ends[j + 1] - ends[j]) * cmath.exp(1j * kx * X[j])
    p = solved(A + [closing], right + [0])
    i = at.index(c.middle)
    return abs(sum(x * y for x, y in zip(film[i], p + [1])))


def amplitude_left(c, length, angle, u=1, stride=4):
    """The amplitude of the film at X = 0 relative to that of a wave whose crests
    are at `angle` degrees to the y axis, and the error of that."""
    k, turned = 2 * math.pi / length, math.radians(angle)
    kx = k * math.cos(turned) if angle < 90 else 0
    ky = k * math.sin(turned) if angle else 0
    coarse, fine = (film_of_wave(c, kx, ky, u, s) for s in (2 * stride, stride))
    return fine + (fine - coarse) / 3, abs(fine - coarse) / 3
