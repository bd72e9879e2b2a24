"""A model server that designs from a script: for each thing the constraints, place and facing of rooms.json.

Speaks the OpenAI protocol on a free port of 127.0.0.1. Whatever it is asked again, it answers the same.
"""

import json
import sys
import threading
from contextlib import contextmanager
from http.server import ThreadingHTTPServer
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tests" / "designer"))

import scripted_model  # noqa: E402


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
    """What scripted_model's handler asks: the answer to one question."""

    def __init__(self, room):
        self.things = {t["id"]: t for t in room["things"]}
        self.asked = []

    def place_answer(self, identifier):
        self.asked.append(identifier)
        thing = self.things[identifier]
        return {
            "reasoning": "as the script says",
            "constraints": thing["constraints"],
            "location": thing["at"],
            "facing": thing.get("facing"),
        }

    def text(self, answer, identifier):
        return json.dumps(answer)


@contextmanager
def serving(room):
    """The base URL of a server that answers for this room."""
    server = ThreadingHTTPServer(("127.0.0.1", 0), scripted_model.Handler)
    server.script = Script(room)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    try:
        yield f"http://127.0.0.1:{server.server_port}/v1"
    finally:
        server.shutdown()
        server.server_close()
