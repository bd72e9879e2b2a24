"""What a call of `roomgen mcp` takes: agents.py ROOMGEN [ROUNDS [OPTIONS]] furnishes a bedroom, then makes the same
calls again and again, and prints the median and the longest of each, in milliseconds, with the bytes of the last answer.
OPTIONS are those of `roomgen mcp`."""

import json
import statistics
import subprocess
import sys
import tempfile
import time

ROOM = "a cosy bedroom for two with a desk by the wall"
CALLS = [
    ("check", {}), ("explain", {}), ("preview", {"object": "desk-0", "position": [1, 1]}), ("history", {}),
    ("edit", {"change": "turn the desk chair by 15 degrees", "picture": "none"}), ("undo", {"picture": "none"}),
    ("edit with a picture", {"change": "turn the desk chair by 15 degrees"}), ("undo", {"picture": "none"}),
    ("render marks", {"view": "marks"}), ("render eye", {"view": "eye"})]


class Server:
    def __init__(self, roomgen, root, *options):
        self.process = subprocess.Popen([roomgen, "mcp", "--root", root, *options], stdin=subprocess.PIPE,
                                        stdout=subprocess.PIPE, text=True)

    def call(self, tool, arguments):
        """The answer, its bytes, and the milliseconds that it took."""
        message = {"jsonrpc": "2.0", "id": 1, "method": "tools/call", "params": {"name": tool, "arguments": arguments}}
        start = time.perf_counter()
        self.process.stdin.write(json.dumps(message) + "\n")
        self.process.stdin.flush()
        line = self.process.stdout.readline()
        took = 1000 * (time.perf_counter() - start)
        result = json.loads(line)["result"]
        if result["isError"]:
            sys.exit(tool + ": " + result["content"][0]["text"])
        return result, len(line), took


def measure(server, rounds):
    times, sizes = {}, {}
    for _ in range(rounds):
        for name, arguments in CALLS:
            _, size, took = server.call(name.split()[0], {"room": "bedroom", **arguments})
            times.setdefault(name, []).append(took)
            sizes[name] = size
    for name, all_times in times.items():
        print(f"{name:22} {statistics.median(all_times):8.1f} {max(all_times):8.1f} {sizes[name]:8}")


def main():
    roomgen, rounds, options = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 20, sys.argv[3:]
    with tempfile.TemporaryDirectory() as root:
        server = Server(roomgen, root, *options)
        _, _, took = server.call("generate", {"folder": "bedroom", "prompt": ROOM})
        print(f"{'generate':22} {took:8.1f}")
        measure(server, rounds)
        server.process.stdin.close()
        server.process.wait()


if __name__ == "__main__":
    main()
