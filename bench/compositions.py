#!/usr/bin/env python3
"""Compositions drawn from above, and checked by boxes.

    build/release/tests/composition/print_compositions [FILE...] > LINES
    bench/compositions.py LINES [FOLDER]       FOLDER: sheet-N.png of twelve drawings each (needs Pillow)

Faults are what stands in each other on the floor or on the wall (more than 2 cm, where neither tucks under the other),
what sticks out of the thing that it stands on or shares its place there, a kind that plans do not know, and what hangs
on the wall and is not flush with the group's back.
Ends with 1 where there are any.
"""
import json
import math
import sys
from itertools import combinations

BAND = 0.02           # metres that boxes may share
ROUND_SIDES = 24
COLUMNS, ROWS, CELL = 4, 3, 460  # of a sheet; pixels
USUAL_HEIGHT = 1.5    # metres to the middle of what hangs on a wall, unless told
COLORS = {"floor": (205, 220, 235), "surface": (250, 225, 150), "wall": (150, 190, 150), "ceiling": (235, 200, 235)}


def outline(member):
    """Corners, counter-clockwise from the back left as its sitter sees it."""
    w, d = member["size"][0] / 2, member["size"][1] / 2
    if member["round"]:
        turn = 2 * math.pi / ROUND_SIDES
        local = [(w * math.cos(i * turn), d * math.sin(i * turn)) for i in range(ROUND_SIDES)]
    else:
        local = [(w, d), (-w, d), (-w, -d), (w, -d)]
    return [to_group(member, point) for point in local]


def to_group(member, point):
    c, s = math.cos(member["yaw"]), math.sin(member["yaw"])
    return (member["position"][0] + c * point[0] - s * point[1], member["position"][1] + s * point[0] + c * point[1])


def shared(a, b):
    """How deep two convex outlines lie in each other, in metres."""
    least = math.inf
    for one in (a, b):
        for (x0, y0), (x1, y1) in zip(one, one[1:] + one[:1]):
            length = math.hypot(x1 - x0, y1 - y0)
            nx, ny = (y1 - y0) / length, (x0 - x1) / length
            spans = [[nx * x + ny * y for x, y in other] for other in (a, b)]
            least = min(least, min(max(spans[0]), max(spans[1])) - max(min(spans[0]), min(spans[1])))
    return least


def heights(member):
    tall = member["size"][2]
    if member["mount"] == "floor":
        return 0.0, tall
    middle = member.get("height", USUAL_HEIGHT)
    return middle - tall / 2, middle + tall / 2


def tucks(a, b):
    return any(kind in a["tucks_under"] for kind in b["kinds"]) or any(kind in b["tucks_under"] for kind in a["kinds"])


def name(member):
    return f"{member['part']} at {member['position'][0]:.2f}, {member['position'][1]:.2f}"


def overlaps(members):
    solid = [(m, outline(m), heights(m)) for m in members if m["mount"] in ("floor", "wall") and not m["flat"]]
    for (a, at_a, (low_a, high_a)), (b, at_b, (low_b, high_b)) in combinations(solid, 2):
        if min(high_a, high_b) - max(low_a, low_b) <= BAND or tucks(a, b):
            continue
        if (depth := shared(at_a, at_b)) > BAND:
            yield f"{name(a)} and {name(b)} share {depth:.2f} m"


def on_surfaces(members):
    carried = [(m, outline(m)) for m in members if m["mount"] == "surface"]
    for member, corners in carried:
        carrier = members[member["on"]]
        turned = {"position": [0, 0], "yaw": -carrier["yaw"]}
        w, d = carrier["size"][0] / 2, carrier["size"][1] / 2
        for x, y in corners:
            x, y = to_group(turned, (x - carrier["position"][0], y - carrier["position"][1]))
            out = math.hypot(x / w, y / d) > 1.01 if carrier["round"] else abs(x) > w + 1e-3 or abs(y) > d + 1e-3
            if out:
                yield f"{name(member)} sticks out of {name(carrier)}"
                break
    for (a, at_a), (b, at_b) in combinations(carried, 2):
        if a["on"] == b["on"] and (depth := shared(at_a, at_b)) > BAND:
            yield f"{name(a)} and {name(b)} share {depth:.2f} m on {members[a['on']]['part']}"


def kinds(members):
    for member in members:
        if member["category"] != (member["kinds"] or [""])[0]:
            yield f"{name(member)}: \"{member['category']}\" is planned as \"{(member['kinds'] or [''])[0]}\""


def on_walls(members):
    standing = [m for m in members if m["mount"] in ("floor", "wall") and not m["flat"]]
    back = max(y for m in standing for _, y in outline(m))
    for member in standing:
        if member["mount"] == "wall" and abs(max(y for _, y in outline(member)) - back) > BAND:
            yield f"{name(member)} hangs {back - max(y for _, y in outline(member)):.2f} m before the group's back"


def faults(line):
    members = line["members"]
    return [*kinds(members), *overlaps(members), *on_surfaces(members), *on_walls(members)]


def title(line):
    setting = ", ".join(f"{key} {value:g}" if isinstance(value, float) else f"{key} {value}"
                        for key, value in line["with"].items())
    return line["composition"] + (f" ({setting})" if setting else "")


def draw(drawing, font, line, corner):
    members = sorted(line["members"], key=lambda m: (not m["flat"], "floor wall surface ceiling".index(m["mount"])))
    points = [p for m in members for p in outline(m)]
    low = [min(p[i] for p in points) for i in (0, 1)]
    high = [max(p[i] for p in points) for i in (0, 1)]
    scale = min((CELL - 30) / (high[0] - low[0]), (CELL - 60) / (high[1] - low[1]), 160)

    def pixel(point):
        return (corner[0] + 15 + scale * (point[0] - low[0]), corner[1] + 45 + scale * (high[1] - point[1]))

    for m in members:
        fill = (245, 235, 225) if m["flat"] else None if m["mount"] == "ceiling" else COLORS[m["mount"]]
        drawing.polygon([pixel(p) for p in outline(m)], fill=fill, outline=(90, 90, 90))
        if m["mount"] in ("floor", "surface") and not m["flat"]:
            tip, base = to_group(m, (0, -m["size"][1] / 2)), to_group(m, (0, -m["size"][1] / 4))
            drawing.line([pixel(base), pixel(tip)], fill=(200, 40, 40), width=2)
    for m in members:
        if m["size"][0] * scale > 26 and m["mount"] != "ceiling" or m["mount"] == "wall":
            text = m["category"] + (f" ~{m['spare']}" if m["spare"] else "")
            x, y = pixel(m["position"])
            drawing.text((x - 2.4 * len(text), y - 5), text, fill=(20, 20, 20), font=font)
    size = f"{high[0] - low[0]:.1f} x {high[1] - low[1]:.1f} m, {len(members)} things, {line['alternatives']} ways"
    drawing.text((corner[0] + 6, corner[1] + 4), title(line), fill=(0, 0, 140), font=font)
    drawing.text((corner[0] + 6, corner[1] + 18), size, fill=(90, 90, 90), font=font)


def sheets(lines, folder):
    from PIL import Image, ImageDraw, ImageFont
    font = ImageFont.load_default(10)
    for first in range(0, len(lines), COLUMNS * ROWS):
        image = Image.new("RGB", (COLUMNS * CELL, ROWS * CELL), "white")
        for i, line in enumerate(lines[first:first + COLUMNS * ROWS]):
            draw(ImageDraw.Draw(image), font, line, (i % COLUMNS * CELL, i // COLUMNS * CELL))
        image.save(f"{folder}/sheet-{first // (COLUMNS * ROWS) + 1}.png")


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        lines = [json.loads(line) for line in file]
    if len(sys.argv) > 2:
        sheets([line for line in lines if not line["with"]], sys.argv[2])
    found = [f"{title(line)}: {fault}" for line in lines for fault in faults(line)]
    print("\n".join(found))
    print(f"{len({line['composition'] for line in lines})} compositions, {len(lines)} settings, {len(found)} faults")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
