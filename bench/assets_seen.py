#!/usr/bin/env python3
"""Does a second reader see in the library's models what data/furniture-seen.json says of them?

    assets_seen.py draw 100 --seed 41 --portraits FOLDER > check.json
    assets_seen.py score answers.json [again.json]

draw lists models, and where bench_asset_portraits put their pictures, for somebody who has not read the
table; with --but 41 others than that seed's. His answers: {"Library/id": {"kind": "...", "parts":
[{"part": "...", "color": "...", "material": "..."}, ...]}}, the part with the largest surface first.
What counts as the same is written in assets_seen_alike.json; the shares without it stand beside.
Goals: kind 98 %, colour and material of the main part 95 %, parts 95 %.
"""

import argparse
import json
import pathlib
import random
import re
import sys

DATA = pathlib.Path(__file__).resolve().parent.parent / "data"
GOALS = {"kind": 0.98, "main color and material": 0.95, "parts": 0.95}
ALIKE = json.loads((pathlib.Path(__file__).parent / "assets_seen_alike.json").read_text())
SHADES = {shade: color for color, shades in ALIKE["shades"].items() for shade in shades}


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
    return [set(family) for family in json.loads((DATA / "vocabulary.json").read_text())["families"]] + [
        set(group) for group in ALIKE["materials"]]


def near(a, b, groups):
    return a == b or any(a in group and b in group for group in groups)


def same_kind(answer, entry, lines):
    """The kind, or what it is a kind of: a dining chair is a chair, not every chair a dining chair. What no
    table knows is compared by its last word."""
    have = {answer, *(name for group in ALIKE["kinds"] if answer in group for name in group)}
    want = lines.get(entry["kind"], [entry["kind"]])
    if any(lines.get(name, [name])[0] in want for name in have):
        return True
    return answer not in lines and answer.split()[-1:] == want[0].split()[-1:]


def same_material(a, b, groups):
    return near(a, b, groups) or any(near(x, y, groups) for x in a.split() for y in b.split() if x != "painted")


def same_look(a, b, groups):
    colors = [SHADES.get(part["color"], part["color"]) for part in (a, b)]
    return near(*colors, ALIKE["neighbours"]) and same_material(a["material"], b["material"], groups)


def names_of(part):
    names = {word.rstrip("s") for word in re.findall(r"[a-z]+", part["part"]) if word != "and"}
    return names | {name for group in ALIKE["parts"] if names & set(group) for name in group}


def parts_found(answered, parts, groups):
    """Of the answered parts, how many the table has: by a name in common, or by how they look."""
    return sum(any(names_of(a) & names_of(p) or same_look(a, p, groups) for p in parts) for a in answered)


def word_for_word(answer, entry):
    """Of kind, look of the main part and parts, what is the same without any folding."""
    looks = [(part["color"], part["material"]) for part in entry["parts"]]
    first = answer["parts"][0]
    named = " ".join(part["part"] for part in entry["parts"])
    return (answer["kind"] == entry["kind"], (first["color"], first["material"]) == looks[0],
            sum(part["part"] in named for part in answer["parts"]))


def draw(count, seed, portraits, but):
    """Of the models that the draws of the seeds `but`, one after the other, left over."""
    names = sorted(name for name in table() if (portraits / f"{name}.png").exists())
    for other in [*but, seed]:
        chosen = sorted(random.Random(other).sample(names, count))
        names = [name for name in names if name not in chosen]
    print(json.dumps({"portraits": str(portraits), "seed": seed, "but": but, "assets": chosen}, indent=1))


def verdicts(answer, entry, lines, groups):
    """Of each goal how many are right: folded, and word for word."""
    parts = answer["parts"]
    plain = word_for_word(answer, entry)
    look = any(same_look(parts[0], part, groups) for part in entry["parts"][:2])
    return dict(zip(GOALS, [(same_kind(answer["kind"], entry, lines), plain[0], 1), (look, plain[1], 1),
                            (parts_found(parts, entry["parts"], groups), plain[2], len(parts))]))


def score(files):
    seen, lines, groups = table(), kinds(), families()
    sums = {goal: [0, 0, 0] for goal in GOALS}
    answers = {}
    for file in files:
        answers.update(json.loads(pathlib.Path(file).read_text()))
    for name, answer in answers.items():
        entry = seen[name]
        for goal, counts in verdicts(answer, entry, lines, groups).items():
            sums[goal] = [sum(pair) for pair in zip(sums[goal], counts)]
            if counts[0] < counts[2]:
                print(f"{name}: {goal}: {json.dumps(answer)} against {entry['kind']}, {json.dumps(entry['parts'])}")
    for goal, (right, plain, asked) in sums.items():
        reached = "reached" if right >= GOALS[goal] * asked else "goal"
        print(f"{goal}: {right} of {asked}, {right / max(asked, 1):.1%} ({reached} {GOALS[goal]:.0%}); "
              f"word for word {plain / max(asked, 1):.1%}")
    return 0 if all(right >= GOALS[goal] * asked for goal, (right, _, asked) in sums.items()) else 1


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    drawing = commands.add_parser("draw")
    drawing.add_argument("count", type=int)
    drawing.add_argument("--seed", type=int, default=41)
    drawing.add_argument("--but", type=int, nargs="*", default=[], help="seeds whose models were read before")
    drawing.add_argument("--portraits", type=pathlib.Path, required=True)
    commands.add_parser("score").add_argument("answers", nargs="+", help="a later file's go before an earlier one's")
    arguments = parser.parse_args()
    if arguments.command == "draw":
        return draw(arguments.count, arguments.seed, arguments.portraits, arguments.but)
    return score(arguments.answers)


if __name__ == "__main__":
    sys.exit(main())
