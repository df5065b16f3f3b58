"""Lapses between passages and survival of arrests, with their fits (paper, figure 5)."""

import numpy as np

import fig_trend
import style

RULED_OUT_BELOW = 0.1  # p-value, as Clauset et al.
FEWEST_STEPS = 3       # arrests that must have ended by themselves for a survival function to mean anything
SHORTEST_SHOWN = 1e-3  # T/tau; below it two particles cross the plane side by side


def with_interval(value, error):
    return f"{value:.2f} [{value - style.TO_95 * error:.2f}, {value + style.TO_95 * error:.2f}]"


def is_crowded(statistics):
    """Whether one legend beside the panels explains the colours of all."""
    return len(statistics.groups) > style.MOST_GROUPS_INSIDE


def draw_density(axes, statistics):
    colours = style.group_colours(len(statistics.groups))
    single = len(statistics.groups) == 1
    shown = []
    for index, group in enumerate(statistics.groups):
        rows = [row for row in statistics.rows("lapse_distribution", index) if row["count"] > 0]
        if not rows:
            continue
        x = np.array([np.sqrt(row["T/tau_from [1]"] * row["T/tau_to [1]"]) for row in rows])
        p = np.array([row["P [1]"] for row in rows])
        error = style.TO_95 * np.array([row["error [1]"] for row in rows])
        axes.errorbar(x, p, yerr=[np.minimum(error, 0.7 * p), error], fmt=style.MARKERS[index % len(style.MARKERS)], ms=3.6, lw=0.7,
                      color=colours[index], mec="white", mew=0.3,
                      label=survival_label(group) if is_crowded(statistics) else style.plain(group["label"]))
        draw_fits(axes, group, colours[index], x.max(), single)
        shown += [v for t, v in zip(x, p) if t >= SHORTEST_SHOWN]
    axes.set_xscale("log")
    axes.set_yscale("log")
    if shown:
        mark_threshold(axes, statistics)
        axes.set_xlim(left=max(axes.get_xlim()[0], SHORTEST_SHOWN))
        axes.set_ylim(0.2 * min(shown), 5 * max(shown))
    else:
        style.say(axes, "no two passages in any run")
        axes.set_xlim(0.01, 100)
        axes.set_ylim(1e-4, 10)
    axes.set_xlabel(r"lapse $T/\tau$ [1]")
    axes.set_ylabel(r"probability density $P(T/\tau)$ [1]")
    if is_crowded(statistics):
        style.legend_beside(axes)
    else:
        style.legend(axes, loc="lower left")


def draw_fits(axes, group, colour, largest, single):
    """Density of each fitted law, weighted with the share of lapses that belong to its tail."""
    styles = {"free": ("-", colour if not single else style.GREY), "fixed": ("--", colour if not single else style.INK)}
    names = {"free": r"$T_{\min}$ found", "fixed": r"$T_{\min}=\tau/2$"}
    for key, (line, fit_colour) in styles.items():
        fit = group["power_law"][key]
        if "refused" in fit or (not single and (key == "free" or group["protocol"] != "none")):
            continue
        xmin, alpha = fit["xmin_over_tau"], fit["alpha"]
        x = np.geomspace(xmin, max(largest * 1.2, 2 * xmin), 50)
        share = fit["n_tail"] / fit["n"]
        ruled_out = "\nruled out (p = {:.2g})".format(fit["p_value"]) if fit.get("p_value", 1) < RULED_OUT_BELOW else ""
        label = f"{names[key]}: $\\alpha$ = {with_interval(alpha, fit['sigma'])}{ruled_out}"
        axes.plot(x, share * (alpha - 1) / xmin * (x / xmin) ** -alpha, line, color=fit_colour, lw=1.3, zorder=3,
                  label=label if single else None)


def mark_threshold(axes, statistics):
    group = statistics.groups[0]
    axes.axvline(group["t_min"] / group["tau"], color=style.GREY, lw=0.8, ls=":", zorder=0)


def draw_survival(axes, statistics):
    """Kaplan-Meier estimate for the arrests, censored ones included, and the two rival laws."""
    colours = style.group_colours(len(statistics.groups))
    lowest, drawn = 0.9, False
    for index, group in enumerate(statistics.groups):
        rows = statistics.rows("arrest_survival", index)
        if len(rows) < FEWEST_STEPS:
            continue
        drawn = True
        x = np.array([group["t_min"] / group["tau"]] + [row["T/tau [1]"] for row in rows])
        s = np.array([1.0] + [row["S [1]"] for row in rows])
        error = style.TO_95 * np.array([0.0] + [row["error [1]"] for row in rows])
        lowest = min(lowest, s[s > 0].min(), *(s - error)[s - error > 0.7 * s])
        axes.fill_between(x, np.maximum(s - error, 1e-9), np.minimum(s + error, 1), step="post", color=colours[index], alpha=0.18, lw=0)
        axes.step(x, np.maximum(s, 1e-9), where="post", color=colours[index], label=survival_label(group))
        draw_laws(axes, group, x, len(statistics.groups) == 1)
    axes.set_xscale("log")
    axes.set_yscale("log")
    if drawn:
        axes.set_ylim(0.93 * lowest, 1.04)
        style.label_within_a_decade(axes.yaxis)
        style.label_within_a_decade(axes.xaxis)
    else:
        style.say(axes, missing_survival(statistics))
        axes.set_xlim(0.3, 30)
        axes.set_ylim(0.01, 4)
    axes.set_xlabel(r"arrest $T/\tau$ [1]")
    axes.set_ylabel(r"survival of arrests $S(T/\tau)$ [1]")
    if not is_crowded(statistics):
        if drawn:
            style.room_for_legend(axes)
        style.legend(axes, loc="upper right")


def counts(group):
    """(all arrests, censored ones)"""
    arrests = group["arrests"]
    cut = arrests["ended_by_release"] + arrests["ended_by_end_of_run"]
    return arrests["ended_by_passage"] + cut, cut


def survival_label(group):
    return "{}: {} arrests, {} censored".format(style.plain(group["label"]), *counts(group))


def missing_survival(statistics):
    arrests, cut = (sum(numbers) for numbers in zip(*map(counts, statistics.groups)))
    if arrests == 0:
        return r"no arrest ($T \geq T_{\min}$) in any run"
    return f"{cut} of {arrests} arrests were cut by a release\nor by the end of the run:\nno survival function"


def draw_laws(axes, group, x, single):
    fit = group["power_law"]["fixed_censored"]
    if not single or "refused" in fit:
        return
    tau, t_min = group["tau"], group["t_min"]
    grid = np.geomspace(t_min / tau, x.max() * 1.1, 100)
    misfit = "\nruled out: misses by {:.1f} standard errors".format(fit["standard_errors"]) if fit.get("ruled_out") else ""
    axes.plot(grid, (grid * tau / t_min) ** (1 - fit["alpha"]), "--", color=style.INK, lw=1.2,
              label=f"power law, $\\alpha$ = {with_interval(fit['alpha'], fit['sigma'])}{misfit}")
    axes.plot(grid, np.exp(-fit["exponential"]["rate"] * (grid * tau - t_min)), ":", color=style.GREY, lw=1.4,
              label=f"exponential (likelihood ratio: {fit['exponential']['favoured']})")


def figures(statistics):
    sweep = fig_trend.exists(statistics)
    count = 3 if sweep else 2
    figure, panels = style.row_of_panels(count, 3.5, 3.4)
    figure.get_layout_engine().set(wspace=0.06)
    draw_density(panels[0], statistics)
    draw_survival(panels[1], statistics)
    if sweep:
        fig_trend.draw_alpha(panels[2], statistics)
    for letter, axes in zip("abc", panels):
        axes.set_title(letter)
    yield "lapses", figure
