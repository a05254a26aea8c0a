# SPDX-License-Identifier: GPL-3.0-or-later
"""Plastic deformation below a rolling contact, by finite elements.

An independent counterpart of overroll's [plastic] with another discretization.
Both solve the film of a step with the surface that the preceding film left.
The model has

  - rectangles with bilinear displacements and one plastic strain each, in a
    block that is periodic along x and fixed far below.  The period is 12 b if
    a bump deforms plastically, and overroll's period if the smooth contact
    does. There is no Green's function; the stiffness is solved for each wave
    of the grid.
  - elastic stresses of strips of uniform pressure (K. L. Johnson, Contact
    Mechanics, 2.5), averaged over each element by Gauss quadrature.
  - backward Euler steps of von Mises plasticity, for all elements at once by
    Newton's method, without alternating return and equilibrium.
  - the surface between nodes by its Fourier series.

Lengths in b, stresses in p_h, strains in p_h/E*; z points into the body.
"""
import math

import numpy as np


def layers(first, growth, strained, bottom):
    """Returns the depths of the layer edges, and the number of layers above
    `strained`, which may have plastic strain."""
    z, h = [0.0], first
    while z[-1] < strained:
        z.append(z[-1] + h)
        h *= growth
    count = len(z) - 1
    z = [edge * strained / z[-1] for edge in z]
    while z[-1] < bottom:
        z.append(z[-1] + h)
        h *= 1.2
    return np.array(z), count


class Law:
    """Hardening law: none, linear or kinematic with a modulus, or swift
    (strength, offset, power). Strains are in the units of the model."""

    def __init__(self, name, Y, modulus=0.0, swift=None):
        self.Y, self.swift = Y, swift
        self.linear = modulus if name == "linear" else 0.0
        self.kinematic = modulus if name == "kinematic" else 0.0

    def at(self, all_strain):
        if self.swift:
            B, C, n = self.swift
            return B * (C + all_strain)**n
        return self.Y + self.linear * all_strain

    def slope(self, all_strain):
        if self.swift:
            B, C, n = self.swift
            return B * n * (C + all_strain)**(n - 1)
        return self.linear + 0 * all_strain

    def flow(self, q, was, three_G):
        """Returns de with q - (3G + h) de = Y(was + de), or 0 below yield."""
        stiff = three_G + self.kinematic
        de = np.where(q.real > self.at(was).real,
                      (q - self.at(was)) / (stiff + self.slope(was)), 0)
        for _ in range(8 if self.swift else 0):
            off = q - stiff * de - self.at(was + de)
            de = np.where(de.real > 0,
                          de + off / (stiff + self.slope(was + de)), 0)
        return de


class Block:
    """Influence of plastic strains of elements on the mean stresses of all
    elements and on surface nodes: tables by distance along x."""

    def __init__(self, nu, h, cells, z, strained):
        self.nu, self.h, self.cells = nu, h, cells
        self.z, self.strained = z, strained
        self.G = (1 - nu) / 2                      # E* = 1
        lam = 2 * self.G * nu / (1 - 2 * nu)
        self.C = np.array([[lam + 2 * self.G, lam, 0],
                           [lam, lam + 2 * self.G, 0], [0, 0, self.G]])
        stress, sinks = self.waves()
        self.stress = np.fft.irfft(stress, cells, axis=0)
        self.sinks = sinks                         # for each wave

    def element(self, height):
        """Returns stiffness matrix and mean strain of an element from (u, w)
        at the nodes (0, 0), (1, 0), (0, 1), (1, 1)."""
        K, mean = np.zeros((8, 8)), np.zeros((3, 8))
        g = math.sqrt(1 / 3)
        for s in (-g, g):
            for t in (-g, g):
                a, b = (1 + s) / 2, (1 + t) / 2
                dx = np.array([b - 1, 1 - b, -b, b]) / self.h
                dz = np.array([a - 1, -a, 1 - a, a]) / height
                B = np.zeros((3, 8))
                B[0, 0::2], B[1, 1::2] = dx, dz
                B[2, 0::2], B[2, 1::2] = dz, dx
                K += self.h * height / 4 * B.T @ self.C @ B
                mean += B / 4
        return K, mean

    def waves(self):
        """Computes, for each wave, stresses from strains, (x, z, xz) of each
        layer, and the displacement of the surface node left of the element."""
        some, n = self.strained, len(self.z) - 1
        m = np.arange(self.cells // 2 + 1)
        turn = np.exp(2j * np.pi * m / self.cells)
        to = np.zeros((len(m), 8, 4), complex)     # nodes from one column
        for c in range(2):
            to[:, c, c] = 1
            to[:, 2 + c, c] = turn
            to[:, 4 + c, 2 + c] = 1
            to[:, 6 + c, 2 + c] = turn
        K = np.zeros((len(m), 2 * n + 2, 2 * n + 2), complex)
        loads = np.zeros((len(m), 2 * n, 3 * some), complex)
        strains = np.zeros((len(m), 3 * some, 2 * n), complex)
        for j, height in enumerate(np.diff(self.z)):
            k, mean = self.element(height)
            at = slice(2 * j, 2 * j + 4)
            back = to.conj().transpose(0, 2, 1)
            K[:, at, at] += back @ (k @ to)
            if j < some:
                B = mean @ to
                own = slice(3 * j, 3 * j + 3)
                strains[:, own, 2 * j:2 * j + 4] = B[:, :, :2 * n - 2 * j]
                loads[:, 2 * j:2 * j + 4, own] = 2 * self.G * self.h * \
                    height * B.conj().transpose(0, 2, 1)[:, :2 * n - 2 * j]
        u = np.linalg.solve(K[:, :2 * n, :2 * n], loads)
        total = strains @ u
        C = np.kron(np.eye(some), self.C)
        return C @ total - 2 * self.G * np.eye(3 * some), u[:, 1]


def strip(x, z):
    """Returns the stresses x, z and xz of a unit pressure on the half line x <
    0, except for a constant. The stresses of a strip are the difference between
    its right and its left end."""
    twice = 2 * np.arctan2(z, x)
    square = x * x + z * z
    sine, cosine = 2 * x * z / square, (x - z) * (x + z) / square
    return (-(twice + sine) / (2 * np.pi), -(twice - sine) / (2 * np.pi),
            cosine / (2 * np.pi))


class Metal:
    """Elements of a width of about h that move with a surface. If a bump
    deforms plastically, they are within `half_width` of the origin of the
    material. If the smooth contact does, they fill the window of overroll,
    which is a period. `window`: left end, right end, and a position without
    plastic displacement."""

    def __init__(self, nu, law, h, first, growth, depth, half_width=None,
                 window=None, softness=0.25):
        z, strained = layers(first, growth, depth, 10.0)
        period = window[1] - window[0] if window else 12.0
        cells = 2 * round(period / h / 2)
        if window:
            h, n = period / cells, cells
            self.left, self.far = window[0], window[2]
        else:
            n = 2 * round(half_width / h)
            self.left = -(n / 2 + 0.37) * h        # not at nodes of the film
            self.far = self.left + cells * h / 2
        self.bounded = bool(window)
        self.block = Block(nu, h, cells, z, strained)
        self.law, self.softness, self.columns = law, softness, n
        self.mid = self.left + (np.arange(n) + 0.5) * h
        self.h, self.nu = h, nu
        self.thick = np.diff(z)[:strained]
        self.depth = (z[:strained] + z[1:strained + 1]) / 2
        self.e = np.zeros((strained, n, 3))        # x, z, xz
        self.all = np.zeros((strained, n))

    # ------------------------------------------------------------ stresses

    def elastic(self, P, X, at):
        """Returns elastic stresses due to pressures that are uniform around
        each node. `at` is X of the material's origin."""
        D = X[1] - X[0]
        g = 0.5 / math.sqrt(3)
        out = np.zeros((len(self.depth), self.columns, 3))
        jump = np.diff(np.concatenate([[0], P, [0]]))   # at edges of strips
        edges = np.concatenate([X - D / 2, [X[-1] + D / 2]])
        edges, jump = edges[jump != 0], jump[jump != 0]
        for s in (-g, g):
            x = (self.mid + s * self.h + at)[None, :, None] - edges
            for t in (-g, g):
                z = (self.depth + t * self.thick)[:, None, None]
                for c, part in enumerate(strip(x, z)):
                    # right ends minus left ends of the strips
                    out[..., c] -= part @ jump / 4
        return out

    def whole(self, s, e):
        """Returns x, y, z, xz with sigma_y of plane strain."""
        nu = self.nu
        y = nu * (s[..., 0] + s[..., 1]) + \
            (1 - nu * nu) * (e[..., 0] + e[..., 1])
        return np.stack([s[..., 0], y, s[..., 1], s[..., 2]], axis=-1)

    def residual(self, e):
        """Returns the mean residual stresses x, z and xz of all elements."""
        rows, n, _ = e.shape
        N = self.block.cells
        hat = np.fft.rfft(e, N, axis=1).transpose(1, 0, 2).reshape(-1, 3 * rows)
        if not hasattr(self, "stress_waves"):
            self.stress_waves = np.fft.rfft(self.block.stress, axis=0)
        s = np.fft.irfft((self.stress_waves @ hat[:, :, None])[..., 0], N,
                         axis=0)[:n]
        return s.reshape(n, rows, 3).transpose(1, 0, 2)

    # ----------------------------------------------------------------- flow

    def driving(self, s, e_old):
        """Returns dev s minus the back stress, and its von Mises stress."""
        mean = (s[:, 0] + s[:, 1] + s[:, 2]) / 3
        back = self.law.kinematic * 2 / 3
        d = np.stack([s[:, 0] - mean - back * e_old[:, 0],
                      s[:, 1] - mean + back * (e_old[:, 0] + e_old[:, 1]),
                      s[:, 2] - mean - back * e_old[:, 1],
                      s[:, 3] - back * e_old[:, 2]], axis=1)
        return d, np.sqrt(1.5 * (d[:, 0]**2 + d[:, 1]**2 + d[:, 2]**2 +
                                 2 * d[:, 3]**2))

    def mapped(self, s, e_old, all_old):
        """Solves the backward Euler step of each element separately. Returns e
        and the elements that flow, from the stress without plastic flow in
        this step."""
        d, q = self.driving(s, e_old)
        de = self.law.flow(q, all_old, 3 * self.block.G)
        part = (1.5 * de / np.where(q == 0, 1, q))[:, None]
        return e_old + part * d[:, [0, 2, 3]], de

    def flow(self, P, X, at):
        """Deforms the material under the pressure at one time. Returns the
        maximum stress before plastic flow relative to yield."""
        load = self.elastic(P, X, at)
        rows, n, _ = load.shape
        G = self.block.G
        old, old_all = self.e.reshape(-1, 3), self.all.ravel()
        e = old.copy()

        def trial(e):
            """Returns the stress without the effect of each element's own
            plastic flow in this step."""
            s = self.residual(e.reshape(rows, n, 3)) + load
            s = self.whole(s, e.reshape(rows, n, 3)).reshape(-1, 4)
            de = e - old
            s = s + 2 * G * np.stack([de[:, 0], -de[:, 0] - de[:, 1], de[:, 1],
                                      de[:, 2]], axis=1)
            return s
        near = (self.driving(trial(e), old)[1] / self.law.at(old_all)).max()
        for turn in range(60):
            s = trial(e)
            to, de = self.mapped(s, old, old_all)
            off = to - e
            change = np.abs(off).max()
            if change < 1e-11:
                break
            flows = np.flatnonzero((de > 0) | (np.abs(e - old).max(axis=1) > 0))
            e = e + (off if turn < 2 else
                     self.newton(s[flows], old[flows], old_all[flows],
                                 off[flows], flows, n, len(e)))
        else:
            raise ArithmeticError(f"flow left {change:.1e}")
        self.e = e.reshape(rows, n, 3)
        self.all = (old_all + de).reshape(rows, n)
        return near

    def newton(self, s, old, old_all, off, flows, n, count):
        """Returns d with (1 - dM/ds ds/de) d = off for the elements that
        flow."""
        G, nu, k = self.block.G, self.nu, len(flows)
        row, col = np.divmod(flows, n)
        apart = (col[:, None] - col[None, :]) % self.block.cells
        A = np.empty((k, 3, k, 3))
        for a in range(3):
            for b in range(3):
                A[:, a, :, b] = self.block.stress[
                    apart, 3 * row[:, None] + a, 3 * row[None, :] + b]
        S = np.empty((k, 4, k, 3))
        S[:, 0], S[:, 2], S[:, 3] = A[:, 0], A[:, 1], A[:, 2]
        S[:, 1] = nu * (A[:, 0] + A[:, 1])
        i = np.arange(k)
        own = np.zeros((4, 3))
        own[0, 0] = own[2, 1] = own[3, 2] = 2 * G
        own[1, :2] = (1 - nu * nu) - 2 * G
        S[i, :, i, :] += own
        J = np.zeros((k, 3, k, 3))
        h = 1e-200
        for c in range(4):
            v = s.astype(complex)
            v[:, c] += 1j * h
            by = self.mapped(v, old, old_all)[0].imag / h
            J -= by[:, :, None, None] * S[:, c][:, None]
        J[i, :, i, :] += np.eye(3)
        d = np.zeros((count, 3))
        d[flows] = np.linalg.solve(J.reshape(3 * k, 3 * k),
                                   off.ravel()).reshape(k, 3)
        return d

    # -------------------------------------------------------------- surface

    def sinking(self, xi):
        """Returns the increase of the gap at positions of the material; it is
        zero at `far` and outside of a window."""
        N, h = self.block.cells, self.h
        rows = self.e.shape[0]
        hat = np.fft.rfft(self.e, N, axis=1).transpose(1, 0, 2)
        waves = (self.block.sinks * hat.reshape(-1, 3 * rows)).sum(axis=1) / N
        waves[1:] *= 2
        waves[-1] = 0
        k = 2 * np.pi * np.arange(N // 2 + 1) / (N * h)
        xi = np.asarray(xi) - self.left

        def at(x):
            return (np.exp(1j * np.outer(x, k)) @ waves).real
        w = self.softness * (at(xi) - at(np.array([self.far - self.left])))
        beside = (xi < 0) | (xi >= N * h)
        return np.where(beside, 0, w) if self.bounded else w
