"""Nested meshes: what false crossings cost when one search collects them, and when each is a new ray."""

import markdown
import render
import ring
from store import ROOT

SCENE = "benchmarks/scenes/shells.scene"
TRIANGLES = 70_000


def write_meshes(folder, shells):
    for i in range(shells):
        mesh = ROOT / folder / f"ring_{TRIANGLES}_{i}.ply"
        if not mesh.exists():
            ring.write(mesh, TRIANGLES, 1.0 - 0.15 * i)


def section(store, quick, folder):
    counts = [1, 2, 3, 5]
    write_meshes(folder, max(counts))
    options = ["-W", "160" if quick else "320", "-H", "120" if quick else "240", "--spp", "1"]
    runs = 3 if quick else 9
    shown = render.shown(SCENE, "--declare", "Shells=N", "--declare", "Shift=S", *options, "--interior", "MODE", "--kernel", "general", "--threads", 1)
    out = ("## Nested meshes\n\n"
           f"Rings of {TRIANGLES} triangles, the outermost the strongest; of one ring nothing is false. {shown}, medians of {runs}, in turns; the last\n"
           "columns by the kernel that the scene allows.\n\n")
    for shift, what in ((0, "Within each other: nothing is ever seen of the others, so that `sweep` leaves them out."),
                        (0.08, "Each sticks out of the one before by a little: all must be followed.")):
        rows = []
        for count in counts:
            common = ["--declare", f"Shells={count}", "--declare", f"Shift={shift}", "--declare", f"Triangles={TRIANGLES}", "-L", folder, *options]
            recast, sweep, lanes = render.interleaved(
                store, [[SCENE, *common, "--interior", mode, "--kernel", kernel]
                        for mode, kernel in (("recast", "general"), ("sweep", "general"), ("sweep", "automatic"))], runs)
            rows.append([count, sweep["segments"], *(markdown.number(one["crossings"]["false"] / one["segments"]) for one in (recast, sweep)),
                         markdown.number(recast["ns"]), markdown.number(sweep["ns"]), markdown.times(recast["ns"] / sweep["ns"]),
                         f"{markdown.number(lanes['ns'])} ({lanes['kernel']})", markdown.times(recast["ns"] / lanes["ns"])])
        out += (f"{what}\n\n"
                + markdown.table(["shells", "segments", "false crossings a segment, `recast`", "`sweep`", "`recast`, ns a segment", "`sweep`, ns a segment",
                                  "times faster", "`sweep`, automatic", "times faster"], rows) + "\n")
    return out
