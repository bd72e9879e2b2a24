#!/usr/bin/env python3
"""Makes problems for `roomgen solve` whose solution is known to exist.

Every room is furnished first, by rules a person would use and with some slack everywhere; then the
constraints are read off that layout. So each problem comes with a witness (a scene.json in the
folder `witness`) in which everything is placed and every constraint holds. `witness/index.json`
says for each problem what can be reached; only the problems of the kind `impossible` lose something.
"""

import argparse
import json
import math
import random
import sys
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, field, replace
from pathlib import Path

from shapely.geometry import Polygon

from roomgen_checker import files, geometry as geo, reach, report, rules
from roomgen_checker.constraints import Judge, parse

# Typical sizes, metres (width, depth, height).
SIZES = {
    "bed": (1.6, 2.05, 0.9),
    "single bed": (0.9, 2.0, 0.85),
    "nightstand": (0.45, 0.4, 0.55),
    "bench": (1.0, 0.4, 0.45),
    "wardrobe": (1.2, 0.6, 2.0),
    "dresser": (1.0, 0.45, 0.85),
    "desk": (1.2, 0.6, 0.74),
    "office chair": (0.58, 0.58, 0.95),
    "armchair": (0.8, 0.8, 0.85),
    "floor lamp": (0.35, 0.35, 1.6),
    "plant": (0.4, 0.4, 0.9),
    "bookshelf": (0.9, 0.32, 1.9),
    "sofa": (2.1, 0.9, 0.85),
    "coffee table": (1.1, 0.6, 0.42),
    "tv stand": (1.6, 0.42, 0.5),
    "side table": (0.45, 0.45, 0.55),
    "console table": (1.2, 0.38, 0.8),
    "ottoman": (0.55, 0.55, 0.45),
    "dining table": (1.6, 0.9, 0.75),
    "chair": (0.46, 0.5, 0.9),
    "sideboard": (1.5, 0.45, 0.85),
    "china cabinet": (1.0, 0.42, 1.9),
    "bar cart": (0.7, 0.42, 0.85),
    "counter": (0.9, 0.6, 0.9),
    "sink": (0.8, 0.6, 0.9),
    "stove": (0.6, 0.6, 0.9),
    "refrigerator": (0.7, 0.68, 1.8),
    "cabinet": (0.8, 0.42, 1.8),
    "toilet": (0.38, 0.68, 0.8),
    "vanity": (0.8, 0.5, 0.85),
    "bathtub": (1.7, 0.75, 0.58),
    "shower": (0.9, 0.9, 2.0),
    "washing machine": (0.6, 0.6, 0.85),
    "laundry basket": (0.4, 0.4, 0.6),
    "filing cabinet": (0.45, 0.6, 0.75),
}
# Room to leave before things of which the categories may know nothing yet.
MORE_ZONES = {
    "counter": 1.07,
    "sink": 1.07,
    "stove": 1.07,
    "refrigerator": 1.07,
    "toilet": 0.6,
    "vanity": 0.6,
    "bathtub": 0.6,
    "shower": 0.6,
    "washing machine": 0.9,
    "filing cabinet": 0.75,
}
# How many of a kind a room of 20 m2 is filled up with; twos of other things.
FILL_MOST = {
    "washing machine": 1,
    "vanity": 1,
    "laundry basket": 1,
    "bar cart": 1,
    "tv stand": 1,
    "bookshelf": 4,
    "counter": 4,
    "armchair": 3,
    "chair": 3,
    "filing cabinet": 4,
}
ZONE_MARGIN = 1.08
WALK_MARGIN = -0.02
AT_WALL_GAP = 0.01
PLACE_MARGIN = 0.03


def roomy(categories):
    """The known use zones, all somewhat deeper, and those of things not known yet."""
    entries = json.loads(json.dumps(categories.entries))
    for name, depth in MORE_ZONES.items():
        if not categories.zones(name):
            entries[name] = {"zones": [{"side": "front", "depth": depth}]}
    for entry in entries.values():
        for zone in entry.get("zones", []):
            zone["depth"] *= ZONE_MARGIN
    return files.Categories({"kinds": entries})


@dataclass
class Part:
    """A thing of a group that is about to be placed; wishes name others by `{key}`."""

    key: str
    category: str
    size: tuple
    centre: tuple
    yaw: float
    wishes: list = field(default_factory=list)


@dataclass
class Layout:
    """A room that is being furnished."""

    room: files.Room
    random: random.Random
    categories: files.Categories
    things: list = field(default_factory=list)
    wishes: dict = field(default_factory=dict)

    def scene(self, things=None):
        return files.Scene("", self.room, self.things if things is None else things)

    @property
    def fill(self):
        return sum(t.box.area for t in self.things) / self.room.polygon.area

    def all_of(self, *categories):
        return [t for t in self.things if t.category in categories]

    def size(self, category, spread=0.08):
        """A typical size, varied a little, in whole centimetres."""
        w, d, h = SIZES[category]
        vary = lambda v: round(v * self.random.uniform(1 - spread, 1 + spread), 2)
        return vary(w), vary(d), vary(h)

    def wall(self):
        """Any wall, the longer the likelier."""
        return self.random.choices(self.room.walls, [w.length for w in self.room.walls])[0]

    def place_at(self, wall, along, size, gap=AT_WALL_GAP):
        """(centre, yaw) of a thing with its back at a wall."""
        return wall.point(along, size[1] / 2 + gap), geo.yaw_looking(wall.inward)

    def anywhere_at_wall(self, size, corners=0.3):
        """(centre, yaw) somewhere at a wall, often pushed into one of its ends."""
        wall = self.wall()
        low, high = size[0] / 2, wall.length - size[0] / 2
        if high <= low:
            return None
        along = (
            self.random.choice((low + AT_WALL_GAP, high - AT_WALL_GAP))
            if self.random.random() < corners
            else self.random.uniform(low, high)
        )
        return self.place_at(wall, along, size)

    def anywhere(self):
        x0, y0, x1, y1 = self.room.polygon.bounds
        return self.random.uniform(x0, x1), self.random.uniform(y0, y1)

    def as_things(self, parts):
        """Things with ids for the parts, and what their wishes are with names filled in."""
        count, names, things = {}, {}, []
        for p in parts:
            number = count.get(p.category, len(self.all_of(p.category)))
            count[p.category] = number + 1
            names[p.key] = f"{p.category}-{number}"
            things.append(
                files.Thing(
                    names[p.key],
                    p.category,
                    p.size,
                    (*(round(c, 4) for c in p.centre), 0.0),
                    math.radians(round(math.degrees(p.yaw) % 360, 4)),
                )
            )
        return things, {names[p.key]: [w.format(**names) for w in p.wishes] for p in parts}

    def fits(self, new):
        """Whether a layout with the new things is valid, with slack."""
        s = self.scene(self.things + new)
        if rules.check_inside(s) or rules.check_doors(s) or rules.check_windows(s):
            return False
        if any(rules.overlap_reason(a, b, None) for a in new for b in s.things if a is not b):
            return False
        if not all(self.has_free_zone(t, s) for t in s.things):
            return False
        walk = reach.WalkMap(s, WALK_MARGIN)
        return not reach.check_connected(s, walk) and not reach.check_usable(s, self.categories, walk)

    def has_free_zone(self, thing, scene):
        zones = self.categories.zones(thing.category)
        return not zones or any(
            not reach.zone_blockers(
                thing, z, geo.side_rectangle(thing, z["side"], z["depth"]), scene, self.categories, slack=0
            )
            for z in zones
        )

    def add(self, make, attempts=60):
        """Places the group that `make` proposes, if one of some proposals fits."""
        for _ in range(attempts):
            parts = make(self)
            if not parts:
                continue
            things, wishes = self.as_things(parts)
            if self.fits(things):
                self.things += things
                self.wishes.update(wishes)
                return True
        return False


def beside(centre, yaw, dx, dy):
    """A point given in the frame of a thing."""
    return geo.to_world((dx, dy), centre, yaw)


# --- groups ------------------------------------------------------------------------------------


def at_wall(category, *wishes, corners=0.3):
    """One thing with its back at a wall."""

    def make(layout):
        size = layout.size(category)
        place = layout.anywhere_at_wall(size, corners)
        return place and [Part("a", category, size, *place, ["edge", *wishes])]

    return make


def in_corner(category, *wishes):
    def make(layout):
        size = layout.size(category)
        place = layout.anywhere_at_wall(size, corners=1.0)
        return place and [Part("a", category, size, *place, ["corner", *wishes])]

    return make


def bed(category="bed", stands=2, foot=False):
    #     +--+------+--+
    #     |n1| bed  |n0|      n0 on the bed's left (its front looks down)
    #     +--+      +--+
    #        +------+
    #        [bench ]
    def make(layout):
        size, stand = layout.size(category), layout.size("nightstand")
        place = layout.anywhere_at_wall(size, corners=0.1 if stands == 2 else 0.6)
        if not place:
            return None
        parts = [Part("bed", category, size, *place, ["edge"])]
        back = size[1] / 2 - stand[1] / 2
        sides = layout.random.sample(((1, "left of"), (-1, "right of")), stands)
        for k, (sign, word) in enumerate(sides):
            centre = beside(*place, sign * (size[0] / 2 + stand[0] / 2 + 0.03), back)
            parts.append(
                Part(
                    f"n{k}",
                    "nightstand",
                    stand,
                    centre,
                    place[1],
                    ["edge", "near, {bed}", f"{word}, {{bed}}", "face same as, {bed}"],
                )
            )
        if foot:
            bench = layout.size("bench")
            centre = beside(*place, 0, -size[1] / 2 - bench[1] / 2 - 0.05)
            parts.append(
                Part(
                    "bench",
                    "bench",
                    bench,
                    centre,
                    place[1],
                    ["middle", "near, {bed}", "in front of, {bed}", "aligned, {bed}"],
                )
            )
        return parts

    return make


def opposite(category, target, *wishes):
    """At the wall that a target looks at, and looking back at it."""

    def make(layout):
        targets = layout.all_of(*target)
        if not targets:
            return None
        t, size = layout.random.choice(targets), layout.size(category)
        place = layout.anywhere_at_wall(size, corners=0.0)
        if not place:
            return None
        local = geo.to_local(place[0], t.centre, t.yaw)
        if local[1] > -1.0 or abs(local[0]) > t.size[0] / 2:
            return None
        return [
            Part(
                "a",
                category,
                size,
                *place,
                ["edge", f"in front of, {t.id}", f"face to, {t.id}", f"face opposite to, {t.id}", *wishes],
            )
        ]

    return make


def desk_and_chair(layout):
    #     +--------+
    #     |  desk  |
    #     +--------+
    #       [chair]  looks at it
    size, chair = layout.size("desk"), layout.size("office chair")
    place = layout.anywhere_at_wall(size)
    if not place:
        return None
    centre = beside(*place, 0, -size[1] / 2 - chair[1] / 2 - 0.06)
    return [
        Part("desk", "desk", size, *place, ["edge"]),
        Part(
            "chair",
            "office chair",
            chair,
            centre,
            place[1] + math.pi,
            ["middle", "near, {desk}", "in front of, {desk}", "face to, {desk}"],
        ),
    ]


def sofa_group(chairs=2, free=False, side=True):
    #     [side]+----------+
    #           |   sofa   |
    #           +----------+
    #      <A1   [ coffee ]   A0>      the chairs look at the coffee table
    def make(layout):
        size, table = layout.size("sofa"), layout.size("coffee table")
        if free:
            wall = layout.wall()
            place = layout.place_at(
                wall, layout.random.uniform(0, wall.length), size, layout.random.uniform(0.75, 1.6)
            )
        else:
            place = layout.anywhere_at_wall(size, corners=0.2)
        if not place:
            return None
        parts = [Part("sofa", "sofa", size, *place, ["middle"] if free else ["edge"])]
        down = -size[1] / 2 - 0.45 - table[1] / 2
        parts.append(
            Part(
                "coffee",
                "coffee table",
                table,
                beside(*place, 0, down),
                place[1],
                ["middle", "near, {sofa}", "in front of, {sofa}", "aligned, {sofa}"],
            )
        )
        for k, (sign, word) in enumerate(((1, "left of"), (-1, "right of"))[:chairs]):
            chair = layout.size("armchair")
            # A little forward, so that one can walk between sofa and chair.
            out = sign * (table[0] / 2 + 0.48 + chair[1] / 2)
            parts.append(
                Part(
                    f"chair{k}",
                    "armchair",
                    chair,
                    beside(*place, out, down - 0.2),
                    place[1] - sign * math.pi / 2,
                    ["near, {coffee}", f"{word}, {{coffee}}", "face to, {coffee}"],
                )
            )
        if side:
            small = layout.size("side table")
            sign = layout.random.choice((1, -1))
            centre = beside(*place, sign * (size[0] / 2 + small[0] / 2 + 0.04), size[1] / 2 - small[1] / 2)
            parts.append(
                Part(
                    "side", "side table", small, centre, place[1], ["edge", "near, {sofa}", "side of, {sofa}"]
                )
            )
        return parts

    return make


def dining_group(chairs, turned=True):
    #         [c][c]
    #     [c] +-----+ [c]
    #         |table|
    #         +-----+
    #         [c][c]
    def make(layout):
        long_side = max(1, (chairs - (2 if chairs > 4 else 0) + 1) // 2)
        size = list(layout.size("dining table"))
        size[0] = round(max(0.8, 0.62 * long_side + 0.1), 2)
        chair = layout.size("chair")
        along = layout.wall()
        place = (
            layout.anywhere(),
            geo.yaw_looking(along.inward) + (layout.random.choice((0, math.pi / 2)) if turned else 0),
        )
        parts = [Part("table", "dining table", tuple(size), *place, ["middle"])]
        spots = seats(tuple(size), chair, chairs, long_side)
        for k, (x, y, yaw) in enumerate(spots):
            parts.append(
                Part(
                    f"c{k}",
                    "chair",
                    chair,
                    beside(*place, x, y),
                    place[1] + yaw,
                    ["middle", "around, {table}"]
                    + ([f"aligned, {{c{k - 2}}}"] if k >= 2 and k % 2 == 0 else []),
                )
            )
        return parts

    return make


def seats(table, chair, count, long_side):
    """(x, y, yaw) of chairs in the table's frame: along both long sides, then at the ends."""
    w, d = table[:2]
    out, spots = d / 2 + chair[1] / 2 + 0.04, []
    for k in range(long_side):
        x = (k + 0.5) * w / long_side - w / 2
        spots += [(x, -out, math.pi), (x, out, 0.0)]
    end = w / 2 + chair[1] / 2 + 0.04
    spots = spots[:count] + [(end, 0.0, -math.pi / 2), (-end, 0.0, math.pi / 2)]
    return spots[:count]


def kitchen_run(*row):
    #     +--------+------+-------+-------+
    #     | fridge | sink | count | stove |   a row along one wall
    #     +--------+------+-------+-------+
    def make(layout):
        sizes = [layout.size(c, 0.04) for c in row]
        total = sum(s[0] for s in sizes) + 0.02 * len(row)
        wall = layout.wall()
        if wall.length < total + 0.02:
            return None
        begin = layout.random.choice(
            (0.01, wall.length - total - 0.01, layout.random.uniform(0.01, wall.length - total))
        )
        parts = []
        for k, (category, size) in enumerate(zip(row, sizes)):
            centre, yaw = layout.place_at(wall, begin + size[0] / 2, size)
            begin += size[0] + 0.02
            wishes = (
                ["edge"]
                if k == 0
                else ["edge", f"near, {{p{k - 1}}}", f"side of, {{p{k - 1}}}", f"face same as, {{p{k - 1}}}"]
            )
            parts.append(Part(f"p{k}", category, size, centre, yaw, wishes))
        return parts

    return make


def lamp_by_seat(layout):
    """A lamp beside some seat."""
    targets = layout.all_of("armchair", "sofa", "bed")
    if not targets:
        return None
    t, size = layout.random.choice(targets), layout.size("floor lamp")
    sign = layout.random.choice((1, -1))
    centre = beside(
        t.centre,
        t.yaw,
        sign * (t.size[0] / 2 + size[0] / 2 + 0.06),
        t.size[1] / 2 - size[1] / 2 - layout.random.uniform(0, 0.2),
    )
    return [Part("lamp", "floor lamp", size, centre, t.yaw, [f"near, {t.id}", f"side of, {t.id}"])]


def reading_chair(layout):
    #    [armchair] [side]  somewhere free, looking at another thing
    targets = layout.things
    if not targets:
        return None
    t, size = layout.random.choice(targets), layout.size("armchair")
    centre = layout.anywhere()
    yaw = geo.yaw_looking((t.centre[0] - centre[0], t.centre[1] - centre[1]))
    yaw = round(yaw / (math.pi / 2)) * math.pi / 2 if layout.random.random() < 0.8 else yaw
    return [Part("chair", "armchair", size, centre, yaw, ["middle", f"face to, {t.id}"])]


def shelves(count, category="bookshelf"):
    """A row of equal things at a wall."""

    def make(layout):
        size = layout.size(category)
        wall = layout.wall()
        total = count * (size[0] + 0.01)
        if wall.length < total:
            return None
        begin = layout.random.uniform(0, wall.length - total)
        parts = []
        for k in range(count):
            place = layout.place_at(wall, begin + (k + 0.5) * (size[0] + 0.01), size)
            wishes = ["edge"] + (
                [f"near, {{s{k - 1}}}", f"side of, {{s{k - 1}}}", f"aligned, {{s{k - 1}}}"] if k else []
            )
            parts.append(Part(f"s{k}", category, size, *place, wishes))
        return parts

    return make


def desk_row(count):
    #     [desk][desk][desk]
    #      [c]   [c]   [c]       free in the room, all the same way
    def make(layout):
        desk, chair = layout.size("desk"), layout.size("office chair")
        yaw = geo.yaw_looking(layout.wall().inward)
        centre, parts = layout.anywhere(), []
        for k in range(count):
            x = (k - (count - 1) / 2) * (desk[0] + 0.02)
            spot = beside(centre, yaw, x, 0)
            wishes = ["middle"] + (
                [f"near, {{d{k - 1}}}", f"side of, {{d{k - 1}}}", f"face same as, {{d{k - 1}}}"] if k else []
            )
            parts.append(Part(f"d{k}", "desk", desk, spot, yaw, wishes))
        for k in range(count):
            spot = beside(parts[k].centre, yaw, 0, -desk[1] / 2 - chair[1] / 2 - 0.06)
            parts.append(
                Part(
                    f"c{k}",
                    "office chair",
                    chair,
                    spot,
                    yaw + math.pi,
                    [f"near, {{d{k}}}", f"in front of, {{d{k}}}", f"face to, {{d{k}}}"],
                )
            )
        return parts

    return make


FILLERS = {
    "bedroom": [
        at_wall("dresser"),
        at_wall("wardrobe"),
        at_wall("bookshelf"),
        in_corner("plant"),
        lamp_by_seat,
        at_wall("console table"),
        reading_chair,
        at_wall("ottoman"),
        desk_and_chair,
    ],
    "living room": [
        at_wall("bookshelf"),
        shelves(2),
        in_corner("plant"),
        lamp_by_seat,
        reading_chair,
        at_wall("sideboard"),
        at_wall("console table"),
        at_wall("side table"),
        at_wall("ottoman"),
        desk_and_chair,
        at_wall("bench"),
        at_wall("china cabinet"),
    ],
    "dining room": [
        at_wall("sideboard"),
        at_wall("china cabinet"),
        at_wall("bar cart"),
        in_corner("plant"),
        at_wall("console table"),
        at_wall("chair"),
        at_wall("bookshelf"),
    ],
    "kitchen": [
        at_wall("cabinet"),
        kitchen_run("counter", "counter"),
        at_wall("counter"),
        in_corner("plant"),
        at_wall("bar cart"),
        at_wall("chair"),
        at_wall("sideboard"),
        at_wall("washing machine"),
    ],
    "bathroom": [
        at_wall("cabinet"),
        in_corner("laundry basket"),
        at_wall("washing machine"),
        in_corner("plant"),
        at_wall("vanity"),
        at_wall("bench"),
        at_wall("dresser"),
    ],
    "office": [
        shelves(2),
        at_wall("filing cabinet"),
        in_corner("plant"),
        at_wall("bookshelf"),
        at_wall("cabinet"),
        reading_chair,
        desk_and_chair,
    ],
}

RECIPES = {
    "bedroom": [bed(foot=True), at_wall("wardrobe"), desk_and_chair, opposite("dresser", ["bed"])],
    "small bedroom": [bed(stands=1), at_wall("wardrobe")],
    "children's room": [bed("single bed", 1), bed("single bed", 0), at_wall("wardrobe"), desk_and_chair],
    "living room": [sofa_group(2), opposite("tv stand", ["sofa"])],
    "open living room": [sofa_group(1, free=True, side=False), shelves(2), reading_chair],
    "dining room": [dining_group(6), at_wall("sideboard"), at_wall("china cabinet")],
    "small dining room": [dining_group(4), at_wall("sideboard")],
    "great dining room": [dining_group(10), shelves(2, "china cabinet"), at_wall("sideboard")],
    "kitchen": [kitchen_run("refrigerator", "counter", "sink", "stove"), kitchen_run("counter", "counter")],
    "eat-in kitchen": [kitchen_run("refrigerator", "sink", "counter", "stove"), dining_group(4)],
    "bathroom": [in_corner("bathtub"), at_wall("toilet"), at_wall("vanity")],
    "shower room": [in_corner("shower"), at_wall("toilet"), at_wall("vanity")],
    "office": [desk_row(3), desk_row(2), shelves(3)],
    "study": [desk_and_chair, shelves(2), reading_chair],
    "studio": [bed(stands=1), sofa_group(0, side=True), dining_group(2), at_wall("wardrobe")],
    "living and dining": [
        sofa_group(2),
        opposite("tv stand", ["sofa"]),
        dining_group(6),
        at_wall("sideboard"),
    ],
    "restaurant": [
        dining_group(4),
        dining_group(4),
        dining_group(4),
        dining_group(4),
        dining_group(2),
        dining_group(2),
        at_wall("sideboard"),
    ],
    "open office": [desk_row(3), desk_row(3), desk_row(3), desk_row(3), shelves(3)],
    "lounge": [sofa_group(2), sofa_group(2, free=True), dining_group(4), shelves(3)],
    "one thing": [],
}

# --- rooms -------------------------------------------------------------------------------------


def outline(shape, w, d):
    """The corners of a room of some shape within w x d metres."""
    return {
        "rectangle": [(0, 0), (w, 0), (w, d), (0, d)],
        "l": [(0, 0), (w, 0), (w, 0.55 * d), (0.55 * w, 0.55 * d), (0.55 * w, d), (0, d)],
        "t": [
            (0.25 * w, 0),
            (0.75 * w, 0),
            (0.75 * w, 0.5 * d),
            (w, 0.5 * d),
            (w, d),
            (0, d),
            (0, 0.5 * d),
            (0.25 * w, 0.5 * d),
        ],
        "u": [
            (0, 0),
            (w, 0),
            (w, d),
            (0.67 * w, d),
            (0.67 * w, 0.5 * d),
            (0.33 * w, 0.5 * d),
            (0.33 * w, d),
            (0, d),
        ],
        "slanted": [(0, 0), (w, 0), (w, 0.6 * d), (0.7 * w, d), (0, d)],
        "trapezoid": [(0, 0), (w, 0), (0.85 * w, d), (0.1 * w, d)],
        "octagon": [
            (0.25 * w, 0),
            (0.75 * w, 0),
            (w, 0.25 * d),
            (w, 0.75 * d),
            (0.75 * w, d),
            (0.25 * w, d),
            (0, 0.75 * d),
            (0, 0.25 * d),
        ],
    }[shape]


def turned(corners, degrees):
    yaw = math.radians(degrees)
    return [geo.rotate(x, y, yaw) for x, y in corners]


def choose_segment(walls, rng, width, taken, margin=0.12):
    """A free piece of some wall, as (wall, from, to)."""
    for _ in range(200):
        wall = rng.choices(walls, [w.length for w in walls])[0]
        if wall.length < width + 2 * margin:
            continue
        begin = round(rng.uniform(margin, wall.length - width - margin), 2)
        if all(t[0] is not wall or begin > t[2] + 0.1 or begin + width < t[1] - 0.1 for t in taken):
            return wall, begin, begin + width
    return None


def segment_json(piece):
    wall, begin, end = piece
    return {"segment": [[round(c, 4) for c in wall.point(b)] for b in (begin, end)]}


def empty_problem(name, kind, corners, rng, doors=1, windows=1, door_width=0.9):
    """A problem without objects: openings at random, no two overlapping."""
    corners = [[round(c, 3) for c in p] for p in corners]
    walls, taken = files.make_walls(corners), []
    problem = {
        "name": name,
        "room_type": kind,
        "units": "m",
        "room": corners,
        "height": 2.7,
        "doors": [],
        "windows": [],
        "objects": [],
    }
    for key, count, width in (("doors", doors, door_width), ("windows", windows, None)):
        for _ in range(count):
            piece = choose_segment(walls, rng, width or rng.choice((0.8, 1.2, 1.6)), taken)
            if piece:
                taken.append(piece)
                problem[key].append(segment_json(piece))
    for window in problem["windows"]:
        if rng.random() < 0.2:
            window["sill"] = 0.4
    for door in problem["doors"]:
        swing = rng.choice(("in", "in", "in", "out", "sliding"))
        if swing != "in":
            door["swing"] = swing
    return problem


# --- constraints read off the layout ---------------------------------------------------------------


def firmly_holds(layout, thing, text, companions):
    """Whether a constraint holds and still does a little to all sides; edges are exact anyway."""
    exact = parse(text).name in ("edge", "corner", "aligned", "center aligned")
    shifts = (
        [(0, 0)]
        if exact
        else [(0, 0), (PLACE_MARGIN, 0), (-PLACE_MARGIN, 0), (0, PLACE_MARGIN), (0, -PLACE_MARGIN)]
    )
    for dx, dy in shifts:
        x, y, z = thing.position
        moved = replace(thing, position=(x + dx, y + dy, z), relations=tuple(companions))
        others = [moved if t.id == thing.id else t for t in layout.things]
        if not Judge(layout.scene(others)).holds(moved, parse(text)):
            return False
    return True


def guesses(layout, thing, earlier):
    """Constraints that a designer might also have written about a thing."""
    targets = [t.id for t in earlier] + [o.id for o in layout.room.openings]
    layout.random.shuffle(targets)
    words = ["far", "near", "face to", "in front of", "face same as", "left of", "right of"]
    for target in targets[:4]:
        layout.random.shuffle(words)
        for word in words:
            side_of_line = word in ("left of", "right of") and not any(t.id == target for t in earlier)
            if not side_of_line:
                yield f"{word}, {target}"


def constraints_of(layout, k, most=4):
    """The wishes of the k-th thing that came true, and perhaps one true thing more."""
    thing, earlier = layout.things[k], layout.things[:k]
    wished = layout.wishes.get(thing.id, [])
    found = [w for w in wished if firmly_holds(layout, thing, w, wished)]
    if not found or found[0] not in ("edge", "middle", "corner"):
        found = [w for w in ("edge", "middle") if firmly_holds(layout, thing, w, ())] + found
    if len(found) < most and layout.random.random() < 0.35:
        used = {parse(f).target for f in found}
        found += [
            g
            for g in guesses(layout, thing, earlier)
            if parse(g).target not in used and firmly_holds(layout, thing, g, (*found, g))
        ][:1]
    return found


def object_json(layout, thing, texts, hints):
    """The thing as a problem states it; with hints also roughly where a designer would put it."""
    entry = {"name": thing.id, "size": list(thing.size), "constraints": " | ".join(texts)}
    if hints and layout.random.random() < 0.8:
        entry["location"] = [round(c + layout.random.gauss(0, 0.25), 2) for c in thing.centre]
        if layout.random.random() < 0.3:
            entry["facing"] = round(math.degrees(thing.yaw)) % 360
    return entry


def witness_json(problem, layout, relations, unplaced=()):
    """The layout as a scene.json."""
    room = layout.room
    return {
        "format": "roomgen-scene",
        "version": 1,
        "units": "m",
        "up": "+z",
        "front": "-y",
        "prompt": "",
        "seed": 0,
        "room": {
            "type": room.type,
            "polygon": problem["room"],
            "height": room.height,
            "openings": [
                {
                    "id": o.id,
                    "type": o.type,
                    "wall": o.wall.index,
                    "from": round(o.begin, 4),
                    "to": round(o.end, 4),
                    "sill": o.sill,
                    "head": o.head,
                    "hinge": o.hinge,
                    "swing": o.swing,
                }
                for o in room.openings
            ],
        },
        "objects": [
            {
                "id": t.id,
                "category": t.category,
                "description": "",
                "traits": layout.categories.property(t.category, "traits", ["front"]),
                "size": list(t.size),
                "position": list(t.position),
                "yaw_deg": round(math.degrees(t.yaw), 4),
                "mount": "floor",
                "on": None,
                "relations": relations[t.id],
                "locked": False,
            }
            for t in layout.things
        ],
        "unplaced": list(unplaced),
    }


def furnish(problem, recipe, fill, most, rng, categories):
    """A layout that has at least the recipe's groups, filled up as far as is asked; None if not."""
    layout = Layout(files.read_problem(problem).room, rng, categories)
    for group in RECIPES[recipe]:
        if not layout.add(group, 150):
            return None
    fillers = FILLERS[filler_kind(recipe)]
    begun = {t.category: len(layout.all_of(t.category)) for t in layout.things}
    misses = 0
    while layout.fill < fill and len(layout.things) < most and misses < 30:
        misses += not layout.add(modest(rng.choice(fillers), begun), 12)
    return layout if layout.things else None


def modest(group, begun):
    """A filler that proposes nothing of which there is enough besides what the recipe brought."""

    def make(layout):
        parts = group(layout) or []
        scale = max(1.0, layout.room.polygon.area / 20)
        for p in parts:
            more = len(layout.all_of(p.category)) - begun.get(p.category, 0)
            if more >= FILL_MOST.get(p.category, 2) * scale:
                return None
        return parts

    return make


def filler_kind(recipe):
    for kind, words in (
        ("bedroom", ("bed", "child", "studio", "one")),
        ("dining room", ("restaurant",)),
        ("kitchen", ("kitchen",)),
        ("bathroom", ("bath", "shower")),
        ("office", ("office", "study")),
        ("living room", ("living", "lounge")),
        ("dining room", ("dining",)),
    ):
        if any(w in recipe for w in words):
            return kind
    raise ValueError(recipe)


@dataclass(frozen=True)
class Kind:
    """One line of the list of problems."""

    recipe: str
    shape: str
    width: float
    depth: float
    fill: float
    most: int = 30
    doors: int = 1
    windows: int = 1
    turn: float = 0.0
    hints: bool = False


KINDS = [
    Kind("bedroom", "rectangle", 4.6, 4.0, 0.33),
    Kind("bedroom", "rectangle", 5.0, 4.2, 0.38, hints=True),
    Kind("bedroom", "l", 6.0, 5.4, 0.30),
    Kind("bedroom", "slanted", 5.2, 4.6, 0.33),
    Kind("bedroom", "rectangle", 4.8, 4.4, 0.40, windows=2),
    Kind("bedroom", "rectangle", 5.0, 4.4, 0.30, turn=17),
    Kind("small bedroom", "rectangle", 3.6, 3.0, 0.35),
    Kind("small bedroom", "rectangle", 2.6, 4.4, 0.36),
    Kind("small bedroom", "trapezoid", 4.4, 3.4, 0.33, hints=True),
    Kind("children's room", "rectangle", 4.4, 3.8, 0.36),
    Kind("children's room", "l", 5.6, 5.0, 0.32, hints=True),
    Kind("living room", "rectangle", 5.5, 4.5, 0.28),
    Kind("living room", "rectangle", 6.0, 4.8, 0.36, hints=True),
    Kind("living room", "l", 7.0, 6.0, 0.28, doors=2),
    Kind("living room", "slanted", 6.0, 5.2, 0.32),
    Kind("living room", "octagon", 6.6, 6.6, 0.28),
    Kind("living room", "rectangle", 5.4, 4.8, 0.33, turn=30),
    Kind("living room", "rectangle", 8.0, 3.8, 0.28, doors=2),
    Kind("open living room", "t", 7.6, 6.4, 0.22, hints=True),
    Kind("open living room", "rectangle", 6.0, 5.0, 0.25, doors=2, windows=2),
    Kind("open living room", "u", 9.0, 6.0, 0.22, doors=2),
    Kind("dining room", "rectangle", 4.6, 4.0, 0.33),
    Kind("dining room", "rectangle", 5.0, 4.2, 0.36, hints=True),
    Kind("dining room", "octagon", 5.6, 5.2, 0.28),
    Kind("dining room", "slanted", 5.4, 4.6, 0.32),
    Kind("small dining room", "rectangle", 3.6, 3.6, 0.36),
    Kind("small dining room", "rectangle", 4.0, 3.6, 0.36, turn=45),
    Kind("great dining room", "rectangle", 6.4, 4.6, 0.35, doors=2),
    Kind("great dining room", "l", 7.6, 6.4, 0.28, doors=2, hints=True),
    Kind("kitchen", "rectangle", 4.4, 3.2, 0.32),
    Kind("kitchen", "rectangle", 3.6, 3.4, 0.38),
    Kind("kitchen", "l", 5.2, 5.0, 0.28, hints=True),
    Kind("kitchen", "rectangle", 6.4, 2.6, 0.30, doors=2),
    Kind("eat-in kitchen", "rectangle", 5.0, 4.2, 0.33),
    Kind("eat-in kitchen", "slanted", 5.6, 4.6, 0.30),
    Kind("eat-in kitchen", "rectangle", 5.2, 4.4, 0.34, doors=2, hints=True),
    Kind("bathroom", "rectangle", 2.8, 2.6, 0.38),
    Kind("bathroom", "rectangle", 3.4, 2.8, 0.38),
    Kind("bathroom", "slanted", 3.6, 3.2, 0.34, hints=True),
    Kind("bathroom", "l", 4.0, 3.8, 0.32),
    Kind("shower room", "rectangle", 2.4, 2.0, 0.36, windows=0),
    Kind("shower room", "rectangle", 1.8, 3.4, 0.33),
    Kind("shower room", "rectangle", 2.6, 2.4, 0.36, turn=10),
    Kind("study", "rectangle", 3.4, 3.0, 0.35),
    Kind("study", "trapezoid", 4.4, 3.8, 0.33),
    Kind("study", "rectangle", 2.4, 5.4, 0.30, hints=True),
    Kind("studio", "rectangle", 6.4, 4.8, 0.36),
    Kind("studio", "l", 7.4, 6.0, 0.33, hints=True),
    Kind("office", "rectangle", 6.4, 5.2, 0.33, doors=2),
    Kind("office", "t", 8.4, 7.0, 0.28, doors=2),
    Kind("living and dining", "rectangle", 7.4, 5.4, 0.34, doors=2, windows=2),
    Kind("living and dining", "l", 8.6, 7.2, 0.30, doors=2, windows=2, hints=True),
    Kind("living and dining", "u", 10.0, 7.4, 0.26, doors=2, windows=3),
    Kind("restaurant", "rectangle", 8.4, 6.4, 0.30, most=34, doors=2, windows=3),
    Kind("open office", "rectangle", 9.4, 7.4, 0.28, most=40, doors=2, windows=3),
    Kind("open office", "octagon", 10.4, 9.4, 0.25, most=40, doors=2, windows=2, hints=True),
    Kind("lounge", "l", 10.0, 8.4, 0.27, most=36, doors=2, windows=3),
    Kind("lounge", "rectangle", 9.0, 6.6, 0.32, most=40, doors=3, windows=3),
    Kind("one thing", "rectangle", 1.8, 1.6, 0.15, most=3, windows=0),
    Kind("small bedroom", "rectangle", 3.0, 3.6, 0.45, hints=True),
    Kind("small dining room", "rectangle", 4.0, 3.4, 0.42, windows=0),
    Kind("bedroom", "rectangle", 4.8, 4.0, 0.45, windows=0),
    Kind("living room", "rectangle", 5.2, 4.6, 0.42, windows=0),
]


def make_problem(number, kind, seed, categories):
    """(problem, witness, index entry) for one line of the list; retries until a layout is found."""
    name = f"{number:02d}-{kind.recipe}-{kind.shape}".replace(" ", "-").replace("'", "")
    best = None
    for attempt in range(40):
        rng = random.Random(f"{seed}/{number}/{attempt}")
        corners = turned(outline(kind.shape, kind.width, kind.depth), kind.turn)
        corners = corners[::-1] if number % 3 == 1 else corners  # files have either winding
        width = 0.8 if Polygon(corners).area < 8 else 0.9
        problem = empty_problem(name, kind.recipe, corners, rng, kind.doors, kind.windows, width)
        layout = furnish(problem, kind.recipe, kind.fill, kind.most, rng, roomy(categories))
        if layout and (best is None or layout.fill > best[1].fill):
            best = problem, layout
        if best and (attempt >= 12 or best[1].fill >= kind.fill - 0.03 or len(best[1].things) >= kind.most):
            break
    if best is None:
        raise RuntimeError(f"no layout found for {name}")
    return finish(*best, kind)


def finish(problem, layout, kind):
    relations = {t.id: constraints_of(layout, k) for k, t in enumerate(layout.things)}
    problem["objects"] = [object_json(layout, t, relations[t.id], kind.hints) for t in layout.things]
    total = sum(map(len, relations.values()))
    entry = {
        "name": problem["name"],
        "kind": "feasible",
        "objects": len(layout.things),
        "fill": round(layout.fill, 3),
        "placeable": len(layout.things),
        "constraints": total,
        "constraints_holdable": total,
    }
    return problem, witness_json(problem, layout, relations), entry


# --- problems that cannot be solved completely -----------------------------------------------------


def impossible(name, corners, objects, places, doors, why, windows=()):
    """A problem written by hand; `places` has (x, y, yaw in degrees) of what the witness places."""
    problem = {
        "name": name,
        "room_type": "test",
        "units": "m",
        "room": corners,
        "height": 2.7,
        "doors": doors,
        "windows": list(windows),
        "objects": objects,
    }
    layout = Layout(files.read_problem(problem).room, random.Random(0), files.Categories.default())
    relations, unplaced = {}, []
    for o in files.read_problem(problem).objects:
        if o["id"] in places:
            x, y, yaw = places[o["id"]]
            layout.things.append(
                files.Thing(
                    o["id"], files.category_of_name(o["id"]), o["size"], (x, y, 0.0), math.radians(yaw)
                )
            )
            relations[o["id"]] = o["relations"]
        else:
            unplaced.append({"id": o["id"], "category": files.category_of_name(o["id"]), "reason": why})
    witness = witness_json(problem, layout, relations, unplaced)
    judged = report.judge_constraints(files.read_scene(witness), report.STRICT, files.read_problem(problem))
    results = [r["held"] for rs in judged.values() for r in rs]
    entry = {
        "name": name,
        "kind": "impossible",
        "why": why,
        "objects": len(objects),
        "fill": round(layout.fill, 3),
        "placeable": len(places),
        "constraints": len(results),
        "constraints_holdable": sum(results),
    }
    return problem, witness, entry


def thing(name, size, constraints=""):
    return {"name": name, "size": size, "constraints": constraints}


def hopeless_problems():
    """Problems in which exactly what the index says is lost, however one tries."""
    door = [{"segment": [[0.2, 0], [1.1, 0]]}]
    square = [[0, 0], [4, 0], [4, 4], [0, 4]]
    small = [[0, 0], [1.4, 0], [1.4, 1.3], [0, 1.3]]
    yield impossible(
        "90-too-large",
        square,
        [
            thing("bed-0", [1.6, 2.0], "edge"),
            thing("piano-0", [4.6, 4.2, 1.0], "edge | near, bed-0"),
            thing("plant-0", [0.4, 0.4], "near, bed-0"),
        ],
        {"bed-0": (2.4, 2.99, 0), "plant-0": (1.2, 3.7, 0)},
        door,
        "the piano is larger than the room",
    )
    yield impossible(
        "91-contradiction",
        square,
        [
            thing("sofa-0", [2.0, 0.9], "edge"),
            thing("armchair-0", [0.8, 0.8], "face same as, sofa-0 | face opposite to, sofa-0"),
            thing("dresser-0", [1.0, 0.45], "edge | middle"),
        ],
        {"sofa-0": (2.5, 3.54, 0), "armchair-0": (2.5, 2.0, 180), "dresser-0": (0.235, 3.0, 90)},
        door,
        "two opposite directions; edge and middle",
    )
    yield impossible(
        "92-only-the-door",
        small,
        [thing("wardrobe-0", [1.2, 0.6, 2.0], "edge"), thing("plant-0", [0.3, 0.3], "edge")],
        {"plant-0": (1.24, 1.14, 0)},
        [{"segment": [[0.05, 0], [0.95, 0]]}],
        "the wardrobe fits nowhere beside the door's swing",
    )
    yield impossible(
        "93-too-tall",
        square,
        [
            thing("bookshelf-0", [0.9, 0.3, 2.9], "edge"),
            thing("desk-0", [1.2, 0.6, 0.75], "edge | near, bookshelf-0"),
            thing("office chair-0", [0.55, 0.55], "in front of, desk-0 | face to, desk-0"),
        ],
        {"desk-0": (2.5, 3.69, 0), "office chair-0": (2.5, 3.05, 180)},
        door,
        "the shelf is higher than the room",
    )
    walls = [[[0, 4], [4, 4]], [[0, 0], [0, 4]], [[4, 0], [4, 4]], [[1.3, 0], [4, 0]]]
    yield impossible(
        "94-windows-all-around",
        square,
        [thing("wardrobe-0", [1.2, 0.6, 2.0], "edge"), thing("bench-0", [1.0, 0.4, 0.45], "edge")],
        {"wardrobe-0": (2.5, 2.0, 0), "bench-0": (3.0, 3.79, 0)},
        door,
        "the wardrobe may stand at no wall",
        [{"segment": s, "sill": 0.8} for s in walls],
    )


# --- the program -----------------------------------------------------------------------------------


def faults(problem, witness, entry, categories):
    """What is wrong with a witness; nothing should be."""
    parsed = files.read_problem(problem)
    found = []
    for round_things in (True, False):
        scene = files.read_scene(witness, problem["name"])
        if not round_things:
            scene.things = [replace(t, traits=()) for t in scene.things]
        for lenience in (reach.LENIENCE, WALK_MARGIN / 2):
            r = report.check(scene, report.Options(categories, problem=parsed, lenience=lenience))
            found += [f"{v['rule']} {v['objects']} {v['detail']}" for v in r["violations"]]
        c = r["constraints"]
        if (c["held"], c["total"]) != (entry["constraints_holdable"], entry["constraints"]):
            found.append(f"{c['held']} of {c['total']} constraints held")
    if len(witness["objects"]) != entry["placeable"]:
        found.append("other number of objects")
    return sorted(set(found))


def write(folder, problem, witness):
    (folder / "witness").mkdir(parents=True, exist_ok=True)
    for path, data in (
        (folder / f"{problem['name']}.json", problem),
        (folder / "witness" / f"{problem['name']}.scene.json", witness),
    ):
        path.write_text(compact(data) + "\n", encoding="utf-8")


def compact(data):
    """JSON with one line for each object of a list."""
    lines = []
    for key, value in data.items():
        if isinstance(value, list) and value and isinstance(value[0], dict):
            rows = ",\n  ".join(json.dumps(v) for v in value)
            lines.append(f" {json.dumps(key)}: [\n  {rows}\n ]")
        else:
            lines.append(f" {json.dumps(key)}: {json.dumps(value)}")
    return "{\n" + ",\n".join(lines) + "\n}"


def job(arguments):
    number, kind, seed = arguments
    return make_problem(number, kind, seed, files.Categories.default())


def main():
    p = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    p.add_argument("folder", type=Path, help="such as tests/data/rooms")
    p.add_argument("--seed", type=int, default=1)
    p.add_argument("--jobs", type=int, default=1)
    args = p.parse_args()
    jobs = [(k, kind, args.seed) for k, kind in enumerate(KINDS)]
    categories, entries, bad = files.Categories.default(), [], 0
    with ProcessPoolExecutor(args.jobs) as pool:
        for problem, witness, entry in [*pool.map(job, jobs), *hopeless_problems()]:
            wrong = faults(problem, witness, entry, categories)
            bad += bool(wrong)
            line = f"{entry['name']:40} {entry['objects']:3} objects, fill {entry['fill']:.2f}"
            print(line, *wrong, sep="\n  ! ", flush=True)
            write(args.folder, problem, witness)
            entries.append(entry)
    (args.folder / "witness" / "index.json").write_text(
        "[\n " + ",\n ".join(map(json.dumps, entries)) + "\n]\n", encoding="utf-8"
    )
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
