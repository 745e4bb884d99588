"""Projection of a velocity from equally spaced particles to nodes, written directly from equations 2.1, 4.1 and 4.2 of
Wallstedt & Guilkey (2007): what the squeeze tests are compared with. Needs Debian's python3-numpy."""

import numpy as np


def weights(shape, x, half, nodes, h):
    """S_ip and its derivative by x_p, nodes by particles."""
    s = (x[None, :] - nodes[:, None]) / h
    if shape == "linear":
        return np.maximum(0, 1 - abs(s)), np.where(abs(s) < 1, np.where(s < 0, 1, -1), 0) / h
    size = half / h

    def integral(s):
        s = np.clip(s, -1, 1)
        return s - np.sign(s) * s * s / 2

    def tent(s):
        return np.maximum(0, 1 - abs(s))

    return ((integral(s + size) - integral(s - size)) / (2 * size), (tent(s + size) - tent(s - size)) / (2 * half))


def largest_error(shape, power, enhanced, number, h=0.01, cells=100):
    """Largest relative error at the nodes within the bar for v = (1 + x)^power. With enhancement there are two projections: one
    with the particles' exact gradients, and one with those that they take from the nodes in the step between (equation 4.1)."""
    length = cells * h
    x = (np.arange(number) + 0.5) * length / number
    nodes = np.arange(cells + 1) * h
    value, slope = weights(shape, x, length / number / 2, nodes, h)
    mass = value.sum(axis=1)
    particles = (1 + x) ** power
    exact = (1 + nodes) ** power

    def project(gradient):
        extended = particles[None, :] - gradient[None, :] * (x[None, :] - nodes[:, None])
        with np.errstate(invalid="ignore"):
            return (value * extended).sum(axis=1) / mass

    def error(velocity):
        return np.nanmax(abs(velocity / exact - 1)[1:-1])

    if not enhanced:
        return error(project(np.zeros(number)))
    first = project(power * (1 + x) ** (power - 1))
    return max(error(first), error(project(first @ slope)))
