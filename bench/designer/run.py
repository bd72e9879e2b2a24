#!/usr/bin/env python3
"""How closely are suggestions followed? Twenty rooms of a scripted designer, whose word was never the solver's own.

    run.py ROOMGEN FOLDER [--rooms NAME,…] [--json FILE] [--verbose] [-- MORE OPTIONS OF GENERATE]

Prints Markdown. Which suggestions could be followed is told by feasible.py. Needs the packages of tests/checker.
"""

import argparse
import json
import math
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

import feasible  # noqa: E402
from feasible import files, geo  # noqa: E402
from roomgen_checker import report  # noqa: E402
from roomgen_checker.constraints import STRICT, Judge, parse  # noqa: E402
from script import kind_of, plan_of, serving  # noqa: E402

HERE = Path(__file__).resolve().parent
THRESHOLDS = (0.10, 0.25, 0.5, 1.0, 2.0, 3.0)


def furnish(roomgen, room, folder, more):
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "asked.json").write_text(json.dumps(plan_of(room)))
    with serving(room) as url:
        done = subprocess.run(
            [roomgen, "--quiet", "--json", "generate", "--plan", str(folder / "asked.json"), "-o", str(folder / "room"),
             "--force", "--no-pictures", "--designer", "model", "--model", "script", "--base-url", url, *more],
            capture_output=True, text=True,
        )  # fmt: skip
    if done.returncode != 0:
        raise SystemExit(f"{room['name']}: exit {done.returncode}: {done.stderr}")
    return json.loads(done.stdout)


def suggested_yaw(thing, standing):
    """Radians; towards the target from the suggested place."""
    facing = thing.get("facing")
    if isinstance(facing, str):
        target = standing.get(facing)
        return target and geo.yaw_looking([t - a for t, a in zip(target.centre, thing["at"])])
    return None if facing is None else math.radians(facing)


def turn_between(thing, yaw):
    """How far a thing is turned from a yaw; what has no front looks the same from more sides."""
    period = 2 * math.pi if "front" in thing.traits else math.pi
    if "front" not in thing.traits and abs(thing.size[0] - thing.size[1]) < 1e-3:
        period = math.pi / 2
    if "round" in thing.traits:
        return 0.0
    return abs(math.remainder(thing.yaw - yaw, period))


def split(text):
    return tuple(files.split_constraints(text))


class Account:
    """What became of one suggestion."""

    def __init__(self, room, thing):
        self.room, self.thing = room["name"], thing
        self.feasible = False
        self.placed = self.ended = math.inf  # metres from the suggestion
        self.turned = 0.0
        self.held = 0

    @property
    def constraints(self):
        return split(self.thing["constraints"])

    @property
    def followed(self):
        return self.placed <= feasible.NEAR + 1e-6 and self.turned <= feasible.TURN + 1e-6


def as_suggested(thing, template):
    """The thing where the script wants it, as far as its size and mount are known."""
    x, y = thing["at"]
    known = template or files.Thing(
        thing["id"], kind_of(thing["id"]), tuple(thing["size"]), (x, y, 0.0), 0.0,
        "surface" if "on" in thing else thing.get("mount", "floor"), thing.get("on"), ("front",),
    )  # fmt: skip
    return replace(known, position=(x, y, known.position[2]), on=thing.get("on"), relations=split(thing["constraints"]))


def posed(thing, position, yaw_deg):
    return replace(thing, position=tuple(position), yaw=math.radians(yaw_deg))


def follow(room, folder):
    """An account of each suggestion, in the order of placing."""
    scene = files.read_scene(files.read_json(folder / "scene.json"))
    final = {t.id: t for t in scene.things}
    locals_ = feasible.local_meshes(folder / "scene.glb", scene.things)
    script = {t["id"]: t for t in room["things"]}
    standing, accounts = {}, []
    for line in (folder / "trace.jsonl").read_text().splitlines():
        step = json.loads(line)
        if "object" in step:
            accounts.append(judge_step(room, script[step["object"]], step, scene, final, standing, locals_))
        for move in step.get("moved", []):
            was = standing[move["object"]]
            standing[move["object"]] = replace(was, position=tuple(move["to"]), yaw=was.yaw + math.radians(move["turned_deg"]))
    judge = Judge(scene)
    for account in accounts:
        end = final.get(account.thing["id"])
        if end is None:
            continue
        account.ended = math.dist(end.centre, account.thing["at"])
        end = replace(end, relations=account.constraints)
        account.held = sum(judge.holds(end, parse(text)) for text in account.constraints)
    return accounts


def judge_step(room, thing, step, scene, final, standing, locals_):
    account = Account(room, thing)
    end = final.get(thing["id"])
    pose = step.get("pose")
    template = end and (posed(end, pose["position"], pose["yaw_deg"]) if pose else end)
    moment = feasible.Moment(scene.room, standing.values(), locals_)
    yaw = suggested_yaw(thing, standing)
    account.feasible = moment.is_feasible(as_suggested(thing, template), feasible.yaws_for(yaw, scene.room))
    if pose and template:
        account.placed = math.dist(pose["position"][:2], thing["at"])
        account.turned = 0.0 if yaw is None else turn_between(template, yaw)
        standing[thing["id"]] = template
    return account


def violations(folder):
    options = report.Options(files.Categories.default(), STRICT, "auto", None, feasible.reach.LENIENCE)
    return report.check_file(folder / "scene.json", options)["violations"]


def share(part, whole):
    return f"{part / whole:.1%} ({part}/{whole})" if whole else "-"


def figures_of(accounts, faults):
    good = [a for a in accounts if a.feasible]
    count = lambda test: sum(1 for a in good if test(a))  # noqa: E731
    return {
        "suggestions": len(accounts),
        "feasible": len(good),
        "followed when placed": count(lambda a: a.followed),
        "placed within": {str(t): count(lambda a: a.placed <= t + 1e-6) for t in THRESHOLDS},
        "ended within": {str(t): count(lambda a: a.ended <= t + 1e-6) for t in THRESHOLDS},
        "constraints": sum(len(a.constraints) for a in good),
        "held": sum(a.held for a in good),
        "all constraints": sum(len(a.constraints) for a in accounts),
        "all held": sum(a.held for a in accounts),
        "left out": sum(1 for a in accounts if math.isinf(a.ended)),
        "violations": faults,
    }


def print_figures(f):
    print(f"{f['feasible']} of {f['suggestions']} suggestions can be followed; of these:\n")
    print("| within | when placed | in the end |\n|---|---|---|")
    print(f"| 0.10 m and 5 degrees | {share(f['followed when placed'], f['feasible'])} | |")
    for t in THRESHOLDS[1:]:
        print(f"| {t:g} m | {share(f['placed within'][str(t)], f['feasible'])} | {share(f['ended within'][str(t)], f['feasible'])} |")
    print(f"\nTheir constraints held: {share(f['held'], f['constraints'])}; of all answers "
          f"{share(f['all held'], f['all constraints'])}; left out: {f['left out']}; violations: {f['violations']}")  # fmt: skip


def print_accounts(accounts):
    for a in accounts:
        if not a.feasible or not a.followed or a.ended > 0.25 or a.held < len(a.constraints):
            print(f"  {a.room}: {a.thing['id']}: {'' if a.feasible else 'in'}feasible, placed {a.placed:.2f} m off, turned "
                  f"{math.degrees(a.turned):.0f}, ended {a.ended:.2f} m off, {a.held}/{len(a.constraints)}", file=sys.stderr)  # fmt: skip


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("roomgen")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--rooms", default="")
    parser.add_argument("--json", type=Path)
    parser.add_argument("--verbose", action="store_true")
    parser.add_argument("more", nargs="*", help="options of generate, after --")
    args = parser.parse_args()
    wanted = set(filter(None, args.rooms.split(",")))
    accounts, faults = [], 0
    for room in json.loads((HERE / "rooms.json").read_text()):
        if wanted and room["name"] not in wanted:
            continue
        folder = args.folder / room["name"].replace(" ", "-")
        furnish(args.roomgen, room, folder, args.more)
        accounts += follow(room, folder / "room")
        found = violations(folder / "room")
        faults += len(found)
        if args.verbose:
            for v in found:
                print(f"  {room['name']}: VIOLATION {v}", file=sys.stderr)
    figures = figures_of(accounts, faults)
    print_figures(figures)
    if args.verbose:
        print_accounts(accounts)
    if args.json:
        args.json.write_text(json.dumps(figures, indent=1))


if __name__ == "__main__":
    main()
