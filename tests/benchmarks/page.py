"""The tables of framework/docs/how_fast.md, from what tests/benchmarks/run measured, written between the page's markers."""
import re

from growth_plot import growth_plot
from runs import ROOT, UNEVEN

PAGE = ROOT / "framework/docs/how_fast.md"
PICTURE = ROOT / "framework/docs/how_fast/growth.svg"

SHAPES = ["linear", "gimp", "quadratic", "cubic"]
GOALS = {"double": {"linear": 35, "gimp": 80, "quadratic": 60, "cubic": 110},
         "single": {"linear": 20, "gimp": 42, "quadratic": 35, "cubic": 65}}
TWO_CORES_GOAL, MEMORY_GOAL = 1.9, 1.15

# Other codes, ns per particle and step of one core: smallest and largest time; on the machine that the page names.
PEERS = {
    "NairnMPM": ("double", {"linear": (1890, 2180), "gimp": (2760, 4490), "quadratic": (3250, 5170)}, "1.7–1.96", "700"),
    "Karamelo": ("double", {"linear": (1450, 1450), "quadratic": (5550, 5550), "cubic": (10150, 10150)}, "0.9 (MPI)", "2500–7000"),
    "ExaGOOP (AMReX)": ("double", {"linear": (3570, 4200), "cubic": (35500, 35500)}, "–", "–"),
    "Matter": ("double", {"quadratic": (1430, 2790)}, "1.6", "–"),
    "ExaMPM (Kokkos; a fluid)": ("double", {"quadratic": (1350, 1470)}, "1.6", "–"),
    "taichi_mpm (SIMD by hand)": ("single", {"quadratic": (249, 300)}, "2", "–"),
}
BANDWIDTH = 21  # GB/s of one core of that machine

# Numbers of a particle in 3D that a pass reads or writes, by field; the first pass is project, the second update.
COMPONENTS = {"position": 3, "velocity": 3, "mass": 1, "volume": 1, "stress": 6, "displacement_gradient": 9}
PROJECT_READS = ["position", "velocity", "mass", "volume", "stress"]
UPDATE_READS = list(COMPONENTS)
UPDATE_WRITES = ["position", "velocity", "volume", "stress", "displacement_gradient"]
# A node is set to zero, added to, turned into velocities, and read: six times its numbers, and 1/8 node a particle.
NODE_NUMBERS, NODE_PASSES, NODES_PER_PARTICLE = 10, 6, 1 / 8


def rows(header, *lines):
    return "\n".join("| " + " | ".join(map(str, cells)) + " |" for cells in (header, ["---"] * len(header), *lines))


def nanoseconds(figure):
    time = figure["nanoseconds"]
    return f"{time:.1f}" if time < 100 else f"{time:.0f}"


def span(figure):
    low, high = figure["range"]
    return f"{low:.0f}–{high:.0f}" if round(high) > round(low) else f"{low:.0f}"


def goal_table(figures):
    def row(shape, precision):
        here, goal = figures[f"{shape} {precision} 1"], GOALS[precision][shape]
        loops = [figures[f"reference {shape} {precision} {order}"] for order in ("random", "sorted")]
        faster = [f"{nanoseconds(loop)} ({loop['nanoseconds'] / here['nanoseconds']:.1f} x)" for loop in loops]
        return [f"{shape}, {precision}", goal, nanoseconds(here), span(here), f"{here['nanoseconds'] / goal:.2f}", *faster]

    return rows(["ns per particle and step", "goal", "measured", "all rounds", "measured / goal", "textbook loop, random order", "sorted"],
                *(row(shape, precision) for precision in GOALS for shape in SHAPES))


def threads_table(figures):
    def row(name, key, goal):
        one, two = (figures[f"{key} {n}"] for n in (1, 2))
        faster = one["nanoseconds"] / two["nanoseconds"]
        # Not slower: the ranges of both overlap.
        reached = faster >= goal if goal > 1 else two["range"][0] <= one["range"][1]
        return [name, nanoseconds(one), nanoseconds(two), f"{faster:.2f}", goal, "yes" if reached else "no"]

    return rows(["", "one thread, ns", "two threads, ns", "times faster", "goal", "reached"],
                *(row(f"{shape}, {precision}", f"{shape} {precision}", TWO_CORES_GOAL) for precision in GOALS for shape in SHAPES),
                *(row(f"`{name}.json`", name, goal) for name, goal in UNEVEN.items()))


def times_longer(ratio):
    return f"{ratio:.0f}" if ratio >= 10 else f"{ratio:.1f}"


def peers_table(figures):
    def cell(shape, precision, times):
        if shape not in times:
            return "–"
        low, high = times[shape]
        here = figures[f"{shape} {precision} 1"]["nanoseconds"]
        if low == high:
            return f"{low} ({times_longer(low / here)} x)"
        return f"{low}–{high} ({times_longer(low / here)}–{times_longer(high / here)} x)"

    own = [["Matpoint, " + precision, *(nanoseconds(figures[f"{shape} {precision} 1"]) for shape in SHAPES),
            f"{figures[f'quadratic {precision} 1']['nanoseconds'] / figures[f'quadratic {precision} 2']['nanoseconds']:.2f}",
            figures[f"quadratic {precision} 1"]["bytes_per_particle"]] for precision in GOALS]
    return rows(["", *SHAPES, "two cores, times faster", "bytes a particle"], *own,
                *([f"{name}, {precision}", *(cell(shape, precision, times) for shape in SHAPES), two, size]
                  for name, (precision, times, two, size) in PEERS.items()))


def phases_table(figures):
    named = {f"{shape}, {precision}": figures[f"{shape} {precision} 1"] for precision in GOALS for shape in SHAPES}
    named |= {name: figures[name] for name in ("square_quadratic", "bar_quadratic", "large_quadratic")}
    phases = list(dict.fromkeys(phase for figure in named.values() for phase in figure.get("phases", {})))
    return rows(["ns per particle and step", *phases, "all"],
                *([name, *(f"{1e9 * figure['phases'][phase] / figure['particle_steps']:.1f}" if phase in figure.get("phases", {}) else "–"
                           for phase in phases), f"{figure['nanoseconds_per_particle_step']:.1f}"] for name, figure in named.items()))


def scenes_table(figures):
    scenes = ["block_gimp_contiguous", "block_linear_elastic", "block_j2_plasticity", "square_quadratic", "bar_quadratic",
              "large_quadratic", "large_linear_elastic"]
    return rows(["scene", "particles", "bytes a particle", "ns per particle and step"],
                *([f"`{name}.json`", figures[name]["particles"], figures[name]["bytes_per_particle"], nanoseconds(figures[name])]
                  for name in scenes))


def bytes_moved(figure):
    """Bytes of main memory per particle and step of a neo-Hookean usl step in double precision, were nothing kept in cache."""
    fields = [name for name in figure["particle_fields"] if name in COMPONENTS]
    particle = sum(COMPONENTS[name] * sum(name in group for group in (PROJECT_READS, UPDATE_READS, UPDATE_WRITES)) for name in fields)
    return 8 * (particle + NODE_NUMBERS * NODE_PASSES * NODES_PER_PARTICLE)


def growth(figures):
    return sorted((f["particles"], f["nanoseconds"], bytes_moved(f)) for name, f in figures.items() if name.startswith("growth "))


def growth_table(figures):
    return rows(["particles", "ns per particle and step", "bytes moved, estimated", "GB/s"],
                *([count, f"{time:.1f}", f"{moved:.0f}", f"{moved / time:.1f}"] for count, time, moved in growth(figures)))


def domain_table(figures):
    block, wide = figures["option nothing more"], figures["wide domain"]
    return rows(["domain", "ns per particle and step", "largest memory, MB"],
                *([name, nanoseconds(f), f"{f['peak_memory_bytes'] / 1e6:.0f}"]
                  for name, f in (("1.5 m each way", block), ("15 m each way", wide))))


def options_table(figures):
    base = figures["option nothing more"]
    return rows(["`block_quadratic.json` with", "bytes a particle", "", "ns per particle and step", ""],
                *([name.removeprefix("option "), f["bytes_per_particle"], f"{f['bytes_per_particle'] - base['bytes_per_particle']:+d}",
                   nanoseconds(f), f"{100 * (f['nanoseconds'] / base['nanoseconds'] - 1):+.0f} %"]
                  for name, f in figures.items() if name.startswith("option ")))


OWN_PLUGINS = {
    "built-in": "`bspline` and `neo_hookean`, built-in",
    "spline": "[`user_spline`](../../tests/benchmarks/user_plugins/user_spline.cpp), a shape function of a few lines",
    "plain": "[`plain_rubber`](../../tests/benchmarks/user_plugins/plain_rubber.cpp), a material that is a plain function of one particle",
    "by hand": "[`lanes_rubber`](../../tests/benchmarks/user_plugins/lanes_rubber.cpp), a material tuned by hand, for 3D alone",
    "scalar": "[`scalar_rubber`](../../tests/benchmarks/user_plugins/scalar_rubber.cpp), a material that loops over particles, without Packs",
    "idle": "[`idle_rubber`](../../tests/benchmarks/user_plugins/idle_rubber.cpp), a material without stress: what a step takes beside it",
}


def own_plugins_table(figures):
    built_in = figures["own built-in"]["nanoseconds"]
    return rows(["`block_quadratic.json` with", "ns per particle and step", "all rounds", "times the built-in's"],
                *([text, nanoseconds(figures[f"own {name}"]), span(figures[f"own {name}"]),
                   f"{figures[f'own {name}']['nanoseconds'] / built_in:.2f}"] for name, text in OWN_PLUGINS.items()))


def memory_table(figures):
    def row(name):
        f = figures[name]
        required = f["particles"] * f["bytes_per_particle"]
        scene, _, box = name.partition(" ")
        return [f"`{scene}.json`" + (", a `box` filled evenly" if box else ", a `lattice`"),
                f["bytes_per_particle"], f"{f['peak_memory_bytes'] / f['particles']:.0f}", f"{f['peak_memory_bytes'] / required:.2f}",
                "yes" if f["peak_memory_bytes"] <= MEMORY_GOAL * required else "no"]

    return rows(["scene", "bytes of a particle's fields", "largest memory of the program, bytes a particle", "ratio", f"goal: {MEMORY_GOAL}"],
                *(row(scene + box) for scene in ("large_quadratic", "large_linear_elastic") for box in ("", " box")))


def machine_line(machine):
    return (f"Measured on {machine['cores']} cores of \"{machine['processor']}\", loops for {machine['instruction_set']}.")


def tables(results):
    figures = results["figures"]
    return {"machine": machine_line(results["machine"]), "goal table": goal_table(figures), "threads": threads_table(figures),
            "own plugins": own_plugins_table(figures), "peers": peers_table(figures), "phases": phases_table(figures),
            "scenes": scenes_table(figures), "options": options_table(figures), "memory": memory_table(figures),
            "growth": growth_table(figures), "domain": domain_table(figures)}


def filled(contents):
    """The page with each table between its markers."""
    text = PAGE.read_text()
    for name, content in contents.items():
        begin, end = f"<!-- begin {name} -->", f"<!-- end {name} -->"
        if begin not in text or end not in text:
            raise SystemExit(f"{PAGE}: there is no {begin} … {end}")
        text = re.sub(re.escape(begin) + ".*?" + re.escape(end), lambda _: f"{begin}\n{content}\n{end}", text, flags=re.S)
    return text


def picture(results):
    return growth_plot([(count, time, moved / BANDWIDTH) for count, time, moved in growth(results["figures"])], BANDWIDTH)
