"""Renders by `meniscus render`: times, counts and instructions."""

import json
import re
import statistics

MENISCUS = "build/benchmarks/meniscus"


def words(scene, *options):
    """A command that renders with one thread unless the options say otherwise, and says what it did."""
    command = [MENISCUS, "render", scene, "-o", "/dev/null", "--format", "exr", "--json", "-", "--quiet", *options]
    return command if "--threads" in options else [*command, "--threads", "1"]


def shown(scene, *options):
    """The command as the page tells it."""
    return "`" + " ".join(["meniscus", "render", scene, *map(str, options)]) + "`"


def run_once(store, i, scene, *options):
    # A shell between, which forks: Linux counts what a program's caller held before it as the program's own peak. Its name tells runs apart.
    return json.loads(store.run(["sh", "-c", '"$@"; exit $?', f"run-{i}", *words(scene, *options)]))


def run(store, scene, *options, runs=1):
    """The JSON of one render, its times the medians of so many runs."""
    return median([run_once(store, i, scene, *options) for i in range(runs)])


def interleaved(store, renders, runs):
    """The same of several renders, whose runs take turns."""
    results = [[run_once(store, i, *one) for one in renders] for i in range(runs)]
    return [median(list(of_one)) for of_one in zip(*results)]


def median(results):
    result = results[0]
    for kind in ("seconds", "cpu_seconds"):
        for stage in result[kind]:
            result[kind][stage] = statistics.median(one[kind][stage] for one in results)
    result["ns"] = 1e9 * result["cpu_seconds"]["render"] / result["segments"]
    return result


def instructions(store, scene, *options):
    """Instructions of the render stage: those of all, and by function."""
    text = store.run(["benchmarks/count-instructions", *words(scene, *options)])
    total = re.search(r"([\d,]+) \(100\.0%\)\s+PROGRAM TOTALS", text)
    functions = {}
    for line in text.splitlines():
        found = re.match(r"\s*([\d,]+) \([ \d.]+%\)\s+[^:]*:(\S.*?)(?: \[.*\])?$", line)
        if found:
            functions[found[2]] = functions.get(found[2], 0) + int(found[1].replace(",", ""))
    return int(total[1].replace(",", "")), functions
