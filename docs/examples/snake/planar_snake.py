"""The snake of snake.toml by three equations: a line of prescribed curvature on a plane, with scipy.

Positions are integrals of its direction along the line, by Gauss's rule of eight points on panels. What is unknown is
how it moves and turns as a whole: its centre, its angle and its momenta, which friction changes.
"""

import numpy as np
from scipy.integrate import solve_ivp

PANELS = 50
DENSITY, ROTARY, GRAVITY = 1.0, 1e-5, 9.81
FORWARD, BACKWARD, ACROSS = 0.1, 0.15, 0.3
SLOWEST = 1e-5  # below it friction is in proportion to the speed

abscissae, weights = np.polynomial.legendre.leggauss(8)
s = (np.arange(PANELS)[:, None] + 0.5 * (abscissae + 1)) / PANELS
weights = 0.5 * weights / PANELS
# Integrals from the start of a panel to each of its points, by the polynomial through all.
powers = np.polynomial.legendre.legvander(abscissae, 7)
within = np.array([np.polynomial.legendre.legval(abscissae, np.polynomial.legendre.legint(row, lbnd=-1)) for row in np.eye(8)]).T
within = 0.5 / PANELS * within @ np.linalg.inv(powers)


def integrate(values):
    return (values @ weights).sum()


def cumulate(values):
    """The integral from the tail to each point, and to the head."""
    panels = values @ weights
    return values @ within.T + (np.cumsum(panels) - panels)[:, None], panels.sum()


def find_angles(t):
    """The angle of the line relative to the tail, and its rate."""
    size, rate = 7 * (1 - np.exp(-4 * t**2)), 56 * t * np.exp(-4 * t**2)
    k = 2 * np.pi
    wave, wave_rate = (np.sin(k * (s + t)) - np.sin(k * t)) / k, np.cos(k * (s + t)) - np.cos(k * t)
    return size * wave, rate * wave + size * wave_rate


def find_shape(t):
    """Angles, their rates, places and velocities about the centre in the axes of the tail, and both ends."""
    angle, rate = find_angles(t)
    c, n = np.cos(angle), np.sin(angle)
    parts = [cumulate(values) for values in (c, n, -n * rate, c * rate)]
    centre = [integrate(values) for values, _ in parts]
    tail = np.array([-centre[0], -centre[1]])
    head = tail + [parts[0][1], parts[1][1]]
    return angle, rate, [values - middle for (values, _), middle in zip(parts, centre)], tail, head


def find_rates(t, state):
    _, _, vx, vy, turn, spin = state
    angle, rate, (x, y, u, v), _, _ = find_shape(t)
    inertia = DENSITY * integrate(x**2 + y**2) + ROTARY
    omega = (spin - DENSITY * integrate(x * v - y * u) - ROTARY * integrate(rate)) / inertia
    c, n = np.cos(turn), np.sin(turn)
    u, v = u - omega * y, v + omega * x
    u, v = vx + c * u - n * v, vy + n * u + c * v
    x, y = c * x - n * y, n * x + c * y
    tx, ty = np.cos(angle + turn), np.sin(angle + turn)
    along, across = u * tx + v * ty, v * tx - u * ty
    size = DENSITY * GRAVITY / np.sqrt(along**2 + across**2 + SLOWEST**2)
    f, g = -size * np.where(along > 0, FORWARD, BACKWARD) * along, -size * ACROSS * across
    fx, fy = f * tx - g * ty, f * ty + g * tx
    return [vx, vy, integrate(fx) / DENSITY, integrate(fy) / DENSITY, omega, integrate(x * fy - y * fx)]


def main():
    times = np.arange(5.0)
    found = solve_ivp(find_rates, (0, 4), [0.5, 0, 0, 0, 0, 0], method="DOP853", rtol=1e-7, atol=1e-9, max_step=0.01, t_eval=times)
    for t, (x, y, _, _, turn, _) in zip(times, found.y.T):
        c, n = np.cos(turn), np.sin(turn)
        tail, head = ([x, y] + np.array([[c, -n], [n, c]]) @ end for end in find_shape(t)[3:])
        print(f"t = {t}: tail {tail.round(5)}, head {head.round(5)}")


if __name__ == "__main__":
    main()
