#!/usr/bin/env python3
"""Pictures as wishes: a scripted model behind a real HTTP server sees them when it reads and when it plans; bad files are refused.

    picturing.py ROOMGEN OUT
"""

import json
import struct
import subprocess
import sys
import threading
import zlib
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "checker"))

from chat_server import chat_server, pictures_of, text_of  # noqa: E402
from reading import FORM, thing  # noqa: E402
from roomgen_checker import schemas  # noqa: E402
from reviewing import PLAN  # noqa: E402

SAYS = "A study 4 m wide and 3.6 m deep.\nTwo bookshelves stand against the left wall."
READ = FORM | {
    "pictures": [{"says": SAYS, "scale": "taken from the door, assumed to be 0.9 m wide"}],
    "room": {"type": "study", "words": ["study"],
             "clauses": [{"is": "size", "numbers": [4, 3.6], "name": "", "words": ["4 m wide and 3.6 m deep"]}]},
    "things": [thing("desk", 1, ["desk"]),
               thing("bookshelf", 2, ["bookshelves"], count_words=["Two"],
                     relations=[{"relation": "against", "to": "left wall", "m": 0, "bound": "exact", "denied": False, "each": 0,
                                 "words": ["stand against the left wall"]}])],
    "talk": [{"as": "talk", "words": ["as", "there", "with"]}],
}  # fmt: skip
ASKED = []


def play(question):
    name = question["response_format"]["json_schema"]["name"]
    ASKED.append((name, question))
    answers = {"brief": READ, "plan": PLAN, "review": {"judgement": "good", "operations": []}}
    return json.dumps(answers.get(name, {"reasoning": "", "constraints": "edge", "location": None, "facing": None}))


def blind(question):
    ASKED.append(("blind", question))
    return 400, "image input is not supported"


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def png(width, height, rows=None):
    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    rows = b"".join(b"\0" + b"\x80\x60\x40" * width for _ in range(height)) if rows is None else rows
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")


def jpeg_size(data):
    at = 2
    while data[at + 1] not in (0xC0, 0xC2):
        at += 2 + struct.unpack(">H", data[at + 2 : at + 4])[0]
    height, width = struct.unpack(">HH", data[at + 5 : at + 9])
    return width, height


def serve(answer):
    server, url = chat_server(answer, "eyes-1")
    threading.Thread(target=server.serve_forever, daemon=True).start()
    return server, ["--model", "eyes-1", "--base-url", url]


def main():
    roomgen, folder = sys.argv[1], Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    photo, recording = folder / "photo.png", folder / "answers.jsonl"
    photo.write_bytes(png(1500, 1000))
    recording.unlink(missing_ok=True)

    def generate(*arguments):
        usual = ["-o", folder / "room", "--force", "--no-pictures", "--choose", "off"]
        return subprocess.run([roomgen, *arguments[:1], "generate", *arguments[1:], *usual], capture_output=True, text=True)

    server, model = serve(play)
    wish = ["as there, with a desk", "--image", photo]
    made = generate("--json", *wish, *model, "--record", recording)
    server.shutdown()
    assert made.returncode == 0, made.stderr
    shown = {name: pictures_of(question["messages"][-1]) for name, question in ASKED}
    assert len(shown["brief"]) == 1 and shown["brief"] == shown["plan"], {name: len(all) for name, all in shown.items()}
    assert jpeg_size(shown["brief"][0]) == (1024, 682), jpeg_size(shown["brief"][0])
    form = ASKED[0][1]["response_format"]["json_schema"]
    assert form["strict"] and "pictures" in form["schema"]["required"]
    assert "Image 1: A study 4 m wide" in text_of(dict(ASKED)["plan"]["messages"][-1])
    summary = json.loads(made.stdout)
    sources = {one["clause"]: one["source"] for one in summary["requirements"]}
    assert sources["2 bookshelf"] == "image 1" and sources["a desk"] == "prompt", sources
    assert not [one for one in summary["heard"] if one["as"] == "not understood"], summary["heard"]
    scene = json.loads((folder / "room/scene.json").read_text())
    assert not schemas.errors(scene, "scene"), schemas.errors(scene, "scene")
    assert scene["prompt"].splitlines() == ["as there, with a desk", "Image 1: " + SAYS.replace("\n", " ")]
    notes = json.loads((folder / "room/plan.json").read_text()).get("notes", [])
    assert any("assumed to be 0.9 m" in note for note in notes), notes
    again = generate("--json", *wish, "--designer", "model", "--replay", recording)
    assert json.loads(again.stdout)["requirements"] == summary["requirements"], again.stderr

    server, model = serve(blind)
    sightless = generate("--quiet", *wish, *model)
    server.shutdown()
    assert sightless.returncode == 1 and "takes pictures" in sightless.stderr, sightless.stderr

    broken, text, large, header = (folder / name for name in ("broken.png", "text.png", "large.png", "header.jpg"))
    broken.write_bytes(png(40, 40)[:90])
    text.write_text("no picture")
    large.write_bytes(png(10000, 5000, b""))
    header.write_bytes(b"\xff\xd8\xff\xe0\0\x04ab\xff\xc0\0\x11\x08" + struct.pack(">HH", 9000, 8000) + bytes(20))
    asked = len(ASKED)
    for file, part in ((broken, "broken.png"), (text, "no PNG and no JPEG"), (large, "50 megapixels"), (header, "72 megapixels"),
                       (folder, "regular file"), (folder / "none.png", "none.png")):  # fmt: skip
        refused = generate("--quiet", "a study", "--image", file, *model)
        assert refused.returncode == 1 and part in refused.stderr and refused.stderr.count("\n") == 1, (file, refused)
    assert len(ASKED) == asked
    without = generate("--quiet", "a study", "--image", photo)
    assert without.returncode == 2 and "--model" in without.stderr, without.stderr


if __name__ == "__main__":
    main()
