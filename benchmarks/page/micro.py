"""Micro-benchmarks, and meshes against Embree."""

import json

import markdown


def micro_table(store, quick):
    command = ["build/benchmarks/benchmarks/micro", f"--benchmark_min_time={0.02 if quick else 0.5}", *(["--benchmark_filter=-1000000"] if quick else []),
               "--benchmark_format=json"]
    rows = []
    for one in json.loads(store.run(command))["benchmarks"]:
        extra = [f"{key} {markdown.number(one[key])}" for key in ("met", "visits", "crossings", "items_per_second") if key in one]
        scale = {"ns": 1, "us": 1e3, "ms": 1e6, "s": 1e9}[one["time_unit"]]
        rows.append([f"`{one['name']}`", markdown.number(scale * one["cpu_time"]), ", ".join(extra)])
    return ("### Pieces\n\n`micro " + " ".join(command[1:-1]) + "`, one ray at a time; *met* is the share of rays that meet the shape, *visits* the\n"
            "boxes visited a ray, *crossings* and *items* are a second's.\n\n" + markdown.table(["", "CPU ns", ""], rows) + "\n")


def mesh_rays(store, root, quick):
    program = root / "build/benchmarks/benchmarks/mesh_rays"
    if not program.exists():
        return ""
    out = ("### Meshes against Embree\n\nEmbree 3.13, robust, one ray at a time, in turns with ours in one run on one thread; ours finds its crossings in double\n"
           "precision.\n\n")
    for count in [70_000, 1_000_000]:
        words = [program.relative_to(root), count, *([131072, 7] if quick else [262144, 7])]
        out += markdown.code("$ " + " ".join(["mesh_rays", *map(str, words[1:])]) + "\n" + store.run(words)) + "\n"
    return out


def section(store, root, quick):
    return "## Pieces of the work\n\n" + mesh_rays(store, root, quick) + micro_table(store, quick)
