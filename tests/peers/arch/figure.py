"""Picture of the comparison: one panel of forces, one of their ratio along the channel."""

import numpy as np


def draw(clogs, file):
    """clogs: {seed: (x [D], resolved [n, 3], law [n, 3])} of compared spheres [N]"""
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4.2), layout="constrained")
    most = 0.0
    for (seed, (x, resolved, law)), mark in zip(clogs.items(), "o^sDv"):
        size, along = np.linalg.norm(law, axis=1), np.sum(resolved * law, axis=1) / np.linalg.norm(law, axis=1)
        across = np.sqrt(np.maximum(np.sum(resolved**2, axis=1) - along**2, 0))
        colour = left.plot(1e9 * size, 1e9 * along, mark, ms=4, alpha=0.7, label=f"clog {seed}")[0].get_color()
        right.plot(x, along / size, mark, ms=4, alpha=0.7, color=colour, label=f"clog {seed}")
        right.plot(x, across / size, mark, ms=3, alpha=0.7, mfc="none", color=colour)
        most = max(most, 1e9 * size.max(), 1e9 * along.max())
    left.plot([0, most], [0, most], "k-", lw=0.8, label="equal")
    left.set(xlabel="strip law [nN]", ylabel="resolved, along the law's direction [nN]")
    left.legend(frameon=False)
    right.axhline(1, color="k", lw=0.8)
    right.axhline(0, color="0.7", lw=0.8)
    right.axvline(0, color="0.7", lw=0.8, ls="--")
    right.set(xlabel="x / D (the neck begins at 0)", ylabel="resolved over strip law\nfull: along, open: across")
    figure.savefig(file, dpi=130)
    plt.close(figure)
