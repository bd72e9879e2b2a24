#!/usr/bin/env python3
"""Compositions drawn from above, and checked by boxes.

    build/release/tests/composition/print_compositions [FILE...] > LINES
    bench/compositions.py LINES [FOLDER]       FOLDER: sheets of all settings (needs Pillow)

Faults are what stands in each other on the floor or on the wall (more than 2 cm, where neither
tucks under the other), what sticks out of the thing that it stands on or shares its place there, a
kind that plans do not know, what hangs on the wall and is flush with nothing of its back, a seat at
a table that cannot be drawn back, and what stands on a rug with one half.
Ends with 1 where there are any.
"""
import json
import math
import sys
from itertools import combinations

BAND = 0.02           # metres that boxes may share
BEHIND = 0.55         # metres that a seat at a table is drawn back by who gets up
ROUND_SIDES = 24
COLUMNS, ROWS, CELL = 4, 4, 390  # of a sheet; pixels
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


def lies_in(member, point, band=0.0):
    """Whether a point of the group's frame is within the outline of a thing."""
    turned = {"position": [0, 0], "yaw": -member["yaw"]}
    w, d = member["size"][0] / 2, member["size"][1] / 2
    x, y = to_group(turned, (point[0] - member["position"][0], point[1] - member["position"][1]))
    if member["round"]:
        return math.hypot(x / w, y / d) <= 1 + 10 * band
    return abs(x) <= w + band and abs(y) <= d + band


def on_surfaces(members):
    carried = [(m, outline(m)) for m in members if m["mount"] == "surface"]
    for member, corners in carried:
        carrier = members[member["on"]]
        if not all(lies_in(carrier, point, 1e-3) for point in corners):
            yield f"{name(member)} sticks out of {name(carrier)}"
    for (a, at_a), (b, at_b) in combinations(carried, 2):
        if a["on"] == b["on"] and (depth := shared(at_a, at_b)) > BAND:
            yield f"{name(a)} and {name(b)} share {depth:.2f} m on {members[a['on']]['part']}"


def kinds(members):
    for member in members:
        if member["category"] != (member["kinds"] or [""])[0]:
            yield f"{name(member)}: \"{member['category']}\" is planned as \"{(member['kinds'] or [''])[0]}\""


def on_walls(members):
    """A wall is where the backs of all that looks one way end: a kitchen in an L has two."""
    standing = [m for m in members if m["mount"] in ("floor", "wall") and not m["flat"]]
    for member in standing:
        if member["mount"] != "wall":
            continue
        turn = {"position": [0, 0], "yaw": -member["yaw"]}
        own = max(to_group(turn, point)[1] for point in outline(member))
        back = max(to_group(turn, point)[1] for m in standing for point in outline(m))
        if back - own > BAND:
            yield f"{name(member)} hangs {back - own:.2f} m before the group's back"


def is_seat_at_table(member, solid):
    """A chair or stool whose front is under the edge of something, or at it."""
    kinds = set(member["kinds"])
    if not {"chair", "stool"} & kinds or {"theatre seat", "armchair"} & kinds:
        return False
    front = strip(member, -1, 0.12)
    return any(other is not member and tucks(member, other) and shared(front, outline(other)) > 0
               for other in solid)


def strip(member, side, depth):
    """The floor before (-1) or behind (1) a thing, as wide as four fifths of it."""
    w, d = 0.4 * member["size"][0], member["size"][1] / 2
    near, far = sorted((side * d, side * (d + depth)))
    return [to_group(member, point) for point in ((w, far), (-w, far), (-w, near), (w, near))]


def seats(members):
    solid = [m for m in members if m["mount"] == "floor" and not m["flat"]]
    for member in solid:
        if not is_seat_at_table(member, solid):
            continue
        behind = strip(member, 1, BEHIND)
        for other in solid:
            if other is member or "parasol" in other["kinds"]:  # a canopy overhead
                continue
            if shared(outline(member), outline(other)) > BAND:  # the top that it sits at
                continue
            if (depth := shared(behind, outline(other))) > BAND:
                yield f"{name(member)} has {BEHIND - depth:.2f} m to {name(other)} behind it"


def rugs(members):
    """Beds do: feet come down on the rug, heads need none."""
    solid = [m for m in members if m["mount"] == "floor" and not m["flat"]]
    for rug in (m for m in members if m["flat"]):
        for member in solid:
            inside = [lies_in(rug, point) for point in outline(member)]
            if "bed" not in member["kinds"] and any(inside) and not all(inside):
                yield f"{name(member)} stands partly on {name(rug)}"


def faults(line):
    members = line["members"]
    return [*kinds(members), *overlaps(members), *on_surfaces(members), *on_walls(members), *seats(members),
            *rugs(members)]


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
        sheets(lines, sys.argv[2])
    found = [f"{title(line)}: {fault}" for line in lines for fault in faults(line)]
    print("\n".join(found))
    print(f"{len({line['composition'] for line in lines})} compositions, {len(lines)} settings, {len(found)} faults")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
