#!/usr/bin/env python3
"""Whether `roomgen check` and `roomgen evaluate` are of one opinion about what collides: agree.py ROOMGEN FOLDER

FOLDER holds folders with a scene.json, as freeze.py --keep and bench/rooms/run.py leave them; dwellings count room by
room. Prints every pair of solids that only one of the two names and exits 1 if there is any.
"""

import argparse
import csv
import json
import subprocess
import sys
import tempfile
from pathlib import Path


def overlaps(roomgen, scene):
    """The pairs that `check` names."""
    done = subprocess.run([roomgen, "--json", "check", scene], capture_output=True, text=True)
    if not done.stdout:
        sys.exit(f"{scene}: {done.stderr.strip()}")
    found = json.loads(done.stdout)["violations"]
    return {frozenset((v["object"], v["other"])) for v in found if v["fault"] == "overlap"}


def collisions(roomgen, folder, ids):
    """The pairs that `evaluate` names, by the folder's name."""
    with tempfile.TemporaryDirectory() as place:
        rows, scores = Path(place) / "rows.csv", Path(place) / "scores.json"
        with open(rows, "w", encoding="utf-8", newline="") as file:
            csv.writer(file).writerows([["ID", "Description", "ObjCount"], *([name, name, ""] for name in ids)])
        subprocess.run([roomgen, "--quiet", "evaluate", "--requirements", rows, "--rooms", folder, "--json-file", scores],
                       check=True, stdout=subprocess.DEVNULL)
        return {score["id"]: {frozenset(pair) for pair in score["collisions"]}
                for score in json.loads(scores.read_text())["scores"]}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("roomgen", type=Path)
    parser.add_argument("folder", type=Path)
    options = parser.parse_args()
    scenes = sorted(options.folder.glob("*/scene.json"))
    scored = collisions(options.roomgen, options.folder, [scene.parent.name for scene in scenes])
    differing = solids = rugs = 0
    for scene in scenes:
        name = scene.parent.name
        flat = {o["id"] for o in json.loads(scene.read_text())["objects"] if "flat" in o.get("traits", [])}
        checked = overlaps(options.roomgen, scene)
        among_solids = {pair for pair in scored[name] if not pair & flat}
        for pair in checked ^ among_solids:
            print(f"{name}: {' and '.join(sorted(pair))}: only {'check' if pair in checked else 'evaluate'}")
        differing += len(checked ^ among_solids)
        solids += len(checked)
        rugs += len(scored[name]) - len(among_solids)
    print(f"{len(scenes)} scenes: {solids} pairs of solids collide, {rugs} with a rug; {differing} in only one opinion")
    return 1 if differing else 0


if __name__ == "__main__":
    sys.exit(main())
