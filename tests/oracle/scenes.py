"""The short scenes that `same_bits` runs: together they use every term and every path of the solver.

Each starts from one of three texts (a box of unequal spheres, a channel, a channel from an STL file) and names what it
changes. A scene with several paths is cheaper than many scenes; where two terms could hide each other they stand apart.
"""

import random
from dataclasses import dataclass, field
from pathlib import Path

REPOSITORY = Path(__file__).resolve().parents[2]


@dataclass
class Scene:
    about: str
    text: str
    flow: str = ""              # which of FLOWS it reads
    options: list = field(default_factory=list)
    ranks: int = 1
    interrupted: str = ""       # time limit after which it is stopped and called again
    same_as: str = ""           # the scene whose files it must repeat
    later: bool = False         # an earlier program may refuse it: then there is nothing to compare with


def text_of(sections):
    """A scene file from {"section.key": value}; keys without a section come first."""
    lines = [f"{key} = {value}" for key, value in sections.items() if "." not in key]
    names = list(dict.fromkeys(key.rsplit(".", 1)[0] for key in sections if "." in key))
    for name in names:
        lines.append(f"[{name}]")
        for key, value in sections.items():
            if "." in key and key.rsplit(".", 1)[0] == name and key.rsplit(".", 1)[1]:
                lines.append(f"{key.rsplit('.', 1)[1]} = {value}")
    return "\n".join(lines) + "\n"


CHANNEL = {
    "geometry.neck_width": '"100 um"', "geometry.channel_length": '"300 um"', "geometry.half_angle": '"60 deg"',
    "fluid.viscosity": '"1.8e-3 Pa s"', "fluid.density": '"1062 kg/m3"',
    "flow.mean_velocity": '"5 mm/s"', "flow.mesh_cells_per_neck": 8, "flow.grid_spacing": '"5 um"',
    "particles.diameter": '"47 um"',
    "contact.youngs_modulus": '"3 MPa"', "contact.poisson_ratio": 0.35, "contact.restitution": 0.7,
    "contact.friction.sliding": 0.6, "contact.friction.rolling": 0.6, "contact.friction.torsion": 0.6,
    "lubrication.enabled": "true", "drag.enabled": "true", "porosity.strips": 3, "inlet.start": '"filled"',
    "unclog.protocol": '"release"', "unclog.after": '"4 ms"', "unclog.duration": '"1.5 ms"',
    "time.end": '"20 ms"', "time.step_fraction": 0.04, "time.mass_scale": 10, "time.rotational_inertia_scale": 5,
    "output.snapshot_interval": '"5 ms"', "output.series_interval": '"0.5 ms"',
}
SHAPE_AND_FLOW = ("geometry.", "fluid.", "flow.")


def spheres(number, seed, columns=("x", "y", "z", "radius", "vx", "vy", "vz", "wx", "wy", "wz")):
    """A loose pack of unequal moving, spinning spheres on a lattice, as CSV."""
    draw = random.Random(seed)
    side = 38e-6
    lines = [",".join(columns)]
    for k in range(number):
        place = (k % 5, k // 5 % 5, k // 25)
        values = [side * (0.5 + p) + draw.uniform(-2e-6, 2e-6) for p in place]
        values[2] += 45e-6  # above the ridge of the STL box
        values += [draw.uniform(12e-6, 16.5e-6)]
        values += [draw.uniform(-0.02, 0.02) for _ in range(3)] + [draw.uniform(-500, 500) for _ in range(3)]
        lines.append(",".join(repr(value) for value in values))
    return "\n".join(lines) + "\n"


def box(folder, **changes):
    keys = {
        "body_force": '["3e-10 N", "-2e-10 N", "-1e-9 N"]',
        "box.min": '["0 m", "0 m", "0 m"]', "box.max": '["200 um", "200 um", "400 um"]',
        "particles.diameter": '"33 um"', "particles.density": '"2500 kg/m3"', "particles.initial": f'"{folder}"',
        "contact.youngs_modulus": '"3 MPa"', "contact.poisson_ratio": 0.35, "contact.restitution": 0.5,
        "contact.friction.sliding": 0.5, "contact.friction.rolling": 0.2, "contact.friction.torsion": 0.1,
        "time.end": '"3 ms"', "time.step": '"1e-7 s"',
        "output.series_interval": '"0.2 ms"', "output.snapshot_interval": '"0.5 ms"',
    }
    return keys | {key.replace("__", "."): value for key, value in changes.items()}


def channel(**changes):
    keys = CHANNEL | {key.replace("__", "."): value for key, value in changes.items()}
    return text_of({key: value for key, value in keys.items() if value is not None})


def flow_of(**changes):
    """What decides the flow, and what no scene can do without."""
    keys = CHANNEL | {key.replace("__", "."): value for key, value in changes.items()}
    needed = (*SHAPE_AND_FLOW, "particles.", "contact.youngs", "contact.poisson", "time.end")
    return text_of({key: value for key, value in keys.items() if key.startswith(needed) and value is not None})


PORE = {"geometry__" + key: None for key in ("channel_length", "half_angle")} | {
    "geometry__stl": f'"{REPOSITORY / "scenes" / "pore.stl"}"', "geometry__stl_unit": '"1 um"',
    "flow__mesh_cells_per_neck": 14}
STEPPED = {"geometry__half_angle": '"45 deg"', "geometry__step_width": '"200 um"', "geometry__step_length": '"100 um"',
           "geometry__expansion_width": '"300 um"', "flow__mesh_cells_per_neck": 12}

FLOWS = {"straight": flow_of(), "pore": flow_of(**PORE), "stepped": flow_of(**STEPPED)}


MIXTURE = {"particles__diameter": None, "particles__size_distribution": '"lognormal"', "particles__size_spread": 0.05,
           "particles__species": '[{diameter = "47 um", share = 0.4}, '
                                 '{diameter = "20 um", share = 0.6, density = "1300 kg/m3"}]',
           "particles__density": '"1000 kg/m3"', "gravity": '["0 m/s2", "-9.81 m/s2", "0 m/s2"]', "lubrication__walls": "true"}


def ridge_box():
    """A closed box, 200 x 200 x 400, whose floor rises to a ridge at y = 100: flat walls, corners and a convex edge."""
    outline = [(0, 0), (100, 40), (200, 0), (200, 400), (0, 400)]  # (y, z), counter-clockwise seen along -x
    facets = []
    for (y0, z0), (y1, z1) in zip(outline, outline[1:] + outline[:1]):
        facets += [((0, y0, z0), (0, y1, z1), (200, y1, z1)), ((0, y0, z0), (200, y1, z1), (200, y0, z0))]
    for x in (0, 200):
        ends = [((x, *outline[1]), (x, *outline[k]), (x, *outline[(k + 1) % 5])) for k in (2, 3, 4)]
        facets += [facet if x else facet[::-1] for facet in ends]
    lines = ["solid ridge"]
    for facet in facets:
        lines += ["facet normal 0 0 0", "outer loop"]
        lines += ["vertex {} {} {}".format(*corner) for corner in facet] + ["endloop", "endfacet"]
    return "\n".join([*lines, "endsolid ridge"]) + "\n"


def write_inputs(folder):
    """The files that scenes of boxes read."""
    (folder / "ridge.stl").write_text(ridge_box())
    (folder / "spheres.csv").write_text(spheres(120, 1))
    (folder / "equal.csv").write_text("\n".join(
        ",".join(line.split(",")[:3]) for line in spheres(120, 2).splitlines()) + "\n")


FULL_FRICTION = {"contact__tangential_factor": 1, "contact__tangential_damping": 0.5,
                 "contact__wall_friction__sliding": 0.3, "contact__wall_friction__rolling": 0.05,
                 "contact__wall_youngs_modulus": '"6 MPa"', "contact__wall_poisson_ratio": 0.2}
WET = {"fluid__viscosity": '"1.8e-3 Pa s"', "fluid__density": '"1062 kg/m3"', "lubrication__enabled": "true",
       "lubrication__walls": "true", "lubrication__below_roughness": '"clamp"'}
STL_BOX = {"box__min": None, "box__max": None, "geometry__stl": '"ridge.stl"', "geometry__stl_unit": '"1 um"'}


def box_text(initial="spheres.csv", **changes):
    return text_of({key: value for key, value in box(initial, **changes).items() if value is not None})


SCENES = {
    "box": Scene("unequal spheres, all frictions, plain walls", box_text()),
    "box_materials": Scene("walls of another material and friction, other tangential law", box_text(**FULL_FRICTION)),
    "box_sliding": Scene("equal spheres, sliding alone, elastic", box_text(
        "equal.csv", contact__friction__rolling=0, contact__friction__torsion=0, contact__restitution=1)),
    "box_frictionless": Scene("equal spheres without friction", box_text("equal.csv", **{
        f"contact__friction__{kind}": 0 for kind in ("sliding", "rolling", "torsion")})),
    "box_doubling": Scene("the torsion spring that doubles", box_text(
        contact__torsion_update='"doubling"', time__end='"0.2 ms"')),
    "box_wet": Scene("films between particles and with walls, clamped", box_text(**WET)),
    "box_wet_implicit": Scene("films solved together", box_text(
        **WET | {"lubrication__below_roughness": '"off"'}, time__integrator='"implicit_fluid"')),
    "box_uniform_flow": Scene("uniform flow, drag, viscous torque, noise", box_text(
        **WET, flow__source='"uniform"', flow__velocity='["1 mm/s", "0 m/s", "2 mm/s"]', drag__viscous_torque="true",
        drag__fluctuation__strength=0.5, drag__fluctuation__time='"1 ms"', time__integrator='"implicit_drag"')),
    "box_wall_restitution": Scene("walls that give back less than particles do", box_text(
        **FULL_FRICTION, contact__wall_restitution=0.3), later=True),
    "silo": Scene("grains that fall, clog and are poked, without a flow", channel(
        gravity='["9.81 m/s2", "0 m/s2", "0 m/s2"]', flow__source='"none"', flow__mean_velocity=None,
        flow__mesh_cells_per_neck=None, flow__grid_spacing=None, fluid__viscosity=None, fluid__density=None,
        particles__density='"2500 kg/m3"', lubrication__enabled="false", drag__enabled="false", time__mass_scale=1,
        unclog__protocol='"poke"', unclog__duration=None, time__end='"10 ms"'), later=True),
    "stl_box": Scene("walls from an STL file", box_text(**STL_BOX)),
    "channel": Scene("filled, released, all terms, explicit", channel(), "straight"),
    "channel_empty": Scene("empty start, a given rate of insertion, no release", channel(
        inlet__start='"empty"', inlet__rate='"20000 1/s"', unclog__protocol='"none"', unclog__after=None,
        unclog__duration=None, time__end='"100 ms"'), "straight"),
    "channel_implicit": Scene("implicit drag, trilinear lookup, no torsion", channel(
        time__integrator='"implicit_drag"', flow__lookup='"trilinear"', contact__friction__torsion=0,
        time__step_fraction=0.05, porosity__update_interval='"0 s"'), "straight"),
    "channel_films": Scene("drag and films implicit, superficial drag, one strip", channel(
        time__integrator='"implicit_fluid"', drag__velocity='"superficial"', porosity__strips=1, time__end='"4 ms"'),
        "straight"),
    "channel_noise": Scene("random factors on drag and flow, porosity off", channel(
        drag__fluctuation__strength=1.4, drag__fluctuation__time='"2 ms"', flow__pulsation__strength=0.5,
        flow__pulsation__time='"2 ms"', porosity__strips=0, drag__viscous_torque="true"), "straight"),
    "channel_local": Scene("porosity around each particle, a law that knows the slip", channel(
        porosity__method='"local"', porosity__width='"60 um"', drag__law='"beetstra"', time__end='"8 ms"'), "straight",
        later=True),
    "channel_mixture": Scene("the mixture's rate, the neck a strip of its own", channel(
        drag__velocity='"mixture"', porosity__neck="true", time__end='"8 ms"'), "straight", later=True),
    "channel_oscillation": Scene("a flow that oscillates, an inflow of a given concentration", channel(
        flow__oscillation__amplitude=0.8, flow__oscillation__frequency='"200 Hz"', flow__oscillation__phase=0.25,
        inlet__start='"empty"', inlet__concentration=0.1, unclog__protocol='"none"', unclog__after=None,
        unclog__duration=None, time__end='"40 ms"'), "straight", later=True),
    "channel_pressure": Scene("a pressure drives the flow, pulsating", channel(
        flow__drive='"pressure"', flow__pressure_drop='"200 Pa"', drag__velocity='"mixture"',
        time__integrator='"implicit_drag"', drag__viscous_torque="true", flow__pulsation__strength=0.2,
        flow__pulsation__time='"2 ms"', time__end='"8 ms"'), "straight", later=True),
    "channel_compliance": Scene("a pump behind a soft tube, explicit drag", channel(
        flow__compliance='"1e-14 m3/Pa"', drag__velocity='"mixture"', time__end='"8 ms"'), "straight", later=True),
    "channel_small": Scene("small spheres, many neighbours, dry", channel(
        particles__diameter='"22 um"', lubrication__enabled="false", time__end='"5 ms"'), "straight"),
    "channel_sizes": Scene("a mixture that spreads, two densities that sink and rise, films at walls", channel(
        **MIXTURE, time__end='"8 ms"'), "straight", later=True),
    "channel_species": Scene("two species of one size, each with a friction of its own", channel(
        particles__diameter=None,
        particles__species='[{diameter = "47 um", share = 0.5, friction = {sliding = 0.2, rolling = 0}}, '
                           '{diameter = "47 um", share = 0.5, wall_friction = {torsion = 0}}]',
        time__end='"8 ms"'), "straight", later=True),
    "channel_sticky": Scene("spheres that stick and film, a flowing start, restarts", channel(
        contact__law='"jkr"', contact__surface_energy='"0.5 mJ/m2"', inlet__start='"flowing"', inlet__strain=1,
        unclog__protocol='"restart"', unclog__duration=None, unclog__strain=1, time__end='"15 ms"'), "straight",
        later=True),
    "box_sticky": Scene("unequal hard spheres that stick, in a box", box_text(
        contact__law='"dmt"', contact__surface_energy='"0.2 mJ/m2"'), later=True),
    "stepped": Scene("other corners: two narrowings, an expansion", channel(**STEPPED), "stepped"),
    "pore": Scene("a channel from an STL file", channel(**PORE), "pore"),
    "pore_local": Scene("porosity around each particle between walls from a file, no strips", channel(
        **PORE, porosity__method='"local"', porosity__strips=0, time__end='"5 ms"'), "pore", later=True),
    "seeds_one_rank": Scene("four seeds on one rank", channel(time__end='"8 ms"'), "straight",
                            ["--seeds", "1-4"]),
    "seeds_two_ranks": Scene("four seeds on two ranks", channel(time__end='"8 ms"'), "straight",
                             ["--seeds", "1-4"], ranks=2, same_as="seeds_one_rank"),
    "resumed_local": Scene("a local porosity, stopped again and again", channel(
        porosity__method='"local"', porosity__width='"60 um"', drag__law='"beetstra"', time__end='"8 ms"'), "straight",
        interrupted="0.2 s", same_as="channel_local", later=True),
    "resumed_sizes": Scene("the mixture, stopped again and again", channel(**MIXTURE, time__end='"8 ms"'), "straight",
                           interrupted="0.2 s", same_as="channel_sizes", later=True),
    "resumed": Scene("stopped again and again, and resumed", channel(), "straight", interrupted="0.3 s",
                     same_as="channel"),
    "sweep": Scene("a folder for every value", channel(time__end='"5 ms"'), "straight",
                   ["--sweep", "particles.diameter=40 um,47 um"]),
}
