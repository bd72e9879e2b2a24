"""Where a person can walk, and whether things can be used from there.

The room is drawn on a fine raster; a distance transform gives every cell its clearance. Cells are
free where a disc, a little smaller than the person so that two correct discretisations do not
disagree, has room.
"""

from functools import cached_property

import numpy as np
import shapely
from scipy import ndimage

from . import geometry as geo
from .rules import Violation, covers_window, door_clearance

RADIUS = 0.25
LENIENCE = 0.02
CELL = 0.01
ZONE_SLACK = 0.02
OVERHEAD = 1.75
WALL_OVERHEAD = 1.2


def overhead(thing):
    """High enough for a person to stand under it."""
    return thing.bottom > OVERHEAD or (thing.mount == "wall" and thing.bottom > WALL_OVERHEAD)


def is_obstacle(thing):
    """Whether a thing is in the way of a person."""
    return thing.solid and thing.mount != "surface" and not overhead(thing) and not covers_window(thing)


class WalkMap:
    """The parts of the floor between which a person can walk."""

    def __init__(self, scene, lenience=LENIENCE):
        self.room = scene.room
        self.obstacles = [t for t in scene.things if is_obstacle(t)]
        self.radius = RADIUS - lenience
        self.lenience = lenience

    @cached_property
    def axes(self):
        """Coordinates of the cells' centres, with a frame of blocked cells around the room."""
        x0, y0, x1, y1 = self.room.polygon.bounds
        return tuple(np.arange(lo - 1.5 * CELL, hi + 2 * CELL, CELL) for lo, hi in ((x0, x1), (y0, y1)))

    def draw(self, shape):
        """(window, mask): the cells whose centres a shape covers, within its bounds."""
        xs, ys = self.axes
        x0, y0, x1, y1 = shape.bounds
        i0, i1 = np.searchsorted(xs, (x0, x1 + CELL))
        j0, j1 = np.searchsorted(ys, (y0, y1 + CELL))
        window = np.s_[i0:i1, j0:j1]
        gx, gy = np.meshgrid(xs[i0:i1], ys[j0:j1], indexing="ij")
        shapely.prepare(shape)
        return window, shapely.contains_xy(shape, gx, gy)

    def covers(self, shape, mask):
        window, inside = self.draw(shape)
        return mask[window][inside]

    @cached_property
    def regions(self):
        """The number of the connected free region of every cell, 0 where nobody fits."""
        free = np.zeros([len(a) for a in self.axes], dtype=bool)
        window, inside = self.draw(self.room.polygon)
        free[window] = inside
        for thing in self.obstacles:
            window, inside = self.draw(thing.footprint)
            free[window] &= ~inside
        # A blocked cell's centre lies on average half a cell behind the edge.
        clearance = ndimage.distance_transform_edt(free) * CELL - CELL / 2
        return ndimage.label(clearance >= self.radius, structure=np.ones((3, 3)))[0]

    def regions_in(self, shape):
        """The regions with a standing place whose centre lies in a shape."""
        return set(np.unique(self.covers(shape, self.regions)).tolist()) - {0}

    @cached_property
    def from_door(self):
        """For every door and passage, the regions that begin in its clearance."""
        return {o.id: self.regions_in(door_clearance(o)) for o in self.room.entrances}

    @cached_property
    def walkable(self):
        return set().union(*self.from_door.values()) if self.from_door else None

    def reaches(self, zone):
        """Whether a disc that comes from a door can touch a zone."""
        if self.walkable is None:
            return True
        return bool(self.regions_in(zone.buffer(RADIUS + self.lenience / 2)) & self.walkable)


def check_connected(scene, walk):
    """Every door can be reached from every other."""
    found, doors = [], list(walk.from_door.items())
    for k, (door, regions) in enumerate(doors):
        if not regions:
            found.append(Violation("connected", (door,), "nobody can stand before it"))
        for other, regions_there in doors[k + 1 :]:
            if regions and regions_there and not regions & regions_there:
                found.append(Violation("connected", (door, other), "no way between the two"))
    return found


def zone_blockers(thing, zone, rectangle, scene, categories, slack=ZONE_SLACK):
    """What keeps a use zone from being free: ids, `wall` for the room's edge."""
    blockers = []
    grown = scene.room.polygon.buffer(max(slack, 0) + 1e-6, join_style="mitre")
    if not grown.covers(rectangle):
        blockers.append("wall")
    core = rectangle.buffer(-slack, join_style="mitre") if slack > 0 else rectangle
    for other in scene.things:
        partner = any(categories.is_a(other.category, p) for p in zone.get("partners", []))
        if other.id == thing.id or partner or not is_obstacle(other):
            continue
        if core.intersection(other.footprint).area > 1e-6:
            blockers.append(other.id)
    return blockers


def needs_access(thing):
    """Things on others and things overhead are used from wherever their neighbours are."""
    return is_obstacle(thing) and thing.mount in ("floor", "wall")


def zone_rectangle(thing, zone):
    """The floor of a use zone: without the head of a bed, and of one wider than deep at its long sides."""
    side, (w, d) = zone["side"], thing.size[:2]
    beside = side in ("left", "right")
    if beside and zone.get("lengthwise") and w > d:
        return geo.side_rectangle(thing, "front" if side == "left" else "back", zone["depth"])
    if not beside or not zone.get("inset"):
        return geo.side_rectangle(thing, side, zone["depth"])
    inset, far = min(zone["inset"], d / 2), w / 2 + zone["depth"]
    x0, x1 = (w / 2, far) if side == "left" else (-far, -w / 2)
    return geo.local_rectangle(thing.centre, thing.yaw, x0, x1, -d / 2, d / 2 - inset)


def unusable_reason(thing, scene, categories, walk):
    """None if a zone of the thing is free and reachable, or if it has none."""
    reasons = []
    for zone in categories.zones(thing.category):
        rectangle = zone_rectangle(thing, zone)
        blockers = zone_blockers(thing, zone, rectangle, scene, categories)
        if blockers:
            reasons.append(f"{zone['side']}: blocked by {', '.join(blockers)}")
        elif walk.reaches(rectangle):
            return None
        else:
            reasons.append(f"{zone['side']}: not reachable from a door")
    return "; ".join(reasons) or None


def check_usable(scene, categories, walk):
    found = []
    for t in scene.things:
        reason = unusable_reason(t, scene, categories, walk) if needs_access(t) else None
        if reason:
            found.append(Violation("usable", (t.id,), reason))
    return found
