# SPDX-License-Identifier: GPL-3.0-or-later
"""An independent model of the contact in time: dense Newton, small grids.

It shares with overroll the discrete equations of overroll-theory(7) and, for
mass-conserving cavitation, of the head comment of src/multigrid/content.h.
Therefore both have the same solution except for rounding and stopping
tolerance.  The model was written from these texts, not from the sources.  The
following is different:

  - The deformation is a full matrix, without multigrid.
  - Shear-thinning films are integrated across by Gauss quadrature of the
    stress, without closed forms or tables.
  - Layers are solved as a boundary value problem for each wave number and
    transformed to X by quadrature, without images.
  - One unknown x determines whether a node is cavitated: P = max(x, 0), and
    max(-x, 0) is the missing lubricant or the excess of the Reynolds equation
    (a semismooth Newton method).  There are no node sets and no sweeps.
  - The whole Jacobian is computed by complex steps.
  - Steps end at the times of the run, with the model's own history.
"""
import math

import numpy as np

POINTS, WEIGHTS = np.polynomial.legendre.leggauss(48)
ABOVE, ABOVE_WEIGHTS = POINTS[24:], WEIGHTS[24:]    # for even functions


def smoothstep(y):
    y = min(1.0, max(0.0, y))
    return y**3 * (10 - 15 * y + 6 * y * y)


def smoothstep_integral(y):
    if y <= 0:
        return 0.0
    if y >= 1:
        return 0.5 + (y - 1)
    return y**6 - 3 * y**5 + 2.5 * y**4


class Constant:
    def __init__(self, value):
        self.value = value

    def at(self, T):
        return self.value

    def slope(self, T):
        return 0.0

    def way(self, T):
        return self.value * T

    def lines(self):
        return ""


class Ramp:
    def __init__(self, start, end, begin, duration):
        self.start, self.end = start, end
        self.begin, self.duration = begin, duration

    def at(self, T):
        y = (T - self.begin) / self.duration
        return self.start + (self.end - self.start) * smoothstep(y)

    def slope(self, T):
        y = min(1.0, max(0.0, (T - self.begin) / self.duration))
        return (self.end - self.start) * 30 * (y * (1 - y))**2 / self.duration

    def way(self, T):
        def whole(t):
            return (self.end - self.start) * self.duration * \
                smoothstep_integral((t - self.begin) / self.duration)
        return self.start * T + whole(T) - whole(0)

    def lines(self):
        return (f"history = ramp\nfrom = {self.start!r}\nto = {self.end!r}\n"
                f"start = {self.begin!r}\nduration = {self.duration!r}\n")


class Layer:
    """Compliance A(k) of one bonded layer of thickness d relative to the
    substrate, in plane strain, for a unit wave of pressure. Airy's function is
    (a + b z) exp(-kz) + (c + d z) exp(kz) in the layer and (e + f z) exp(-kz)
    below."""

    def __init__(self, d, E, nu, E_below, nu_below):
        self.d = d
        self.top = self.compliance(E, nu) / self.compliance(E_below, nu_below)
        self.E, self.nu = (E, E_below), (nu, nu_below)

    @staticmethod
    def compliance(E, nu):
        return 2 * (1 - nu * nu) / E

    def parts(self, k, z, body, kind):
        """Returns sigma_z, tau, u and w of z^n exp(s k z) cos(kx), without the
        factors sin and cos; strains follow Hooke's law in plane strain."""
        s, n = kind
        E, nu = self.E[body], self.nu[body]
        e = math.exp(s * k * (z - (self.d if s > 0 else 0)))
        f = (z if n else 1) * e
        f1 = ((1 if n else 0) + s * k * (z if n else 1)) * e
        f2 = (2 * s * k * (1 if n else 0) + k * k * (z if n else 1)) * e
        f3 = (3 * k * k * (1 if n else 0) +
              s * k**3 * (z if n else 1)) * e
        sz, sx, t = -k * k * f, f2, k * f1    # cos, cos, sin
        a, b = (1 - nu * nu) / E, nu * (1 + nu) / E
        u = (a * sx - b * sz) / k             # sin
        # w' = a sz - b sx, and  tau (2 (1 + nu)/E) = u_z + w_x, w = W cos
        u1 = (a * f3 - b * (-k * k * f1)) / k
        W = (u1 - 2 * (1 + nu) / E * t) / k
        return sz, t, u, W

    def ratio(self, k):
        if k * self.d > 40:
            return self.top
        layer = [(-1, 0), (-1, 1), (1, 0), (1, 1)]
        below = [(-1, 0), (-1, 1)]
        A, r = np.zeros((6, 6)), np.zeros(6)
        for c, kind in enumerate(layer):
            at_top = self.parts(k, 0.0, 0, kind)
            A[0, c], A[1, c] = at_top[0], at_top[1]
            A[2:, c] = self.parts(k, self.d, 0, kind)
        for c, kind in enumerate(below):
            A[2:, 4 + c] = [-v for v in self.parts(k, self.d, 1, kind)]
        r[0] = -1
        scale = np.abs(A).max(axis=0)
        rows = np.abs(A / scale).max(axis=1)
        x = np.linalg.solve(A / scale / rows[:, None], r / rows) / scale
        W = sum(x[c] * self.parts(k, 0.0, 0, kind)[3]
                for c, kind in enumerate(layer))
        return abs(W) * k / self.compliance(self.E[1], self.nu[1])


def logarithms(d):
    """Returns int ln|x| over the interval d - 1/2 to d + 1/2."""
    def half(y):
        return y * (np.log(np.abs(y)) - 1)
    return half(d + 0.5) - half(d - 0.5)


def kernel(n, D, layers=None):
    """Returns int K over one grid interval at distances of 0 ... n - 1 mesh
    sizes. layers: (fraction of the compliance, Layer) of bodies 1 and 2,
    lengths in b."""
    d = np.arange(n, dtype=float)
    K = D * (logarithms(d) + math.log(D))
    for share, layer in layers or []:
        # A - top - (1 - top) exp(-k a) is smooth and vanishes at k d = 40
        a, top = layer.d, layer.top
        edges = np.concatenate([np.linspace(0, 4, 4001),
                                np.linspace(4, 42, 6001)[1:]]) / layer.d
        k, step = (edges[1:] + edges[:-1]) / 2, np.diff(edges)
        rest = np.array([layer.ratio(v) for v in k]) - top - \
            (1 - top) * np.exp(-k * a)
        X = d * D
        box = np.sinc(k * D / (2 * np.pi)) * D
        smooth = -np.cos(np.outer(X, k)) @ (rest * box / k * step)
        s, w = POINTS / 2 * D, WEIGHTS / 2 * D
        image = np.log(np.hypot(X[:, None] + s, a)) @ w
        K += share * ((top - 1) * D * (logarithms(d) + math.log(D)) +
                      (1 - top) * image + smooth)
    return K


class Model:
    """Discrete equations of a case, with the parameters in `case`."""

    def __init__(self, case):
        self.c = case
        n = self.n = 7 * 2**case["level"] + 1
        self.X_a, self.X_b = case.get("inlet", -4.0), case.get("outlet", 1.5)
        self.D = (self.X_b - self.X_a) / (n - 1)
        self.X = self.X_a + self.D * np.arange(n)
        M, L = case["M"], case["L"]
        self.lam = 3 * math.pi**2 / (8 * M * M)
        self.alphabar = L * math.sqrt(M / (2 * math.pi))
        self.ph = self.alphabar / 17e-9
        K = kernel(n, self.D, case.get("layers"))
        i = np.arange(n)
        self.K = K[np.abs(i[:, None] - i)] / math.pi
        self.carreau = case.get("carreau")  # Sigma0, n; a = 2, stress form
        self.Sigma0 = case.get("eyring") or self.carreau and self.carreau[0]
        self.conserving = bool(case.get("conserving"))
        self.closed = "film" in case
        self.first_order = case.get("scheme") == "upstream1"
        self.half = 0.0 if self.first_order else 0.5  # row 1: q_1 - q_0
        self.wall = case.get("boundary")
        one = Constant(1.0)
        self.load = case.get("load", one)
        self.speed = case.get("speed", one)
        self.sliding = case.get("sliding")
        self.radius = case.get("radius", one)

    # -------------------------------------------------------------- inputs

    def V(self, T):
        if self.sliding:
            return self.sliding.at(T)
        return self.c.get("slide", 0.0) * self.speed.at(T)

    def slid(self, T):
        if self.sliding:
            return self.sliding.way(T)
        return self.c.get("slide", 0.0) * self.speed.way(T)

    def gap(self, T):
        kappa = 1 / self.radius.at(T)
        gap = kappa * self.X**2 / 2
        if self.c.get("rides"):
            rate = -self.radius.slope(T) * kappa**2
            gap -= rate * self.X**3 / (6 * self.speed.at(T))
        for f in self.c.get("features", []):
            sign = 0.5 if f["surface"] == 1 else -0.5
            at = f["start"] + self.speed.way(T) + sign * self.slid(T)
            v = (self.X - at) / f["width"]
            gap += f["depth"] * 10.0**(-10 * v * v) * np.cos(2 * np.pi * v)
        return gap

    def arrives(self, T):
        """Returns q of the supplied film (u1 h1 + u2 h2)/um; before T = 0 its
        value at 0."""
        h1, h2 = self.c["film"]
        Cu, V = self.speed.at(max(T, 0)), self.V(max(T, 0))
        return h1 * (1 + V / (2 * Cu)) + h2 * (1 - V / (2 * Cu))

    # --------------------------------------------------------- properties

    def rho(self, P):
        a = 5.9e8 / self.ph
        return (a + 1.34 * P) / (a + P)

    def ln_eta(self, P):
        p0, z = 1.98e8 / self.ph, 0.68
        return self.alphabar * p0 / z * ((1 + P / p0)**z - 1)

    def conductances(self, P, H, V):
        """Returns E at the half nodes."""
        phi = self.rho(P) * np.exp(-self.ln_eta(P)) / self.lam

        def mean(f, power):
            a, b = H[:-1]**power, H[1:]**power
            return (f[:-1] + f[1:]) / 2 * 2 * a * b / (a + b)
        eps = mean(phi, 3)
        if not self.Sigma0:
            return eps
        c = abs(V) / (12 * self.Sigma0) * mean(self.rho(P), 2)
        g = (H[:-1] + H[1:]) / 2 * np.diff(P) / self.D / (2 * self.Sigma0)
        over = np.where(g == 0, 1, g)
        if self.carreau:
            return eps * self.thinning(c / eps, over)
        sinh = np.sinh(g[:, None] * ABOVE)
        even = np.sqrt(1 + sinh * sinh) @ ABOVE_WEIGHTS
        odd = sinh @ (ABOVE_WEIGHTS * ABOVE) * 3
        odd = np.where(g == 0, 1, odd / over)
        return odd * np.sqrt(eps**2 + (c / even)**2)

    def thinning(self, slid, g):
        """Returns E/eps for gamma = x (1 + x^2)^((1/n - 1)/2). The mean stress
        a of the given sliding speed and the flow are computed by
        quadrature."""
        power = (1 / self.carreau[1] - 1) / 2
        half = WEIGHTS / 2

        def step(a, g, slid):
            x = a[:, None] + g[:, None] * POINTS
            thin = (1 + x * x)**power
            slope = thin * (1 + 2 * power * x * x / (1 + x * x))
            return ((x * thin) @ half - slid) / (slope @ half)
        # convex: converges from above; then the contribution of complex steps
        a = np.minimum(slid.real, slid.real**self.carreau[1]) + np.abs(g.real)
        for _ in range(76):
            change = step(a, g.real, slid.real)
            a = a - change
            if (np.abs(change) <= 1e-15 * np.abs(a)).all():
                break
        for _ in range(2):
            a = a - step(a, g, slid)
        x = a[:, None] + g[:, None] * POINTS
        return (x * (1 + x * x)**power) @ (1.5 * WEIGHTS * POINTS) / g

    # ---------------------------------------------------------- equations

    def outflow(self, q, dry):
        """Returns Q at i + 1/2, i = 0 ... n - 2, for motion towards +x."""
        if self.first_order:
            return q[:-1]
        before = np.concatenate([[q[0]], q[:-1]])
        Q = 1.5 * q - 0.5 * before
        Q[0] = q[0]
        if self.conserving:
            Q = np.where(dry & (Q.real < q.real / 2), q / 2, Q)
        return Q[:-1]

    def wedge(self, q, dry, Cu, T):
        """Returns Cu (Q_{i+1/2} - Q_{i-1/2}) at nodes 1 ... n - 2."""
        if Cu < 0:
            Q = self.outflow(q[::-1], dry[::-1])
            out, into = Q[1:], Q[:-1].copy()
            into[0] = q[-1] + self.half * (q[-2] - q[-1])
            return -Cu * (out - into)[::-1]
        Q = self.outflow(q, dry)
        out, into = Q[1:], Q[:-1].copy()
        into[0] = q[0] + self.half * (q[1] - q[0])
        if self.closed:
            into[0] = self.arrives(T - self.D / (2 * Cu))
        return Cu * (out - into)

    def stored(self, q, past, step, dry):
        """Returns (A - B)/dT at nodes 1 ... n - 2. past: q of the two previous
        times."""
        if step is None:
            return 0
        dT, s = step
        if self.first_order:
            return (q - past[0][0])[1:-1] / dT
        kappa, b2 = s / (1 + s), s * s / (1 + s)
        (q1, dry1), (q2, _) = past
        A = (1 + kappa) * q - kappa * q1
        B = (1 + b2) * q1 - b2 * q2
        if self.conserving:
            A = np.where(dry & (A.real < q.real / 2), q / 2, A)
            B = np.where(dry1 & (B < q1 / 2), q1 / 2, B)
        return ((A - B) / dT)[1:-1]

    def flux(self, P, H, T):
        """Returns the pressure-driven flow at the half nodes."""
        flux = self.conductances(P, H, self.V(T)) * np.diff(P) / self.D
        return np.concatenate([[0], flux[1:]]) if self.closed else flux

    def carried(self, q, dry, T, past, step):
        """Returns the sum of wedge term and storage term of each row."""
        return (self.wedge(q, dry, self.speed.at(T), T) / self.D +
                self.stored(q, past, step, dry))

    def rows(self, P, H, q, dry, T, past, step):
        return (np.diff(self.flux(P, H, T)) / self.D -
                self.carried(q, dry, T, past, step))

    def touching(self, H):
        if not self.wall:
            return 0 * H
        a1, s, h, d = self.wall
        A = a1 * np.exp(-H / s)
        if h > 0:
            A = A + np.exp((h - H) / d) * np.expm1(-h / d) / np.expm1(-H / d)
        return A

    # --------------------------------------------------------------- Newton

    def state(self, u, T):
        """Splits the unknowns: x at nodes 1 ... n - 2, asperity pressure
        there, and H0."""
        m = self.n - 2
        P, lack, bears = (np.zeros(self.n) for _ in range(3))
        P[1:-1], lack[1:-1] = np.maximum(u[:m], 0), np.maximum(-u[:m], 0)
        if self.wall:
            bears[1:-1] = u[m:2 * m]
        H = u[-1] + self.gap(T) - self.K @ (P + bears)
        q = self.rho(P) * H
        if self.conserving:
            q = q - lack
            if self.closed:
                q[0] = self.arrives(T)
        return P, bears, H, q, lack

    def defects(self, u, T, past, step):
        P, bears, H, q, lack = self.state(u, T)
        dry = lack > 0
        dry[0] = self.closed
        r = self.rows(P, H, q, dry, T, past, step)
        if not self.conserving:
            r = r + lack[1:-1]
        out = [r]
        if self.wall:
            out.append(bears[1:-1] - self.touching(H)[1:-1])
        load = math.pi / 2 * self.load.at(T) - self.D * (P + bears).sum()
        return np.concatenate(out + [[load]])

    def matrix(self, u, T, past, step):
        """Computes the Jacobian by complex steps: derivatives of the flux with
        respect to P and H of every second node at once, and of the convected
        content with respect to q of every fifth node."""
        n, m, h = self.n, self.n - 2, 1e-200
        P, bears, H, q, lack = self.state(u, T)
        dry = lack > 0
        dry[0] = self.closed
        by = {name: np.zeros((m, n)) for name in "PHq"}
        i = np.arange(1, n - 1)
        for name in "PH":
            left, right = np.zeros(n - 1), np.zeros(n - 1)
            for colour in range(2):
                v = {"P": P.astype(complex), "H": H.astype(complex)}
                v[name][colour::2] += 1j * h
                d = self.flux(v["P"], v["H"], T).imag / h / self.D
                left[colour::2] = d[colour::2]
                right[1 - colour::2] = d[1 - colour::2]
            J = by[name]
            J[i - 1, i - 1] = -left[:-1]
            J[i - 1, i] = left[1:] - right[:-1]
            J[i - 1, i + 1] = right[1:]
        for colour in range(5):
            v = q.astype(complex)
            v[colour::5] += 1j * h
            d = -self.carried(v, dry, T, past, step).imag / h
            j = i - 2 + (colour - i + 2) % 5         # node of this colour
            there = (j >= 0) & (j < n)
            by["q"][(i - 1)[there], j[there]] = d[there]
        rho1 = self.rho(P + 1j * h).imag / h
        rho = self.rho(P)
        wet = u[:m] > 0
        own = np.ones(n)
        if self.closed:
            own[0] = 0                            # q is prescribed

        by_film = by["H"] + by["q"] * (own * rho)
        K = self.K[:, 1:-1]

        def film(dH):
            """Multiplies the matrix of five diagonals by dH."""
            out = np.zeros((m, dH.shape[1]))
            for d in range(-2, 3):
                i = np.arange(max(0, -d - 1), min(m, n - 1 - d))
                out[i] += by_film[i, i + 1 + d][:, None] * dH[i + 1 + d]
            return out
        Jx = (by["P"] + by["q"] * (own * rho1 * H))[:, 1:-1] * wet + \
            film(-K * wet)
        if self.conserving:
            Jx += by["q"][:, 1:-1] * ~wet
        else:
            Jx -= np.diag((~wet).astype(float))
        J0 = film(np.ones((n, 1)))
        if not self.wall:
            last = np.concatenate([-self.D * wet, [0]])
            return np.vstack([np.hstack([Jx, J0]), last])
        slope = (self.touching(H + 1j * h).imag / h)[1:-1, None]
        inner = K[1:-1]
        return np.vstack([
            np.hstack([Jx, film(-K), J0]),
            np.hstack([slope * inner * wet, np.eye(m) + slope * inner,
                       -slope]),
            np.concatenate([-self.D * wet,
                            -self.D * np.ones(m), [0]])])

    def solve(self, u, T, past=None, step=None, most=100):
        """Solves by Newton's method with changes of at most a fifth of p_h.
        The iteration ends when the change no longer decreases because of
        rounding, and must then be below 1e-11."""
        m = self.n - 2
        change = math.inf
        for _ in range(most):
            last = change
            r = self.defects(u, T, past, step)
            J = self.matrix(u, T, past, step)
            rows = np.abs(J).max(axis=1)
            d = np.linalg.solve(J / rows[:, None], -r / rows)
            moved = np.maximum(u + d, 0) - np.maximum(u, 0)
            moved[m:] = d[m:]
            change = np.abs(moved).max()
            new = u + d * min(1.0, 0.2 / max(change, 1e-300))
            same = (new[:m] > 0) == (u[:m] > 0)
            u = new
            done = change < 1e-12 or last <= change < 1e-11
            if done and same.all():
                return u
        raise ArithmeticError(f"Newton's method left {change:.1e} at T = {T}")

    def about(self, u, T, past, step):
        """Returns the unknowns of guessed pressures, with the residual where
        the pressure is zero."""
        if self.conserving:
            return u
        m = self.n - 2
        P, _, H, q, lack = self.state(u, T)
        r = self.rows(P, H, q, lack > 0, T, past, step)
        return np.concatenate([np.where(u[:m] > 0, u[:m], np.minimum(r, 0)),
                               u[m:]])

    def march(self, guesses, times):
        """Yields P, asperity pressure, H, q and missing lubricant at the times,
        of which the first is the steady start. guesses: unknowns for each time,
        used for the first and if extrapolation does not converge."""
        u = self.solve(guesses(0), times[0])
        state = self.state(u, times[0])
        yield state
        past = [(state[3], state[4] > 0)] * 2
        old, before = None, u
        for k in range(1, len(times)):
            dT = times[k] - times[k - 1]
            s = dT / old if old else 1.0
            new = None
            for guess in (lambda: u + (u - before) * s, lambda: u,
                          lambda: guesses(k)):
                first = self.about(guess(), times[k], past, (dT, s))
                try:
                    new = self.solve(first, times[k], past, (dT, s), 25)
                    break
                except (ArithmeticError, np.linalg.LinAlgError) as why:
                    failed = why
            if new is None:
                raise failed
            before, u, old = u, new, dT
            state = self.state(u, times[k])
            past = [(state[3], state[4] > 0), past[0]]
            yield state
