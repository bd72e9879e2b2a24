#!/usr/bin/env python3
"""What becomes of the nouns of a list when a prompt asks for one of each.

usage: nouns.py ROOMGEN LIST.csv [--half open|kept] [--words]

LIST.csv has the columns noun and count (how often it was met). Each noun is asked for in a room of its
own, with a workbench for what stands on others:

  kind        a kind is called so
  synonym     WordNet says that it is another word for a kind, or a special one of it
  spelling    a misspelt name of a kind
  made        put together from its words
  stand-in    a plain shape of the size of such things
  room        part of the room: a wall, a window
  missing     listed as left out
  no object   nothing is planned

The halves are drawn by the noun's hash: what becomes of the open one may be looked at (--words), the kept one
is for figures only.
"""
import argparse
import collections
import concurrent.futures
import csv
import hashlib
import json
import os
import subprocess
import tempfile

FATES = ["kind", "synonym", "spelling", "made", "stand-in", "room", "missing", "no object"]


def half_of(noun):
    return "open" if hashlib.sha256(noun.encode()).digest()[0] % 2 == 0 else "kept"


def phrase(noun):
    if noun.endswith("s") and not noun.endswith("ss"):
        return "some " + noun
    return ("an " if noun[0] in "aeiou" else "a ") + noun


def said_in(scene, prompt_start, noun):
    """How the last word of the noun was heard."""
    end = prompt_start + len(noun)
    for heard in scene.get("heard", []):
        if heard["span"][0] < end <= heard["span"][1]:
            return heard["as"]
    return "not understood"


def fate(roomgen, noun):
    start = "A large living room with only a workbench and "
    prompt = start + phrase(noun) + "."
    with tempfile.TemporaryDirectory() as folder:
        output = os.path.join(folder, "room")
        done = subprocess.run([roomgen, "generate", "--no-pictures", "--json", "--seed", "1", "-o", output, "--", prompt],
                              capture_output=True, text=True, timeout=300)
        if done.returncode != 0:
            return "no object"
        with open(os.path.join(output, "scene.json"), encoding="utf-8") as file:
            scene = json.load(file)
        with open(os.path.join(output, "plan.json"), encoding="utf-8") as file:
            notes = " ".join(json.load(file).get("notes", []))
    if scene["unplaced"]:
        return "missing"
    things = [thing for thing in scene["objects"] if thing["id"] != "workbench-0"]
    if not things:
        heard = said_in(scene, len(start) + phrase(noun).rindex(noun), noun)
        return "room" if heard in ("thing", "room", "relation") else "no object"
    thing = things[0]
    if thing.get("stand_in"):
        return "stand-in " + thing["asset"]["procedural"]["params"]["kind"].removeprefix("stand-in ")
    if thing["asset"].get("procedural", {}).get("params", {}).get("approximate"):
        return "made"
    if "is taken for a" in notes:
        return "synonym " + thing["category"]
    if 'read "' in notes:
        return "spelling " + thing["category"]
    return "kind " + thing["category"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("roomgen")
    parser.add_argument("list")
    parser.add_argument("--half", choices=["open", "kept"], default="open")
    parser.add_argument("--words", action="store_true", help="what each noun became; not for the kept half")
    arguments = parser.parse_args()
    with open(arguments.list, newline="", encoding="utf-8") as file:
        counts = {row["noun"]: int(row["count"]) for row in csv.DictReader(file) if half_of(row["noun"]) == arguments.half}
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        fates = dict(zip(counts, pool.map(lambda noun: fate(arguments.roomgen, noun), counts)))
    nouns, met = collections.Counter(), collections.Counter()
    for noun, what in fates.items():
        group = next(one for one in FATES if what.startswith(one))
        nouns[group] += 1
        met[group] += counts[noun]
    print(f"{len(counts)} nouns of the {arguments.half} half, met {sum(counts.values())} times")
    for group in FATES:
        print(f"  {group:10} {100 * nouns[group] / len(counts):5.1f} % of the nouns, {100 * met[group] / sum(counts.values()):5.1f} % of what was met")
    if arguments.words and arguments.half == "open":
        for group in FATES:
            listed = [f"{noun} ({what.removeprefix(group).strip()})" for noun, what in fates.items() if what.startswith(group)]
            print(f"{group}: {'; '.join(listed)}")


if __name__ == "__main__":
    main()
