#!/usr/bin/env python3
"""A real language model (SmolLM2, 135 M parameters, on this machine) furnishes a bedroom over HTTP.

    local_model.py ROOMGEN SOURCE_FOLDER OUTPUT

It is far too weak to design: the room must come out whole and valid all the same, and the summary must say how much
of it is the rules' work. Exit code 77 (skipped) where scripts/try-local-model has not installed the model.
"""

import json
import subprocess
import sys
from pathlib import Path


def main():
    roomgen, source, output = sys.argv[1], Path(sys.argv[2]), Path(sys.argv[3])
    sys.path.insert(0, str(source / "tests" / "checker"))
    python = source / "build" / "local-model" / "bin" / "python"
    if not (python.parents[1] / "ready").exists():
        print("skipped: scripts/try-local-model installs the model that this test asks")
        return 77
    server = subprocess.Popen(
        [python, source / "scripts" / "local_model_server.py"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True
    )
    try:
        url = server.stdout.readline().strip()
        done = subprocess.run(
            [
                roomgen, "--quiet", "--json", "generate", "a bedroom", "--designer", "model", "--reader", "rules", "--steps", "objects", "--model", "smollm2",
                "--mode", "constraints", "--base-url", url, "--call-seconds", "60", "--idle-seconds", "60", "--plan-tokens", "600", "--place-tokens", "150",
                 "-o", output, "--force", "--no-pictures",
            ],
            capture_output=True,
            text=True,
        )  # fmt: skip
    finally:
        server.kill()
    print(done.stdout, done.stderr)
    if done.returncode != 0:
        return 1

    from roomgen_checker import files, reach, report
    from roomgen_checker.constraints import STRICT

    summary = json.loads(done.stdout)
    scene = json.loads((output / "scene.json").read_text())
    options = report.Options(files.Categories.default(), STRICT, "auto", None, reach.LENIENCE)
    violations = report.check_file(output / "scene.json", options)["violations"]
    lines = [json.loads(line) for line in (output / "trace.jsonl").read_text().splitlines()]
    steps = [line for line in lines if "object" in line]
    by_rules = sum(a.get("model", {}).get("fell_back", False) for s in steps for a in s.get("attempts", []))
    failures = []
    if violations:
        failures.append(f"violations: {violations}")
    if not any(o["category"] == "bed" or "bed" in o["category"] for o in scene["objects"]):
        failures.append("a bedroom without a bed")
    if scene.get("incomplete") or summary["incomplete"] or len(scene["objects"]) < 3:
        failures.append("the room is not complete")
    if summary["model"]["calls"] < 1 or summary["model"]["input_tokens"] < 500:
        failures.append("the model was not asked")
    if summary["model"]["fallbacks"] != by_rules:
        failures.append(f"the summary counts {summary['model']['fallbacks']} fallbacks, the trace {by_rules}")
    for failure in failures:
        print(failure, file=sys.stderr)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
