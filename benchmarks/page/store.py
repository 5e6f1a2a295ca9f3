"""Runs commands and keeps what they print, so that a run that was stopped goes on where it was."""

import hashlib
import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]


class Store:
    """Results of one build of the programs, in a folder of its own."""

    def __init__(self, folder, programs, again=False):
        build = hashlib.sha256()
        for program in programs:
            build.update(pathlib.Path(program).read_bytes())
        self.folder = pathlib.Path(folder) / build.hexdigest()[:12]
        self.folder.mkdir(parents=True, exist_ok=True)
        if again:
            for kept in self.folder.glob("*.out"):
                kept.unlink()

    def run(self, command):
        """What the command prints on standard output; from memory if it ran before."""
        words = [str(word) for word in command]
        key = hashlib.sha256("\0".join(words).encode()).hexdigest()[:16]
        kept = self.folder / f"{key}.out"
        if kept.exists():
            return kept.read_text()
        print("  " + " ".join(words), file=sys.stderr, flush=True)
        done = subprocess.run(words, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        if done.returncode != 0:
            raise SystemExit(f"{' '.join(words)}\nended with {done.returncode}:\n{done.stderr[-2000:]}")
        partial = kept.with_suffix(f".{os.getpid()}")
        partial.write_text(done.stdout)
        partial.rename(kept)
        return done.stdout
