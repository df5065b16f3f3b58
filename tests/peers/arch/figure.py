"""Picture of the comparison: resolved forces against the law in both velocities, and their ratio across the channel."""

import numpy as np

FLOWS = {"strips": "strip law, V0", "plug strips": "strip law, plug flow"}


def draw(clogs, across, file):
    """clogs: {seed: ClogResults}; across: {seed: |y| over the half width there [n]}"""
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    figure, panels = plt.subplots(1, 3, figsize=(12, 3.9), layout="constrained")
    most = 0.0
    for panel, (law, name) in zip(panels, FLOWS.items()):
        for (seed, clog), mark in zip(clogs.items(), "o^sDv"):
            force, by_law = clog.force()[clog.inner], clog.laws[law][clog.inner]
            size = np.linalg.norm(by_law, axis=1)
            along = np.sum(force * by_law, axis=1) / size
            panel.plot(1e9 * size, 1e9 * along, mark, ms=4, alpha=0.7, label=f"clog {seed}")
            panels[2].plot(across[seed][clog.inner], along / size, "o" if law == "strips" else "x", ms=4, alpha=0.7,
                           color="C3" if law == "strips" else "C0", label=name if seed == min(clogs) else None)
            most = max(most, 1e9 * size.max(), 1e9 * along.max())
        panel.set(xlabel=f"{name} [nN]", ylabel="resolved, along the law's direction [nN]")
    for panel in panels[:2]:
        panel.plot([0, most], [0, most], "k-", lw=0.8, label="equal")
        panel.set(xlim=(0, 1.03 * most), ylim=(0, 1.03 * most), aspect="equal")
    panels[0].legend(frameon=False, fontsize=8)
    panels[2].axhline(1, color="k", lw=0.8)
    panels[2].set(xlabel="|y| over the half width there", ylabel="resolved over law", ylim=(0, None))
    panels[2].legend(frameon=False, fontsize=8)
    figure.savefig(file, dpi=110)
    plt.close(figure)
