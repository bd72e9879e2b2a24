#!/usr/bin/env python3
"""Does a second reader see in the library's models what data/furniture-seen.json says of them?

    assets_seen.py draw 100 --seed 41 --portraits FOLDER > check.json
    assets_seen.py score answers.json

draw lists models, and where bench_asset_portraits put their pictures, for somebody who has not read the
table. His answers: {"Library/id": {"kind": "...", "parts": [{"part": "...", "color": "...", "material":
"..."}, ...]}}, the part with the largest surface first. Goals: kind 98 %, colour and material of the main
part 95 %, parts 95 %.
"""

import argparse
import json
import pathlib
import random
import re
import sys

DATA = pathlib.Path(__file__).resolve().parent.parent / "data"
GOALS = {"kind": 0.98, "main color and material": 0.95, "parts": 0.95}
# Neighbours between which two people who look at the same thing may differ.
NEAR_COLORS = [
    {"white", "cream", "beige", "silver", "clear", "transparent"}, {"grey", "silver", "black", "white"},
    {"brown", "light brown", "dark brown", "beige", "orange", "black"}, {"beige", "yellow", "gold", "light brown"},
    {"red", "orange", "pink", "brown"}, {"blue", "green", "purple", "grey"}, {"yellow", "orange", "green"},
    {"pink", "purple"}, {"clear", "transparent", "grey", "green", "blue", "white"}]
NEAR_MATERIALS = [{"plastic", "painted wood", "painted metal", "laminate", "metal"}, {"ceramic", "plastic", "stone"},
                  {"leather", "fabric", "plastic"}, {"rubber", "plastic"}, {"paper", "cardboard", "fabric"}]


def table():
    assets = json.loads((DATA / "furniture-seen.json").read_text())["assets"]
    return {f"{library}/{name}": entry for library, entries in assets.items() for name, entry in entries.items()}


def kinds():
    """Name or other name of a kind to its line: itself, then what it is a kind of."""
    entries = {}
    for file in sorted((DATA / "kinds").glob("*.json")):
        entries.update(json.loads(file.read_text()).get("kinds", {}))
    lines = {}
    for kind, entry in entries.items():
        line, at = [], kind
        while at and at not in line:
            line.append(at)
            at = entries.get(at, {}).get("is", "")
        for name in [kind, *entry.get("names", []), *entry.get("loose_names", [])]:
            lines.setdefault(name, line)
    return lines


def families():
    vocabulary = json.loads((DATA / "vocabulary.json").read_text())
    return [set(family) for family in vocabulary["families"]] + NEAR_MATERIALS


def same_kind(answer, entry, lines):
    """One of a line, as a dining chair is a chair; what no table knows is compared by its last word."""
    have, want = lines.get(answer, [answer]), lines.get(entry["kind"], [entry["kind"]])
    return have[0] in want or want[0] in have or have[0].split()[-1:] == want[0].split()[-1:]


def near(a, b, groups):
    return a == b or any(a in group and b in group for group in groups)


def same_material(a, b, groups):
    return near(a, b, groups) or any(near(x, y, groups) for x in a.split() for y in b.split())


def same_look(a, b, groups):
    return near(a["color"], b["color"], NEAR_COLORS) and same_material(a["material"], b["material"], groups)


def names_of(part):
    return {word.rstrip("s") for word in re.findall(r"[a-z]+", part["part"]) if word != "and"}


def parts_found(answered, parts, groups):
    """Of the answered parts, how many the table has: by a name in common, or by how they look."""
    return sum(any(names_of(a) & names_of(p) or same_look(a, p, groups) for p in parts) for a in answered)


def draw(count, seed, portraits):
    names = sorted(name for name in table() if (portraits / f"{name}.png").exists())
    chosen = sorted(random.Random(seed).sample(names, count))
    print(json.dumps({"portraits": str(portraits), "seed": seed, "assets": chosen}, indent=1))


def score(file):
    seen, lines, groups = table(), kinds(), families()
    answers = json.loads(pathlib.Path(file).read_text())
    right = {goal: 0 for goal in GOALS}
    asked = {goal: 0 for goal in GOALS}
    for name, answer in answers.items():
        entry, parts = seen[name], answer["parts"]
        verdicts = {"kind": (same_kind(answer["kind"], entry, lines), 1),
                    "main color and material": (any(same_look(parts[0], part, groups) for part in entry["parts"][:2]), 1),
                    "parts": (parts_found(parts, entry["parts"], groups), len(parts))}
        for goal, (got, of) in verdicts.items():
            right[goal] += got
            asked[goal] += of
            if got < of:
                print(f"{name}: {goal}: {json.dumps(answer)} against {entry['kind']}, {json.dumps(entry['parts'])}")
    for goal, least in GOALS.items():
        share = right[goal] / max(asked[goal], 1)
        print(f"{goal}: {right[goal]} of {asked[goal]}, {share:.1%} ({'reached' if share >= least else 'goal'} {least:.0%})")
    return 0 if all(right[goal] >= least * asked[goal] for goal, least in GOALS.items()) else 1


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    drawing = commands.add_parser("draw")
    drawing.add_argument("count", type=int)
    drawing.add_argument("--seed", type=int, default=41)
    drawing.add_argument("--portraits", type=pathlib.Path, required=True)
    commands.add_parser("score").add_argument("answers")
    arguments = parser.parse_args()
    if arguments.command == "draw":
        return draw(arguments.count, arguments.seed, arguments.portraits)
    return score(arguments.answers)


if __name__ == "__main__":
    sys.exit(main())
