#!/usr/bin/env python3
"""Do other programs find in scene.glb what is in the room?

    bench/readers/run.py ROOMGEN FOLDER [--rooms 60] [--trips 10] [--only trimesh,three.js,Blender,Godot] [--results FILE]

Furnishes the lines of prompts.txt offline (rooms that FOLDER already has are kept), most of them with things that no
library has and roomgen creates, and lets trimesh, three.js, Blender and Godot load each scene.glb. A reader has found a
thing when a node of it tells the thing's id (Godot, which keeps no extras: has its name). In the first --trips rooms
three.js and Blender also move one thing and write the file again, with extras and without: `roomgen import` must tell
that move and nothing else.

The readers are installed into build/readers, Godot 3 with its X server by apt (as root; left out where that cannot be).
Exit 1 if anything was not found.
"""

import argparse
import datetime
import json
import os
import platform
import re
import shutil
import struct
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
TOOLS = ROOT / "build" / "readers"
PYTHON = TOOLS / "venv" / "bin" / "python"
MOVE = 0.15  # as the readers do
SAME = 2e-3


def run(*command, **options):
    return subprocess.run([str(part) for part in command], capture_output=True, text=True, **options)


def install(readers):
    """The readers of these that can be had."""
    wanted = {"trimesh": "trimesh", "Blender": "bpy"}
    packages = [package for name, package in wanted.items() if name in readers]
    if packages and not PYTHON.exists():
        run(sys.executable, "-m", "venv", TOOLS / "venv", check=True)
    if packages:
        run(PYTHON, "-m", "pip", "install", "-q", "numpy", *packages, check=True)
    if "three.js" in readers and not (TOOLS / "node_modules" / "three").exists():
        run("npm", "install", "--silent", "--no-save", "--prefix", TOOLS, "three", check=True)
    if "Godot" in readers and not (shutil.which("godot3") and shutil.which("xvfb-run")):
        run("apt-get", "install", "-y", "--no-install-recommends", "godot3", "xvfb", "xauth",
            env={**os.environ, "DEBIAN_FRONTEND": "noninteractive"})
    return [name for name in readers if name != "Godot" or shutil.which("godot3")]


def make_rooms(roomgen, folder, count):
    prompts = (HERE / "prompts.txt").read_text().splitlines()[:count]
    rooms = []
    for number, prompt in enumerate(prompts, 1):
        room = folder / f"{number:03d}"
        if not (room / "scene.glb").exists():
            made = run(roomgen, "--quiet", "generate", prompt, "-o", room, "--no-pictures", "--seed", "1")
            if made.returncode:
                sys.exit(f"{prompt}: {made.stderr}")
        rooms.append(room)
    return rooms


def objects_of(room):
    return json.loads((room / "scene.json").read_text())["objects"]


def names_by_id(room):
    """What the nodes of the room's things are called, read without any of the readers."""
    data = (room / "scene.glb").read_bytes()
    gltf = json.loads(data[20 : 20 + struct.unpack_from("<I", data, 12)[0]])
    marked = [(node.get("extras", {}), node["name"]) for node in gltf["nodes"]]
    return {extras["id"]: name for extras, name in marked if "id" in extras and "shell" not in extras}


def thing_to_move(room):
    """One that stands on the floor, with a blank in its name if there is one."""
    ids = [thing["id"] for thing in objects_of(room) if thing.get("mount", "floor") == "floor"]
    return next((one for one in ids if " " in one), ids[0])


def answers(output, mark=""):
    lines = (line[len(mark):] for line in output.splitlines() if line.startswith(mark + "{"))
    return [json.loads(line) for line in lines]


def ask_trimesh(rooms, _):
    return run(PYTHON, HERE / "read_trimesh.py", *(room / "scene.glb" for room in rooms))


def with_trips(rooms, trips, name):
    tasks = [str(room / "scene.glb") for room in rooms]
    for number, room in enumerate(rooms[:trips]):
        tasks[number] += f"\t{thing_to_move(room)}\t{room / name}"
    return "\n".join(tasks)


def ask_blender(rooms, trips):
    return run(PYTHON, HERE / "read_blender.py", input=with_trips(rooms, trips, "blender"))


def ask_three(rooms, trips):
    return run("node", HERE / "read_three.mjs", input=with_trips(rooms, trips, "three"),
               env={**os.environ, "ROOMGEN_NODE_MODULES": str(TOOLS / "node_modules")})


def ask_godot(rooms, _):
    project = TOOLS / "godot"
    shutil.rmtree(project, ignore_errors=True)
    shutil.copytree(HERE / "godot", project)
    (project / "rooms").mkdir()
    for room in rooms:
        shutil.copy(room / "scene.glb", project / "rooms" / f"{room.name}.glb")
    home = {**os.environ, "HOME": str(project / "home"), "LIBGL_ALWAYS_SOFTWARE": "1"}
    godot = ["xvfb-run", "-a", "godot3", "--audio-driver", "Dummy", "--path", project]
    run(*godot, "--editor", "--quit", env=home)  # imports all that lies there
    return run(*godot, "--script", project / "list.gd", env=home)


READERS = {"trimesh": ask_trimesh, "three.js": ask_three, "Blender": ask_blender, "Godot": ask_godot}


def found_in(answer, room):
    """Ids of the room's things that a reader has found."""
    by_id = names_by_id(room)
    nodes = answer.get("nodes", [])
    ids = {node["id"] for node in nodes if node.get("id")}
    if ids:
        return ids & set(by_id)
    names = {node["name"] for node in nodes}
    return {one for one, name in by_id.items() if name.replace(".", "") in names}


def read_all(name, rooms, trips):
    done = READERS[name](rooms, trips)
    got = answers(done.stdout, "found " if name == "Godot" else "")
    by_room = {Path(a["file"]).stem if name == "Godot" else Path(a["file"]).parent.name: a for a in got}
    files = found = wanted = 0
    for room in rooms:
        answer = by_room.get(room.name, {"error": "no answer: " + done.stderr[-300:]})
        ids = {thing["id"] for thing in objects_of(room)}
        own = found_in(answer, room) if "error" not in answer else set()
        files += own == ids
        found += len(own & ids)
        wanted += len(ids)
        if own != ids:
            print(f"  {name} {room.name}: {answer.get('error', sorted(ids - own))}")
    return {"files": files, "things": found, "of": wanted}


def is_only_move(roomgen, room, file, moved):
    done = run(roomgen, "import", room / "scene.json", file, "--dry-run")
    if done.returncode or done.stderr.strip():
        return print(f"  {file}: {(done.stderr or done.stdout).strip()}")
    spots = [spot for operation in json.loads(done.stdout) for spot in operation.get("spots", [])]
    was = next(thing["position"] for thing in objects_of(room) if thing["id"] == moved)
    ok = len(spots) == 1 and spots[0]["object"] == moved and abs(spots[0]["position"][0] - was[0] - MOVE) < SAME
    return ok or print(f"  {file}: {done.stdout}")


def import_all(roomgen, rooms, program):
    kinds = ("extras", "names")
    right = [is_only_move(roomgen, room, room / f"{program}-{kind}.glb", thing_to_move(room))
             for room in rooms for kind in kinds]
    return {"right": sum(map(bool, right)), "of": len(right)}


def machine():
    model = re.search(r"model name\s*: (.*)", Path("/proc/cpuinfo").read_text())
    return f"{model[1] if model else platform.machine()}, {os.cpu_count()} cores"


def versions(readers):
    told = {}
    for package in ("trimesh", "bpy"):
        done = run(PYTHON, "-c", f"from importlib.metadata import version; print(version('{package}'))")
        told[package] = done.stdout.strip()
    three = TOOLS / "node_modules" / "three" / "package.json"
    told["three.js"] = json.loads(three.read_text())["version"] if three.exists() else ""
    told["Godot"] = run("dpkg-query", "-W", "-f", "${Version}", "godot3").stdout
    told["Blender"] = told["bpy"]
    return {name: told[name] for name in readers}


def write_results(file, options, values):
    commit = run("git", "-C", ROOT, "rev-parse", "--short", "HEAD").stdout.strip()
    command = f"bench/readers/run.py build/release/roomgen FOLDER --rooms {options.rooms} --trips {options.trips}"
    result = {"what": "things of furnished rooms that other programs find in scene.glb", "command": command,
              "machine": machine(), "commit": commit, "date": datetime.date.today().isoformat(), "values": values}
    file.parent.mkdir(exist_ok=True)
    file.write_text(json.dumps(result, indent=1, ensure_ascii=False) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("roomgen", type=Path)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--rooms", type=int, default=60)
    parser.add_argument("--trips", type=int, default=10)
    parser.add_argument("--only", default=",".join(READERS))
    parser.add_argument("--results", type=Path)
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    rooms = make_rooms(options.roomgen.resolve(), options.folder.resolve(), options.rooms)
    created = [sum("procedural" in thing.get("asset", {}) for thing in objects_of(room)) for room in rooms]
    readers = install([name for name in READERS if name in options.only.split(",")])
    version = versions(readers)
    values = [{"name": "rooms", "value": len(rooms), "unit": ""},
              {"name": "rooms with created things", "value": sum(map(bool, created)), "unit": ""},
              {"name": "created things", "value": sum(created), "unit": ""}]
    print("| reader | files whole | things found | imports right |\n|---|---|---|---|")
    whole = True
    for name in readers:
        read = read_all(name, rooms, options.trips)
        program = {"three.js": "three", "Blender": "blender"}.get(name)
        trip = import_all(options.roomgen, rooms[: options.trips], program) if program and options.trips else None
        right = f"{trip['right']} of {trip['of']}" if trip else ""
        print(f"| {name} {version[name]} | {read['files']} of {len(rooms)} | {read['things']} of {read['of']} | {right} |")
        values.append({"name": f"{name} {version[name]}: files in which all is found", "value": read["files"], "unit": ""})
        values.append({"name": f"{name}: things found of {read['of']}", "value": read["things"], "unit": ""})
        if trip:
            values.append({"name": f"{name}: imports right of {trip['of']}", "value": trip["right"], "unit": ""})
        whole = whole and read["files"] == len(rooms) and (not trip or trip["right"] == trip["of"])
    if options.results:
        write_results(options.results, options, values)
    sys.exit(0 if whole else 1)


if __name__ == "__main__":
    main()
