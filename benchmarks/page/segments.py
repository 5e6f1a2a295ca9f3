"""What a segment takes, by kernel."""

import pathlib

import markdown
import render

SCENES = "tests/povray/bench"
OPTIONS = ["--spp", "1"]
TIMED, COUNTED = ["-W", "320", "-H", "240"], ["-W", "96", "-H", "72"]


def section(store, quick):
    runs = 5 if quick else 11
    flags = pathlib.Path("/proc/cpuinfo").read_text().split()
    kernels = [kernel for kernel, flag in (("avx512", "avx512f"), ("avx2", "avx2")) if flag in flags] + ["general"]
    out = ("## A segment\n\n"
           f"{render.shown('SCENE', *TIMED, *OPTIONS, '--kernel', 'KERNEL', '--threads', 1)}: CPU nanoseconds of the render stage a segment,\n"
           f"medians of {runs}, in turns. Instructions by `benchmarks/count-instructions`, with `{' '.join(COUNTED)}`; it cannot count those of AVX-512.\n\n")
    rows = []
    for mark, scene in (("(i)", "spheres"), ("(ii)", "tumbler")):
        path = f"{SCENES}/{scene}.scene"
        timed = render.interleaved(store, [(path, *TIMED, *OPTIONS, "--kernel", kernel) for kernel in kernels], runs)
        for kernel, result in zip(kernels, timed):
            counted = "-"
            if kernel != "avx512":
                few = (path, *COUNTED, *OPTIONS, "--kernel", kernel)
                total, _ = render.instructions(store, *few)
                counted = markdown.number(total / render.run(store, *few)["segments"])
            rows.append([f"{mark} {path}", kernel, result["segments"], markdown.number(result["ns"]), counted])
    return out + markdown.table(["scene", "kernel", "segments", "ns a segment", "instructions a segment"], rows) + "\n"
