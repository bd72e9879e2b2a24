"""scene.json, problem.json and the kinds of things as plain values."""

import json
import math
import re
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

from shapely.geometry import LineString, Point, Polygon

from . import geometry as geo

DEFAULT_HEIGHT = 0.9
DEFAULT_ROOM_HEIGHT = 2.7
DEFAULT_DOOR_HEAD = 2.05
DEFAULT_WINDOW_SILL = 0.9
DEFAULT_WINDOW_HEAD = 2.1


@dataclass(frozen=True)
class Thing:
    """A placed object."""

    id: str
    category: str
    size: tuple
    position: tuple
    yaw: float
    mount: str = "floor"
    on: str | None = None
    traits: tuple = ()
    relations: tuple = ()

    @property
    def centre(self):
        return self.position[:2]

    @property
    def bottom(self):
        return self.position[2]

    @property
    def top(self):
        return self.position[2] + self.size[2]

    @property
    def solid(self):
        return "flat" not in self.traits

    @cached_property
    def box(self):
        """The rectangle of the box seen from above."""
        return geo.rectangle(self.centre, self.yaw, *self.size[:2])

    @cached_property
    def footprint(self):
        """The rectangle, or the inscribed ellipse of a round thing."""
        if "round" in self.traits:
            return geo.ellipse(self.centre, self.yaw, *self.size[:2])
        return self.box


@dataclass(frozen=True)
class Wall:
    """One side of the polygon, from `start` to `end` in the file's order."""

    index: int
    start: tuple
    end: tuple
    inward: tuple

    @cached_property
    def length(self):
        return math.dist(self.start, self.end)

    @cached_property
    def line(self):
        return LineString([self.start, self.end])

    @property
    def along(self):
        return tuple((e - s) / self.length for s, e in zip(self.start, self.end))

    def point(self, distance, inwards=0.0):
        """The point at `distance` along the wall and `inwards` off it."""
        return tuple(s + distance * a + inwards * n for s, a, n in zip(self.start, self.along, self.inward))

    def coordinates(self, point):
        """(metres along the wall, metres off it into the room)."""
        v = [p - s for p, s in zip(point, self.start)]
        return (v[0] * self.along[0] + v[1] * self.along[1], v[0] * self.inward[0] + v[1] * self.inward[1])

    def strip(self, begin, end, depth):
        """The rectangle before a piece of the wall."""
        return Polygon([self.point(begin), self.point(end), self.point(end, depth), self.point(begin, depth)])


@dataclass(frozen=True)
class Opening:
    id: str
    type: str
    wall: Wall
    begin: float
    end: float
    sill: float
    head: float
    swing: str = "in"
    hinge: str = "from"
    leaves: int = 1

    @property
    def width(self):
        return self.end - self.begin

    @cached_property
    def line(self):
        return LineString([self.wall.point(self.begin), self.wall.point(self.end)])

    @property
    def is_entrance(self):
        return self.type in ("door", "passage")


@dataclass
class Room:
    type: str
    polygon: Polygon
    height: float
    walls: list
    openings: list

    @property
    def corners(self):
        return [Point(w.start) for w in self.walls]

    @property
    def entrances(self):
        return [o for o in self.openings if o.is_entrance]


@dataclass
class Scene:
    name: str
    room: Room
    things: list
    unplaced: list = field(default_factory=list)  # dictionaries as in the file
    incomplete: bool = False
    source: dict = field(default_factory=dict)

    @cached_property
    def by_id(self):
        return {t.id.lower(): t for t in self.things}


@dataclass
class Problem:
    name: str
    room: Room
    objects: list  # {"id", "size", "relations"}


def read_json(path):
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def make_walls(corners):
    """The walls of a polygon of either winding, numbered in the given order."""
    corners = [tuple(map(float, c)) for c in corners]
    counter_clockwise = Polygon(corners).exterior.is_ccw
    walls = []
    for k, start in enumerate(corners):
        end = corners[(k + 1) % len(corners)]
        length = math.dist(start, end)
        dx, dy = (end[0] - start[0]) / length, (end[1] - start[1]) / length
        inward = (-dy, dx) if counter_clockwise else (dy, -dx)
        walls.append(Wall(k, start, end, inward))
    return walls


def make_room(room_type, corners, height, openings):
    return Room(room_type, Polygon(corners), float(height), make_walls(corners), openings)


def read_opening(entry, walls):
    begin, end = sorted((float(entry["from"]), float(entry["to"])))
    return Opening(
        entry["id"].lower(),
        entry["type"],
        walls[entry["wall"]],
        begin,
        end,
        float(entry.get("sill", 0.0)),
        float(entry.get("head", DEFAULT_DOOR_HEAD)),
        entry.get("swing", "in"),
        entry.get("hinge", "from"),
        int(entry.get("leaves", 1)),
    )


def read_room(entry):
    room = make_room(entry.get("type", ""), entry["polygon"], entry.get("height", DEFAULT_ROOM_HEIGHT), [])
    room.openings = [read_opening(o, room.walls) for o in entry.get("openings", [])]
    return room


def read_thing(entry):
    return Thing(
        entry["id"],
        entry.get("category", category_of_name(entry["id"])),
        tuple(map(float, entry["size"])),
        tuple(map(float, entry["position"])),
        math.radians(entry.get("yaw_deg", 0.0)),
        entry.get("mount", "floor"),
        entry.get("on"),
        tuple(entry.get("traits", ())),
        tuple(entry.get("relations", ())),
    )


def read_scene(data, name=""):
    """A scene from the parsed scene.json."""
    return Scene(
        name,
        read_room(data["room"]),
        [read_thing(o) for o in data.get("objects", [])],
        list(data.get("unplaced", [])),
        bool(data.get("incomplete", False)),
        data,
    )


def split_constraints(text):
    """`edge | near, bed-0` as a list of its parts."""
    return [part.strip() for part in text.split("|") if part.strip()]


def category_of_name(name):
    """`dining chair-3` is a `dining chair`."""
    return re.sub(r"-\d+$", "", name.strip().lower())


def opening_on_wall(walls, entry, index, kind):
    """The opening of a segment that lies on a wall of the room."""
    a, b = (tuple(map(float, p)) for p in entry["segment"])
    wall = min(walls, key=lambda w: w.line.distance(Point(a)) + w.line.distance(Point(b)))
    ends = [wall.coordinates(p)[0] for p in (a, b)]
    window = kind == "window"
    return Opening(
        f"{kind}-{index}",
        kind,
        wall,
        min(ends),
        max(ends),
        float(entry.get("sill", DEFAULT_WINDOW_SILL if window else 0.0)),
        float(entry.get("head", DEFAULT_WINDOW_HEAD if window else DEFAULT_DOOR_HEAD)),
        entry.get("swing", "in"),
        "from" if ends[0] <= ends[1] else "to",
    )


def read_problem_object(entry):
    size = [float(v) for v in entry["size"]]
    if len(size) == 2:
        size.append(DEFAULT_HEIGHT)
    return {
        "id": entry["name"].lower(),
        "size": tuple(size),
        "relations": split_constraints(entry.get("constraints", "")),
    }


def read_problem(data):
    """A problem from the parsed problem.json."""
    room = make_room(data.get("room_type", ""), data["room"], data.get("height", DEFAULT_ROOM_HEIGHT), [])
    for kind in ("door", "window"):
        room.openings += [
            opening_on_wall(room.walls, entry, k, kind) for k, entry in enumerate(data.get(kind + "s", []))
        ]
    return Problem(data.get("name", ""), room, [read_problem_object(o) for o in data["objects"]])


def singular(word):
    """A plain English singular: good enough for furniture."""
    for ending, replacement in (
        ("shelves", "shelf"),
        ("ies", "y"),
        ("ses", "s"),
        ("xes", "x"),
        ("ches", "ch"),
        ("shes", "sh"),
    ):
        if word.endswith(ending):
            return word[: -len(ending)] + replacement
    return word[:-1] if word.endswith("s") and not word.endswith("ss") else word


class Categories:
    """What is known about kinds of things; properties are inherited by `is`."""

    def __init__(self, data):
        kinds = {k.lower(): v for k, v in data["kinds"].items()}
        self.entries = {name: entry for name, entry in kinds.items() if not entry.get("variant")}
        self.names = {}
        for name, entry in kinds.items():
            for other in entry.get("names", []) + entry.get("loose_names", []) + entry.get("resembles", []):
                self.names[other.lower()] = self.planned(kinds, name)
        self.names.update({name: self.planned(kinds, name) for name in kinds})

    @staticmethod
    def planned(kinds, name):
        """The kind as which scenes know one: a variant's parent."""
        while kinds[name].get("variant"):
            name = kinds[name]["is"].lower()
        return name

    @classmethod
    def load(cls, folder):
        kinds = {}
        for path in sorted(Path(folder).glob("*.json")):
            kinds.update(read_json(path)["kinds"])
        return cls({"kinds": kinds})

    @classmethod
    def default(cls):
        return cls.load(Path(__file__).resolve().parents[3] / "data" / "kinds")

    def lookup(self, text):
        """The known name for a text: exact, synonym, singular, else its longest known ending."""
        words = re.sub(r"[-_\s]+", " ", text.strip().lower()).split(" ")
        for begin in range(len(words)):
            ending = " ".join(words[begin:])
            for candidate in (ending, singular(ending)):
                if candidate in self.names:
                    return self.names[candidate]
        return None

    def lineage(self, text):
        """The name itself, then what it is, and so on upwards."""
        name, found = self.lookup(text), []
        while name and name not in found:
            found.append(name)
            name = self.names.get(self.entries[name].get("is", "").lower())
        return found

    def property(self, text, key, default=None):
        """The value of the nearest ancestor that states it."""
        for name in self.lineage(text):
            if key in self.entries[name]:
                return self.entries[name][key]
        return default

    def zones(self, text):
        return self.property(text, "zones", [])

    def covers_window(self, text):
        """Curtains and blinds, which hang before windows and give way to people."""
        return bool(self.property(text, "covers_window", False))

    def is_a(self, text, kind):
        return kind.lower() in self.lineage(text) or text.strip().lower() == kind.lower()
