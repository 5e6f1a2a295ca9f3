"""Makes docs/benchmarks.md and its plots; scripts/benchmarks says how to run it."""

import argparse
import json

import error_curves
import markdown
import micro
import paper_table
import render
import ring
import scaling
import segments
import shells
import skipping
from store import ROOT, Store

HEAD = """# Benchmarks

`meniscus bench SCENE...` measures run time against error for any scene: our settings, the interior modes, and POV-Ray where it is installed.

    meniscus bench glass.scene --quick --report bench.html     # minutes; without --quick hours
    meniscus bench glass.scene --csv - --no-povray             # all points as CSV

It makes a reference of each model with an error of its own, renders every setting in turn, round by round, and prints the points, the fronts
(what no other setting beats in time and error) and how many times faster one curve is than another at equal error and at the same task.
`--report`, `--svg`, `--csv` and `--json` write the same as a page, a plot and data; Ctrl-C keeps what was measured. `meniscus bench --help`
tells the rest.

Everything below is made by one command, which goes on where it was stopped:

"""


def head(store, quick, command):
    first = json.loads(store.run([render.MENISCUS, "bench", "benchmarks/scenes/opaque.scene", "-W", "8", "-H", "6", "--quick", "--no-povray",
                                  "--spp", "2", "--aa", "0.1", "--json", "-"]))
    note = ("These are the figures of the quick mode: one run of most settings. They show the shape of things, not the last digit.\n\n" if quick else "")
    return HEAD + markdown.code(command) + f"\nMachine: {first['benchmarks'][0]['machine']}.\n\n" + note


def main():
    parser = argparse.ArgumentParser(prog="scripts/benchmarks", description="Makes docs/benchmarks.md and its plots anew.")
    parser.add_argument("--quick", action="store_true", help="few settings and points: half an hour instead of many")
    parser.add_argument("--again", action="store_true", help="forget what an earlier run has measured")
    options = parser.parse_args()

    programs = ROOT / "build/benchmarks"
    measured = [programs / "meniscus", *sorted((programs / "benchmarks").glob("m*[a-z]"))]
    store = Store(ROOT / "build/benchmark-results" / ("quick" if options.quick else "full"),
                  [program for program in measured if program.is_file()], options.again)
    meshes = ROOT / "build/benchmark-results/meshes"
    meshes.mkdir(exist_ok=True)
    if not (meshes / "ring_70000.ply").exists():
        ring.write(meshes / "ring_70000.ply", 70_000)
    meshes = meshes.relative_to(ROOT)
    pictures = ROOT / "docs/pictures"

    page = head(store, options.quick, "scripts/benchmarks --quick" if options.quick else "scripts/benchmarks")
    page += error_curves.section(store, pictures, options.quick, meshes)
    page += segments.section(store, options.quick)
    page += paper_table.section(store, options.quick)
    page += scaling.section(store, pictures, options.quick, meshes)
    page += shells.section(store, options.quick, meshes)
    page += skipping.section(store, ROOT)
    page += micro.section(store, ROOT, options.quick)
    (ROOT / "docs/benchmarks.md").write_text(page.rstrip() + "\n")


if __name__ == "__main__":
    main()
