# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes against surfaces where distances are hard to measure: far from the surface, where all of it is nearly as far, and thin or far from
the origin, where the distance is rounding."""
import math

from measure import measure

RATIOS = (2, 100, 10000)
PLATES = ((1, 0), (1e-2, 1e3), (1e-2, 1e6))    # thickness, and how far from the origin


def write_off(path, points, triangles):
    with open(path, "w") as file:
        file.write(f"OFF\n{len(points)} {len(triangles)} 0\n")
        file.writelines("%r %r %r\n" % tuple(p) for p in points)
        file.writelines("3 %d %d %d\n" % tuple(t) for t in triangles)


def icosphere(levels, radius):
    """20 4^levels triangles with their vertices on a sphere about the origin."""
    def unit(v):
        length = math.sqrt(sum(x * x for x in v))
        return tuple(x / length for x in v)
    g = (1 + 5**0.5) / 2
    points = [unit(v) for v in ((-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g), (0, -1, -g), (0, 1, -g),
                                (g, 0, -1), (g, 0, 1), (-g, 0, -1), (-g, 0, 1))]
    triangles = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6), (7, 1, 8),
                 (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)]
    for _ in range(levels):
        middles, finer = {}, []

        def middle(a, b):
            key = (min(a, b), max(a, b))
            if key not in middles:
                middles[key] = len(points)
                points.append(unit([x + y for x, y in zip(points[a], points[b])]))
            return middles[key]
        for a, b, c in triangles:
            ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
            finer += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
        triangles = finer
    return [[radius * x for x in p] for p in points], triangles


def plate(thickness, away):
    """A box 1 x 0.8 x thickness, turned by 0.7 about z and x, and moved."""
    c, s = math.cos(0.7), math.sin(0.7)
    points = []
    for i in range(8):
        x, y, z = i & 1, 0.8 * (i >> 1 & 1), thickness * (i >> 2 & 1)
        x, y = c * x - s * y, s * x + c * y
        y, z = c * y - s * z, s * y + c * z
        points.append((x + away, y - 0.7 * away, z + 0.3 * away))
    quads = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))
    return points, [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]


def distances(bench):
    verify, threads = bench.ours("tetproof-verify"), len(bench.cores)
    commands = []
    write_off(bench.path("inner.off"), *icosphere(5, 1))
    bench.command("TetGen inner", "tetgen", "-pYQ", "inner.off").run(bench.cores)
    for ratio in RATIOS:
        write_off(bench.path(f"outer{ratio}.off"), *icosphere(6, ratio))
        commands.append(bench.command(f"a ball of radius 1 against a sphere of radius {ratio}", verify, "inner.1.node", f"outer{ratio}.off",
                                      "--threads", threads, accept=(1,)))
    for number, (thickness, away) in enumerate(PLATES):
        write_off(bench.path(f"plate{number}.off"), *plate(thickness, away))
        bench.command(f"TetGen plate{number}", "tetgen", "-pqQa0.0005" if thickness == 1 else f"-pqQa{2e-3 * thickness:g}",
                      f"plate{number}.off").run(bench.cores)
        commands.append(bench.command(f"a plate of thickness {thickness:g}, {away:g} from the origin", verify, f"plate{number}.1.node",
                                      f"plate{number}.off", "--threads", threads, accept=(0, 1)))
    measure(commands, bench.runs, bench.cores)
    print("### Distances that are hard to measure\n\nThe ball has 20,480 boundary faces, the spheres have 81,920 triangles.\n\n"
          "| | wall s | CPU s |\n|---|---|---|")
    for command in commands:
        bench.record.setdefault("distances", {})[command.name] = command.record()
        print(f"| {command.name} | {command.wall:.2f} ± {100 * command.spread():.0f} % | {command.cpu:.2f} |")
    print(flush=True)
