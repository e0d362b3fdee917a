"""The program `depth-eval` over a pipe."""

import json
import subprocess


class DepthEval:
    """The program that evaluates the engines: one line per request, one line per result."""

    def __init__(self, program: str) -> None:
        self.process = subprocess.Popen([program], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def answer(self, op: str, **fields: object) -> dict:
        """Returns the result, which may be an error."""
        self.process.stdin.write(json.dumps({"op": op, **fields}) + "\n")
        self.process.stdin.flush()
        return json.loads(self.process.stdout.readline())

    def __call__(self, op: str, **fields: object) -> dict:
        """Returns the result, and fails if it is an error."""
        answer = self.answer(op, **fields)
        assert "error" not in answer, answer
        return answer

    def close(self) -> None:
        self.process.stdin.close()
        self.process.wait()
