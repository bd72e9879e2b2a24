"""Frames and footprints.

Metres, radians, Z up. An object's own frame: width along X, depth along Y, front towards -Y, its
left hand at +X. Yaw is counter-clockwise seen from above.
"""

import math

import numpy as np
import shapely
from shapely.geometry import LineString, Polygon

# Files round their numbers; a limit that is missed by less than this is kept.
SLACK = 1e-3
ELLIPSE_POINTS = 128


def rotate(x, y, yaw):
    """A vector turned by `yaw`."""
    c, s = math.cos(yaw), math.sin(yaw)
    return c * x - s * y, s * x + c * y


def to_world(point, centre, yaw):
    x, y = rotate(point[0], point[1], yaw)
    return centre[0] + x, centre[1] + y


def to_local(point, centre, yaw):
    return rotate(point[0] - centre[0], point[1] - centre[1], -yaw)


def front_of(yaw):
    """The unit vector in which a thing looks: -Y turned by its yaw."""
    return math.sin(yaw), -math.cos(yaw)


def yaw_looking(direction):
    """The yaw of a thing that looks along `direction`."""
    return math.atan2(direction[0], -direction[1])


def angle_between(a, b):
    """The difference of two angles, 0 to pi."""
    return abs((a - b + math.pi) % (2 * math.pi) - math.pi)


def local_rectangle(centre, yaw, x0, x1, y0, y1):
    """The polygon of a rectangle that is given in a thing's own frame."""
    corners = [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]
    return Polygon([to_world(c, centre, yaw) for c in corners])


def rectangle(centre, yaw, width, depth):
    return local_rectangle(centre, yaw, -width / 2, width / 2, -depth / 2, depth / 2)


def ellipse(centre, yaw, width, depth):
    """The ellipse inscribed in a box, as a polygon with its corners on the ellipse."""
    angles = np.linspace(0, 2 * math.pi, ELLIPSE_POINTS, endpoint=False)
    points = [(width / 2 * math.cos(t), depth / 2 * math.sin(t)) for t in angles]
    return Polygon([to_world(p, centre, yaw) for p in points])


def side_rectangle(thing, side, depth):
    """The rectangle of `depth` along a whole side of a thing's box."""
    w, d = thing.size[0] / 2, thing.size[1] / 2
    x0, x1, y0, y1 = {
        "front": (-w, w, -d - depth, -d),
        "back": (-w, w, d, d + depth),
        "left": (w, w + depth, -d, d),
        "right": (-w - depth, -w, -d, d),
    }[side]
    return local_rectangle(thing.centre, thing.yaw, x0, x1, y0, y1)


def side_segment(thing, side):
    """The edge of a thing's box that is called front, back, left or right."""
    w, d = thing.size[0] / 2, thing.size[1] / 2
    ends = {
        "front": ((-w, -d), (w, -d)),
        "back": ((-w, d), (w, d)),
        "left": ((w, -d), (w, d)),
        "right": ((-w, -d), (-w, d)),
    }[side]
    return LineString([to_world(e, thing.centre, thing.yaw) for e in ends])


def share_area(a, b, slack):
    """Whether two convex shapes reach into each other by more than `slack`.

    Both are shrunk by half of it, which is exact for faces that overlap and a little lenient at
    corners.
    """
    if not shapely.intersects(a, b):
        return False
    a, b = (shapely.buffer(g, -slack / 2, join_style="mitre") for g in (a, b))
    return not a.is_empty and not b.is_empty and a.intersection(b).area > 1e-9
