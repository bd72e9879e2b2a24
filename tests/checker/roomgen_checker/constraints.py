"""Whether a constraint holds, by the table in docs/constraints.md.

`LOOSE` holds the limits with which an earlier solver was measured, so that both can be compared.
"""

import math
import re
from dataclasses import dataclass
from functools import cache, cached_property

from shapely.geometry import LineString, Point

from . import geometry as geo
from .files import Categories

ONE_DEGREE = math.radians(1.0) + 1e-6
RAY_LENGTH = 1000.0
TURNS = {"front": 0.0, "back": math.pi, "left": math.pi / 2, "right": -math.pi / 2}
GAP = re.compile(r"gap (at least |at most )?(\d+(?:\.\d+)?) m")
PLAIN = ("edge", "middle", "corner")
FRONT_OR_BACK = ("in front of", "behind")
SIDEWAYS = ("left of", "right of", "side of")
ALIGNED = ("center aligned", "aligned")
NAMES = (
    PLAIN
    + FRONT_OR_BACK
    + SIDEWAYS
    + ALIGNED
    + (
        "near",
        "next to",
        "far",
        "around",
        "between",
        "face to",
        "face same as",
        "face opposite to",
        "used facing",
        "on",
        "inside",
        "above",
        "under",
        "hang from",
    )
)


@dataclass(frozen=True)
class Limits:
    loose: bool = False
    edge: float = 0.05
    corner: float = 0.10
    middle: float = 0.30
    near: float = 1.5
    beside: float = 0.5
    around: float = 0.6
    aligned: float = 0.05
    gap: float = 0.10


STRICT = Limits()
LOOSE = Limits(loose=True, edge=0.10, around=1.5)


@dataclass(frozen=True)
class Constraint:
    text: str
    name: str
    target: str | None = None


@cache
def categories():
    return Categories.default()


def parse(text):
    """`Near, Bed-0` as a Constraint; names are not case-sensitive."""
    name, _, target = text.partition(",")
    name = " ".join(name.lower().split()).replace("centre", "center")
    return Constraint(text, name, target.strip().lower() or None)


@dataclass(frozen=True)
class Place:
    """What a constraint may point at: a thing, an opening or a wall (without depth)."""

    centre: tuple
    yaw: float
    width: float
    depth: float
    bottom: float
    top: float
    shape: object
    box: object
    wall: object = None

    def local(self, point):
        return geo.to_local(point, self.centre, self.yaw)


def place_of_thing(thing):
    return Place(
        thing.centre, thing.yaw, *thing.size[:2], thing.bottom, thing.top, thing.footprint, thing.box
    )


def place_of_line(line, wall, bottom, top):
    middle = line.interpolate(0.5, normalized=True)
    return Place(
        (middle.x, middle.y), geo.yaw_looking(wall.inward), line.length, 0.0, bottom, top, line, line, wall
    )


class Judge:
    """Tests the constraints of one scene."""

    def __init__(self, scene, limits=STRICT):
        self.scene = scene
        self.room = scene.room
        self.limits = limits

    @cached_property
    def places(self):
        places = {t.id.lower(): place_of_thing(t) for t in self.scene.things}
        for wall in self.room.walls:
            places[f"wall-{wall.index}"] = place_of_line(wall.line, wall, 0.0, self.room.height)
        for o in self.room.openings:
            places[o.id] = place_of_line(o.line, o.wall, o.sill, o.head)
        return places

    def shape(self, thing):
        return thing.box if self.limits.loose else thing.footprint

    def holds(self, thing, constraint):
        """Whether `constraint` holds for a placed thing; unknown words and targets do not."""
        name, target = constraint.name, constraint.target
        if name in PLAIN:
            return getattr(self, name)(thing)
        if target == "corner":
            return self.to_corner(thing, name)
        if name == "hang from":
            return self.hangs(thing, target)
        if name == "in part":
            return self.in_region(thing, target)
        if said := GAP.fullmatch(name):
            return self.keeps_gap(thing, target, said[1], float(said[2]))
        place = self.places.get(target)
        if place is None or target == thing.id.lower() or name not in NAMES:
            return False
        if name == "between":
            return self.between(thing, place, target)
        if name in ALIGNED:
            return self.aligned(thing, place, self.companions(thing, target))
        return getattr(self, name.replace(" ", "_"))(thing, place)

    def companions(self, thing, target):
        """The names of all constraints that a thing has with a target."""
        return {c.name for c in map(parse, thing.relations) if c.target == target}

    # --- to the room

    def walls_at_back(self, thing, limit):
        """The walls at which a thing stands with its back."""
        back = geo.side_segment(thing, "back").interpolate(0.5, normalized=True)
        found = []
        for wall in self.room.walls:
            along, off = wall.coordinates((back.x, back.y))
            parallel = geo.angle_between(thing.yaw, geo.yaw_looking(wall.inward)) <= ONE_DEGREE
            beside = -geo.SLACK <= along <= wall.length + geo.SLACK
            if parallel and beside and abs(off) <= limit + geo.SLACK:
                found.append(wall)
        return found

    def edge(self, thing):
        if self.limits.loose:
            back = geo.side_segment(thing, "back").interpolate(0.5, normalized=True)
            return self.room.polygon.exterior.distance(back) <= self.limits.edge + geo.SLACK
        return bool(self.walls_at_back(thing, self.limits.edge))

    def middle(self, thing):
        gap = self.room.polygon.exterior.distance(self.shape(thing))
        inside = self.room.polygon.contains(Point(thing.centre))
        return inside and gap >= self.limits.middle - geo.SLACK

    def corner(self, thing):
        """`edge`, and one side close to another wall that looks at that side."""
        for wall in self.walls_at_back(thing, self.limits.edge):
            for side, outward in (("left", (1, 0)), ("right", (-1, 0))):
                line = geo.side_segment(thing, side)
                direction = geo.rotate(*outward, thing.yaw)
                for other in self.room.walls:
                    facing = other.inward[0] * direction[0] + other.inward[1] * direction[1]
                    if (
                        other.index != wall.index
                        and facing < -0.1
                        and line.distance(other.line) <= self.limits.corner + geo.SLACK
                    ):
                        return True
        return False

    def to_corner(self, thing, name):
        """A constraint with the target `corner`: any corner may serve."""
        shape = self.shape(thing)
        gaps = [shape.distance(c) for c in self.room.corners]
        if name == "near":
            return min(gaps) <= self.limits.near + geo.SLACK
        if name == "far":
            return max(gaps) >= self.limits.near - geo.SLACK
        if name == "face to":
            return any(self.ray(thing).distance(c) <= geo.SLACK for c in self.room.corners)
        return False

    # --- to a place

    def gap(self, thing, place):
        return self.shape(thing).distance(place.box if self.limits.loose else place.shape)

    def keeps_gap(self, thing, target, bound, said):
        """So far from a place, or from the nearest wall."""
        if target == "wall":
            there = self.room.polygon.exterior.distance(self.shape(thing))
        elif target in self.places and target != thing.id.lower():
            there = self.gap(thing, self.places[target])
        else:
            return False
        slack = self.limits.gap + geo.SLACK
        return (bound == "at most " or there >= said - slack) and (bound == "at least " or there <= said + slack)

    def is_at(self, thing, place, limit):
        """So near; what hangs on a wall is near that wall, not near one round the corner."""
        if thing.mount == "wall" and place.wall is not None and place.shape is place.wall.line:
            return place.wall in self.walls_at_back(thing, self.limits.edge)
        return self.gap(thing, place) <= limit + geo.SLACK

    def near(self, thing, place):
        return self.is_at(thing, place, self.limits.near)

    def next_to(self, thing, place):
        return self.is_at(thing, place, self.limits.beside)

    def far(self, thing, place):
        return self.gap(thing, place) >= self.limits.near - geo.SLACK

    def beyond(self, thing, place, axis, sign):
        """Beyond the side of a target that lies at `sign` on its own `axis`, and not beside it."""
        local, half = place.local(thing.centre), (place.width / 2, place.depth / 2)
        other = 1 - axis
        return sign * local[axis] >= half[axis] - geo.SLACK and abs(local[other]) <= half[other] + geo.SLACK

    def in_front_of(self, thing, place):
        return self.beyond(thing, place, 1, -1)

    def behind(self, thing, place):
        return self.beyond(thing, place, 1, +1)

    def left_of(self, thing, place):
        return self.beyond(thing, place, 0, +1)

    def right_of(self, thing, place):
        return self.beyond(thing, place, 0, -1)

    def side_of(self, thing, place):
        return self.left_of(thing, place) or self.right_of(thing, place)

    def around(self, thing, place):
        close = self.gap(thing, place) <= self.limits.around + geo.SLACK
        return close and self.face_to(thing, place)

    def between(self, thing, place, target):
        """Within the strip that joins the two things with which a thing has the constraint."""
        others = [
            self.places[c.target]
            for c in map(parse, thing.relations)
            if c.name == "between" and c.target != target and c.target in self.places
        ]
        if not others:
            return False
        other = others[0]
        dx, dy = (b - a for a, b in zip(place.centre, other.centre))
        length = math.hypot(dx, dy)
        if length < 1e-9:
            return False
        along, across = (dx / length, dy / length), (-dy / length, dx / length)

        def span(shape, axis, origin):
            points = shape.exterior.coords if hasattr(shape, "exterior") else shape.coords
            stations = [(x - origin[0]) * axis[0] + (y - origin[1]) * axis[1] for x, y in points]
            return min(stations), max(stations)

        low = span(place.shape, along, place.centre)[1]
        high = span(other.shape, along, place.centre)[0]
        widths = [span(p.shape, across, p.centre) for p in (place, other)]
        allowed = max(max(abs(a), abs(b)) for a, b in widths)
        offset = [t - c for t, c in zip(thing.centre, place.centre)]
        station = offset[0] * along[0] + offset[1] * along[1]
        aside = abs(offset[0] * across[0] + offset[1] * across[1])
        slack = 0.01  # round things are polygons here
        return low < high and low - slack <= station <= high + slack and aside <= allowed + slack

    def in_region(self, thing, name):
        """The centre in the share of the room's box that lies at the named side."""
        west, south, east, north = self.room.polygon.bounds
        *sides, share = name.replace("two-thirds", "two_thirds").split("-")
        if share == "quarter" and len(sides) == 2:
            return all(self.in_region(thing, f"{side}-half") for side in sides)
        part = {"half": 1 / 2, "third": 1 / 3, "two_thirds": 2 / 3, "quarter": 1 / 4}.get(share)
        if part is None or len(sides) != 1:
            return False
        (side,) = sides
        u = (thing.centre[0] - west) / (east - west)
        v = (thing.centre[1] - south) / (north - south)
        if side == "middle":
            t = u if east - west >= north - south else v
            return abs(t - 0.5) <= part / 2 + geo.SLACK
        t = {"east": 1 - u, "west": u, "north": 1 - v, "south": v}.get(side)
        return t is not None and t <= part + geo.SLACK

    def aligned(self, thing, place, companions):
        lateral, longitudinal = map(abs, place.local(thing.centre))
        offsets = []
        if companions & set(FRONT_OR_BACK):
            offsets.append(lateral)
        if companions & set(SIDEWAYS):
            offsets.append(longitudinal)
        if not offsets or self.limits.loose:
            offsets = [lateral, longitudinal]
        return min(offsets) <= self.limits.aligned + geo.SLACK

    def ray(self, thing, turn=0.0):
        front = geo.front_of(thing.yaw + turn)
        end = [c + RAY_LENGTH * f for c, f in zip(thing.centre, front)]
        return LineString([thing.centre, end])

    def face_to(self, thing, place):
        shape = place.box if self.limits.loose else place.shape
        return self.ray(thing).distance(shape) <= geo.SLACK

    def used_facing(self, thing, place):
        """The side that things of this kind face with meets the target."""
        turn = TURNS[categories().property(thing.category, "faces", "front")]
        shape = place.box if self.limits.loose else place.shape
        return self.ray(thing, turn).distance(shape) <= geo.SLACK

    def face_same_as(self, thing, place):
        return geo.angle_between(thing.yaw, place.yaw) <= ONE_DEGREE

    def face_opposite_to(self, thing, place):
        return geo.angle_between(thing.yaw, place.yaw + math.pi) <= ONE_DEGREE

    # --- up and down

    def over_each_other(self, thing, place):
        """The thing's centre lies over the target's box."""
        x, y = place.local(thing.centre)
        return abs(x) <= place.width / 2 + geo.SLACK and abs(y) <= place.depth / 2 + geo.SLACK

    def above(self, thing, place):
        return self.over_each_other(thing, place) and thing.bottom >= place.top - geo.SLACK

    def under(self, thing, place):
        return self.over_each_other(thing, place) and thing.top <= place.bottom + geo.SLACK

    def on(self, thing, place):
        """Stands on a thing, or hangs on a wall."""
        if place.wall is not None:
            return thing.mount == "wall" and place.wall in self.walls_at_back(thing, 0.05)
        if thing.mount == "ceiling":
            return self.hangs_under(thing, place)
        return (
            thing.mount == "surface" and thing.on is not None and self.places.get(thing.on.lower()) is place
        )

    def inside(self, thing, place):
        """Between the floor and the top of what contains it, for the most part of its height."""
        slack = 1e-4
        below_top = (thing.bottom + thing.top) / 2 <= place.top + slack and thing.bottom >= place.bottom - slack
        own, other = thing.footprint, place.shape
        return below_top and (other.buffer(slack).covers(own) or own.buffer(slack).covers(other))

    def hangs_under(self, thing, beam):
        """Its top at the underside of a thing, or within the height of one that does not hang from the ceiling."""
        high = beam.bottom if beam.top >= self.room.height - 0.05 else beam.top
        return self.gap(thing, beam) <= 0.15 + geo.SLACK and beam.bottom - 0.05 <= thing.top <= high + 0.05

    def hangs(self, thing, target):
        walls = {f"wall-{w.index}" for w in self.walls_at_back(thing, 0.05)}
        at_ceiling = abs(thing.top - self.room.height) <= 0.05
        if target in (None, "ceiling"):
            return at_ceiling or (target is None and bool(walls))
        beam = self.places.get(target)
        if beam is not None and beam.wall is None:
            return thing.mount in ("wall", "ceiling") and self.hangs_under(thing, beam)
        return target in walls or (target == "wall" and bool(walls))
