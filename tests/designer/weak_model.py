#!/usr/bin/env python3
"""What validation is good for: programs that a weak model wrote (tests/data/create/weak-model), with and without it.

    weak_model.py ROOMGEN SOURCE_FOLDER OUTPUT

Replays the recorded answers in the variants full and no-validation. Exit code 1 unless the programs are the model's and
measurably better when they were validated. The README beside the answers says how they were recorded.
"""

import json
import subprocess
import sys
from pathlib import Path

CHECKS = ("connected", "grounded", "supported", "symmetric", "stable", "size")
VARIANTS = ("no-validation", "full")
# What validation must win, in programs: about half of what it won when the answers were recorded.
LEAST_GAIN = {"connected": 3, "grounded": 6, "stable": 2}


def replay(roomgen, data, answers, output):
    done = subprocess.run(
        [
            roomgen, "--quiet", "experiment", "--create", str(data / "suite.json"), "-o", str(output), "--force",
            "--variants", ",".join(VARIANTS), "--designer", "model", "--model", "SmolLM2-135M-Instruct",
            "--answers", "1", "--answer-tokens", "900", "--prompts", str(answers / "prompts"),
            "--replay", str(answers / "answers.jsonl"),
        ],
        capture_output=True,
        text=True,
    )  # fmt: skip
    if done.returncode != 0:
        sys.exit(f"{answers.name}: exit {done.returncode}: {done.stderr}")
    return json.loads((output / "results.json").read_text())["results"]


def share(results, check):
    asked = [r[check] for r in results if r[check] is not None]
    return sum(asked), len(asked)


def main():
    roomgen, data, output = sys.argv[1], Path(sys.argv[2]) / "tests/data/create/weak-model", Path(sys.argv[3])
    results = []
    output.mkdir(parents=True, exist_ok=True)
    for answers in sorted(path.parent for path in data.glob("*/answers.jsonl")):
        results += replay(roomgen, data, answers, output / answers.name)
    of = {v: [r for r in results if r["variant"] == v and not r["by_rules"]] for v in VARIANTS}
    sentences = sum(r["variant"] == "full" for r in results)
    print(f"{sentences} answers, {len(of['full'])} programs are the model's\n")
    print("| variant | programs | parts right | " + " | ".join(CHECKS) + " |\n" + "|---" * (3 + len(CHECKS)) + "|")
    for variant in VARIANTS:
        mine = of[variant]
        parts = sum(r["parts_right"] for r in mine) / max(1, sum(r["parts_asked"] for r in mine))
        cells = [f"{right} of {asked}" for right, asked in (share(mine, check) for check in CHECKS)]
        print(f"| {variant} | {len(mine)} | {parts:.0%} | " + " | ".join(cells) + " |")

    failures = []
    if len(of["full"]) < 0.5 * sentences:
        failures.append("most programs are the rules', not the model's")
    if [r["prompt"] for r in of["full"]] != [r["prompt"] for r in of["no-validation"]]:
        failures.append("the variants did not get the same answers")
    gained = {}
    for check in CHECKS:
        gained[check] = share(of["full"], check)[0] - share(of["no-validation"], check)[0]
        # A repair that steadies a thing may make it larger than was asked for.
        if gained[check] < (-1 if check == "size" else 0):
            failures.append(f"{check}: validation made {-gained[check]} worse")
    for check, least in LEAST_GAIN.items():
        if gained[check] < least:
            failures.append(f"{check}: validation gains {gained[check]} programs, not {least}")
    for failure in failures:
        print(failure, file=sys.stderr)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
