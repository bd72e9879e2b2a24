#!/usr/bin/env python3
"""The frames of one short tour drawn again and again, each time by a process of its own: how many ended badly or gave other
files; prints a table.

    repeat_frames.py ROOMGEN FOLDER [--runs 500] [--threads 2] [--size 64x48] [--fps 0.3]

FOLDER gets the room, its tour, the files of the last run and of the first that differ. Exit code 1 if any run failed or
differed from the first.
"""

import argparse
import hashlib
import shutil
import subprocess
import sys
from pathlib import Path


def contents(folder):
    """One hash of all files and their names."""
    whole = hashlib.sha256()
    for file in sorted(path for path in folder.rglob("*") if path.is_file()):
        whole.update(f"{file.relative_to(folder)}\0".encode() + hashlib.sha256(file.read_bytes()).digest())
    return whole.hexdigest()


def prepare(roomgen, folder):
    scene, tour = folder / "room/scene.json", folder / "tour/tour.json"
    if not tour.exists():
        folder.mkdir(parents=True, exist_ok=True)
        subprocess.run([roomgen, "--quiet", "generate", "a small bedroom", "--seed", "3", "--no-pictures", "--force", "-o",
                        scene.parent], check=True)
        subprocess.run([roomgen, "--quiet", "tour", scene, "-o", tour.parent], check=True)
    return scene, tour


def draw(options, scene, tour, run):
    """The exit code and the hash of the files."""
    shutil.rmtree(run, ignore_errors=True)
    run.mkdir()
    shutil.copy(tour, run)
    command = [options.roomgen, "--quiet", "frames", scene, "--tour", run, "--size", options.size, "--fps", options.fps,
               "--threads", options.threads]
    code = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode
    return code, contents(run)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("roomgen")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--runs", type=int, default=500)
    parser.add_argument("--threads", default="2")
    parser.add_argument("--size", default="64x48")
    parser.add_argument("--fps", default="0.3")
    options = parser.parse_args()
    scene, tour = prepare(options.roomgen, options.folder)
    first, failed, differing = None, 0, 0
    run = options.folder / "run"
    for number in range(options.runs):
        code, files = draw(options, scene, tour, run)
        if code:
            failed += 1
            print(f"run {number}: exit {code}", file=sys.stderr, flush=True)
            continue
        first = first or files
        if files != first:
            differing += 1
            print(f"run {number}: other files", file=sys.stderr, flush=True)
            if differing == 1:
                shutil.copytree(run, options.folder / "differing", dirs_exist_ok=True)
    print(f"| | runs |\n|---|---|\n| all | {options.runs} |\n| not exit 0 | {failed} |\n| other files than the first | {differing} |")
    return 1 if failed or differing else 0


if __name__ == "__main__":
    sys.exit(main())
