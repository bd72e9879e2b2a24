"""The protocol's official Python client furnishes a room, changes it, looks at it and asks for wrong things.

python_client.py ROOMGEN FOLDER: FOLDER is emptied and used. Each revision of the protocol's two kinds is spoken.
"""

import asyncio
import base64
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import anyio
from mcp import Client, MCPError, StdioServerParameters

TOOLS = {"read", "plan", "candidates", "generate", "compose", "optimise", "create", "edit", "preview", "check", "explain",
         "undo", "redo", "history", "branch", "import", "review", "render", "export", "rooms", "delete"}  # fmt: skip



def text_of(result):
    return "\n".join(part.text for part in result.content if part.type == "text")


def picture_of(result):
    """Width and height of the only picture."""
    pictures = [part for part in result.content if part.type == "image"]
    assert len(pictures) == 1 and pictures[0].mime_type == "image/png", result
    png = base64.b64decode(pictures[0].data)
    assert png.startswith(b"\x89PNG\r\n\x1a\n")
    return int.from_bytes(png[16:20], "big"), int.from_bytes(png[20:24], "big")


async def done(client, tool, **arguments):
    result = await client.call_tool(tool, arguments)
    assert not result.is_error, (tool, text_of(result))
    return result


async def refused(client, tool, part, **arguments):
    """The tool says what is wrong, for the model to read."""
    result = await client.call_tool(tool, arguments)
    assert result.is_error, (tool, arguments, text_of(result))
    assert part in text_of(result), (part, text_of(result))


async def furnish(client):
    names = {tool.name for tool in (await client.list_tools()).tools}
    assert names == TOOLS, names
    planned = await done(client, "plan", prompt="a small study with a desk and a chair", save_to="plans/study.json")
    assert any(thing["category"] == "desk" for thing in planned.structured_content["rooms"][0]["things"])
    told = []

    async def progress(amount, total, message):
        told.append((amount, total, message))

    made = await client.call_tool("generate", {"folder": "study", "plan": "plans/study.json"},
                                  progress_callback=progress)
    assert not made.is_error, text_of(made)
    assert made.structured_content["room"] == "study" and made.structured_content["objects"] >= 2
    assert max(picture_of(made)) == 512
    assert len(told) > 2 and told[0][0] >= 0, told
    assert all(before[0] < after[0] for before, after in zip(told, told[1:])), told
    assert all(amount <= total and message for amount, total, message in told), told


async def change(client, root):
    scene = root / "study" / "scene.json"
    first = scene.read_bytes()
    edited = await done(client, "edit", room="study", change="turn the desk chair by 10 degrees")
    assert edited.structured_content["changes"] and scene.read_bytes() != first
    picture_of(edited)
    moved = await done(client, "edit", room="study", picture="none",
                       operations=[{"do": "lock", "objects": ["desk-0"]}])
    assert moved.structured_content["state"] == 3
    meant = await done(client, "edit", room="study", change="remove the desk chair", dry_run=True)
    assert meant.structured_content["operations"][0]["do"] == "remove"
    history = (await done(client, "history", room="study")).structured_content
    assert [entry["by"] for entry in history["entries"]] == ["file", "agent", "agent"]
    undone = await done(client, "undo", room="study", steps=5)
    assert undone.structured_content["steps"] == 2 and scene.read_bytes() == first
    await refused(client, "undo", "nothing to undo", room="study")
    await done(client, "redo", room="study", picture="iso")
    assert (await done(client, "history", room="study", **{"from": 1, "to": 2})).structured_content["differences"]


async def look(client, root):
    everything = (await done(client, "explain", room="study")).structured_content
    desk = next(thing for thing in everything["objects"] if thing["id"] == "desk-0")
    assert (await done(client, "check", room="study/scene.json")).structured_content["valid"]
    why = (await done(client, "explain", room="study", object="desk-0")).structured_content
    assert why["placed"]["object"] == "desk-0"
    here = await done(client, "preview", room="study", object="desk-0", position=desk["position"][:2])
    assert here.structured_content["feasible"], text_of(here)
    outside = await done(client, "preview", room="study", object="desk-0", position=[99, 99])
    assert not outside.structured_content["feasible"] and outside.structured_content["reason"]
    drawn = await done(client, "render", room="study", view="eye", pixels=200, file="pictures/eye.png")
    assert max(picture_of(drawn)) == 200 and (root / "pictures/eye.png").read_bytes().startswith(b"\x89PNG")
    exported = await done(client, "export", room="study", file="out/study.glb")
    glb = (root / "out/study.glb").read_bytes()
    assert glb.startswith(b"glTF") and len(glb) == exported.structured_content["bytes"]


WISH = "a reading room with a rust armchair and a globe"
DESIGN = {
    "concept": "An armchair by the window.",
    "room": {"type": "library", "size_m": [4.0, 3.6], "height_m": 2.6},
    "openings": [{"kind": "door", "wall": "east", "at": 0.2, "width": 0.9}, {"kind": "window", "wall": "south", "at": 0.5, "width": 1.6}],
    "groups": [{"id": "sitting", "things": [
        {"part": "chair", "name": "armchair", "description": "rust leather armchair", "quantity": 1},
        {"part": "table", "name": "side table", "description": "round oak side table", "quantity": 1, "where": "astride chair"}]}],
    "objects": [{"name": "bookshelf", "description": "oak bookshelf", "size_cm": [100, 32, 200], "quantity": 1, "place": "floor"},
                {"name": "reading lectern", "description": "reading lectern of oak", "quantity": 1, "place": "floor"}],
}  # fmt: skip


async def design(client, root):
    """An agent designs as a model does: reading, whole plan, choices by label, places; what is not followed is told."""
    read = await done(client, "read", prompt=WISH)
    assert "r1: a armchair" in text_of(read) and "r2: rust armchair" in text_of(read), text_of(read)
    brief = read.structured_content["brief"]
    brief["things"] = [thing for thing in brief["things"] if thing["name"] != "globe"]
    again = await done(client, "read", prompt=WISH, brief=brief)
    assert not any("globe" in each["clause"] for each in again.structured_content["requirements"]), again
    await refused(client, "read", "/brief", prompt=WISH, brief={"things": "none"})
    made = await done(client, "create", words="a lectern of oak with a sloped top", name="reading lectern", size=[0.5, 0.4, 1.1])
    picture_of(made)
    assert made.structured_content["name"] == "reading lectern"
    found = await done(client, "candidates", things=["reading lectern", "globe"])
    assert "1a: reading lectern" in text_of(found) and "2a: globe" in text_of(found), text_of(found)
    offered = await done(client, "candidates", prompt=WISH, design=DESIGN)
    assert any(part.type == "image" and part.mime_type == "image/jpeg" for part in offered.content), offered
    rows = [line for line in text_of(offered).splitlines() if line[:1].isdigit()]
    chair = next(line for line in rows if "armchair" in line).split(".")[0]
    shelf = next(line for line in rows if "bookshelf" in line).split(".")[0]
    room = await done(client, "generate", folder="designed", prompt=WISH, design=DESIGN, picture="elevation",
                      choices=[{"item": chair, "take": chair + "a", "paint": "rust leather"},
                               {"item": shelf, "take": "leave out", "why": "no books here"}, {"item": "99", "take": "99a"}],
                      places=[{"id": "armchair-0", "constraints": "near, window-0", "location": [2.0, 1.6], "facing": 180},
                              {"id": "harp-0", "location": [1, 1]}])  # fmt: skip
    notes = "\n".join(room.structured_content["notes"])
    for part in ("does not say where it is", "harp-0", "no books here", "99"):
        assert part in notes, (part, notes)
    scene = json.loads((root / "designed/scene.json").read_text())
    things = {thing["id"]: thing for thing in scene["objects"]}
    assert "rust" in json.dumps(things["armchair-0"]["asset"]) and "bookshelf-0" not in things, things
    lectern = next(thing for name, thing in things.items() if name.startswith("lectern"))
    assert lectern["asset"]["library"] == "kept", lectern
    assert max(abs(a - b) for a, b in zip(things["armchair-0"]["position"], [2.0, 1.6])) < 0.3, things["armchair-0"]
    await refused(client, "generate", "/design", folder="other", prompt=WISH, design={"objects": []})
    await refused(client, "generate", "of one room", folder="other", prompt="a flat: a bedroom and a kitchen", design=DESIGN)
    await refused(client, "generate", "either prompt or plan", folder="other", plan="plans/study.json", design=DESIGN)
    seen = await done(client, "review", room="designed")
    assert len([part for part in seen.content if part.type == "image"]) == 4 and "r1: " in text_of(seen), text_of(seen)
    photo = await done(client, "render", room="designed", pixels=200, camera={"eye": [1, 1, 1.6], "target": [3, 3, 1]})
    assert picture_of(photo) == (200, 150)
    await refused(client, "render", "/camera/eye", room="designed", camera={"eye": [99, 1, 1.6], "target": [3, 3, 1]})
    assert "designed" in (await done(client, "rooms")).structured_content["rooms"]
    (root / "designed/own.txt").write_text("mine")
    await done(client, "delete", room="designed")
    assert [each.name for each in (root / "designed").iterdir()] == ["own.txt"]
    shutil.rmtree(root / "designed")
    await refused(client, "delete", "rooms are", room="designed")


async def clauses(client, root, roomgen):
    """Tool and command count the same, and nothing that an edit withdrew."""
    before = (await done(client, "check", room="study")).structured_content
    await done(client, "edit", room="study", change="remove the desk chair", picture="none")
    after = (await done(client, "check", room="study")).structured_content
    ledger = json.loads((await client.read_resource("roomgen:///study/ledger.json")).contents[0].text)
    verdicts = [each["verdict"] for each in ledger["requirements"]]
    assert "withdrawn" in verdicts and after["not_met"] == [], (ledger, after)
    assert after["asked"] == len(verdicts) - verdicts.count("withdrawn") < before["asked"], (before, after)
    assert after["met"] == after["asked"], after
    said = subprocess.run([roomgen, "check", str(root / "study/scene.json"), "--json", "--no-default-libraries",
                           "--cache", str(root.parent / "cache")], capture_output=True, text=True)
    assert {**after, "format": "roomgen-scene"} == json.loads(said.stdout), said
    await done(client, "undo", room="study", picture="none")


async def long_answers(client, root):
    """A crowd is explained page by page, each of a size that a model can read."""
    scene = json.loads((root / "study/scene.json").read_text())
    desk = next(thing for thing in scene["objects"] if thing["id"] == "desk-0")
    scene["objects"] = [{**desk, "id": f"desk-{i}", "relations": []} for i in range(500)]
    (root / "crowd").mkdir()
    (root / "crowd/scene.json").write_text(json.dumps(scene))
    ids, skip = [], 0
    while skip is not None:
        page = await done(client, "explain", room="crowd", skip=skip)
        assert len(text_of(page)) + len(json.dumps(page.structured_content)) < 60_000
        ids += [thing["id"] for thing in page.structured_content["objects"]]
        skip = page.structured_content.get("next")
    assert ids == [thing["id"] for thing in scene["objects"]], len(ids)
    await refused(client, "explain", "/skip", room="crowd", skip=10**6)
    shutil.rmtree(root / "crowd")


async def as_meant(client, root):
    """What clients in strict mode and careless models send: null and "" for what is left out, texts of values."""
    plan = "plans/study.json"
    for left_out in ({"prompt": None, "seed": None, "size": None, "floor_plan": None},
                     {"prompt": "", "size": "", "floor_plan": ""}):
        await done(client, "generate", folder="meant", plan=plan, picture="none", replace=True, **left_out)
    for given in ({"replace": True, "seed": 7.0}, {"replace": True, "seed": "7"},
                  {"replace": "true", "seed": 7, "plan": ""}):
        await done(client, "generate", folder="meant", prompt="a study with a desk", picture="none", **given)
    lock = '{"do": "lock", "objects": ["desk-0"]}'
    for operations in ("[" + lock + "]", [lock]):
        await done(client, "edit", room="meant", operations=operations, picture="none", dry_run=True)
    turn = {"do": "turn", "object": "desk-0", "by_deg": 0, "position": None, "relations": [], "on": ""}
    await done(client, "edit", room="meant", operations=[turn], picture="none", dry_run=True)
    for position in ("[1.5, 1.5]", "1.5, 1.5", [1.5, 1.5]):
        await done(client, "preview", room="meant/", object="desk-0", position=position)
    await done(client, "preview", room="./meant/scene.json", object="desk-0", position=[1.5, 1.5])
    await refused(client, "preview", "/position: expected a list of numbers", room="meant", object="desk-0",
                  position={"x": 1.5, "y": 1.5})
    for operations in (None, []):
        await done(client, "edit", room="meant", change="turn the desk by 0 degrees", operations=operations,
                   picture="none", dry_run=True)
        await refused(client, "edit", "either change or operations", room="meant", change="", operations=operations)
    await refused(client, "plan", "\"prompt\" is missing", prompt="")
    shutil.rmtree(root / "meant")


async def resources(client, root):
    listed = {str(each.uri) for each in (await client.list_resources()).resources}
    guides = {uri for uri in listed if uri.startswith("roomgen:///docs/")}
    assert listed - guides == {"roomgen:///study/scene.json", "roomgen:///study/ledger.json"}, listed
    for uri in guides:
        guide = (await client.read_resource(uri)).contents[0]
        assert guide.mime_type == "text/markdown" and len(guide.text) > 500 and "{{" not in guide.text, uri
    assert "roomgen:///docs/skill.md" in guides and "roomgen:///docs/plan-form.md" in guides
    scene = await client.read_resource("roomgen:///study/scene.json")
    assert scene.contents[0].text == (root / "study/scene.json").read_text()
    ledger = json.loads((await client.read_resource("roomgen:///study/ledger.json")).contents[0].text)
    assert ledger["requirements"]
    templates = await client.list_resource_templates()
    assert len(templates.resource_templates) == 2
    for uri in ("roomgen:///none/scene.json", "roomgen:///../scene.json", "file:///etc/passwd"):
        try:
            await client.read_resource(uri)
            raise AssertionError(uri + " was read")
        except MCPError:
            pass


async def wrong_calls(client, root):
    outside = root.parent / "outside"
    outside.mkdir(exist_ok=True)
    shutil.copy(root / "study/scene.json", outside)
    os.symlink(outside, root / "link")
    before = (root / "study/scene.json").read_bytes()
    for path in ("../outside", str(outside), "link", "study/../../outside"):
        await refused(client, "check", "leads out of the root folder", room=path)
        await refused(client, "edit", "leads out of the root folder", room=path, change="remove the desk")
        await refused(client, "generate", "leads out of the root folder", folder=path + "/new", prompt="a study")
        await refused(client, "export", "leads out of the root folder", room="study", file=path + "/x.glb")
    assert sorted(each.name for each in outside.iterdir()) == ["scene.json"]
    await refused(client, "check", "rooms are: study", room="stdy")
    await refused(client, "check", "expected a text", room=7)
    await refused(client, "check", "\"room\" is missing")
    await refused(client, "generate", "holds a room already", folder="study", prompt="a study")
    await refused(client, "generate", "either prompt or plan", folder="other")
    await refused(client, "generate", "below the root", folder=".", prompt="a study")
    for tool, where in (("plan", {"save_to": "tiny.json"}), ("generate", {"folder": "tiny"})):
        await refused(client, tool, "no bed finds a place in it", prompt="a bedroom", size="2x2", **where)
    assert not list(root.glob("tiny*"))
    await refused(client, "render", "does not end with .png", room="study", file="study/scene.json")
    await refused(client, "check", "is no scene", room="study/scene.glb")
    await refused(client, "export", "a room's own file", room="study", file="study/scene.glb")
    await refused(client, "plan", "a room's own file", prompt="a study", save_to="study/plan.json")
    os.symlink(outside, root / ".made.link")
    os.rename(root / ".made", root / ".made.real")
    os.rename(root / ".made.link", root / ".made")
    await refused(client, "create", "leads out of the root folder", words="a round stool with three legs")
    os.unlink(root / ".made")
    os.rename(root / ".made.real", root / ".made")
    (root / "package.json").write_text("{}")
    await refused(client, "plan", "not of this kind", prompt="a study", save_to="package.json")
    await done(client, "plan", prompt="a study", save_to="plans/study.json")
    await refused(client, "plan", "/size", prompt="a study", size="big")
    await refused(client, "edit", "unknown key \"by\"", room="study",
                  operations=[{"do": "turn", "object": "desk-0", "by": 9}])
    await refused(client, "edit", "", room="study", change="sing a song")
    await refused(client, "edit", "", room="study",
                  operations=[{"do": "put", "object": "desk-0", "position": [99, 99]}])
    await refused(client, "explain", "did you mean \"desk-0\"?", room="study", object="desk-1")
    try:
        await client.call_tool("fly", {})
        raise AssertionError("an unknown tool was called")
    except MCPError as error:
        assert "preview" in str(error)
    assert (root / "study/scene.json").read_bytes() == before
    os.unlink(root / "link")


async def programs(client, root):
    """Rooms by numbers and by programs, which are rooms like others; wrong programs come back with the place."""
    made = (await done(client, "compose", folder="reading", prompt="a reading room with two bookshelves", seats="3..4",
                       steps=4000, rounds=2)).structured_content
    seats = next(measure for measure in made["measures"] if measure["name"] == "seats")
    assert seats["asked"] == [3, 4] and (not made["met"] or 3 <= seats["reached"] <= 4), made
    assert (await done(client, "check", room="reading")).structured_content["valid"]
    program = json.loads((root / "reading/program.json").read_text())
    again = await done(client, "optimise", folder="again", program=program, steps=3000)
    assert {each["name"] for each in again.structured_content["constraints"]} == set(program["constraints"])
    assert max(picture_of(again)) == 512
    await done(client, "optimise", folder="third", file="reading/program.json", steps=500, picture="none")
    first = (await done(client, "explain", room="again")).structured_content["objects"][0]["id"]
    await done(client, "edit", room="again", operations=[{"do": "lock", "objects": [first]}], picture="none")
    await refused(client, "optimise", "holds a room already", folder="again", program=program)
    await refused(client, "optimise", "either program or file", folder="fourth")
    await refused(client, "optimise", "leads out of the root folder", folder="fourth", file="../program.json")
    name = next(iter(program["sets"]))
    program["sets"][name]["factory"] = "bokshelf"
    await refused(client, "optimise", "bokshelf", folder="fourth", program=program)
    await refused(client, "compose", "/seats", folder="fourth", prompt="a study", seats="many")
    assert not (root / "fourth").exists()


async def give_up(client, root):
    """A call that is cancelled while it works writes nothing, and the next one is answered."""
    with anyio.CancelScope() as scope:

        async def progress(*_):
            scope.cancel()

        await client.call_tool("generate", {"folder": "flat", "prompt": "a flat with two bedrooms and a kitchen"},
                               progress_callback=progress)
    assert scope.cancelled_caught
    assert (await done(client, "check", room="study")).structured_content["valid"]
    assert not (root / "flat").exists()


async def talk(roomgen, root, mode):
    root.mkdir(parents=True)
    server = StdioServerParameters(command=roomgen, args=["mcp", "--root", str(root), "--no-default-libraries",
                                                          "--cache", str(root.parent / "cache")])
    async with Client(server, mode=mode) as client:
        await furnish(client)
        await change(client, root)
        await look(client, root)
        await clauses(client, root, roomgen)
        await design(client, root)
        if mode == "auto":  # whatever the revision
            await long_answers(client, root)
            await as_meant(client, root)
        await resources(client, root)
        await wrong_calls(client, root)
        await programs(client, root)
        await give_up(client, root)
        await done(client, "check", room="study")


def main():
    roomgen, folder = sys.argv[1], Path(sys.argv[2])
    shutil.rmtree(folder, ignore_errors=True)
    for mode in ("legacy", "auto"):
        asyncio.run(talk(roomgen, folder / mode / "root", mode))


if __name__ == "__main__":
    main()
