#!/usr/bin/env python3
"""Does what a model said hold where it stands? Rooms that were played are placed anew, with the answers of then.

    held.py ROOMGEN OUT PLAYED... [--json FILE] [--verbose] [-- MORE OPTIONS OF GENERATE]

A PLAYED folder holds plan.json, as `generate --designer model` wrote it, and calls/NNNN/answer.txt with prompt.txt
beside it. Each question for a place is answered as the model answered it, the next time by its next answer. Of the
answers that could be followed, some pose within 2 cm and 2 degrees breaks no rule and keeps the answer's constraints
by the checker of tests/checker (feasible.py): how many end there? How many members of groups stand within 1 cm of
their places, and what was dropped or swapped though nobody said so? Needs the packages of tests/checker.
"""

import argparse
import json
import math
import re
import subprocess
import sys
from collections import Counter
from dataclasses import replace
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

import feasible  # noqa: E402
from feasible import files  # noqa: E402
from run import posed, share, split, turn_between  # noqa: E402
from roomgen_checker.constraints import parse  # noqa: E402
from script import ASKED, serving_answers  # noqa: E402

feasible.NEAR, feasible.TURN, feasible.STEP = 0.02, math.radians(2.0), 0.01
MEMBER = 0.01
SWAPPED = re.compile(r"for there is no such|for what was chosen found no place|for it found no room on")


class Played:
    """The answers for each thing, in the order in which they were given."""

    def __init__(self, folder):
        self.answers, self.asked, self.moves = {}, Counter(), {}
        for call in sorted((folder / "calls").iterdir()):
            prompt, text = ((call / name).read_text() for name in ("prompt.txt", "answer.txt"))
            asked = ASKED.findall(prompt)
            if not asked or "{" not in text:
                continue
            answer = json.loads(text[text.index("{") : text.rindex("}") + 1])
            self.answers.setdefault(asked[-1], []).append(answer)
            self.moves |= {move["id"]: move for move in answer.get("move") or []}
            for other in answer.get("others") or []:
                self.answers.setdefault(other["id"], []).append(other)

    def next_of(self, identifier):
        known = self.answers.get(identifier)
        if known is None:
            return None
        number = min(self.asked[identifier], len(known) - 1)
        self.asked[identifier] += 1
        return {k: v for k, v in known[number].items() if k != "others"}

    def text(self, question):
        identifier = ASKED.findall(question)[-1]
        answer = self.next_of(identifier) or {"constraints": "", "location": None, "leave_out": "nobody was asked"}
        tail = question[question.index(f"Now place {identifier}:") :]
        others = [one for one in re.findall(r"^([^:\n]+-\d+): ", tail, re.M) if one in self.answers]
        answer["others"] = [{**self.next_of(one), "id": one} for one in others]
        return json.dumps(answer)


def furnish(roomgen, played, folder, out, more):
    with serving_answers(played.text) as url:
        done = subprocess.run(
            [roomgen, "--quiet", "--json", "generate", "--plan", str(folder / "plan.json"), "-o", str(out), "--force",
             "--no-pictures", "--designer", "model", "--model", "played", "--base-url", url, "--seed", "1", *more],
            capture_output=True, text=True,
        )  # fmt: skip
    if done.returncode != 0:
        raise SystemExit(f"{folder}: exit {done.returncode}: {done.stderr}")
    return json.loads(done.stdout)


def known_relations(answer):
    def is_known(text):
        try:
            return parse(text) is not None
        except ValueError:
            return False

    return tuple(text for text in split(answer["constraints"]) if is_known(text))


class Moment(feasible.Moment):
    """A group is feasible as a whole: its members move with it."""

    members = ()

    def holds(self, thing):
        if not super().holds(thing):
            return False
        if not self.members:
            return True
        c, s = math.cos(thing.yaw), math.sin(thing.yaw)
        for member, (x, y, turn) in self.members:
            at = (thing.position[0] + c * x - s * y, thing.position[1] + s * x + c * y, member.position[2])
            if not super().holds(replace(member, position=at, yaw=thing.yaw + turn, relations=())):
                return False
        return True


def in_frame(member, anchor):
    dx, dy = (m - a for m, a in zip(member.centre, anchor.centre))
    c, s = math.cos(-anchor.yaw), math.sin(-anchor.yaw)
    return c * dx - s * dy, s * dx + c * dy, member.yaw - anchor.yaw


class Account:
    def __init__(self, room, identifier):
        self.room, self.id = room, identifier
        self.feasible = self.followed = False
        self.off, self.why = math.inf, ""


def follow(room, folder, moves):
    """An account of each place that was said, and how far members of groups are from theirs."""
    text = files.read_json(folder / "scene.json")
    scene = files.read_scene(text)
    groups = {o["id"]: o.get("group") for o in text["objects"]}
    final = {t.id: t for t in scene.things}
    steps = [json.loads(line) for line in (folder / "trace.jsonl").read_text().splitlines()]
    steps = [step for step in steps if "object" in step]
    placed = {s["object"]: posed(final[s["object"]], **s["pose"]) for s in steps if s.get("pose") and s["object"] in final}
    locals_ = feasible.local_meshes(folder / "scene.glb", scene.things)
    standing, accounts, members = {}, [], []
    for step in steps:
        identifier, attempts = step["object"], step.get("attempts") or []
        answer = attempts[-1]["answer"] if attempts else {}
        template = placed.get(identifier)
        said = not answer.get("usual", True) and answer.get("location")
        if said and not answer.get("spread") and not any("model" in one for one in attempts):
            members.append((identifier, math.dist(template.centre, answer["location"]) if template else math.inf))
        elif said and not answer.get("spread") and template:
            account = Account(room, identifier)
            near = Moment(scene.room, standing.values(), locals_)
            if groups.get(identifier):
                near.members = [
                    (placed[i], in_frame(placed[i], template))
                    for i in placed
                    if i not in standing and i != identifier and groups.get(i) == groups[identifier]
                    and placed[i].mount != "surface" and placed[i].solid
                ]  # fmt: skip
            yaw = None if answer["facing_deg"] is None else math.radians(answer["facing_deg"])
            x, y = answer["location"]
            thing = replace(template, position=(x, y, template.position[2]), relations=known_relations(answer))
            account.feasible = near.is_feasible(thing, feasible.yaws_for(yaw, scene.room))
            end = template if identifier in moves else final[identifier]  # said anew
            account.off = math.dist(end.centre, answer["location"])
            turned = 0.0 if yaw is None else turn_between(end, yaw)
            account.followed = account.off <= feasible.NEAR + 1e-3 and turned <= feasible.TURN + 1e-6
            account.why = "; ".join(attempts[-1].get("objections", []))
            accounts.append(account)
        if template:
            standing[identifier] = template
        for move in step.get("moved", []):
            was = standing.get(move["object"])
            if was:
                yaw = was.yaw + math.radians(move["turned_deg"])
                standing[move["object"]] = replace(was, position=tuple(move["to"]), yaw=yaw)
    return accounts, members, text.get("unplaced", [])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("roomgen")
    parser.add_argument("out", type=Path)
    parser.add_argument("played", type=Path, nargs="+")
    parser.add_argument("--json", type=Path)
    parser.add_argument("--verbose", action="store_true")
    args, more = parser.parse_known_args()
    accounts, members, dropped, swapped = [], [], [], []
    for folder in args.played:
        played = Played(folder)
        told = furnish(args.roomgen, played, folder, args.out / folder.name, [one for one in more if one != "--"])
        some, inside, unplaced = follow(folder.name, args.out / folder.name, played.moves)
        accounts += some
        members += inside
        dropped += [f"{folder.name}: {one['id']}: {one['reason']}" for one in unplaced
                    if "the designer left it out" not in one["reason"]]  # fmt: skip
        swapped += [f"{folder.name}: {note}" for note in told.get("notes", []) if SWAPPED.search(note)]
    good = [a for a in accounts if a.feasible]
    exact = sum(off <= MEMBER + 1e-4 for _, off in members)
    print(f"places said: {len(accounts)}, feasible: {len(good)}")
    print(f"of these within 2 cm and 2 degrees: {share(sum(a.followed for a in good), len(good))}")
    print(f"of all places within 2 cm: {share(sum(a.off <= 0.021 for a in accounts), len(accounts))}")
    print(f"members of groups within 1 cm: {share(exact, len(members))}")
    print(f"dropped unasked: {len(dropped)}, swapped: {len(swapped)}")
    if args.verbose:
        for a in accounts:
            if not a.followed:
                print(f"  {a.room}: {a.id}: {'' if a.feasible else 'in'}feasible, {a.off:.2f} m off {a.why}", file=sys.stderr)
        for identifier, off in members:
            if off > MEMBER:
                print(f"  member {identifier}: {off:.2f} m off", file=sys.stderr)
        print("\n".join(["  dropped " + one for one in dropped] + ["  " + one for one in swapped]), file=sys.stderr)
    if args.json:
        figures = {"said": len(accounts), "feasible": len(good), "followed": sum(a.followed for a in good),
                   "members": len(members), "exact": exact, "dropped": dropped, "swapped": swapped}  # fmt: skip
        args.json.write_text(json.dumps(figures, indent=1))


if __name__ == "__main__":
    main()
