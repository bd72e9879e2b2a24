#!/usr/bin/env python3
"""Time by the clock and memory of whole commands, as Markdown: whole_job.py ROOMGEN FOLDER

The catalogue is made in FOLDER first, so that the rooms have a warm one.
"""

import os
import subprocess
import sys
import time
from pathlib import Path

FULL = Path(__file__).resolve().parent / "rooms/full-living-room.txt"


def measured(command, environment):
    """Seconds and the most megabytes that the command had, with those of its readers of meshes."""
    start = time.monotonic()
    child = subprocess.Popen(command, env=environment, stdout=subprocess.DEVNULL)
    _, status, used = os.wait4(child.pid, 0)
    if os.waitstatus_to_exitcode(status) != 0:
        sys.exit(f"failed: {' '.join(map(str, command))}")
    return time.monotonic() - start, used.ru_maxrss / 1000


def main():
    roomgen, folder = Path(sys.argv[1]).resolve(), Path(sys.argv[2])
    environment = os.environ | {"XDG_CACHE_HOME": str(folder / "cache")}
    jobs = {"index the libraries": ["assets", "index"], "assets search": ["assets", "search", "desk"]}
    for name, prompt in [(p, p) for p in ("a bedroom", "a living room", "a kitchen")] + [
            ("a full living room", FULL.read_text().strip())]:
        jobs[name] = ["generate", prompt, "--seed", "3", "-o", folder / "room", "--force"]
    print("| what | s | MB |\n|---|---|---|")
    for name, job in jobs.items():
        seconds, megabytes = measured([roomgen, *job], environment)
        print(f"| {name} | {seconds:.1f} | {megabytes:.0f} |", flush=True)


if __name__ == "__main__":
    main()
