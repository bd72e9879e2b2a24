#!/usr/bin/env python3
"""Makes every object of the suite: run.py ROOMGEN FOLDER [--seed N] [--timeout S] [--jobs N] [--only 3,17] [-- ARGUMENTS]

FOLDER gets, for the Nth prompt of prompts.json, NNN.glb, NNN.json (the program), NNN.summary.json (what --json printed)
and NNN.result.json (exit code, seconds, what was said on standard error); FOLDER/refused has the same for refused.json.
ARGUMENTS go to `roomgen create` as they are. score.py judges the folder.
"""

import argparse
import json
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

HERE = Path(__file__).resolve().parent


def create(roomgen, prompt, base, options, more):
    for suffix in (".glb", ".json", ".summary.json", ".result.json"):
        base.with_name(base.name + suffix).unlink(missing_ok=True)
    command = [roomgen, "create", prompt, "-o", f"{base}.glb", "--write-program", f"{base}.json", "--json"]
    if options.seed is not None:
        command += ["--seed", str(options.seed)]
    start = time.monotonic()
    try:
        done = subprocess.run(command + more, capture_output=True, text=True, errors="replace", timeout=options.timeout)
        code, out, err = done.returncode, done.stdout, done.stderr
    except subprocess.TimeoutExpired:
        code, out, err = None, "", f"not done in {options.timeout:g} s"
    if out.strip():
        Path(f"{base}.summary.json").write_text(out)
    result = {"prompt": prompt, "exit": code, "seconds": round(time.monotonic() - start, 3), "message": err.strip()}
    Path(f"{base}.result.json").write_text(json.dumps(result, indent=1, ensure_ascii=False) + "\n")
    return result


def main():
    own, more = sys.argv[1:], []
    if "--" in own:
        own, more = own[: own.index("--")], own[own.index("--") + 1 :]
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("roomgen")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--seed", type=int)
    parser.add_argument("--timeout", type=float, default=120)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--only", help="numbers of prompts, from 1; leaves the refused ones out")
    options = parser.parse_args(own)
    only = options.only and {int(number) for number in options.only.split(",")}
    tasks = []
    for source, folder in (("prompts", options.folder), ("refused", options.folder / "refused")):
        if only and source == "refused":
            continue
        folder.mkdir(parents=True, exist_ok=True)
        for number, entry in enumerate(json.loads((HERE / f"{source}.json").read_text()), 1):
            if not only or number in only:
                tasks.append((entry["prompt"], folder / f"{number:03d}"))
    with ThreadPoolExecutor(options.jobs) as pool:
        results = list(pool.map(lambda task: create(options.roomgen, *task, options, more), tasks))
    made = sum(result["exit"] == 0 for result in results)
    print(f"{made} of {len(results)} made in {sum(result['seconds'] for result in results):.1f} s")


if __name__ == "__main__":
    main()
