#!/usr/bin/env python3
"""Scores what run.py made: score.py FOLDER [--json FILE], or score.py --self-test.

Markdown on standard output: a row for each group and a total, the sentences that must be refused, then every failure.
Needs the packages of requirements.txt. What is judged, for each sentence of prompts.json:

made        NNN.glb is there and holds triangles
parts       of the parts that the sentence asks for, how many are there in the right number and shape
            (a column for the share of parts, one for the sentences with all of them)
connected   the pieces of the model touch (3 mm), or one is inside the other, as one whole
grounded    the lowest point is within 1 mm of z = 0
stable      dropped with MuJoCo, what stands by itself stays within 1 cm and 0.1 rad (see drop.py); not asked of
            things on the wall and the ceiling
size        within the sentence's width, depth and height
watertight  every piece is closed
light       at most 20,000 triangles

Parts are counted by label among the bodies of NNN.summary.json (what `roomgen create --json` prints: "bodies", each
with name, label, triangles and size); a label of several words counts as its last ("back cushion" is a cushion). A
group of the program NNN.json whose label none of its bodies bears, such as a back of posts and rails, counts as one
more. Shapes of parts are measured on the model itself: the summary's bodies are looked up in the GLB by their triangles
and size. Without "bodies", the copies that the program describes are counted, and shapes cannot be judged. Everything
else is measured on the GLB alone.
"""

import argparse
import json
import re
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
CHECKS = ("connected", "grounded", "stable", "size", "watertight", "light")
MOST_TRIANGLES = 20000
GROUND = 0.001


def word(label):
    return str(label or "").strip().lower().replace("-", " ").replace("_", " ")


def is_called(label, name):
    """A back cushion is a cushion, an oven door a door."""
    label = word(label)
    return label == name or label.endswith(" " + name)


def copies(operations):
    """How many bodies the operations of a component make of one."""
    count = 1
    for operation in operations or []:
        if "mirror" in operation:
            count *= 2
        elif "array" in operation:
            count *= int(operation["array"]["count"])
        elif "radial" in operation:
            count *= int(operation["radial"]["count"])
        elif operation.get("join"):
            count = 1
    return count


def program_bodies(program):
    """The labels of a concrete program's bodies, for a run whose summary does not list them."""

    def walk(components, label, many):
        for component in components:
            own = component.get("label", label)
            times = many * copies(component.get("operations"))
            group = component.get("group")
            if group is None:
                yield from ({"label": own} for _ in range(times))
            else:
                inner = list(walk(group["components"] if isinstance(group, dict) else group, own, 1))
                yield from inner * times

    return list(walk(program.get("components", []), None, 1))


def labelled_groups(program):
    """Groups whose label none of their bodies bears, such as a back made of posts and rails: label, copies, a pattern
    for the names of the bodies inside."""

    def components(group):
        return group["components"] if isinstance(group, dict) else group

    def bears(inner, label):
        for component in inner:
            own = component.get("label", label)
            if bears(components(component["group"]), own) if "group" in component else word(own) == word(label):
                return True
        return False

    def walk(inner, path, many):
        for component in inner:
            if "group" not in component:
                continue
            within = path + [re.escape(component["name"]) + r"(-\d+)?"]
            times = many * copies(component.get("operations"))
            if component.get("label") and not bears(components(component["group"]), component["label"]):
                yield component["label"], times, re.compile(r"\.".join(within) + r"\.")
            yield from walk(components(component["group"]), within, times)

    return list(walk(program.get("components", []), [], 1))


def part_failure(part, bodies, meshes):
    """What is wrong with a part that was asked for, or None."""
    from pieces import has_shape

    labels = {word(label) for label in part["label"].split("|")}
    mine = [index for index, body in enumerate(bodies) if any(is_called(body.get("label"), label) for label in labels)]
    count, wanted = len(mine), part["count"]
    if wanted is None:
        right = count >= 1
    elif isinstance(wanted, list):
        right = wanted[0] <= count <= wanted[1]
    else:
        right = count == wanted
    if not right:
        return f"{part['label']}: {count}, not {'at least one' if wanted is None else wanted}"
    if part.get("shape"):
        shapes = [meshes[index] for index in mine if meshes[index] is not None]
        if len(shapes) < len(mine):
            return f"{part['label']}: its shape cannot be measured (the model does not hold it as the summary says)"
        try:
            right = has_shape(part["shape"], shapes)
        except Exception as error:  # noqa: BLE001 - too thin for a hull, say
            return f"{part['label']}: its shape cannot be measured ({str(error).splitlines()[0]})"
        if not right:
            return f"{part['label']}: not {part['shape']}"
    return None


def read(path):
    try:
        return json.loads(path.read_text())
    except (OSError, ValueError):
        return None


def judge(entry, base):
    """Checks of one sentence: {"made": bool, "parts": (right, asked), check: bool or None, "failures": [...]}."""
    import pieces as geometry
    from drop import stands
    import numpy as np

    result = {"made": False, "parts": (0, len(entry["parts"])), "failures": []}
    result.update({check: False for check in CHECKS})
    if entry["mount"] in ("wall", "ceiling"):
        result["stable"] = None
    glb = Path(f"{base}.glb")
    if not glb.exists():
        said = (read(Path(f"{base}.result.json")) or {}).get("message", "")
        result["failures"].append("not made" + (f": {' '.join(said.split())[:160]}" if said else ""))
        return result
    try:
        parts = geometry.load(glb)
    except Exception as error:  # noqa: BLE001 - whatever is wrong with a file is that file's failure
        result["failures"].append(f"cannot be read: {error}")
        return result
    if not parts:
        result["failures"].append("is empty")
        return result
    result["made"] = True
    failures = result["failures"]

    summary = read(Path(f"{base}.summary.json")) or {}
    bodies = summary.get("bodies")
    program = read(Path(f"{base}.json")) or {}
    if bodies is None:
        bodies = program_bodies(program)
        meshes = [None] * len(bodies)
    else:
        meshes = geometry.assign(parts, bodies)
        lost = sum(mesh is None for mesh in meshes)
        if lost:
            failures.append(f"(note) {lost} of {len(bodies)} bodies of the summary are not in the model as described")
    for label, times, names in labelled_groups(program):
        inside = [mesh for body, mesh in zip(bodies, meshes) if mesh is not None and names.match(body.get("name", ""))]
        bodies = bodies + [{"label": label}] * times
        meshes = meshes + [np.concatenate(inside) if inside else None] * times
    wrong = [failure for failure in (part_failure(part, bodies, meshes) for part in entry["parts"]) if failure]
    result["parts"] = (len(entry["parts"]) - len(wrong), len(entry["parts"]))
    failures += wrong

    solids = []
    for part in parts:
        names = geometry.split(part)
        solids += [geometry.Piece(part[names == name]) for name in range(names.max() + 1)]
    solids = [solid for solid in solids if len(solid.faces)]
    if not solids:
        failures.append("has no surface")
        return result
    together = geometry.groups(solids)
    result["connected"] = len(together) == 1
    if len(together) > 1:
        loose = solids[together[-1][0]]
        middle = ", ".join(f"{value:.2f}" for value in (loose.low + loose.high) / 2)
        failures.append(f"not connected: {len(together)} groups of pieces, one loose at ({middle})")

    points = np.concatenate([part.reshape(-1, 3) for part in parts])
    low, extent = points.min(axis=0), np.ptp(points, axis=0)
    result["grounded"] = bool(abs(low[2]) <= GROUND)
    if not result["grounded"]:
        failures.append(f"not grounded: the lowest point is at {low[2] * 1000:.1f} mm")
    if result["stable"] is not None:
        try:
            result["stable"], how = stands(solids)
        except Exception as error:  # noqa: BLE001 - a shape that cannot be dropped does not stand
            result["stable"], how = False, str(error)
        if not result["stable"]:
            failures.append(f"not stable: {how}")
    outside = [
        f"{name} {value:.3f} m, not {least:g} to {most:g}"
        for name, value, (least, most) in zip(("width", "depth", "height"), extent, entry["size"])
        if not least - 0.002 <= value <= most + 0.002
    ]
    result["size"] = not outside
    if outside:
        failures.append("size: " + "; ".join(outside))
    open_pieces = sum(not piece.watertight for piece in solids)
    result["watertight"] = not open_pieces
    if open_pieces:
        failures.append(f"not watertight: {open_pieces} of {len(solids)} pieces")
    triangles = sum(len(part) for part in parts)
    result["triangles"] = triangles
    result["light"] = triangles <= MOST_TRIANGLES
    if not result["light"]:
        failures.append(f"{triangles} triangles")
    return result


def judge_refusal(entry, base):
    """What is wrong with a sentence that must be refused, or None."""
    result = read(Path(f"{base}.result.json"))
    if result is None:
        return "no result"
    code, message = result.get("exit"), result.get("message", "")
    if len(entry["prompt"].split()) > 3:
        message = message.replace(entry["prompt"], "")  # to repeat the sentence says nothing about it
    if code == 0 or Path(f"{base}.glb").exists():
        return "was made"
    if code is None or code < 0 or code > 125:
        return f"ended badly ({code}): {message[:100]}"
    if not any(mention.lower() in message.lower() for mention in entry["mention"]):
        return f"says none of {', '.join(entry['mention'])}: {' '.join(message.split())[:160]}"
    return None


def share(right, of):
    return f"{right}/{of} ({100 * right / of:.0f} %)" if of else "-"


def row(name, results):
    cells = [name, str(len(results)), share(sum(r["made"] for r in results), len(results))]
    cells.append(share(sum(r["parts"][0] for r in results), sum(r["parts"][1] for r in results)))
    cells.append(share(sum(r["made"] and r["parts"][0] == r["parts"][1] for r in results), len(results)))
    for check in CHECKS:
        asked = [r[check] for r in results if r[check] is not None]
        cells.append(share(sum(asked), len(asked)))
    cells.append(share(sum(perfect(r) for r in results), len(results)))
    return "| " + " | ".join(cells) + " |"


def perfect(result):
    return result["made"] and result["parts"][0] == result["parts"][1] and all(result[c] is not False for c in CHECKS)


def report(entries, results):
    titles = ["group", "sentences", "made", "parts right", "all parts", *CHECKS, "everything"]
    lines = ["| " + " | ".join(titles) + " |", "|" + "---|" * len(titles)]
    for group in ("common", "edge", "strange"):
        mine = [result for entry, result in zip(entries, results) if entry["group"] == group]
        if mine:
            lines.append(row(group, mine))
    lines.append(row("total", results))
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path, nargs="?")
    parser.add_argument("--prompts", type=Path, default=HERE / "prompts.json")
    parser.add_argument("--refused", type=Path, default=HERE / "refused.json")
    parser.add_argument("--only", help="numbers of prompts, from 1; leaves the refused ones out")
    parser.add_argument("--json", type=Path, help="write every check of every sentence to a file")
    parser.add_argument("--self-test", action="store_true")
    options = parser.parse_args()
    if options.self_test:
        from self_test import run

        sys.exit(run())
    if options.folder is None:
        parser.error("which folder?")
    entries = json.loads(options.prompts.read_text())
    numbers = [int(number) for number in options.only.split(",")] if options.only else list(range(1, len(entries) + 1))
    entries = [entries[number - 1] for number in numbers]
    results = [judge(entry, options.folder / f"{number:03d}") for number, entry in zip(numbers, entries)]
    print("\n".join(report(entries, results)))
    refused = []
    if not options.only and (options.folder / "refused").is_dir():
        for number, entry in enumerate(json.loads(options.refused.read_text()), 1):
            refused.append((number, entry, judge_refusal(entry, options.folder / "refused" / f"{number:03d}")))
        print(f"\nRefused with the right words: {share(sum(wrong is None for _, _, wrong in refused), len(refused))}")
    print("\nFailures:\n")
    for number, entry, result in zip(numbers, entries, results):
        for failure in result["failures"]:
            print(f"- {number:03d} ({entry['group']}) {entry['prompt']}: {failure}")
    for number, entry, wrong in refused:
        if wrong:
            print(f"- {number:03d} (refused) {entry['prompt'].strip() or '(empty)'}: {wrong}")
    if options.json:
        detail = [
            {"number": n, "prompt": e["prompt"], "group": e["group"], **r} for n, e, r in zip(numbers, entries, results)
        ]
        detail += [
            {"number": n, "prompt": e["prompt"], "group": "refused", "failure": wrong} for n, e, wrong in refused
        ]
        options.json.write_text(json.dumps(detail, indent=1, ensure_ascii=False) + "\n")


if __name__ == "__main__":
    main()
