"""An endpoint of the OpenAI protocol that answers as servers are reported to do, in MODES, and keeps its own bill.

What it is asked for is always the same small bedroom, and the same place for each thing in it.
"""

import json
import threading
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer

from chat_server import first_choices, text_of


def thing(name, description, size):
    return {"name": name, "description": description, "size_cm": size, "quantity": 1, "variance": "same",
            "place": "floor", "on_top": []}  # fmt: skip


def plan(kind, size, *things):
    room = {"type": kind, "size_m": size, "polygon_m": None, "height_m": 2.6}
    return {"room": room, "objects": list(things), "excluded": []}


BEDROOM = plan("bedroom", [4.0, 4.5], thing("bed", "a double bed of oak", [160, 205, 90]),
               thing("nightstand", "an oak nightstand", [45, 40, 55]), thing("wardrobe", "a white wardrobe", [120, 60, 200]),
               thing("desk", "a desk", [120, 60, 75]))  # fmt: skip
DRAFT = plan("bathroom", [2.0, 2.5], thing("bathtub", "a white bathtub", [170, 75, 60]), thing("toilet", "a toilet", [40, 65, 80]))
PLACE = {"reasoning": "by the wall", "constraints": "edge", "location": [2.0, 2.5], "facing": 0}
DRAFT_PLACE = {"reasoning": "draft", "constraints": "middle", "location": [0.5, 0.5], "facing": 180}
BLIND = "image input is not supported - hint: if this is unexpected, you may need to provide the mmproj"
USAGE = {"prompt_tokens": 500, "completion_tokens": 100, "total_tokens": 600}


class Question:
    """One request, the how-many-th it is, and its good answer."""

    def __init__(self, body, number):
        self.body, self.number = body, number
        form = body.get("response_format", {}).get("json_schema", {}).get("name", "")
        words = "\n".join(text_of(message) for message in body["messages"])
        self.is_plan = form == "plan" if form else "list of its furniture" in words
        self.good = json.dumps(first_choices(words) or (BEDROOM if self.is_plan else PLACE))
        self.draft = json.dumps(DRAFT if self.is_plan else DRAFT_PLACE)
        self.bound = body.get("max_tokens", body.get("max_completion_tokens"))

    def has_pictures(self):
        contents = [m["content"] for m in self.body["messages"]]
        return any(part["type"] != "text" for c in contents if isinstance(c, list) for part in c)


def says(content, reason="stop", tokens=None, **message):
    """A completion; the tokens of its answer are 100 unless given."""
    choice = {"index": 0, "message": {"role": "assistant", "content": content, **message}, "finish_reason": reason}
    usage = USAGE if tokens is None else {**USAGE, "completion_tokens": tokens}
    return 200, {"id": "x", "object": "chat.completion", "created": 1, "model": "gpt-4o", "choices": [choice], "usage": usage}


def fails(status, message, **more):
    return status, {"error": {"message": message, **more}}


def unless(refused, status, message, question, **more):
    return fails(status, message, **more) if refused else says(question.good)


def thinks_until_4000(q):
    enough = q.bound >= 8000 or q.body.get("reasoning_effort") == "none"
    return says(q.good, reasoning="hm") if enough else says("", "length", reasoning="hm " * 1000)


def streams(q):
    chunk = lambda text: {"id": "x", "choices": [{"index": 0, "delta": {"content": text}, "finish_reason": None}]}  # noqa: E731
    events = [json.dumps(chunk(q.good[at : at + 40])) for at in range(0, len(q.good), 40)] + ["[DONE]"]
    return 200, ": hello\n\n" + "".join(f"data: {event}\n\n" for event in events)


def repeats(q):
    if not q.is_plan:
        return says(q.good)
    begun = q.good[: q.good.rindex("]", 0, q.good.rindex("]"))]
    return says(begun + (", " + json.dumps(thing("chair", "a chair", [50, 50, 90]))) * 400 + ', {"name": "cha', "length")


def thinks_in_parts(q):
    first = {"type": "thinking", "thinking": [{"type": "text", "text": 'first {"objects": []}'}]}
    return says([first, {"type": "text", "text": q.good}])


def calls_a_tool(q):
    return says(None, "tool_calls", tool_calls=[{"id": "1", "type": "function", "function": {"name": "plan", "arguments": q.good}}])


HARMONY = '<|channel|>analysis<|message|>We need: {"objects": []}<|end|><|start|>assistant<|channel|>final <|constrain|>json<|message|>'

# What a question gets: a status and its body; nothing, and for ever, from a server that is slow.
MODES = {
    "good": lambda q: says(q.good),
    "thinking_empty": lambda q: says("", "length", q.bound, reasoning="The user wants a room. " * 50),
    "thinking_until_4000": thinks_until_4000,
    "think_tag_draft": lambda q: says(f"<think>\nLet me draft: {q.draft}\nNo.\n</think>\n\n{q.good}"),
    "think_no_open": lambda q: says(f"Let me draft: {q.draft}\nNo.\n</think>\n\n{q.good}"),
    "only_reasoning": lambda q: says("", reasoning_content=q.good),
    "tool_call": calls_a_tool,
    "harmony": lambda q: says(HARMONY + q.good),
    "parts": thinks_in_parts,
    "comments": lambda q: (200, ": PROCESSING\n\n: PROCESSING\n\n" + json.dumps(says(q.good)[1])),
    "sse": streams,
    "repeat": repeats,
    "no_vision_500": lambda q: unless(q.has_pictures(), 500, BLIND, q, code=500, type="server_error"),
    "no_vision_400": lambda q: unless(q.has_pictures(), 400, "Model does not support images", q),
    "lmstudio_no_schema": lambda q: unless("response_format" in q.body, 400, "'response_format.type' must be 'text'", q),
    "grammar_400": lambda q: unless("response_format" in q.body, 400, "Failed to initialize samplers: failed to parse grammar", q),
    "refuse_temperature": lambda q: unless("temperature" in q.body, 400, "`temperature` is deprecated for this model.", q),
    "loading": lambda q: unless(q.number <= 5, 503, "Loading model", q, type="unavailable_error", code=503),
    "busy_once_200": lambda q: unless(q.number == 1, 200, "Provider returned error", q, code=429),
    "error_200": lambda q: fails(200, "Provider returned error", code=429, metadata={"raw": "rate limited"}),
    "error_string": lambda q: (400, {"error": "'response_format.type' must be 'json_schema' or 'text'"}),
    "context": lambda q: fails(400, "request (9377 tokens) exceeds the available context size (4096 tokens), try increasing it",
                               code=400, type="exceed_context_size_error"),
    "slow": lambda q: None,
}  # fmt: skip


class Endpoint:
    """A server at work on a free port of 127.0.0.1 while it is entered; what it was asked, and what it counted."""

    def __init__(self, mode):
        self.requests = self.input_tokens = self.output_tokens = 0
        self.uncounted = 0  # answers, or questions that were worked on, without a usage
        self.lock, self.ended = threading.Lock(), threading.Event()
        endpoint = self

        class Handler(BaseHTTPRequestHandler):
            protocol_version = "HTTP/1.1"

            def do_POST(self):  # noqa: N802 - the name is http.server's
                body = json.loads(self.rfile.read(int(self.headers["Content-Length"])))
                with endpoint.lock:
                    endpoint.requests += 1
                    answer = MODES[mode](Question(body, endpoint.requests))
                    endpoint.count(answer)
                if answer is None:
                    endpoint.ended.wait()  # the client has long gone
                    return
                status, content = answer
                data = (content if isinstance(content, str) else json.dumps(content)).encode()
                self.send_response(status)
                self.send_header("Content-Type", "text/event-stream" if isinstance(content, str) else "application/json")
                self.send_header("Content-Length", str(len(data)))
                self.end_headers()
                self.wfile.write(data)

            def log_message(self, *_):
                pass

        self.server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
        self.server.daemon_threads = True
        self.url = f"http://127.0.0.1:{self.server.server_port}/v1"

    def count(self, answer):
        content = answer[1] if answer else ""
        at = content.find('{"id": "x", "object": "chat.completion",') if isinstance(content, str) else -1
        whole = content if isinstance(content, dict) else json.loads(content[at:]) if at >= 0 else {}
        usage = whole.get("usage")
        if usage:
            self.input_tokens += usage["prompt_tokens"]
            self.output_tokens += usage["completion_tokens"]
        elif "error" not in whole:
            self.uncounted += 1

    def __enter__(self):
        threading.Thread(target=self.server.serve_forever, daemon=True).start()
        return self

    def __exit__(self, *_):
        self.ended.set()
        self.server.shutdown()
        self.server.server_close()
