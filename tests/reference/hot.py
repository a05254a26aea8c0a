# SPDX-License-Identifier: GPL-3.0-or-later
"""The independent model of model.py with temperatures of film and surfaces.

It shares with overroll only the heat equations of overroll-theory(7) and the
discrete film thickness of model.py.  The following is different:

  - Temperatures across the film: Chebyshev collocation at 17 points in the
    strong form, with separate rows for the surfaces (overroll: weak form, 7
    points).
  - Flow and shear of a film whose viscosity varies across it: Gauss quadrature
    of the rheological model, also where sliding and pressure gradient thin the
    film together (overroll: Dowson's integrals multiplied by the factor of the
    uniform film, which the entry `dowson` of a case selects here too).
  - The thermal memory of a surface: the integral of its heat flux divided by
    sqrt(time since then) along the path of the material, from the fluxes of
    all steps (overroll: convected fields that decay).
  - The memory under a layer: Carslaw and Jaeger's images, integrated by
    quadrature (overroll: fit to the inverse transform of the impedance).
  - Film and temperatures of a step are solved alternately until both converge
    (overroll: viscosities are extrapolated from previous temperatures).

Both models follow the paths of the layers in time, to first order.  Surfaces
move fast in the same direction: heat conduction along them is neglected.
"""
import math

import numpy as np

from model import Model, POINTS, WEIGHTS

ABSOLUTE = 138.0              # K, of Roelands' law


def chebyshev(n):
    """Returns Chebyshev points from -1 to 1 and their differentiation
    matrix."""
    s = -np.cos(np.pi * np.arange(n) / (n - 1))
    c = np.ones(n)
    c[[0, -1]] = 2
    c *= (-1.0)**np.arange(n)
    D = np.outer(c, 1 / c) / (s[:, None] - s + np.eye(n))
    return s, D - np.diag(D.sum(axis=1))


def between(s, at):
    """Returns the matrix that interpolates from the Chebyshev points s to the
    points `at`."""
    w = (-1.0)**np.arange(len(s))
    w[[0, -1]] /= 2
    parts = w / (at[:, None] - s)
    return parts / parts.sum(axis=1)[:, None]


def cubic(X, values, x):
    """Interpolates each row of values at its row of x, by a cubic through the
    four nearest nodes of a uniform grid. The result is 0 upstream of the first
    node and the last value downstream of the last."""
    D, n = X[1] - X[0], len(X)
    i = np.clip(((x - X[0]) / D).astype(int), 1, n - 3)
    t = (x - X[i]) / D
    a, b, c, d = (np.take_along_axis(values, i + k, axis=-1)
                  for k in (-1, 0, 1, 2))
    y = (-t * (t - 1) * (t - 2) / 6 * a + (t + 1) * (t - 1) * (t - 2) / 2 * b -
         (t + 1) * t * (t - 2) / 2 * c + (t + 1) * t * (t - 1) / 6 * d)
    return np.where(x <= X[0], 0, np.where(x >= X[-1], values[..., -1:], y))


class Physical:
    """Dimensionless parameters of the equations for a contact in SI units."""

    def __init__(self, given):
        w, R, E, eta0 = (given[k] for k in
                         ("load", "radius", "modulus", "viscosity"))
        um = (given["speed_1"] + given["speed_2"]) / 2
        self.b = math.sqrt(8 * w * R / (math.pi * E))
        self.ph = 2 * w / (math.pi * self.b)
        two_U = 2 * eta0 * um / (E * R)
        self.M = w / (E * R) / math.sqrt(two_U)
        self.L = given["alpha"] * E * two_U**0.25
        self.slide = (given["speed_1"] - given["speed_2"]) / um
        self.kappa = self.b / R
        self.Sigma0 = given["eyring_stress"] / (self.ph * self.kappa)
        self.film = self.b**2 / R
        self.p0 = 1.98e8 / self.ph
        self.z = given["alpha"] * 1.98e8 / (math.log(eta0) + 9.67)
        k, c, rho0 = given["oil"]
        self.Theta = self.ph / (rho0 * c)
        self.Kf = k * R**2 / (rho0 * c * um * self.b**3)
        self.N = [k * R * self.b**-1.5 / math.sqrt(math.pi * k1 * c1 * r1 * um)
                  for k1, c1, r1 in given["body"]]
        # layer of each body: effusivity relative to the body, d^2 rho c/k
        self.coat = [None, None]
        for body, (d, k1, c1, r1) in given.get("coat", {}).items():
            below = given["body"][body - 1]
            self.coat[body - 1] = (
                math.sqrt(k1 * c1 * r1 / math.prod(below)),
                d * d * c1 * r1 / k1 / (self.b / um))


class Hot(Model):
    """`case` as of Model, with `physical`, a dictionary of SI units."""

    def __init__(self, case):
        given = case["physical"]
        p = self.p = Physical(given)
        full = dict(case, M=p.M, L=p.L, slide=p.slide, eyring=p.Sigma0)
        if "arriving" in case:
            full["film"] = tuple(h / p.film for h in case["arriving"])
        super().__init__(full)
        self.ph = p.ph
        self.T0, self.expansion = given["temperature"], given["expansion"]
        self.S0 = given["S0"]
        self.s, Ds = chebyshev(17)
        self.Dz = 2 * Ds                        # by zeta = (1 + s)/2
        inner = np.linalg.inv(Ds[1:, 1:])       # integral from s = -1
        self.Iz = np.zeros_like(Ds)
        self.Iz[1:, 1:] = inner / 2
        self.to_gauss = between(self.s, POINTS)
        self.known = {}
        self.at_temperature(np.zeros((17, self.n)), np.zeros(self.n))

    # -------------------------------------------------------- the oil

    def mean(self, T):
        return WEIGHTS / 2 @ (self.to_gauss @ T)

    def log_eta(self, P, T):
        th = ((self.T0 + T - ABSOLUTE) / (self.T0 - ABSOLUTE))**-self.S0
        C = self.alphabar * self.p.p0 / self.p.z
        return C * ((1 + P / self.p.p0)**self.p.z * th - 1)

    def swelling(self, P):
        a = 5.9e8 / self.ph
        return a * a / ((a + P) * (a + 1.34 * P)) * self.expansion

    def at_temperature(self, T, P):
        """Sets the temperatures with which the flow is computed."""
        self.T, self.Tm = T, self.mean(T)
        fluid = np.exp(self.log_eta(P, self.Tm) - self.log_eta(P, T))
        self.r = self.to_gauss @ fluid
        half = WEIGHTS / 2
        m0, m1 = half @ self.r, (half * POINTS) @ self.r
        V = self.V(0)
        self.turned = np.where(P > 0, V / 2 * m1 / m0, 0)

    def rho(self, P):
        return super().rho(P) / (1 + self.swelling(P) * self.Tm)

    def ln_eta(self, P):
        return self.log_eta(P, self.Tm)

    @staticmethod
    def bent(g):
        """Returns exp(g s) divided by its maximum, and the logarithm of this
        maximum."""
        most = np.abs(g.real)
        return np.exp(g * POINTS[:, None] - most), most

    @staticmethod
    def slides(r, b, e, most):
        """Solves for a: the mean of r sinh(a + g s) is b. e and most are the
        results of `bent`."""
        w = WEIGHTS[:, None] / 2 * r
        up, down = (w * e).sum(axis=0), (w * e[::-1]).sum(axis=0)
        b = b * np.exp(-most)
        return np.log((b + np.sqrt(b * b + up * down)) / up)

    def faces(self, P, H, V):
        """Returns eps at the mean temperatures, r and b at the half nodes."""
        phi = self.rho(P) * np.exp(-self.ln_eta(P)) / self.lam

        def mean(f, power):
            a, b = H[:-1]**power, H[1:]**power
            return (f[:-1] + f[1:]) / 2 * 2 * a * b / (a + b)
        eps = mean(phi, 3)
        b = -V / (12 * self.Sigma0) * mean(self.rho(P), 2) / eps
        return eps, (self.r[:, :-1] + self.r[:, 1:]) / 2, b

    def conductances(self, P, H, V):
        eps, r, b = self.faces(P, H, V)
        g = (H[:-1] + H[1:]) / 2 * np.diff(P) / self.D / (2 * self.Sigma0)
        g = np.where(abs(g) < 1e-5, 1e-5, g)
        s, half = POINTS[:, None], WEIGHTS[:, None] / 2
        m0, m1 = (half * r).sum(axis=0), (half * r * s).sum(axis=0)
        if self.c.get("dowson"):
            psi = 3 * ((half * r * s * s).sum(axis=0) - m1 * m1 / m0)
            sinh = np.sinh(g * s[24:])
            even = 2 * (half[24:] * np.sqrt(1 + sinh * sinh)).sum(axis=0)
            odd = 6 * (half[24:] * s[24:] * sinh).sum(axis=0) / g
            return eps * psi * odd * np.sqrt(1 + (b / (m0 * even))**2)
        e, most = self.bent(g)
        a = self.slides(r, b, e, most)
        sinh = (np.exp(a + most) * e - np.exp(most - a) * e[::-1]) / 2
        flow = (half * s * r * sinh).sum(axis=0)
        return eps * 3 * (flow - b * m1 / m0) / g

    def wedge(self, q, dry, Cu, T):
        return super().wedge(q * (1 + self.turned), dry, Cu, T)

    def friction(self, P, H, T):
        """Returns |mu_slide|, int t dX divided by the load."""
        _, r, b = self.faces(P, H, self.V(T))
        g = (H[:-1] + H[1:]) / 2 * np.diff(P) / self.D / (2 * self.Sigma0)
        t = self.Sigma0 * self.slides(r, b, *self.bent(g))
        held = (P[:-1] > 0) | (P[1:] > 0)
        return abs(self.D * t[held].sum()) / \
            (math.pi / 2 * self.load.at(T)) * self.p.kappa

    # ---------------------------------------------------------------- heat

    def sheet(self, P, q, Cu, V):
        """Returns height, velocity and heating of the lubricant in every
        column."""
        H = q / self.rho(P)
        P_X = np.zeros(self.n)
        P_X[1:-1] = (P[2:] - P[:-2]) / (2 * self.D)
        P_X[P <= 0] = 0
        Y = self.lam * np.exp(self.ln_eta(P)) / (12 * H)
        g = H * P_X / 2 / self.Sigma0
        a = self.slides(self.r, -V * Y / self.Sigma0, *self.bent(g))
        x = a + g * self.s[:, None]
        r = np.exp(self.log_eta(P, self.Tm) - self.log_eta(P, self.T))
        u_z = self.Sigma0 * r * np.sinh(x) / Y
        u = Cu + V / 2 + self.Iz @ u_z
        dry = P <= 0            # cavitated: the lubricant moves with the walls
        u[:, dry] = Cu - V / 2 * self.s[:, None]
        heating = np.where(dry, 0, self.Sigma0 * x * u_z)
        return H, P_X, u, heating

    def columns(self, P, q, P_T, Cu, V):
        """Returns, for every node, matrix and right side of the heat equation
        without convection along the paths, velocities and heights."""
        H, P_X, u, heating = self.sheet(P, q, Cu, V)
        f = self.swelling(P)
        beta = f / (1 + f * self.T)
        press = self.p.Theta * beta * H * (P_T + u * P_X)
        press = np.where(P > 0, press, 0)
        A = -self.p.Kf / H[:, None, None] * (self.Dz @ self.Dz) - \
            np.einsum("ji,jk->ijk", press, np.eye(17))
        b = (self.p.Theta * heating + press * self.T0).T
        return A, b, u, H

    def walls(self, A, b, H, past, resistance):
        """Fills in the rows of both surfaces in A and b of every column."""
        for k, (row, sign) in enumerate(((0, -1), (-1, 1))):
            A[:, row] = sign * resistance[k] * self.Dz[row] / H[:, None]
            A[:, row, row] += 1
            b[:, row] = past[k]

    def fluxes(self, T, H):
        return [(self.Dz[0] @ T) / H, -(self.Dz[-1] @ T) / H]

    def lasting(self, k, t):
        """Returns M(t), the temperature of surface k after a heat pulse
        relative to a half-space."""
        if not self.p.coat[k]:
            return np.ones_like(t)
        e, tau = self.p.coat[k]
        g = (e - 1) / (e + 1)
        n = np.arange(1, 400).reshape(-1, *[1] * t.ndim)
        return (1 + 2 * (g**n * np.exp(-n * n * tau / t)).sum(axis=0)) / e

    def weights(self, k, count, dt):
        """Returns the weights of q at times 0, dt, ... in the past, linear
        between them, in int q M/sqrt(t) dt."""
        t = dt * np.arange(count + 1)
        root = np.sqrt(t)
        half = np.diff(root) / 2
        v = root[:-1, None] + half[:, None] * (1 + POINTS)
        M = self.lasting(k, v * v) * 2 * half[:, None] * WEIGHTS
        whole, first = M.sum(axis=1), (M * v * v).sum(axis=1)
        later = (first - t[:-1] * whole) / dt
        w = np.zeros(count + 1)
        w[:-1] += whole - later
        w[1:] += later
        return w

    def kept(self, k, count, dt):
        """Returns the weights, computed once."""
        most = count + 50
        key = (k, round(dt, 12))
        if len(self.known.get(key, ())) <= count:
            self.known[key] = self.weights(k, most, dt)
        w = self.known[key][:count + 1].copy()
        return w

    def steady_heat(self, P, q):
        """Computes the temperatures of a steady film, column by column
        downstream, with the second-order backward difference along x."""
        Cu, V = self.speed.at(0), self.V(0)
        A, b, u, H = self.columns(P, q, 0, Cu, V)
        T = np.zeros((17, self.n))
        flux = np.zeros((2, self.n))
        v = [Cu + V / 2, Cu - V / 2]
        w = [self.kept(k, self.n, self.D / x) for k, x in enumerate(v)]
        for i in range(1, self.n):
            past = [self.p.N[k] * (w[k][1:i + 1] @ flux[k, i - 1::-1])
                    for k in range(2)]
            speed = q[i] * np.abs(u[:, i]) / self.D
            lead, back = np.ones(17), T[:, i - 1]
            if i > 1:
                lead, back = 1.5 * lead, 2 * back - 0.5 * T[:, i - 2]
            if i + 1 < self.n:           # backflow has the last temperatures
                lead = np.where(u[:, i] < 0, 1, lead)
                back = np.where(u[:, i] < 0, self.T[:, i + 1], back)
            A1 = (A[i] + np.diag(lead * speed))[None]
            b1 = (b[i] + speed * back)[None]
            self.walls(A1, b1, H[i:i + 1], [[x] for x in past],
                       [self.p.N[k] * w[k][0] for k in range(2)])
            T[:, i] = np.linalg.solve(A1[0], b1[0])
            flux[:, i] = [f[0] for f in
                          self.fluxes(T[:, i:i + 1], H[i:i + 1])]
        return T, flux

    def past(self, k, T, dT):
        """Returns N int q/sqrt(t) dt of surface k without the present q."""
        v = self.speed.at(T) + (0.5, -0.5)[k] * self.V(T)
        steps = len(self.history)
        count = steps + int((self.X[-1] - self.X[0]) / (v * dT)) + 2
        w = self.kept(k, count, dT)
        ago = np.arange(1, count + 1)
        q = np.array([self.history[l][k] for l in np.maximum(steps - ago, 0)])
        came = cubic(self.X, q, self.X - v * dT * ago[:, None])
        return self.p.N[k] * (w[1:] @ came)

    def step_heat(self, P, q, P_T, old, past, T, dT):
        A, b, u, H = self.columns(P, q, P_T, self.speed.at(T), self.V(T))
        foot = cubic(self.X, old, self.X - u * dT)
        A += (q / dT)[:, None, None] * np.eye(17)
        b += (q / dT * foot).T
        self.walls(A, b, H, past,
                   [self.p.N[k] * self.kept(k, 1, dT)[0] for k in range(2)])
        new = np.linalg.solve(A, b[:, :, None])[:, :, 0].T
        new[:, 0] = 0
        return new, self.fluxes(new, H)

    # ----------------------------------------------- alternating solution

    def settle(self, u, T, past, step, heat):
        """Iterates film and temperatures until both converge."""
        for turn in range(120):
            u = self.solve(u, T, past, step)
            state = self.state(u, T)
            new, flux = heat(state)
            apart = np.abs(new - self.T).max()
            # the last pressurized node may alternate between iterations
            if apart < (1e-3 if turn < 20 else 5e-3) * max(new.max(), 1):
                return u, state, new, flux
            self.at_temperature((self.T + new) / 2, state[0])
        raise ArithmeticError(f"temperatures move by {apart:.1e} at T = {T}")

    def march(self, guesses, times):
        """Yields P, H, temperatures (17, n) and friction at each time."""
        T = times[0]
        u = guesses(0)
        for _ in range(20):               # temperatures of the guessed film
            P, _, _, q, _ = self.state(u, T)
            self.at_temperature((self.T + self.steady_heat(P, q)[0]) / 2, P)
        u, state, temperature, flux = self.settle(
            u, T, None, None, lambda s: self.steady_heat(s[0], s[3]))
        self.history = [flux]
        yield (state[0], state[2], temperature,
               self.friction(state[0], state[2], T))
        past = [(state[3], state[4] > 0)] * 2
        before, old_dT = u, None
        for k in range(1, len(times)):
            T, dT = times[k], times[k] - times[k - 1]
            s = dT / old_dT if old_dT else 1.0
            old, P_old = temperature, state[0]
            walls = [self.past(j, T, dT) for j in range(2)]
            self.at_temperature(old, P_old)

            def heat(now):
                return self.step_heat(now[0], now[3], (now[0] - P_old) / dT,
                                      old, walls, T, dT)
            new, state, temperature, flux = self.settle(
                u, T, past, (dT, s), heat)
            before, u, old_dT = u, new, dT
            self.history.append(flux)
            past = [(state[3], state[4] > 0), past[0]]
            yield (state[0], state[2], temperature,
                   self.friction(state[0], state[2], T))

