"""A model behind a real HTTP server changes a room: what it is shown, and what becomes of its answers.

    editing.py ROOMGEN FOLDER
"""

import json
import shutil
import subprocess
import sys
import threading
from pathlib import Path

from chat_server import chat_server, pictures_of, text_of

ANSWERS = []    # of the model, in order
QUESTIONS = []  # as they came


def play(question):
    QUESTIONS.append(question)
    return ANSWERS.pop(0)


def main():
    roomgen, folder = sys.argv[1], Path(sys.argv[2])
    server, url = chat_server(play, "editor-1")
    threading.Thread(target=server.serve_forever, daemon=True).start()
    shutil.rmtree(folder, ignore_errors=True)
    subprocess.run([roomgen, "generate", "a living room with a sofa, an armchair, a coffee table and a floor lamp",
                    "-o", folder, "--quiet", "--no-pictures"], check=True, stdout=subprocess.DEVNULL)
    scene = folder / "scene.json"

    def edit(sentence, *answers):
        ANSWERS[:] = [a if isinstance(a, str) else json.dumps(a) for a in answers]
        QUESTIONS.clear()
        done = subprocess.run([roomgen, "edit", scene, sentence, "--designer", "model", "--model", "editor-1",
                               "--base-url", url, "--no-pictures"],
                              capture_output=True, text=True)
        assert not ANSWERS, f"{sentence}: the model was asked {len(QUESTIONS)} times"
        return done

    def objects():
        return {o["id"]: o for o in json.loads(scene.read_text())["objects"]}

    before = objects()
    done = edit("make it cosy by the window", {"operations": [{"do": "lock", "objects": ["sofa-0"]}]})
    assert done.returncode == 0, done.stderr
    assert objects()["sofa-0"]["locked"]
    asked = QUESTIONS[0]["messages"][-1]
    text, pictures = text_of(asked), pictures_of(asked)
    assert "make it cosy by the window" in text and "sofa-0" in text and "window-0" in text
    assert len(pictures) == 1 and pictures[0][:2] == b"\xff\xd8" and len(pictures[0]) < 200_000
    assert '"do": "reshape"' in json.dumps(QUESTIONS[0]["messages"][0]).replace('\\"', '"')

    # Prose and fences around it; and what cannot be done goes back with the reason.
    done = edit("turn the armchair", "Sure!\n```json\n{\"operations\": [{\"do\": \"turn\", \"object\": \"armchair-9\", \"by_deg\": 90}]}\n```",
                {"operations": [{"do": "turn", "object": "armchair-0", "by_deg": 90}]})
    assert done.returncode == 0, done.stderr
    assert "armchair-9" in text_of(QUESTIONS[1]["messages"][-1])
    turned = (objects()["armchair-0"]["yaw_deg"] - before["armchair-0"]["yaw_deg"]) % 360
    assert abs(turned - 90) < 1, turned

    # Nothing changes: unclear, impossible twice, nonsense twice.
    still = scene.read_bytes()
    done = edit("remove that one", {"operations": [], "unclear": "which of the two?"})
    assert done.returncode == 2 and "which of the two?" in done.stderr, done.stderr
    sideways = {"operations": [{"do": "shift", "object": "armchair-0", "by": [50, 0, 0]}]}
    done = edit("move the armchair out", sideways, sideways)
    assert done.returncode == 1 and "armchair-0" in done.stderr, done.stderr
    done = edit("do something", "I cannot help with that.", "Still no.")
    assert done.returncode == 2, (done.returncode, done.stderr)
    assert scene.read_bytes() == still

    # The history tells what was asked.
    history = subprocess.run([roomgen, "history", scene], capture_output=True, text=True, check=True).stdout
    assert "make it cosy by the window" in history, history
    server.shutdown()
    shutil.rmtree(folder)


if __name__ == "__main__":
    main()
