"""Run time against error, beside POV-Ray."""

import json

import markdown
import render
from store import ROOT

SCENES = "tests/povray/bench"


def subjects(quick):
    size = ["-W", "320", "-H", "240", *(["--quick"] if quick else [])]
    # Both renderers have the gap fastest from sources written by hand; at their scale POV-Ray loses films thinner than 1e-3.
    gap = ["--gap", "1e-3", "--declare", "Gap=1e-3", "--declare", "GAP=1e-3"]
    # The least of the first errors is twice POV-Ray's lowest here; the others are nearer to its floor.
    yield "(i)", "spheres", "three nested spheres: glass, water, ice", [
        f"{SCENES}/spheres.scene", *size, *gap, "--errors", "0.035,0.024,0.02,0.013", "--povray", f"gap={SCENES}/spheres.pov"]
    yield "(ii)", "tumbler", "a tumbler of water with an ice cube and 60 bubbles", [
        f"{SCENES}/tumbler.scene", *size, *gap, "--errors", "0.044,0.036,0.027,0.019",
        "--gap-scene", f"{SCENES}/tumbler_gap.scene", "--povray", f"gap={SCENES}/tumbler.pov"]


def ratio_rows(ratios):
    return [[ratio["at"], ratio["curve"], markdown.number(ratio["cpu_seconds"]), ratio["peer"],
             markdown.number(ratio["peer_cpu_seconds"]), markdown.times(ratio["ratio"])] for ratio in ratios]


def mesh_words(quick, folder):
    size = ["-W", "160", "-H", "120", "--reference-spp", "16"] if quick else ["-W", "320", "-H", "240"]
    return ["benchmarks/scenes/ring.scene", *size, "-L", str(folder), "--models", "contact", "--modes", "sweep", "--quick",
            "--runs", "1" if quick else "3", "--spp", "2,4"]


def section(store, pictures, quick, folder):
    out = "## Run time against error\n\n"
    out += ("Seconds are CPU seconds of the render stage, one thread of both renderers, medians of interleaved runs; what takes us less than 0.2 s\n"
            "is repeated at once, up to five times. Errors are RMSE in linear\n"
            "light, clipped to [0, 1] as POV-Ray's pictures are, against our own picture of the same model from many more samples; its own error,\n"
            "half the difference of two halves with unlike samples, stands beside it. *Gap* is the picture of air films 1e-3 thick between the\n"
            "media, which is what POV-Ray is given; *contact* that of the media themselves. Ratios at equal error are read off the Pareto fronts and\n"
            "never extrapolated; below twice the peer's lowest error its curve bends up, and a ratio says less.\n\n")
    for mark, name, what, words in subjects(quick):
        plot = store.folder.relative_to(ROOT) / f"{name}.svg"
        command = [render.MENISCUS, "bench", *words]
        bench = json.loads(store.run([*command, "--json", "-", "--svg", plot]))["benchmarks"][0]
        target = pictures / f"bench_{name}.svg"
        target.write_text((ROOT / plot).read_text())
        out += f"### {mark} {what}\n\n![Run time against error](pictures/{target.name})\n\n"
        out += markdown.code(" ".join(["meniscus", *command[1:]])) + "\n"
        for model, reference in bench["references"].items():
            out += (f"Reference, {model}: {reference['samples']} samples a pixel, paths of {reference['depth']} segments, its own RMSE "
                    f"{reference['rmse']:.1e}, mean {reference['bias']:.0e}.\n")
        for curve in ("Meniscus, contact", "Meniscus, gap"):
            kernels = sorted({row["kernel"] for row in bench["rows"] if row["curve"] == curve and "kernel" in row})
            out += f"{curve}, by kernel {'; '.join(kernels)}.\n" if kernels else ""
        head = ["at", "", "seconds", "against", "seconds", "times faster"]
        out += "\nAt equal error:\n\n" + markdown.table(head, ratio_rows(bench["at_equal_error"]))
        out += "\nThe same task (of POV-Ray: pixel centres within the same limits):\n\n"
        out += markdown.table(head, ratio_rows(bench["of_equal_tasks"]))
        out += "\nMeniscus in contact:\n\n" + markdown.table(
            ["options", "RMSE", "bias", "seconds", "segments", "ns a segment"],
            [[row["options"], f"{row['error']['rmse']:.2e}", f"{row['error']['bias']:+.1e}", markdown.number(row["cpu_seconds"]),
              row["segments"], markdown.number(row["ns_a_segment"])]
             for row in bench["rows"] if row["curve"] == "Meniscus, contact" and "failure" not in row]) + "\n"
    words = mesh_words(quick, folder)
    bench = json.loads(store.run([render.MENISCUS, "bench", *words, "--json", "-"]))["benchmarks"][0]
    out += "### (iii) a ring of glass, one mesh of 70,000 triangles\n\n"
    out += markdown.code("meniscus bench " + " ".join(words))
    return out + "\n" + markdown.table(["at", "", "seconds", "against", "seconds", "times faster"],
                                       ratio_rows(bench["of_equal_tasks"] + bench["at_equal_error"])) + "\n"
