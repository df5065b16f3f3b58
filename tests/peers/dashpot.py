"""One dashpot, said in each program's words: LIGGGHTS is given the restitution e, the others what has the same constant."""

import math


def damping_ratio(e):
    """LIGGGHTS' beta: of a swing that ends at no overlap (Antypov & Elliott 2011)."""
    return -math.log(e) / math.hypot(math.log(e), math.pi)


def our_restitution(e):
    """Of an impact that ends when the force is zero, same dashpot."""
    phi = math.asin(damping_ratio(e))
    return math.exp(-(math.pi - 2 * phi) * math.tan(phi))


def lammps_restitution(e):
    """Where LAMMPS' polynomial (Tsuji) is this dashpot, sqrt(5) beta."""
    wanted, low, high = math.sqrt(5) * damping_ratio(e), 0.0, 1.0
    for _ in range(100):
        x = (low + high) / 2
        alpha = 1.2728 - 4.2783*x + 11.087*x**2 - 22.348*x**3 + 27.467*x**4 - 18.022*x**5 + 4.8218*x**6
        low, high = (x, high) if alpha > wanted else (low, x)
    return low
