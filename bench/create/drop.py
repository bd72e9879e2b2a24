"""Whether a thing stays where it is put: two seconds of gravity on a plane in MuJoCo.

The thing is one rigid body. Its mass, centre and inertia are those of its solid pieces at 500 kg/m3 (a piece that is
not closed counts with its hull). A plane touches of any body only what its convex hull touches, so small balls at the
corners of the whole hull are all that the collision needs; a decomposition into convex parts would find the same
contacts. The start is 1 mm above the floor.
"""

import mujoco
import numpy as np
from scipy.spatial import ConvexHull

DENSITY = 500.0
SECONDS = 2.0
SHIFT = 0.01  # metres
TURN = 0.1  # radians
BALL = 0.0005


def inertia(pieces):
    mass, moment, solids = 0.0, np.zeros(3), []
    for piece in pieces:
        mesh = piece.mesh
        if not piece.watertight:
            try:
                mesh = mesh.convex_hull
            except Exception:  # noqa: BLE001 - a flat piece has no hull and no weight
                continue
        properties = mesh.mass_properties
        weight = DENSITY * properties["volume"]
        if weight > 1e-9:
            solids.append((weight, np.asarray(properties["center_mass"]), DENSITY * np.asarray(properties["inertia"])))
            mass += weight
            moment += weight * solids[-1][1]
    if not mass:
        raise ValueError("nothing in it has a volume")
    centre = moment / mass
    tensor = np.zeros((3, 3))
    for weight, at, own in solids:
        arm = at - centre
        tensor += own + weight * (arm @ arm * np.eye(3) - np.outer(arm, arm))
    return mass, centre, tensor


def feelers(points):
    """Corners of the hull: those farthest out in many directions, and all round the lowest layer."""
    corners = points[ConvexHull(points).vertices]
    if len(corners) <= 200:
        return corners
    index = np.arange(160) + 0.5
    tilt, turn = np.arccos(1 - 2 * index / 160), np.pi * (1 + 5**0.5) * index
    directions = np.stack([np.cos(turn) * np.sin(tilt), np.sin(turn) * np.sin(tilt), np.cos(tilt)], axis=1)
    chosen = set(np.argmax(corners @ directions.T, axis=0))
    low = np.flatnonzero(corners[:, 2] < corners[:, 2].min() + 0.002)
    around = np.linspace(0, 2 * np.pi, 48, endpoint=False)
    chosen |= set(low[np.argmax(corners[low, :2] @ np.stack([np.cos(around), np.sin(around)]), axis=0)])
    return corners[sorted(chosen)]


def drop(pieces):
    """How far the centre moves (metres) and how far the thing turns (radians)."""
    mass, centre, tensor = inertia(pieces)
    points = np.concatenate([piece.vertices for piece in pieces])
    lift = 0.001 - points[:, 2].min()
    balls = "".join(
        '<geom type="sphere" size="%g" pos="%.9g %.9g %.9g"/>' % (BALL, *(point - centre + [0, 0, BALL]))
        for point in feelers(points)
    )
    order = (tensor[0, 0], tensor[1, 1], tensor[2, 2], tensor[0, 1], tensor[0, 2], tensor[1, 2])
    model = mujoco.MjModel.from_xml_string(
        f"""<mujoco><compiler balanceinertia="true"/><option timestep="0.002"/>
        <default><geom friction="0.8 0.005 0.0001" contype="1" conaffinity="0"/></default>
        <worldbody><geom type="plane" size="50 50 1" contype="0" conaffinity="1"/>
        <body pos="{centre[0]} {centre[1]} {centre[2] + lift}"><freejoint/>
        <inertial pos="0 0 0" mass="{mass}" fullinertia="{" ".join("%.9g" % value for value in order)}"/>
        {balls}</body></worldbody></mujoco>"""
    )
    data = mujoco.MjData(model)
    start = data.qpos[:3].copy()
    shift = turn = 0.0
    for _ in range(round(SECONDS / model.opt.timestep)):
        mujoco.mj_step(model, data)
        shift = max(shift, float(np.linalg.norm(data.qpos[:3] - start)))
        turn = max(turn, 2 * float(np.arccos(min(1.0, abs(data.qpos[3])))))
        if shift > 1 or turn > 1.5:
            break
    return shift, turn


def stands(pieces):
    shift, turn = drop(pieces)
    return shift < SHIFT and turn < TURN, f"moves {shift * 1000:.0f} mm and turns {turn:.2f} rad"
