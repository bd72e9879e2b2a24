#!/usr/bin/env python3
"""What a search of so many steps is worth, with moves of clusters and without.

    bench/programs/budgets.py ROOMGEN FOLDER [--programs FILE...] [--seeds 5] [--steps 1000 5000 20000 60000]

Mean violation and loss (less is better) over the seeds, one chain each; the same seed gives both the same room."""
import argparse
import json
import pathlib
import statistics
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAMS = [ROOT / "tests/data/programs/dining.json"] + [
    ROOT / f"examples/programs/{name}.json" for name in ("classroom", "library", "meeting-room", "restaurant")]


def run(roomgen, folder, program, seed, steps, more):
    done = subprocess.run([roomgen, "optimise", program, "-o", folder / "room", "--force", "--seed", str(seed), "--steps",
                           str(steps), "--chains", "1", "--no-pictures", "--json", "--quiet", *more],
                          capture_output=True, text=True, check=True)
    said = json.loads(done.stdout)
    return said["violation"], said["loss"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("roomgen")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--programs", nargs="+", type=pathlib.Path, default=PROGRAMS)
    parser.add_argument("--seeds", type=int, default=5)
    parser.add_argument("--steps", nargs="+", type=int, default=[1000, 5000, 20000, 60000])
    known = parser.parse_args()
    print("| program | moves |" + "".join(f" {steps:,} |" for steps in known.steps))
    print("|---|---|" + "---|" * len(known.steps))
    for program in known.programs:
        for name, more in (("with clusters", []), ("without", ["--no-clusters"])):
            cells = []
            for steps in known.steps:
                worth = [run(known.roomgen, known.folder, program, seed, steps, more) for seed in range(1, known.seeds + 1)]
                missed, loss = (statistics.mean(values) for values in zip(*worth))
                cells.append(f" {missed:.2f} missed, {loss:.1f} |" if missed > 0.005 else f" {loss:.1f} |")
            print(f"| {program.stem} | {name} |" + "".join(cells), flush=True)


if __name__ == "__main__":
    main()
