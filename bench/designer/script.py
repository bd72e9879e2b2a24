"""A model server that designs from a script: for each thing the constraints, place and facing of rooms.json.

Speaks the OpenAI protocol on a free port of 127.0.0.1. Whatever it is asked again, it answers the same.
"""

import json
import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tests" / "designer"))

from chat_server import first_choices, text_of  # noqa: E402
from chat_server import serving as serving_model  # noqa: E402

ASKED = re.compile(r"^Now place ([^:\n]+):", re.M)


def plan_of(room):
    """The plan.json of a room of the script."""
    return {
        "format": "roomgen-plan",
        "version": 1,
        "prompt": room["name"],
        "seed": 1,
        "room": room["room"],
        "objects": [item_of(thing) for thing in room["things"]],
    }


def kind_of(identifier):
    return identifier.rsplit("-", 1)[0]


def item_of(thing):
    item = {"category": kind_of(thing["id"]), "description": kind_of(thing["id"]), "size": thing["size"], "quantity": 1}
    if "on" in thing:
        item.update(mount="surface", on=thing["on"])
    if "mount" in thing:
        item["mount"] = thing["mount"]
    return item


class Script:
    """The answer to one question."""

    def __init__(self, room):
        self.things = {t["id"]: t for t in room["things"]}

    def text(self, question):
        thing = self.things[ASKED.findall(question)[-1]]
        return json.dumps({
            "reasoning": "as the script says",
            "constraints": thing["constraints"],
            "location": thing["at"],
            "facing": thing.get("facing"),
        })  # fmt: skip


def serving_answers(text):
    """The base URL of a server that answers questions for places as a function of their text says."""

    def answer(request):
        question = "\n".join(text_of(m) for m in request["messages"] if m["role"] == "user")
        if ASKED.search(question):
            return text(question)
        return json.dumps(first_choices(question) or {})

    return serving_model(answer, "script")


def serving(room):
    return serving_answers(Script(room).text)
