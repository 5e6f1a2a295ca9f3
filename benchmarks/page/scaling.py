"""How time and memory grow with the scene, the picture and the threads."""

import json
import subprocess

import growth
import markdown
import render
import ring
from store import ROOT


class Series:
    """One thing that grows: its points, drawn and tabled."""

    def __init__(self, name, title, x_label):
        self.name, self.title, self.x_label = name, title, x_label
        self.rows, self.seconds, self.nanoseconds, self.build = [], [], [], []
        self.compared = []  # pairs of x whose ratios are told

    def add(self, x, result):
        cpu = result["cpu_seconds"]
        build = cpu["parse"] + cpu["build"]
        self.rows.append([x, markdown.number(cpu["render"]), result["segments"], markdown.number(result["ns"]),
                          markdown.number(build), markdown.number(result["peak_bytes"] / 1e6)])
        self.seconds.append((x, cpu["render"]))
        self.nanoseconds.append((x, result["ns"]))
        self.build.append((x, build))

    def section(self, store, pictures, command):
        plot = {"title": self.title, "x": self.x_label, "y": "CPU seconds", "series": [
            {"name": "render", "points": self.seconds}, {"name": "read and build", "points": self.build}]}
        source = store.folder / f"{self.name}.json"
        source.write_text(json.dumps(plot))
        subprocess.run(["build/benchmarks/benchmarks/draw_plot", source, pictures / f"bench_{self.name}.svg"], cwd=ROOT, check=True)
        fits = [f"{what} as the power {growth.exponent(points):.2f}" for what, points in
                (("render seconds", self.seconds), ("ns a segment", self.nanoseconds)) if growth.exponent(points) is not None]
        ns, seconds = dict(self.nanoseconds), dict(self.seconds)
        ratios = [f"{many} {self.x_label} take {markdown.times(ns[many] / ns[few])} the time a segment of {few} and "
                  f"{markdown.times(seconds[many] / seconds[few])} the time of their picture" for few, many in self.compared]
        told = "".join(f" {ratio}." for ratio in ratios)
        return (f"### {self.title}\n\n![{self.title}](pictures/bench_{self.name}.svg)\n\n{command}. Fitted: {', '.join(fits)}.{told}\n\n"
                + markdown.table([self.x_label, "render seconds", "segments", "ns a segment", "read and build seconds", "peak MB"], self.rows) + "\n")


def bubbles(store, pictures, quick):
    counts = [10, 60, 100, 1000, 10_000, 100_000, 1_000_000]
    options = ["-W", "64", "-H", "48", "--spp", "2"] if quick else ["-W", "160", "-H", "120", "--spp", "4"]
    series = Series("bubbles", "Bubbles in a block of water", "bubbles")
    series.compared = [(60, 100), (1000, 100_000)]
    for count in counts:
        series.add(count, render.run(store, "benchmarks/scenes/bubbles.scene", "--declare", f"Count={count}", *options,
                                     runs=3))
    return series.section(store, pictures, render.shown("benchmarks/scenes/bubbles.scene", "--declare", "Count=N", *options, "--threads", 1))


def nests(store, pictures, quick):
    depths = [1, 3, 10, 30, 100] + ([300] if quick else [300, 1000])
    options = ["-W", "32" if quick else "64", "-H", "24" if quick else "48", "--spp", "2", "--depth", "4000", "--tree", "sampled"]
    series = Series("nest", "Balls within balls", "depth")
    for depth in depths:
        series.add(depth, render.run(store, "benchmarks/scenes/nest.scene", "--declare", f"Depth={depth}", *options,
                                     runs=3))
    return series.section(store, pictures, render.shown("benchmarks/scenes/nest.scene", "--declare", "Depth=N", *options, "--threads", 1))


def triangles(store, pictures, quick, folder):
    counts = [1000, 10_000, 100_000, 1_000_000] + ([] if quick else [4_000_000])
    options = ["-W", "80" if quick else "160", "-H", "60" if quick else "120", "--spp", "2" if quick else "4"]
    series = Series("triangles", "Triangles of a glass ring", "triangles")
    for count in counts:
        mesh = ROOT / folder / f"ring_{count}.ply"
        if not mesh.exists():
            ring.write(mesh, count)
        series.add(count, render.run(store, "benchmarks/scenes/ring.scene", "--declare", f"Triangles={count}", "-L", folder, *options,
                                     runs=3))
    return series.section(store, pictures, render.shown("benchmarks/scenes/ring.scene", "--declare", "Triangles=N", *options, "--threads", 1))


def resolutions(store, pictures, quick):
    widths = [40, 80, 160, 320, 640] + ([] if quick else [1280])
    series = Series("resolution", "Pixels of the tumbler", "pixels")
    scene = "tests/povray/bench/tumbler.scene"
    for width in widths:
        height = width * 3 // 4
        series.add(width * height, render.run(store, scene, "-W", width, "-H", height, "--spp", "1", runs=3))
    return series.section(store, pictures, render.shown(scene, "-W", "N", "-H", "3/4 N", "--spp", 1, "--threads", 1))


def threads(store):
    # Large enough that reading the scene and starting threads do not count.
    scene, options = "tests/povray/bench/tumbler.scene", ["-W", "1280", "-H", "960", "--spp", "16"]
    rows, first = [], None
    counts = (1, 2)
    results = render.interleaved(store, [[scene, *options, "--threads", count] for count in counts], 3)
    for count, result in zip(counts, results):
        wall, cpu = result["seconds"]["render"], result["cpu_seconds"]["render"]
        first = first or wall
        rows.append([count, markdown.number(wall), markdown.number(cpu), markdown.times(first / wall)])
    return ("### Threads\n\n" + render.shown(scene, *options, "--threads", "N") + ", medians of 3, in turns. The picture is the same to the last bit.\n\n"
            + markdown.table(["threads", "seconds by the clock", "CPU seconds", "times faster"], rows) + "\n")


def section(store, pictures, quick, folder):
    return ("## Growth\n\nOne thread. Exponents are least squares over all points in logarithms; the picture changes with the scene, so time a segment\n"
            "tells more than time.\n\n" + bubbles(store, pictures, quick) + nests(store, pictures, quick)
            + triangles(store, pictures, quick, folder) + resolutions(store, pictures, quick) + threads(store))
