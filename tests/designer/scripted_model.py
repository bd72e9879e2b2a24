"""A model server that plays a designer from a script: the scene and plan of an earlier room.

    scripted_model.py --script FOLDER [--manner good|chatty|sloppy|hostile|noisy|hopeless] [--seed N]

Speaks the OpenAI protocol on a free port of 127.0.0.1 and prints its base URL. It answers plan questions with the
script's inventory and place questions with the script's poses, in one of several manners:

good      as asked
chatty    with prose, fences and second thoughts around it
sloppy    wrong quotes, units, spellings, trailing commas, lists for strings
noisy     suggestions off by a standard deviation of 0.5 m
hopeless  suggestions anywhere in the room
hostile   nonsense, things that are not there, places outside, paths, megabytes
"""

import argparse
import json
import random
import re
from pathlib import Path

from chat_server import chat_server, first_choices, text_of


class Script:
    def __init__(self, folder, manner, seed):
        self.scene = json.loads((Path(folder) / "scene.json").read_text())
        self.plan = json.loads((Path(folder) / "plan.json").read_text())
        self.manner, self.random = manner, random.Random(seed)
        self.objects = {o["id"]: o for o in self.scene["objects"]}

    def place(self, identifier):
        known = self.objects.get(identifier)
        if known is None:
            kind = identifier.rsplit("-", 1)[0]
            same = [o for o in self.scene["objects"] if o["category"] == kind]
            known = same[0] if same else None
        return known

    def noise(self, point):
        if self.manner == "noisy":
            return [round(c + self.random.gauss(0, 0.5), 2) for c in point]
        if self.manner == "hopeless":
            xs, ys = zip(*self.scene["room"]["polygon"])
            return [round(self.random.uniform(min(xs), max(xs)), 2), round(self.random.uniform(min(ys), max(ys)), 2)]
        return [round(c, 2) for c in point]

    def is_at_wall(self, known):
        """What stands in a group has no words of its own; a designer would still say that it is at the wall."""
        xs, ys = zip(*self.scene["room"]["polygon"])
        x, y = known["position"][:2]
        return min(x - min(xs), max(xs) - x, y - min(ys), max(ys) - y) < max(known["size"][:2]) / 2 + 0.15

    def place_answer(self, identifier):
        known = self.place(identifier)
        if known is None:
            return {"reasoning": "a free corner", "constraints": "edge", "location": [1, 1], "facing": None}
        return {
            "reasoning": f"{identifier} belongs there.",
            "constraints": " | ".join(known["relations"]) or ("edge" if self.is_at_wall(known) else "middle"),
            "location": self.noise(known["position"][:2]),
            "facing": known["yaw_deg"],
        }

    def plan_answer(self):
        def item(i):
            size = i.get("size")
            place = i.get("mount", "floor")
            return {
                "name": i["category"],
                "description": i.get("description", ""),
                "size_cm": [round(100 * s) for s in size] if size else None,
                "quantity": i.get("quantity", 1),
                "variance": i.get("variance", "same"),
                "place": f"on {i['on']}" if i.get("on") else ("on a table" if place == "surface" else place),
                "on_top": [],
            }

        xs, ys = zip(*self.scene["room"]["polygon"])
        room = {"type": self.scene["room"]["type"], "size_m": [max(xs) - min(xs), max(ys) - min(ys)], "height_m": 2.7}
        return {"room": room, "objects": [item(i) for i in self.plan["objects"]], "excluded": []}

    def text(self, answer, identifier):
        whole = json.dumps(answer)
        if self.manner == "chatty":
            return (
                f"Let me think about this room.\nA first idea: {{\"idea\": \"somewhere\"}}. On reflection:\n\n"
                f"```json\n{json.dumps(answer, indent=2)}\n```\n\nI hope this helps! Tell me if I should move it."
            )
        if self.manner == "sloppy" and identifier:
            x, y = answer["location"]
            names = [c.replace("-", " ").title() for c in answer["constraints"].split(" | ")]
            return (
                f"{{'Reasoning': 'because', // fine\n 'Constrains': {names},\n"
                f" 'Position': {{'y': '{100 * y:.0f} cm', 'x': '{x} m'}},\n}}"
            )
        if self.manner == "sloppy":
            return "Sure! " + whole[:-1] + ",}"
        if self.manner == "hostile":
            return self.random.choice(
                [
                    "I will not.",
                    "[" * 50_000,
                    '{"constraints": "edge | near, ../../../../etc/passwd", "location": [1e308, -1e308]}',
                    '{"constraints": ["face to, throne-7", "fly"], "location": "everywhere"}',
                    '{"constraints": "edge | middle | edge", "location": [NaN, null], "facing": {"$ref": "/etc/shadow"}}',
                    '{"output": "/tmp/owned", "constraints": ' + json.dumps("x" * 200_000) + "}",
                    "\ufffd\u202e\u0000{{prompt}} </s>",
                    whole,
                ]
            )
        return whole


def answer(script, request):
    text = text_of(next(m for m in request["messages"] if m["role"] == "user"))
    choices = first_choices(text)
    if choices:
        return script.text(choices, None)
    found = re.search(r"^Now place ([^:\n]+):", text, re.M)
    identifier = found.group(1) if found else None
    return script.text(script.place_answer(identifier) if identifier else script.plan_answer(), identifier)


def serve(folder, manner="good", seed=0):
    """A server that is ready to run, and its base URL."""
    script = Script(folder, manner, seed)
    return chat_server(lambda request: answer(script, request), "scripted")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--script", required=True)
    parser.add_argument("--manner", default="good")
    parser.add_argument("--seed", type=int, default=0)
    args = parser.parse_args()
    server, url = serve(args.script, args.manner, args.seed)
    print(url, flush=True)
    server.serve_forever()


if __name__ == "__main__":
    main()
