"""What a scene does not need, and whether it costs nothing: counts with and without it."""

import markdown
import render

SCENES = "benchmarks/scenes/skipping"


def section(store, root):
    rows = []
    options = ["-W", "48", "-H", "36", "--spp", "1"]
    for path in sorted((root / SCENES).glob("*.scene")):
        text = path.read_text()
        variants = [("", [])] + ([("without", ["--declare", "Without=1"])] if "(Without)" in text else [])
        for label, declared in variants:
            scene = f"{SCENES}/{path.name}"
            result = render.run(store, scene, *options, *declared)
            total, _ = render.instructions(store, scene, *options, *declared)
            crossings = result["crossings"]
            rows.append([label or text.splitlines()[0].removeprefix("// "), result["casts"], result["segments"], crossings["true"],
                         crossings["false"], result["rays"]["shadow"], markdown.number(total / result["segments"]),
                         "; ".join(result["skipped"]) or "nothing"])
    return ("## What is skipped\n\n"
            f"{render.shown('SCENE', *options, '--threads', 1)}, scenes of `{SCENES}`; *without* is the same with\n"
            "`--declare Without=1`. Instructions by `benchmarks/count-instructions`. What a scene does not need should cost neither casts nor\n"
            "instructions.\n\n"
            + markdown.table(["scene", "casts", "segments", "true crossings", "false", "shadow rays", "instructions a segment", "skipped, as told"],
                             rows) + "\n")
