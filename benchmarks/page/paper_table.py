"""The paper's own table: what the list costs where there is nothing to nest, what it gains, and its share."""

import markdown
import render

OPAQUE = "benchmarks/scenes/opaque.scene"
FIGURE_3 = "examples/glass_of_water.scene"


def list_share(functions, total):
    return sum(count for name, count in functions.items() if "InteriorList::" in name.split("(")[0]) / total


def section(store, quick):
    runs = 3 if quick else 9
    small = ["-W", "48", "-H", "36", "--spp", "1"]
    large = ["-W", "96", "-H", "72", "--spp", "2"] if quick else ["-W", "320", "-H", "240", "--spp", "16"]
    rows, figure = [], []
    base = {}
    for scene, collect in ((OPAQUE, rows), (FIGURE_3, figure)):
        for mode, kernel in (("off", "general"), ("sweep", "general"), ("recast", "general"), ("sweep", "automatic")):
            how = ["--interior", mode, "--kernel", kernel]
            total, functions = render.instructions(store, scene, *small, *how)
            timed = render.run(store, scene, *large, *how, runs=runs)
            counted = render.run(store, scene, *small, *how)
            seconds = timed["cpu_seconds"]["render"]
            if mode == "off":
                base = {"instructions": total, "seconds": seconds}
            collect.append([
                f"`{mode}`, {kernel}" + (f" ({counted['kernel']})" if kernel == "automatic" else ""), total, markdown.percent(total / base["instructions"] - 1), markdown.number(seconds),
                markdown.percent(seconds / base["seconds"] - 1), counted["segments"], markdown.number(total / counted["segments"]),
                f"{100 * list_share(functions, total):.2f} %"])
    head = ["", "instructions", "against `off`", "CPU seconds", "against `off`", "segments", "instructions a segment",
            "of them in InteriorList"]
    commands = (f"Instructions: {render.shown('SCENE', *small, '--interior', 'MODE', '--kernel', 'general', '--threads', 1)} under\n"
                f"`benchmarks/count-instructions`. Seconds: with `{' '.join(large)}`, medians of {runs}.\n")
    return ("## The paper's table\n\n"
            "Schmidt and Budge (2002) state for their tracer: 0.8 % overhead where the scene has no dielectric, a gain of more than 5 % with nested\n"
            "ones against an unmodified tracer, and less than 0.4 % of the run time in keeping lists. `recast` is their method, `off` an ordinary\n"
            "tracer; all three by the general kernel, and `sweep` also by the one that the scene allows (of lanes, AVX2 for counts of instructions). The last column\n"
            "counts the list's own functions as far as the compiler did not inline them; lanes have none.\n\n"
            + commands + f"\nNo dielectric (`{OPAQUE}`):\n\n" + markdown.table(head, rows)
            + f"\nNested dielectrics (`{FIGURE_3}`, their Figure 3); `off` renders another picture here:\n\n" + markdown.table(head, figure) + "\n")
