#!/usr/bin/env python3
"""The least sizes of rooms that are what they are called, as `roomgen plan` measures them.

    bench/least_sizes.py ROOMGEN COMMIT > bench/results/least-sizes.json
"""
import datetime
import json
import platform
import re
import subprocess
import sys

TYPES = ["bedroom", "living room", "kitchen", "bathroom", "toilet room", "dining room", "study", "kids room", "nursery",
         "studio", "laundry room", "walk-in closet", "home gym", "open office", "conference room", "classroom",
         "hotel room", "dormitory", "restaurant", "workshop"]


def least(roomgen, room):
    """Width and depth in metres, from the refusal of a room of half a metre."""
    ended = subprocess.run([roomgen, "plan", "a " + room, "--size", "0.5x0.5"], capture_output=True, text=True)
    found = re.search(r"; ([\d.]+) x ([\d.]+) m is the least size", ended.stderr)
    if ended.returncode != 1 or not found:
        raise SystemExit(f"{room}: {ended.stderr or ended.stdout}")
    return float(found[1]), float(found[2])


def main():
    roomgen, commit = sys.argv[1:]
    values = []
    for room in TYPES:
        for side, metres in zip(("width", "depth"), least(roomgen, room)):
            values.append({"name": f"{room}, {side}", "value": metres, "unit": "m"})
    print(json.dumps({"what": "Least inner size in which a room plan has what makes the room what it is called (docs/rooms.md)",
                      "command": "bench/least_sizes.py build/release/roomgen COMMIT",
                      "machine": f"{platform.machine()}, {platform.system()}; the figures do not depend on it",
                      "commit": commit, "date": datetime.date.today().isoformat(), "values": values}, indent=1))


if __name__ == "__main__":
    main()
